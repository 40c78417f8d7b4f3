#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/diagnose/force/force_model.hpp"

/// What laws of effects are written with, and the laws themselves: each is a namespace in the file
/// of its kind, and a place in the list of catalogue.cpp.
namespace host_sim::diagnose::laws {

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

inline bool has_current(const ForceRecord& record) {
  return record.input_N_per_A > 0;
}

inline bool has_sheath_temperature(const ForceRecord& record) {
  return !record.sheath_temperature_C.empty();
}

inline bool pulls_alone(const ForceRecord& record) {
  return record.pulls_alone;
}

inline bool works_both_ways(const ForceRecord& record) {
  return !record.pulls_alone;
}

extern const ForceEffect kPreload;
extern const ForceEffect kVelocity;
extern const ForceEffect kStribeck;
extern const ForceEffect kLoad;
extern const ForceEffect kPosition;
extern const ForceEffect kPresliding;
extern const ForceEffect kElasticPresliding;

extern const ForceEffect kSlack;
extern const ForceEffect kLooseTendon;
extern const ForceEffect kCompliance;

extern const ForceEffect kTemperature;
extern const ForceEffect kWear;
extern const ForceEffect kRunIn;
extern const ForceEffect kBendAngle;
extern const ForceEffect kTorqueGain;

extern const ForceEffect kLag;
extern const ForceEffect kDelay;
extern const ForceEffect kZero;
extern const ForceEffect kCurrentOffset;
extern const ForceEffect kGearAsymmetry;
extern const ForceEffect kTorqueRipple;

extern const ForceEffect kGivingSheath;
extern const ForceEffect kOneWayFriction;
extern const ForceEffect kBentSensor;
extern const ForceEffect kDriftingGain;
extern const ForceEffect kWarmSensor;

}  // namespace host_sim::diagnose::laws
