#include "host_sim/report/page/chart.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "host_sim/report/page/escape.hpp"

namespace host_sim {
namespace {

using nlohmann::json;

TEST(ChartJson, NamesKindsAsTheScriptReadsThem) {
  Chart chart;
  chart.x.kind = Axis::Kind::weibull;
  chart.y.kind = Axis::Kind::log;
  for (const Layer::Kind kind : {Layer::Kind::line, Layer::Kind::area, Layer::Kind::points,
                                 Layer::Kind::bars, Layer::Kind::rug, Layer::Kind::labels}) {
    Layer layer;
    layer.kind = kind;
    chart.layers.push_back(layer);
  }
  chart.layers[2].arrow = Layer::Arrow::up;
  const json data = chart_json(chart);
  EXPECT_EQ(data["x"]["kind"], "weibull");
  EXPECT_EQ(data["y"]["kind"], "log");
  json kinds = json::array();
  for (const json& layer : data["layers"]) {
    kinds.push_back(layer["kind"]);
  }
  EXPECT_EQ(kinds, json({"line", "area", "points", "bars", "rug", "labels"}));
  EXPECT_EQ(data["layers"][2]["arrow"], "up");
  EXPECT_EQ(data["layers"][0]["arrow"], "none");
}

TEST(ChartJson, HasNullForAnEndThatDoesNotExist) {
  Chart chart;
  Layer bars;
  bars.kind = Layer::Kind::bars;
  bars.x = {1};
  bars.y = {2};
  bars.high = {std::numeric_limits<double>::infinity()};
  chart.layers = {bars};
  const json data = json::parse(script_json(chart_json(chart)));
  EXPECT_TRUE(data["layers"][0]["high"][0].is_null());
  EXPECT_EQ(data["layers"][0]["y"][0], 2.0);
}

}  // namespace
}  // namespace host_sim
