#include "host_sim/diagnose/force/force_covariance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace host_sim::diagnose {
namespace {

/// What scatters more has a cause: standard deviation of ln gain, and of friction over itself.
constexpr double kMostLogGain = 0.03;
constexpr double kMostFriction = 0.1;

/// Gain and friction that one session has beside the model, how surely, and what they leave.
struct RefitOfSession {
  ForceCovariance::Refit of;
  Eigen::VectorXd left_N;
  double inflation = 1;
};

RefitOfSession refit_of(const Eigen::MatrixX2d& directions_N, const Eigen::VectorXd& weights,
                        const Eigen::VectorXd& residuals_N) {
  constexpr double kRidge = 1e-9;
  const Eigen::MatrixX2d weighted_N = weights.asDiagonal() * directions_N;
  Eigen::Matrix2d square = weighted_N.transpose() * directions_N;
  square.diagonal() *= 1 + kRidge;
  square.diagonal().array() += 1e-30;
  const Eigen::Matrix2d inverse = square.inverse();
  RefitOfSession refit;
  refit.of.value = inverse * (weighted_N.transpose() * residuals_N);
  refit.left_N = residuals_N - directions_N * refit.of.value;
  refit.inflation = inflation_of(refit.left_N);
  const double noise_N2 = (weights.array() * refit.left_N.array().square()).mean();
  refit.of.covariance = inverse * noise_N2 * refit.inflation;
  return refit;
}

/// How fast the input force of a model changes at each sample, 0 where that is no matter.
struct Rates {
  std::vector<double> timing_N_s;  ///< where it may have been read sooner or later than its time
  std::vector<double> turn_N_s;    ///< where friction turns over between it and the next to it
};

/// Variance of the noise of a sample: absolute, in proportion to the output force, and of when it
/// was read, in proportion to how fast the input force changes. Where friction turns over it does
/// so as filters and micrometres of presliding have it, which samples do not show: that is a noise
/// of its own.
class NoiseVariance {
 public:
  static constexpr int kParts = 4;
  using Parts = Eigen::Matrix<double, kParts, 1>;
  using Square = Eigen::Matrix<double, kParts, kParts>;

  explicit NoiseVariance(double absolute_N2) { parts_(0) = absolute_N2; }

  /// What the parts of the variance of a sample go with.
  static Parts row_of(double output_N, double timing_N_s, double turn_N_s) {
    return {1, output_N * output_N, timing_N_s * timing_N_s, turn_N_s * turn_N_s};
  }

  [[nodiscard]] double at_N2(const Parts& row) const { return parts_.dot(row); }

  /// By weighted least squares; a part that would be negative is left out of it.
  /// @param most of each part
  void solve(Square square, Parts product, const Parts& least, const Parts& most) {
    square.diagonal() *= 1 + 1e-12;
    for (int round = 0; round < kParts; ++round) {
      parts_ = square.ldlt().solve(product);
      for (int k = 1; k < kParts; ++k) {
        if (!(parts_(k) > 0)) {
          square.row(k).setZero();
          square.col(k).setZero();
          square(k, k) = 1;
          product(k) = 0;
        }
      }
    }
    parts_ = parts_.cwiseMax(least).cwiseMin(most);
  }

