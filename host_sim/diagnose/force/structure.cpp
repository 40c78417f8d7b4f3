#include "host_sim/diagnose/force/structure.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

namespace host_sim::diagnose {
namespace {

constexpr std::size_t kFewSessions = 4;

/// Mean square of what repeats, over the covariate that shows most of it.
double most_repeated(const std::vector<BinMeans>& means) {
  double most_N2 = 0;
  for (const BinMeans& one : means) {
    most_N2 = std::max(most_N2, one.square_N2());
  }
  return most_N2;
}

/// Samples in an eighth of the mean time between reversals, which are those of 5 % of the stroke.
std::size_t part_of_stroke(const effects::ForceRecord& record, double stroke_m) {
  constexpr double kReversal = 0.05;
  constexpr std::size_t kPart = 8;
  std::size_t strokes = 1;
  double turned_m = record.position_m.front();
  double way = 0;
  for (const double position_m : record.position_m) {
    const double moved_m = position_m - turned_m;
    if (way == 0 || moved_m * way > 0) {
      turned_m = position_m;
      way = way == 0 && std::abs(moved_m) > 0 ? moved_m : way;
    } else if (std::abs(moved_m) > kReversal * stroke_m) {
      turned_m = position_m;
      way = moved_m;
      ++strokes;
    }
  }
  return std::max<std::size_t>(record.samples() / (kPart * strokes), 1);
}

/// Residuals of a session, each by its weight.
std::vector<double> weighted_N(const ForceData& data, std::size_t session,
                               const std::vector<double>& residuals_N) {
  std::vector<double> values_N = residuals_N;
  for (std::size_t i = 0; i < values_N.size(); ++i) {
    values_N[i] *= std::sqrt(data.covariance().weight(session, i));
  }
  return values_N;
}

/// Sums over pairs of samples.
struct Pairs {
  double products = 0;
  double squares = 0;        ///< of the first of each
  double later_squares = 0;  ///< of the other
  std::size_t count = 0;

  void add(double value, double later_value) {
    products += value * later_value;
    squares += value * value;
    later_squares += later_value * later_value;
    ++count;
  }

