#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::diagnose {

inline Eigen::Map<const Eigen::VectorXd> vector_of(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// By how much fewer samples residuals count that go on from one to the next, 1 or more.
double inflation_of(const Eigen::VectorXd& residuals);

/// How residuals of the input force covary: noise of each sample that grows with the force and with
/// how fast it changes, and within a session what gain and friction coefficient do that scatter
/// between sessions.
class ForceCovariance {
 public:
  /// The same noise everywhere and no scatter.
  ForceCovariance() = default;

  /// @param directions_N dT_in/d ln gain and dT_in/d mu of each record, 0 where a sample does not
  ///   count
  /// @param residuals_N of the best model so far, by record, 0 where a sample does not count
  /// @param friction_coefficient that a tenth of is the most that scatters
  /// @param with_timing whether samples may have been read sooner or later than their time
  ForceCovariance(std::span<const effects::ForceRecord> records,
                  std::span<const Eigen::MatrixX2d> directions_N,
                  const std::vector<std::vector<double>>& residuals_N, double friction_coefficient,
                  bool with_timing);

  /// The same noise from here on, and no scatter.
  void forget_scatter();

  /// a' W b of the samples of one record; W is the inverse of the covariance, and in the mean over
  /// all samples 1 where nothing scatters.
  [[nodiscard]] Eigen::MatrixXd product(std::size_t record,
                                        const Eigen::Ref<const Eigen::MatrixXd>& a,
                                        const Eigen::Ref<const Eigen::MatrixXd>& b) const;

  /// What is left of the residuals of one record without what its gain and friction most likely do.
  [[nodiscard]] Eigen::VectorXd beside_scatter(
      std::size_t record, const Eigen::Ref<const Eigen::VectorXd>& residuals_N) const;

  /// ln gain and friction coefficient that suit one record, beside those of a model.
  struct Refit {
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  };
  /// @param residuals_N that the model leaves
  [[nodiscard]] Refit refit(std::size_t record,
                            const Eigen::Ref<const Eigen::VectorXd>& residuals_N) const;

  /// What those leave.
  [[nodiscard]] Eigen::VectorXd beside_refit(
      std::size_t record, const Eigen::Ref<const Eigen::VectorXd>& residuals_N) const;

  /// ln of how likely it is that a model leaves such gain and friction to sessions, whatever their
  /// mean and however much of them is scatter.
  [[nodiscard]] double log_likelihood_of(std::span<const Refit> refits) const;

  /// Of one record, the sum of squares of what a unit of ln gain and of friction does to the input
  /// force, by the weight of samples.
  [[nodiscard]] Eigen::Array2d squares(std::size_t record) const;

  /// Standard deviations of ln gain and friction of which any more has a cause.
  [[nodiscard]] const Eigen::Array2d& most_scatter() const { return most_scatter_; }

  /// How much a sample of a record says beside others, by its noise: 1 in the mean over all.
  [[nodiscard]] double weight(std::size_t record, std::size_t sample) const {
    return weights_.empty() ? 1 : weights_[record](static_cast<Eigen::Index>(sample));
  }

  /// The sum of squares by these weights.
  [[nodiscard]] double weighted_square(std::size_t record,
                                       const Eigen::Ref<const Eigen::VectorXd>& residuals_N) const;

  /// Standard deviations of ln gain and friction between sessions.
  [[nodiscard]] Eigen::Array2d scatter() const { return {log_gain_sd_, friction_sd_}; }
  [[nodiscard]] double log_gain_sd() const { return log_gain_sd_; }
  [[nodiscard]] double friction_sd() const { return friction_sd_; }

 private:
  /// dT_in/d ln gain and dT_in/d mu.
  [[nodiscard]] Eigen::MatrixX2d directions_N(std::size_t record) const;

  std::vector<Eigen::VectorXd> weights_;
  std::vector<Eigen::MatrixX2d> along_N_;  ///< dT_in/d ln gain and dT_in/d mu, times the weights
  std::vector<Eigen::Matrix2d> shrinks_;
  Eigen::Array2d most_scatter_ = Eigen::Array2d::Zero();
  double log_gain_sd_ = 0;
  double friction_sd_ = 0;
};

}  // namespace host_sim::diagnose
