#include <cmath>

#include "host_sim/synth/tension/kinds.hpp"

namespace host_sim::synth {
namespace {

/// Wear: mu * (1 + a (n / n0)^p). Run-in: mu * (1 + a exp(-n / n0)).
class FrictionWear final : public TensionPart {
 public:
  explicit FrictionWear(const Values& values)
      : change_(values["change"]),
        reference_cycles_(values["reference_cycles"]),
        exponent_(values["exponent"]),
        run_in_(values.word("law") == "run_in") {}

  [[nodiscard]] double friction(double mu, const Moment& moment,
                                double /*tension_N*/) const override {
    const double age = moment.cycle / reference_cycles_;
    return mu * (1 + change_ * (run_in_ ? std::exp(-age) : std::pow(age, exponent_)));
  }

 private:
  double change_, reference_cycles_, exponent_;
  bool run_in_;
};

}  // namespace

TensionKind friction_wear() {
  return {"friction_wear",
          {{{"change", "", {-0.9, 5}}},
           {{"reference_cycles", "cycles", {1, 1e9}}},
           {{"exponent", "", {0.05, 4}}, 1}},
          {{"law", {"wear", "run_in"}}},
          make_part<FrictionWear>};
}

}  // namespace host_sim::synth
