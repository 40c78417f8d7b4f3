#include "host_sim/statistics/normal_tail.hpp"

#include <cmath>
#include <numbers>

namespace host_sim::statistics {
namespace {

constexpr double kSqrt2 = std::numbers::sqrt2;
const double kHalfLogTwoPi = 0.5 * std::log(2 * std::numbers::pi);

/// From here on erfc loses digits or underflows, and the continued fraction is short.
constexpr double kFarTail = 10;

/// Laplace's continued fraction z + 1/(z + 2/(z + 3/(z + ...))), Abramowitz and Stegun 26.2.14.
double far_hazard(double z) {
  constexpr int kTerms = 30;
  double fraction = z;
  for (int k = kTerms; k >= 1; --k) {
    fraction = z + k / fraction;
  }
  return fraction;
}

}  // namespace

double log_normal_density(double z) {
  return -0.5 * z * z - kHalfLogTwoPi;
}

double log_normal_survival(double z) {
  if (z >= kFarTail) {
    return log_normal_density(z) - std::log(far_hazard(z));
  }
  if (z < 0) {
    return std::log1p(-0.5 * std::erfc(-z / kSqrt2));
  }
  return std::log(0.5 * std::erfc(z / kSqrt2));
}

double normal_hazard(double z) {
  if (z >= kFarTail) {
    return far_hazard(z);
  }
  return 2 * std::exp(log_normal_density(z)) / std::erfc(z / kSqrt2);
}

}  // namespace host_sim::statistics
