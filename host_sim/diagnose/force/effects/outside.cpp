#include "host_sim/diagnose/force/effects/law.hpp"

/// What is outside of the catalogue: what could imitate an effect, and is never named.
namespace host_sim::diagnose::laws {
namespace {

namespace giving_sheath {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"giving_share", "1", -1, 1, {0.1}}};
}

constexpr ForceEffect kEffect{
    "giving_sheath",
    "a sheath that bends more or less under load",
    "phi (1 + c (|T|/T_0 - 1))",
    "",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.giving_share = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction,
    true};

}  // namespace giving_sheath

namespace one_way_friction {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"one_way_share", "1", -0.9, 0.9, {0.1}}};
}

constexpr ForceEffect kEffect{
    "one_way_friction",
    "friction that is larger one way than the other",
    "all friction (1 + c s)",
    "",
    works_both_ways,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.one_way_share = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction,
    true};

}  // namespace one_way_friction

namespace bent_sensor {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"bent_share", "1", -0.5, 0.5, {0.01}}};
}

constexpr ForceEffect kEffect{
    "bent_sensor",
    "a sensor of the output that is not linear",
    "T_out (1 + c (T_out/T_0)^2)",
    "",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.bent_share = numbers[0]; },
    nullptr,
    ForceEffect::Of::sensor,
    true};

}  // namespace bent_sensor

namespace drifting_gain {

Parameters parameters(const ForceScales& /*scales*/) {
  ForceParameter time_constant{"drift_s", "s", 0, 100, {1.5, 5, 15}};
  time_constant.chosen = true;
  return {{"drift_share", "1", -0.5, 0.5, {0.02}}, time_constant};
}

constexpr ForceEffect kEffect{"drifting_gain",
                              "an input force that settles in the course of each session",
                              "T_in (1 + c (1 - exp(-t/tau)))",
                              "",
                              nullptr,
                              parameters,
                              [](Numbers numbers, ForceValues& values) {
                                values.drift_share = numbers[0];
                                values.drift_s = numbers[1];
                              },
                              nullptr,
                              ForceEffect::Of::session,
                              true};

}  // namespace drifting_gain

namespace warm_sensor {

Parameters parameters(const ForceScales& scales) {
  const double unit_N_K = scales.larger_N() / 100;
  return {{"warm_N_K", "N/K", -unit_N_K, unit_N_K, {0.05 * unit_N_K}}};
}

constexpr ForceEffect kEffect{
    "warm_sensor",
    "a sensor whose zero goes with the temperature",
    "g (T_in + c (T - 20 C))",
    "",
    has_sheath_temperature,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.warm_N_K = numbers[0]; },
    nullptr,
    ForceEffect::Of::session,
    true};

}  // namespace warm_sensor

}  // namespace

constinit const ForceEffect kGivingSheath = giving_sheath::kEffect;
constinit const ForceEffect kOneWayFriction = one_way_friction::kEffect;
constinit const ForceEffect kBentSensor = bent_sensor::kEffect;
constinit const ForceEffect kDriftingGain = drifting_gain::kEffect;
constinit const ForceEffect kWarmSensor = warm_sensor::kEffect;

}  // namespace host_sim::diagnose::laws
