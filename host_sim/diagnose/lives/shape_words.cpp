#include "host_sim/diagnose/lives/shape_words.hpp"

#include <fmt/format.h>

#include <vector>

#include "host_sim/statistics/common_shape.hpp"

namespace host_sim::diagnose::lives {
namespace {

constexpr std::uint64_t kShapeStream = 502;
constexpr std::size_t kLeastFailures = 5;

struct Levels {
  std::vector<statistics::Sample> samples;
  std::vector<double> tensions_N;
};

Levels levels_with_failures(const Campaign& campaign) {
  Levels levels;
  for (const Level& level : levels_of(campaign)) {
    statistics::Sample sample;
    std::size_t failures = 0;
    for (const Campaign::Specimen* specimen : level.specimens) {
      const bool failed = specimen->status == Campaign::Status::failed;
      sample.push_back({specimen->cycles(), failed});
      failures += failed ? 1 : 0;
    }
    if (level.role == Campaign::Role::fit && failures >= kLeastFailures) {
      levels.samples.push_back(std::move(sample));
      levels.tensions_N.push_back(level.load.effective_tension_N);
    }
  }
  return levels;
}

}  // namespace

std::string shape_words(const Campaign& campaign, const ShapeTestOptions& options) {
  const Levels levels = levels_with_failures(campaign);
  constexpr std::size_t kLeastLevels = 3;
  if (levels.samples.size() < kLeastLevels) {
    return "";
  }
  const statistics::BootstrapOptions bootstrap{
      .seed = options.seed, .stream = kShapeStream, .replicates = 2000, .threads = options.threads};
  std::size_t odd = 0;
  statistics::Test least{.p_simulated = 2};
  for (std::size_t i = 0; i < levels.samples.size(); ++i) {
    const statistics::Test test = statistics::test_one_against_rest(levels.samples, i, bootstrap);
    if (test.p_simulated < least.p_simulated) {
      least = test;
      odd = i;
    }
  }
  constexpr double kDiffers_p = 0.05;
  if (!(least.p_simulated * static_cast<double>(levels.samples.size()) < kDiffers_p)) {
    return "";
  }
  std::vector<statistics::Sample> rest = levels.samples;
  rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(odd));
  return fmt::format(
      "The lives at {:.1f} N have a Weibull shape of {:.2f} against {:.2f} of the other levels "
      "(p = {:.1g} by the likelihood ratio, {:.1g} simulated), as another mode of failure would.",
      levels.tensions_N[odd],
      statistics::fit(statistics::Family::weibull, levels.samples[odd]).distribution.second,
      statistics::fit_common_shape(rest).shape, least.p_chi_square, least.p_simulated);
}

}  // namespace host_sim::diagnose::lives
