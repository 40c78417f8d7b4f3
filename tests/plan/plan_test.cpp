#include "host_sim/plan/plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/plan/theory.hpp"

namespace host_sim::plan {
namespace {

using nlohmann::json;
using testing::kPaperLaw;

/// Close to the levels, so that few specimens do.
PlanRequest small_request() {
  PlanRequest request;
  request.conditions = {kPaperLaw, {42.5, 55, 70.8}};
  request.goal = {.use_tension_N = 38, .ratio = 1.5, .assurance = 0.8};
  request.specimens_max = 100;
  request.simulation = {.simulations = 40};
  return request;
}

std::string summary(const PlanRequest& request) {
  std::ostringstream out;
  write_plan(out, request, make_plan(request));
  return out.str();
}

TEST(Extrapolation, IsMeasuredFromTheNearestLevel) {
  const Conditions conditions{{.scale = 1e5, .exponent = 2, .shape = 3}, {40, 80}};
  const Extrapolation below = extrapolation_to(20, conditions);
  EXPECT_NEAR(below.tension_factor, 2, 1e-12);
  EXPECT_NEAR(below.life_factor, 4, 1e-12);
  EXPECT_NEAR(below.ranges, 1, 1e-12);
  const Extrapolation above = extrapolation_to(160, conditions);
  EXPECT_NEAR(above.tension_factor, 2, 1e-12);
  EXPECT_NEAR(above.life_factor, 0.25, 1e-12);
  const Extrapolation between = extrapolation_to(50, conditions);
  EXPECT_EQ(between.tension_factor, 1);
  EXPECT_EQ(between.life_factor, 1);
  EXPECT_EQ(between.ranges, 0);
}

TEST(DaysOf, AreThoseOfARigThatNeverStops) {
  EXPECT_DOUBLE_EQ(days_of(28'800, 20), 1);
}

TEST(Plan, ChoosesTheCheapestThatReachTheGoal) {
  const PlanResult result = make_plan(small_request());
  ASSERT_EQ(result.tests.size(), 4U);
  ASSERT_TRUE(result.fewest_specimens);
  ASSERT_TRUE(result.fewest_cycles);
  EXPECT_NEAR(result.b10_cycles, kPaperLaw.quantile(0.1, 38), 1e-9);
  for (const PlannedTest& test : result.tests) {
    EXPECT_TRUE(test.reached) << test.name;
    EXPECT_GE(test.outlook.share_within, 0.8) << test.name;
    EXPECT_EQ(test.curvature_power.has_value(), test.design.tested_levels() > 2) << test.name;
    EXPECT_LE(result.tests[*result.fewest_specimens].outlook.specimens(), test.outlook.specimens());
    EXPECT_LE(result.tests[*result.fewest_cycles].outlook.cycles(), test.outlook.cycles());
  }
}

// What the theory of large samples says too: the extremes alone need the fewest.
TEST(Plan, FindsTheExtremesToNeedTheFewestFarBelowTheLevels) {
  PlanRequest request = small_request();
  request.goal.use_tension_N = 25.5;
  request.goal.ratio = 1.6;
  const PlanResult result = make_plan(request);
  ASSERT_TRUE(result.fewest_specimens);
  EXPECT_EQ(result.tests[*result.fewest_specimens].name, "extremes");
  EXPECT_LT(result.tests[*result.fewest_specimens].outlook.specimens(),
            result.tests.front().outlook.specimens());
}

TEST(Plan, ChoosesTheFewestThatShowACurvature) {
  PlanRequest request = small_request();
  // Half of the life at the use is four times the life in the middle.
  request.goal.use_tension_N = 40;
  request.goal.ratio = 1.5;
  const PlanResult result = make_plan(request);
  ASSERT_TRUE(result.fewest_showing_curvature);
  const PlannedTest& chosen = result.tests[*result.fewest_showing_curvature];
  EXPECT_GE(chosen.curvature_power.value(), 0.8);
  for (const PlannedTest& test : result.tests) {
    if (test.reached && test.curvature_power && *test.curvature_power >= 0.8) {
      EXPECT_LE(chosen.outlook.specimens(), test.outlook.specimens());
    }
  }
  request.curvature_factor = 1.001;
  EXPECT_FALSE(make_plan(request).fewest_showing_curvature);
}

TEST(Plan, ChoosesNoneOutOfReach) {
  PlanRequest request = small_request();
  request.goal.ratio = 1.01;
  request.specimens_max = 12;
  const PlanResult result = make_plan(request);
  EXPECT_FALSE(result.fewest_specimens);
  EXPECT_FALSE(result.fewest_cycles);
  for (const PlannedTest& test : result.tests) {
    EXPECT_FALSE(test.reached);
    EXPECT_EQ(test.outlook.specimens(), 12U);
  }
  const json written = json::parse(plan_json(request, result));
  EXPECT_EQ(written["reached"], false);
  EXPECT_TRUE(written["fewest_specimens"].is_null());
  EXPECT_NE(summary(request).find("not reached with 12 specimens"), std::string::npos);
}

TEST(Plan, SaysWhatAGivenDesignGives) {
  PlanRequest request = small_request();
  request.specimens = {6, 0, 4};
  const PlanResult result = make_plan(request);
  ASSERT_EQ(result.tests.size(), 1U);
  EXPECT_EQ(result.tests[0].outlook.levels[0].specimens, 6U);
  EXPECT_EQ(result.tests[0].outlook.levels[1].specimens, 0U);
  EXPECT_EQ(result.tests[0].outlook.specimens(), 10U);
  EXPECT_FALSE(result.tests[0].curvature_power);
  EXPECT_NE(summary(request).find("2 levels fit any curvature"), std::string::npos);
}

TEST(PlanJson, HasEveryPlanWithItsLevels) {
  PlanRequest request = small_request();
  request.conditions.suspend_at_cycles = 1000;
  request.cycles_per_minute = 20;
  const PlanResult result = make_plan(request);
  const json written = json::parse(plan_json(request, result));
  EXPECT_EQ(written["use_tension_N"], 38);
  EXPECT_EQ(written["ratio"], 1.5);
  EXPECT_EQ(written["suspend_at_cycles"], 1000);
  EXPECT_EQ(written["reached"], true);
  ASSERT_EQ(written["plans"].size(), 4U);
  const json& equal = written["plans"][0];
  EXPECT_EQ(equal["name"], "equal");
  EXPECT_EQ(equal["specimens"], result.tests[0].outlook.specimens());
  EXPECT_EQ(equal["ratio_median"], result.tests[0].outlook.ratio_median);
  EXPECT_EQ(equal["ratio_at_assurance"], result.tests[0].outlook.ratio_at_assurance);
  ASSERT_EQ(equal["levels"].size(), 3U);
  EXPECT_EQ(equal["levels"][2]["effective_tension_N"], 70.8);
  EXPECT_LT(equal["levels"][0]["expected_failures"], equal["levels"][0]["specimens"]);
  EXPECT_DOUBLE_EQ(equal["levels"][1]["days_on_one_rig"].get<double>(),
                   equal["levels"][1]["expected_cycles"].get<double>() / 28'800);
  EXPECT_TRUE(written["plans"][2]["curvature_power"].is_null());
}

TEST(PlanJson, WritesWhatHasNoBoundAsNull) {
  PlanRequest request = small_request();
  request.specimens = {3, 3, 3};
  request.goal.ratio = std::numeric_limits<double>::infinity();
  request.conditions.suspend_at_cycles = 1;
  const json written = json::parse(plan_json(request, make_plan(request)));
  EXPECT_TRUE(written["ratio"].is_null());
  EXPECT_TRUE(written["plans"][0]["ratio_median"].is_null());
  EXPECT_FALSE(written["plans"][0].contains("reached"));
  EXPECT_NE(summary(request).find("no bound"), std::string::npos);
}

TEST(PlanJson, IsTheSameForAnyNumberOfThreads) {
  PlanRequest request = small_request();
  request.simulation = {.simulations = 20, .threads = 1};
  const std::string one = plan_json(request, make_plan(request));
  request.simulation.threads = 4;
  EXPECT_EQ(plan_json(request, make_plan(request)), one);
}

}  // namespace
}  // namespace host_sim::plan
