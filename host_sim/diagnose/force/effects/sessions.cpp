#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "host_sim/diagnose/force/effects/law.hpp"

/// What sessions differ in.
namespace host_sim::diagnose::laws {
namespace {

namespace temperature {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"temperature_coefficient_1_K", "1/K", -0.05, 0.05, {0.001}}};
}

constexpr ForceEffect kEffect{
    "friction_temperature",
    "temperature-dependent friction",
    "all friction (1 + k (T - 20 C))",
    "a sheath that is warmer has another friction, and damage goes with it",
    has_sheath_temperature,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.temperature_1_K = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::session};

}  // namespace temperature

namespace wear {

bool has_cycles(const ForceRecord& record) {
  return !record.cycle.empty();
}

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"wear_coefficient", "1", -1, 1, {0.02}}, {"wear_exponent", "1", 0.1, 2, {1, 0.5}}};
}

constexpr ForceEffect kEffect{
    "friction_wear",
    "wear of the sheath",
    "mu (1 + a (n/1000)^p)",
    "friction grows with mu phi as the sheath wears, so that later cycles do more damage than "
    "Miner books for new ones",
    has_cycles,
    parameters,
    [](Numbers numbers, ForceValues& values) {
      values.wear = numbers[0];
      values.wear_exponent = numbers[1];
    },
    [](std::string_view id, Numbers numbers, const ForceScales& scales) {
      Extension extension = by_name(id, numbers, parameters(scales));
      extension.values.push_back({"run_in_cycles", {0}});
      return extension;
    },
    ForceEffect::Of::session};

}  // namespace wear

namespace run_in {

constexpr double kMost_cycles = 10000;

Parameters parameters(const ForceScales& scales) {
  return {{"wear_coefficient", "1", -1, 1, {0.05}},
          {"run_in_cycles",
           "cycles",
           1,
           std::clamp(2 * scales.cycles, 2.0, kMost_cycles),
           {0.03 * scales.cycles, 0.1 * scales.cycles, 0.3 * scales.cycles}}};
}

constexpr ForceEffect kEffect{
    "friction_wear",
    "run-in of the sheath",
    "mu (1 + a exp(-n/n0))",
    "a new sheath has another friction than one that has run, and its first cycles another damage",
    wear::has_cycles,
    parameters,
    [](Numbers numbers, ForceValues& values) {
      values.run_in = numbers[0];
      values.run_in_cycles = numbers[1];
    },
    [](std::string_view id, Numbers numbers, const ForceScales& scales) {
      Extension extension = by_name(id, numbers, parameters(scales));
      extension.values.insert(extension.values.begin() + 1, {"wear_exponent", {0}});
      return extension;
    },
    ForceEffect::Of::session};

}  // namespace run_in

namespace bend_angle {

/// A scale of all angles is one of mu: the largest is taken to be right.
Parameters parameters(const ForceScales& scales) {
  Parameters all;
  for (std::size_t pose = 0; pose + 1 < scales.poses_rad.size(); ++pose) {
    const int angle_deg =
        static_cast<int>(std::lround(scales.poses_rad[pose] * 180 / std::numbers::pi));
    all.push_back({"bend_angle_error_rad_at_" + std::to_string(angle_deg) + "_deg",
                   "rad",
                   -0.6,
                   0.6,
                   {0.02}});
  }
  return all;
}

constexpr ForceEffect kEffect{
    "bend_angle",
    "bend-angle (pose) error",
    "mu (phi + delta), delta of each pose",
    "a pose that bends more than it was said to has input tensions larger by exp(mu delta)",
    nullptr,
    parameters,
    [](Numbers numbers, ForceValues& values) { values.pose_errors_rad = numbers; },
    [](std::string_view id, Numbers numbers, const ForceScales& scales) {
      Extension::Value errors{"bend_angle_error_rad", {numbers.begin(), numbers.end()}};
      errors.values.push_back(0);
      Extension::Value angles{"bend_angles_deg", {}};
      for (const double pose_rad : scales.poses_rad) {
        angles.values.push_back(pose_rad * 180 / std::numbers::pi);
      }
      return Extension{std::string(id), {std::move(errors), std::move(angles)}};
    },
    ForceEffect::Of::session};

}  // namespace bend_angle

namespace torque_gain {

Parameters parameters(const ForceScales& /*scales*/) {
  return {{"droop_1_K", "1/K", 0, 0.005, {0.0005}}};
}

constexpr ForceEffect kEffect{
    "torque_gain",
    "torque constant that falls as the winding warms",
    "K_t (1 - alpha (T_winding - 20 C))",
    "a warm motor pulls less than its current says, so that damage is overstated by gamma alpha dT",
    [](const ForceRecord& record) {
      return has_current(record) && !record.winding_temperature_C.empty();
    },
    parameters,
    [](Numbers numbers, ForceValues& values) { values.droop_1_K = numbers[0]; },
    written<parameters>,
    ForceEffect::Of::session};

}  // namespace torque_gain

}  // namespace

constinit const ForceEffect kTemperature = temperature::kEffect;
constinit const ForceEffect kWear = wear::kEffect;
constinit const ForceEffect kRunIn = run_in::kEffect;
constinit const ForceEffect kBendAngle = bend_angle::kEffect;
constinit const ForceEffect kTorqueGain = torque_gain::kEffect;

}  // namespace host_sim::diagnose::laws
