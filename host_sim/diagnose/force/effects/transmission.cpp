#include <utility>

#include "host_sim/diagnose/force/effects/law.hpp"

/// What gives way or lies loose between both ends.
namespace host_sim::diagnose::laws {
namespace {

/// b of laws of slack.
ForceParameter slack_length(const ForceScales& scales) {
  const double stroke_m = scales.stroke_m;
  return {"slack_m", "m", 0, 0.3 * stroke_m, {0.01 * stroke_m, 0.03 * stroke_m, 0.1 * stroke_m},
          true};
}

/// ln of what a loose tendon lacks at least: one that has nearly all of its force is not loose.
constexpr double kLeastDrop = 0.04;

namespace slack {

Parameters parameters(const ForceScales& scales) {
  return {slack_length(scales)};
}

constexpr ForceEffect kEffect{
    "slack",
    "backlash",
    "no friction within b of a reversal",
    "the tendon runs free at reversals, and shocks follow",
    works_both_ways,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.slack_m = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction};

}  // namespace slack

namespace loose_tendon {

Parameters parameters(const ForceScales& scales) {
  Parameters all{slack_length(scales),
                 {"slack_log_drop", "1", 0, 5, {0.1}, false, false, kLeastDrop},
                 {"slack_friction_share", "1", 0, 1, {1}}};
  all[1].beside = true;
  all[2].beside = true;
  return all;
}

constexpr ForceEffect kEffect{"slack",
                              "backlash",
                              "exp(-d) T, friction by another share, within b of a reversal",
                              "the tendon runs free at reversals, and shocks follow",
                              pulls_alone,
                              parameters,
                              [](Numbers numbers, ForceValues& values) {
                                values.loose_m = numbers[0];
                                values.loose_log_drop = numbers[1];
                                values.loose_friction = numbers[2];
                              },
                              nullptr,
                              ForceEffect::Of::friction};

}  // namespace loose_tendon

namespace compliance {

Parameters parameters(const ForceScales& scales) {
  return {stiffness("stiffness_N_m", scales, {0.3, 3, 30, 300})};
}

constexpr ForceEffect kEffect{
    "compliance",
    "sheath and tendon elasticity",
    "dT_in = k dx within what friction holds",
    "reversals of the friction come late, which changes small cycles",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.stiffness_N_m = numbers[0]; },
    nullptr,
    ForceEffect::Of::friction};

}  // namespace compliance

}  // namespace

constinit const ForceEffect kSlack = slack::kEffect;
constinit const ForceEffect kLooseTendon = loose_tendon::kEffect;
constinit const ForceEffect kCompliance = compliance::kEffect;

}  // namespace host_sim::diagnose::laws
