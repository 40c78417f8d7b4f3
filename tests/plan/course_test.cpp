#include "host_sim/plan/course.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/plan/theory.hpp"

namespace host_sim::plan {
namespace {

PlanRequest request_of_a_course() {
  PlanRequest request;
  request.conditions = {testing::kPaperLaw, {42.5, 55, 70.8}};
  request.goal = {.use_tension_N = 38, .ratio = 1.5, .assurance = 0.8};
  request.specimens_max = 100;
  request.simulation = {.simulations = 100};
  return request;
}

TEST(Courses, GoFromTheFewestToTwiceThePlanThroughThePlanItself) {
  const PlanRequest request = request_of_a_course();
  const PlanResult result = make_plan(request);
  const auto courses = courses_of(request, result);
  ASSERT_EQ(courses.size(), result.tests.size());
  for (std::size_t i = 0; i < courses.size(); ++i) {
    const auto& points = courses[i].points;
    const PlannedTest& test = result.tests[i];
    EXPECT_EQ(courses[i].name, test.name);
    EXPECT_EQ(points.front().outlook.specimens(), 2 * test.design.tested_levels());
    EXPECT_EQ(points.back().outlook.specimens(), 2 * test.design.specimens());
    const auto own = std::ranges::find(points, test.design.specimens(), [](const CoursePoint& one) {
      return one.outlook.specimens();
    });
    ASSERT_NE(own, points.end());
    EXPECT_EQ(own->outlook.ratio_at_assurance, test.outlook.ratio_at_assurance);
    EXPECT_EQ(own->curvature_power, test.curvature_power);
  }
}

// More of the same specimens narrow the interval: by the root of their number in the large.
TEST(Courses, NarrowTheInterval) {
  const PlanRequest request = request_of_a_course();
  for (const Course& course : courses_of(request, make_plan(request))) {
    for (std::size_t i = 1; i < course.points.size(); ++i) {
      EXPECT_LT(course.points[i].outlook.ratio_at_assurance,
                course.points[i - 1].outlook.ratio_at_assurance)
          << course.name << i;
    }
  }
}

TEST(Courses, KeepTheSharesOfAPlanThatWasGiven) {
  PlanRequest request = request_of_a_course();
  request.specimens = {8, 0, 4};
  const auto courses = courses_of(request, make_plan(request));
  ASSERT_EQ(courses.size(), 1U);
  const auto& last = courses[0].points.back().outlook.levels;
  EXPECT_EQ(last[0].specimens, 16U);
  EXPECT_EQ(last[1].specimens, 0U);
  EXPECT_EQ(last[2].specimens, 8U);
  EXPECT_FALSE(courses[0].points.back().curvature_power);
}

}  // namespace
}  // namespace host_sim::plan
