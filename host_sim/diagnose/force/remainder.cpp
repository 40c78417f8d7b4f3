#include "host_sim/diagnose/force/remainder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "host_sim/recording/signal.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim::diagnose {
namespace {

std::vector<double> travel_of(const ForceRecord& record) {
  std::vector<double> travel_m(record.samples());
  double since_m = record.samples() == 0 ? 0 : record.position_m.front();
  for (std::size_t i = 1; i < record.samples(); ++i) {
    if (record.velocity_m_s[i] * record.velocity_m_s[i - 1] <= 0) {
      since_m = record.position_m[i];
    }
    travel_m[i] = std::abs(record.position_m[i] - since_m);
  }
  return travel_m;
}

/// By a cubic over some samples to each side.
std::vector<double> acceleration_of(const ForceRecord& record) {
  const recording::Stretch whole{0, record.samples()};
  const double duration_s = record.samples() < 2 ? 0 : record.time_s.back() - record.time_s.front();
  constexpr double kSamples = 4;
  const double reach_s = kSamples * duration_s / static_cast<double>(record.samples());
  std::vector<double> acceleration_m_s2(record.samples());
  for (std::size_t i = 0; i < record.samples(); ++i) {
    recording::LocalFit fit;
    if (recording::fit_locally(record.time_s, record.velocity_m_s, whole, i, reach_s, fit)) {
      acceleration_m_s2[i] = fit.slope_1_s;
    }
  }
  return acceleration_m_s2;
}

std::vector<double> since_start(std::vector<double> time_s) {
  const double start_s = time_s.front();
  for (double& value_s : time_s) {
    value_s -= start_s;
  }
  return time_s;
}

std::vector<double> sizes_of(std::vector<double> values) {
  for (double& value : values) {
    value = std::abs(value);
  }
  return values;
}

}  // namespace

std::vector<ForceCovariate> force_covariates(const std::vector<ForceRecord>& records) {
  std::vector<ForceCovariate> all{{"output tension", "N", {}},
                                  {"position", "m", {}},
                                  {"speed", "m/s", {}},
                                  {"travel", "m", {}},
                                  {"rate of tension", "N/s", {}},
                                  {"acceleration", "m/s2", {}},
                                  {"time", "s", {}}};
  for (const ForceRecord& record : records) {
    all[0].values.push_back(sizes_of(record.output_N));
    all[1].values.push_back(record.position_m);
    all[2].values.push_back(sizes_of(record.velocity_m_s));
    all[3].values.push_back(travel_of(record));
    all[4].values.push_back(record.output_rate_N_s);
    all[5].values.push_back(acceleration_of(record));
    all[6].values.push_back(since_start(record.time_s));
  }
  return all;
}

namespace {

constexpr std::size_t kBins = RemainderBins::kCount;

struct Spread {
  double mean_N = 0;
  double sd_N = 0;
};

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

/// Mean residual of each session in each bin, by weight; absent where a session has few samples
/// there. Samples count where the direction of friction is settled: as the motion turns over, noise
/// of the velocity leaves what is the same in all sessions too.
class BinMeans {
 public:
  /// @param noise whose weights samples have
  BinMeans(const ForceData& data, const RemainderBins& bins,
           const std::vector<std::vector<double>>& residuals_N, const ForceCovariance& noise)
      : means_N_(data.records().size()) {
    const std::vector<ForceRecord>& records = data.records();
    constexpr double kTurnsOver = 2;
    const double settled_m_s = kTurnsOver * data.scales().turn_over_m_s;
    for (std::size_t j = 0; j < records.size(); ++j) {
      std::array<double, 2 * kBins> sums{};
      std::array<double, 2 * kBins> weights{};
      std::array<std::size_t, 2 * kBins> counts{};
      for (std::size_t i = 0; i < records[j].samples(); ++i) {
        if (records[j].used[i] && std::abs(records[j].velocity_m_s[i]) > settled_m_s) {
          const double weight = noise.weight(j, i);
          sums[bins.places[j][i]] += weight * residuals_N[j][i];
          weights[bins.places[j][i]] += weight;
          ++counts[bins.places[j][i]];
        }
      }
      for (std::size_t bin = 0; bin < 2 * kBins; ++bin) {
        weights_[bin] += weights[bin];
        constexpr std::size_t kFew = 3;
        means_N_[j][bin] =
            counts[bin] < kFew ? std::nullopt : std::optional(sums[bin] / weights[bin]);
      }
    }
  }

