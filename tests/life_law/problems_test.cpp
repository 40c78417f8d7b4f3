#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "host_sim/life_law/life_fit.hpp"
#include "tests/life_law/campaigns.hpp"
#include "tests/life_law/data_sets.hpp"

namespace host_sim::life_law {
namespace {

using statistics::FitProblem;
using testing::life_data;

constexpr LifeForm kFreeScales{.scale = LifeForm::Scale::free};
constexpr LifeForm kFreeShapes{.scale = LifeForm::Scale::free, .shape = LifeForm::Shape::free};
constexpr LifeForm kCurved{.scale = LifeForm::Scale::curved};

FitProblem problem_of(const LifeData& data, LifeForm form = {}) {
  return fit_life(data, form).problem;
}

TEST(LifeFitProblem, FewerThanTwoFailures) {
  EXPECT_EQ(problem_of({}), FitProblem::too_few_failures);
  EXPECT_EQ(problem_of(life_data({{40, {900}, {900, 950}}, {60, {}, {600}}})),
            FitProblem::too_few_failures);
}

TEST(LifeFitProblem, TwoFailuresLieOnALaw) {
  EXPECT_EQ(problem_of(life_data({{40, {900}, {}}, {60, {600}, {}}})), FitProblem::no_spread);
}

TEST(LifeFitProblem, AllFailuresOnTheLaw) {
  EXPECT_EQ(problem_of(life_data({{10, {1000, 1000}, {}}, {20, {250}, {}}, {40, {62.5}, {62}}})),
            FitProblem::no_spread);
}

// A specimen that outlives the law keeps the shape finite.
TEST(LifeFitProblem, ASuspendedSpecimenBeyondTheLawIsSpread) {
  EXPECT_EQ(problem_of(life_data({{10, {1000, 1000}, {1300}}, {20, {250}, {}}, {40, {62.5}, {}}})),
            FitProblem::none);
}

TEST(LifeFitProblem, OneTensionHasNoExponent) {
  EXPECT_EQ(problem_of(life_data({{40, {900, 1000, 1200}, {1300}}})), FitProblem::not_identified);
}

// Specimens that only outlived a low load bound the exponent on one side.
TEST(LifeFitProblem, FailuresAtOneTensionHaveNoExponent) {
  EXPECT_EQ(problem_of(life_data({{40, {900, 1000, 1200}, {}}, {30, {}, {1500, 1500}}})),
            FitProblem::not_identified);
}

TEST(LifeFitProblem, TensionsThatDifferByRoundingAreOne) {
  EXPECT_EQ(problem_of(life_data({{40, {900, 1000, 1200}, {}}, {40 + 1e-10, {950, 1100}, {}}})),
            FitProblem::not_identified);
}

TEST(LifeFitProblem, TwoTensionsHaveNoCurvature) {
  EXPECT_EQ(problem_of(life_data({{40, {900, 1000, 1200}, {}}, {60, {500, 650}, {}}}), kCurved),
            FitProblem::not_identified);
}

TEST(LifeFitProblem, ALevelWithOneFailureHasNoShapeOfItsOwn) {
  EXPECT_EQ(problem_of(life_data({{40, {900, 1000, 1200}, {}}, {60, {500}, {}}}), kFreeShapes),
            FitProblem::no_spread);
}

TEST(LifeFitProblem, ABadStartIsForgotten) {
  const LifeData data = testing::paper_like(1);
  LifeFit start = fit_life(data);
  start.scale[0] -= 2000;  // every damage beyond what a double holds
  const LifeFit fit = fit_life(data, start);
  ASSERT_EQ(fit.problem, FitProblem::none);
  EXPECT_NEAR(fit.log_likelihood, fit_life(data).log_likelihood, 1e-9);
}

TEST(LifeFitProblem, AStartWithAProblemIsForgotten) {
  const LifeFit start = fit_life(LifeData{});
  EXPECT_EQ(fit_life(testing::paper_like(1), start).problem, FitProblem::none);
}

// A level without failures lasts for ever, and says nothing of the rest.
TEST(LifeFitFreeLevels, ALevelWithoutFailures) {
  const std::vector<testing::StressLevel> failing{{40, {900, 1000, 1200}, {}},
                                                  {60, {500, 650}, {700}}};
  std::vector<testing::StressLevel> with_survivors = failing;
  with_survivors.push_back({20, {}, {5000, 5000}});
  const LifeData data = life_data(with_survivors);
  const LifeFit fit = fit_life(data, kFreeScales);
  ASSERT_EQ(fit.problem, FitProblem::none);
  EXPECT_EQ(fit.scale.at(2), std::numeric_limits<double>::infinity());
  const LifeFit without = fit_life(life_data(failing), kFreeScales);
  EXPECT_DOUBLE_EQ(fit.log_likelihood, without.log_likelihood);
  EXPECT_DOUBLE_EQ(log_likelihood(data, fit), without.log_likelihood);
  EXPECT_TRUE(std::isnan(fit_life(data, kFreeShapes).shape.at(2)));
}

TEST(LifeFitFreeLevels, SkipSpecimensWithoutALevel) {
  LifeData data = testing::paper_like(3);
  const double without = fit_life(data, kFreeScales).log_likelihood;
  data.push_back({.blocks = {{50, 100}, {60, 300}}, .failed = true});
  EXPECT_DOUBLE_EQ(fit_life(data, kFreeScales).log_likelihood, without);
}

TEST(LifeFitFreeLevels, AreTheFitsOfEachLevel) {
  LifeData data = testing::suspended_at(testing::paper_like(4), 800);
  const LifeFit all = fit_life(data, kFreeShapes);
  ASSERT_EQ(all.problem, FitProblem::none);
  double sum = 0;
  for (std::size_t level = 0; level < 4; ++level) {
    statistics::Sample sample;
    for (const LifeDatum& datum : data) {
      if (datum.level == level) {
        sample.push_back({.value = datum.blocks.front().cycles, .failed = datum.failed});
      }
    }
    const statistics::Fit own = statistics::fit(statistics::Family::weibull, sample);
    EXPECT_NEAR(std::exp(all.scale[level]), own.distribution.first, 1e-6);
    EXPECT_NEAR(std::exp(all.shape[level]), own.distribution.second, 1e-7);
    sum += own.log_likelihood;
  }
  EXPECT_NEAR(all.log_likelihood, sum, 1e-9);
}

}  // namespace
}  // namespace host_sim::life_law
