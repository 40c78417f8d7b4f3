#include "tests/report/calibrate/sample_result.hpp"

#include <cmath>
#include <limits>

namespace host_sim::samples {
namespace {

using calibrate::CalibrateResult;
using calibrate::LevelResult;
using statistics::Interval;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

/// Twenty lives at the median ranks of a Weibull distribution, with the fit that they are drawn at.
LevelResult level_at(double angle_deg, double tension_N, double scale, double shape) {
  constexpr std::size_t kSpecimens = 20;
  LevelResult level;
  level.load = {angle_deg, tension_N, tension_N, tension_N};
  for (std::size_t i = 0; i < kSpecimens; ++i) {
    const double p = (static_cast<double>(i) + 0.7) / (kSpecimens + 0.4);
    const double life = scale * std::pow(-std::log1p(-p), 1 / shape);
    level.sample.push_back({life, true});
    level.specimens.push_back("wire " + std::to_string(i + 1));
    level.positions.push_back({life, p, life, i});
  }
  level.fits = {
      statistics::Fit{{statistics::Family::normal, 0.93 * scale, scale / shape}, -125.5, {}},
      statistics::Fit{{statistics::Family::lognormal, std::log(0.9 * scale), 1 / shape}, -126, {}},
      statistics::Fit{{statistics::Family::weibull, scale, shape}, -124.5, {}}};
  level.goodness = {statistics::GoodnessOfFit{0.11, 0.715, 0.25, 0.884},
                    statistics::GoodnessOfFit{0.12, 0.694, 0.31, 0.883},
                    statistics::GoodnessOfFit{0.1, 0.955, 0.2, 0.978}};
  level.shape_unbiased = 0.93 * shape;
  level.mean_life = scale * std::tgamma(1 + 1 / shape);
  for (const double place : {-5.0, -4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 1.6}) {
    const double life = scale * std::exp(place / shape);
    const double spread = 1.06 + 0.03 * std::abs(place);
    level.band.p.push_back(-std::expm1(-std::exp(place)));
    level.band.low.push_back(life / spread);
    level.band.high.push_back(life * spread);
  }
  return level;
}

void suspend_last(LevelResult& level) {
  level.sample.back().failed = false;
  level.positions.pop_back();
}

void without_fits(LevelResult& level, statistics::FitProblem problem) {
  for (statistics::Fit& fit : level.fits) {
    fit.problem = problem;
    fit.distribution.first = fit.distribution.second = kNotANumber;
  }
  level.goodness = {};
  level.mean_life = level.shape_unbiased = 0;
  level.band = {};
}

calibrate::CommonShape shape_like_the_paper() {
  calibrate::CommonShape shape;
  shape.value = 5.94;
  shape.ci95 = {5.05, 6.87};
  shape.unbiased = 5.78;
  shape.homogeneity = {6.2, 3, 0.102, 0.125};
  shape.with_all_levels = statistics::Test{15.5, 4, 0.0038, 0.0051};
  shape.odd_levels = {{2, {3.2, 1, 0.074, 0.08}, 0.4}, {5, {9.9, 1, 0.0017, 0.0023}, 0.0115}};
  return shape;
}

calibrate::StressLife law_like_the_paper() {
  calibrate::StressLife law;
  law.law = {2.06e5, 1.457, 5.79};
  law.log_likelihood = -497.25;
  law.scale_ci95 = {1.2e5, 3.5e5};
  law.exponent_ci95 = {1.32, 1.59};
  law.shape_ci95 = {4.9, 6.7};
  law.shape_unbiased = 5.63;
  law.least_squares = life_law::LifeLaw{1.53e5, 1.38, 5.94};
  law.least_squares_rmse = 12.3;
  law.against_free_levels = statistics::Test{1.75, 2, 0.417, 0.43};
  law.against_curvature = statistics::Test{1.5, 1, 0.221, 0.23};
  law.against_growing_scatter = statistics::Test{4.5, 1, 0.034, 0.031};
  for (double tension_N = 35; tension_N < 101; tension_N += 5) {
    const double mean = law.law.mean_life(tension_N);
    const double spread = 1.04 + 0.08 * std::abs(std::log(tension_N / 53));
    law.band_tension_N.push_back(tension_N);
    law.band_mean.push_back({mean / spread, mean * spread});
  }
  law.tested_N = {35, 100};
  return law;
}

calibrate::UseLevel use_at(const std::string& name, double tension_N, double spread) {
  const life_law::LifeLaw law{2.06e5, 1.457, 5.79};
  calibrate::UseLevel use;
  use.name = name;
  use.effective_tension_N = tension_N;
  use.mean = law.mean_life(tension_N);
  use.b10 = law.quantile(0.1, tension_N);
  use.b50 = law.quantile(0.5, tension_N);
  use.b90 = law.quantile(0.9, tension_N);
  use.mean_ci95 = {use.mean / spread, use.mean * spread};
  use.b10_ci95 = {use.b10 / spread, use.b10 * spread};
  use.next_specimen_95 = {0.55 * use.mean, 1.4 * use.mean};
  return use;
}

calibrate::ValidationResult validation_at(std::size_t level) {
  calibrate::ValidationResult validation;
  validation.level = level;
  validation.predicted_mean = 1044;
  validation.measured_mean = 993;
  validation.ratio_ci95 = {0.86, 1.05};
  validation.p = 0.31;
  validation.below_b10 = 2;
  validation.inside_b10_b90 = 17;
  validation.above_b90 = 1;
  validation.words = "the measured mean is 4.9 % less than predicted: not refuted, not proved";
  return validation;
}

void add_found(CalibrateResult& result) {
  result.common_shape = shape_like_the_paper();
  result.stress_life = law_like_the_paper();
  result.seed = 1;
  result.bootstraps = 10'000;
}

CalibrateResult one_level() {
  CalibrateResult result;
  result.campaign = "One level";
  result.specimens = result.failed = 20;
  result.levels = {level_at(315, 42.5, 854, 4.79)};
  result.warnings = {"no life law: all failures are at one effective tension"};
  return result;
}

/// Tension alone, all suspended at one level, too few failures at the other.
CalibrateResult without_law() {
  CalibrateResult result;
  result.campaign = "Nothing to fit";
  result.levels = {level_at(0, 20, 2000, 5), level_at(0, 30, 1000, 5)};
  for (LevelResult& level : result.levels) {
    level.load.bend_angle_deg.reset();
    without_fits(level, statistics::FitProblem::too_few_failures);
    for (statistics::Observation& specimen : level.sample) {
      specimen.failed = false;
    }
    level.positions.clear();
  }
  result.levels[1].sample.front().failed = true;
  result.levels[1].positions = {{result.levels[1].sample.front().value, 0.034}};
  result.specimens = 40;
  result.failed = 1;
  result.suspended = 39;
  result.warnings = {"level 20.0 N: nothing failed", "no life law"};
  return result;
}

/// Intervals without ends, tests that were not made, p-values that were not computed.
CalibrateResult without_ends() {
  CalibrateResult result = paper_like();
  result.campaign = "No ends";
  calibrate::StressLife& law = *result.stress_life;
  law.scale_ci95 = {0, kInfinity};
  law.exponent_ci95 = {-kInfinity, kInfinity};
  law.against_free_levels.reset();
  law.against_curvature.reset();
  law.against_growing_scatter = statistics::Test{kNotANumber, 1, kNotANumber, kNotANumber};
  law.least_squares.reset();
  for (Interval& interval : law.band_mean) {
    interval.high = kInfinity;
  }
  for (calibrate::UseLevel& use : result.use_levels) {
    use.mean_ci95 = {0, kInfinity};
    use.b10_ci95 = {0, kInfinity};
    use.next_specimen_95 = {0, kInfinity};
  }
  result.levels[0].band.low.front() = 0;
  result.levels[0].band.high.back() = kInfinity;
  return result;
}

/// A campaign of blocks alone has no level to draw.
CalibrateResult only_blocks() {
  CalibrateResult result;
  result.campaign = "Blocks";
  result.specimens = result.failed = result.in_blocks = 8;
  add_found(result);
  result.common_shape.reset();
  calibrate::ValidationResult validation = validation_at(0);
  validation.in_blocks = true;
  validation.predicted_mean = 0.93;
  validation.measured_mean = 0.88;
  result.validation = {validation};
  result.use_levels = {use_at("glove", 25.5, 1.2)};
  return result;
}

}  // namespace

CalibrateResult paper_like() {
  CalibrateResult result;
  result.campaign = "Bowden cable, 49 N";
  result.levels = {level_at(315, 42.5, 854, 4.79), level_at(360, 50.8, 675, 7.7),
                   level_at(405, 60.1, 551, 5.09), level_at(450, 71.0, 407, 7.64),
                   level_at(540, 99.8, 236, 3.34), level_at(270, 35.2, 1060, 6.94)};
  result.levels[4].left_out = "its shape 3.34 differs from that of the other levels, p 0.0023";
  result.levels[5].role = Campaign::Role::validation;
  suspend_last(result.levels[1]);
  suspend_last(result.levels[5]);
  result.specimens = 100;
  result.failed = 99;
  result.suspended = 1;
  add_found(result);
  result.common_shape->odd_levels[0].level = 1;
  result.common_shape->odd_levels[1].level = 4;
  result.use_levels = {use_at("upper arm", 39.9, 1.07), use_at("Exo-glove", 25.5, 1.18),
                       use_at("SDM hand", 25.0, 1.19)};
  result.validation = {validation_at(5)};
  result.mixes = {{"stairs", {{40, 0.5}, {50, 0.5}}, 45.11, 44.34}};
  result.warnings = {"level 540 deg, 99.8 N is left out of the life law: its shape differs",
                     "use level Exo-glove: 25.5 N lies outside of the tested 42.5 to 71.0 N"};
  return result;
}

CalibrateResult hostile_campaign() {
  CalibrateResult result = paper_like();
  result.campaign = "</script><script>throw 1</script>\"'&amp;{{title}} \u00dcberlast \u8155 \xff";
  result.levels[4].left_out = "<!--<script>";
  result.use_levels[0].name = "--><img src=x onerror=\"throw 2\">";
  result.mixes[0].name = "</table><td onclick='throw 3'>";
  result.validation[0].words = "</li></ul><plaintext>";
  result.warnings = {"<style>*{display:none}</style>", "\x01]]>"};
  return result;
}

std::vector<CalibrateSample> all_calibrations() {
  std::vector<CalibrateSample> samples;
  samples.push_back({"typical", 15, paper_like()});
  samples.push_back({"hostile", 15, hostile_campaign()});
  samples.push_back({"one_level", 8, one_level()});
  samples.push_back({"without_law", 5, without_law()});
  samples.push_back({"without_ends", 15, without_ends()});
  samples.push_back({"only_blocks", 4, only_blocks()});
  samples.push_back({"nothing", 0, CalibrateResult{}});
  return samples;
}

}  // namespace host_sim::samples