 private:
  Parts parts_ = Parts::Zero();
};

/// As the force turns over faster than the samples follow each other, the rate is the larger one of
/// the two sides.
Rates rates_of(const effects::ForceRecord& record, const std::vector<double>& residuals_N,
               bool with_timing) {
  std::vector<double> rates(record.samples());
  for (std::size_t i = 1; i < rates.size(); ++i) {
    const double step_N =
        record.input_N[i] - residuals_N[i] - (record.input_N[i - 1] - residuals_N[i - 1]);
    const bool both = record.used[i] && record.used[i - 1];
    const double rate_N_s = both ? std::abs(step_N) / (record.time_s[i] - record.time_s[i - 1]) : 0;
    rates[i - 1] = std::max(rates[i - 1], rate_N_s);
    rates[i] = rate_N_s;
  }
  const std::vector<bool> turns = effects::next_to_turns(record);
  Rates all{std::vector<double>(rates.size()), std::vector<double>(rates.size())};
  for (std::size_t i = 0; i < rates.size(); ++i) {
    all.timing_N_s[i] = with_timing ? rates[i] : 0;
    all.turn_N_s[i] = turns[i] ? rates[i] : 0;
  }
  return all;
}

/// Of squares by weighted least squares, each by its own variance.
NoiseVariance noise_of(std::span<const effects::ForceRecord> records,
                       const std::vector<RefitOfSession>& refits, const std::vector<Rates>& rates) {
  constexpr int kRounds = 8;
  constexpr double kLeastShare = 0.01;  // of all variance: some noise has no sample
  constexpr double kMostOfStep = 0.5;   // what is read later than that is late, and no noise
  double all_N2 = 0;
  double samples = 0;
  double step_s = 0;
  for (std::size_t j = 0; j < records.size(); ++j) {
    all_N2 += refits[j].left_N.squaredNorm();
    samples += static_cast<double>(std::ranges::count(records[j].used, true));
    step_s = std::max(step_s, (records[j].time_s.back() - records[j].time_s.front()) /
                                  static_cast<double>(records[j].samples()));
  }
  all_N2 = std::max(all_N2 / std::max(samples, 1.0), 1e-30);
  const NoiseVariance::Parts least(kLeastShare * all_N2, 0, 0, 0);
  const NoiseVariance::Parts most(all_N2, HUGE_VAL, std::pow(kMostOfStep * step_s, 2), HUGE_VAL);
  NoiseVariance noise(all_N2);
  for (int round = 0; round < kRounds; ++round) {
    NoiseVariance::Square square = NoiseVariance::Square::Zero();
    NoiseVariance::Parts product = NoiseVariance::Parts::Zero();
    for (std::size_t j = 0; j < records.size(); ++j) {
      for (std::size_t i = 0; i < records[j].samples(); ++i) {
        if (records[j].used[i]) {
          const NoiseVariance::Parts row = NoiseVariance::row_of(
              records[j].output_N[i], rates[j].timing_N_s[i], rates[j].turn_N_s[i]);
          const double left_N = refits[j].left_N(static_cast<Eigen::Index>(i));
          const double weight = 1 / std::pow(noise.at_N2(row), 2);
          square += weight * row * row.transpose();
          product += weight * left_N * left_N * row;
        }
      }
    }
    noise.solve(square, product, least, most);
  }
  return noise;
}

}  // namespace

double inflation_of(const Eigen::VectorXd& residuals) {
  constexpr double kMost = 0.98;
  const Eigen::Index count = residuals.size();
  const double square = residuals.squaredNorm();
  if (count < 2 || square == 0) {
    return 1;
  }
  const double correlation =
      std::clamp(residuals.head(count - 1).dot(residuals.tail(count - 1)) / square, 0.0, kMost);
  return (1 + correlation) / (1 - correlation);
}

ForceCovariance::ForceCovariance(std::span<const effects::ForceRecord> records,
                                 std::span<const Eigen::MatrixX2d> directions_N,
                                 const std::vector<std::vector<double>>& residuals_N,
                                 double friction_coefficient, bool with_timing) {
  const auto sessions = static_cast<double>(records.size());
  if (records.size() < 2) {
    return;
  }
  std::vector<RefitOfSession> refits;
  for (std::size_t j = 0; j < records.size(); ++j) {
    refits.push_back(refit_of(directions_N[j], Eigen::VectorXd::Ones(directions_N[j].rows()),
                              vector_of(residuals_N[j])));
  }
  std::vector<Rates> rates;
  for (std::size_t j = 0; j < records.size(); ++j) {
    rates.push_back(rates_of(records[j], residuals_N[j], with_timing));
  }
  const NoiseVariance noise = noise_of(records, refits, rates);
  double sum = 0;
  double samples = 0;
  for (std::size_t j = 0; j < records.size(); ++j) {
    const effects::ForceRecord& record = records[j];
    Eigen::VectorXd& weights = weights_.emplace_back(static_cast<Eigen::Index>(record.samples()));
    for (std::size_t i = 0; i < record.samples(); ++i) {
      weights(static_cast<Eigen::Index>(i)) =
          1 / noise.at_N2(NoiseVariance::row_of(record.output_N[i], rates[j].timing_N_s[i],
                                                rates[j].turn_N_s[i]));
    }
    sum += weights.sum();
    samples += static_cast<double>(record.samples());
  }
  Eigen::Array2d mean = Eigen::Array2d::Zero();
  double noise_N2 = 0;
  for (std::size_t j = 0; j < records.size(); ++j) {
    weights_[j] *= samples / sum;
    refits[j] = refit_of(directions_N[j], weights_[j], vector_of(residuals_N[j]));
    mean += refits[j].of.value.array() / sessions;
    noise_N2 += (weights_[j].array() * refits[j].left_N.array().square()).sum() *
                refits[j].inflation / samples;
  }
  Eigen::Array2d variance = Eigen::Array2d::Zero();
  for (const RefitOfSession& refit : refits) {
    variance += (refit.of.value.array() - mean).square() / (sessions - 1) -
                refit.of.covariance.diagonal().array() / sessions;
  }
  most_scatter_ = {kMostLogGain, kMostFriction * friction_coefficient};
  variance = variance.max(0).min(most_scatter_.square());
  log_gain_sd_ = std::sqrt(variance[0]);
  friction_sd_ = std::sqrt(variance[1]);
  const Eigen::Matrix2d root = (variance / std::max(noise_N2, 1e-30)).sqrt().matrix().asDiagonal();
  for (std::size_t j = 0; j < records.size(); ++j) {
    along_N_.emplace_back(weights_[j].asDiagonal() * directions_N[j]);
    const Eigen::Matrix2d square = directions_N[j].transpose() * along_N_[j];
    shrinks_.push_back(root * (Eigen::Matrix2d::Identity() + root * square * root).inverse() *
                       root);
  }
}

