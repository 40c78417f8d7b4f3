#include "host_sim/io/model_keys.hpp"

#include <array>

namespace host_sim {
namespace {

constexpr std::array<ModelKey, 14> kKeys{{
    {"cable",
     "diameter_mm",
     "mm",
     {0.01, 10.0},
     [](Model& m) -> double& { return m.cable.diameter_mm; }},
    {"cable",
     "ultimate_tension_N",
     "N",
     {5.0, 1000.0},
     [](Model& m) -> double& { return m.cable.ultimate_tension_N; }},
    {"sheath",
     "friction_coefficient",
     "",
     {0.0, 1.0},
     [](Model& m) -> double& { return m.sheath.friction_coefficient; }},
    {"sheath",
     "bend_angle_deg",
     "deg",
     {0.0, 1800.0},
     [](Model& m) -> double& { return m.sheath.bend_angle_deg; }},
    {"drive",
     "torque_constant_Nm_per_A",
     "Nm_per_A",
     {1e-6, 100.0},
     [](Model& m) -> double& { return m.drive->torque_constant_Nm_per_A; }},
    {"drive",
     "gear_ratio",
     "",
     {0.001, 10000.0},
     [](Model& m) -> double& { return m.drive->gear_ratio; }},
    {"drive",
     "gear_efficiency",
     "",
     {0.01, 1.0},
     [](Model& m) -> double& { return m.drive->gear_efficiency; }},
    {"drive",
     "spool_radius_mm",
     "mm",
     {0.1, 1000.0},
     [](Model& m) -> double& { return m.drive->spool_radius_mm; }},
    {"drive",
     "current_offset_A",
     "A",
     {-100.0, 100.0},
     [](Model& m) -> double& { return m.drive->current_offset_A; }},
    {"counting",
     "sample_rate_Hz",
     "Hz",
     {0.1, 100000.0},
     [](Model& m) -> double& { return m.counting.sample_rate_Hz; }},
    {"counting",
     "hysteresis_N",
     "N",
     {0.0, 100.0},
     [](Model& m) -> double& { return m.counting.hysteresis_N; }},
    {"life",
     "ipl_scale",
     "",
     {0.0, 1e300, true},
     [](Model& m) -> double& { return m.life.ipl_scale; }},
    {"life",
     "ipl_exponent",
     "",
     {1.0, 12.0},
     [](Model& m) -> double& { return m.life.ipl_exponent; }},
    {"life",
     "weibull_shape",
     "",
     {0.5, 50.0},
     [](Model& m) -> double& { return m.life.weibull_shape; }},
}};

}  // namespace

std::span<const ModelKey> model_keys() {
  return kKeys;
}

}  // namespace host_sim
