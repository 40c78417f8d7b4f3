#include "host_sim/report/page/chart.hpp"

#include <array>
#include <cstddef>

namespace host_sim {
namespace {

using nlohmann::json;

constexpr std::array kAxisKinds = {"linear", "log", "weibull", "category"};
constexpr std::array kLayerKinds = {"line", "area", "points", "bars", "rug", "labels"};
constexpr std::array kArrows = {"none", "up", "right"};

template <typename Names, typename Enum>
const char* name_in(const Names& names, Enum value) {
  return names.at(static_cast<std::size_t>(value));
}

json axis_json(const Axis& axis) {
  return {{"label", axis.label},
          {"kind", name_in(kAxisKinds, axis.kind)},
          {"unit", axis.unit},
          {"categories", axis.categories},
          {"from_zero", axis.from_zero}};
}

json layer_json(const Layer& layer) {
  return {{"kind", name_in(kLayerKinds, layer.kind)},
          {"name", layer.name},
          {"colour", layer.colour},
          {"shape", layer.shape},
          {"filled", layer.filled},
          {"dashed", layer.dashed},
          {"width", layer.width_px},
          {"heads", layer.heads},
          {"arrow", name_in(kArrows, layer.arrow)},
          {"x", layer.x},
          {"y", layer.y},
          {"high", layer.high},
          {"texts", layer.texts}};
}

}  // namespace

json chart_json(const Chart& chart) {
  json layers = json::array();
  for (const Layer& layer : chart.layers) {
    layers.push_back(layer_json(layer));
  }
  return {{"name", chart.name},
          {"x", axis_json(chart.x)},
          {"y", axis_json(chart.y)},
          {"layers", layers}};
}

}  // namespace host_sim
