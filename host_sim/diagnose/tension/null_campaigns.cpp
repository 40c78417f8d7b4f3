#include "host_sim/diagnose/tension/null_campaigns.hpp"

#include <Eigen/Cholesky>
#include <boost/math/distributions/normal.hpp>

namespace host_sim::diagnose {
namespace {

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

}  // namespace

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

}  // namespace host_sim::diagnose
