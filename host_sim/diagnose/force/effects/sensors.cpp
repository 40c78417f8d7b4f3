#include <algorithm>
#include <string>

#include "host_sim/diagnose/force/effects/law.hpp"

/// What sensors and the motor show otherwise than it is.
namespace host_sim::diagnose::laws {
namespace {

constexpr double kOfStep = 0.04;  ///< of the time between samples, which times are resolved by

namespace lag {

Parameters parameters(const ForceScales& scales) {
  return {{"lag_s", "s", -0.1, 0.1, {0.005, -0.005}, false, false, kOfStep * scales.step_s}};
}

constexpr ForceEffect kEffect{
    "filter_lag",
    "first-order lag of a sensor",
    "T_out + tau dT_out/dt; of the input where tau is negative",
    "peaks of fast cycles are read too low",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.lag_s = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::time};

}  // namespace lag

namespace delay {

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

constexpr ForceEffect kEffect{
    "channel_delay",
    "delay of a channel",
    "T_out(t + d); T_in(t + |d|) where d is negative",
    "nothing by itself: friction and lag are read wrong where it is not known",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.delay_s = numbers[0]; },
    nullptr,
    ForceEffect::Of::time};

}  // namespace delay

namespace zero {

Parameters parameters(const ForceScales& scales) {
  const double most_N = 2 * std::max(scales.force_N, scales.input_N);
  return {{"load_cell_zero_N", "N", -most_N, most_N, {0.01 * scales.force_N}}};
}

constexpr ForceEffect kEffect{
    "load_cell_zero",
    "zero of the output sensor",
    "T_out - b",
    "every tension is read too high or too low by the same force",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.zero_N = numbers[0]; },
    [](std::string_view id, Numbers numbers, const ForceScales& /*scales*/) {
      return Extension{std::string(id), {{"zero_N", {numbers[0]}}}};
    }};

}  // namespace zero

namespace current_offset {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"current_offset_A", "A", -0.5, 0.5, {0.01}}};
}

constexpr ForceEffect kEffect{
    "current_offset",
    "zero error of the current sensor",
    "I - b",
    "all input tensions are wrong by the same force: the mean moves and the amplitude stays",
    has_current,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.current_offset_A = numbers[0]; },
    written<parameters>};

}  // namespace current_offset

namespace gear_asymmetry {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"gear_asymmetry", "1", -0.3, 0.3, {0.01}}};
}

constexpr ForceEffect kEffect{
    "gear_asymmetry",
    "direction-dependent gear efficiency",
    "eta_g (1 + c s)",
    "the amplitude of input tension is wrong by c times its mean, at every bend angle",
    has_current,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.gear_asymmetry = numbers[0]; },
    written<parameters>};

}  // namespace gear_asymmetry

namespace torque_ripple {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"ripple_sine_A", "A", -0.5, 0.5, {0.01}},
          {"ripple_cosine_A", "A", -0.5, 0.5, {0.01}},
          {"ripple_harmonic",
           "1",
           1,
           24,
           {1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 21, 24},
           false,
           true}};
}

constexpr ForceEffect kEffect{
    "torque_ripple",
    "cogging and torque ripple",
    "I + a sin(k theta) + b cos(k theta)",
    "adds many small cycles of input tension, each of little damage",
    [](const ForceRecord& record) { return has_current(record) && !record.rotor_rad.empty(); },
    parameters,
    [](Numbers numbers, ForceValues& values) {
      values.ripple_sine_A = numbers[0];
      values.ripple_cosine_A = numbers[1];
      values.ripple_harmonic = numbers[2];
    },
    written<parameters>};

}  // namespace torque_ripple

}  // namespace

constinit const ForceEffect kLag = lag::kEffect;
constinit const ForceEffect kDelay = delay::kEffect;
constinit const ForceEffect kZero = zero::kEffect;
constinit const ForceEffect kCurrentOffset = current_offset::kEffect;
constinit const ForceEffect kGearAsymmetry = gear_asymmetry::kEffect;
constinit const ForceEffect kTorqueRipple = torque_ripple::kEffect;

}  // namespace host_sim::diagnose::laws
