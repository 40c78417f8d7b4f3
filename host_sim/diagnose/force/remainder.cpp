#include "host_sim/diagnose/force/remainder.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "host_sim/diagnose/force/session_drift.hpp"
#include "host_sim/diagnose/force/structure.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::diagnose {
namespace {

constexpr std::size_t kBins = CovariateBins::kCount;

/// Of what is left, from where on it shows as structure: noise of the output force and of the
/// velocity alone leave up to 0.4 % that is the same in all sessions. The force of one tendon
/// changes less beside its noise, and where that is correlated from sample to sample by 0.9 it
/// is 1.3 %.
constexpr double kLeastRemainder = 0.005;
constexpr double kLeastRemainderAlone = 0.02;
/// The chance of what repeats, which eight sessions can show: of 2^8 ways to turn them over, two.
constexpr double kRareRepeat = 0.01;
/// That of what goes with sessions.
constexpr double kRareTrend = SessionScatter::kRare;

constexpr double kLeastMemory = 0.05;
constexpr double kLeastOfBursts = 0.12;

/// What goes on in each session, other than in the others: of three ways, the one that chance shows
/// least, and the chance of any.
struct Course {
  double correlation = 0;
  double p = 1;
  bool stands = false;
};

Course course_of(const ForceData& data, const std::vector<std::vector<double>>& residuals_N) {
  struct Way {
    Memory memory;
    double least;
  };
  std::vector<Way> ways{{memory_of(data, residuals_N, MemoryOf::force), kLeastMemory},
                        {memory_of(data, residuals_N, MemoryOf::friction), kLeastMemory}};
  // Of forces that come near zero, noise goes down with them by itself.
  if (data.records().front().pulls_alone) {
    ways.push_back({memory_of(data, residuals_N, MemoryOf::size), kLeastOfBursts});
  }
  const Way& rarest =
      *std::ranges::min_element(ways, {}, [](const Way& way) { return way.memory.p; });
  return {rarest.memory.correlation, std::min(1.0, 3 * rarest.memory.p),
          std::ranges::any_of(ways, [](const Way& way) {
            return way.memory.correlation >= way.least && way.memory.p < kRareTrend;
          })};
}

/// Gain and friction that suit each session beside a model, against a covariate of sessions.
class SessionTrend {
 public:
  /// @param sessions standardized gain and friction of each
  SessionTrend(const ForceCovariate& covariate, const Eigen::MatrixX2d& sessions)
      : values_(sessions.rowwise() - sessions.colwise().mean()) {
    const Eigen::Index count = sessions.rows();
    Eigen::VectorXd place(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      place(j) = effects::mean_of(covariate.values[static_cast<std::size_t>(j)]);
    }
    place = (place.array() - place.mean()) / std::max(place.cwiseAbs().maxCoeff(), 1e-300);
    add(place);
    add(place.cwiseAbs2());
    values_.colwise().normalize();
  }

  /// As many sessions as the parabola explains of one of both.
  /// @param order of the sessions
  [[nodiscard]] double statistic(const std::vector<Eigen::Index>& order) const {
    constexpr Eigen::Index kFewSessions = 8;
    if (values_.rows() < kFewSessions) {
      return 0;
    }
    const Eigen::MatrixX2d moved = values_(order, Eigen::all);
    return (parabola_.transpose() * moved).colwise().squaredNorm().maxCoeff() *
           static_cast<double>(values_.rows());
  }

 private:
  /// Beside the mean and the columns before it.
  void add(Eigen::VectorXd column) {
    constexpr double kSame = 1e-6;
    const double before = column.norm();
    column.array() -= column.mean();
    column -= parabola_ * (parabola_.transpose() * column);
    if (column.norm() > kSame * before) {
      parabola_.conservativeResize(column.size(), parabola_.cols() + 1);
      parabola_.rightCols<1>() = column.normalized();
    }
  }

  Eigen::MatrixX2d values_;
  Eigen::MatrixXd parabola_ = Eigen::MatrixXd(values_.rows(), 0);
};

/// What one model leaves against each covariate.
class CovariateTest {
 public:
  CovariateTest(const ForceData& data, const std::vector<std::vector<double>>& all_N,
                const std::vector<ForceCovariate>& covariates,
                const std::vector<CovariateBins>& bins)
      : residuals_N_(beside_scatter_N(data, all_N)), covariates_(covariates) {
    const Eigen::MatrixX2d sessions =
        standardized(refits_of(data, all_N), data.covariance().scatter());
    drift_ = drift_of_either(sessions);
    means_.reserve(covariates.size());
    trends_.reserve(covariates.size());
    for (std::size_t i = 0; i < covariates.size(); ++i) {
      means_.emplace_back(data, bins[i], residuals_N_, ForceCovariance());
      trends_.emplace_back(covariates[i], sessions);
    }
  }

