#include "host_sim/report/calibrate/charts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "tests/report/calibrate/sample_result.hpp"

namespace host_sim::calibrate_page {
namespace {

using testing::Contains;
using testing::Each;
using testing::ElementsAre;

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

bool has_layer(const Chart& chart, const std::string& name) {
  return std::any_of(chart.layers.begin(), chart.layers.end(),
                     [&name](const Layer& layer) { return layer.name == name; });
}

TEST(LivesChart, ShowsEverySpecimenOnceAndWhatItIs) {
  const Chart chart = lives_chart(samples::paper_like());
  EXPECT_THAT(chart.x.categories, ElementsAre("315\u00b0\n42.5\u00a0N", "360\u00b0\n50.8\u00a0N",
                                              "405\u00b0\n60.1\u00a0N", "450\u00b0\n71\u00a0N",
                                              "540\u00b0\n99.8\u00a0N", "270\u00b0\n35.2\u00a0N"));
  EXPECT_EQ(layer_of(chart, "Failed").y.size(), 79U);
  EXPECT_EQ(layer_of(chart, "Suspended: lives longer").y.size(), 1U);
  EXPECT_EQ(layer_of(chart, "Failed, validation").y.size(), 19U);
  EXPECT_EQ(layer_of(chart, "Suspended, validation").y.size(), 1U);
  EXPECT_EQ(layer_of(chart, "Failed, left out").y.size(), 20U);
}

TEST(LivesChart, TellsSuspendedAndLeftOutApartByShape) {
  const Chart chart = lives_chart(samples::paper_like());
  const Layer failed = layer_of(chart, "Failed");
  const Layer suspended = layer_of(chart, "Suspended: lives longer");
  EXPECT_TRUE(failed.filled);
  EXPECT_EQ(failed.arrow, Layer::Arrow::none);
  EXPECT_FALSE(suspended.filled);
  EXPECT_EQ(suspended.arrow, Layer::Arrow::up);
  const std::set<std::string_view> shapes = {failed.shape,
                                             layer_of(chart, "Failed, validation").shape,
                                             layer_of(chart, "Failed, left out").shape,
                                             layer_of(chart, "Mean life of the Weibull fit").shape};
  EXPECT_EQ(shapes.size(), 4U);
}

TEST(LivesChart, EqualLivesStandBesideEachOther) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.levels.resize(1);
  result.levels[0].sample = {{700, true}, {700, true}, {700, true}};
  const Layer failed = layer_of(lives_chart(result), "Failed");
  EXPECT_EQ(std::set<double>(failed.x.begin(), failed.x.end()).size(), 3U);
  for (const double x : failed.x) {
    EXPECT_LT(std::abs(x), 0.3);
  }
}

TEST(DensityChart, DrawsEquation15) {
  const Chart chart = density_chart(samples::paper_like());
  const Layer curve = layer_of(chart, "315 deg, 42.5 N");
  double area = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const double ratio = curve.x[i] / 854;
    const double density = 4.79 / 854 * std::pow(ratio, 3.79) * std::exp(-std::pow(ratio, 4.79));
    EXPECT_NEAR(curve.y[i], density, 1e-12);
    if (i > 0) {
      area += (curve.y[i] + curve.y[i - 1]) / 2 * (curve.x[i] - curve.x[i - 1]);
    }
  }
  EXPECT_NEAR(area, 0.998, 1e-4);
  EXPECT_FALSE(curve.dashed);
  EXPECT_TRUE(layer_of(chart, "540 deg, 99.8 N (left out)").dashed);
  EXPECT_EQ(layer_of(chart, "540 deg, 99.8 N (left out)").colour, "muted");
}

