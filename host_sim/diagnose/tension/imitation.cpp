#include "host_sim/diagnose/tension/imitation.hpp"

#include <cmath>
#include <cstddef>

#include "host_sim/diagnose/projection.hpp"
#include "host_sim/diagnose/tension/model_fit.hpp"

namespace host_sim::diagnose {
namespace {

/// Products of what a part adds to the residual with itself and with gain and friction.
struct PartProducts {
  Eigen::Matrix2d common = Eigen::Matrix2d::Zero();
  Eigen::Vector2d across = Eigen::Vector2d::Zero();
  double square = 0;

  void add(const Eigen::MatrixXd& columns, const GramLayout::Block& block, const ModelFit& fit) {
    const auto first = static_cast<Eigen::Index>(block.first);
    const auto count = static_cast<Eigen::Index>(block.count);
    const Eigen::VectorXd added =
        columns.middleCols(first, count) * fit.coefficients.segment(first, count);
    const auto both = columns.leftCols<2>();
    common += both.transpose() * both;
    across += both.transpose() * added;
    square += added.squaredNorm();
  }

  [[nodiscard]] double beside_common() const {
    return square - across.dot(inverse_of_products(common) * across);
  }
};

}  // namespace

std::vector<Component> beyond_noise(const Evidence& evidence, const std::vector<Component>& parts) {
  const Fitted by = fitted(evidence, parts);
  std::vector<PartProducts> products(parts.size());
  double of_noise = 0;
  for (const Session& session : evidence.sessions) {
    const recording::Covariates& covariates = session.covariates;
    for (std::size_t i = 0; i < covariates.input_noise.size(); ++i) {
      const double variance = covariates.input_noise[i] + covariates.output_noise[i];
      of_noise += variance * variance;
    }
    const Eigen::MatrixXd columns = columns_of(session, by.grams.layout, by.grams.baseline);
    for (std::size_t part = 0; part < parts.size(); ++part) {
      products[part].add(columns, by.grams.layout.effects[part].blocks.front(), by.fit);
    }
  }
  std::vector<Component> kept;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (products[part].beside_common() >= kTimesVariance * kTimesVariance * of_noise) {
      kept.push_back(parts[part]);
    }
  }
  return kept;
}

}  // namespace host_sim::diagnose
