#pragma once

#include <optional>
#include <vector>

#include "host_sim/extension/friction.hpp"
#include "host_sim/model/model.hpp"

namespace host_sim {

/// Input tension by the extended equations in double precision, sample by sample. Which effects of
/// the model act is acting.hpp's to say; here all are evaluated that the input in use can show.
class ExtendedInput {
 public:
  /// How far the inverse of a lag may move a tension, of the ultimate tension.
  static constexpr double kMostLagShare = 0.125;
  /// The torque constant does not fall below this share of its nominal value.
  static constexpr double kLeastGain = 0.05;

  explicit ExtendedInput(const Model& model);

  /// From output tension: T_in = T_out exp(mu phi s) + F s, with mu and phi extended; the load
  /// dependence is solved along the sheath. The lag is taken out of T_out first.
  double from_output_N(double output_tension_N, const Circumstances& at);

  /// From motor current, with offset b, ripple (a, c), droop alpha and asymmetry e:
  /// T_in = K_t (1 - alpha (T_winding - T_ref)) (I - I_0 - b + a sin(k theta) + c cos(k theta))
  ///        N eta_g (1 + e s) / r_spool. The lag of the current is taken out of T_in last.
  /// @pre the model has a drive
  double from_current_N(double motor_current_A, const Circumstances& at);

  /// A sample is missing, so that the next has no rate.
  void gap() { before_N_.reset(); }

 private:
  /// T + tau dT/dt with the difference to the sample before, one period ago; bounded.
  double without_lag_N(double tension_N, double lag_s);

  Model model_;
  ExtendedFriction friction_;
  std::optional<double> before_N_;
};

}  // namespace host_sim
