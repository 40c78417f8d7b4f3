#include "host_sim/diagnose/force/smoothing.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "host_sim/recording/signal.hpp"

namespace host_sim::diagnose {
namespace {

/// Samples in a row that were measured.
std::vector<recording::Stretch> pieces_of(const effects::ForceRecord& record) {
  return recording::stretches_of(record.measured, true);
}

using Channel = std::vector<double> effects::ForceRecord::*;

/// What each sample around one counts in something that is in proportion to them.
using Weights = Eigen::VectorXd;

/// Sum of squares that such weights make of noise of variance 1 that is correlated from sample to
/// sample, as `correlation` to the power of how far they are apart.
double variance_of(const Weights& weights, double correlation) {
  double variance = 0;
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    for (Eigen::Index k = 0; k < weights.size(); ++k) {
      variance += weights(i) * weights(k) * std::pow(correlation, std::abs(i - k));
    }
  }
  return variance;
}

/// Of a quintic that fits the samples around one best (Savitzky and Golay, 1964).
struct Quintic {
  Weights value;
  Weights slope;  ///< of one sample to the next

  explicit Quintic(int samples) {
    const Eigen::ArrayXd at = Eigen::ArrayXd::LinSpaced(2 * samples + 1, -1, 1);
    Eigen::MatrixXd powers(at.size(), 6);
    for (int power = 0; power < 6; ++power) {
      powers.col(power) = at.pow(power);
    }
    const Eigen::MatrixXd fit = powers * (powers.transpose() * powers).inverse();
    value = fit.col(0);
    slope = fit.col(1) / samples;
  }

  /// What a sample counts in the fit at its own place.
  [[nodiscard]] double own() const { return value((value.size() - 1) / 2); }

