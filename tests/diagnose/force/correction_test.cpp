#include "host_sim/diagnose/force/correction.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/extension/model_file.hpp"
#include "tests/diagnose/force/joint.hpp"

namespace host_sim::diagnose {
namespace {

TEST(ForceTable, IsLinearBetweenItsKnotsAndConstantBeyond) {
  const ForceTable table{{1, 3, 7}, {10, 20, 0}, {-1, -1, 3}};
  EXPECT_EQ(table.at_N(0, false), 10);
  EXPECT_EQ(table.at_N(1, false), 10);
  EXPECT_EQ(table.at_N(2, false), 15);
  EXPECT_EQ(table.at_N(3, false), 20);
  EXPECT_EQ(table.at_N(6, false), 5);
  EXPECT_EQ(table.at_N(7, false), 0);
  EXPECT_EQ(table.at_N(9, false), 0);
  EXPECT_EQ(table.at_N(5, true), 1);
}

TEST(ForceTable, OfOneKnotIsAForceForEachDirection) {
  const ForceTable table{{2}, {5}, {-4}};
  EXPECT_EQ(table.at_N(-1, false), 5);
  EXPECT_EQ(table.at_N(8, true), -4);
}

struct Corrected {
  double nominal_N = 0;
  std::optional<ForceCorrection> correction;
  double corrected_N = 0;
};

Corrected corrected(const Joint& joint) {
  const ForceData data(measured(joint, 11));
  const ForceFit fit = data.fit({}, {1, 0.1}, 15);
  const HeldOut held = data.held_out(fit);
  Corrected result{data.rmse_N(held.plain_N2), {}, 0};
  result.correction = correction_of(data, fit, held.residuals_N, force_covariates(data.records()),
                                    joint.rotor_known);
  result.corrected_N =
      result.correction ? data.rmse_N(data.mean_squares_N2(result.correction->held_N)) : 0;
  return result;
}

/// 8 N at the ends of a stroke of 0.05 m either side, with the motion and, back, against it.
TEST(Correction, FindsTheForceThatRepeatsOverThePositionByDirection) {
  const Corrected found = corrected({.noise_N = 0.3, .shaped_N = 8});
  ASSERT_TRUE(found.correction);
  EXPECT_EQ(found.correction->covariate, 1U);
  // The noise of both ends alone is 0.42 N, and the gain of sessions scatters by 0.28 N.
  EXPECT_GT(found.corrected_N, 0.42);
  EXPECT_LT(found.corrected_N, 0.8);
  EXPECT_GT(found.nominal_N, 5);
  for (const double position_m : {-0.04, -0.02, 0.01, 0.03}) {
    const double force_N = 8 * position_m / 0.05;
    EXPECT_NEAR(found.correction->table.at_N(position_m, false), force_N, 0.6) << position_m;
    EXPECT_NEAR(found.correction->table.at_N(position_m, true), -force_N, 0.6) << position_m;
  }
}

TEST(Correction, IsNotWrittenOverAPositionThatNoControllerKnows) {
  const Corrected found = corrected({.noise_N = 0.3, .shaped_N = 8, .rotor_known = false});
  EXPECT_TRUE(!found.correction || found.correction->covariate != 1U);
}

TEST(Correction, WhatDoesNotRepeatGetsNone) {
  EXPECT_FALSE(corrected({.noise_N = 0.3}).correction);
  EXPECT_FALSE(corrected({.noise_N = 0.3, .shaped_N = 8, .shape_turns = true}).correction);
}

/// Behind a gain of 2 the table of the model is half of what is seen.
TEST(Correction, IsWrittenBeforeTheGain) {
  const ForceCorrection correction{
      .covariate = 3, .table = {{0, 0.5}, {2, -4}, {6, 8}}, .held_N = {}};
  EXPECT_EQ(toml_text(std::vector{written_correction(correction, 2)}),
            "[extension.empirical]\ntravel_m = [0.0, 0.5]\npulling_N = [1.0, -2.0]\n"
            "letting_go_N = [3.0, 4.0]\n");
}

}  // namespace
}  // namespace host_sim::diagnose
