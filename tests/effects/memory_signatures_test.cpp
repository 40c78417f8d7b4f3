#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/effects/trace.hpp"

/// Effects that remember what was before, against simulations in steps of 2 us.
namespace host_sim::effects::testing {
namespace {

constexpr double kStep_s = 2e-6;
constexpr int kStepsEachSample = 2500;  // 200 samples a second
constexpr int kSamples = 800;
constexpr double kAngle_rad = 2;
constexpr double kTurnRate_rad_s = 2 * std::numbers::pi * 0.7;
constexpr double kLoadRate_rad_s = 2 * std::numbers::pi * 0.9;

double position_m(double time_s) {
  return 0.02 * std::sin(kTurnRate_rad_s * time_s + 0.3);
}

double velocity_m_s(double time_s) {
  return 0.02 * kTurnRate_rad_s * std::cos(kTurnRate_rad_s * time_s + 0.3);
}

double direction(double time_s) {
  return velocity_m_s(time_s) > 0 ? 1 : -1;
}

double output_N(double time_s) {
  return 40 + 10 * std::sin(kLoadRate_rad_s * time_s);
}

double output_rate_1_s(double time_s) {
  return 10 * kLoadRate_rad_s * std::cos(kLoadRate_rad_s * time_s) / output_N(time_s);
}

double sliding_input_N(double time_s) {
  return output_N(time_s) * std::exp(kMu * kAngle_rad * direction(time_s));
}

/// Tensions of both ends as they are measured after one more step.
struct Ends {
  double input_N = 0, output_N = 0;
};

/// What is recorded of a motion by sensors that say `step` of each instant.
recording::Covariates recorded(const std::function<Ends(double time_s)>& step) {
  recording::Covariates c;
  for (int k = 1; k <= kSamples * kStepsEachSample; ++k) {
    const double time_s = k * kStep_s;
    const Ends ends = step(time_s);
    if (k % kStepsEachSample == 0) {
      c.time_s.push_back(time_s);
      c.position_m.push_back(position_m(time_s));
      c.velocity_m_s.push_back(velocity_m_s(time_s));
      c.direction.push_back(direction(time_s));
      c.bend_angle_rad.push_back(kAngle_rad);
      c.input_tension_N.push_back(ends.input_N);
      c.output_tension_N.push_back(ends.output_N);
      c.log_output_rate_1_s.push_back(output_rate_1_s(time_s));
    }
  }
  return c;
}

recording::Covariates without(const recording::Covariates& covariates, std::size_t from,
                              std::size_t count) {
  recording::Covariates rest = covariates;
  for (const auto member :
       {&recording::Covariates::time_s, &recording::Covariates::position_m,
        &recording::Covariates::velocity_m_s, &recording::Covariates::direction,
        &recording::Covariates::bend_angle_rad, &recording::Covariates::input_tension_N,
        &recording::Covariates::output_tension_N, &recording::Covariates::log_output_rate_1_s}) {
    const auto begin = (rest.*member).begin() + static_cast<std::ptrdiff_t>(from);
    (rest.*member).erase(begin, begin + static_cast<std::ptrdiff_t>(count));
  }
  return rest;
}

/// The first sample at or after `from` that the tendon moves the other way.
std::size_t turn_after(const recording::Covariates& c, std::size_t from) {
  while (c.direction[from] == c.direction[from - 1]) {
    ++from;
  }
  return from;
}

TEST(FilterLag, IsWhatAFirstOrderLagOfTheOutputDoes) {
  constexpr double kLag_s = 0.005;
  double measured_N = output_N(0) * (1 - kLag_s * output_rate_1_s(0));
  const recording::Covariates c = recorded([&](double time_s) {
    measured_N += (output_N(time_s) - measured_N) * kStep_s / kLag_s;
    return Ends{sliding_input_N(time_s), measured_N};
  });
  expect_same(columns("filter_lag", c, {kLag_s})[0], residuals(c), 0.05);
}

/// T_out exp(g t) has a reading of T_out exp(g t)/(1 + g tau).
TEST(FilterLag, OfATensionThatGrowsByAShareIsExact) {
  recording::Covariates c = recorded([](double time_s) {
    return Ends{sliding_input_N(time_s), output_N(time_s)};
  });
  std::ranges::fill(c.log_output_rate_1_s, 10);
  const std::vector<double> found = columns("filter_lag", c, {0.02})[0];
  for (const double value : found) {
    EXPECT_NEAR(value, -std::log(1.2), 1e-12);
  }
}

TEST(FilterLag, IsWhatAFirstOrderLagOfTheInputDoesToTheJumpsOfFriction) {
  constexpr double kLag_s = 0.02;
  double measured_N = sliding_input_N(0) * (1 - kLag_s * output_rate_1_s(0));
  const recording::Covariates c = recorded([&](double time_s) {
    measured_N += (sliding_input_N(time_s) - measured_N) * kStep_s / kLag_s;
    return Ends{measured_N, output_N(time_s)};
  });
  const std::vector<double> exact = residuals(c);
  expect_same(columns("filter_lag", c, {-kLag_s})[0], exact, 0.015);
  // Right after a reversal most of twice mu phi is still missing.
  EXPECT_GT(*std::ranges::max_element(exact), 2 * kMu * kAngle_rad * 0.75);
}

TEST(FilterLag, KnowsNothingOfWhatWasBeforeALongPause) {
  constexpr double kLag_s = 0.02;
  recording::Covariates c = recorded([](double time_s) {
    return Ends{sliding_input_N(time_s), output_N(time_s)};
  });
  const std::size_t turn = turn_after(c, 100);
  for (std::size_t i = turn; i < c.samples(); ++i) {
    c.time_s[i] += 10;
  }
  const auto found = columns("filter_lag", c, {-kLag_s})[0];
  EXPECT_NEAR(found[turn], std::log1p(kLag_s * c.log_output_rate_1_s[turn]), 1e-12);
}

/// T_in of a spring in series with a sheath that holds up to full friction.
recording::Covariates sprung(double stiffness_N_m) {
  double input_N = sliding_input_N(0);
  double before_m = position_m(0);
  return recorded([=](double time_s) mutable {
    const double grip = std::exp(kMu * kAngle_rad);
    input_N += stiffness_N_m * (position_m(time_s) - before_m);
    before_m = position_m(time_s);
    input_N = std::clamp(input_N, output_N(time_s) / grip, output_N(time_s) * grip);
    return Ends{input_N, output_N(time_s)};
  });
}

TEST(Compliance, IsWhatASpringBeforeASliderDoes) {
  for (const double stiffness_N_m : {1e3, 1e4}) {
    const recording::Covariates c = sprung(stiffness_N_m);
    const std::vector<double> exact = residuals(c);
    expect_same(columns("compliance", c, {stiffness_N_m})[0], exact, 0.02);
    // Friction is still that of the way before.
    EXPECT_GT(*std::ranges::max_element(exact), 2 * kMu * kAngle_rad * 0.9);
    EXPECT_NEAR(exact[turn_after(c, 150) - 10], 0, 1e-12);
  }
}

/// From 1 to -1 m/s within a second the tendon goes 0.25 m on and 0.25 m back. Sliding until then,
/// T_in falls from 50 exp(mu phi) by 40 N/m times 0.25 m.
TEST(Compliance, TurnsWithinAStep) {
  recording::Covariates c;
  c.time_s = {0, 1};
  c.position_m = {0, 0};
  c.velocity_m_s = {1, -1};
  c.direction = {1, -1};
  c.bend_angle_rad = {2, 2};
  c.travel_m = {1, 0.25};
  c.output_tension_N = {50, 50};
  c.log_output_rate_1_s = {0, 0};
  c.input_tension_N = {50 * std::exp(kMu * 2), 50 * std::exp(kMu * 2) - 10};
  const double ratio = std::exp(kMu * 2) - 10.0 / 50;
  EXPECT_NEAR(columns("compliance", c, {40})[0][1], -kMu * 2 - std::log(ratio), 1e-12);
}

TEST(Compliance, GoesOnOverAFewMissingSamples) {
  const recording::Covariates c = sprung(1e3);
  const std::size_t turn = turn_after(c, 100);
  recording::Covariates gap = without(c, turn + 3, 6);
  gap.log_output_rate_1_s[turn + 3] =
      c.direction[turn] * -50;  // what differences over a gap may say
  std::vector<double> exact = residuals(gap);
  const std::vector<double> found = columns("compliance", gap, {1e3})[0];
  EXPECT_GT(exact[turn + 3], 0.1);
  EXPECT_NEAR(found[turn + 3], exact[turn + 3], 0.01);
}

TEST(Compliance, SlidesAfterALongPause) {
  recording::Covariates c = sprung(1e3);
  const std::size_t turn = turn_after(c, 100);
  EXPECT_GT(columns("compliance", c, {1e3})[0][turn + 1], 0.3);
  for (std::size_t i = turn + 1; i < c.samples(); ++i) {
    c.time_s[i] += 10;
  }
  EXPECT_EQ(columns("compliance", c, {1e3})[0][turn + 1], 0);
}

}  // namespace
}  // namespace host_sim::effects::testing
