#include "host_sim/report/calibrate/level_look.hpp"

#include <fmt/format.h>

namespace host_sim::calibrate_page {
namespace {

constexpr std::size_t kColours = 6;

}  // namespace

Part part_of(const calibrate::LevelResult& level) {
  if (level.role == Campaign::Role::validation) {
    return Part::validation;
  }
  return level.left_out.empty() ? Part::fitted : Part::left_out;
}

std::string_view shape_of(Part part) {
  switch (part) {
    case Part::validation:
      return "diamond";
    case Part::left_out:
      return "cross";
    case Part::fitted:
      break;
  }
  return "circle";
}

std::string colour_of(const calibrate::CalibrateResult& result, std::size_t level) {
  if (part_of(result.levels[level]) == Part::left_out) {
    return "muted";
  }
  return fmt::format("level-{}", level % kColours);
}

std::string title_of(const calibrate::LevelResult& level) {
  switch (part_of(level)) {
    case Part::validation:
      return level.name() + " (validation)";
    case Part::left_out:
      return level.name() + " (left out)";
    case Part::fitted:
      break;
  }
  return level.name();
}

bool has_fit(const calibrate::LevelResult& level) {
  return level.weibull().problem == statistics::FitProblem::none;
}

Layer specimen_points(Part part, bool failed, std::string_view colour) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.shape = shape_of(part);
  layer.colour = colour;
  layer.filled = failed;
  if (!failed) {
    layer.arrow = Layer::Arrow::up;
  }
  return layer;
}

}  // namespace host_sim::calibrate_page
