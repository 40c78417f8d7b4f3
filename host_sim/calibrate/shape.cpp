#include "host_sim/calibrate/shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "host_sim/calibrate/result.hpp"
#include "host_sim/calibrate/streams.hpp"

namespace host_sim::calibrate {
namespace {

constexpr std::size_t kFewestToCompare = 3;

/// Levels that can be compared: role fit, a fit of their own, not left out.
std::vector<std::size_t> comparable(std::span<const LevelResult> levels) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].role == Campaign::Role::fit && levels[i].left_out.empty() &&
        levels[i].weibull().problem == statistics::FitProblem::none) {
      found.push_back(i);
    }
  }
  return found;
}

std::vector<statistics::Sample> samples_of(std::span<const LevelResult> levels,
                                           std::span<const std::size_t> chosen) {
  std::vector<statistics::Sample> samples;
  samples.reserve(chosen.size());
  for (const std::size_t level : chosen) {
    samples.push_back(levels[level].sample);
  }
  return samples;
}

std::vector<OddLevel> odd_levels(std::span<const statistics::Sample> samples,
                                 std::span<const std::size_t> chosen,
                                 const CalibrateOptions& options) {
  std::vector<OddLevel> odd;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    OddLevel level;
    level.level = chosen[i];
    level.test = statistics::test_one_against_rest(
        samples, i, bootstrap(options, Purpose::odd_level, chosen[i]));
    level.p_corrected = std::min(1.0, level.test.p_simulated * static_cast<double>(chosen.size()));
    odd.push_back(level);
  }
  return odd;
}

std::string reason(const OddLevel& odd, const LevelResult& level) {
  return fmt::format(
      "its shape {:.3g} differs from that of the other levels: likelihood ratio {:.2f}, p {:.2g}, "
      "corrected for looking at every level {:.2g}",
      level.weibull().distribution.second, odd.test.statistic, odd.test.p_simulated,
      odd.p_corrected);
}

}  // namespace

std::optional<CommonShape> common_shape(std::span<LevelResult> levels,
                                        const CalibrateOptions& options) {
  constexpr std::size_t kFewest = 2;
  std::vector<std::size_t> chosen = comparable(levels);
  if (chosen.size() < kFewest) {
    return std::nullopt;
  }
  CommonShape result;
  std::vector<statistics::Sample> samples = samples_of(levels, chosen);
  result.homogeneity =
      statistics::test_common_shape(samples, bootstrap(options, Purpose::common_shape));
  if (chosen.size() >= kFewestToCompare) {
    result.odd_levels = odd_levels(samples, chosen, options);
  }
  std::vector<OddLevel> odd = result.odd_levels;
  while (!options.keep_all_levels && result.homogeneity.p_simulated < kSignificance &&
         chosen.size() >= kFewestToCompare) {
    const auto worst = std::min_element(odd.begin(), odd.end(), [](const auto& a, const auto& b) {
      return a.test.statistic > b.test.statistic;
    });
    if (worst->p_corrected >= kSignificance) {
      break;
    }
    levels[worst->level].left_out = reason(*worst, levels[worst->level]);
    if (!result.with_all_levels) {
      result.with_all_levels = result.homogeneity;
    }
    chosen = comparable(levels);
    samples = samples_of(levels, chosen);
    result.homogeneity = statistics::test_common_shape(
        samples, bootstrap(options, Purpose::common_shape, chosen.size()));
    odd = odd_levels(samples, chosen, options);
  }
  const statistics::CommonShapeFit fit = statistics::fit_common_shape(samples);
  result.value = fit.shape;
  result.ci95 = statistics::common_shape_interval(samples, fit, kConfidence);
  result.unbiased =
      statistics::unbiased_shape(samples, fit, bootstrap(options, Purpose::common_bias));
  return result;
}

}  // namespace host_sim::calibrate
