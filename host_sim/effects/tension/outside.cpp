#include <algorithm>
#include <array>

#include "host_sim/effects/tension/law.hpp"

/// What is outside of the catalogue: what could imitate an effect, and is never named.
namespace host_sim::effects::laws {
namespace {

/// Friction by a covariate in any way, on lines between knots.
template <std::array<double, 3> ForceValues::*kShares>
void set_shares(Numbers numbers, ForceValues& values) {
  std::ranges::copy(numbers, (values.*kShares).begin());
}

namespace friction_by_load {

constexpr TensionEffect kEffect{
    "friction_by_load", "friction that depends on the load in a way of its own", {}, {}, {}};

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"share_at_a_quarter", "1", -0.9, 9, {0.05}},
          {"share_at_a_half", "1", -0.9, 9, {0.05}},
          {"share_at_twice", "1", -0.9, 9, {-0.05}}};
}

constexpr ForceLaw kLaw{.effect = &kEffect,
                        .equation = "mu (1 + g(|T|))",
                        .parameters = parameters,
                        .set = set_shares<&ForceValues::by_load>,
                        .of = ForceLaw::Of::friction,
                        .by = ForceLaw::By::load,
                        .outside = true};

}  // namespace friction_by_load

namespace friction_by_speed {

constexpr TensionEffect kEffect{
    "friction_by_speed", "friction that depends on the speed in a way of its own", {}, {}, {}};

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"share_at_rest", "1", -0.9, 9, {0.05}},
          {"share_at_a_quarter", "1", -0.9, 9, {0.05}},
          {"share_at_full_speed", "1", -0.9, 9, {0.05}}};
}

constexpr ForceLaw kLaw{.effect = &kEffect,
                        .equation = "mu (1 + g(|v|)), F (1 + g(|v|))",
                        .parameters = parameters,
                        .set = set_shares<&ForceValues::by_speed>,
                        .of = ForceLaw::Of::friction,
                        .by = ForceLaw::By::speed,
                        .outside = true};

}  // namespace friction_by_speed

namespace giving_sheath {

constexpr TensionEffect kEffect{
    "giving_sheath", "a sheath that bends more or less under load", {}, {}, {}};

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"giving_share", "1", -1, 1, {0.1}}};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "phi (1 + c (|T|/T_0 - 1))",
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.giving_share = numbers[0]; },
    .of = ForceLaw::Of::friction,
    .outside = true};

}  // namespace giving_sheath

namespace one_way_friction {

constexpr TensionEffect kEffect{
    "one_way_friction", "friction that is larger one way than the other", {}, {}, {}};

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"one_way_share", "1", -0.9, 0.9, {0.1}}};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "all friction (1 + c s)",
    .missing = needs_both_ways,
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.one_way_share = numbers[0]; },
    .of = ForceLaw::Of::friction,
    .outside = true};

}  // namespace one_way_friction

namespace bent_sensor {

constexpr TensionEffect kEffect{
    "bent_sensor", "a sensor of the output that is not linear", {}, {}, {}};

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"bent_share", "1", -0.5, 0.5, {0.01}}};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "T_out (1 + c (T_out/T_0)^2)",
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.bent_share = numbers[0]; },
    .of = ForceLaw::Of::sensor,
    .outside = true};

}  // namespace bent_sensor

namespace drifting_gain {

constexpr TensionEffect kEffect{
    "drifting_gain", "an input force that settles in the course of each session", {}, {}, {}};

Parameters parameters(const ForceScales& /*scales*/) {
  ForceParameter time_constant{"drift_s", "s", 0, 100, {1.5, 5, 15}};
  time_constant.chosen = true;
  return {{"drift_share", "1", -0.5, 0.5, {0.02}}, time_constant};
}

constexpr ForceLaw kLaw{.effect = &kEffect,
                        .equation = "T_in (1 + c (1 - exp(-t/tau)))",
                        .parameters = parameters,
                        .set =
                            [](Numbers numbers, ForceValues& values) {
                              values.drift_share = numbers[0];
                              values.drift_s = numbers[1];
                            },
                        .of = ForceLaw::Of::session,
                        .outside = true};

}  // namespace drifting_gain

namespace warm_sensor {

constexpr TensionEffect kEffect{
    "warm_sensor", "a sensor whose zero goes with the temperature", {}, {}, {}};

Parameters parameters(const ForceScales& scales) {
  const double unit_N_K = scales.larger_N() / 100;
  return {{"warm_N_K", "N/K", -unit_N_K, unit_N_K, {0.05 * unit_N_K}}};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "g (T_in + c (T - 20 C))",
    .missing = needs_sheath_temperature,
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.warm_N_K = numbers[0]; },
    .of = ForceLaw::Of::session,
    .outside = true};

}  // namespace warm_sensor

}  // namespace

constinit const ForceLaw kFrictionByLoad = friction_by_load::kLaw;
constinit const ForceLaw kFrictionBySpeed = friction_by_speed::kLaw;
constinit const ForceLaw kGivingSheath = giving_sheath::kLaw;
constinit const ForceLaw kOneWayFriction = one_way_friction::kLaw;
constinit const ForceLaw kBentSensor = bent_sensor::kLaw;
constinit const ForceLaw kDriftingGain = drifting_gain::kLaw;
constinit const ForceLaw kWarmSensor = warm_sensor::kLaw;

}  // namespace host_sim::effects::laws
