#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "host_sim/life_law/life_design.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/life_law/life_likelihood.hpp"
#include "host_sim/life_law/newton.hpp"

namespace host_sim::life_law {
namespace {

/// A quantity of a power law with one shape as a function of the coefficients of its design
/// (ln alpha at the centre, exponent times spread, phi = ln beta):
///   q = linear . coefficients + h(phi)
/// where h is 0, sigma ln(-ln(1 - p)) for a quantile, ln Gamma(1 + sigma) for a mean life, with
/// sigma = exp(-phi). The shape is taken by its logarithm.
class Quantity {
 public:
  Quantity(const LifeQuantity& wanted, const LogTensionFrame& frame);

  /// What follows from ln beta, and its derivatives.
  struct Part {
    double value = 0, first = 0, second = 0;
  };
  [[nodiscard]] Part part(double ln_shape) const;

  [[nodiscard]] double value(const Eigen::Vector3d& coefficients) const;
  [[nodiscard]] Eigen::Vector3d gradient(const Eigen::Vector3d& coefficients) const;
  [[nodiscard]] const Eigen::Vector3d& linear() const { return linear_; }

  /// The coefficient that is given by the quantity and the other two.
  [[nodiscard]] Eigen::Index dependent() const { return dependent_; }

 private:
  LifeQuantity::Kind kind_;
  double p_;
  Eigen::Vector3d linear_;
  Eigen::Index dependent_;
};

using QuantityKind = LifeQuantity::Kind;

Eigen::Vector3d linear_part(const LifeQuantity& wanted, const LogTensionFrame& frame) {
  switch (wanted.kind) {
    case QuantityKind::exponent:
      return {0, 1 / frame.spread, 0};
    case QuantityKind::shape:
      return {0, 0, 1};
    case QuantityKind::ln_scale:
      return {1, -frame.x(1), 0};
    case QuantityKind::ln_mean_life:
    case QuantityKind::ln_quantile:
      break;
  }
  return {1, -frame.x(wanted.effective_tension_N), 0};
}

Eigen::Index dependent_of(QuantityKind kind) {
  switch (kind) {
    case QuantityKind::exponent:
      return 1;
    case QuantityKind::shape:
      return 2;
    case QuantityKind::ln_scale:
    case QuantityKind::ln_mean_life:
    case QuantityKind::ln_quantile:
      break;
  }
  return 0;
}

Quantity::Quantity(const LifeQuantity& wanted, const LogTensionFrame& frame)
    : kind_(wanted.kind),
      p_(wanted.p),
      linear_(linear_part(wanted, frame)),
      dependent_(dependent_of(wanted.kind)) {}

Quantity::Part Quantity::part(double ln_shape) const {
  const double sigma = std::exp(-ln_shape);
  if (kind_ == QuantityKind::ln_quantile) {
    const double term = std::log(-std::log1p(-p_)) * sigma;
    return {.value = term, .first = -term, .second = term};
  }
  if (kind_ == QuantityKind::ln_mean_life) {
    const double slope = sigma * boost::math::digamma(1 + sigma);
    return {.value = boost::math::lgamma(1 + sigma),
            .first = -slope,
            .second = slope + sigma * sigma * boost::math::trigamma(1 + sigma)};
  }
  return {};
}

double Quantity::value(const Eigen::Vector3d& coefficients) const {
  return linear_.dot(coefficients) + part(coefficients[2]).value;
}

Eigen::Vector3d Quantity::gradient(const Eigen::Vector3d& coefficients) const {
  return linear_ + part(coefficients[2]).first * Eigen::Vector3d::UnitZ();
}

/// The largest log likelihood for each value of a quantity.
class ProfileLikelihood {
 public:
  /// @param best coefficients with the largest log likelihood of all
  ProfileLikelihood(const LifeDesign& design, const Quantity& quantity,
                    const Eigen::Vector3d& best);

  [[nodiscard]] double best_value() const { return best_value_; }
  /// Standard error of the quantity by the curvature at its best value.
  [[nodiscard]] double standard_error() const { return standard_error_; }
  /// The log likelihood's loss against its maximum, 0 or more.
  [[nodiscard]] double loss(double value) const;
  /// The value on one side of the best one, -1 or 1, at which the root of twice the loss is
  /// `wanted`, where Newton's steps from a parabola find it: value, coefficients and multiplier at
  /// once (Venzon and Moolgavkar, A method for computing profile-likelihood-based confidence
  /// intervals, 1988).
  [[nodiscard]] std::optional<double> end_at_once(double wanted, double side) const;

