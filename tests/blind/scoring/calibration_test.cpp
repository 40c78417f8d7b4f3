#include "tests/blind/scoring/calibration.hpp"

#include <gtest/gtest.h>

namespace blind::test {
namespace {

TEST(Calibration, NoAnswersHaveNoError) {
  EXPECT_EQ(Calibration().error(), 0);
}

TEST(Calibration, ThreeOfFourAtThreeQuartersIsPerfect) {
  Calibration calibration;
  for (const bool right : {true, true, true, false}) {
    calibration.add(0.75, right);
  }
  EXPECT_EQ(calibration.error(), 0);
}

// Bin 0.9 .. 1: three answers of 0.95, two right, |2 - 2.85| = 0.85. Bin 0.5 .. 0.6: one answer of
// 0.5, right, |1 - 0.5| = 0.5. (0.85 + 0.5) / 4.
TEST(Calibration, ErrorIsWeightedByAnswers) {
  Calibration calibration;
  calibration.add(0.95, true);
  calibration.add(0.95, true);
  calibration.add(0.95, false);
  calibration.add(0.5, true);
  EXPECT_NEAR(calibration.error(), 1.35 / 4, 1e-12);
}

// Within one bin too much confidence and too little cancel; across bins they do not.
TEST(Calibration, BinsDoNotCancel) {
  Calibration calibration;
  calibration.add(0.15, true);
  calibration.add(0.85, false);
  EXPECT_NEAR(calibration.error(), 0.85, 1e-12);
}

TEST(Calibration, CertaintyBelongsToTheLastBin) {
  Calibration calibration;
  calibration.add(1, true);
  EXPECT_EQ(calibration.bins()[9].answers, 1U);
  EXPECT_EQ(calibration.bins()[9].right, 1U);
}

}  // namespace
}  // namespace blind::test
