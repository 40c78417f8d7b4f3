#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>

#include "host_sim/report/design/charts.hpp"
#include "host_sim/report/design/html.hpp"
#include "tests/report/design/samples.hpp"
#include "tests/report/page/page_text.hpp"

namespace host_sim {
namespace {

using testing::HasSubstr;

std::string page_of(const design::Study& study) {
  std::ostringstream out;
  write_design_report(out, samples::design_model(), study, {"5ed12218", {}}, "0.1.0");
  return out.str();
}

/// The layer of this name; fails the test and gives an empty one where there is none.
Layer layer_of(const Chart& chart, const std::string& name) {
  for (const Layer& layer : chart.layers) {
    if (layer.name == name) {
      return layer;
    }
  }
  ADD_FAILURE() << "no layer '" << name << "' in " << chart.id;
  return {};
}

TEST(DesignPage, IsSelfContained) {
  for (const samples::DesignSample& sample : samples::all_designs()) {
    EXPECT_EQ(page_text::reference_out_of(page_of(sample.study)), "") << sample.name;
  }
}

TEST(DesignPage, HasAPlaceAndDataForEachPlot) {
  for (const samples::DesignSample& sample : samples::all_designs()) {
    EXPECT_EQ(page_text::misplaced_plot(page_of(sample.study), sample.charts), "") << sample.name;
  }
}

TEST(DesignPage, SaysTheDesignInWordsAndNumbers) {
  const auto all = samples::all_designs();
  EXPECT_THAT(page_of(all[0].study), HasSubstr("Which tension has which life"));
  EXPECT_THAT(page_of(all[0].study), HasSubstr("A test at 60\u00a0N and 300\u00b0 lasts"));
  EXPECT_THAT(page_of(all[1].study), HasSubstr("Life has no end: nothing varies the tension"));
  EXPECT_THAT(page_of(all[2].study),
              HasSubstr("Safety: 1.27 times the tension or 1.54 times the life of 500 cycles"));
  EXPECT_THAT(page_of(all[2].study),
              HasSubstr("<td class=\"number\">1.267</td><td class=\"number\">1.54</td>"));
}

TEST(DesignCharts, MarkTheDesign) {
  const design::Study study = samples::all_designs()[2].study;
  const Layer design = layer_of(design_page::life_chart(study), "The design");
  EXPECT_EQ(design.x, std::vector<double>{49});
  EXPECT_NEAR(design.y.at(0), 770.081, 1e-3);
  const Layer wanted = layer_of(design_page::life_chart(study), "The wanted life");
  EXPECT_EQ(wanted.y, std::vector<double>{500});
}

TEST(DesignCharts, StressIsThatOfEquation11) {
  const design::Study study = samples::all_designs()[2].study;
  const Layer line = layer_of(design_page::stress_chart(samples::design_model(), study),
                              "Constant 49\u00a0N, the design");
  ASSERT_EQ(line.x.front(), 0);
  EXPECT_EQ(line.y.front(), 0);
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const double g = 0.128 * line.x[i] * std::acos(-1.0) / 180;
    const double ratio = 49 * std::cosh(g) / 177.4;
    EXPECT_NEAR(line.y[i], 49 * std::sinh(g) / (1 - ratio * ratio), 1e-9);
  }
  const Layer from_zero =
      layer_of(design_page::stress_chart(samples::design_model(), study), "From 0 to 49\u00a0N");
  EXPECT_NEAR(from_zero.y.front(), 24.5 / (1 - std::pow(24.5 / 177.4, 2)), 1e-9);
}

TEST(DesignCharts, AccelerationStartsAtTheDesign) {
  const design::Study study = samples::all_designs()[2].study;
  const Chart chart = design_page::acceleration_chart(samples::design_model(), study);
  EXPECT_DOUBLE_EQ(chart.layers.at(0).x.front(), 49);
  EXPECT_DOUBLE_EQ(chart.layers.at(0).y.front(), 1);
  EXPECT_GT(chart.layers.at(0).y.back(), 3);
}

}  // namespace
}  // namespace host_sim
