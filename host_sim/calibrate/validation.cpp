#include "host_sim/calibrate/validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/calibrate/streams.hpp"
#include "host_sim/life_law/life_simulation.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/statistics/fit.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::calibrate {

double damage(const life_law::LifeDatum& datum, const life_law::LifeLaw& law) {
  double sum = 0;
  for (const life_law::LifeDatum::Block& block : datum.blocks) {
    sum += block.cycles / law.characteristic_life(block.effective_tension_N);
  }
  return sum;
}

double mean_damage(std::span<const life_law::LifeDatum> data, const life_law::LifeLaw& law) {
  statistics::Sample damages;
  double sum = 0;
  bool known = true;
  for (const life_law::LifeDatum& datum : data) {
    const double used = damage(datum, law);
    sum += used;
    known = known && datum.failed && !datum.from_cycles;
    damages.push_back({.value = used, .failed = datum.failed});
    if (datum.from_cycles) {
      damages.back().from = *datum.from_cycles / datum.blocks.front().cycles * used;
    }
  }
  const auto count = static_cast<double>(data.size());
  if (known && count > 0) {
    return sum / count;
  }
  const statistics::CentredSample logs(statistics::Family::weibull, damages);
  if (!logs.bounded()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::exp(log_scale(logs, law.shape)) * reference::weibull_mean_damage(law.shape);
}

namespace {

/// Logarithm of measured over predicted mean, in units of the scatter of ln life: free of the
/// parameters of the law but for the design.
double pivot(std::span<const life_law::LifeDatum> specimens, const LifeLaw& law) {
  const double predicted = reference::weibull_mean_damage(law.shape);
  return std::log(mean_damage(specimens, law) / predicted) * law.shape;
}

std::vector<double> simulated_pivots(std::span<const life_law::LifeDatum> specimens,
                                     const LifeLaw& law, std::span<const LifeLaw> refits,
                                     std::size_t index, const CalibrateOptions& options) {
  const life_law::LifeSimulation simulation(specimens);
  std::vector<double> pivots(refits.size(), std::nan(""));
  statistics::parallel_for(
      refits.size(),
      [&](std::size_t i) {
        life_law::LifeData drawn;
        statistics::Random random(options.seed, stream_of(Purpose::validation, index), i);
        simulation.draw(law, random, drawn);
        if (refits[i].shape > 0) {
          pivots[i] = pivot(drawn, refits[i]);
        }
      },
      options.threads);
  pivots.erase(
      std::remove_if(pivots.begin(), pivots.end(), [](double x) { return !std::isfinite(x); }),
      pivots.end());
  std::sort(pivots.begin(), pivots.end());
  return pivots;
}

double two_sided_p(const std::vector<double>& sorted, double measured) {
  const auto below = std::upper_bound(sorted.begin(), sorted.end(), measured) - sorted.begin();
  const auto above = sorted.end() - std::lower_bound(sorted.begin(), sorted.end(), measured);
  const auto count = static_cast<double>(sorted.size());
  return std::min(1.0, 2 * static_cast<double>(1 + std::min(below, above)) / (1 + count));
}

double quantile_of(const std::vector<double>& sorted, double p) {
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::lround(p * last))];
}

void count_bands(std::span<const life_law::LifeDatum> specimens, const LifeLaw& law,
                 ValidationResult& result) {
  for (const life_law::LifeDatum& specimen : specimens) {
    const double used = damage(specimen, law);
    if (!specimen.failed) {
      continue;
    }
    // Where both ends of what is known of a life lie on one side.
    const double from =
        specimen.from_cycles ? *specimen.from_cycles / specimen.blocks.front().cycles * used : used;
    const double b10 = reference::weibull_life_damage(0.1, law.shape);
    const double b90 = reference::weibull_life_damage(0.9, law.shape);
    if (used < b10) {
      ++result.below_b10;
    } else if (from > b90) {
      ++result.above_b90;
    } else if (from >= b10 && used <= b90) {
      ++result.inside_b10_b90;
    }
  }
}

std::string prose_of(const ValidationResult& result) {
  const double difference = result.measured_mean / result.predicted_mean - 1;
  const std::string finding = fmt::format(
      "the measured mean is {:.1f} % {} than predicted; if the law is right, a difference as large "
      "comes up with p = {:.2g}",
      100 * std::abs(difference), difference < 0 ? "less" : "more", result.p);
  const std::string range = fmt::format("{:.2f} to {:.2f} times the prediction",
                                        result.ratio_ci95.low, result.ratio_ci95.high);
  return result.p < kSignificance
             ? fmt::format("{}: the law is refuted here at 5 %; the true mean is {}", finding,
                           range)
             : fmt::format("{}: not refuted, and not proved either: the true mean may be {}",
                           finding, range);
}

}  // namespace

std::optional<ValidationResult> validate(std::span<const life_law::LifeDatum> specimens,
                                         const LifeLaw& law, std::span<const LifeLaw> refits,
                                         std::size_t index, const CalibrateOptions& options) {
  constexpr double kTail = 0.025;
  const double measured = pivot(specimens, law);
  if (!std::isfinite(measured)) {
    return std::nullopt;
  }
  const std::vector<double> pivots = simulated_pivots(specimens, law, refits, index, options);
  if (pivots.empty()) {
    return std::nullopt;
  }
  ValidationResult result;
  result.predicted_mean = reference::weibull_mean_damage(law.shape);
  result.measured_mean = mean_damage(specimens, law);
  result.p = two_sided_p(pivots, measured);
  result.ratio_ci95 = {std::exp((measured - quantile_of(pivots, 1 - kTail)) / law.shape),
                       std::exp((measured - quantile_of(pivots, kTail)) / law.shape)};
  count_bands(specimens, law, result);
  result.words = prose_of(result);
  return result;
}

}  // namespace host_sim::calibrate