  /// @param draws how often sessions are turned over and change places at random; few sessions are
  ///   turned over in each of all ways, of which there are fewer
  void run(int draws, std::uint64_t seed) {
    const std::size_t sessions = residuals_N_.size();
    std::vector<double> signs(sessions, 1);
    std::vector<Eigen::Index> order(sessions);
    std::iota(order.begin(), order.end(), Eigen::Index{0});
    statistics_ = of(signs, order);
    // All turned over together are as they were: the last one stays.
    constexpr std::size_t kMostWays = 9;
    const bool all_ways = sessions <= kMostWays;
    const int ways = all_ways ? (1 << (sessions - 1)) - 1 : draws;
    std::vector<int> as_large(statistics_.size(), 1);
    for (int draw = 0; draw < draws; ++draw) {
      constexpr std::uint64_t kStream = 41;
      statistics::Random random(seed, kStream, static_cast<std::uint64_t>(draw));
      for (std::size_t j = 0; j < sessions; ++j) {
        const bool turned = all_ways ? (((draw + 1) >> j) & 1) != 0 : random.uniform() < 0.5;
        signs[j] = turned ? -1 : 1;
      }
      for (std::size_t j = sessions; j > 1; --j) {
        const auto other = static_cast<std::size_t>(random.uniform() * static_cast<double>(j));
        std::swap(order[j - 1], order[std::min(other, j - 1)]);
      }
      const std::vector<double> drawn = of(signs, order);
      const double repeats = draw < ways ? largest(drawn, false) : -1;
      const double moves = largest(drawn, true);
      for (std::size_t i = 0; i < as_large.size(); ++i) {
        as_large[i] += (covariates_[i].of_sessions ? moves : repeats) >= statistics_[i] ? 1 : 0;
      }
    }
    for (std::size_t i = 0; i < as_large.size(); ++i) {
      p_.push_back(static_cast<double>(as_large[i]) /
                   ((covariates_[i].of_sessions ? draws : ways) + 1));
    }
  }

  [[nodiscard]] const std::vector<double>& statistics() const { return statistics_; }
  /// That chance leaves as much against any of the covariates of its kind.
  [[nodiscard]] const std::vector<double>& p() const { return p_; }

  [[nodiscard]] const BinMeans& means(std::size_t covariate) const { return means_[covariate]; }
  [[nodiscard]] const std::vector<std::vector<double>>& residuals_N() const { return residuals_N_; }

  [[nodiscard]] const SessionDrift& drift() const { return drift_; }

  /// The place of the one that chance shows least.
  [[nodiscard]] std::size_t most() const {
    std::size_t most = 0;
    for (std::size_t i = 1; i < p_.size(); ++i) {
      if (std::pair(-p_[i], statistics_[i]) > std::pair(-p_[most], statistics_[most])) {
        most = i;
      }
    }
    return most;
  }

 private:
  [[nodiscard]] std::vector<double> of(const std::vector<double>& signs,
                                       const std::vector<Eigen::Index>& order) const {
    std::vector<double> all;
    all.reserve(means_.size());
    for (std::size_t i = 0; i < means_.size(); ++i) {
      all.push_back(covariates_[i].of_sessions ? trends_[i].statistic(order)
                                               : means_[i].statistic(signs));
    }
    return all;
  }

  /// The largest of all that repeats, or of all of sessions.
  [[nodiscard]] double largest(const std::vector<double>& statistics, bool of_sessions) const {
    double largest = 0;
    for (std::size_t i = 0; i < statistics.size(); ++i) {
      largest =
          covariates_[i].of_sessions == of_sessions ? std::max(largest, statistics[i]) : largest;
    }
    return largest;
  }

