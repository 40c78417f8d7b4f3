#include "host_sim/calibrate/levels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "host_sim/calibrate/streams.hpp"

namespace host_sim::calibrate {
namespace {

using statistics::Family;

constexpr std::size_t kFamilies = 3;

statistics::Observation observation_of(const Campaign::Specimen& specimen) {
  using Status = Campaign::Status;
  statistics::Observation seen{.value = specimen.cycles()};
  seen.failed = specimen.status != Status::suspended && specimen.status != Status::trimmed_high;
  seen.trimmed = specimen.trimmed();
  if (seen.failed && specimen.status != Status::failed) {
    seen.from = specimen.from_cycles;
  }
  return seen;
}

statistics::Sample sample_of(const Level& level) {
  statistics::Sample sample;
  sample.reserve(level.specimens.size());
  for (const Campaign::Specimen* specimen : level.specimens) {
    sample.push_back(observation_of(*specimen));
  }
  return sample;
}

/// Even steps on the probability paper from 0.5 % to 99.5 %.
std::vector<double> band_probabilities() {
  constexpr std::size_t kPoints = 41;
  const double first = std::log(-std::log1p(-0.005));
  const double last = std::log(-std::log1p(-0.995));
  std::vector<double> p(kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double share = static_cast<double>(i) / (kPoints - 1);
    p[i] = -std::expm1(-std::exp(first + share * (last - first)));
  }
  return p;
}

}  // namespace

LevelResult level_result(const Level& level, std::size_t index, const CalibrateOptions& options) {
  LevelResult result;
  result.load = level.load;
  result.role = level.role;
  result.sample = sample_of(level);
  for (const Campaign::Specimen* specimen : level.specimens) {
    result.specimens.push_back(specimen->name);
  }
  for (std::size_t i = 0; i < kFamilies; ++i) {
    result.fits[i] = statistics::fit(static_cast<Family>(i), result.sample);
    if (result.fits[i].problem == statistics::FitProblem::none && result.found_broken() == 0) {
      result.goodness[i] = statistics::goodness_of_fit(
          result.fits[i], result.sample,
          bootstrap(options, Purpose::goodness_of_fit, index * kFamilies + i));
    }
  }
  result.positions = statistics::plotting_positions(result.sample);
  const statistics::Fit& weibull = result.weibull();
  if (weibull.problem == statistics::FitProblem::none) {
    const std::vector<statistics::Sample> alone{result.sample};
    result.mean_life = weibull.distribution.mean();
    result.shape_unbiased = statistics::unbiased_shape(
        alone, statistics::fit_common_shape(alone), bootstrap(options, Purpose::level_bias, index));
    const std::vector<double> p = band_probabilities();
    result.band = statistics::weibull_quantile_band(
        weibull, result.sample, p, kConfidence, bootstrap(options, Purpose::quantile_band, index));
  }
  return result;
}

std::string_view problem_name(statistics::FitProblem problem) {
  switch (problem) {
    case statistics::FitProblem::none:
      return "";
    case statistics::FitProblem::too_few_failures:
      return "fewer than two failures";
    case statistics::FitProblem::no_spread:
      return "all failures at one life";
    case statistics::FitProblem::not_identified:
      return "the data do not determine it";
    case statistics::FitProblem::not_converged:
      return "the fit did not converge";
  }
  return "";
}

std::size_t LevelResult::failed() const {
  std::size_t count = 0;
  for (const statistics::Observation& observation : sample) {
    count += observation.failed || observation.trimmed ? 1U : 0U;
  }
  return count;
}

std::size_t LevelResult::found_broken() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      sample,
      [](const statistics::Observation& seen) { return seen.from.has_value() && !seen.trimmed; }));
}

std::size_t LevelResult::trimmed() const {
  return static_cast<std::size_t>(std::ranges::count_if(sample, &statistics::Observation::trimmed));
}

std::string LevelResult::name() const {
  return load.bend_angle_deg
             ? fmt::format("{:g} deg, {:.1f} N", *load.bend_angle_deg, load.effective_tension_N)
             : fmt::format("{:.1f} N", load.effective_tension_N);
}

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

std::vector<OddLevel> odd_levels(std::span<const statistics::Test> one_against_rest,
                                 std::span<const std::size_t> chosen) {
  std::vector<OddLevel> odd;
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const statistics::Test& test = one_against_rest[i];
    const double looked_at = static_cast<double>(chosen.size());
    odd.push_back({.level = chosen[i],
                   .test = test,
                   .p_corrected = std::min(1.0, test.p_simulated * looked_at)});
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
  statistics::ShapeTests tests =
      statistics::test_shapes(samples, bootstrap(options, Purpose::common_shape));
  result.homogeneity = tests.common;
  if (chosen.size() >= kFewestToCompare) {
    result.odd_levels = odd_levels(tests.one_against_rest, chosen);
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
    tests =
        statistics::test_shapes(samples, bootstrap(options, Purpose::common_shape, chosen.size()));
    result.homogeneity = tests.common;
    odd = odd_levels(tests.one_against_rest, chosen);
  }
  const statistics::CommonShapeFit fit = statistics::fit_common_shape(samples);
  result.value = fit.shape;
  result.ci95 = statistics::common_shape_interval(samples, fit, kConfidence);
  result.unbiased =
      statistics::unbiased_shape(samples, fit, bootstrap(options, Purpose::common_bias));
  return result;
}

namespace {

life_law::LifeDatum datum_of(const Campaign::Specimen& specimen, std::size_t level) {
  life_law::LifeDatum datum;
  for (const Campaign::Block& block : specimen.blocks) {
    datum.blocks.push_back({block.load.effective_tension_N, block.cycles});
  }
  const statistics::Observation seen = observation_of(specimen);
  datum.failed = seen.failed;
  datum.level = level;
  datum.from_cycles = seen.from;
  datum.trimmed = seen.trimmed;
  return datum;
}

life_law::LifeData in_blocks(const Campaign& campaign, Campaign::Role role) {
  life_law::LifeData data;
  for (const Campaign::Specimen& specimen : campaign.specimens) {
    if (specimen.role == role && !specimen.constant_load()) {
      data.push_back(datum_of(specimen, life_law::LifeDatum::kNoLevel));
    }
  }
  return data;
}

}  // namespace

life_law::LifeData specimens_to_fit(const Campaign& campaign, std::span<const LevelResult> levels,
                                    std::span<const Level> sources) {
  life_law::LifeData data = in_blocks(campaign, Campaign::Role::fit);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i].role != Campaign::Role::fit || !levels[i].left_out.empty()) {
      continue;
    }
    const life_law::LifeData level = level_specimens(sources[i], i);
    data.insert(data.end(), level.begin(), level.end());
  }
  return data;
}

life_law::LifeData level_specimens(const Level& level, std::size_t number) {
  life_law::LifeData data;
  for (const Campaign::Specimen* specimen : level.specimens) {
    data.push_back(datum_of(*specimen, number));
  }
  return data;
}

life_law::LifeData validation_in_blocks(const Campaign& campaign) {
  return in_blocks(campaign, Campaign::Role::validation);
}

}  // namespace host_sim::calibrate
