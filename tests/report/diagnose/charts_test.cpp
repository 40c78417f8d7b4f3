#include "host_sim/report/diagnose/charts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "host_sim/report/diagnose/captions.hpp"
#include "tests/report/diagnose/sample_diagnosis.hpp"

namespace host_sim::diagnose_page {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The layer of this name and kind; fails the test and gives an empty one where there is none.
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
  for (const Layer& layer : chart.layers) {
    if (layer.name == name) {
      return true;
    }
  }
  return false;
}

TEST(TraceError, IsTheRootOfTheMeanSquare) {
  EXPECT_DOUBLE_EQ(rmse_N({1, 2, 3, 4}, {4, 2, 3, 0}), 2.5);  // sqrt((9 + 16) / 4)
  EXPECT_TRUE(std::isnan(rmse_N({}, {})));
  EXPECT_TRUE(std::isnan(rmse_N({1, 2}, {1})));
}

TEST(WorstTraces, ComeFirstAndThoseWithoutALineLast) {
  diagnose::TensionDiagnosis tension;
  tension.traces = {{"a", {}, {}, {1, 1}, {2, 2}, {}},
                    {"b", {}, {}, {1, 1}, {}, {}},
                    {"c", {}, {}, {1, 1}, {5, 5}, {}},
                    {"d", {}, {}, {1, 1}, {2, 2}, {}}};
  EXPECT_THAT(worst_traces(tension, 4), ElementsAre(2, 0, 3, 1));
  EXPECT_THAT(worst_traces(tension, 1), ElementsAre(2));
}

TEST(TraceChart, ShowsMeasuredAndBothModels) {
  const diagnose::Diagnosis diagnosis = samples::wear_named();
  const diagnose::TracePicture& trace = diagnosis.tension->traces[5];
  const Chart chart = trace_chart(*diagnosis.tension, 5);
  EXPECT_EQ(layer_of(chart, "Measured").y, trace.measured_N);
  EXPECT_EQ(layer_of(chart, "Nominal model").y, trace.before_N);
  EXPECT_EQ(layer_of(chart, "Extended model").y, trace.after_N);
  EXPECT_EQ(layer_of(chart, "Measured").x, trace.time_s);
  EXPECT_NE(layer_of(chart, "Nominal model").dashed, layer_of(chart, "Extended model").dashed);
}

TEST(TraceChart, NoLineCrossesATimeWithoutSamples) {
  diagnose::TensionDiagnosis tension;
  tension.traces = {{"a", {0, 1, 2, 9, 10}, {1, 2, 3, 4, 5}, {5, 6, 7, 8, 9}, {1, 1, 1, 1, 1}, {}}};
  for (const Chart& chart : {trace_chart(tension, 0), loop_chart(tension, 0)}) {
    const Layer measured = layer_of(chart, "Measured");
    ASSERT_EQ(measured.y.size(), 6U);
    EXPECT_TRUE(std::isnan(measured.x[3]) && std::isnan(measured.y[3])) << chart.id;
    EXPECT_EQ(measured.y[2], 7);
    EXPECT_EQ(measured.y[4], 8);
    EXPECT_EQ(layer_of(chart, "Nominal model").y.size(), 6U);
  }
}

TEST(Gaps, AreLongerThanThreeUsualIntervals) {
  EXPECT_THAT(gaps_in({0, 1, 2, 5, 6, 9.1, 10}), ElementsAre(5));
  EXPECT_THAT(gaps_in({0, 1}), ElementsAre());
  EXPECT_THAT(gaps_in({}), ElementsAre());
}

/// A trace of cos and sin of as many cycles as `cycles`, 100 samples each, and noise.
diagnose::TracePicture circles(double cycles) {
  diagnose::TracePicture trace;
  trace.session = "a";
  for (int i = 0; i < static_cast<int>(100 * cycles); ++i) {
    const double phase = 2 * std::numbers::pi * i / 100;
    trace.time_s.push_back(0.1 * i);
    trace.input_N.push_back(20 - 10 * std::cos(phase) + (i % 2 == 0 ? 1 : -1));
    trace.measured_N.push_back(20 + 10 * std::sin(phase));
  }
  return trace;
}

TEST(Loop, IsOfTwoCyclesFromTheMiddleWithArrows) {
  diagnose::TensionDiagnosis tension;
  tension.traces = {circles(7)};
  // It rises in each of seven cycles: of the six whole ones two are left out before and after.
  const Stretch stretch = cycles_in(tension.traces[0].input_N);
  EXPECT_EQ(stretch.last - stretch.first, 201U);
  EXPECT_EQ(stretch.first / 100, 2U);
  const Chart chart = loop_chart(tension, 0);
  EXPECT_EQ(layer_of(chart, "Measured").x.size(), 201U);
  EXPECT_GT(layer_of(chart, "Measured").heads, 0);
  EXPECT_EQ(layer_of(trace_chart(tension, 0), "Measured").heads, 0);
  EXPECT_EQ(layer_of(trace_chart(tension, 0), "Measured").x.size(), 700U);
}

