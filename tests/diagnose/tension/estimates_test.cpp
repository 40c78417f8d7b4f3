#include "host_sim/diagnose/tension/estimates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host_sim/diagnose/tension/model_fit.hpp"
#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

constexpr double kFine_sd = 0.01;

std::vector<Estimate> estimates(const std::vector<Session>& sessions, const Component& part,
                                double dispersion = 1) {
  const Evidence evidence = evidence_of(sessions, kFine_sd);
  return estimates_of(evidence, std::vector{part}, 0, dispersion);
}

Disturbances with_heat(double share_1_K) {
  return {.sample_sd = kFine_sd, .effect = [=](const recording::Covariates& c, std::size_t i) {
            return -kMu * share_1_K * (c.sheath_temperature_C[i] - 20) * c.bend_angle_rad[i] *
                   c.direction[i];
          }};
}

TEST(Estimates, IntervalsHoldTheTruthAndAreNoWiderThanTheEstimatesSpread) {
  constexpr double kTruth_1_K = 0.004;
  constexpr int kCampaigns = 60;
  int held = 0;
  double sum = 0;
  double square = 0;
  double half = 0;
  for (int i = 0; i < kCampaigns; ++i) {
    const auto found = estimates(
        noisy_sessions(small_design(), with_heat(kTruth_1_K), static_cast<std::uint64_t>(i)),
        component("friction_temperature"));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].unit, "1/K");
    held += found[0].low <= kTruth_1_K && kTruth_1_K <= found[0].high ? 1 : 0;
    sum += found[0].value / kCampaigns;
    square += found[0].value * found[0].value / kCampaigns;
    half += (found[0].high - found[0].low) / 2 / kCampaigns;
  }
  EXPECT_GE(held, 52);  // 57 of 60 expected, sd 1.7
  const double spread = std::sqrt(square - sum * sum);
  EXPECT_NEAR(sum, kTruth_1_K, 4 * spread / std::sqrt(kCampaigns));
  EXPECT_NEAR(half / (1.96 * spread), 1, 0.35);
}

// Half a width is the root of the sum of two squares: of the noise, which dispersion multiplies,
// and of 1.5 % of the value that the signature itself may be off by.
TEST(Estimates, DispersionWidensWhatNoiseDoesByItsRoot) {
  const auto sessions = noisy_sessions(small_design(), with_heat(0.004), 1);
  // As much of it as no scatter between sessions comes near.
  const Estimate one = estimates(sessions, component("friction_temperature"), 100)[0];
  const Estimate four = estimates(sessions, component("friction_temperature"), 400)[0];
  EXPECT_EQ(one.value, four.value);
  const double off = 1.959963984540054 * 0.015 * one.value;
  const auto noise_square = [&](const Estimate& estimate) {
    const double half = (estimate.high - estimate.low) / 2;
    return half * half - off * off;
  };
  EXPECT_GT(noise_square(one), 0);
  EXPECT_NEAR(noise_square(four) / noise_square(one), 4, 1e-9);
}

TEST(Estimates, AShapeThatIsScaledByItsShareIsOneParameter) {
  const auto sessions =
      noisy_sessions(small_design(), {.sample_sd = kFine_sd, .effect = preload(2)}, 1);
  // 2 N as a share 1.111 of 1.8 N.
  const auto found = estimates(sessions, component("friction_preload", {1.8}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].name, "preload_N");
  EXPECT_EQ(found[0].unit, "N");
  EXPECT_NEAR(found[0].value, 2, 0.1);
  EXPECT_LT(found[0].low, found[0].value);
  EXPECT_GT(found[0].high, found[0].value);
}

TEST(Estimates, AnIntervalOfANegativeShapeIsInOrder) {
  const auto sessions =
      noisy_sessions(small_design(),
                     {.sample_sd = kFine_sd,
                      .effect = [](const recording::Covariates& c,
                                   std::size_t i) { return std::log(1 + 0.05 / c.current_A[i]); }},
                     1);
  const auto found = estimates(sessions, component("current_offset", {-0.05}));
  EXPECT_LT(found[0].low, -0.05);
  EXPECT_GT(found[0].high, -0.05);
}

/// Presliding over 0.5 mm of strokes that are much longer, from the first reversal on.
double slid_before(const recording::Covariates& c, std::size_t i) {
  const auto turn = std::ranges::find(c.direction, -1.0);
  if (static_cast<std::ptrdiff_t>(i) < turn - c.direction.begin()) {
    return 0;
  }
  return kMu * c.bend_angle_rad[i] * c.direction[i] * 2 * std::exp(-c.travel_m[i] / 5e-4);
}

