#include "host_sim/diagnose/tension/model_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <vector>

namespace host_sim::diagnose {
namespace {

using Eigen::Index;

/// Of gain and friction, far beyond what they ever are, so that one pose does not make them
/// indeterminate.
constexpr double kFlat_sd = 10;

Grams picked(const Grams& grams, std::span<const std::size_t> places) {
  Grams some{.baseline = grams.baseline, .layout = grams.layout, .sessions = {}};
  for (const std::size_t place : places) {
    some.sessions.push_back(grams.sessions[place]);
  }
  return some;
}

NoiseModel best_scatter(const Grams& grams, const Terms& terms, double sample_sd) {
  const std::vector<ScatterPoint> grid = scatter_grid(grams, sample_sd);
  const ScatterPoint* best = nullptr;
  double most = 0;
  for (const ScatterPoint& point : grid) {
    const double here = log_evidence({point}, terms, grams.response(), grams.samples());
    if (best == nullptr || here > most) {
      best = &point;
      most = here;
    }
  }
  return best->noise;
}

}  // namespace

ModelFit fit_model(const Grams& grams, const Terms& terms, std::span<const std::size_t> sessions,
                   double sample_sd) {
  const Grams some = picked(grams, sessions);
  ModelFit fit{.noise = best_scatter(some, terms, sample_sd), .coefficients = {}, .covariance = {}};
  std::vector<Index> columns{Index{GramLayout::kIntercept}, Index{GramLayout::kFriction}};
  columns.insert(columns.end(), terms.columns.begin(), terms.columns.end());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(grams.response() + 1, grams.response() + 1);
  for (const SessionGram& session : some.sessions) {
    information += session_information(session, fit.noise);
  }
  Eigen::MatrixXd inner = information(columns, columns);
  Eigen::VectorXd products = information(columns, grams.response());
  for (Index i = 0; i < inner.rows(); ++i) {
    const auto term = static_cast<std::size_t>(i) - 2;
    const double sd = i < 2 ? kFlat_sd : terms.prior_sd[term];
    inner(i, i) += 1 / (sd * sd);
    products(i) += i < 2 ? 0 : terms.prior_mean[term] / (sd * sd);
  }
  const Eigen::LDLT<Eigen::MatrixXd> solver(inner);
  fit.coefficients = solver.solve(products);
  fit.covariance = solver.solve(Eigen::MatrixXd::Identity(inner.rows(), inner.cols()));
  return fit;
}

ModelFit fit_model(const Grams& grams, const Terms& terms, double sample_sd) {
  std::vector<std::size_t> all(grams.sessions.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return fit_model(grams, terms, all, sample_sd);
}

}  // namespace host_sim::diagnose