  [[nodiscard]] double correlation() const { return products / std::sqrt(squares * later_squares); }
};

/// Below which speed the direction of friction is not settled.
double settled_m_s(const ForceData& data) {
  constexpr double kTurnsOver = 2;
  return kTurnsOver * data.scales().turn_over_m_s;
}

/// Samples that count where friction turns over neither there nor at the ones beside them, nor has
/// done just before.
std::vector<bool> between_reversals(const ForceData& data, const effects::ForceRecord& record) {
  constexpr double kSettled = 3;  // of how late it follows: 1.7 % of a step are left
  const double settled_m_s = diagnose::settled_m_s(data);
  const double settled_s = kSettled * data.scales().forces_late_s;
  const auto goes = [&](std::size_t i, double way) {
    return way * record.velocity_m_s[i] > settled_m_s;
  };
  std::vector<bool> between(record.samples());
  for (std::size_t i = 1; i + 1 < between.size(); ++i) {
    const double way = record.velocity_m_s[i] < 0 ? -1 : 1;
    between[i] = record.used[i] && goes(i - 1, way) && goes(i, way) && goes(i + 1, way);
    for (std::size_t k = i; k-- > 0 && record.time_s[i] - record.time_s[k] < settled_s;) {
      between[i] = between[i] && goes(k, way);
    }
  }
  return between;
}

/// Squares of residuals over what noise has at the force of their sample, less 1. That is learned
/// from samples between reversals alone, where weights have a part of those.
std::vector<double> sizes_of(const effects::ForceRecord& record,
                             const std::vector<double>& residuals_N,
                             const std::vector<bool>& between) {
  constexpr double kMost = 9;  // heavy tails say little
  constexpr int kSizeRounds = 3;
  std::vector<double> of_force_N2(residuals_N.size());
  double mean_N2 = 0;
  double count = 0;
  for (std::size_t i = 0; i < residuals_N.size(); ++i) {
    of_force_N2[i] = std::pow(record.input_N[i] - residuals_N[i], 2);
    mean_N2 += between[i] ? residuals_N[i] * residuals_N[i] : 0;
    count += between[i] ? 1 : 0;
  }
  mean_N2 = std::max(mean_N2 / std::max(count, 1.0), 1e-30);
  const auto noise_N2 = [&](const Eigen::Vector2d& parts, std::size_t i) {
    constexpr double kLeast = 0.02;
    return std::max(parts(0) + parts(1) * of_force_N2[i], kLeast * mean_N2);
  };
  Eigen::Vector2d parts(mean_N2, 0);
  for (int round = 0; round < kSizeRounds; ++round) {
    Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
    Eigen::Vector2d product = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < residuals_N.size(); ++i) {
      if (between[i]) {
        const Eigen::Vector2d row = Eigen::Vector2d(1, of_force_N2[i]) / noise_N2(parts, i);
        square += row * row.transpose();
        product += row * (residuals_N[i] * residuals_N[i] / noise_N2(parts, i));
      }
    }
    square.diagonal() *= 1 + 1e-9;  // of a force that stays the parts are one
    parts = square.ldlt().solve(product);
  }
  std::vector<double> sizes(residuals_N.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    sizes[i] = std::min(residuals_N[i] * residuals_N[i] / noise_N2(parts, i), kMost) - 1;
  }
  return sizes;
}

/// After a second noise of sensors is forgotten, and after a quarter its size: of first order, with
/// a coefficient of 0.95 at 100 Hz, a correlation of 0.006 is left, and of its squares 0.08.
constexpr double kForgotten_s = 1;
constexpr double kBurst_s = 0.25;

/// Of a session those that MemoryOf asks for.
Pairs pairs_apart(const ForceData& data, std::size_t session,
                  const std::vector<double>& residuals_N, MemoryOf what) {
  constexpr double kLater = 1.4;  // so that what oscillates is as often alike as not
  const effects::ForceRecord& record = data.records()[session];
  const std::vector<bool> between = between_reversals(data, record);
  const std::vector<double> values = what == MemoryOf::size
                                         ? sizes_of(record, residuals_N, between)
                                         : weighted_N(data, session, residuals_N);
  const double first_s = what == MemoryOf::force ? kForgotten_s : kBurst_s;
  const double last_s = (what == MemoryOf::friction ? 3 : kLater) * first_s;
  const auto samples_in = [&](double time_s) {
    return static_cast<std::size_t>(std::lround(time_s / record.step_s()));
  };
  Pairs pairs;
  for (std::size_t later = samples_in(first_s); later <= samples_in(last_s); ++later) {
    for (std::size_t i = 0; i + later < values.size(); ++i) {
      const bool opposite = record.velocity_m_s[i] * record.velocity_m_s[i + later] < 0;
      if (between[i] && between[i + later] && (opposite || what != MemoryOf::friction)) {
        pairs.add(values[i], values[i + later]);
      }
    }
  }
  return pairs;
}

/// Residuals of one session by weight, and how far apart they are asked to be alike.
struct GoingOn {
  const effects::ForceRecord* record;
  std::vector<double> values_N;
  std::size_t later;  ///< samples in an eighth of the time between reversals

  [[nodiscard]] double later_s() const { return static_cast<double>(later) * record->step_s(); }

  /// Mean product of those that lie some samples apart; none where there are none.
  [[nodiscard]] std::optional<double> product_N2(std::size_t apart) const {
    Pairs pairs;
    for (std::size_t i = 0; i + apart < values_N.size(); ++i) {
      if (record->used[i] && record->used[i + apart]) {
        pairs.add(values_N[i], values_N[i + apart]);
      }
    }
    return pairs.count > 0 ? std::optional(pairs.products / static_cast<double>(pairs.count))
                           : std::nullopt;
  }
};

/// What noise remembers for so long: sessions that turn slowly have it, too, and no more later.
/// @param slow that go on for the longest
double remembered_N2(const std::vector<GoingOn>& slow, double later_s) {
  double sum_N2 = 0;
  double count = 0;
  for (const GoingOn& one : slow) {
    const auto apart = static_cast<std::size_t>(std::lround(later_s / one.record->step_s()));
    if (apart < one.later) {
      const auto soon_N2 = one.product_N2(apart);
      const auto later_N2 = one.product_N2(one.later);
      if (soon_N2 && later_N2) {
        sum_N2 += *soon_N2 - *later_N2;
        ++count;
      }
    }
  }
  return count > 0 ? std::max(sum_N2 / count, 0.0) : 0;
}

/// Mean product of residuals that are so far apart, without what noise remembers, less twice what
/// chance puts there by its scatter between sessions.
double going_on(const ForceData& data, const std::vector<std::vector<double>>& residuals_N) {
  constexpr double kChance = 2;
  constexpr std::size_t kSlow = 4;  ///< a quarter of sessions
  std::vector<GoingOn> all;
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    const effects::ForceRecord& record = data.records()[j];
    all.push_back({&record, weighted_N(data, j, residuals_N[j]),
                   part_of_stroke(record, data.scales().stroke_m)});
  }
  std::ranges::sort(all, std::greater<>(), &GoingOn::later_s);
  const std::vector<GoingOn> slow(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::max(
                                     all.size() / kSlow, std::min(kFewSessions, all.size()))));
  std::vector<double> of_sessions;
  for (const GoingOn& one : all) {
    if (const auto product_N2 = one.product_N2(one.later)) {
      of_sessions.push_back(*product_N2 - remembered_N2(slow, one.later_s()));
    }
  }
  if (of_sessions.size() < 2) {
    return 0;
  }
  const Spread spread = spread_of(of_sessions);
  const double error_N2 = spread.sd_N / std::sqrt(static_cast<double>(of_sessions.size()));
  return std::max(spread.mean_N - kChance * error_N2, 0.0);
}

}  // namespace

