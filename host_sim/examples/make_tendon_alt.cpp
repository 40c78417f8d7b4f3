// Writes specimens.csv of the example campaign: the paper's life tests, synthetic.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hal/files/output_file.hpp"
#include "host_sim/reference/equations.hpp"
#include "host_sim/statistics/common_shape.hpp"
#include "host_sim/statistics/distribution.hpp"
#include "host_sim/statistics/fit.hpp"
#include "host_sim/statistics/goodness_of_fit.hpp"
#include "host_sim/synth/draws.hpp"

/// Samples of whole cycles in place of the lives that the paper measured but did not print.
namespace tendon_alt {

/// A row of the paper's Table 4, with the mean life of its Figure 10.
struct PrintedLevel {
  int bend_angle_deg;
  double scale_cycles;
  double shape;
  double mean_cycles;  ///< 0 where it is not printed
};

constexpr std::array<PrintedLevel, 6> kPrinted{{
    {270, 1060, 6.94, 993},
    {315, 854, 4.79, 783},
    {360, 675, 7.70, 634},
    {405, 551, 5.09, 506},
    {450, 407, 7.64, 383},
    {540, 236, 3.34, 0},
}};

namespace {

using host_sim::statistics::Family;
using host_sim::statistics::Fit;
using host_sim::statistics::Observation;
using host_sim::statistics::Sample;

constexpr std::uint64_t kSeed = 1;
constexpr std::uint64_t kUpperArmStream = 1;
constexpr std::size_t kSpecimens = 20;
constexpr std::uint64_t kDraws = 20'000;
constexpr std::size_t kChoices = 12, kOddChoices = 200;

// Half of the last digit that is printed.
constexpr double kScaleHalf = 0.5, kShapeHalf = 0.005, kMeanHalf = 0.5;
constexpr double kCommonShape = 5.94;
// All that samples with the printed fits can have.
constexpr double kLikelihoodRatio = 6.25, kLikelihoodRatioHalf = 0.55;
// The ratio of 540 deg against the others is 9.9 from the printed digits.
constexpr double kOddRatio = 9.9, kOddRatioHalf = 0.05;
// By family; below it p is above 0.3 for the Weibull distribution, 0.1 for the others.
constexpr std::array<double, 3> kLargestAndersonDarling{0.55, 0.55, 0.4};

bool near(double value, double middle, double half) {
  return std::abs(value - middle) < half;
}

Sample weibull_sample(std::uint64_t stream, std::uint64_t number, std::size_t size, double shape) {
  host_sim::synth::Random random(kSeed, stream, number);
  Sample sample(size);
  for (Observation& observation : sample) {
    observation.value = std::pow(-std::log(random.uniform()), 1 / shape);
  }
  return sample;
}

double mean_of(const Sample& sample) {
  double sum = 0;
  for (const Observation& observation : sample) {
    sum += observation.value;
  }
  return sum / static_cast<double>(sample.size());
}

/// Maximum likelihood is equivariant: where the fit of x is (a, b), that of
/// alpha (x / a)^(b / beta) is (alpha, beta), but for the rounding to whole cycles.
Sample whole_cycles(Sample sample, double alpha_cycles, double beta) {
  const auto [family, a, b] = host_sim::statistics::fit(Family::weibull, sample).distribution;
  for (Observation& observation : sample) {
    observation.value = std::round(alpha_cycles * std::pow(observation.value / a, b / beta));
  }
  return sample;
}

/// As in the paper's Table 3 no family is far off.
bool fits_each_family(const Sample& sample) {
  constexpr std::array<Family, 3> kFamilies{Family::normal, Family::lognormal, Family::weibull};
  for (std::size_t i = 0; i < kFamilies.size(); ++i) {
    const Fit fit = host_sim::statistics::fit(kFamilies[i], sample);
    if (host_sim::statistics::anderson_darling(fit.distribution, sample) >
        kLargestAndersonDarling[i]) {
      return false;
    }
  }
  return true;
}

bool looks_like(const PrintedLevel& printed, const Sample& sample) {
  if (printed.mean_cycles != 0 && !near(mean_of(sample), printed.mean_cycles, kMeanHalf)) {
    return false;
  }
  const Fit fit = host_sim::statistics::fit(Family::weibull, sample);
  return near(fit.distribution.first, printed.scale_cycles, kScaleHalf) &&
         near(fit.distribution.second, printed.shape, kShapeHalf) && fits_each_family(sample);
}

std::vector<Sample> choices_for(const PrintedLevel& printed, std::size_t count) {
  const auto stream = static_cast<std::uint64_t>(printed.bend_angle_deg);
  std::vector<Sample> choices;
  for (std::uint64_t number = 0; number < kDraws && choices.size() < count; ++number) {
    const Sample drawn = weibull_sample(stream, number, kSpecimens, printed.shape);
    Sample sample = whole_cycles(drawn, printed.scale_cycles, printed.shape);
    if (looks_like(printed, sample)) {
      choices.push_back(std::move(sample));
    }
  }
  return choices;
}

bool share_the_shape(const std::vector<Sample>& samples) {
  return near(host_sim::statistics::fit_common_shape(samples).shape, kCommonShape, kShapeHalf) &&
         near(host_sim::statistics::test_common_shape(samples, {.replicates = 0}).statistic,
              kLikelihoodRatio, kLikelihoodRatioHalf);
}

/// One of the choices for each of the four levels, the first that share the printed shape.
std::vector<Sample> four_levels() {
  std::array<std::vector<Sample>, 4> choices;
  std::size_t combinations = 1;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    choices[i] = choices_for(kPrinted[i + 1], kChoices);
    combinations *= choices[i].size();
  }
  for (std::size_t combination = 0; combination < combinations; ++combination) {
    std::vector<Sample> samples;
    std::size_t rest = combination;
    for (const std::vector<Sample>& of_level : choices) {
      samples.push_back(of_level[rest % of_level.size()]);
      rest /= of_level.size();
    }
    if (share_the_shape(samples)) {
      return samples;
    }
  }
  throw std::runtime_error("no samples share the printed shape");
}

Sample odd_level(std::vector<Sample> samples) {
  const std::size_t odd = samples.size();
  samples.emplace_back();
  for (const Sample& sample : choices_for(kPrinted.back(), kOddChoices)) {
    samples.back() = sample;
    const auto test =
        host_sim::statistics::test_shapes(samples, {.replicates = 0}).one_against_rest[odd];
    if (near(test.statistic, kOddRatio, kOddRatioHalf)) {
      return sample;
    }
  }
  throw std::runtime_error("no sample of the last level has the printed odds");
}

}  // namespace

