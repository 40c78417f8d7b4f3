#pragma once

#include <span>

#include "host_sim/diagnose/force/force_fit.hpp"

namespace host_sim::diagnose {

/// Of PairedGain::slope, where both models leave as much.
inline constexpr double kEvenSlope = 0.5;

/// How much less one model leaves than another on sessions that neither saw, beside the scatter.
struct PairedGain {
  double mean = 0;               ///< of ln(rmse_b/rmse_a) over sessions
  double z = 0;                  ///< how surely, in standard errors of a normal distribution
  double slope = 0;              ///< along what they differ in: 1 where the other is the truth
  double error = 0;              ///< standard error of the slope
  double log_odds = 0;           ///< of the other model against the one
  double of_sessions = 0;        ///< gain of HeldOut::log_likelihood
  double moved_N2 = 0;           ///< mean square of what they differ by, by weight of samples
  double within_N2 = 0;          ///< the same of what gain and friction of each session leave
  double z_within = 0;           ///< z of that
  double slope_within = 0;       ///< slope of that
  double error_within = 0;       ///< standard error of it
  double taken_N2 = 0;           ///< that the mean square by the weight of samples is less
  double beside_scatter_N2 = 0;  ///< the same of what gain and friction of sessions leave
  double plain_N2 = 0;           ///< that the mean square is less, each sample alike
  double plain_error_N2 = 0;     ///< standard error of that, of sessions that scatter

  [[nodiscard]] bool any() const { return taken_N2 > 0 || beside_scatter_N2 > 0; }
};

/// Record by record: the mean of ln(rmse_b/rmse_a), and that over its standard error.
PairedGain paired_gain(std::span<const double> before_N2, std::span<const double> after_N2);

/// What the other model takes off a session is regressed on what is left there: sessions count by
/// how much the models differ in them. Of the truth the slope is 1.
/// @param nested whether the other is the one and more: z is how surely the slope is above 0,
///   where that takes off nothing that is there, else above 1/2, where both leave as much
PairedGain paired_gain(const ForceData& data, const HeldOut& before, const HeldOut& after,
                       bool nested);

}  // namespace host_sim::diagnose