  /// How far the means are from zero against their scatter between sessions, all bins together.
  [[nodiscard]] double statistic(const std::vector<double>& signs) const {
    double sum = 0;
    double bins = 0;
    for (std::size_t bin = 0; bin < 2 * kBins; ++bin) {
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

  /// Square of the means over sessions, less what chance puts there, in the mean over all samples
  /// by weight.
  [[nodiscard]] double square_N2() const {
    double sum_N2 = 0;
    double weights = 0;
    for (std::size_t bin = 0; bin < 2 * kBins; ++bin) {
      const std::vector<double> means_N = of_sessions(bin);
      if (means_N.size() < kFewSessions) {
        continue;
      }
      const Spread spread = spread_of(means_N);
      const double chance_N2 = spread.sd_N * spread.sd_N / static_cast<double>(means_N.size());
      sum_N2 += weights_[bin] * (spread.mean_N * spread.mean_N - chance_N2);
      weights += weights_[bin];
    }
    return weights > 0 ? std::max(sum_N2 / weights, 0.0) : 0;
  }

  /// Of one bin, those that there are.
  [[nodiscard]] std::vector<double> of_sessions(std::size_t bin) const {
    std::vector<double> all;
    for (const auto& session : means_N_) {
      if (session[bin]) {
        all.push_back(*session[bin]);
      }
    }
    return all;
  }

 private:
  static constexpr std::size_t kFewSessions = 4;

  std::vector<std::array<std::optional<double>, 2 * kBins>> means_N_;
  std::array<double, 2 * kBins> weights_{};  ///< of samples that count, of all sessions
};

/// Mean square of what repeats, over the covariate that shows most of it.
double most_repeated(const std::vector<BinMeans>& means) {
  double most_N2 = 0;
  for (const BinMeans& one : means) {
    most_N2 = std::max(most_N2, one.square_N2());
  }
  return most_N2;
}

std::vector<std::vector<double>> beside_scatter_N(const ForceData& data,
                                                  std::vector<std::vector<double>> residuals_N) {
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    const Eigen::VectorXd left_N = data.covariance().beside_scatter(j, vector_of(residuals_N[j]));
    residuals_N[j].assign(left_N.begin(), left_N.end());
  }
  return residuals_N;
}

/// Samples in an eighth of the mean time between reversals, which are those of 5 % of the stroke.
std::size_t part_of_stroke(const ForceRecord& record, double stroke_m) {
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

/// Mean product of residuals that are so far apart, less twice what chance puts there by its
/// scatter between sessions.
double going_on(const ForceData& data, const std::vector<std::vector<double>>& residuals_N) {
  constexpr double kChance = 2;
  std::vector<double> of_sessions;
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    const ForceRecord& record = data.records()[j];
    const std::size_t later = part_of_stroke(record, data.scales().stroke_m);
    double sum_N2 = 0;
    double count = 0;
    for (std::size_t i = 0; i + later < record.samples(); ++i) {
      if (record.used[i] && record.used[i + later]) {
        sum_N2 +=
            std::sqrt(data.covariance().weight(j, i) * data.covariance().weight(j, i + later)) *
            residuals_N[j][i] * residuals_N[j][i + later];
        ++count;
      }
    }
    if (count > 0) {
      of_sessions.push_back(sum_N2 / count);
    }
  }
  if (of_sessions.size() < 2) {
    return 0;
  }
  const Spread spread = spread_of(of_sessions);
  const double error_N2 = spread.sd_N / std::sqrt(static_cast<double>(of_sessions.size()));
  return std::max(spread.mean_N - kChance * error_N2, 0.0);
}

/// What both models leave, as the test sees it.
std::vector<RemainderPicture> pictures_of(const ForceCovariate& covariate,
                                          const RemainderBins& bins, const BinMeans& before,
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

double mean_square(const ForceData& data, const std::vector<std::vector<double>>& residuals_N) {
  double square_N2 = 0;
  for (const std::vector<double>& of_record : residuals_N) {
    square_N2 += vector_of(of_record).squaredNorm();
  }
  return square_N2 / data.samples();
}

}  // namespace

RemainderBins::RemainderBins(const std::vector<ForceRecord>& records,
                             const ForceCovariate& covariate) {
  std::vector<double> sorted;
  for (const auto& values : covariate.values) {
    sorted.insert(sorted.end(), values.begin(), values.end());
  }
  std::ranges::sort(sorted);
  for (std::size_t bin = 0; bin < kCount; ++bin) {
    centres.push_back(sorted[(2 * bin + 1) * sorted.size() / (2 * kCount)]);
  }
  for (std::size_t j = 0; j < records.size(); ++j) {
    std::vector<std::size_t>& of_record = places.emplace_back();
    for (std::size_t i = 0; i < records[j].samples(); ++i) {
      const auto below = std::ranges::lower_bound(sorted, covariate.values[j][i]) - sorted.begin();
      const std::size_t bin =
          std::min(static_cast<std::size_t>(below) * kCount / sorted.size(), kCount - 1);
      of_record.push_back(2 * bin + (records[j].velocity_m_s[i] < 0 ? 1 : 0));
    }
  }
}

Structure structure_of(const ForceData& data, const std::vector<RemainderBins>& bins,
                       const ForceFit& model) {
  const std::vector<std::vector<double>> all_N = data.residuals_N(model);
  const std::vector<std::vector<double>> beside_N = beside_scatter_N(data, all_N);
  std::vector<BinMeans> beside;
  std::vector<BinMeans> all;
  beside.reserve(bins.size());
  all.reserve(bins.size());
  for (const RemainderBins& of_covariate : bins) {
    beside.emplace_back(data, of_covariate, beside_N, data.covariance());
    all.emplace_back(data, of_covariate, all_N, data.covariance());
  }
  return {.repeats_N2 = most_repeated(all),
          .beside_scatter_N2 = std::max(most_repeated(beside), going_on(data, beside_N))};
}

ForceRemainder remainder_of(const ForceData& data, const ForceFit& nominal, const ForceFit& model,
                            const std::vector<ForceCovariate>& covariates,
                            const std::vector<RemainderBins>& bins, std::uint64_t seed) {
  constexpr int kDraws = 999;
  const std::vector<std::vector<double>> residuals_N =
      beside_scatter_N(data, data.residuals_N(model));
  std::vector<BinMeans> means;
  means.reserve(bins.size());
  for (const RemainderBins& of_covariate : bins) {
    means.emplace_back(data, of_covariate, residuals_N, ForceCovariance());
  }
  std::vector<double> signs(data.records().size(), 1);
  std::size_t most = 0;
  double largest = 0;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const double statistic = means[i].statistic(signs);
    if (statistic > largest) {
      largest = statistic;
      most = i;
    }
  }
  int as_large = 1;
  for (int draw = 0; draw < kDraws; ++draw) {
    constexpr std::uint64_t kStream = 41;
    statistics::Random random(seed, kStream, static_cast<std::uint64_t>(draw));
    for (double& sign : signs) {
      sign = random.uniform() < 0.5 ? -1 : 1;
    }
    as_large += std::ranges::any_of(
        means, [&](const BinMeans& one) { return one.statistic(signs) >= largest; });
  }
  const BinMeans before(data, bins[most], beside_scatter_N(data, data.residuals_N(nominal)),
                        ForceCovariance());
  return {covariates[most].name, static_cast<double>(as_large) / (kDraws + 1),
          most_repeated(means) / std::max(mean_square(data, residuals_N), 1e-300),
          pictures_of(covariates[most], bins[most], before, means[most])};
}

}  // namespace host_sim::diagnose
