#include "host_sim/report/calibrate/notation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page {
namespace {

constexpr std::size_t kColours = 6;

}  // namespace

LevelKind kind_of(const calibrate::LevelResult& level) {
  if (level.role == Campaign::Role::validation) {
    return LevelKind::validation;
  }
  return level.left_out.empty() ? LevelKind::fitted : LevelKind::left_out;
}

std::string_view shape_of(LevelKind part) {
  switch (part) {
    case LevelKind::validation:
      return "diamond";
    case LevelKind::left_out:
      return "cross";
    case LevelKind::fitted:
      break;
  }
  return "circle";
}

std::string colour_of(const calibrate::CalibrateResult& result, std::size_t level) {
  if (kind_of(result.levels[level]) == LevelKind::left_out) {
    return "muted";
  }
  return fmt::format("level-{}", level % kColours);
}

std::string title_of(const calibrate::LevelResult& level) {
  switch (kind_of(level)) {
    case LevelKind::validation:
      return level.name() + " (validation)";
    case LevelKind::left_out:
      return level.name() + " (left out)";
    case LevelKind::fitted:
      break;
  }
  return level.name();
}

std::string specimen_text(const calibrate::LevelResult& level, std::size_t specimen) {
  return level.specimens.at(specimen) + ", " + level.name();
}

bool has_fit(const calibrate::LevelResult& level) {
  return level.weibull().problem == statistics::FitProblem::none;
}

bool is_point(const statistics::Observation& specimen, bool failed) {
  return !specimen.trimmed && (failed ? specimen.exact() : !specimen.failed);
}

Layer found_broken_bars() {
  Layer layer;
  layer.kind = Layer::Kind::bars;
  layer.name = "Found broken: life between inspections";
  layer.colour = "muted";
  return layer;
}

Layer specimen_points(LevelKind part, bool failed, std::string_view colour) {
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

std::string angle_text(double angle_deg) {
  return number_text(angle_deg, 4) + "\u00b0";
}

std::string interval_text(statistics::Interval interval, int significant) {
  const auto end = [significant](double value) {
    return std::isinf(value) ? std::string("no limit") : number_text(value, significant);
  };
  return fmt::format("{} to {}", end(interval.low), end(interval.high));
}

namespace {

/// Where a share stands on probability paper; 0 at the scale parameter.
double paper_place(double p) {
  return std::log(-std::log1p(-p));
}

}  // namespace

std::optional<statistics::Interval> scale_interval(const statistics::QuantileBand& band) {
  for (std::size_t i = 1; i < band.p.size(); ++i) {
    const double before = paper_place(band.p[i - 1]);
    const double after = paper_place(band.p[i]);
    if (before <= 0 && after >= 0 && before < after) {
      const double share = -before / (after - before);
      const auto between = [share](double from, double to) {
        return from * std::pow(to / from, share);
      };
      return statistics::Interval{between(band.low[i - 1], band.low[i]),
                                  between(band.high[i - 1], band.high[i])};
    }
  }
  return std::nullopt;
}

}  // namespace host_sim::calibrate_page
