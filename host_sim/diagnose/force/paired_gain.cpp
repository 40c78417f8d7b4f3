#include "host_sim/diagnose/force/paired_gain.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace host_sim::diagnose {
namespace {

/// Of one session: what another model takes off, along what is left there and itself.
struct Regressed {
  double along = 0;
  double size = 0;
};

struct Slope {
  double value = 0;
  double error = 0;  ///< standard error; none where sessions show nothing
};

/// As far as the slope goes without each session (jackknife); without the one that alone shows
/// anything it is none.
Slope slope_of(const std::vector<Regressed>& sessions) {
  constexpr double kLeast = 1e-6;
  double along = 0;
  double size = 0;
  for (const Regressed& session : sessions) {
    along += session.along;
    size += session.size;
  }
  if (size <= 0) {
    return {};
  }
  const double slope = along / size;
  double square = 0;
  for (const Regressed& session : sessions) {
    const double others = size - session.size;
    const double without = others > kLeast * size ? (along - session.along) / others : 0;
    square += std::pow(without - slope, 2);
  }
  const auto count = static_cast<double>(sessions.size());
  return {slope, std::sqrt(std::max(square, 1e-300) * (count - 1) / count)};
}

}  // namespace

PairedGain paired_gain(std::span<const double> before_N2, std::span<const double> after_N2) {
  constexpr double kLeast_N2 = 1e-18;
  const double count = static_cast<double>(before_N2.size());
  double sum = 0;
  double square = 0;
  for (std::size_t j = 0; j < before_N2.size(); ++j) {
    const double gain =
        std::log(std::max(before_N2[j], kLeast_N2) / std::max(after_N2[j], kLeast_N2)) / 2;
    sum += gain;
    square += gain * gain;
  }
  PairedGain gain;
  gain.mean = sum / std::max(count, 1.0);
  const double variance = std::max(square / count - gain.mean * gain.mean, 1e-12) / (count - 1);
  gain.z = count > 1 ? gain.mean / std::sqrt(variance) : 0;
  return gain;
}

PairedGain paired_gain(const ForceData& data, const HeldOut& before, const HeldOut& after,
                       bool nested) {
  const double count = static_cast<double>(data.records().size());
  const ForceCovariance& covariance = data.covariance();
  PairedGain gain;
  gain.mean = std::max(paired_gain(before.beside_scatter_N2, after.beside_scatter_N2).mean,
                       std::log(data.rmse_N(before.plain_N2) / data.rmse_N(after.plain_N2)));
  gain.of_sessions = after.log_likelihood - before.log_likelihood;
  const auto taken_N2 = [&](std::span<const double> of_before, std::span<const double> of_after) {
    return std::pow(data.rmse_N(of_before), 2) - std::pow(data.rmse_N(of_after), 2);
  };
  gain.beside_scatter_N2 = taken_N2(before.beside_scatter_N2, after.beside_scatter_N2);
  gain.taken_N2 = taken_N2(before.weighted_N2, after.weighted_N2);
  double square_N4 = 0;
  for (std::size_t j = 0; j < data.records().size(); ++j) {
    const double less_N2 =
        (before.plain_N2[j] - after.plain_N2[j]) * data.counts()[j] / data.samples();
    gain.plain_N2 += less_N2;
    square_N4 += less_N2 * less_N2;
  }
  gain.plain_error_N2 = std::sqrt(std::max(count * square_N4 - gain.plain_N2 * gain.plain_N2, 0.0) /
                                  std::max(count - 1, 1.0));
  std::vector<Regressed> sessions;
  std::vector<Regressed> within;
  for (std::size_t j = 0; j < data.records().size(); ++j) {
    const Eigen::VectorXd left_N = vector_of(before.residuals_N[j]);
    const Eigen::VectorXd taken_N = left_N - vector_of(after.residuals_N[j]);
    const double noise_N2 = std::max(after.beside_scatter_N2[j], 1e-300);
    sessions.push_back({covariance.product(j, taken_N, left_N)(0, 0) / noise_N2,
                        covariance.product(j, taken_N, taken_N)(0, 0) / noise_N2});
    const Eigen::VectorXd taken_within_N = covariance.beside_refit(j, taken_N);
    gain.moved_N2 += covariance.weighted_square(j, taken_N) / data.samples();
    gain.within_N2 += covariance.weighted_square(j, taken_within_N) / data.samples();
    within.push_back({covariance.product(j, taken_within_N, left_N)(0, 0) / noise_N2,
                      covariance.product(j, taken_within_N, taken_within_N)(0, 0) / noise_N2});
  }
  const Slope slope = slope_of(sessions);
  if (count < 2 || slope.error <= 0) {
    return gain;
  }
  // Few sessions say less of how much they scatter: as surely as Student's t.
  const auto normal_of = [&](double t) {
    return std::copysign(std::sqrt(count * std::log1p(t * t / (count - 1))), t);
  };
  gain.z = normal_of((nested ? slope.value : slope.value - kEvenSlope) / slope.error);
  gain.log_odds = normal_of((slope.value - kEvenSlope) / slope.error) / slope.error;
  gain.slope = slope.value;
  gain.error = slope.error;
  const Slope slope_within = slope_of(within);
  gain.z_within = slope_within.error > 0 ? normal_of(slope_within.value / slope_within.error) : 0;
  gain.slope_within = slope_within.value;
  gain.error_within = slope_within.error;
  return gain;
}

}  // namespace host_sim::diagnose
