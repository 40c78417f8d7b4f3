#include "host_sim/report/calibrate/words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "host_sim/report/calibrate/texts.hpp"
#include "tests/report/calibrate/sample_result.hpp"

namespace host_sim::calibrate_page {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

TEST(Texts, SayWhatANumberCannot) {
  EXPECT_EQ(interval_text({1.25, 3.5}), "1.25 to 3.5");
  EXPECT_EQ(interval_text({-kInfinity, kInfinity}), "no limit to no limit");
}

TEST(Texts, PreferTheSimulatedP) {
  EXPECT_TRUE(rejects({4, 1, 0.06, 0.04}));
  EXPECT_FALSE(rejects({4, 1, 0.04, 0.06}));
  EXPECT_TRUE(rejects({4, 1, 0.04, kNotANumber}));
  EXPECT_FALSE(rejects({4, 1, kNotANumber, kNotANumber}));
}

TEST(Verdict, TellsTheLawAndTheFirstUseLevel) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.use_levels[0].mean = 887;
  result.use_levels[0].mean_ci95 = {829, 949};
  result.use_levels[0].b10 = 649;
  result.use_levels[0].b10_ci95 = {607, 695};
  EXPECT_EQ(verdict(result),
            "Life falls with effective tension to the power of 1.46 (95\u00a0% 1.32 to 1.59), with "
            "Weibull shape 5.79; upper arm at 39.9\u00a0N: mean life 887 cycles (829 to 949), B10 "
            "649 (607 to 695). Read the 2 warnings first.");
  result.use_levels.clear();
  result.warnings.pop_back();
  EXPECT_THAT(verdict(result), HasSubstr("shape 5.79. Read the warning first."));
}

TEST(Verdict, SaysThatThereIsNoLaw) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.stress_life.reset();
  EXPECT_THAT(verdict(result), StartsWith("No life law could be fitted"));
}

TEST(Words, TellWhatTheTestsOfTheLawSay) {
  EXPECT_THAT(adequacy_words(samples::paper_like()),
              ElementsAre(StartsWith("The straight line in log-log is not rejected"),
                          StartsWith("No bend of the law in log-log is seen"),
                          StartsWith("Scatter changes with tension")));
}

TEST(Words, DoNotJudgeATestThatWasNotMade) {
  calibrate::CalibrateResult result = samples::paper_like();
  result.stress_life->against_free_levels.reset();
  result.stress_life->against_curvature =
      statistics::Test{kNotANumber, 1, kNotANumber, kNotANumber};
  EXPECT_THAT(adequacy_words(result),
              ElementsAre(HasSubstr("could not be tested"), HasSubstr("could not be tested"),
                          Not(HasSubstr("could not be tested"))));
}

TEST(Words, TellWhetherOneShapeHoldsAndWhoIsLeftOut) {
  const calibrate::CalibrateResult result = samples::paper_like();
  EXPECT_THAT(shape_words(result),
              ElementsAre(HasSubstr("is not rejected (likelihood ratio 6.2 with 3"),
                          HasSubstr("would be rejected (likelihood ratio 15.5 with 4")));
  EXPECT_THAT(left_out_words(result),
              ElementsAre("540 deg, 99.8 N is left out: its shape 3.34 differs from that of the "
                          "other levels, p 0.0023."));
}

}  // namespace
}  // namespace host_sim::calibrate_page
