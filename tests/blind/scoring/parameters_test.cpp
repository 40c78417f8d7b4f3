#include "tests/blind/scoring/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace blind::test {
namespace {

using host_sim::diagnose::FoundEffect;

// 0.3 (n / 4000)^0.5 is 0.15 at 1000 cycles.
TEST(Parameters, WearIsScaledToTheCataloguesCycles) {
  const HiddenEffect wear{"friction_wear",
                          false,
                          {{"change", {0.3}}, {"reference_cycles", {4000}}, {"exponent", {0.5}}},
                          {{"law", "wear"}}};
  const auto truth = true_parameters(wear);
  ASSERT_EQ(truth.size(), 2U);
  EXPECT_EQ(truth[0].name, "wear_coefficient");
  EXPECT_NEAR(truth[0].value, 0.15, 1e-12);
  EXPECT_EQ(truth[1].value, 0.5);
}

TEST(Parameters, ALagAtTheDriveCountsBackwards) {
  const HiddenEffect lag{
      "filter_lag", false, {{"time_constant_ms", {5}}}, {{"sensor", "motor_current"}}};
  ASSERT_EQ(true_parameters(lag).size(), 1U);
  EXPECT_NEAR(true_parameters(lag)[0].value, -0.005, 1e-12);
}

// 0.89 and 0.853 about their mean 0.8715: +-2.12 %.
TEST(Parameters, GearAsymmetryIsHalfTheDifference) {
  const HiddenEffect gear{"gear_asymmetry",
                          false,
                          {{"pulling_efficiency", {0.89}}, {"releasing_efficiency", {0.853}}},
                          {}};
  EXPECT_NEAR(true_parameters(gear)[0].value, 0.021228, 1e-6);
}

TEST(Parameters, WhatTheCatalogueHasInAnotherFormIsNotCompared) {
  const HiddenEffect bump{
      "friction_position", false, {{"change", {0.3}}, {"centre_mm", {0}}, {"width_mm", {3}}}, {}};
  EXPECT_TRUE(true_parameters(bump).empty());
}

TEST(Parameters, ErrorAndCoverageAreByName) {
  FoundEffect found;
  found.parameters = {{"other", "N", 7, 6, 8}, {"preload_N", "N", 2.2, 1.9, 2.1}};
  const auto scores = score_parameters({{"preload_N", 2}, {"not_found", 1}}, found);
  ASSERT_EQ(scores.size(), 1U);
  EXPECT_NEAR(scores[0].relative_error, 0.1, 1e-12);
  EXPECT_TRUE(scores[0].covered);
}

TEST(Parameters, AnIntervalBesideTheTruthDoesNotCover) {
  FoundEffect found;
  found.parameters = {{"droop_1_K", "1/K", 0.001, 0.0009, 0.0011}};
  const auto scores = score_parameters({{"droop_1_K", 0.002}}, found);
  EXPECT_NEAR(scores.at(0).relative_error, 0.5, 1e-12);
  EXPECT_FALSE(scores.at(0).covered);
}

}  // namespace
}  // namespace blind::test
