#include "host_sim/report/calibrate/stress_life_layers.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/report/calibrate/level_look.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page {
namespace {

using calibrate::CalibrateResult;
using calibrate::LevelResult;
using calibrate::StressLife;

/// The band as an outline: forth along its upper side and back along the lower one.
Layer mean_band(const StressLife& law) {
  Layer layer;
  layer.kind = Layer::Kind::area;
  layer.name = "95 % band of the mean";
  const std::size_t size = std::min(law.band_tension_N.size(), law.band_mean.size());
  for (std::size_t i = 0; i < 2 * size; ++i) {
    const std::size_t at = i < size ? i : 2 * size - 1 - i;
    const double life = i < size ? law.band_mean[at].high : law.band_mean[at].low;
    if (std::isfinite(life)) {
      layer.x.push_back(law.band_tension_N[at]);
      layer.y.push_back(life);
    }
  }
  return layer;
}

Layer named(Layer layer, std::string_view name, std::string_view colour, bool dashed,
            double width_px) {
  layer.name = name;
  layer.colour = colour;
  layer.dashed = dashed;
  layer.width_px = width_px;
  return layer;
}

void add_if_any(Chart& chart, Layer layer) {
  if (!layer.x.empty()) {
    chart.layers.push_back(std::move(layer));
  }
}

Layer specimens(const CalibrateResult& result, Part part, bool failed, std::string_view colour) {
  Layer layer = specimen_points(part, failed, colour);
  for (const LevelResult& level : result.levels) {
    for (const statistics::Observation& specimen : level.sample) {
      if (part_of(level) == part && specimen.failed == failed) {
        layer.x.push_back(level.load.effective_tension_N);
        layer.y.push_back(specimen.value);
        layer.texts.push_back(level.name());
      }
    }
  }
  return layer;
}

}  // namespace

void add_law(Chart& chart, const StressLife& law, TensionRange range) {
  constexpr double kThin = 1.5;
  constexpr double kThick = 2.5;
  const auto quantile = [&law](double p) {
    return [&law, p](double tension_N) { return law.law.quantile(p, tension_N); };
  };
  add_if_any(chart, mean_band(law));
  add_if_any(chart,
             named(law_line(range, quantile(0.9)), "B90 (90 % broken)", "level-3", false, kThin));
  add_if_any(
      chart,
      named(law_line(range, [&law](double tension_N) { return law.law.mean_life(tension_N); }),
            "Mean life", "line", false, kThick));
  add_if_any(chart,
             named(law_line(range, quantile(0.1)), "B10 (10 % broken)", "level-4", false, kThin));
  if (law.least_squares) {
    const life_law::LifeLaw& other = *law.least_squares;
    add_if_any(
        chart,
        named(law_line(range, [&other](double tension_N) { return other.mean_life(tension_N); }),
              "Mean life by least squares", "ink", true, kThin));
  }
}

void add_specimens(Chart& chart, const CalibrateResult& result) {
  struct Kind {
    Part part;
    bool failed;
    const char* colour;
    const char* name;
  };
  constexpr Kind kKinds[] = {{Part::left_out, true, "muted", "Failed, left out"},
                             {Part::left_out, false, "muted", "Suspended, left out"},
                             {Part::fitted, true, "line", "Failed"},
                             {Part::fitted, false, "line", "Suspended: lives longer"},
                             {Part::validation, true, "level-2", "Failed, validation"},
                             {Part::validation, false, "level-2", "Suspended, validation"}};
  for (const Kind& kind : kKinds) {
    Layer layer = specimens(result, kind.part, kind.failed, kind.colour);
    layer.name = kind.name;
    add_if_any(chart, std::move(layer));
  }
}

void add_left_out_names(Chart& chart, const CalibrateResult& result) {
  Layer labels;
  labels.kind = Layer::Kind::labels;
  labels.colour = "ink-soft";
  for (const LevelResult& level : result.levels) {
    if (part_of(level) == Part::left_out && !level.sample.empty()) {
      const auto longest =
          std::max_element(level.sample.begin(), level.sample.end(),
                           [](const auto& a, const auto& b) { return a.value < b.value; });
      labels.x.push_back(level.load.effective_tension_N);
      labels.y.push_back(longest->value);
      labels.texts.push_back((level.load.bend_angle_deg
                                  ? angle_text(*level.load.bend_angle_deg)
                                  : quantity_text(level.load.effective_tension_N, "N")) +
                             " left out");
    }
  }
  add_if_any(chart, std::move(labels));
}

}  // namespace host_sim::calibrate_page