TEST(Loop, IsOfOneCycleOrOfAllWhereThereAreNoTwo) {
  EXPECT_EQ(cycles_in(circles(2).input_N).last - cycles_in(circles(2).input_N).first, 101U);
  EXPECT_EQ(cycles_in(circles(1).input_N).last, 100U);
  EXPECT_EQ(cycles_in({}).last, 0U);
  EXPECT_EQ(cycles_in({5, 5, 5}).last, 3U);
}

TEST(CauseChart, IsTheLoopWithoutAndWithTheCause) {
  diagnose::TensionDiagnosis tension;
  tension.causes = {{"friction_preload", circles(7)}};
  diagnose::TracePicture& trace = tension.causes[0].trace;
  trace.before_N.assign(trace.time_s.size(), 20);
  trace.after_N = trace.measured_N;
  const Chart chart = cause_chart(tension, 0);
  EXPECT_EQ(chart.id, "cause-0");
  EXPECT_EQ(layer_of(chart, "Measured").x.size(), 201U) << "two cycles";
  EXPECT_TRUE(layer_of(chart, "Without friction_preload").dashed);
  EXPECT_GT(layer_of(chart, "Without friction_preload").heads, 0);
  EXPECT_EQ(layer_of(chart, "With friction_preload").y, layer_of(chart, "Measured").y);
  // 10 sin of a whole cycle about 20 N: 10 / sqrt(2) = 7.07 N without, nothing with it.
  EXPECT_THAT(captions::cause(tension, 0),
              HasSubstr("is 7.07\u00a0N (RMSE) without it, 0\u00a0N with it."));
}

TEST(TraceChart, WithoutAnExtensionHasNoLineOfIt) {
  const diagnose::Diagnosis diagnosis = samples::nothing_wrong();
  EXPECT_FALSE(has_layer(trace_chart(*diagnosis.tension, 0), "Extended model"));
}

TEST(RemainderChart, HasMeansAndTheScatterOfSessionsOfBothModels) {
  diagnose::TensionDiagnosis tension;
  tension.remainders = {{"output tension", "N", -1, {0, 10}, {5, -3}, {1, 2}, {0.5, 0.2}, {0, 1}}};
  Chart chart = remainder_chart(tension, 0);
  EXPECT_EQ(chart.name, "What remains over output tension, while letting go");
  EXPECT_EQ(chart.x.label, "output tension, N");
  EXPECT_THAT(layer_of(chart, "Nominal model").y, ElementsAre(5, -3));
  const Layer bars = layer_of(chart, "Nominal model, \u00b1 1 standard deviation of sessions");
  EXPECT_THAT(bars.y, ElementsAre(4, -5));
  EXPECT_THAT(bars.high, ElementsAre(6, -1));
  EXPECT_THAT(layer_of(chart, "As far as the catalogue goes").y, ElementsAre(0.5, 0.2));
  tension.findings.extensions = {{"slack", {}}};
  EXPECT_TRUE(has_layer(remainder_chart(tension, 0), "Extended model"));
  tension.remainders[0].after_N = tension.remainders[0].before_N;
  EXPECT_FALSE(has_layer(remainder_chart(tension, 0), "Extended model"));
  tension.remainders[0].direction = 1;
  EXPECT_EQ(remainder_chart(tension, 0).name, "What remains over output tension, while pulling");
}

TEST(SessionChart, HasAPointForEachSessionByItsName) {
  diagnose::TensionDiagnosis tension;
  EXPECT_TRUE(session_chart(tension, SessionParameter::gain).layers.empty());
  tension.session_refits = {{"a", 0.1, 0.02}, {"b", 0.3, -0.01}};
  const Chart friction = session_chart(tension, SessionParameter::friction);
  ASSERT_EQ(friction.layers.size(), 1U);
  EXPECT_EQ(friction.layers[0].kind, Layer::Kind::points);
  EXPECT_THAT(friction.x.categories, ElementsAre("a", "b"));
  EXPECT_THAT(friction.layers[0].x, ElementsAre(0, 1));
  EXPECT_THAT(friction.layers[0].y, ElementsAre(0.1, 0.3));
  EXPECT_THAT(session_chart(tension, SessionParameter::gain).layers[0].y, ElementsAre(0.02, -0.01));
}

TEST(StepsChart, IsAStaircaseWithATreadForEachModel) {
  const Chart chart = steps_chart(samples::explained_in_part().tension->findings);
  EXPECT_THAT(chart.x.categories, ElementsAre("Nominal\nmodel", "slack", "friction\nposition"));
  EXPECT_TRUE(chart.y.from_zero);
  EXPECT_THAT(layer_of(chart, "Output tension from input tension").y, ElementsAre(8.4, 6.7, 5.9));
  EXPECT_THAT(layer_of(chart, "Input tension from output tension").y, ElementsAre(5.8, 4.2, 3.9));
  EXPECT_THAT(chart.layers[0].x, ElementsAre(-0.5, 0.5, 0.5, 1.5, 1.5, 2.5));
  EXPECT_THAT(chart.layers[0].y, ElementsAre(8.4, 8.4, 6.7, 6.7, 5.9, 5.9));
  EXPECT_TRUE(steps_chart({}).layers.empty());
}

