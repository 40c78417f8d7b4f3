#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/effects/tension/force_model.hpp"

/// What effects are written with, and their laws: each effect is a namespace in the file of its
/// kind, and each of its laws a place in the list of catalogue.cpp.
namespace host_sim::effects::laws {

using Parameters = std::vector<ForceParameter>;
using Numbers = std::span<const double>;

/// By the names of the parameters.
inline Extension by_name(std::string_view id, Numbers parameters, const Parameters& names) {
  Extension extension{std::string(id), {}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    extension.values.push_back({names[i].name, {parameters[i]}});
  }
  return extension;
}

/// The same as the table of a law that has these.
template <Parameters (*kParameters)(const ForceScales&)>
Extension written(std::string_view id, Numbers numbers, const ForceScales& scales) {
  return by_name(id, numbers, kParameters(scales));
}

/// k of laws of a tendon that stretches: at the least the whole stroke stretches it by what
/// friction of 1 % holds.
/// @param starts in units of the rms force over the stroke
inline ForceParameter stiffness(std::string name, const ForceScales& scales,
                                std::vector<double> starts) {
  const double unit_N_m = scales.force_N / scales.stroke_m;
  for (double& start : starts) {
    start *= unit_N_m;
  }
  constexpr double kLeast = 0.01;
  return {std::move(name), "N/m", kLeast * unit_N_m, 1e4 * unit_N_m, std::move(starts)};
}

/// A parameter of which a usual effect has this size.
inline ForceParameter usual(double size, ForceParameter parameter) {
  parameter.usual = size;
  return parameter;
}

// What laws need: empty where a record holds it, else what is missing, in words.

inline std::string_view needs_current(const ForceRecord& record) {
  return record.input_N_per_A > 0
             ? ""
             : "input tension comes from a load cell, which the drive does not change";
}

inline std::string_view needs_load(const ForceRecord& record) {
  return std::ranges::all_of(record.output_N, [](double output_N) { return output_N == 0; })
             ? "output_tension_N is 0 N throughout: no sensor has read it"
             : "";
}

inline std::string_view needs_sheath_temperature(const ForceRecord& record) {
  return record.sheath_temperature_C.empty()
             ? "no sheath temperature that varies (sheath_temperature_C): heat the sheath by 3 K "
               "or more"
             : "";
}

inline std::string_view needs_one_tendon(const ForceRecord& record) {
  return record.pulls_alone ? "" : "the force works both ways";
}

inline std::string_view needs_both_ways(const ForceRecord& record) {
  return record.pulls_alone ? "the tendon pulls alone" : "";
}

extern const ForceLaw kPreload;
extern const ForceLaw kVelocity;
extern const ForceLaw kStribeck;
extern const ForceLaw kLoad;
extern const ForceLaw kPosition;
extern const ForceLaw kPositionFromMiddle;
extern const ForceLaw kPresliding;
extern const ForceLaw kElasticPresliding;

extern const ForceLaw kSlack;
extern const ForceLaw kLooseTendon;
extern const ForceLaw kCompliance;

extern const ForceLaw kTemperature;
extern const ForceLaw kWear;
extern const ForceLaw kRunIn;
extern const ForceLaw kBendAngle;
extern const ForceLaw kTorqueGain;

extern const ForceLaw kLag;
extern const ForceLaw kDelay;
extern const ForceLaw kZero;
extern const ForceLaw kCurrentOffset;
extern const ForceLaw kGearAsymmetry;
extern const ForceLaw kTorqueRipple;

extern const ForceLaw kFrictionByLoad;
extern const ForceLaw kFrictionBySpeed;
extern const ForceLaw kGivingSheath;
extern const ForceLaw kOneWayFriction;
extern const ForceLaw kBentSensor;
extern const ForceLaw kDriftingGain;
extern const ForceLaw kWarmSensor;

}  // namespace host_sim::effects::laws
