#include "host_sim/life_law/coefficients.hpp"

#include <gtest/gtest.h>

#include "host_sim/life_law/life_design.hpp"
#include "host_sim/life_law/life_likelihood.hpp"
#include "tests/life_law/campaigns.hpp"

namespace host_sim::life_law {
namespace {

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
