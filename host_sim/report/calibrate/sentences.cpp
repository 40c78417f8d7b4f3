#include "host_sim/report/calibrate/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "host_sim/report/calibrate/notation.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page {
namespace {

using calibrate::CalibrateResult;
using calibrate::LevelResult;

std::string evidence(const statistics::Test& test) {
  return fmt::format(
      "likelihood ratio {} with {}, p {} simulated, {} by chi-square", number_text(test.statistic),
      counted_text(static_cast<std::uint64_t>(test.degrees_of_freedom), "degree") + " of freedom",
      p_text(test.p_simulated), p_text(test.p_chi_square));
}

void add_test(std::vector<std::string>& words, const std::optional<statistics::Test>& test,
              std::string_view held, std::string_view rejected, std::string_view missing) {
  if (!test || std::isnan(calibrate::p_of(*test))) {
    words.emplace_back(missing);
  } else {
    words.push_back(
        fmt::format("{} ({}).", calibrate::rejected(*test) ? rejected : held, evidence(*test)));
  }
}

/// How many things the reader must look at before trusting the law.
std::string caution(const CalibrateResult& result) {
  if (result.warnings.empty()) {
    return {};
  }
  return result.warnings.size() == 1
             ? " Read the warning first."
             : fmt::format(" Read the {} warnings first.", result.warnings.size());
}

std::string levels_used(const CalibrateResult& result) {
  const auto used =
      std::count_if(result.levels.begin(), result.levels.end(),
                    [](const LevelResult& level) { return kind_of(level) == LevelKind::fitted; });
  return counted_text(static_cast<std::uint64_t>(used), "level");
}

}  // namespace

std::string verdict(const CalibrateResult& result) {
  if (!result.stress_life) {
    return "No life law could be fitted to this campaign." + caution(result);
  }
  const life_law::LifeLaw& law = result.stress_life->law;
  std::string text = fmt::format(
      "Life falls with effective tension to the power of {} (95\u00a0% {}), with Weibull shape {}",
      number_text(law.exponent), interval_text(result.stress_life->exponent_ci95, 3),
      number_text(law.shape));
  if (result.use_levels.empty()) {
    text += ".";
  } else {
    const calibrate::UseLevel& use = result.use_levels.front();
    text += fmt::format("; {} at {}: mean life {} cycles ({}), B10 {} ({}).", use.name,
                        quantity_text(use.effective_tension_N, "N"), number_text(use.mean),
                        interval_text(use.mean_ci95, 3), number_text(use.b10),
                        interval_text(use.b10_ci95, 3));
  }
  return text + caution(result);
}

std::string origin(const CalibrateResult& result) {
  std::string text =
      fmt::format("{} to fit: {} failed, {} suspended. {} in the life law.",
                  counted_text(result.specimens, "specimen"), count_text(result.failed),
                  count_text(result.suspended), levels_used(result));
  if (result.in_blocks > 0) {
    text += fmt::format(" {} loaded in blocks.", counted_text(result.in_blocks, "specimen"));
  }
  return text + fmt::format(" Simulated p-values and bands: {}, seed {}.",
                            counted_text(result.bootstraps, "replicate"), result.seed);
}

std::vector<std::string> shape_words(const CalibrateResult& result) {
  std::vector<std::string> words;
  if (!result.common_shape) {
    words.emplace_back("With fewer than two levels there is no common shape to test.");
    return words;
  }
  const calibrate::CommonShape& shape = *result.common_shape;
  add_test(words, shape.homogeneity, "One shape for the levels of the life law is not rejected",
           "One shape for the levels of the life law is rejected",
           "One shape for the levels of the life law could not be tested.");
  if (shape.with_all_levels) {
    add_test(words, shape.with_all_levels,
             "With the left-out levels it would not be rejected either",
             "With the left-out levels it would be rejected",
             "It could not be tested with the left-out levels.");
  }
  return words;
}