  std::vector<std::vector<double>> residuals_N_;
  SessionDrift drift_;
  const std::vector<ForceCovariate>& covariates_;
  std::vector<BinMeans> means_;
  std::vector<SessionTrend> trends_;
  std::vector<double> statistics_;
  std::vector<double> p_;
};

/// What both models leave, as the test sees it.
std::vector<RemainderPicture> pictures_of(const ForceCovariate& covariate,
                                          const CovariateBins& bins, const BinMeans& before,
                                          const BinMeans& after) {
  std::vector<RemainderPicture> pictures;
  for (const std::size_t back : {0U, 1U}) {
    RemainderPicture picture{std::string(covariate.name),
                             std::string(covariate.unit),
                             back == 0 ? 1 : -1,
                             {},
                             {},
                             {},
                             {},
                             {}};
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      const std::vector<double> before_N = before.of_sessions(2 * bin + back);
      const std::vector<double> after_N = after.of_sessions(2 * bin + back);
      if (before_N.size() < 2) {
        continue;
      }
      picture.centre.push_back(bins.centres[bin]);
      const Spread was = spread_of(before_N);
      const Spread is = spread_of(after_N);
      picture.before_N.push_back(was.mean_N);
      picture.before_sd_N.push_back(was.sd_N);
      picture.after_N.push_back(is.mean_N);
      picture.after_sd_N.push_back(is.sd_N);
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

/// Places of the covariate that shows most, and of those that the nominal model leaves most against
/// or the model does, as far as chance does not.
std::vector<std::size_t> pictured(const std::vector<double>& before_p,
                                  const std::vector<double>& after_p, std::size_t most) {
  constexpr std::size_t kMost = 3;
  std::vector<std::size_t> others;
  const auto p = [&](std::size_t i) { return std::min(before_p[i], after_p[i]); };
  for (std::size_t i = 0; i < before_p.size(); ++i) {
    if (i != most && p(i) < kRareRepeat) {
      others.push_back(i);
    }
  }
  std::ranges::stable_sort(others, {}, p);
  others.insert(others.begin(), most);
  others.resize(std::min(others.size(), kMost));
  return others;
}

double mean_square(const ForceData& data, const std::vector<std::vector<double>>& residuals_N) {
  double square_N2 = 0;
  for (const std::vector<double>& of_record : residuals_N) {
    square_N2 += vector_of(of_record).squaredNorm();
  }
  return square_N2 / data.samples();
}

}  // namespace

ForceRemainder remainder_of(const ForceData& data, const ForceFit& nominal, const ForceFit& model,
                            const std::vector<ForceCovariate>& covariates,
                            const std::vector<CovariateBins>& bins, std::uint64_t seed) {
  constexpr int kDraws = 999;
  const std::vector<std::vector<double>> nominal_N = data.residuals_N(nominal);
  const std::vector<std::vector<double>> model_N = data.residuals_N(model);
  CovariateTest before(data, nominal_N, covariates, bins);
  CovariateTest after(data, model_N, covariates, bins);
  before.run(kDraws, seed);
  after.run(kDraws, seed);
  const std::size_t most = after.most();
  ForceRemainder remainder;
  remainder.covariate = covariates[most].name;
  remainder.p = after.p()[most];
  double repeated_N2 = 0;
  double repeats_p = 1;
  double moves_p = 1;
  for (std::size_t i = 0; i < covariates.size(); ++i) {
    remainder.discrepancies.push_back(
        {std::string(covariates[i].name), before.statistics()[i], before.p()[i], after.p()[i]});
    double& least_p = covariates[i].of_sessions ? moves_p : repeats_p;
    least_p = std::min(least_p, after.p()[i]);
    if (!covariates[i].of_sessions) {
      repeated_N2 = std::max(repeated_N2, after.means(i).square_N2());
    }
  }
  remainder.share = repeated_N2 / std::max(mean_square(data, after.residuals_N()), 1e-300);
  const SessionScatter scatter = session_scatter_of(data, model_N);
  if (scatter.p < remainder.p) {
    remainder.covariate = kSession;
    remainder.p = scatter.p;
  }
  remainder.discrepancies.push_back(
      {std::string(kSession), scatter.statistic, session_scatter_of(data, nominal_N).p, scatter.p});
  const SessionDrift& drift = after.drift();
  if (drift.p < std::min(remainder.p, kRareTrend)) {
    remainder.covariate = kOfSessions;
    remainder.p = drift.p;
  }
  remainder.discrepancies.push_back(
      {std::string(kOfSessions), drift.ratio, before.drift().p, drift.p});
  const Course course = course_of(data, after.residuals_N());
  if (course.stands && course.p < remainder.p) {
    remainder.covariate = kOfTime;
    remainder.p = course.p;
  }
  remainder.discrepancies.push_back({std::string(kOfTime), course.correlation,
                                     course_of(data, before.residuals_N()).p, course.p});
  const double least = data.records().front().pulls_alone ? kLeastRemainderAlone : kLeastRemainder;
  remainder.stands = (repeats_p < kRareRepeat && remainder.share >= least) ||
                     moves_p < kRareTrend || scatter.p < SessionScatter::kRare ||
                     drift.p < kRareTrend || course.stands;
  for (const std::size_t i : pictured(before.p(), after.p(), most)) {
    std::ranges::move(pictures_of(covariates[i], bins[i], before.means(i), after.means(i)),
                      std::back_inserter(remainder.pictures));
  }
  return remainder;
}

}  // namespace host_sim::diagnose
