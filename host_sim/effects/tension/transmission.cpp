#include <utility>

#include "host_sim/effects/tension/law.hpp"

/// What gives way or lies loose between both ends.
namespace host_sim::effects::laws {
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

constexpr TableKey kTable[] = {{{"slack_log_drop", "", {-3, 3}}},
                               {{"slack_friction_share", "", {0, 2}}},
                               {{"slack_m", "m", {1e-4, 2e-3}}}};

constexpr Separation kSeparations[] = {
    {"presliding", "step the pretension: slack closes, presliding stays"},
    {"compliance", "step the pretension"}};

constexpr TensionEffect kEffect{"slack", "backlash or dead zone",
                                "short swings of input tension do not reach the output, and the "
                                "take-up adds a swing at each reversal",
                                kTable, kSeparations};

Parameters slack_parameters(const ForceScales& scales) {
  return {slack_length(scales)};
}

constexpr ForceLaw kBacklash{
    .effect = &kEffect,
    .equation = "no friction within b of a reversal",
    .missing = needs_both_ways,
    .parameters = slack_parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.slack_m = numbers[0]; },
    .of = ForceLaw::Of::friction};

Parameters loose_parameters(const ForceScales& scales) {
  Parameters all{slack_length(scales),
                 usual(0.3, {"slack_log_drop", "1", 0, 5, {0.1}, false, false, kLeastDrop}),
                 {"slack_friction_share", "1", 0, 1, {1}}};
  all[1].beside = true;
  all[2].beside = true;
  return all;
}

constexpr ForceLaw kLooseTendon{
    .effect = &kEffect,
    .equation = "exp(-d) T, friction by another share, within b of a reversal",
    .missing = needs_one_tendon,
    .parameters = loose_parameters,
    .set =
        [](Numbers numbers, ForceValues& values) {
          values.loose_m = numbers[0];
          values.loose_log_drop = numbers[1];
          values.loose_friction = numbers[2];
        },
    .of = ForceLaw::Of::friction};

}  // namespace slack

namespace compliance {

constexpr TableKey kTable[] = {{{"compliance_share", "", {0, 1}}},
                               {{"stiffness_N_m", "N_m", {1e3, 1e6}}}};

constexpr Separation kSeparations[] = {
    {"filter_lag", "change the frequency at the same speed"},
    {"presliding", "change the rate of tension at the same travel"},
    {"slack", "step the pretension"}};

constexpr TensionEffect kEffect{"compliance", "elasticity of sheath and tendon",
                                "friction turns over earlier than the motor does, which moves the "
                                "peaks of input tension at each reversal",
                                kTable, kSeparations};

Parameters parameters(const ForceScales& scales) {
  return {stiffness("stiffness_N_m", scales, {0.3, 3, 30, 300})};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "dT_in = k dx within what friction holds",
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.stiffness_N_m = numbers[0]; },
    .of = ForceLaw::Of::friction};

}  // namespace compliance

}  // namespace

constinit const ForceLaw kSlack = slack::kBacklash;
constinit const ForceLaw kLooseTendon = slack::kLooseTendon;
constinit const ForceLaw kCompliance = compliance::kLaw;

}  // namespace host_sim::effects::laws