TEST(GainChart, GoesDownFromTheNominalToTheExtendedModel) {
  const Chart chart = gain_chart(
      {"session",
       {{"rmse_N", 1.2, 0.3}, {"log_predictive_density", 2, 3}, {"input_rmse_N", 1.5, 0.4}}});
  EXPECT_THAT(layer_of(chart, "Output tension from input tension").y, ElementsAre(1.2, 0.3));
  EXPECT_THAT(layer_of(chart, "Input tension from output tension").y, ElementsAre(1.5, 0.4));
  EXPECT_EQ(chart.layers.size(), 4U);
  EXPECT_TRUE(gain_chart({"level", {{"b10_coverage", 0.2, 0.1}}}).layers.empty());
}

TEST(WeibullChart, TheSlopeOfALineIsTheShape) {
  const diagnose::Diagnosis diagnosis = samples::lots_named();
  const Chart chart = weibull_chart(*diagnosis.lives);
  const auto place = [](double p) { return std::log(-std::log1p(-p)); };
  for (const auto& [name, shape] :
       {std::pair{"Nominal model says", 3.9}, std::pair{"Extended model says", 5.8}}) {
    const Layer line = layer_of(chart, name);
    EXPECT_NEAR((place(line.y[1]) - place(line.y[0])) / std::log(line.x[1] / line.x[0]), shape,
                1e-9);
  }
  // One of the 48 is suspended.
  EXPECT_EQ(layer_of(chart, "Failed, over the life of the nominal model").x.size(), 47U);
  EXPECT_EQ(layer_of(chart, "Failed, over the life of the extended model").x.size(), 47U);
}

TEST(WeibullChart, PlacesFailuresAtTheirMedianRank) {
  diagnose::LifeDiagnosis lives;
  lives.picture.points = {
      {"a", "1", 40, 2, 9, true}, {"b", "1", 40, 1, 9, true}, {"c", "1", 40, 3, 9, true}};
  const Layer failed = layer_of(weibull_chart(lives), "Failed, over the life of the nominal model");
  EXPECT_THAT(failed.x, ElementsAre(1, 2, 3));
  // Benard: (i - 0.3) / (n + 0.4)
  EXPECT_NEAR(failed.y[0], 0.7 / 3.4, 1e-12);
  EXPECT_NEAR(failed.y[2], 2.7 / 3.4, 1e-12);
}

TEST(RatioChart, TellsLotsApartWhereTheyAreFew) {
  diagnose::Diagnosis diagnosis = samples::lots_named();
  const Chart chart = ratio_chart(*diagnosis.lives, Model::extended);
  EXPECT_EQ(layer_of(chart, "Failed, lot B").x.size(), 16U);
  EXPECT_EQ(layer_of(chart, "Failed, lot A").x.size(), 15U);
  EXPECT_EQ(layer_of(chart, "Suspended: lives longer, lot A").arrow, Layer::Arrow::up);
  EXPECT_NE(layer_of(chart, "Failed, lot A").colour, layer_of(chart, "Failed, lot B").colour);
  int lot = 0;
  for (diagnose::LifePoint& point : diagnosis.lives->picture.points) {
    point.lot = std::to_string(lot++ % 7);
  }
  EXPECT_EQ(layer_of(ratio_chart(*diagnosis.lives, Model::nominal), "Failed").x.size(), 47U);
}

TEST(RatioChart, DoesNotSayLotTwice) {
  diagnose::Diagnosis diagnosis = samples::lots_named();
  for (diagnose::LifePoint& point : diagnosis.lives->picture.points) {
    point.lot = "lot" + point.lot;
  }
  EXPECT_TRUE(has_layer(ratio_chart(*diagnosis.lives, Model::nominal), "Failed, lotB"));
}

TEST(RatioChart, OfTheExtendedModelNeedsAnExtension) {
  diagnose::Diagnosis diagnosis = samples::lots_named();
  diagnosis.lives->findings.extensions.clear();
  EXPECT_TRUE(ratio_chart(*diagnosis.lives, Model::extended).layers.empty());
  EXPECT_FALSE(ratio_chart(*diagnosis.lives, Model::nominal).layers.empty());
  EXPECT_FALSE(has_layer(weibull_chart(*diagnosis.lives), "Extended model says"));
}

TEST(DiagnosisCharts, HaveIdsOfTheirOwn) {
  std::set<std::string> ids;
  const auto all = charts(samples::both_named());
  for (const Chart& chart : all) {
    ids.insert(chart.id);
    EXPECT_FALSE(chart.x.label.empty()) << chart.id;
    EXPECT_FALSE(chart.y.label.empty()) << chart.id;
  }
  EXPECT_EQ(ids.size(), all.size());
}

}  // namespace
}  // namespace host_sim::diagnose_page