/// @pre two values or more
Spread spread_of(const std::vector<double>& values_N) {
  const auto count = static_cast<double>(values_N.size());
  const double mean_N = std::accumulate(values_N.begin(), values_N.end(), 0.0) / count;
  double square_N2 = 0;
  for (const double value_N : values_N) {
    square_N2 += (value_N - mean_N) * (value_N - mean_N);
  }
  return {mean_N, std::sqrt(square_N2 / (count - 1))};
}

BinMeans::BinMeans(const ForceData& data, const CovariateBins& bins,
                   const std::vector<std::vector<double>>& residuals_N,
                   const ForceCovariance& noise)
    : means_N_(data.records().size()) {
  const std::vector<effects::ForceRecord>& records = data.records();
  const double least_m_s = settled_m_s(data);
  for (std::size_t j = 0; j < records.size(); ++j) {
    std::array<double, kBins> sums{};
    std::array<double, kBins> weights{};
    std::array<std::size_t, kBins> counts{};
    for (std::size_t i = 0; i < records[j].samples(); ++i) {
      if (records[j].used[i] && std::abs(records[j].velocity_m_s[i]) > least_m_s) {
        const double weight = noise.weight(j, i);
        sums[bins.places[j][i]] += weight * residuals_N[j][i];
        weights[bins.places[j][i]] += weight;
        ++counts[bins.places[j][i]];
      }
    }
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      weights_[bin] += weights[bin];
      constexpr std::size_t kFew = 3;
      means_N_[j][bin] =
          counts[bin] < kFew ? std::nullopt : std::optional(sums[bin] / weights[bin]);
    }
  }
}

double BinMeans::statistic(const std::vector<double>& signs) const {
  double sum = 0;
  double bins = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    double count = 0;
    double mean = 0;
    double square = 0;
    for (std::size_t j = 0; j < means_N_.size(); ++j) {
      if (means_N_[j][bin]) {
        const double value = signs[j] * *means_N_[j][bin];
        ++count;
        mean += value;
        square += value * value;
      }
    }
    if (count >= kFewSessions && square > 0) {
      sum += mean * mean / square;
      ++bins;
    }
  }
  return bins > 0 ? sum / bins : 0;
}

double BinMeans::square_N2() const {
  constexpr double kChance = 2;  // standard errors
  double sum_N2 = 0;
  double variance_N4 = 0;
  double weights = 0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const std::vector<double> means_N = of_sessions(bin);
    if (means_N.size() < kFewSessions) {
      continue;
    }
    const Spread spread = spread_of(means_N);
    const double chance_N2 = spread.sd_N * spread.sd_N / static_cast<double>(means_N.size());
    sum_N2 += weights_[bin] * (spread.mean_N * spread.mean_N - chance_N2);
    variance_N4 += 2 * std::pow(weights_[bin] * chance_N2, 2);
    weights += weights_[bin];
  }
  sum_N2 -= kChance * std::sqrt(variance_N4);
  return weights > 0 ? std::max(sum_N2 / weights, 0.0) : 0;
}

std::vector<double> BinMeans::of_sessions(std::size_t bin) const {
  std::vector<double> all;
  for (const auto& session : means_N_) {
    if (session[bin]) {
      all.push_back(*session[bin]);
    }
  }
  return all;
}

std::vector<std::vector<double>> beside_scatter_N(const ForceData& data,
                                                  std::vector<std::vector<double>> residuals_N) {
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    const Eigen::VectorXd left_N = data.covariance().beside_scatter(j, vector_of(residuals_N[j]));
    residuals_N[j].assign(left_N.begin(), left_N.end());
  }
  return residuals_N;
}

std::vector<ForceCovariance::Refit> refits_of(const ForceData& data,
                                              const std::vector<std::vector<double>>& residuals_N) {
  std::vector<ForceCovariance::Refit> all;
  all.reserve(residuals_N.size());
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    all.push_back(data.covariance().refit(j, vector_of(residuals_N[j])));
  }
  return all;
}