 private:
  [[nodiscard]] Eigen::Vector3d complete(const Eigen::Vector2d& free, double value) const;
  void expand(const Eigen::VectorXd& free, double value, Expansion& expansion) const;

  const LifeDesign& design_;
  const Quantity& quantity_;
  Eigen::Index first_;  ///< the coefficients that are free
  Eigen::Index second_;
  Eigen::Vector3d best_;
  Eigen::Vector3d
      ridge_;  ///< how the best coefficients move with the quantity, near its best value
  double best_value_;
  double standard_error_;
  double best_log_likelihood_;
};

constexpr Eigen::Index kLnShape = 2;

ProfileLikelihood::ProfileLikelihood(const LifeDesign& design, const Quantity& quantity,
                                     const Eigen::Vector3d& best)
    : design_(design),
      quantity_(quantity),
      first_(quantity.dependent() == 0 ? 1 : 0),
      second_(quantity.dependent() == kLnShape ? 1 : kLnShape),
      best_(best),
      best_value_(quantity.value(best)) {
  Expansion expansion;
  expand_log_likelihood(design, best, expansion);
  const Eigen::Matrix3d covariance = Eigen::Matrix3d(-expansion.hessian).inverse();
  const Eigen::Vector3d gradient = quantity.gradient(best);
  const double variance = gradient.dot(covariance * gradient);
  ridge_ = covariance * gradient / variance;
  standard_error_ = std::sqrt(variance);
  best_log_likelihood_ = expansion.value;
}

Eigen::Vector3d ProfileLikelihood::complete(const Eigen::Vector2d& free, double value) const {
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();
  coefficients[first_] = free[0];
  coefficients[second_] = free[1];
  const Eigen::Index dependent = quantity_.dependent();
  coefficients[dependent] = (value - quantity_.value(coefficients)) / quantity_.linear()[dependent];
  return coefficients;
}

void ProfileLikelihood::expand(const Eigen::VectorXd& free, double value,
                               Expansion& expansion) const {
  const Eigen::Vector3d coefficients = complete(free, value);
  Expansion full;
  expand_log_likelihood(design_, coefficients, full);

  const Eigen::Index dependent = quantity_.dependent();
  const Eigen::Vector3d slopes = -quantity_.gradient(coefficients) / quantity_.linear()[dependent];
  Eigen::Matrix<double, 3, 2> chain = Eigen::Matrix<double, 3, 2>::Zero();
  chain(first_, 0) = 1;
  chain(second_, 1) = 1;
  chain(dependent, 0) = slopes[first_];
  chain(dependent, 1) = slopes[second_];
  expansion.value = full.value;
  expansion.gradient = chain.transpose() * full.gradient;
  expansion.hessian = chain.transpose() * full.hessian * chain;
  if (second_ == kLnShape) {
    const double bend = quantity_.part(coefficients[kLnShape]).second;
    expansion.hessian(1, 1) -= full.gradient[dependent] * bend / quantity_.linear()[dependent];
  }
}

double ProfileLikelihood::loss(double value) const {
  const Eigen::Vector3d near = best_ + (value - best_value_) * ridge_;
  const Eigen::Vector2d start(near[first_], near[second_]);
  const Maximum maximum =
      maximise([this, value](const Eigen::VectorXd& free,
                             Expansion& expansion) { expand(free, value, expansion); },
               start);
  return std::max(0.0, best_log_likelihood_ - maximum.expansion.value);
}

std::optional<double> ProfileLikelihood::end_at_once(double wanted, double side) const {
  constexpr int kMostSteps = 12;
  constexpr double kSettled = 1e-7;  // standard errors; the next step is below a double's precision
  constexpr double kLongest = 2;     // the same
  double value = best_value_ + side * wanted * standard_error_;
  Eigen::Vector3d coefficients = best_ + (value - best_value_) * ridge_;
  double multiplier = side * wanted / standard_error_;
  Expansion full;
  for (int step = 0; step < kMostSteps; ++step) {
    expand_log_likelihood(design_, coefficients, full);
    const double missing = best_log_likelihood_ - wanted * wanted / 2 - full.value;
    if (!std::isfinite(missing)) {
      return std::nullopt;
    }
    const Eigen::Vector3d by_quantity = quantity_.gradient(coefficients);
    Eigen::Matrix4d system = Eigen::Matrix4d::Zero();
    system.topLeftCorner<3, 3>() = full.hessian;
    system(kLnShape, kLnShape) += multiplier * quantity_.part(coefficients[kLnShape]).second;
    system.topRightCorner<3, 1>() = by_quantity;
    system.bottomLeftCorner<1, 3>() = full.gradient.transpose();
    Eigen::Vector4d wrong;
    wrong << -full.gradient - multiplier * by_quantity, missing;
    const Eigen::Vector4d change = system.fullPivLu().solve(wrong);
    coefficients += change.head<3>();
    multiplier += change[3];
    const double before = value;
    value = quantity_.value(coefficients);
    const double moved = std::abs(value - before) / standard_error_;
    if (!(moved < kLongest) || side * (value - best_value_) <= 0 || side * multiplier <= 0) {
      return std::nullopt;
    }
    if (moved < kSettled && std::abs(missing) < kSettled) {
      return value;
    }
  }
  return std::nullopt;
}

/// The value on one side of the best one at which the root of twice the loss is `wanted`.
double end_of(const ProfileLikelihood& profile, double wanted, double side) {
  if (const auto end = profile.end_at_once(wanted, side)) {
    return *end;
  }
  constexpr double kFurthest = 1e4;  // in standard errors
  constexpr int kBits = 40;
  constexpr double kGrowth = 1.5;
  const double error = profile.standard_error();
  // Nearly linear, with `distance` in standard errors.
  const auto excess = [&](double distance) {
    return std::sqrt(2 * profile.loss(profile.best_value() + side * distance * error)) - wanted;
  };
  double near = 0;
  double far = wanted;
  double excess_near = -wanted;
  double excess_far = excess(far);
  while (excess_far < 0) {
    near = far;
    excess_near = excess_far;
    far *= kGrowth;
    if (far > kFurthest) {
      return side * std::numeric_limits<double>::infinity();
    }
    excess_far = excess(far);
  }
  std::uintmax_t steps = 100;
  const auto [below, above] =
      boost::math::tools::toms748_solve(excess, near, far, excess_near, excess_far,
                                        boost::math::tools::eps_tolerance<double>(kBits), steps);
  return profile.best_value() + side * (below + above) / 2 * error;
}

}  // namespace

statistics::Interval profile_interval(std::span<const LifeDatum> data, const LifeFit& fit,
                                      LifeQuantity quantity, double confidence) {
  const LogTensionFrame frame = frame_of(data);
  const Participation participation(data, fit.form);
  const LifeDesign design = design_of(data, fit.form, frame, participation);
  const Quantity wanted(quantity, frame);
  const ProfileLikelihood profile(design, wanted, design_coefficients(fit, frame, participation));

  const double root =
      std::sqrt(boost::math::quantile(boost::math::chi_squared_distribution<>(1), confidence));
  const statistics::Interval interval{.low = end_of(profile, root, -1),
                                      .high = end_of(profile, root, 1)};
  if (quantity.kind == LifeQuantity::Kind::shape) {
    return {.low = std::exp(interval.low), .high = std::exp(interval.high)};
  }
  return interval;
}

double pivot_tension_N(std::span<const LifeDatum> data, const LifeFit& fit) {
  const LogTensionFrame frame = frame_of(data);
  const Participation participation(data, fit.form);
  Expansion expansion;
  expand_log_likelihood(design_of(data, fit.form, frame, participation),
                        design_coefficients(fit, frame, participation), expansion);
  const Eigen::Matrix3d covariance = Eigen::Matrix3d(-expansion.hessian).inverse();
  // ln alpha(x) = a - g x has no covariance with g where cov(a, g) = x var(g).
  return std::exp(frame.centre + frame.spread * covariance(0, 1) / covariance(1, 1));
}

statistics::Interval exp_of(statistics::Interval of_ln) {
  return {std::exp(of_ln.low), std::exp(of_ln.high)};
}

}  // namespace host_sim::life_law