/// Twenty lives for each row of kPrinted. The Weibull fit of each sample rounds to the printed
/// digits, and its mean to the printed mean. From 315 to 450 deg the common shape rounds to 5.94
/// and the likelihood ratio (18) lies in 5.7 .. 6.8; that of 540 deg against them rounds to 9.9.
std::array<Sample, kPrinted.size()> lives_by_level() {
  std::vector<Sample> four = four_levels();
  Sample last = odd_level(four);
  return {choices_for(kPrinted.front(), 1).at(0), four[0], four[1], four[2], four[3], last};
}

/// Ten lives of the upper-arm application (section 4.1): mean 1.00e3, of which the 867 cycles that
/// the paper predicts are 13.6 % short; eight between the B10 and B90 lives of the paper's model at
/// 39.9 N and two above.
Sample lives_of_upper_arm() {
  namespace reference = host_sim::reference;
  constexpr double kShape = 5.94, kTension_N = 39.9;
  constexpr double kMean = 1003.5, kMargin = 0.03;
  const double alpha = reference::ipl_life_cycles(kTension_N, 1.53e5, 1.38);
  const double b10 = alpha * reference::weibull_life_damage(0.1, kShape);
  const double b90 = alpha * reference::weibull_life_damage(0.9, kShape);
  for (std::uint64_t number = 0; number < kDraws; ++number) {
    Sample sample = weibull_sample(kUpperArmStream, number, 10, kShape);
    const double factor = kMean / mean_of(sample);
    for (Observation& observation : sample) {
      observation.value = std::round(factor * observation.value);
    }
    const auto inside = std::count_if(sample.begin(), sample.end(), [&](const Observation& one) {
      return one.value > b10 * (1 + kMargin) && one.value < b90 * (1 - kMargin);
    });
    const auto above = std::count_if(sample.begin(), sample.end(), [&](const Observation& one) {
      return one.value > b90 * (1 + kMargin);
    });
    if (inside == 8 && above == 2 && near(mean_of(sample), kMean, kMeanHalf)) {
      return sample;
    }
  }
  throw std::runtime_error("no sample of the upper arm has the printed range");
}

}  // namespace tendon_alt

namespace {

constexpr std::string_view kHeader =
    "# Synthetic, not measured: whole cycles drawn so that the Weibull fit of each level equals "
    "the\n"
    "# one printed in the paper's Table 4, 20 specimens a level under 49.0 N of output tension, "
    "and\n"
    "# the mean that of its Figure 10. 315 to 450 deg share the shape 5.94.\n"
    "# UA: the upper-arm application of section 4.1, mean life 1.00e3, 8 of 10 within B10 to B90.\n"
    "specimen,lot,bend_angle_deg,output_tension_mean_N,output_tension_amplitude_N,cycles,status,"
    "role\n";

void append(std::string& text, std::string_view name, std::string_view load, std::string_view role,
            const host_sim::statistics::Sample& sample) {
  int number = 0;
  for (const host_sim::statistics::Observation& observation : sample) {
    fmt::format_to(std::back_inserter(text), "{}-{:02},1,{},{:.0f},failed,{}\n", name, ++number,
                   load, observation.value, role);
  }
}

std::string specimens() {
  std::string text(kHeader);
  const auto lives = tendon_alt::lives_by_level();
  for (std::size_t level = 0; level < lives.size(); ++level) {
    const int bend_angle_deg = tendon_alt::kPrinted[level].bend_angle_deg;
    append(text, fmt::format("T{}", bend_angle_deg), fmt::format("{}.0,49.0,0.0", bend_angle_deg),
           bend_angle_deg == 270 ? "validation" : "fit", lives[level]);
  }
  append(text, "UA", "270.0,38.5,10.0", "validation", tendon_alt::lives_of_upper_arm());
  return text;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: {} FILE.csv\n", argv[0]);
    return 2;
  }
  try {
    hal::files::write_file(argv[1], specimens());
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
