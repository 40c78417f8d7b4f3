#include "host_sim/synth/tension/motion.hpp"

#include <cmath>
#include <numbers>

namespace host_sim::synth {
namespace {

constexpr double kTurn_rad = 2 * std::numbers::pi;
constexpr double kRadPerDeg = std::numbers::pi / 180;

/// How square the velocity of a rounded triangle is: 1 is a triangle.
constexpr double kSquareness = 0.98;

struct Stroke {
  double position, velocity, acceleration;  ///< in amplitudes and radians
};

Stroke sine(double angle_rad) {
  return {-std::cos(angle_rad), std::sin(angle_rad), std::cos(angle_rad)};
}

/// -asin(k cos a) / asin(k) and its derivatives.
Stroke rounded_triangle(double angle_rad) {
  const double k = kSquareness;
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  const double root = std::sqrt(1 - k * k * c * c);
  const double scale = k / std::asin(k);
  return {-std::asin(k * c) / std::asin(k), scale * s / root,
          scale * c * (1 - k * k) / (root * root * root)};
}

}  // namespace

void move_to(double time_s, const Motion& motion, const Setting& setting, Covariates& covariates) {
  const double rate_rad_s = kTurn_rad * setting.frequency_Hz;
  const double amplitude_m = setting.travel_mm * 1e-3 / 2;
  const double angle_rad = kTurn_rad * std::fmod(setting.frequency_Hz * time_s, 1.0);
  const Stroke stroke =
      motion.form == Motion::Form::sine ? sine(angle_rad) : rounded_triangle(angle_rad);
  covariates.step_s = time_s - covariates.time_s;
  covariates.time_s = time_s;
  covariates.wall_clock_h =
      static_cast<double>(setting.number) * motion.session_interval_h + time_s / 3600;
  covariates.cycle = setting.start_cycle + setting.frequency_Hz * time_s;
  const double position_m = amplitude_m * stroke.position;
  covariates.travel_m = covariates.step_s > 0 ? position_m - covariates.position_m : 0;
  covariates.position_m = position_m;
  covariates.velocity_m_s = amplitude_m * rate_rad_s * stroke.velocity;
  covariates.acceleration_m_s2 = amplitude_m * rate_rad_s * rate_rad_s * stroke.acceleration;
  if (covariates.velocity_m_s != 0) {
    covariates.direction = covariates.velocity_m_s > 0 ? 1 : -1;
  }
  const double sway_rad_s = kTurn_rad * motion.pose_sway_Hz;
  const double sway_rad = motion.pose_sway_deg * kRadPerDeg;
  covariates.bend_angle_rad =
      setting.bend_angle_deg * kRadPerDeg + sway_rad * std::sin(sway_rad_s * time_s);
  covariates.bend_rate_rad_s = sway_rad * sway_rad_s * std::cos(sway_rad_s * time_s);
  const double load_rad =
      rate_rad_s * motion.load_frequency_ratio * time_s + motion.load_phase_deg * kRadPerDeg;
  covariates.output_tension_N =
      setting.output_mean_N - setting.output_amplitude_N * std::cos(load_rad);
  covariates.ambient_C = setting.sheath_ambient_C;
}

}  // namespace host_sim::synth
