#include <cmath>
#include <limits>

#include "host_sim/synth/life/kinds.hpp"

namespace host_sim::synth {
namespace {

/// The true law of mean stress in place of Gerber's.
class MeanStress final : public LifePart {
 public:
  explicit MeanStress(const Values& values)
      : law_(values.word("law")), walker_exponent_(values["walker_exponent"]) {}

  /// Goodman: T_a / (1 - T_m / T_u). Smith, Watson and Topper: sqrt(T_max T_a). Walker:
  /// T_max^(1 - w) T_a^w. Reference: Dowling, Mean stress effects in stress-life and strain-life
  /// fatigue, SAE 2004-01-2227.
  [[nodiscard]] double effective_tension_N(double /*effective_N*/, reference::MeanAmplitude input,
                                           double ultimate_tension_N) const override {
    if (law_ == "goodman") {
      const double left = 1 - input.mean_N / ultimate_tension_N;
      return left > 0 ? input.amplitude_N / left : std::numeric_limits<double>::infinity();
    }
    const double exponent = law_ == "walker" ? walker_exponent_ : 0.5;
    const double maximum_N = input.mean_N + input.amplitude_N;
    return std::pow(maximum_N, 1 - exponent) * std::pow(input.amplitude_N, exponent);
  }

 private:
  std::string law_;
  double walker_exponent_;
};

}  // namespace

LifeKind mean_stress() {
  return {"mean_stress",
          {{{"walker_exponent", "", {0, 1}}, 0.65}},
          {{"law", {"walker", "goodman", "swt"}}},
          make_life_part<MeanStress>};
}

}  // namespace host_sim::synth
