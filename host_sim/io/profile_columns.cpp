#include "host_sim/io/profile_columns.hpp"

#include <array>

namespace host_sim {
namespace {

constexpr std::array<ProfileColumn, kProfileColumnCount> kColumns{{
    {"time_s", "s", -1e12, 1e12},
    {"input_tension_N", "N", -1e6, 1e6},
    {"motor_current_A", "A", -1e6, 1e6},
    {"output_tension_N", "N", -1e6, 1e6},
    {"tendon_velocity_m_s", "m_s", -1000.0, 1000.0},
    {"bend_angle_deg", "deg", 0.0, 1800.0},
    {"motor_angle_rad", "rad", -1e12, 1e12},
    {"sheath_temperature_C", "C", -273.15, 10000.0},
    {"winding_temperature_C", "C", -273.15, 10000.0},
}};

}  // namespace

std::span<const ProfileColumn, kProfileColumnCount> profile_columns() {
  return kColumns;
}

std::string profile_column_names() {
  std::string names;
  for (const ProfileColumn& column : kColumns) {
    if (!names.empty()) {
      names += ", ";
    }
    names += column.name;
  }
  return names;
}

}  // namespace host_sim
