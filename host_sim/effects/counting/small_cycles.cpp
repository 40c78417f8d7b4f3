#include "host_sim/effects/counting/damage.hpp"
#include "host_sim/effects/counting_effect.hpp"

namespace host_sim::effects {
namespace {

constexpr Parameter kParameter{
    .name = "hysteresis_N", .unit = "N", .minimum = 0, .maximum = 50, .typical = 0.2};

constexpr Separation kSeparations[] = {
    {"endurance_limit",
     "sweep the hysteresis of the count: an endurance limit does not move with it"},
};

class SmallCycles final : public CountingEffect {
 public:
  std::string_view id() const override { return "small_cycles"; }
  std::string_view term() const override { return "cycles below the threshold of the counter"; }
  std::string_view equation() const override {
    return "a swing below the hysteresis h does not count; its damage is (T_a/T)^gamma of a full "
           "one";
  }
  std::string_view life_consequence() const override {
    return "cycles that wear the wire are not booked: one of a tenth of the amplitude costs 4.2 % "
           "of a full one at gamma 1.38";
  }
  const Parameter& parameter() const override { return kParameter; }
  std::span<const Separation> separations() const override { return kSeparations; }

  std::string missing(const recording::Covariates& covariates) const override {
    return covariates.tension_in_N().empty()
               ? "no input tension (input_tension_N or motor_current_A)"
               : "";
  }

  double damage_lost(const recording::Covariates& covariates, const reference::Constants& constants,
                     double value) const override {
    reference::Constants without_threshold = constants;
    without_threshold.hysteresis_N = 0;
    reference::Constants with_threshold = constants;
    with_threshold.hysteresis_N = value;
    const std::vector<double>& tension_N = covariates.tension_in_N();
    return share_lost(damage_of(tension_N, 1, without_threshold),
                      damage_of(tension_N, 1, with_threshold));
  }
};

}  // namespace

std::unique_ptr<CountingEffect> make_small_cycles();

std::unique_ptr<CountingEffect> make_small_cycles() {
  return std::make_unique<SmallCycles>();
}

}  // namespace host_sim::effects
