#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host_sim/life_law/coefficients.hpp"
#include "host_sim/life_law/life_design.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/life_law/profile_likelihood.hpp"

namespace host_sim::life_law {
namespace {

/// The value on one side of the best one at which the root of twice the loss is `wanted`.
double end_of(const ProfileLikelihood& profile, double wanted, double side) {
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

statistics::Interval exp_of(statistics::Interval of_ln) {
  return {std::exp(of_ln.low), std::exp(of_ln.high)};
}

}  // namespace host_sim::life_law
