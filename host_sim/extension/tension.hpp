#pragma once

#include <cstddef>
#include <optional>

#include "host_sim/model/model.hpp"

namespace host_sim {

/// What the extended equations are evaluated at, at one instant.
struct Covariates {
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
  [[nodiscard]] double coefficient(const Covariates& at) const;

  /// phi with the error of the pose next to it in bend angle; never below 0.
  [[nodiscard]] double bend_angle_rad(double nominal_rad) const;

  /// ln(T_in / T_out) of a tendon of which a share `slip` of s slides: mu phi slip, and with
  /// mu (T/50 N)^-k at each place of the sheath the solution
  /// ln(1 + k mu phi slip (T_out/50 N)^-k) / k; the argument of the logarithm is held at
  /// kLeastLoadTerm. Without load dependence where T_out is not above 0.
  [[nodiscard]] double log_ratio(double output_tension_N, double slip, const Covariates& at) const;
  static constexpr double kLeastLoadTerm = 1.0 / 1024;

  /// F (1 + g(x)) + c |v|: what friction adds whatever the load is.
  [[nodiscard]] double load_independent_N(const Covariates& at) const;

 private:
  [[nodiscard]] double wear(double cycle) const;
  [[nodiscard]] double temperature(double sheath_temperature_C) const;
  [[nodiscard]] double position(double motor_angle_rad) const;
  [[nodiscard]] double velocity(double velocity_m_s) const;

  Model model_;
};

/// The place in kEmpiricalCovariates of what an empirical correction is written over.
std::size_t empirical_covariate(const Extension& empirical);

/// Input tension by the extended equations in double precision, sample by sample. Which effects of
/// the model act is acting.hpp's to say; here all are evaluated that the input in use can show.
class ExtendedInput {
 public:
  /// How far the inverse of a lag may move a tension, of the ultimate tension.
  static constexpr double kMostLagShare = 0.125;
  /// The torque constant does not fall below this share of its nominal value.
  static constexpr double kLeastGain = 0.05;

  explicit ExtendedInput(const Model& model);

  /// From output tension: T_in = T_out exp(mu phi s) + (F (1 + g(x)) + c |v|) s, with mu and phi
  /// extended; the load dependence is solved along the sheath. Where friction turns over along the
  /// way, s is the slip z: z += (s - z) (1 - exp(-|v| dt/l)), from 0 on. The zero and the lag are
  /// taken out of T_out first. A force the other way round is that of the other tendon of a pair,
  /// whose motion is the other way too: T_out exp(-mu phi s). The empirical correction comes last.
  double from_output_N(double output_tension_N, const Covariates& at);

  /// From motor current, with offset b, ripple (a, c), droop alpha and asymmetry e:
  /// T_in = K_t (1 - alpha (T_winding - T_ref)) (I - I_0 - b + a sin(k theta) + c cos(k theta))
  ///        N eta_g (1 + e s) / r_spool. The lag of the current is taken out of T_in last.
  /// @pre the model has a drive
  double from_current_N(double motor_current_A, const Covariates& at);

  /// A sample is missing, so that the next has no rate.
  void gap() { before_N_.reset(); }

 private:
  /// T + tau dT/dt with the difference to the sample before, one period ago; bounded.
  double without_lag_N(double tension_N, double lag_s);
  double slip(const Covariates& at);
  void travel(const Covariates& at);
  [[nodiscard]] double empirical_N(double output_N, const Covariates& at) const;

  Model model_;
  ExtendedFriction friction_;
  std::optional<double> before_N_;
  double slip_ = 0;
  double direction_ = 1;
  double travel_m_ = 0;  ///< since the motion turned
};

}  // namespace host_sim