TEST(StressLifeChart, DrawsTheLaw) {
  const Chart chart = stress_life_chart(samples::paper_like(), StressLifeAxes::logarithmic);
  const Layer mean = layer_of(chart, "Mean life");
  const Layer b10 = layer_of(chart, "B10 (10 % broken)");
  const Layer b90 = layer_of(chart, "B90 (90 % broken)");
  const Layer squares = layer_of(chart, "Mean life by least squares");
  for (std::size_t i = 0; i < mean.x.size(); ++i) {
    const double alpha = 2.06e5 / std::pow(mean.x[i], 1.457);
    EXPECT_NEAR(mean.y[i], alpha * std::tgamma(1 + 1 / 5.79), 1e-6);
    EXPECT_NEAR(b10.y[i], alpha * std::pow(-std::log(0.9), 1 / 5.79), 1e-6);
    EXPECT_NEAR(b90.y[i], alpha * std::pow(-std::log(0.1), 1 / 5.79), 1e-6);
    EXPECT_NEAR(squares.y[i], 1.53e5 / std::pow(mean.x[i], 1.38) * std::tgamma(1 + 1 / 5.94), 1e-6);
  }
  EXPECT_TRUE(squares.dashed);
  EXPECT_FALSE(mean.dashed);
  EXPECT_LT(mean.x.front(), 35.2);
  EXPECT_GT(mean.x.back(), 99.8);
}

TEST(StressLifeChart, NamesWhatIsLeftOut) {
  const Chart chart = stress_life_chart(samples::paper_like(), StressLifeAxes::linear);
  EXPECT_EQ(layer_of(chart, "Failed, left out").colour, "muted");
  const auto labels =
      std::find_if(chart.layers.begin(), chart.layers.end(),
                   [](const Layer& layer) { return layer.kind == Layer::Kind::labels; });
  ASSERT_NE(labels, chart.layers.end());
  EXPECT_THAT(labels->texts, ElementsAre("540\u00b0 left out"));
  EXPECT_EQ(layer_of(chart, "Suspended: lives longer").arrow, Layer::Arrow::up);
}

TEST(StressLifeChart, TheBandGoesForthAndBack) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.stress_life->band_tension_N = {40, 50, 60};
  result.stress_life->band_mean = {{700, 900}, {600, 700}, {450, 550}};
  const Layer band =
      layer_of(stress_life_chart(result, StressLifeAxes::linear), "95 % band of the mean");
  EXPECT_THAT(band.x, ElementsAre(40, 50, 60, 60, 50, 40));
  EXPECT_THAT(band.y, ElementsAre(900, 700, 550, 450, 600, 700));
}

TEST(UseChart, TheBandGoesOverAllUseLevels) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.stress_life->tested_N = {34, 110};
  result.stress_life->band_tension_N = {24, 40, 50, 60};
  result.stress_life->band_mean = {{900, 2000}, {700, 900}, {600, 700}, {450, 550}};
  EXPECT_THAT(layer_of(use_chart(result, StressLifeAxes::linear), "95 % band of the mean").x,
              ElementsAre(24, 40, 50, 60, 60, 50, 40, 24));
  EXPECT_THAT(
      layer_of(stress_life_chart(result, StressLifeAxes::linear), "95 % band of the mean").x,
      ElementsAre(40, 50, 60, 60, 50, 40))
      << "what was tested alone";
}

TEST(AllCharts, TellTheNameOfASpecimen) {
  const calibrate::CalibrateResult result = samples::paper_like();
  EXPECT_EQ(layer_of(lives_chart(result), "Failed").texts[1], "wire 2");
  EXPECT_EQ(layer_of(stress_life_chart(result, StressLifeAxes::linear), "Failed").texts[2],
            "wire 3, 315 deg, 42.5 N");
  EXPECT_EQ(layer_of(probability_chart(result, 0), "Failed").texts[19], "wire 20");
  EXPECT_EQ(layer_of(probability_chart(result, 1), "Suspended: lives longer").texts[0], "wire 20");
}