std::vector<std::string> adequacy_words(const CalibrateResult& result) {
  std::vector<std::string> words;
  if (!result.stress_life) {
    words.emplace_back("There is no law to test.");
    return words;
  }
  const calibrate::StressLife& law = *result.stress_life;
  add_test(words, law.against_free_levels,
           "The straight line in log-log is not rejected against levels that are free of it",
           "The straight line in log-log is rejected: levels free of it fit better",
           "The straight line could not be tested against free levels.");
  add_test(words, law.against_curvature, "No bend of the law in log-log is seen",
           "The law bends: a curved law fits better", "The law could not be tested for curvature.");
  add_test(words, law.against_growing_scatter, "No change of the scatter with tension is seen",
           "Scatter changes with tension: one shape for all is not enough",
           "The law could not be tested for scatter that changes with tension.");
  return words;
}

std::vector<std::string> left_out_words(const CalibrateResult& result) {
  std::vector<std::string> words;
  for (const LevelResult& level : result.levels) {
    if (kind_of(level) == LevelKind::left_out) {
      words.push_back(fmt::format("{} is left out: {}.", level.name(), level.left_out));
    }
  }
  return words;
}

std::vector<std::string> validation_words(const CalibrateResult& result) {
  std::vector<std::string> words;
  for (const calibrate::ValidationResult& validation : result.validation) {
    const std::string name =
        validation.in_blocks ? "Specimens in blocks" : result.levels.at(validation.level).name();
    words.push_back(fmt::format("{}: {}.", name, validation.words));
  }
  return words;
}

}  // namespace host_sim::calibrate_page

namespace host_sim::calibrate_page::captions {
namespace {

/// Specimens in blocks have no tension to stand at.
std::string blocks_note(const calibrate::CalibrateResult& result) {
  return result.in_blocks == 0
             ? std::string()
             : fmt::format(" {} in blocks cannot stand at one tension and are not drawn.",
                           counted_text(result.in_blocks, "specimen"));
}

}  // namespace

std::string lives(const calibrate::CalibrateResult& result) {
  return "Lives fall from level to level as the tension rises. Open signs with an arrow did not "
         "fail: they live longer than shown. Stars are the mean lives." +
         blocks_note(result);
}

std::string densities() {
  return "Each curve is a level's Weibull fit, the star its mean life and the strokes at the foot "
         "its failures. Curves farther left wear out sooner; narrow ones scatter less. Dashed: not "
         "in the life law.";
}

std::string scale_by_tension() {
  return "Scale parameters with 95\u00a0% intervals, bend angles written above. They follow the "
         "life law where the intervals touch its line.";
}

std::string scale_by_angle() {
  return "The same scale parameters over the bend angle: friction makes the tension, and so the "
         "wear, grow with the angle.";
}

std::string common_shape(const calibrate::CalibrateResult& result) {
  if (!result.common_shape) {
    return "The failures of all levels; there is no common shape to draw.";
  }
  return fmt::format(
      "Parallel lines have the common shape {}. A level whose points are less steep "
      "scatters more than the others.",
      number_text(result.common_shape->value));
}

std::string stress_life(const calibrate::CalibrateResult& result) {
  return "About eight in ten specimens of each level should lie between B10 and B90. Validation "
         "and "
         "left-out specimens did not shape the law." +
         blocks_note(result);
}

std::string stress_life_log() {
  return "The same with logarithmic axes, where the law is a straight line; specimens that bend "
         "away from it at one end are evidence against it.";
}

std::string use() {
  return "What the law says where it will be used: the bar with caps is for the life of one more "
         "specimen, the thick one for the mean. Filled squares are measured means of validation "
         "levels; the open ones beside them are predicted.";
}

std::string use_log() {
  return "The same with logarithmic axes: the farther a use level lies from the tested tensions, "
         "the wider its bars.";
}

}  // namespace host_sim::calibrate_page::captions
