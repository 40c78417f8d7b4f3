#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "host_sim/effects/tension/law.hpp"

/// What sessions differ in.
namespace host_sim::effects::laws {
namespace {

namespace temperature {

constexpr TableKey kTable[] = {{{"temperature_coefficient_1_K", "1_K", {-0.05, 0.05}}},
                               {{"sheath_reference_C", "C", {-50, 150}}, 20}};

constexpr Separation kSeparations[] = {
    {"friction_wear", "heat the sheath alone, at one cycle number"},
    {"torque_gain", "heat the sheath alone, with the winding cold"}};

constexpr TensionEffect kEffect{
    "friction_temperature", "temperature-dependent friction",
    "a sheath that is hotter than the reference has another mu phi, and life goes with exp(-gamma "
    "k mu phi dT) for each kelvin that it stays so",
    kTable, kSeparations};

Parameters parameters(const ForceScales& /*scales*/) {
  return {usual(0.005, {"temperature_coefficient_1_K", "1/K", -0.05, 0.05, {0.001}})};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "all friction (1 + k (T - 20 C))",
    .missing = needs_sheath_temperature,
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.temperature_1_K = numbers[0]; },
    .written = written<parameters>,
    .of = ForceLaw::Of::session};

}  // namespace temperature

namespace wear {

/// Friction is held to seven times that of the model.
constexpr double kMostWear = 6;

constexpr TableKey kTable[] = {{{"wear_coefficient", "", {-1, kMostWear}}},
                               {{"wear_exponent", "", {0, 2}}},
                               {{"run_in_cycles", "cycles", {0, 10000}}}};

constexpr Separation kSeparations[] = {
    {"friction_temperature", "start from cold at several cycle numbers"},
    {"torque_gain", "start with a cold winding at several cycle numbers"}};

constexpr TensionEffect kEffect{"friction_wear", "wear or run-in of the sheath",
                                "the amplitude (13) grows with mu phi as the sheath wears, so that "
                                "later cycles do more damage than Miner books for new ones",
                                kTable, kSeparations};

std::string_view needs_cycles(const ForceRecord& record) {
  return record.cycle.empty()
             ? "no cycle number that differs between sessions (start_cycle in sessions.csv)"
             : "";
}

Parameters wear_parameters(const ForceScales& /*scales*/) {
  return {usual(0.3, {"wear_coefficient", "1", -1, kMostWear, {0.02}}),
          {"wear_exponent", "1", 0.1, 2, {1, 0.5}}};
}

constexpr ForceLaw kWear{.effect = &kEffect,
                         .own_term = "wear of the sheath",
                         .equation = "mu (1 + a (n/1000)^p)",
                         .missing = needs_cycles,
                         .parameters = wear_parameters,
                         .set =
                             [](Numbers numbers, ForceValues& values) {
                               values.wear = numbers[0];
                               values.wear_exponent = numbers[1];
                             },
                         .written =
                             [](std::string_view id, Numbers numbers, const ForceScales& scales) {
                               Extension extension = by_name(id, numbers, wear_parameters(scales));
                               extension.values.push_back({"run_in_cycles", {0}});
                               return extension;
                             },
                         .of = ForceLaw::Of::session};

constexpr double kMost_cycles = 10000;

Parameters run_in_parameters(const ForceScales& scales) {
  return {usual(0.3, {"wear_coefficient", "1", -1, kMostWear, {0.05}}),
          {"run_in_cycles",
           "cycles",
           1,
           std::clamp(2 * scales.cycles, 2.0, kMost_cycles),
           {0.03 * scales.cycles, 0.1 * scales.cycles, 0.3 * scales.cycles}}};
}

constexpr ForceLaw kRunIn{
    .effect = &kEffect,
    .own_term = "run-in of the sheath",
    .equation = "mu (1 + a exp(-n/n0))",
    .missing = needs_cycles,
    .parameters = run_in_parameters,
    .set =
        [](Numbers numbers, ForceValues& values) {
          values.run_in = numbers[0];
          values.run_in_cycles = numbers[1];
        },
    .written =
        [](std::string_view id, Numbers numbers, const ForceScales& scales) {
          Extension extension = by_name(id, numbers, run_in_parameters(scales));
          extension.values.insert(extension.values.begin() + 1, {"wear_exponent", {0}});
          return extension;
        },
    .of = ForceLaw::Of::session};

}  // namespace wear

namespace bend_angle {

constexpr double kMost_rad = 0.6;

constexpr TableKey kTable[] = {
    {{"bend_angle_error_rad", "rad", {-2 * kMost_rad, 2 * kMost_rad}}, std::nullopt, true}};

constexpr Separation kSeparations[] = {
    {"gear_asymmetry", "measure at four or more bend angles: an asymmetry is the same at each"}};

constexpr TensionEffect kEffect{
    "bend_angle", "bend-angle (pose) error",
    "a pose that bends more than it was said to has input tensions larger by exp(mu delta)", kTable,
    kSeparations};

/// A scale of all angles is one of mu: the largest is taken to be right, and its own error is that
/// of the others in proportion.
Parameters parameters(const ForceScales& scales) {
  Parameters all;
  for (std::size_t pose = 0; pose + 1 < scales.poses_rad.size(); ++pose) {
    const double most_rad =
        kMost_rad * (1 + scales.poses_rad[pose] / std::max(scales.poses_rad.back(), 1e-9));
    const int angle_deg =
        static_cast<int>(std::lround(scales.poses_rad[pose] * 180 / std::numbers::pi));
    // What all poses have in common is hardly more than another friction.
    all.push_back(usual(pose % 2 == 0 ? 0.26 : -0.26,
                        {"bend_angle_error_rad_at_" + std::to_string(angle_deg) + "_deg",
                         "rad",
                         -most_rad,
                         most_rad,
                         {0.02}}));
  }
  return all;
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "mu (phi + delta), delta of each pose",
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.pose_errors_rad = numbers; },
    .written =
        [](std::string_view id, Numbers numbers, const ForceScales& scales) {
          Extension::Value errors{"bend_angle_error_rad", {numbers.begin(), numbers.end()}};
          errors.values.push_back(0);
          Extension::Value angles{"bend_angles_deg", {}};
          for (const double pose_rad : scales.poses_rad) {
            angles.values.push_back(pose_rad * 180 / std::numbers::pi);
          }
          return Extension{std::string(id), {std::move(errors), std::move(angles)}};
        },
    .of = ForceLaw::Of::session};

}  // namespace bend_angle

