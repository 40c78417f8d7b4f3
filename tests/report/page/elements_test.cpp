#include "host_sim/report/page/elements.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "host_sim/report/page/chart.hpp"

namespace host_sim {
namespace {

TEST(HtmlEscape, EscapesWhatEndsTextOrAttribute) {
  EXPECT_EQ(html_escape(R"(<a href="x">&'</a>)"),
            "&lt;a href=&quot;x&quot;&gt;&amp;&#39;&lt;/a&gt;");
}

TEST(HtmlEscape, KeepsLettersOfEveryScript) {
  EXPECT_EQ(html_escape("Überlast 腕 🦾"), "Überlast 腕 🦾");
}

TEST(HtmlEscape, ReplacesWhatIsNoText) {
  EXPECT_EQ(html_escape("a\xff\x01z"), "a\ufffd\ufffdz");
  EXPECT_EQ(html_escape("tab\tline\n"), "tab\tline\n");
}

TEST(ScriptJson, CannotEndItsElement) {
  EXPECT_EQ(script_json("</script><!--&"), "\"\\u003c/script\\u003e\\u003c!--\\u0026\"");
  EXPECT_EQ(nlohmann::json::parse(script_json("</script><!--&")), "</script><!--&");
}

TEST(ScriptJson, HasNullForNumbersThatAreNotFinite) {
  EXPECT_EQ(script_json({{"a", std::numeric_limits<double>::infinity()},
                         {"b", std::numeric_limits<double>::quiet_NaN()}}),
            R"({"a":null,"b":null})");
}

RC_GTEST_PROP(EscapeProperty, NoBytesBreakOut, (const std::string& bytes)) {
  const std::string html = html_escape(bytes);
  RC_ASSERT(html.find_first_of("<>\"'") == std::string::npos);
  const std::string script = script_json(bytes);
  RC_ASSERT(script.find_first_of("<>&") == std::string::npos);
  RC_ASSERT(std::all_of(script.begin(), script.end(), [](char c) { return c >= ' ' && c <= '~'; }));
}

TEST(Table, NamesRowsAndColumnsForScreenReaders) {
  Table table("Lives", {"Level", "Mean"});
  table.row("a", {"1"});
  EXPECT_EQ(table.html(),
            "<div class=\"table\" tabindex=\"0\" role=\"region\" aria-label=\"Lives\">\n"
            "<table>\n<thead><tr><th scope=\"col\">Level</th>"
            "<th scope=\"col\" class=\"number\">Mean</th></tr></thead>\n<tbody>\n"
            "<tr><th scope=\"row\">a</th><td class=\"number\">1</td></tr>\n"
            "</tbody>\n</table>\n</div>\n");
}

TEST(Table, LetsTextsBreak) {
  Table table("Lives", {"Level", "Lives"}, Table::Cells::texts);
  table.row("b", {"one, two"});
  EXPECT_EQ(table.html().find("class=\"number\""), std::string::npos);
  EXPECT_NE(table.html().find("<th scope=\"row\">b</th><td>one, two</td>"), std::string::npos);
}

TEST(Table, EscapesEveryText) {
  Table table("<a>", {"<b>", "<c>"});
  table.row("<d>", {"<e>"});
  EXPECT_EQ(table.html().find("<d>"), std::string::npos);
  EXPECT_NE(table.html().find("&lt;e&gt;"), std::string::npos);
  EXPECT_NE(table.html().find("aria-label=\"&lt;a&gt;\""), std::string::npos);
}

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
