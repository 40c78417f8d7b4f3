#include "tests/plan/theory.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>

#include "tests/support/algebra.hpp"

namespace host_sim::plan::testing {
namespace {

/// Information of one specimen in (ln alpha, ln beta), with z = (t / alpha)^beta up to `limit`.
Eigen::Matrix2d information(double shape, double limit) {
  constexpr double kAllFailed = 50;
  const double end = std::min(limit, kAllFailed);
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const auto expected = [&](auto integrand) {
    return quadrature.integrate([&](double z) { return integrand(z) * std::exp(-z); }, 0.0, end);
  };
  const auto score_shape = [](double z) { return 1 + (1 - z) * std::log(z); };
  const double survive = std::exp(-end);
  const double at_end = end * std::log(end);
  Eigen::Matrix2d result;
  result(0, 0) =
      shape * shape * (expected([](double z) { return (1 - z) * (1 - z); }) + end * end * survive);
  result(1, 1) = expected([&](double z) { return score_shape(z) * score_shape(z); }) +
                 at_end * at_end * survive;
  result(0, 1) = -shape * (expected([&](double z) { return (1 - z) * score_shape(z); }) +
                           end * at_end * survive);
  result(1, 0) = result(0, 1);
  return result;
}

}  // namespace

double standard_error_of_ln_b10(const Design& design, const LifeLaw& law, double use_tension_N) {
  Eigen::Matrix3d total = Eigen::Matrix3d::Zero();
  for (const PlannedLevel& level : design.levels) {
    const double limit = std::pow(
        design.suspend_at_cycles / law.characteristic_life(level.effective_tension_N), law.shape);
    Eigen::Matrix<double, 2, 3> gradient;
    gradient << 1, -std::log(level.effective_tension_N), 0, 0, 0, 1;
    total += static_cast<double>(level.specimens) * gradient.transpose() *
             information(law.shape, limit) * gradient;
  }
  const double ln_hazard = std::log(-std::log(0.9));
  const Eigen::Vector3d to_b10(1, -std::log(use_tension_N), -ln_hazard / law.shape);
  return std::sqrt(to_b10.dot(total.inverse() * to_b10));
}

double power_to_see_bend(const Design& design, const LifeLaw& law,
                         const std::vector<double>& bend) {
  const auto levels = static_cast<Eigen::Index>(design.levels.size());
  Eigen::MatrixXd line(levels, 2);
  Eigen::VectorXd change(levels);
  for (Eigen::Index i = 0; i < levels; ++i) {
    const PlannedLevel& level = design.levels[static_cast<std::size_t>(i)];
    const double root = std::sqrt(static_cast<double>(level.specimens));
    line.row(i) << root, root * std::log(level.effective_tension_N);
    change(i) = root * bend[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd left = algebra::left_by(line, change);
  const double critical = boost::math::quantile(boost::math::chi_squared(1), 0.95);
  const boost::math::non_central_chi_squared bent(1, law.shape * law.shape * left.squaredNorm());
  return boost::math::cdf(boost::math::complement(bent, critical));
}

Design paper_design(std::size_t specimens_of_level, double suspend_at_cycles) {
  Design design{{}, suspend_at_cycles};
  for (const double tension_N : {42.5, 50.7, 60.0, 70.8}) {
    design.levels.push_back({tension_N, specimens_of_level});
  }
  return design;
}

}  // namespace host_sim::plan::testing
