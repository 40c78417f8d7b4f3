#include "host_sim/report/calibrate/captions.hpp"

#include <fmt/format.h>

#include "host_sim/report/page/number_text.hpp"

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
         "away from it at one end speak against it.";
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
