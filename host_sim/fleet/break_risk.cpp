#include "host_sim/fleet/break_risk.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "lifemodel/life/conditional.hpp"
#include "lifemodel/pack/pack.hpp"

namespace host_sim::fleet {

double distance_from_pivot(const LawBelief& law, const Tendon& tendon) {
  return tendon.effective_tension_N ? std::log(*tendon.effective_tension_N / law.pivot_tension_N)
                                    : 0.0;
}

std::vector<NormalPoint> normal_points(double step, int reach, double sd) {
  if (sd == 0) {
    return {{}};
  }
  std::vector<NormalPoint> points;
  double sum = 0;
  for (int i = -reach; i <= reach; ++i) {
    const double z = i * step;
    points.push_back({z, std::exp(-0.5 * z * z)});
    sum += points.back().weight;
  }
  for (NormalPoint& point : points) {
    point.weight /= sum;
  }
  return points;
}

std::vector<NormalPoint> rate_factors(double log_sd) {
  std::vector<NormalPoint> factors = normal_points(1, 4, log_sd);
  double mean = 0;
  for (NormalPoint& factor : factors) {
    factor.z = std::exp(log_sd * factor.z);
    mean += factor.weight * factor.z;
  }
  for (NormalPoint& factor : factors) {
    factor.z /= mean;
  }
  return factors;
}

double hazard_growth(double used, double further, double shape) {
  if (further >= used) {
    return std::pow(used + further, shape) - std::pow(used, shape);
  }
  return std::pow(used, shape) * std::expm1(shape * std::log1p(further / used));
}

BreakRisk::BreakRisk(const LawBelief& law, const Tendon& tendon)
    : used_(tendon.damage),
      damage_per_h_(tendon.damage_per_h),
      fitted_shape_(law.shape),
      rates_(rate_factors(tendon.rate_log_sd)) {
  const double log_life_sd =
      std::hypot(law.log_life_sd, law.exponent_sd * distance_from_pivot(law, tendon));
  const std::vector<NormalPoint> lives = normal_points(0.75, 7, log_life_sd);
  double least_hazard = std::numeric_limits<double>::infinity();
  for (const NormalPoint& point : normal_points(1, 4, law.log_shape_sd)) {
    Shape shape{law.shape * std::exp(law.log_shape_sd * point.z), {}};
    for (const NormalPoint& life : lives) {
      const double share = point.weight * life.weight;
      shape.laws.push_back({std::exp(-shape.shape * log_life_sd * life.z), share, share});
      least_hazard =
          std::min(least_hazard, std::pow(used_, shape.shape) * shape.laws.back().rate_of_hazard);
    }
    shapes_.push_back(std::move(shape));
  }
  // Survival relative to that of the strongest law, which may itself be below any number.
  double sum = 0;
  for (Shape& shape : shapes_) {
    const double hazard = std::pow(used_, shape.shape);
    for (Law& each : shape.laws) {
      each.weight *= std::exp(least_hazard - hazard * each.rate_of_hazard);
      sum += each.weight;
    }
  }
  for (Shape& shape : shapes_) {
    for (Law& each : shape.laws) {
      each.weight /= sum;
    }
  }
}

double BreakRisk::within(double hours) const {
  return of_further(damage_per_h_ * hours, &Law::weight);
}

double BreakRisk::within_of_all_laws(double hours) const {
  return of_further(damage_per_h_ * hours, &Law::share);
}

double BreakRisk::of_further(double damage, double Law::*weight) const {
  double risk = 0;
  for (const Shape& shape : shapes_) {
    for (const NormalPoint& rate : rates_) {
      const double growth = hazard_growth(used_, damage * rate.z, shape.shape);
      double given_rate = 0;
      for (const Law& law : shape.laws) {
        given_rate -= law.*weight * std::expm1(-growth * law.rate_of_hazard);
      }
      risk += rate.weight * given_rate;
    }
  }
  return std::min(risk, 1.0);
}

double BreakRisk::within_at_fit(double hours) const {
  return lifemodel::pack::to_double(lifemodel::break_risk(
      lifemodel::pack::from_double<lifemodel::WeibullShape>(fitted_shape_),
      lifemodel::pack::damage(used_), lifemodel::pack::damage(damage_per_h_ * hours)));
}

double BreakRisk::hours_to(double risk) const {
  if (damage_per_h_ == 0) {
    return std::numeric_limits<double>::infinity();
  }
  // In ln of the further damage, from where the fitted law has this risk: hours at a rate that is
  // next to none are more than a number holds.
  const double hazard = std::pow(used_, fitted_shape_) - std::log1p(-risk);
  const double further = std::pow(hazard, 1 / fitted_shape_) - used_;
  const double least = 1e-12 * std::max(used_, 1e-6);
  double low = std::log(std::max(further, least));
  double high = low;
  const auto excess = [&](double log_further) {
    return of_further(std::exp(log_further), &Law::weight) - risk;
  };
  constexpr double kStep = 0.25;
  double at_low = excess(low);
  double at_high = at_low;
  while (at_low > 0) {
    low -= kStep * (1 + high - low);
    at_low = excess(low);
  }
  while (at_high < 0) {
    high += kStep * (1 + high - low);
    at_high = excess(high);
  }
  if (at_low == 0 || at_high == 0) {
    return std::exp(at_low == 0 ? low : high) / damage_per_h_;
  }
  constexpr int kBits = 32;
  std::uintmax_t most = 100;
  const auto [below, above] = boost::math::tools::toms748_solve(
      excess, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(kBits), most);
  return std::exp(0.5 * (below + above)) / damage_per_h_;
}

}  // namespace host_sim::fleet
