#include "host_sim/diagnose/force/force_covariates.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "host_sim/recording/signal.hpp"

namespace host_sim::diagnose {
namespace {

std::vector<double> travel_of(const effects::ForceRecord& record) {
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
std::vector<double> acceleration_of(const effects::ForceRecord& record) {
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

/// Adds a covariate of sessions where all have it and they differ by more than `least`.
void add_of_sessions(std::vector<ForceCovariate>& all,
                     const std::vector<effects::ForceRecord>& records, ForceCovariate covariate,
                     std::vector<double> effects::ForceRecord::*values, double least) {
  double low = HUGE_VAL;
  double high = -HUGE_VAL;
  for (const effects::ForceRecord& record : records) {
    if ((record.*values).empty()) {
      return;
    }
    low = std::min(low, effects::mean_of(record.*values));
    high = std::max(high, effects::mean_of(record.*values));
    covariate.values.push_back(record.*values);
  }
  if (high - low > least) {
    all.push_back(std::move(covariate));
  }
}

std::vector<double> smoothed_over_strokes(const effects::ForceRecord& record,
                                          const std::vector<double>& values) {
  constexpr double kToEachSide = 0.25;
  double strokes = 1;
  for (std::size_t i = 1; i < record.samples(); ++i) {
    strokes += record.velocity_m_s[i] * record.velocity_m_s[i - 1] < 0 ? 1 : 0;
  }
  const double stroke_s = (record.time_s.back() - record.time_s.front()) / strokes;
  const recording::Stretch whole{0, record.samples()};
  return recording::smoothed(record.time_s, values, std::span(&whole, 1), kToEachSide * stroke_s);
}

}  // namespace

std::vector<ForceCovariate> force_covariates(const std::vector<effects::ForceRecord>& records) {
  std::vector<ForceCovariate> all{{"output tension", "N", {}, false, true},
                                  {"position", "m", {}, false, false},
                                  {"speed", "m/s", {}, false, false},
                                  {"travel", "m", {}, false, false},
                                  {"rate of tension", "N/s", {}, false, false},
                                  {"acceleration", "m/s2", {}, false, false},
                                  {"time", "s", {}, false, false}};
  for (const effects::ForceRecord& record : records) {
    all[0].values.push_back(sizes_of(record.output_N));
    all[1].values.push_back(record.position_m);
    all[2].values.push_back(sizes_of(record.velocity_m_s));
    all[3].values.push_back(travel_of(record));
    all[4].values.push_back(record.output_rate_N_s);
    all[5].values.push_back(acceleration_of(record));
    all[6].values.push_back(since_start(record.time_s));
  }
  constexpr double kSamePose_rad = 0.02;
  constexpr double kSame_K = 3;
  add_of_sessions(all, records, {"cycle", "1", {}, true, false}, &effects::ForceRecord::cycle, 1);
  add_of_sessions(all, records, {"bend angle", "rad", {}, true, false},
                  &effects::ForceRecord::bend_angle_rad, kSamePose_rad);
  add_of_sessions(all, records, {"sheath temperature", "C", {}, true, false},
                  &effects::ForceRecord::sheath_temperature_C, kSame_K);
  add_of_sessions(all, records, {"winding temperature", "C", {}, true, false},
                  &effects::ForceRecord::winding_temperature_C, kSame_K);
  return all;
}

CovariateBins::CovariateBins(const std::vector<effects::ForceRecord>& records,
                             const ForceCovariate& covariate)
    : of_sessions(covariate.of_sessions) {
  std::vector<std::vector<double>> smooth;
  if (covariate.noisy) {
    for (std::size_t j = 0; j < records.size(); ++j) {
      smooth.push_back(smoothed_over_strokes(records[j], covariate.values[j]));
    }
  }
  const std::vector<std::vector<double>>& all = covariate.noisy ? smooth : covariate.values;
  std::vector<double> sorted;
  for (const auto& values : all) {
    sorted.insert(sorted.end(), values.begin(), values.end());
  }
  std::ranges::sort(sorted);
  for (std::size_t bin = 0; bin < kCount; ++bin) {
    centres.push_back(sorted[(2 * bin + 1) * sorted.size() / (2 * kCount)]);
  }
  for (std::size_t j = 0; j < records.size(); ++j) {
    std::vector<std::size_t>& of_record = places.emplace_back();
    for (std::size_t i = 0; i < records[j].samples(); ++i) {
      const auto below = std::ranges::lower_bound(sorted, all[j][i]) - sorted.begin();
      const std::size_t bin =
          std::min(static_cast<std::size_t>(below) * kCount / sorted.size(), kCount - 1);
      of_record.push_back(2 * bin + (records[j].velocity_m_s[i] < 0 ? 1 : 0));
    }
  }
}

}  // namespace host_sim::diagnose