TEST(Estimates, AShapeHasTheIntervalInWhichTheEvidenceHolds) {
  const auto sessions =
      noisy_sessions(small_design(), {.sample_sd = kFine_sd, .effect = slid_before}, 1);
  const auto found = estimates(sessions, component("presliding", {5e-4}));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].name, "presliding_length_m");
  EXPECT_EQ(found[1].value, 5e-4);
  EXPECT_LT(found[1].low, 5e-4);
  EXPECT_GT(found[1].high, 5e-4);
  EXPECT_GT(found[1].low, 2e-4);
  EXPECT_LT(found[1].high, 9e-4);
}

/// How much a sheath has worn at 5,000 .. 8,000 cycles is known, and less well how much it had at
/// 1,000: that goes with the exponent.
TEST(Estimates, TheIntervalOfASizeHoldsWhatItsShapeLeavesOpen) {
  constexpr double kTruth = 0.08;
  constexpr int kCampaigns = 40;
  auto runs = small_design();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].start_cycle = 5000 + 250 * static_cast<double>(i);
  }
  const Disturbances worn{.sample_sd = kFine_sd,
                          .session_friction_sd = 0.002,
                          .effect = [](const recording::Covariates& c, std::size_t i) {
                            return -kMu * kTruth * c.cycle[i] / 1000 * c.bend_angle_rad[i] *
                                   c.direction[i];
                          }};
  int held = 0;
  double times_wider = 0;
  for (int i = 0; i < kCampaigns; ++i) {
    const std::vector<Session> sessions = noisy_sessions(runs, worn, static_cast<std::uint64_t>(i));
    Evidence evidence = evidence_of(sessions, kFine_sd);
    const std::vector<Component> model = refined(evidence, {component("friction_wear", {1, 0})});
    const Estimate size = estimates_of(evidence, model, 0, 1)[0];
    held += size.low <= kTruth && kTruth <= size.high ? 1 : 0;
    const ModelFit known = fitted(evidence, model).fit;
    const double variance = std::max(known.covariance(2, 2), known.covariance_by_sessions(2, 2));
    times_wider += (size.high - size.low) / std::sqrt(variance) / 2 / kCampaigns;
  }
  EXPECT_GE(held, 33);  // 38 expected, sd 1.4
  // Of 9 degrees of freedom Student's t alone has 2.26.
  EXPECT_GT(times_wider, 2.6);
}

TEST(Estimates, OfEachPoseHasTheNameOfThePose) {
  const auto sessions =
      noisy_sessions(small_design(),
                     {.sample_sd = kFine_sd,
                      .session_gain_sd = 0.001,
                      .session_friction_sd = 0.001,
                      .effect =
                          [](const recording::Covariates& c, std::size_t i) {
                            return c.bend_angle_rad[i] < 2 ? -kMu * 0.3 * c.direction[i] : 0.0;
                          }},
                     1);
  const auto found = estimates(sessions, component("bend_angle"));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].name.ends_with("_at_85.94_deg")) << found[0].name;  // 1.5 rad
  EXPECT_TRUE(found[1].name.ends_with("_at_343.8_deg")) << found[1].name;  // 6 rad
  EXPECT_GT(found[0].value, found[1].value);
}

TEST(Extension, HoldsTheEstimatesByName) {
  const Extension extension = extension_of(component("friction_preload", {2}),
                                           {{"preload_N", "N", 2.1, 1.9, 2.3}}, baseline());
  EXPECT_EQ(extension.id, "friction_preload");
  ASSERT_EQ(extension.values.size(), 1U);
  EXPECT_EQ(extension.values[0].name, "preload_N");
  EXPECT_EQ(extension.values[0].values, std::vector<double>{2.1});
}

TEST(Extension, OfPosesHasAListAndTheirAngles) {
  effects::Baseline two = baseline();
  two.poses_rad = {std::numbers::pi / 2, std::numbers::pi};
  const Extension extension = extension_of(
      component("bend_angle"),
      {{"a_at_90_deg", "rad", 0.1, 0, 0.2}, {"a_at_180_deg", "rad", -0.2, -1, 0}}, two);
  ASSERT_EQ(extension.values.size(), 2U);
  EXPECT_EQ(extension.values[0].values, (std::vector<double>{0.1, -0.2}));
  EXPECT_EQ(extension.values[1].name, "bend_angles_deg");
  EXPECT_DOUBLE_EQ(extension.values[1].values[0], 90);
  EXPECT_DOUBLE_EQ(extension.values[1].values[1], 180);
}

}  // namespace
}  // namespace host_sim::diagnose::testing