  /// Of what a sample is off the fit of the others.
  [[nodiscard]] Weights off() const {
    Weights off = -value / (1 - own());
    off((off.size() - 1) / 2) = 1;
    return off;
  }
};

/// Of what a sample is off the cubic through the two to each side of it.
Weights off_neighbours() {
  return Eigen::Matrix<double, 5, 1>(1, -4, 6, -4, 1) / 6;
}

/// Mean square of that.
double off_neighbours(const effects::ForceRecord& record, Channel channel) {
  const Weights weights = off_neighbours();
  const std::vector<double>& at = record.*channel;
  double square = 0;
  double count = 0;
  for (const recording::Stretch& piece : pieces_of(record)) {
    for (std::size_t i = piece.first + 2; i + 2 < piece.end(); ++i) {
      square += std::pow(weights.dot(Eigen::Map<const Eigen::VectorXd>(&at[i - 2], 5)), 2);
      ++count;
    }
  }
  return square / std::max(count, 1.0);
}

/// Correlation of noise that is off the fit of many samples by as many times more than off its
/// neighbours' as this ratio.
double correlation_by(double ratio, const Quintic& quintic) {
  constexpr double kMost = 0.6;  // more of it looks alike, but for how large it is
  const Weights off = quintic.off();
  const Weights of_neighbours = off_neighbours();
  double low = 0;
  double high = kMost;
  for (int step = 0; step < 20; ++step) {
    const double middle = (low + high) / 2;
    (variance_of(off, middle) < ratio * variance_of(of_neighbours, middle) ? low : high) = middle;
  }
  return low;
}

struct Smoothed {
  int samples = 0;  ///< to each side
  std::vector<double> values;
  std::vector<std::optional<double>> rates_1_s;  ///< none where no fit is
  double off = 0;  ///< mean square of what a sample is off the fit of the others
};

/// By quintics over some samples to each side.
Smoothed smoothed_over(int samples, const effects::ForceRecord& record, Channel channel) {
  const double own = Quintic(samples).own();
  const double reach_s = (samples + 0.5) * record.step_s();
  const std::vector<double>& read = record.*channel;
  Smoothed smoothed{.samples = samples, .values = read, .rates_1_s = {}, .off = HUGE_VAL};
  smoothed.rates_1_s.resize(read.size());
  double square = 0;
  double count = 0;
  for (const recording::Stretch& piece : pieces_of(record)) {
    for (std::size_t i = piece.first; i < piece.end(); ++i) {
      recording::LocalFit fit;
      if (recording::fit_wave_locally(record.time_s, read, piece, i, reach_s, fit)) {
        smoothed.values[i] = fit.value;
        smoothed.rates_1_s[i] = fit.slope_1_s;
        square += std::pow((read[i] - fit.value) / (1 - own), 2);
        ++count;
      }
    }
  }
  if (count > 0) {
    smoothed.off = square / count;
  }
  return smoothed;
}

/// Of these, over as many samples as foresee a sample best; null if none does better than its
/// neighbours.
const Smoothed* best_of(const std::vector<Smoothed>& all, double off_neighbours) {
  const auto best = std::ranges::min_element(all, {}, &Smoothed::off);
  return best->off < off_neighbours ? &*best : nullptr;
}

std::vector<Smoothed> smoothed_over(std::span<const int> samples,
                                    const effects::ForceRecord& record, Channel channel) {
  std::vector<Smoothed> all;
  for (const int of : samples) {
    all.push_back(smoothed_over(of, record, channel));
  }
  return all;
}

/// The noise that is left.
/// @param least of all that were tried
/// @param best null where none was taken
OutputNoise noise_left(const Smoothed& least, const Smoothed* best, double off_neighbours_N2,
                       double step_s) {
  const Smoothed& by = best != nullptr ? *best : least;
  if (by.off == HUGE_VAL || off_neighbours_N2 == 0) {
    return {};
  }
  const Quintic quintic(by.samples);
  const double correlation = correlation_by(by.off / off_neighbours_N2, quintic);
  const double noise_N2 = by.off / variance_of(quintic.off(), correlation);
  if (best == nullptr) {
    return {noise_N2, noise_N2 * (1 - correlation * correlation) / (2 * step_s * step_s)};
  }
  return {noise_N2 * variance_of(quintic.value, correlation),
          noise_N2 * variance_of(quintic.slope, correlation) / (step_s * step_s)};
}

}  // namespace

OutputNoise smooth_output(effects::ForceRecord& record) {
  constexpr int kSamples[] = {6, 10, 16};
  const Channel channel = &effects::ForceRecord::output_N;
  const double off_N2 = off_neighbours(record, channel);
  const std::vector<Smoothed> all = smoothed_over(kSamples, record, channel);
  const Smoothed* const best = best_of(all, off_N2);
  if (best != nullptr) {
    record.output_N = best->values;
    for (std::size_t i = 0; i < best->rates_1_s.size(); ++i) {
      record.output_rate_N_s[i] = best->rates_1_s[i].value_or(record.output_rate_N_s[i]);
    }
  }
  return noise_left(all.front(), best, off_N2, record.step_s());
}

void smooth_temperatures(effects::ForceRecord& record) {
  constexpr int kSamples[] = {8, 32};
  for (const Channel channel : {&effects::ForceRecord::sheath_temperature_C,
                                &effects::ForceRecord::winding_temperature_C}) {
    if ((record.*channel).empty()) {
      continue;
    }
    const std::vector<Smoothed> all = smoothed_over(kSamples, record, channel);
    if (const Smoothed* const best = best_of(all, off_neighbours(record, channel))) {
      record.*channel = best->values;
    }
  }
}

void thin(effects::ForceRecord& record, std::size_t most) {
  const std::size_t step = std::max<std::size_t>(1, record.samples() / most);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < record.samples(); i += step) {
    kept.push_back(i);
  }
  if (step > 1) {
    record.motion = std::make_shared<const effects::Motion>(
        effects::Motion{record.time_s, record.velocity_m_s});
    record.motion_step = step;
  }
  keep(record, kept);
}

}  // namespace host_sim::diagnose
