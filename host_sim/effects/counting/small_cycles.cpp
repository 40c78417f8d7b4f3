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
    return missing_input(covariates);
  }

  double damage_lost(const recording::Covariates& covariates, const reference::Constants& constants,
                     double value) const override {
    return share_lost(covariates, constants, 1, value);
  }
};

}  // namespace

std::unique_ptr<CountingEffect> make_small_cycles();

std::unique_ptr<CountingEffect> make_small_cycles() {
  return std::make_unique<SmallCycles>();
}

}  // namespace host_sim::effects