namespace torque_gain {

constexpr TableKey kTable[] = {{{"droop_1_K", "1_K", {0, 0.005}}},
                               {{"winding_reference_C", "C", {-50, 200}}, 20}};

constexpr Separation kSeparations[] = {
    {"friction_temperature", "heat the motor alone, with the sheath cold"},
    {"friction_wear", "start with a cold winding at several cycle numbers"},
    {"current_offset", "take points near zero current and at high current"}};

constexpr TensionEffect kEffect{
    "torque_gain", "torque constant that falls as the winding warms",
    "a warm motor pulls less than its current says, so that damage is overstated by gamma alpha dT",
    kTable, kSeparations};

Parameters parameters(const ForceScales& /*scales*/) {
  return {usual(0.001, {"droop_1_K", "1/K", 0, 0.005, {0.0005}})};
}

constexpr ForceLaw kLaw{
    .effect = &kEffect,
    .equation = "K_t (1 - alpha (T_winding - 20 C))",
    .missing =
        [](const ForceRecord& record) {
          return record.winding_temperature_C.empty()
                     ? "no winding temperature that varies (winding_temperature_C): heat the motor "
                       "by 3 K or more"
                     : needs_current(record);
        },
    .parameters = parameters,
    .set = [](Numbers numbers, ForceValues& values) { values.droop_1_K = numbers[0]; },
    .written = written<parameters>,
    .of = ForceLaw::Of::session};

}  // namespace torque_gain

}  // namespace

constinit const ForceLaw kTemperature = temperature::kLaw;
constinit const ForceLaw kWear = wear::kWear;
constinit const ForceLaw kRunIn = wear::kRunIn;
constinit const ForceLaw kBendAngle = bend_angle::kLaw;
constinit const ForceLaw kTorqueGain = torque_gain::kLaw;

}  // namespace host_sim::effects::laws
