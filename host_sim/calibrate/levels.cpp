#include "host_sim/calibrate/levels.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host_sim/calibrate/problem_text.hpp"
#include "host_sim/calibrate/result.hpp"
#include "host_sim/calibrate/streams.hpp"

namespace host_sim::calibrate {
namespace {

using statistics::Family;

constexpr std::size_t kFamilies = 3;

statistics::Sample sample_of(const Level& level) {
  statistics::Sample sample;
  sample.reserve(level.specimens.size());
  for (const Campaign::Specimen* specimen : level.specimens) {
    sample.push_back({specimen->cycles(), specimen->status == Campaign::Status::failed});
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
  for (std::size_t i = 0; i < kFamilies; ++i) {
    result.fits[i] = statistics::fit(static_cast<Family>(i), result.sample);
    if (result.fits[i].problem == statistics::FitProblem::none) {
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

std::string level_warning(const Campaign& campaign, const Level& level, const LevelResult& result) {
  const statistics::Fit& weibull = result.weibull();
  if (weibull.problem == statistics::FitProblem::none) {
    return {};
  }
  const auto file = (campaign.folder / "specimens.csv").string();
  return fmt::format(
      "{}:{}: level {}: {} failed of {}: no Weibull fit of its own, {}; its specimens still count "
      "in the life law",
      file, level.specimens.front()->line, result.name(), result.failed(), result.sample.size(),
      problem_text(weibull.problem));
}

std::size_t LevelResult::failed() const {
  std::size_t count = 0;
  for (const statistics::Observation& observation : sample) {
    count += observation.failed ? 1U : 0U;
  }
  return count;
}

std::string LevelResult::name() const {
  return load.bend_angle_deg
             ? fmt::format("{:g} deg, {:.1f} N", *load.bend_angle_deg, load.effective_tension_N)
             : fmt::format("{:.1f} N", load.effective_tension_N);
}

}  // namespace host_sim::calibrate
