#include "host_sim/replay/constants.hpp"

#include <charconv>
#include <numbers>
#include <stdexcept>
#include <string>

#include "lifemodel/pack/pack.hpp"

namespace host_sim {

double radians(double angle_deg) {
  return angle_deg * std::numbers::pi / 180;
}

reference::Drive drive_of(const Model& model) {
  const Model::Drive& drive = *model.drive;
  return {drive.torque_constant_Nm_per_A, drive.gear_ratio, drive.gear_efficiency,
          drive.spool_radius_mm * 1e-3, drive.current_offset_A};
}

reference::Constants reference_constants_of(const Model& model) {
  return {model.cable.ultimate_tension_N, model.counting.hysteresis_N, model.life.ipl_scale,
          model.life.ipl_exponent, model.life.weibull_shape};
}

lifemodel::Parameters parameters_of(const Model& model) {
  lifemodel::pack::Constants constants{
      .ultimate_tension_N = model.cable.ultimate_tension_N,
      .hysteresis_N = model.counting.hysteresis_N,
      .ipl_scale = model.life.ipl_scale,
      .ipl_exponent = model.life.ipl_exponent,
      .weibull_shape = model.life.weibull_shape,
      .friction_coefficient = model.sheath.friction_coefficient,
      .bend_angle_rad = radians(model.sheath.bend_angle_deg),
      .tension_per_current_N_A = std::nullopt,
      .current_offset_A = 0,
      .sample_period_s = 1 / model.counting.sample_rate_Hz,
      .model_digest = 0,
  };
  if (model.drive) {
    reference::Drive drive = drive_of(model);
    constants.current_offset_A = drive.current_offset_A;
    drive.current_offset_A = 0;
    constants.tension_per_current_N_A = reference::input_tension_from_current(1, drive);
  }
  const std::string digest = model_digest(model);
  std::from_chars(digest.data(), digest.data() + digest.size(), constants.model_digest, 16);
  const auto parameters = lifemodel::pack::parameters(constants);
  if (!parameters) {
    throw std::invalid_argument(lifemodel::to_string(parameters.error()));
  }
  return *parameters;
}

}  // namespace host_sim