TEST(StressLifeChart, WithoutALawShowsTheSpecimens) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.stress_life.reset();
  const Chart chart = stress_life_chart(result, StressLifeAxes::linear);
  EXPECT_FALSE(has_layer(chart, "Mean life"));
  EXPECT_EQ(layer_of(chart, "Failed").x.size(), 79U);
  EXPECT_TRUE(use_chart(result, StressLifeAxes::linear).layers.empty());
}

TEST(UseChart, ShowsPredictedAndMeasured) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.use_levels[0].next_specimen_95 = {500, 1250};
  result.use_levels[0].mean_ci95 = {830, 950};
  result.use_levels.resize(1);
  const Chart chart = use_chart(result, StressLifeAxes::logarithmic);
  const Layer next = layer_of(chart, "One more specimen, 95 %");
  EXPECT_THAT(next.x, ElementsAre(39.9));
  EXPECT_THAT(next.y, ElementsAre(500));
  EXPECT_THAT(next.high, ElementsAre(1250));
  EXPECT_THAT(layer_of(chart, "Mean life, 95 %").high, ElementsAre(950));
  EXPECT_THAT(layer_of(chart, "Predicted mean at a validation level").y, ElementsAre(1044));
  EXPECT_THAT(layer_of(chart, "Measured mean at a validation level").y, ElementsAre(993));
}

TEST(ProbabilityChart, TheSlopeOfTheLineIsTheShape) {
  const Chart chart = probability_chart(samples::paper_like(), 0);
  const Layer line = layer_of(chart, "Weibull fit");
  const auto place = [](double p) { return std::log(-std::log1p(-p)); };
  EXPECT_NEAR((place(line.y[1]) - place(line.y[0])) / std::log(line.x[1] / line.x[0]), 4.79, 1e-9);
  EXPECT_EQ(chart.y.kind, Axis::Kind::weibull);
  EXPECT_EQ(layer_of(chart, "Failed").x.size(), 20U);
  EXPECT_FALSE(has_layer(chart, "Suspended: lives longer"));
  EXPECT_EQ(layer_of(probability_chart(samples::paper_like(), 1), "Suspended: lives longer").arrow,
            Layer::Arrow::right);
}

TEST(CommonShapeChart, TheLinesOfTheLevelsAreParallel) {
  const Chart chart = common_shape_chart(samples::paper_like());
  std::vector<double> ratios;
  for (const Layer& layer : chart.layers) {
    if (layer.kind == Layer::Kind::line) {
      ratios.push_back(layer.x.at(1) / layer.x.at(0));
    }
  }
  ASSERT_EQ(ratios.size(), 4U);
  EXPECT_THAT(ratios, Each(testing::DoubleNear(ratios[0], 1e-9)));
}

TEST(ScaleCharts, ShowIntervalsAndOnlyAnglesThatThereAre) {
  calibrate::CalibrateResult result = samples::paper_like();
  const Chart chart = scale_by_tension_chart(result);
  EXPECT_THAT(layer_of(chart, "Scale, fitted level").y, ElementsAre(854, 675, 551, 407));
  const auto bars = std::find_if(chart.layers.begin(), chart.layers.end(), [](const Layer& layer) {
    return layer.kind == Layer::Kind::bars;
  });
  ASSERT_NE(bars, chart.layers.end());
  EXPECT_NEAR(bars->y[0], 854 / 1.06, 1e-9);
  EXPECT_NEAR(bars->high[0], 854 * 1.06, 1e-9);
  for (calibrate::LevelResult& level : result.levels) {
    level.load.bend_angle_deg.reset();
  }
  EXPECT_TRUE(scale_by_angle_chart(result).layers.empty());
}

TEST(Charts, HaveIdsOfTheirOwn) {
  std::set<std::string> ids;
  for (const Chart& chart : charts(samples::paper_like())) {
    EXPECT_TRUE(ids.insert(chart.id).second) << chart.id;
  }
  EXPECT_THAT(ids, Contains("probability-5"));
}

}  // namespace
}  // namespace host_sim::calibrate_page
