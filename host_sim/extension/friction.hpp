#pragma once

#include <vector>

#include "host_sim/model/model.hpp"

namespace host_sim {

/// What the extended equations are evaluated at, at one instant.
struct Circumstances {
  double velocity_m_s = 0;  ///< of the tendon, positive while pulling
  double direction = 1;     ///< s: 1 while pulling, -1 while letting go
  double bend_angle_rad = 0;
  double cycle = 0;  ///< n, from the first of the sheath
  double motor_angle_rad = 0;
  double sheath_temperature_C = 20;
  double winding_temperature_C = 20;
};

/// Friction of the sheath with all effects of a model:
/// mu = mu_0 (1 + wear) (1 + temperature) (1 + position) + (mu_s - mu) exp(-|v|/v_s) + kappa |v|.
class ExtendedFriction {
 public:
  /// Each factor is held in 0 .. kMostFactor, mu in 0 .. kMostCoefficient.
  static constexpr double kMostFactor = 7;
  static constexpr double kMostCoefficient = 2;

  explicit ExtendedFriction(const Model& model);

  /// mu, but for its dependence on the tension.
  [[nodiscard]] double coefficient(const Circumstances& at) const;

  /// phi with the error of the pose next to it in bend angle; never below 0.
  [[nodiscard]] double bend_angle_rad(double nominal_rad) const;

  /// ln(T_in / T_out) of a tendon that slides: mu phi s, and with mu (T/50 N)^-k at each place of
  /// the sheath the solution ln(1 + k mu phi s (T_out/50 N)^-k) / k; the argument of the logarithm
  /// is held at kLeastLoadTerm. Without load dependence where T_out is not above 0.
  [[nodiscard]] double log_ratio(double output_tension_N, const Circumstances& at) const;
  static constexpr double kLeastLoadTerm = 1.0 / 1024;

 private:
  [[nodiscard]] double wear(double cycle) const;
  [[nodiscard]] double temperature(double sheath_temperature_C) const;
  [[nodiscard]] double position(double motor_angle_rad) const;
  [[nodiscard]] double velocity(double velocity_m_s) const;

  Model model_;
};

}  // namespace host_sim
