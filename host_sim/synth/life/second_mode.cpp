#include <cmath>

#include "host_sim/statistics/random.hpp"
#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/life/kinds.hpp"
#include "host_sim/synth/streams.hpp"

namespace host_sim::synth {
namespace {

/// A second mode of failure with a law of its own; a specimen fails by the one that comes first.
class SecondMode final : public LifePart {
 public:
  explicit SecondMode(const Values& values)
      : scale_cycles_(values["life_cycles"]),
        reference_N_(values["reference_N"]),
        exponent_(values["exponent"]),
        shape_(values["shape"]) {}

  void begin(const SpecimenPlace& place, std::uint64_t seed) override {
    statistics::Random random(seed, kSecondModeStream, place.number);
    strength_ = std::pow(exponential(random), 1 / shape_);
  }

  [[nodiscard]] double other_life_cycles(double effective_N) const override {
    return scale_cycles_ * std::pow(effective_N / reference_N_, -exponent_) * strength_;
  }

 private:
  double scale_cycles_, reference_N_, exponent_, shape_;
  double strength_ = 1;
};

}  // namespace

LifeKind second_mode() {
  return {"second_mode",
          {{{"life_cycles", "cycles", {1, 1e12}}},
           {{"reference_N", "N", {0.1, 1000}}},
           {{"exponent", "", {0, 30}}},
           {{"shape", "", {0.3, 50}}}},
          {},
          make_life_part<SecondMode>};
}

}  // namespace host_sim::synth