namespace {

/// Mean square by weight that gain and friction of each session take off.
double taken_by_refits_N2(const ForceData& data,
                          const std::vector<std::vector<double>>& residuals_N) {
  const ForceCovariance& covariance = data.covariance();
  double taken_N2 = 0;
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    const auto all_N = vector_of(residuals_N[j]);
    taken_N2 += covariance.weighted_square(j, all_N) -
                covariance.weighted_square(j, covariance.beside_refit(j, all_N));
  }
  return taken_N2 / data.samples();
}

}  // namespace

SessionScatter session_scatter_of(const ForceData& data,
                                  const std::vector<std::vector<double>>& residuals_N) {
  const std::vector<ForceCovariance::Refit> refits = refits_of(data, residuals_N);
  const auto sessions = static_cast<double>(refits.size());
  const Eigen::Array2d most = data.covariance().most_scatter();
  if (sessions < 2 || !(most > 0).all()) {
    return {};
  }
  const boost::math::chi_squared chance(sessions - 1);
  SessionScatter scatter;
  for (Eigen::Index k = 0; k < 2; ++k) {
    const auto weight_of = [&](const ForceCovariance::Refit& refit) {
      return 1 / (most[k] * most[k] + refit.covariance(k, k));
    };
    double weights = 0;
    double sum = 0;
    double squares_N2 = 0;
    for (std::size_t j = 0; j < refits.size(); ++j) {
      weights += weight_of(refits[j]);
      sum += weight_of(refits[j]) * refits[j].value(k);
      squares_N2 += data.covariance().squares(j)[k];
    }
    double statistic = 0;
    for (const ForceCovariance::Refit& refit : refits) {
      statistic += weight_of(refit) * std::pow(refit.value(k) - sum / weights, 2);
    }
    const double p =
        std::min(1.0, 2 * boost::math::cdf(boost::math::complement(chance, statistic)));
    scatter.statistic = std::max(scatter.statistic, statistic);
    scatter.p = std::min(scatter.p, p);
    if (p < SessionScatter::kRare) {
      scatter.beyond_N2 +=
          (statistic / (sessions - 1) - 1) * most[k] * most[k] * squares_N2 / data.samples();
    }
  }
  // Gain and friction that stand for each other move far where they take little off.
  if (scatter.beyond_N2 > 0) {
    scatter.beyond_N2 = std::min(scatter.beyond_N2, taken_by_refits_N2(data, residuals_N));
  }
  return scatter;
}

Memory memory_of(const ForceData& data, const std::vector<std::vector<double>>& residuals_N,
                 MemoryOf what) {
  constexpr std::size_t kFewSamples = 20;
  std::vector<double> correlations;
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    if (data.covariance().weighted_square(j, vector_of(residuals_N[j])) <= 0) {
      continue;
    }
    const Pairs pairs = pairs_apart(data, j, residuals_N[j], what);
    if (pairs.count >= kFewSamples && pairs.squares > 0 && pairs.later_squares > 0) {
      correlations.push_back(what == MemoryOf::friction ? -pairs.correlation()
                                                        : pairs.correlation());
    }
  }
  const auto sessions = static_cast<double>(correlations.size());
  if (correlations.size() < kFewSessions) {
    return {};
  }
  const Spread spread = spread_of(correlations);
  const boost::math::students_t chance(sessions - 1);
  const double t = spread.mean_N / std::max(spread.sd_N, 1e-300) * std::sqrt(sessions);
  return {spread.mean_N, boost::math::cdf(boost::math::complement(chance, t))};
}

Structure structure_of(const ForceData& data, const std::vector<CovariateBins>& bins,
                       const ForceFit& model) {
  const std::vector<std::vector<double>> all_N = data.residuals_N(model);
  const std::vector<std::vector<double>> beside_N = beside_scatter_N(data, all_N);
  std::vector<BinMeans> beside;
  std::vector<BinMeans> all;
  beside.reserve(bins.size());
  all.reserve(bins.size());
  for (const CovariateBins& of_covariate : bins) {
    if (of_covariate.of_sessions) {
      continue;
    }
    beside.emplace_back(data, of_covariate, beside_N, data.covariance());
    all.emplace_back(data, of_covariate, all_N, data.covariance());
  }
  const double beyond_N2 = session_scatter_of(data, all_N).beyond_N2;
  return {
      .of_sessions_N2 = beyond_N2,
      .repeats_N2 = most_repeated(all) + beyond_N2,
      .beside_scatter_N2 = std::max(most_repeated(beside), going_on(data, beside_N)) + beyond_N2};
}

}  // namespace host_sim::diagnose
