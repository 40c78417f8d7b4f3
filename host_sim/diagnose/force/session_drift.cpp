#include "host_sim/diagnose/force/session_drift.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/beta.hpp>
#include <cstddef>

#include "host_sim/diagnose/force/structure.hpp"

namespace host_sim::diagnose {
namespace {

constexpr Eigen::Index kFewInOrder = 8;

/// Of ln gain (0) or friction (1), beside the mean.
Eigen::VectorXd of_sessions(std::span<const ForceCovariance::Refit> refits, Eigen::Index which) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(refits.size()));
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    values(j) = refits[static_cast<std::size_t>(j)].value(which);
  }
  return values.array() - values.mean();
}

}  // namespace

/// Half the ratio, taken from 1, has the mean and variance of a beta on -1 .. 1 where values are
/// normal and independent.
SessionDrift drift_of(const Eigen::VectorXd& values) {
  const Eigen::Index count = values.size();
  const double square = (values.array() - values.mean()).square().sum();
  if (count < kFewInOrder || square <= 0) {
    return {};
  }
  const double ratio = (values.tail(count - 1) - values.head(count - 1)).squaredNorm() / square;
  const auto n = static_cast<double>(count);
  const double shape = ((n * n - 1) / (n - 2) - 1) / 2;
  const boost::math::beta_distribution<> chance(shape, shape);
  return {ratio, boost::math::cdf(chance, std::clamp(ratio / 4, 0.0, 1.0))};
}

Eigen::MatrixX2d standardized(std::span<const ForceCovariance::Refit> refits,
                              const Eigen::Array2d& scatter) {
  const auto count = static_cast<Eigen::Index>(refits.size());
  Eigen::ArrayX2d values(count, 2);
  Eigen::ArrayX2d variances(count, 2);
  for (Eigen::Index j = 0; j < count; ++j) {
    const ForceCovariance::Refit& refit = refits[static_cast<std::size_t>(j)];
    values.row(j) = refit.value.transpose();
    variances.row(j) =
        (refit.covariance.diagonal().array() + scatter.square()).transpose().max(1e-300);
  }
  const Eigen::ArrayX2d weights = variances.inverse();
  const Eigen::Array<double, 1, 2> means =
      (weights * values).colwise().sum() / weights.colwise().sum();
  return ((values.rowwise() - means) / variances.sqrt()).matrix();
}

SessionDrift drift_of_either(const Eigen::MatrixX2d& sessions) {
  SessionDrift rarer;
  for (const Eigen::Index which : {0, 1}) {
    const SessionDrift drift = drift_of(sessions.col(which));
    rarer = drift.p < rarer.p ? drift : rarer;
  }
  return {rarer.ratio, std::min(1.0, 2 * rarer.p)};
}

bool may_be_drift(std::span<const ForceCovariance::Refit> with,
                  std::span<const ForceCovariance::Refit> without, const Eigen::Array2d& scatter) {
  constexpr double kDrifts = 0.05;
  constexpr double kTenfold = 10;
  const Eigen::MatrixX2d in_errors = standardized(with, scatter);
  return std::ranges::any_of(std::to_array<Eigen::Index>({0, 1}), [&](Eigen::Index which) {
    const Eigen::VectorXd left = of_sessions(with, which);
    const Eigen::VectorXd moved = of_sessions(without, which) - left;
    return drift_of(in_errors.col(which)).p < SessionScatter::kRare / 2 &&
           drift_of(moved).p < kDrifts && moved.squaredNorm() < kTenfold * left.squaredNorm();
  });
}

}  // namespace host_sim::diagnose
