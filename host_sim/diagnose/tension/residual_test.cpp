#include "host_sim/diagnose/tension/residual_test.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

#include "host_sim/diagnose/tension/scatter_score.hpp"
#include "host_sim/statistics/parallel.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::diagnose {
namespace {

/// Draws X'y of campaigns of the same design that hold noise and scatter of sessions alone. The
/// coefficients of a model stay zero: what is refitted does not change what is left.
class NullCampaigns {
 public:
  /// @param grams must outlive this
  explicit NullCampaigns(const Grams& grams);

  [[nodiscard]] Products draw(const NoiseModel& noise, statistics::Random& random) const;

 private:
  /// What the columns of a session make of white noise of unit size.
  struct SessionNoise {
    Eigen::Matrix2d common_root;     ///< of the products with gain and friction
    Eigen::MatrixXd rest_of_common;  ///< the others' expected products, by those
  };

  const Grams& grams_;
  std::vector<SessionNoise> sessions_;
  Eigen::MatrixXd rest_root_;  ///< of the others' products beside that, of all sessions
};

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

double normal_draw(statistics::Random& random) {
  return boost::math::quantile(boost::math::normal_distribution<double>(), random.uniform());
}

VectorXd normal_draws(statistics::Random& random, Index count) {
  VectorXd draws(count);
  for (Index i = 0; i < count; ++i) {
    draws(i) = normal_draw(random);
  }
  return draws;
}

/// A root R of a symmetric matrix R R' whose least eigenvalues may be 0.
MatrixXd root_of(const MatrixXd& matrix) {
  const Eigen::LDLT<MatrixXd> ldlt(matrix);
  const VectorXd diagonal = ldlt.vectorD().cwiseMax(0).cwiseSqrt();
  return ldlt.transpositionsP().transpose() *
         MatrixXd(MatrixXd(ldlt.matrixL()) * diagonal.asDiagonal());
}

NullCampaigns::NullCampaigns(const Grams& grams) : grams_(grams) {
  const Index size = grams.response();
  MatrixXd rest = MatrixXd::Zero(size - 2, size - 2);
  for (const SessionGram& session : grams.sessions) {
    const Eigen::Matrix2d common = session.gram.topLeftCorner<2, 2>();
    const auto across = session.gram.block(2, 0, size - 2, 2);
    const MatrixXd inverse = pseudo_inverse(common, common.diagonal());
    sessions_.push_back({root_of(common), across * inverse});
    rest += session.gram.block(2, 2, size - 2, size - 2) - across * inverse * across.transpose();
  }
  rest_root_ = root_of(rest);
}

Products NullCampaigns::draw(const NoiseModel& noise, statistics::Random& random) const {
  Products products;
  const Index size = grams_.response();
  products.total = VectorXd::Zero(size);
  products.total.tail(size - 2) =
      noise.sample_sd * (rest_root_ * normal_draws(random, rest_root_.cols()));
  for (std::size_t i = 0; i < sessions_.size(); ++i) {
    const Eigen::Vector2d scatter(noise.session_gain_sd * normal_draw(random),
                                  noise.session_friction_sd * normal_draw(random));
    const Eigen::Vector2d common =
        noise.sample_sd * (sessions_[i].common_root * normal_draws(random, 2));
    const VectorXd by_scatter = grams_.sessions[i].gram.topLeftCorner(size, 2) * scatter;
    products.common.push_back(common + by_scatter.head<2>());
    products.total += by_scatter;
    products.total.head<2>() += common;
    products.total.tail(size - 2) += sessions_[i].rest_of_common * common;
  }
  return products;
}

constexpr std::size_t kDraws = 999;
constexpr std::uint64_t kStream = 0x70726f6265;

/// Wilson and Hilferty: a chi-square as a standard normal.
double normal_score(double chi_square, double freedom) {
  if (freedom <= 0) {
    return 0;
  }
  const double ninth = 2 / (9 * freedom);
  return (std::cbrt(std::max(chi_square, 0.0) / freedom) - (1 - ninth)) / std::sqrt(ninth);
}

std::vector<double> scores_of(const ScatterScore& at, const std::vector<double>& statistics) {
  std::vector<double> scores;
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    scores.push_back(normal_score(statistics[i], at.freedom(i)));
  }
  return scores;
}

Products measured_products(const Grams& grams) {
  const Eigen::Index response = grams.response();
  Products measured{.common = {}, .total = Eigen::VectorXd::Zero(response)};
  for (const SessionGram& session : grams.sessions) {
    measured.common.push_back(session.gram.col(response).head<2>());
    measured.total += session.gram.col(response).head(response);
  }
  return measured;
}

/// The highest score of any probe in each of the campaigns simulated.
std::vector<double> highest_scores(const Grams& grams, const PossibleScatter& scatter,
                                   const std::vector<double>& deviances, std::uint64_t seed,
                                   unsigned threads) {
  const NullCampaigns campaigns(grams);
  std::vector<double> highest(kDraws);
  statistics::parallel_for(
      kDraws,
      [&](std::size_t draw) {
        statistics::Random random(seed, kStream, draw);
        const NoiseModel& noise = scatter.drawn(deviances, random.uniform()).noise();
        const Products products = campaigns.draw(noise, random);
        const ScatterScore& best = scatter.best(products);
        highest[draw] = std::ranges::max(scores_of(best, best.statistics(grams, products)));
      },
      threads);
  return highest;
}

}  // namespace

ResidualTest test_residual(const Grams& grams, double sample_sd, std::uint64_t seed,
                           unsigned threads) {
  if (grams.layout.probes.empty()) {
    return {};
  }
  const auto refitted = static_cast<Eigen::Index>(grams.layout.probes.front().first);
  const Products measured = measured_products(grams);
  const PossibleScatter scatter(grams, sample_sd, refitted, measured);
  const ScatterScore& best = scatter.best(measured);
  const std::vector<double> statistics = best.statistics(grams, measured);
  const std::vector<double> scores = scores_of(best, statistics);
  const std::vector<double> highest =
      highest_scores(grams, scatter, scatter.deviances(measured), seed, threads);
  ResidualTest test;
  test.explained = best.explained(grams, measured);
  const NoiseModel most = scatter_values().back();
  test.scatter_beyond = best.noise().session_gain_sd >= most.session_gain_sd ||
                        best.noise().session_friction_sd >= most.session_friction_sd;
  double top = -HUGE_VAL;
  for (std::size_t i = 0; i < statistics.size(); ++i) {
    const auto above = static_cast<double>(
        std::ranges::count_if(highest, [&](double value) { return value >= scores[i]; }));
    const double p = (1 + above) / (1 + static_cast<double>(kDraws));
    test.probes.push_back({grams.layout.probes[i].probe.of, statistics[i], best.freedom(i), p});
    if (scores[i] > top) {
      top = scores[i];
      test.p = p;
      test.excess = statistics[i] - best.freedom(i);
    }
  }
  return test;
}

ResidualTest ResidualTests::of(const Evidence& evidence, std::span<const Component> model) {
  GramOptions options = evidence.options;
  options.wanted = wanted_of(model);
  options.probes = probes_;
  Grams grams = gram_of(evidence.sessions, options, before_ ? &*before_ : nullptr);
  ResidualTest test = test_residual(grams, evidence.sample_sd, seed_, evidence.options.threads);
  if (!before_) {
    before_ = std::move(grams);
  }
  return test;
}

}  // namespace host_sim::diagnose