void ForceCovariance::forget_scatter() {
  std::ranges::fill(shrinks_, Eigen::Matrix2d::Zero());
  log_gain_sd_ = 0;
  friction_sd_ = 0;
}

Eigen::MatrixXd ForceCovariance::product(std::size_t record,
                                         const Eigen::Ref<const Eigen::MatrixXd>& a,
                                         const Eigen::Ref<const Eigen::MatrixXd>& b) const {
  if (record >= shrinks_.size()) {
    return a.transpose() * b;
  }
  const Eigen::MatrixX2d& along_N = along_N_[record];
  return a.transpose() * (weights_[record].asDiagonal() * b) -
         (a.transpose() * along_N) * shrinks_[record] * (along_N.transpose() * b);
}

double ForceCovariance::weighted_square(
    std::size_t record, const Eigen::Ref<const Eigen::VectorXd>& residuals_N) const {
  return weights_.empty() ? residuals_N.squaredNorm()
                          : (weights_[record].array() * residuals_N.array().square()).sum();
}

ForceCovariance::Refit ForceCovariance::refit(
    std::size_t record, const Eigen::Ref<const Eigen::VectorXd>& residuals_N) const {
  return record < along_N_.size() ? refit_of(directions_N(record), weights_[record], residuals_N).of
                                  : Refit{};
}

Eigen::VectorXd ForceCovariance::beside_refit(
    std::size_t record, const Eigen::Ref<const Eigen::VectorXd>& residuals_N) const {
  return record < along_N_.size()
             ? refit_of(directions_N(record), weights_[record], residuals_N).left_N
             : Eigen::VectorXd(residuals_N);
}

Eigen::MatrixX2d ForceCovariance::directions_N(std::size_t record) const {
  return weights_[record].cwiseInverse().asDiagonal() * along_N_[record];
}

double ForceCovariance::log_likelihood_of(std::span<const Refit> refits) const {
  constexpr int kSteps = 17;
  constexpr double kLeast = 0.01;  // of the most; each size between is as likely
  if (!(most_scatter_ > 0).all()) {
    return 0;
  }
  Eigen::Array<double, kSteps, kSteps> of_scatter;
  const auto share = [](Eigen::Index step) {
    return std::pow(kLeast, static_cast<double>(step) / (kSteps - 1));
  };
  for (Eigen::Index i = 0; i < kSteps; ++i) {
    for (Eigen::Index k = 0; k < kSteps; ++k) {
      const Eigen::Array2d variance = (most_scatter_ * Eigen::Array2d(share(i), share(k))).square();
      Eigen::Matrix2d weights = Eigen::Matrix2d::Zero();
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      double log_likelihood = 0;
      for (const Refit& refit : refits) {
        const Eigen::Matrix2d all =
            refit.covariance + Eigen::Matrix2d(variance.matrix().asDiagonal());
        const Eigen::Matrix2d weight = all.inverse();
        weights += weight;
        sum += weight * refit.value;
        log_likelihood -= (refit.value.dot(weight * refit.value) + std::log(all.determinant())) / 2;
      }
      // Their mean is that of the model: any is as likely.
      of_scatter(i, k) =
          log_likelihood + (sum.dot(weights.inverse() * sum) - std::log(weights.determinant())) / 2;
    }
  }
  const double most = of_scatter.maxCoeff();
  return most + std::log((of_scatter - most).exp().mean());
}

Eigen::Array2d ForceCovariance::squares(std::size_t record) const {
  if (record >= along_N_.size()) {
    return Eigen::Array2d::Zero();
  }
  return (weights_[record].cwiseInverse().asDiagonal() * along_N_[record].cwiseAbs2())
      .colwise()
      .sum()
      .transpose()
      .array();
}

Eigen::VectorXd ForceCovariance::beside_scatter(
    std::size_t record, const Eigen::Ref<const Eigen::VectorXd>& residuals_N) const {
  if (record >= shrinks_.size()) {
    return residuals_N;
  }
  const Eigen::MatrixX2d& along_N = along_N_[record];
  const Eigen::Vector2d most_likely = shrinks_[record] * (along_N.transpose() * residuals_N);
  return residuals_N - weights_[record].cwiseInverse().asDiagonal() * (along_N * most_likely);
}

}  // namespace host_sim::diagnose
