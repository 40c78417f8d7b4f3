#include "host_sim/report/calibrate/charts.hpp"
#include "host_sim/report/calibrate/law_lines.hpp"
#include "host_sim/report/calibrate/level_look.hpp"
#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page {
namespace {

/// Neighbours stand beside each other, so that equal lives can be told apart.
double beside(std::size_t specimen) {
  constexpr std::size_t kColumns = 5;
  constexpr double kStep = 0.07;
  constexpr double kMiddle = 2;
  return (static_cast<double>(specimen % kColumns) - kMiddle) * kStep;
}

std::string category_of(const calibrate::LevelResult& level) {
  const std::string tension = quantity_text(level.load.effective_tension_N, "N");
  return level.load.bend_angle_deg ? angle_text(*level.load.bend_angle_deg) + "\n" + tension
                                   : tension;
}

Layer specimens(const calibrate::CalibrateResult& result, Part part, bool failed) {
  Layer layer = specimen_points(part, failed, part == Part::left_out ? "muted" : "line");
  if (part == Part::validation) {
    layer.colour = "level-2";
  }
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const calibrate::LevelResult& level = result.levels[i];
    for (std::size_t j = 0; part_of(level) == part && j < level.sample.size(); ++j) {
      if (level.sample[j].failed == failed) {
        layer.x.push_back(static_cast<double>(i) + beside(j));
        layer.y.push_back(level.sample[j].value);
      }
    }
  }
  return layer;
}

Layer means(const calibrate::CalibrateResult& result) {
  Layer layer;
  layer.kind = Layer::Kind::points;
  layer.name = "Mean life of the Weibull fit";
  layer.colour = "mark";
  layer.shape = "star";
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    if (has_fit(result.levels[i])) {
      layer.x.push_back(static_cast<double>(i));
      layer.y.push_back(result.levels[i].mean_life);
    }
  }
  return layer;
}

}  // namespace

Chart lives_chart(const calibrate::CalibrateResult& result) {
  struct Kind {
    Part part;
    bool failed;
    const char* name;
  };
  constexpr Kind kKinds[] = {{Part::fitted, true, "Failed"},
                             {Part::fitted, false, "Suspended: lives longer"},
                             {Part::validation, true, "Failed, validation"},
                             {Part::validation, false, "Suspended, validation"},
                             {Part::left_out, true, "Failed, left out"},
                             {Part::left_out, false, "Suspended, left out"}};
  Chart chart;
  chart.id = "lives";
  chart.name = "The life of every specimen";
  chart.x = {"Level", Axis::Kind::category, "", {}, false};
  chart.y = {"Life, cycles", Axis::Kind::linear, "cycles", {}, true};
  for (const calibrate::LevelResult& level : result.levels) {
    chart.x.categories.push_back(category_of(level));
  }
  for (const Kind& kind : kKinds) {
    Layer layer = specimens(result, kind.part, kind.failed);
    layer.name = kind.name;
    chart.layers.push_back(layer);
  }
  chart.layers.push_back(means(result));
  std::erase_if(chart.layers, [](const Layer& layer) { return layer.x.empty(); });
  return chart;
}

}  // namespace host_sim::calibrate_page
