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

}  // namespace

constinit const ForceEffect kGivingSheath = giving_sheath::kEffect;
constinit const ForceEffect kOneWayFriction = one_way_friction::kEffect;
constinit const ForceEffect kBentSensor = bent_sensor::kEffect;

}  // namespace host_sim::diagnose::laws
