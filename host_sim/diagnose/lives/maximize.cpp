#include "host_sim/diagnose/lives/maximize.hpp"

#include <nlopt.hpp>
#include <vector>

namespace host_sim::diagnose::lives {
namespace {

constexpr double kGradientStep = 1e-5;
constexpr double kHessianStep = 1e-3;

struct Call {
  const Function* function;
  Eigen::VectorXd best;
  double best_value;
};

double call(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  auto& call = *static_cast<Call*>(data);
  Eigen::VectorXd at =
      Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size()));
  const double value = (*call.function)(at);
  if (value > call.best_value) {
    call.best_value = value;
    call.best = at;
  }
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    at[k] = x[i] + kGradientStep;
    const double above = (*call.function)(at);
    at[k] = x[i] - kGradientStep;
    const double below = (*call.function)(at);
    at[k] = x[i];
    gradient[i] = (above - below) / (2 * kGradientStep);
  }
  return value;
}

/// From the best that was seen; it ends early where a slope breaks off.
void climb(Call& data) {
  constexpr double kLastGain = 1e-7;
  constexpr int kMostCalls = 200;
  nlopt::opt search(nlopt::LD_SLSQP, static_cast<unsigned>(data.best.size()));
  search.set_max_objective(call, &data);
  search.set_lower_bounds(-kFarthest);
  search.set_upper_bounds(kFarthest);
  search.set_ftol_abs(kLastGain);
  search.set_maxeval(kMostCalls);
  std::vector<double> x(data.best.data(), data.best.data() + data.best.size());
  double value = 0;
  try {
    search.optimize(x, value);
  } catch (const nlopt::roundoff_limited&) {
    // The best that was seen is as good as differences allow.
  } catch (const std::runtime_error&) {
    // The same where a step of it failed.
  }
}

}  // namespace

Eigen::VectorXd maximize(const Function& function, const Eigen::VectorXd& start) {
  constexpr double kWorthwhile = 1e-3;
  constexpr int kMostClimbs = 20;
  Call data{&function, start, function(start)};
  for (int i = 0; i < kMostClimbs; ++i) {
    const double before = data.best_value;
    climb(data);
    if (!(data.best_value > before + kWorthwhile)) {
      break;
    }
  }
  return data.best;
}

Eigen::MatrixXd hessian(const Function& function, const Eigen::VectorXd& at) {
  const Eigen::Index n = at.size();
  Eigen::MatrixXd result(n, n);
  const double centre = function(at);
  std::vector<double> above(static_cast<std::size_t>(n));
  std::vector<double> below(static_cast<std::size_t>(n));
  Eigen::VectorXd x = at;
  for (Eigen::Index i = 0; i < n; ++i) {
    x[i] = at[i] + kHessianStep;
    above[static_cast<std::size_t>(i)] = function(x);
    x[i] = at[i] - kHessianStep;
    below[static_cast<std::size_t>(i)] = function(x);
    x[i] = at[i];
    result(i, i) =
        (above[static_cast<std::size_t>(i)] - 2 * centre + below[static_cast<std::size_t>(i)]) /
        (kHessianStep * kHessianStep);
  }
  // f(x + hi + hj) + f(x - hi - hj) holds twice the mixed derivative and both single ones.
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      x[i] = at[i] + kHessianStep;
      x[j] = at[j] + kHessianStep;
      const double both_above = function(x);
      x[i] = at[i] - kHessianStep;
      x[j] = at[j] - kHessianStep;
      const double both_below = function(x);
      x[i] = at[i];
      x[j] = at[j];
      const double both = (both_above - 2 * centre + both_below) / (kHessianStep * kHessianStep);
      result(i, j) = result(j, i) = (both - result(i, i) - result(j, j)) / 2;
    }
  }
  return result;
}

}  // namespace host_sim::diagnose::lives
