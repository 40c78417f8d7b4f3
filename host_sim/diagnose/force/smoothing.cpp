#include "host_sim/diagnose/force/smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "host_sim/recording/signal.hpp"

namespace host_sim::diagnose {
namespace {

/// Samples in a row that count.
std::vector<recording::Stretch> pieces_of(const effects::ForceRecord& record) {
  return recording::stretches_of(record.used, true);
}

/// Mean square of what a sample is off the cubic through the two to each side of it.
double off_neighbours(const std::vector<effects::ForceRecord>& records) {
  double square_N2 = 0;
  double count = 0;
  for (const effects::ForceRecord& record : records) {
    const std::vector<double>& at_N = record.output_N;
    for (const recording::Stretch& piece : pieces_of(record)) {
      for (std::size_t i = piece.first + 2; i + 2 < piece.end(); ++i) {
        const double between_N = (4 * (at_N[i - 1] + at_N[i + 1]) - at_N[i - 2] - at_N[i + 2]) / 6;
        square_N2 += std::pow(at_N[i] - between_N, 2);
        ++count;
      }
    }
  }
  return square_N2 / std::max(count, 1.0);
}

struct Smoothed {
  std::vector<std::vector<double>> output_N;  ///< by record
  std::vector<std::vector<double>> rate_N_s;
  double off_N2 = 0;  ///< mean square of what a sample is off the fit of the others
  double own = 0;     ///< what a sample counts in the fit at its own place
};

/// By cubics over some samples to each side.
Smoothed smoothed_over(int samples, const std::vector<effects::ForceRecord>& records) {
  const double reach = samples;
  const double own = 3 * (3 * reach * reach + 3 * reach - 1) /
                     ((2 * reach + 3) * (2 * reach + 1) * (2 * reach - 1));
  Smoothed smoothed{.output_N = {}, .rate_N_s = {}, .off_N2 = 0, .own = own};
  double count = 0;
  for (const effects::ForceRecord& record : records) {
    std::vector<double>& output_N = smoothed.output_N.emplace_back(record.output_N);
    std::vector<double>& rate_N_s = smoothed.rate_N_s.emplace_back(record.output_rate_N_s);
    const double step_s = record.step_s();
    for (const recording::Stretch& piece : pieces_of(record)) {
      for (std::size_t i = piece.first; i < piece.end(); ++i) {
        recording::LocalFit fit;
        if (recording::fit_locally(record.time_s, record.output_N, piece, i, (reach + 0.5) * step_s,
                                   fit)) {
          output_N[i] = fit.value;
          rate_N_s[i] = fit.slope_1_s;
          smoothed.off_N2 += std::pow((record.output_N[i] - fit.value) / (1 - own), 2);
          ++count;
        }
      }
    }
  }
  smoothed.off_N2 = count > 0 ? smoothed.off_N2 / count : HUGE_VAL;
  return smoothed;
}

template <class T>
void thin(std::vector<T>& values, std::size_t step) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); i += step) {
    values[kept++] = values[i];
  }
  values.resize(kept);
}

/// Of all places since the sample that is kept before one, the farthest beyond both; else its own.
double reversal_m(const effects::ForceRecord& record, std::size_t before, std::size_t at) {
  const auto [low_m, high_m] = std::minmax(record.position_m[before], record.position_m[at]);
  double turned_m = record.position_m[at];
  double farthest_m = 0;
  for (std::size_t i = before + 1; i <= at; ++i) {
    for (const double place_m : {record.reversal_m[i], record.position_m[i]}) {
      const double beyond_m = std::max(place_m - high_m, low_m - place_m);
      if (beyond_m > farthest_m) {
        farthest_m = beyond_m;
        turned_m = place_m;
      }
    }
  }
  return turned_m;
}

}  // namespace

double smooth_output(std::vector<effects::ForceRecord>& records) {
  constexpr int kSamples[] = {4, 8, 16};
  constexpr double kOfNeighbours = 35.0 / 18;  // of the noise, 1 + (2 * 4^2 + 2 * 1^2)/6^2
  double least_N2 = off_neighbours(records);
  std::optional<Smoothed> best;
  for (const int samples : kSamples) {
    Smoothed smoothed = smoothed_over(samples, records);
    if (smoothed.off_N2 < least_N2) {
      least_N2 = smoothed.off_N2;
      best = std::move(smoothed);
    }
  }
  if (!best) {
    return least_N2 / kOfNeighbours;
  }
  for (std::size_t j = 0; j < records.size(); ++j) {
    records[j].output_N = std::move(best->output_N[j]);
    records[j].output_rate_N_s = std::move(best->rate_N_s[j]);
  }
  return best->own * (1 - best->own) * best->off_N2;
}

void thin(effects::ForceRecord& record, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, record.samples() / most);
  for (std::size_t i = step; i < record.samples(); i += step) {
    record.reversal_m[i] = reversal_m(record, i - step, i);
  }
  for (auto* values : {&record.time_s, &record.input_N, &record.output_N, &record.output_rate_N_s,
                       &record.velocity_m_s, &record.position_m, &record.reversal_m,
                       &record.bend_angle_rad, &record.sheath_temperature_C,
                       &record.winding_temperature_C, &record.rotor_rad, &record.cycle}) {
    thin(*values, step);
  }
  thin(record.used, step);
}

}  // namespace host_sim::diagnose
