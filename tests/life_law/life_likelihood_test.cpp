#include "host_sim/life_law/life_likelihood.hpp"

#include <gtest/gtest.h>

#include <boost/math/differentiation/finite_difference.hpp>
#include <cmath>
#include <limits>

#include "host_sim/life_law/life_design.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "tests/life_law/data_sets.hpp"

namespace host_sim::life_law {
namespace {

/// alpha = 1000 at 10 N and 250 at 20 N, shape 2.
LifeFit square_law() {
  LifeFit fit;
  fit.centre_ln_N = std::log(10);
  fit.scale = {std::log(1000), 2};
  fit.shape = {std::log(2)};
  return fit;
}

LifeDatum specimen(std::vector<LifeDatum::Block> blocks, bool failed) {
  return {.blocks = std::move(blocks), .failed = failed};
}

TEST(LogLikelihood, OfAFailureIsTheLogDensity) {
  // D = 0.5: f = (2 / 1000) 0.5 exp(-0.25)
  const LifeData data{specimen({{10, 500}}, true)};
  EXPECT_NEAR(log_likelihood(data, square_law()), std::log(0.001) - 0.25, 1e-13);
}

TEST(LogLikelihood, OfASuspendedSpecimenIsTheLogSurvival) {
  const LifeData data{specimen({{20, 500}}, false)};  // D = 2
  EXPECT_NEAR(log_likelihood(data, square_law()), -4, 1e-13);
}

LifeDatum found_broken(double effective_tension_N, double from_cycles, double cycles) {
  return {.blocks = {{effective_tension_N, cycles}}, .from_cycles = from_cycles};
}

// Between D = 0.5 and 1: exp(-1/4) - exp(-1); by D = 0.5: 1 - exp(-1/4).
TEST(LogLikelihood, OfASpecimenFoundBrokenIsTheLogProbabilityToBreakInBetween) {
  EXPECT_NEAR(log_likelihood(LifeData{found_broken(10, 500, 1000)}, square_law()),
              std::log(std::exp(-0.25) - std::exp(-1)), 1e-13);
  EXPECT_NEAR(log_likelihood(LifeData{found_broken(10, 0, 500)}, square_law()),
              std::log(1 - std::exp(-0.25)), 1e-13);
}

TEST(LogLikelihood, OfAnIntervalFarInATailIsFinite) {
  // D = 40 and 44: -1600 + ln(1 - exp(-336)).
  EXPECT_NEAR(log_likelihood(LifeData{found_broken(10, 40000, 44000)}, square_law()), -1600, 1e-9);
  // D up to 1e-9: ln(1e-18).
  EXPECT_NEAR(log_likelihood(LifeData{found_broken(10, 0, 1e-6)}, square_law()), -18 * std::log(10),
              1e-9);
}

// 500 cycles at 10 N and 25 at 20 N: D = 0.5 + 0.1, density (2 / 250) 0.6 exp(-0.36).
TEST(LogLikelihood, OfAFailureInTheSecondBlock) {
  const LifeData data{specimen({{10, 500}, {20, 25}}, true)};
  EXPECT_NEAR(log_likelihood(data, square_law()), std::log(0.0048) - 0.36, 1e-13);
}

TEST(LogLikelihood, OfASpecimenSuspendedInItsThirdBlock) {
  const LifeData data{specimen({{10, 500}, {20, 25}, {10, 100}}, false)};  // D = 0.7
  EXPECT_NEAR(log_likelihood(data, square_law()), -0.49, 1e-13);
}

TEST(LogLikelihood, OfASpecimenInBlocksUsesTheShapeAtItsCycleWeightedMean) {
  LifeFit fit = square_law();
  fit.form.shape = LifeForm::Shape::growing;
  fit.shape = {std::log(2), 1};
  // x is 0 for 300 cycles and ln 2 for 100: beta = 2 * 2^(1/4); D = 0.3 + 0.4.
  const LifeData data{specimen({{10, 300}, {20, 100}}, false)};
  EXPECT_NEAR(log_likelihood(data, fit), -std::pow(0.7, 2 * std::pow(2, 0.25)), 1e-13);
}

// exp(-D^beta) over the cycles of the last block falls by the density of a failure there.
TEST(LogLikelihood, TheDensityOfAFailureIsTheSlopeOfTheSurvival) {
  const LifeFit fit = square_law();
  const auto survival = [&fit](double last_cycles) {
    return std::exp(log_likelihood(LifeData{specimen({{10, 400}, {20, last_cycles}}, false)}, fit));
  };
  const double density =
      -boost::math::differentiation::finite_difference_derivative(survival, 60.0);
  EXPECT_NEAR(log_likelihood(LifeData{specimen({{10, 400}, {20, 60}}, true)}, fit),
              std::log(density), 1e-9);
}

TEST(LogLikelihood, OfASteeperShapeThanAnyScatterIsMinusInfinity) {
  LifeFit fit = square_law();
  fit.shape = {kLargestLnShape + 1};
  EXPECT_EQ(log_likelihood(LifeData{specimen({{10, 1000}}, true)}, fit),
            -std::numeric_limits<double>::infinity());
}

LifeData with_blocks() {
  LifeData data = testing::motorettes();
  for (LifeDatum& datum : data) {
    for (LifeDatum::Block& block : datum.blocks) {
      block.effective_tension_N *= 20;
    }
  }
  const double tension_N = data.front().blocks.front().effective_tension_N;
  for (const auto& [from, to] : {std::pair(0.0, 900.0), std::pair(700.0, 1500.0),
                                 std::pair(8000.0, 8100.0), std::pair(3000.0, 40000.0)}) {
    data.push_back(found_broken(tension_N, from, to));
    data.back().level = 0;
  }
  data.push_back(specimen({{1.5, 900}, {2.5, 300}}, true));
  data.push_back(specimen({{2.5, 200}, {1.5, 700}, {2.0, 90}}, false));
  return data;
}

class Derivatives : public ::testing::TestWithParam<LifeForm> {};

TEST_P(Derivatives, AreThoseOfFiniteDifferences) {
  const LifeForm form = GetParam();
  const LifeData data = with_blocks();
  const LogTensionFrame frame = frame_of(data);
  const Participation participation(data, form);
  const LifeDesign design = design_of(data, form, frame, participation);
  // Away from the maximum, where no term vanishes.
  const Eigen::VectorXd at = 7.3 * Eigen::VectorXd::Unit(design.coefficients(), 0) +
                             Eigen::VectorXd::LinSpaced(design.coefficients(), 0.3, 0.9) +
                             (form.scale == LifeForm::Scale::free ? 6.5 : 0.0) *
                                 Eigen::VectorXd::Unit(design.coefficients(), 1);
  Expansion expansion;
  expand_log_likelihood(design, at, expansion);
  ASSERT_TRUE(std::isfinite(expansion.value));

  const auto moved = [&](Eigen::Index i, double to) {
    Eigen::VectorXd point = at;
    point[i] = to;
    Expansion there;
    expand_log_likelihood(design, point, there);
    return there;
  };
  using boost::math::differentiation::finite_difference_derivative;
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const double slope =
        finite_difference_derivative([&](double to) { return moved(i, to).value; }, at[i]);
    EXPECT_NEAR(expansion.gradient[i], slope, 1e-7 * (1 + std::abs(slope))) << i;
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      const double bend =
          finite_difference_derivative([&](double to) { return moved(j, to).gradient[i]; }, at[j]);
      EXPECT_NEAR(expansion.hessian(i, j), bend, 1e-7 * (1 + std::abs(bend))) << i << ' ' << j;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Forms, Derivatives,
    ::testing::Values(LifeForm{}, LifeForm{.shape = LifeForm::Shape::growing},
                      LifeForm{.scale = LifeForm::Scale::curved},
                      LifeForm{.scale = LifeForm::Scale::curved, .shape = LifeForm::Shape::growing},
                      LifeForm{.scale = LifeForm::Scale::free},
                      LifeForm{.shape = LifeForm::Shape::free},
                      LifeForm{.scale = LifeForm::Scale::free, .shape = LifeForm::Shape::free}));

class Coefficients : public ::testing::TestWithParam<LifeForm> {};

// The same curves have other coefficients about another centre, and the same likelihood.
TEST_P(Coefficients, InAnotherFrameAreTheSameCurves) {
  const LifeForm form = GetParam();
  const LifeData data = testing::suspended_at(testing::paper_like(6), 800);
  const LifeFit fit = fit_life(data, form);
  ASSERT_EQ(fit.problem, statistics::FitProblem::none);
  const LogTensionFrame frame{.centre = fit.centre_ln_N + 0.7, .spread = 2.5};
  const Participation participation(data, form);
  Expansion expansion;
  expand_log_likelihood(design_of(data, form, frame, participation),
                        design_coefficients(fit, frame, participation), expansion);
  EXPECT_NEAR(expansion.value, fit.log_likelihood, 1e-9);

  LifeFit back = fit;
  set_coefficients(back, design_coefficients(fit, frame, participation), frame, participation);
  EXPECT_EQ(back.centre_ln_N, frame.centre);
  EXPECT_NEAR(log_likelihood(data, back), fit.log_likelihood, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Forms, Coefficients,
    ::testing::Values(LifeForm{}, LifeForm{.shape = LifeForm::Shape::growing},
                      LifeForm{.scale = LifeForm::Scale::curved, .shape = LifeForm::Shape::growing},
                      LifeForm{.scale = LifeForm::Scale::free, .shape = LifeForm::Shape::free}));

}  // namespace
}  // namespace host_sim::life_law
