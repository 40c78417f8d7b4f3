#include <cmath>

#include "host_sim/statistics/random.hpp"
#include "host_sim/synth/draws.hpp"
#include "host_sim/synth/life/kinds.hpp"
#include "host_sim/synth/streams.hpp"

namespace host_sim::synth {
namespace {

/// Life A / (T - S_e)^gamma, without end at S_e and below. Each specimen has its own limit,
/// lognormal about the median, or all have the same. Reference for the random limit: Pascual and
/// Meeker, Estimating fatigue curves with the random fatigue-limit model, Technometrics 41, 1999.
class EnduranceLimit final : public LifePart {
 public:
  explicit EnduranceLimit(const Values& values)
      : median_N_(values["limit_N"]), log_sd_(values["log_sd"]), limit_N_(median_N_) {}

  void begin(const SpecimenPlace& place, std::uint64_t seed) override {
    statistics::Random random(seed, kEnduranceStream, place.number);
    limit_N_ = median_N_ * std::exp(log_sd_ * normal(random));
  }

  [[nodiscard]] double damaging_tension_N(double effective_N) const override {
    return effective_N - limit_N_;
  }

 private:
  double median_N_, log_sd_, limit_N_;
};

}  // namespace

LifeKind endurance_limit() {
  return {"endurance_limit",
          {{{"limit_N", "N", {0, 1000}}}, {{"log_sd", "", {0, 1}}, 0}},
          {},
          make_life_part<EnduranceLimit>};
}

}  // namespace host_sim::synth
