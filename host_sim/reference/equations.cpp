#include "host_sim/reference/equations.hpp"

#include <cmath>
#include <limits>

namespace host_sim::reference {

double capstan_efficiency(double friction_coefficient, double bend_angle_rad) {
  return std::exp(-friction_coefficient * bend_angle_rad);
}

MeanAmplitude input_tension_range(const MeanAmplitude& output, double efficiency) {
  const double even = (1.0 / efficiency + efficiency) / 2.0;
  const double odd = (1.0 / efficiency - efficiency) / 2.0;
  return {.mean_N = even * output.mean_N + odd * output.amplitude_N,
          .amplitude_N = odd * output.mean_N + even * output.amplitude_N};
}

Direction direction_of(double tendon_velocity_m_s, Direction last) {
  if (tendon_velocity_m_s > 0.0) {
    return Direction::kPulling;
  }
  return tendon_velocity_m_s < 0.0 ? Direction::kReleasing : last;
}

double input_tension_from_output(double output_tension_N, double efficiency, Direction direction) {
  return direction == Direction::kPulling ? output_tension_N / efficiency
                                          : output_tension_N * efficiency;
}

double input_tension_from_current(double motor_current_A, const Drive& drive) {
  return drive.torque_constant_Nm_per_A * (motor_current_A - drive.current_offset_A) *
         drive.gear_ratio * drive.gear_efficiency / drive.spool_radius_m;
}

double gerber_effective_tension(const MeanAmplitude& input, double ultimate_tension_N) {
  if (input.amplitude_N == 0.0) {
    return 0.0;
  }
  if (std::abs(input.mean_N) >= ultimate_tension_N) {
    return std::numeric_limits<double>::infinity();
  }
  const double mean_ratio = input.mean_N / ultimate_tension_N;
  return input.amplitude_N / (1.0 - mean_ratio * mean_ratio);
}

double ipl_life_cycles(double effective_tension_N, double ipl_scale, double ipl_exponent) {
  return ipl_scale / std::pow(effective_tension_N, ipl_exponent);
}

double weibull_survival(double damage, double weibull_shape) {
  return std::exp(-std::pow(damage, weibull_shape));
}

double weibull_life_damage(double failed_fraction, double weibull_shape) {
  return std::pow(-std::log1p(-failed_fraction), 1.0 / weibull_shape);
}

double weibull_mean_damage(double weibull_shape) {
  return std::tgamma(1.0 + 1.0 / weibull_shape);
}

double weibull_further_damage(double damage, double risk, double weibull_shape) {
  const double power = std::pow(damage, weibull_shape);
  const double hazard = -std::log1p(-risk);
  if (hazard > power * 1e300) {
    return weibull_life_damage(risk, weibull_shape) - damage;
  }
  return hazard == 0.0 ? 0.0 : damage * std::expm1(std::log1p(hazard / power) / weibull_shape);
}

double weibull_break_risk(double damage, double further, double weibull_shape) {
  const double share =
      damage == 0.0 ? 1.0 : -std::expm1(-weibull_shape * std::log1p(further / damage));
  return -std::expm1(-std::pow(damage + further, weibull_shape) * share);
}

}  // namespace host_sim::reference
