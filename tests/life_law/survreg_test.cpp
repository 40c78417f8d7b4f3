#include "tests/statistics/survreg/survreg.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "host_sim/life_law/life_fit.hpp"
#include "tests/life_law/campaigns.hpp"
#include "tests/life_law/data_sets.hpp"

/// The same likelihoods by R's survreg, other code that climbs in other parameters.
namespace host_sim::life_law {
namespace {

struct Formula {
  std::string name;
  LifeForm form;
};

/// x is ln stress. survreg knows no shape that grows with it.
const std::array<Formula, 4> kFormulas{{
    {"x", {}},
    {"x + I((x - mean(x))^2)", {.scale = LifeForm::Scale::curved}},
    {"factor(x)", {.scale = LifeForm::Scale::free}},
    {"factor(x) + strata(x)", {.scale = LifeForm::Scale::free, .shape = LifeForm::Shape::free}},
}};

std::vector<survreg::Row> rows_of(const LifeData& data) {
  std::vector<survreg::Row> rows;
  for (const LifeDatum& datum : data) {
    const LifeDatum::Block& block = datum.blocks.front();
    rows.push_back(
        {.life = block.cycles, .failed = datum.failed, .x = std::log(block.effective_tension_N)});
  }
  return rows;
}

void expect_the_same_likelihoods(const std::string& name, const LifeData& data) {
  SCOPED_TRACE(name);
  std::vector<std::string> formulas;
  for (const Formula& formula : kFormulas) {
    formulas.push_back(formula.name);
  }
  const std::vector<survreg::Fit> theirs = survreg::fit_weibull(rows_of(data), formulas);
  for (std::size_t i = 0; i < kFormulas.size(); ++i) {
    SCOPED_TRACE(formulas[i]);
    const LifeFit ours = fit_life(data, kFormulas[i].form);
    ASSERT_EQ(ours.problem, statistics::FitProblem::none);
    EXPECT_NEAR(ours.log_likelihood, theirs[i].log_likelihood,
                1e-7 * std::abs(theirs[i].log_likelihood));
  }
}

TEST(LifeFitAndSurvreg, HaveTheSameLikelihood) {
  if (!survreg::available()) {
    GTEST_SKIP() << "NOT CHECKED: Rscript with the package survival is not installed (Debian: "
                    "r-cran-survival)";
  }
  expect_the_same_likelihoods("insulating fluid", testing::insulating_fluid());
  expect_the_same_likelihoods("rolling bearings", testing::rolling_bearings());
  expect_the_same_likelihoods("motorettes", testing::motorettes());
  expect_the_same_likelihoods("glass capacitors", testing::glass_capacitors());
  expect_the_same_likelihoods("like the paper", testing::paper_like(1));
  expect_the_same_likelihoods("like the paper, suspended",
                              testing::suspended_at(testing::paper_like(2), 800));
}

}  // namespace
}  // namespace host_sim::life_law
