#include "host_sim/life_law/quantity.hpp"

#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/trigamma.hpp>
#include <cmath>

namespace host_sim::life_law {
namespace {

using Kind = LifeQuantity::Kind;

Eigen::Vector3d linear_part(const LifeQuantity& wanted, const LogTensionFrame& frame) {
  switch (wanted.kind) {
    case Kind::exponent:
      return {0, 1 / frame.spread, 0};
    case Kind::shape:
      return {0, 0, 1};
    case Kind::ln_scale:
      return {1, -frame.x(1), 0};
    case Kind::ln_mean_life:
    case Kind::ln_quantile:
      break;
  }
  return {1, -frame.x(wanted.effective_tension_N), 0};
}

Eigen::Index dependent_of(Kind kind) {
  switch (kind) {
    case Kind::exponent:
      return 1;
    case Kind::shape:
      return 2;
    case Kind::ln_scale:
    case Kind::ln_mean_life:
    case Kind::ln_quantile:
      break;
  }
  return 0;
}

}  // namespace

Quantity::Quantity(const LifeQuantity& wanted, const LogTensionFrame& frame)
    : kind_(wanted.kind),
      p_(wanted.p),
      linear_(linear_part(wanted, frame)),
      dependent_(dependent_of(wanted.kind)) {}

Quantity::Part Quantity::part(double ln_shape) const {
  const double sigma = std::exp(-ln_shape);
  if (kind_ == Kind::ln_quantile) {
    const double term = std::log(-std::log1p(-p_)) * sigma;
    return {.value = term, .first = -term, .second = term};
  }
  if (kind_ == Kind::ln_mean_life) {
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

}  // namespace host_sim::life_law
