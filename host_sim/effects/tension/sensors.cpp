#include <algorithm>
#include <string>

#include "host_sim/effects/tension/law.hpp"

/// What sensors and the motor show otherwise than it is.
namespace host_sim::effects::laws {
namespace {

constexpr double kOfStep = 0.04;  ///< of the time between samples, which times are resolved by

namespace lag {

constexpr TableKey kTable[] = {{{"lag_s", "s", {-0.1, 0.1}}}};

constexpr Separation kSeparations[] = {
    {"channel_delay",
     "sweep the frequency up to a third of 1/tau: a lag cuts peaks, a delay does not"},
    {"compliance", "sweep the frequency at the same speed"},
    {"friction_velocity", "run at constant speed, several speeds at the same tension"},
    {"undersampling", "decimate the data"}};

constexpr TensionEffect kEffect{
    "filter_lag", "first-order lag of a sensor or filter",
    "the measured loop is wider or narrower than the true one, and peaks of fast cycles are cut",
    kTable, kSeparations};

Parameters parameters(const ForceScales& scales) {
  return {{"lag_s", "s", -0.1, 0.1, {0.005, -0.005}, false, false, kOfStep * scales.step_s}};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "T_out + tau dT_out/dt; of the input where tau is negative",
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.lag_s = numbers[0]; },
    .written = written<parameters>,
    .of = ForceLaw::Of::time};

}  // namespace lag

namespace delay {

constexpr Separation kSeparations[] = {
    {"filter_lag",
     "sweep the frequency up to a third of 1/tau: a lag cuts peaks, a delay does not"},
    {"compliance", "sweep the frequency at the same speed"}};

constexpr TensionEffect kEffect{
    "channel_delay",
    "delay of a channel",
    "nothing by itself: friction and lag are read wrong where it is not known",
    {},
    kSeparations};

Parameters parameters(const ForceScales& scales) {
  return {{"delay_s",
           "s",
           -0.1,
           0.1,
           {0.005, -0.005, 0.02, -0.02},
           false,
           false,
           kOfStep * scales.step_s}};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "T_out(t + d); T_in(t + |d|) where d is negative",
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.delay_s = numbers[0]; },
    .of = ForceLaw::Of::time};

}  // namespace delay

namespace zero {

constexpr TableKey kTable[] = {{{"zero_N", "N", {-1e6, 1e6}}}};

constexpr Separation kSeparations[] = {
    {"current_offset", "read both sensors with the tendon slack"},
    {"friction_load", "read the sensor with the tendon slack"}};

constexpr TensionEffect kEffect{"load_cell_zero", "zero of the output sensor",
                                "every tension is read too high or too low by the same force",
                                kTable, kSeparations};

Parameters parameters(const ForceScales& scales) {
  const double most_N = 2 * std::max(scales.force_N, scales.input_N);
  return {{"load_cell_zero_N", "N", -most_N, most_N, {0.01 * scales.force_N}}};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "T_out - b",
    .missing = needs_load,
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.zero_N = numbers[0]; },
    .written =
        [](std::string_view id, Numbers numbers, const ForceScales& /*scales*/) {
          return Extension{std::string(id), {{"zero_N", {numbers[0]}}}};
        },
    .constant = true};

}  // namespace zero

namespace current_offset {

constexpr TableKey kTable[] = {{{"current_offset_A", "A", {-0.5, 0.5}}}};

constexpr Separation kSeparations[] = {
    {"friction_preload",
     "move in both directions at low and at high tension: an offset of the sensor does not change "
     "sign with s"},
    {"friction_load", "vary the bend angle at one tension"},
    {"load_cell_zero", "read both sensors with the tendon slack"},
    {"torque_gain", "take points near zero current and at high current"}};

constexpr TensionEffect kEffect{"current_offset", "zero error of the current sensor",
                                "all input tensions are wrong by the same number of newtons: the "
                                "mean (12) moves and the amplitude (13) stays",
                                kTable, kSeparations};

Parameters parameters(const ForceScales& /*scales*/) {
  return {usual(0.05, {"current_offset_A", "A", -0.5, 0.5, {0.01}})};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "I - b",
    .missing = needs_current,
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.current_offset_A = numbers[0]; },
    .written = written<parameters>,
    .constant = true};

}  // namespace current_offset

namespace gear_asymmetry {

constexpr TableKey kTable[] = {{{"gear_asymmetry", "", {-0.3, 0.3}}}};

constexpr Separation kSeparations[] = {
    {"bend_angle", "measure at four or more bend angles: an asymmetry is the same at each"},
    {"friction_preload", "measure at low and at high tension"}};

constexpr TensionEffect kEffect{
    "gear_asymmetry", "direction-dependent gear efficiency",
    "the amplitude of input tension is wrong by c times its mean, at every bend angle", kTable,
    kSeparations};

Parameters parameters(const ForceScales& /*scales*/) {
  return {usual(0.02, {"gear_asymmetry", "1", -0.3, 0.3, {0.01}})};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "eta_g (1 + c s)",
    .missing = needs_current,
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.gear_asymmetry = numbers[0]; },
    .written = written<parameters>};

}  // namespace gear_asymmetry

namespace torque_ripple {

constexpr TableKey kTable[] = {{{"ripple_sine_A", "A", {-0.5, 0.5}}},
                               {{"ripple_cosine_A", "A", {-0.5, 0.5}}},
                               {{"ripple_harmonic", "", {1, 24}}}};

constexpr Separation kSeparations[] = {{"friction_position", "repeat the stroke at several loads"}};

constexpr TensionEffect kEffect{"torque_ripple", "cogging and torque ripple",
                                "adds many small cycles of input tension, each of little damage",
                                kTable, kSeparations};

Parameters parameters(const ForceScales& /*scales*/) {
  return {usual(0.05, {"ripple_sine_A", "A", -0.5, 0.5, {0.01}}),
          usual(0.05, {"ripple_cosine_A", "A", -0.5, 0.5, {0.01}}),
          {"ripple_harmonic",
           "1",
           1,
           24,
           {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 21, 24},
           false,
           true}};
}

constexpr ForceLaw kLaw{.effect = &kEffect,
                        .equation = "I + a sin(k theta) + b cos(k theta)",
                        .missing =
                            [](const ForceRecord& record) {
                              return record.rotor_rad.empty() ? "no rotor angle (motor_angle_rad)"
                                                              : needs_current(record);
                            },
                        .parameters = parameters,
                        .set =
                            [](Numbers numbers, ForceValues& values) {
                              values.ripple_sine_A = numbers[0];
                              values.ripple_cosine_A = numbers[1];
                              values.ripple_harmonic = numbers[2];
                            },
                        .written = written<parameters>};

}  // namespace torque_ripple

}  // namespace

constinit const ForceLaw kLag = lag::kLaw;
constinit const ForceLaw kDelay = delay::kLaw;
constinit const ForceLaw kZero = zero::kLaw;
constinit const ForceLaw kCurrentOffset = current_offset::kLaw;
constinit const ForceLaw kGearAsymmetry = gear_asymmetry::kLaw;
constinit const ForceLaw kTorqueRipple = torque_ripple::kLaw;

}  // namespace host_sim::effects::laws
