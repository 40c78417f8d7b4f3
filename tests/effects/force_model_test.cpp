#include "host_sim/effects/tension/force_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace host_sim::effects {
namespace {

using std::numbers::pi;

const ForceScales kScales{.speed_m_s = 0.1,
                          .stroke_m = 0.2,
                          .position_m = 0,
                          .force_N = 10,
                          .turn_over_m_s = 0.005,
                          .cycles = 10000,
                          .poses_rad = {pi / 2, pi}};

/// Moves steadily: far over the speed below which friction turns over.
ForceRecord record(const std::vector<double>& positions_m, double velocity_m_s, double output_N) {
  ForceRecord record;
  record.session = "s";
  const std::size_t samples = positions_m.size();
  for (std::size_t i = 0; i < samples; ++i) {
    record.time_s.push_back(0.1 * static_cast<double>(i));
  }
  record.position_m = positions_m;
  record.reversal_m = positions_m;
  record.velocity_m_s.assign(samples, velocity_m_s);
  record.output_N.assign(samples, output_N);
  record.output_rate_N_s.assign(samples, 0);
  record.input_N.assign(samples, output_N);  // where it begins, nothing is turned over
  record.bend_angle_rad.assign(samples, pi);
  record.used.assign(samples, true);
  return record;
}

double predicted(const ForceRecord& record, const ForceTerms& terms,
                 const std::vector<double>& parameters) {
  std::vector<double> input_N;
  predict_input(record, kinematics_of(record, kScales), terms, kScales, parameters, input_N);
  return input_N.back();
}

TEST(ForceModel, IsEquation14WhilePullingAndLettingGo) {
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 10), {}, {1, 0.1}), 10 * std::exp(0.1 * pi), 1e-9);
  EXPECT_NEAR(predicted(record({0.1, 0}, -1, 10), {}, {1, 0.1}), 10 * std::exp(-0.1 * pi), 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 10), {}, {2, 0}), 20, 1e-9);
  EXPECT_EQ(predicted(record({0, 0}, 0, 10), {}, {1, 0.1}), 10);
}

TEST(ForceModel, FrictionOfASignedForceWorksAgainstTheMotion) {
  for (const double output_N : {-10.0, 10.0}) {
    for (const double velocity_m_s : {-1.0, 1.0}) {
      const double friction_N =
          predicted(record({0, 0.1}, velocity_m_s, output_N), {}, {1, 0.1}) - output_N;
      EXPECT_GT(friction_N * velocity_m_s, 0) << output_N << ' ' << velocity_m_s;
      // The same drive looked at from the other side.
      EXPECT_NEAR(predicted(record({0, -0.1}, -velocity_m_s, -output_N), {}, {1, 0.1}) + output_N,
                  -friction_N, 1e-12);
    }
  }
}

TEST(ForceModel, LoadIndependentFrictionAddsItsForce) {
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 10), {ForceTerm::preload}, {1, 0, 3}), 13, 1e-9);
  EXPECT_NEAR(predicted(record({0, -0.1}, -1, -2), {ForceTerm::preload}, {1, 0, 3}), -5, 1e-9);
}

TEST(ForceModel, ViscousFrictionGrowsWithSpeed) {
  EXPECT_NEAR(predicted(record({0, 0.1}, 0.5, 10), {ForceTerm::velocity}, {1, 0, 4, 0}), 12, 1e-6);
  EXPECT_NEAR(predicted(record({0, 0.1}, 0.5, 10), {ForceTerm::velocity}, {1, 0, 0, 0.2}),
              10 * std::exp(0.5 * 0.2 * pi), 1e-6);
}

/// At the Stribeck velocity what friction has more at rest has fallen to 1/e.
TEST(ForceModel, StribeckFrictionFallsWithSpeed) {
  const double coefficient = 0.1 + 0.2 * 0.05 + 0.3 * std::exp(-1);
  EXPECT_NEAR(
      predicted(record({0, 0.1}, 0.05, 10), {ForceTerm::stribeck}, {1, 0.1, 0.2, 0.3, 0.05}),
      10 * std::exp(coefficient * pi), 1e-6);
}

/// After 50 mm one way and 1 mm back, of 10 mm that it lies loose in, the drive holds exp(-0.5) of
/// the force with half of the friction; after 20 mm back all of both.
TEST(ForceModel, ALooseTendonIsHeldInPart) {
  const std::vector<double> parameters{1, 0.1, 0.01, 0.5, 0.5};
  EXPECT_NEAR(predicted(record({0, 0.05, 0.049}, -1, 10), {ForceTerm::loose_tendon}, parameters),
              10 * std::exp(-0.05 * pi - 0.5), 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.05, 0.03}, -1, 10), {ForceTerm::loose_tendon}, parameters),
              10 * std::exp(-0.1 * pi), 1e-9);
}

/// One law of slack is of a tendon that pulls alone, the other of a drive that works both ways.
TEST(ForceModel, ATendonThatPullsAloneHasLawsOfItsOwn) {
  std::vector<ForceRecord> records{record({0, 0.1}, 1, 10)};
  EXPECT_TRUE(is_shown(ForceTerm::slack, records));
  EXPECT_FALSE(is_shown(ForceTerm::loose_tendon, records));
  EXPECT_FALSE(is_shown(ForceTerm::stribeck, records));
  records.front().pulls_alone = true;
  EXPECT_FALSE(is_shown(ForceTerm::slack, records));
  EXPECT_TRUE(is_shown(ForceTerm::loose_tendon, records));
  EXPECT_TRUE(is_shown(ForceTerm::stribeck, records));
}

TEST(ForceModel, PreslidingTurnsFrictionOverWithTheTravel) {
  const ForceTerms terms{ForceTerm::preload, ForceTerm::presliding};
  // From rest a length l turns over 1 - 1/e of it, and so does the way there in steps.
  const double once_N = predicted(record({0, 0.01}, 1, 10), terms, {1, 0, 3, 0.01});
  EXPECT_NEAR(once_N, 10 + 3 * (1 - std::exp(-1)), 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.002, 0.007, 0.01}, 1, 10), terms, {1, 0, 3, 0.01}), once_N,
              1e-9);
  // z = 0.95 after three lengths, then one back: -1 + 1.95/e.
  const double z = -1 + (2 - std::exp(-3)) * std::exp(-1);
  EXPECT_NEAR(predicted(record({0, 0.03, 0.02}, -1, 10), terms, {1, 0, 3, 0.01}), 10 + 3 * z, 1e-9);
}

/// Of 10 +- 2 N a force of 9 N is turned over by -1/2; of what is still to turn, 3/2, a slide of
/// l ln 2 leaves a half. A sample that does not count begins with nothing turned over.
TEST(ForceModel, FrictionWithAMemoryBeginsAsItWasRead) {
  const ForceTerms terms{ForceTerm::preload, ForceTerm::presliding};
  ForceRecord begun = record({0, 0.01 * std::log(2)}, 1, 10);
  begun.input_N[0] = 9;
  EXPECT_NEAR(predicted(begun, terms, {1, 0, 2, 0.01}), 10 + 2 * 0.25, 1e-9);
  begun.input_N[0] = 3;  // no friction does that
  EXPECT_NEAR(predicted(begun, terms, {1, 0, 2, 0.01}), 10, 1e-9);
  begun.used[0] = false;
  EXPECT_NEAR(predicted(begun, terms, {1, 0, 2, 0.01}), 10 + 2 * 0.5, 1e-9);
}

/// 3 N of friction stretch 300 N/m by 10 mm, 6 N by 20 mm.
TEST(ForceModel, ATendonThatStretchesTurnsMoreFrictionOverALongerWay) {
  const ForceTerms terms{ForceTerm::preload, ForceTerm::elastic_presliding};
  EXPECT_NEAR(predicted(record({0, 0.01}, 1, 10), terms, {1, 0, 3, 300}),
              10 + 3 * (1 - std::exp(-1)), 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.01}, 1, 10), terms, {1, 0, 6, 300}),
              10 + 6 * (1 - std::exp(-0.5)), 1e-9);
}

TEST(ForceModel, SlackTransmitsNoFrictionUntilItIsTakenUp) {
  const ForceTerms terms{ForceTerm::preload, ForceTerm::slack};
  EXPECT_NEAR(predicted(record({0, 0.05, 0.049}, -1, 10), terms, {1, 0, 3, 0.01}), 10, 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.05, 0.03}, -1, 10), terms, {1, 0, 3, 0.01}), 7, 1e-9);
}

/// dT/dphi = mu (T/10 N)^-k T over pi, by steps of the middle.
double along_sheath_N(double output_N, double mu, double exponent, double side) {
  constexpr int kSteps = 20000;
  const auto rate = [&](double tension_N) {
    return side * mu * std::pow(tension_N / 10, -exponent) * tension_N;
  };
  double tension_N = output_N;
  for (int i = 0; i < kSteps; ++i) {
    const double middle_N = tension_N + rate(tension_N) * pi / kSteps / 2;
    tension_N += rate(middle_N) * pi / kSteps;
  }
  return tension_N;
}

/// Strokes of 20 mm at 2 Hz, of which each sample in `every` of a millisecond is kept.
ForceRecord strokes(std::size_t every) {
  std::vector<double> times_s;
  std::vector<double> positions_m;
  std::vector<double> velocities_m_s;
  for (std::size_t i = 0; i < 2000; i += every) {
    times_s.push_back(1e-3 * static_cast<double>(i));
    const double turn = 4 * pi * times_s.back() + 0.3;
    positions_m.push_back(0.01 * std::sin(turn));
    velocities_m_s.push_back(0.01 * 4 * pi * std::cos(turn));
  }
  ForceRecord moving = record(positions_m, 0, 10);
  moving.time_s = times_s;
  moving.velocity_m_s = velocities_m_s;
  moving.reversal_m = reversals_m(moving);
  return moving;
}

/// By samples 27 ms apart a force is what it is by samples of each millisecond, which come near to
/// all reversals.
TEST(ForceModel, MotionTurnsBetweenSamples) {
  const struct {
    ForceTerm term;
    std::vector<double> parameters;
  } laws[] = {{ForceTerm::presliding, {1, 0.1, 0.002}},
              {ForceTerm::elastic_presliding, {1, 0.1, 1500}},
              {ForceTerm::slack, {1, 0.1, 0.003}},
              {ForceTerm::loose_tendon, {1, 0.1, 0.003, 0.5, 1}},
              {ForceTerm::compliance, {1, 0.1, 2000}}};
  constexpr std::size_t kEvery = 27;
  const ForceRecord fine = strokes(1);
  const ForceRecord coarse = strokes(kEvery);
  for (const auto& [term, parameters] : laws) {
    std::vector<double> fine_N;
    std::vector<double> coarse_N;
    predict_input(fine, kinematics_of(fine, kScales), {term}, kScales, parameters, fine_N);
    predict_input(coarse, kinematics_of(coarse, kScales), {term}, kScales, parameters, coarse_N);
    double most_N = 0;
    for (std::size_t i = 1; i < coarse_N.size(); ++i) {
      most_N = std::max(most_N, std::abs(coarse_N[i] - fine_N[i * kEvery]));
    }
    EXPECT_LT(most_N, 0.1) << law_of(term).id();
  }
}

TEST(ForceModel, FrictionFallsRelativeToTheLoadAlongTheSheath) {
  for (const double exponent : {-0.2, 0.3, 1.0}) {
    for (const double output_N : {2.0, 100.0}) {
      const std::vector<double> parameters{1, 0.1, exponent};
      EXPECT_NEAR(predicted(record({0, 0.1}, 1, output_N), {ForceTerm::load}, parameters),
                  along_sheath_N(output_N, 0.1, exponent, 1), 1e-5 * output_N)
          << exponent;
    }
    EXPECT_NEAR(predicted(record({0.1, 0}, -1, 100), {ForceTerm::load}, {1, 0.1, exponent}),
                along_sheath_N(100, 0.1, exponent, -1), 1e-3)
        << exponent;
  }
  // At k = 1 friction is 0.5 * 10 N * pi, more than is there.
  EXPECT_NEAR(predicted(record({0.1, 0}, -1, 2), {ForceTerm::load}, {1, 0.5, 1}), 0, 0.02);
}

TEST(ForceModel, PositionMultipliesAllFrictionOfTheSheath) {
  // Waves are 1.25 strokes of 0.2 m long: a quarter of that from the middle the sine is 1.
  EXPECT_NEAR(predicted(record({0, 0.0625}, 1, 10), {ForceTerm::preload, ForceTerm::position},
                        {1, 0, 3, 0.2, 0, 0, 0, 0, 0, 0, 0, 0, 0}),
              10 + 3 * 1.2, 1e-9);
  // The fourth harmonic is back at zero there, and its cosine at 1.
  EXPECT_NEAR(predicted(record({0, 0.0625}, 1, 10), {ForceTerm::preload, ForceTerm::position},
                        {1, 0, 3, 0, 0, 0, 0, 0, 0, 0.5, 0.1, 0, 0}),
              10 + 3 * 1.1, 1e-9);
}

/// Where only the velocity is known a place is found again by the middle of the stroke: 0.06 m
/// in one of 0.02 .. 0.1 m is its middle, 0.135 m in one of 0.01 .. 0.135 m a quarter of a wave
/// beyond it.
TEST(ForceModel, PositionMayCountFromTheMiddleOfTheRecord) {
  const ForceTerms terms{ForceTerm::preload, ForceTerm::position_from_middle};
  const std::vector<double> parameters{1, 0, 3, 0.2, 0.3, 0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_NEAR(predicted(record({0.02, 0.1, 0.06}, 1, 10), terms, parameters), 10 + 3 * 1.3, 1e-9);
  EXPECT_NEAR(predicted(record({0.01, 0.135}, 1, 10), terms, parameters), 10 + 3 * 1.2, 1e-9);
  ForceRecord of_rotor = record({0, 0.1}, 1, 10);
  EXPECT_TRUE(is_shown(terms[1], std::span(&of_rotor, 1)));
  of_rotor.rotor_known = true;
  EXPECT_FALSE(is_shown(terms[1], std::span(&of_rotor, 1)));
  EXPECT_TRUE(is_shown(ForceTerm::position, std::span(&of_rotor, 1)));
}

/// Of two lags of 50 ms each a step leaves (1 + x) exp(-x) after x of them: the motion turns at
/// 0.05 s, and 0.05 s and 0.15 s later friction has gone from -1 to 1 but for twice 0.735759 and
/// twice 0.199148.
TEST(ForceModel, FilteredForcesFollowTheMotionLate) {
  ForceRecord turning = record({0, 0, 0}, 1, 10);
  turning.velocity_m_s = {-1, 1, 1};
  ForceScales late = kScales;
  late.forces_late_s = 0.1;
  const std::vector<double> turned = kinematics_of(turning, late).turned_over;
  ASSERT_EQ(turned.size(), 3U);
  EXPECT_NEAR(turned[0], -1, 1e-9);
  EXPECT_NEAR(turned[1], 1 - 2 * 0.735759, 1e-6);
  EXPECT_NEAR(turned[2], 1 - 2 * 0.199148, 1e-6);
}

/// A velocity in steps of 0.02 m/s that goes there and back by one of them is at rest, until it
/// sets in for good.
TEST(ForceModel, WhatRestsStaysTurnedOver) {
  ForceRecord resting = record({0, 0, 0, 0, 0, 0, 0}, 1, 10);
  resting.velocity_m_s = {2, 0, -0.02, 0.02, 0, -0.02, -0.06};
  ForceScales late = kScales;
  late.forces_late_s = 1e-6;
  const std::vector<double> turned = kinematics_of(resting, late).turned_over;
  ASSERT_EQ(turned.size(), 7U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(turned[i], 1, 1e-6) << i;
  }
  EXPECT_LT(turned[5], -0.9);
  EXPECT_LT(turned[6], -0.9);
}

TEST(ForceModel, SlopesOfWavesAreThoseOfSteps) {
  // T_in is 10 exp(mu (1 + g) pi) + 3 (1 + g), and g is h at a quarter of a wave of 0.25 m.
  const ForceRecord moving = record({0, 0.0625}, 1, 10);
  const ForceTerms terms{ForceTerm::preload, ForceTerm::position};
  std::vector<double> parameters{1, 0.1, 3};
  parameters.resize(13);
  const Kinematics kinematics = kinematics_of(moving, kScales);
  std::vector<double> at_N;
  predict_input(moving, kinematics, terms, kScales, parameters, at_N);
  std::vector<double> slopes_N;
  ASSERT_TRUE(position_slopes(moving, kinematics, terms, kScales, parameters, at_N, 1, slopes_N));
  ASSERT_EQ(slopes_N.size(), 20U);
  const double by_share_N = 10 * std::exp(0.1 * pi) * 0.1 * pi + 3;
  // sin and cos of 1, 2, 3, 4 and 5 quarters of a turn.
  const double waves[] = {1, 0, 0, -1, -1, 0, 0, 1, 1, 0};
  for (std::size_t k = 0; k < 10; ++k) {
    EXPECT_NEAR(slopes_N[10 + k], waves[k] * by_share_N, 1e-4) << k;
  }

  EXPECT_FALSE(position_slopes(moving, kinematics, terms, kScales, parameters, at_N, 0, slopes_N));
}

TEST(ForceModel, AMemoryOfFrictionHasNoSlopesOfWaves) {
  const ForceRecord moving = record({0, 0.0625}, 1, 10);
  for (const auto& [term, value] :
       {std::pair{ForceTerm::compliance, 1e3}, std::pair{ForceTerm::elastic_presliding, 1e3},
        std::pair{ForceTerm::lag, -0.1}, std::pair{ForceTerm::delay, 0.05}}) {
    std::vector<double> parameters{1, 0.1, value};
    parameters.resize(13);
    const ForceTerms terms{term, ForceTerm::position};
    const Kinematics kinematics = kinematics_of(moving, kScales);
    std::vector<double> at_N;
    predict_input(moving, kinematics, terms, kScales, parameters, at_N);
    std::vector<double> slopes_N;
    EXPECT_FALSE(position_slopes(moving, kinematics, terms, kScales, parameters, at_N, 1, slopes_N))
        << static_cast<unsigned>(term);
  }
}

TEST(ForceModel, SensorsShiftAndDelayTheOutput) {
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 10), {ForceTerm::zero}, {1, 0, 0.5}), 9.5, 1e-9);
  ForceRecord rising = record({0, 0.1}, 1, 10);
  rising.output_rate_N_s.assign(2, 20);
  EXPECT_NEAR(predicted(rising, {ForceTerm::lag}, {1, 0, 0.01}), 10.2, 1e-9);
}

/// T = 1000 t^2 at 0, 0.1 and 0.2 s, of which cubics by the rates are exact; what is before or
/// after them is as at the ends. The motion is late with the input, and not with the output.
TEST(ForceModel, AChannelIsReadWhereItWasLate) {
  ForceRecord rising = record({0, 0.1, 0.1}, 1, 10);
  rising.output_N = {0, 10, 40};
  rising.output_rate_N_s = {0, 200, 400};
  rising.velocity_m_s = {1, 1, -1};
  const auto input_N = [&](std::size_t sample, double delay_s, double preload_N) {
    std::vector<double> all_N;
    const ForceScales scales = scales_of(std::span(&rising, 1));
    predict_input(rising, kinematics_of(rising, scales), {ForceTerm::preload, ForceTerm::delay},
                  scales, std::vector{1.0, 0.0, preload_N, delay_s}, all_N);
    return all_N.at(sample);
  };
  EXPECT_NEAR(input_N(0, 0.02, 0), 0.4, 1e-9);
  EXPECT_NEAR(input_N(0, 0.12, 0), 14.4, 1e-9);
  EXPECT_NEAR(input_N(1, 0.12, 0), 40, 1e-9);
  EXPECT_NEAR(input_N(2, -0.12, 0), 6.4, 1e-9);
  EXPECT_NEAR(input_N(0, -0.1, 0), 0, 1e-9);
  EXPECT_NEAR(input_N(2, 0.05, 3), 40 - 3, 1e-9);
  EXPECT_NEAR(input_N(2, -0.1, 3), 10 + 3, 1e-9);
  EXPECT_NEAR(input_N(2, -0.05, 3), 22.5, 1e-9);  // halfway between 3 N this way and that
}

/// One step of 0.1 s on a line from 10 to 20 N, read with a lag of 0.05 s: 100 N/s times the lag
/// behind, less what is not yet behind, exp(-2) of it.
TEST(ForceModel, AnInputSensorFollowsWithItsLag) {
  ForceRecord rising = record({0, 0.1}, 1, 10);
  rising.output_N[1] = 20;
  EXPECT_NEAR(predicted(rising, {ForceTerm::lag}, {1, 0, -0.05}), 20 - 5 * (1 - std::exp(-2)),
              1e-9);
}

/// Friction of 2 N turns from 12 to 8 N where the speed goes through zero, 0.075 s before the
/// second sample: exp(-1.5) of the step is still to come. Over a length it turns on a line.
TEST(ForceModel, AnInputSensorFollowsAStepFromWhereTheMotionTurned) {
  ForceRecord turning = record({0, -0.05}, 1, 10);
  turning.input_N[0] = 12;
  turning.velocity_m_s[1] = -3;
  EXPECT_NEAR(predicted(turning, {ForceTerm::preload, ForceTerm::lag}, {1, 0, 2, -0.05}),
              8 + 4 * std::exp(-1.5), 1e-9);
  EXPECT_NEAR(predicted(turning, {ForceTerm::preload, ForceTerm::compliance, ForceTerm::lag},
                        {1, 0, 2, 1e6, -0.05}),
              8 + 4 / 2.0 * (1 - std::exp(-2)), 1e-6);
}

TEST(ForceModel, FrictionChangesWithTheCyclesOfTheTendon) {
  ForceRecord old = record({0, 0.1}, 1, 10);
  old.cycle.assign(2, 4000);
  // 4^0.5 = 2 times 0.3.
  EXPECT_NEAR(predicted(old, {ForceTerm::wear}, {1, 0.1, 0.3, 0.5}), 10 * std::exp(0.16 * pi),
              1e-9);
  EXPECT_NEAR(predicted(old, {ForceTerm::run_in}, {1, 0.1, 0.5, 4000}),
              10 * std::exp(0.1 * (1 + 0.5 * std::exp(-1)) * pi), 1e-9);
  EXPECT_TRUE(is_shown(ForceTerm::wear, std::vector{old}));
  EXPECT_FALSE(is_shown(ForceTerm::run_in, std::vector{record({0, 0.1}, 1, 10)}));
}

/// Of the poses of 90 and 180 deg the larger is taken to be right.
TEST(ForceModel, APoseBendsMoreThanItWasSaidTo) {
  ForceRecord bent = record({0, 0.1}, 1, 10);
  const ForceTerms terms{ForceTerm::bend_angle};
  EXPECT_NEAR(predicted(bent, terms, {1, 0.1, 0.2}), 10 * std::exp(0.1 * pi), 1e-9);
  bent.bend_angle_rad.assign(2, 1.5);
  EXPECT_NEAR(predicted(bent, terms, {1, 0.1, 0.2}), 10 * std::exp(0.17), 1e-9);
  EXPECT_EQ(parameters_of(ForceTerm::bend_angle, kScales).at(0).name,
            "bend_angle_error_rad_at_90_deg");
}

/// T_out 10 N, friction 2 N: 12 N sliding one way, 8 N the other. From 12 N a spring of 30 N/m
/// gives 3 N for 0.1 m back, and stays where friction holds no more.
TEST(ForceModel, ASpringFollowsTheMotionWithinWhatFrictionHolds) {
  ForceRecord back = record({0, -0.05}, 1, 10);
  back.input_N[0] = 12;
  EXPECT_NEAR(predicted(back, {ForceTerm::preload, ForceTerm::compliance}, {1, 0, 2, 30}), 10.5,
              1e-6);
  back.position_m[1] = -0.3;
  back.reversal_m[1] = -0.3;
  EXPECT_NEAR(predicted(back, {ForceTerm::preload, ForceTerm::compliance}, {1, 0, 2, 30}), 8, 1e-6);
}

/// Between an output of 10 N and one of 20 N the motion turns half way, at 15 N: friction of 8 N
/// holds no more than 23 N there, of which 100 N/m lets go of 5 N in 0.05 m.
TEST(ForceModel, ASpringIsHeldByTheFrictionThatIsThereWhereTheMotionTurns) {
  ForceRecord turning = record({0, 0.05}, 1, 10);
  turning.output_N[1] = 20;
  turning.input_N[0] = 18;
  turning.reversal_m[1] = 0.1;
  turning.velocity_m_s[1] = -1;
  EXPECT_NEAR(predicted(turning, {ForceTerm::preload, ForceTerm::compliance}, {1, 0, 8, 100}), 18,
              1e-6);
}

/// Friction of 2 N that turns over by a half, from -1 to 0, in a slide of l ln 2 takes the input
/// from 8 to 10 N, which stretches 100 N/m by 20 mm beside it.
TEST(ForceModel, ATendonThatStretchesSlidesLessThanTheDriveMoves) {
  const double length_m = 0.01;
  const double moved_m = length_m * std::log(2) + 0.02;
  ForceRecord pulling = record({0, moved_m}, 1, 10);
  pulling.input_N[0] = 8;
  EXPECT_NEAR(predicted(pulling, {ForceTerm::preload, ForceTerm::presliding, ForceTerm::compliance},
                        {1, 0, 2, length_m, 100}),
              10, 1e-6);
}

/// In 0.1 s a drive moves 20 mm. Half of it stretches 100 N/m by 1 N, and half slides at 0.1 m/s,
/// against 10 N s/m.
TEST(ForceModel, ATendonThatStretchesSlidesSlowerThanTheDriveMoves) {
  EXPECT_NEAR(predicted(record({0, 0.02}, 1, 10), {ForceTerm::velocity, ForceTerm::compliance},
                        {1, 0, 10, 0, 100}),
              11, 1e-6);
}

/// 1 + 0.01 (35 - 20) of 2 N.
TEST(ForceModel, FrictionGoesWithTemperature) {
  ForceRecord warm = record({0, 0.1}, 1, 10);
  warm.sheath_temperature_C.assign(2, 35);
  EXPECT_NEAR(predicted(warm, {ForceTerm::preload, ForceTerm::temperature}, {1, 0, 2, 0.01}), 12.3,
              1e-9);
}

/// 2 N/A: of 10 N the sensor that shows 0.5 A too much shows 11 N, whatever the gain.
TEST(ForceModel, CurrentIsShiftedBeforeTheGainOfTheMotor) {
  ForceRecord current = record({0, 0.1}, 1, 10);
  current.input_N_per_A = 2;
  EXPECT_NEAR(predicted(current, {ForceTerm::current_offset}, {1, 0, 0.5}), 11, 1e-9);
  EXPECT_NEAR(predicted(current, {ForceTerm::current_offset}, {3, 0, 0.5}), 31, 1e-9);
}

/// A gear that gives 1.25 times the nominal tension while it pulls needs 8 N for 10 N, and 10/0.75
/// N on the way back.
TEST(ForceModel, AGearIsBetterOneWayThanTheOther) {
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 10), {ForceTerm::gear_asymmetry}, {1, 0, 0.25}), 8,
              1e-9);
  EXPECT_NEAR(predicted(record({0.1, 0}, -1, 10), {ForceTerm::gear_asymmetry}, {1, 0, 0.25}),
              10 / 0.75, 1e-9);
}

/// At 70 C a motor has 0.9 of its torque for each ampere, and needs 1/0.9 of the current.
TEST(ForceModel, AWarmMotorNeedsMoreCurrent) {
  ForceRecord warm = record({0, 0.1}, 1, 9);
  warm.input_N_per_A = 2;
  EXPECT_FALSE(is_shown(ForceTerm::torque_gain, std::vector{warm}));
  warm.winding_temperature_C.assign(2, 70);
  EXPECT_TRUE(is_shown(ForceTerm::torque_gain, std::vector{warm}));
  EXPECT_NEAR(predicted(warm, {ForceTerm::torque_gain}, {1, 0, 0.002}), 10, 1e-9);
}

/// T_in is 2 N/A times I + a sin(k theta) + b cos(k theta): where ripple adds 0.25 A, 10 N show as
/// 9.5 N.
TEST(ForceModel, RippleGoesWithTheAngleOfTheRotor) {
  ForceRecord turned = record({0, 0.1}, 1, 10);
  turned.input_N_per_A = 2;
  EXPECT_FALSE(is_shown(ForceTerm::torque_ripple, std::vector{turned}));
  turned.rotor_rad.assign(2, pi / 6);
  EXPECT_TRUE(is_shown(ForceTerm::torque_ripple, std::vector{turned}));
  EXPECT_NEAR(predicted(turned, {ForceTerm::torque_ripple}, {1, 0, 0.25, 0, 3}), 9.5, 1e-9);
  EXPECT_NEAR(predicted(turned, {ForceTerm::torque_ripple}, {1, 0, 0, -0.25, 6}), 9.5, 1e-9);
}

/// Shares 0.4, 0.2 and -0.1 at a quarter, a half and twice of 10 N, on lines over the logarithm.
TEST(ForceModel, FrictionMayDependOnTheLoadInAnyWay) {
  EXPECT_TRUE(law_of(ForceTerm::friction_by_load).outside);
  const auto friction_of = [&](double load_N) {
    const double input_N = predicted(record({0, 0.1}, 1, load_N), {ForceTerm::friction_by_load},
                                     {1, 0.1, 0.4, 0.2, -0.1});
    return std::log(input_N / load_N) / (0.1 * pi);
  };
  EXPECT_NEAR(friction_of(1), 1.4, 1e-9);
  EXPECT_NEAR(friction_of(2.5), 1.4, 1e-9);
  EXPECT_NEAR(friction_of(2.5 * std::sqrt(2)), 1.3, 1e-9);
  EXPECT_NEAR(friction_of(5), 1.2, 1e-9);
  EXPECT_NEAR(friction_of(5 * std::sqrt(2)), 1.1, 1e-9);
  EXPECT_NEAR(friction_of(10), 1, 1e-9);
  EXPECT_NEAR(friction_of(10 * std::sqrt(2)), 0.95, 1e-9);
  EXPECT_NEAR(friction_of(50), 0.9, 1e-9);
}

/// The same of the speed, 0.4 at rest, 0.2 at a quarter, -0.1 at the usual speed, and of a preload.
TEST(ForceModel, FrictionMayDependOnTheSpeedInAnyWay) {
  EXPECT_TRUE(law_of(ForceTerm::friction_by_speed).outside);
  const auto share_at = [](double speeds) {
    const ForceRecord back = record({0.1, 0}, -speeds * kScales.speed_m_s, 10);
    return (predicted(back, {ForceTerm::preload, ForceTerm::friction_by_speed},
                      {1, 0, 3, 0.4, 0.2, -0.1}) -
            10) /
           (predicted(back, {ForceTerm::preload}, {1, 0, 3}) - 10);
  };
  EXPECT_NEAR(share_at(0.125), 1.3, 1e-9);
  EXPECT_NEAR(share_at(0.25), 1.2, 1e-9);
  EXPECT_NEAR(share_at(0.375), 1.1, 1e-9);
  EXPECT_NEAR(share_at(0.5), 1, 1e-9);
  EXPECT_NEAR(share_at(0.75), 0.95, 1e-9);
  EXPECT_NEAR(share_at(2), 0.9, 1e-9);
}

TEST(ForceModel, ASheathThatGivesBendsByTheLoad) {
  EXPECT_TRUE(law_of(ForceTerm::giving_sheath).outside);
  // At twice the scale of force by a fifth more, at half of it by a tenth less.
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 20), {ForceTerm::giving_sheath}, {1, 0.1, 0.2}),
              20 * std::exp(0.1 * 1.2 * pi), 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, -5), {ForceTerm::giving_sheath}, {1, 0.1, 0.2}),
              -5 * std::exp(-0.1 * 0.9 * pi), 1e-9);
}

/// 3 N and a fifth more one way, a fifth less the other.
TEST(ForceModel, FrictionMayBeLargerOneWayThanTheOther) {
  const ForceTerms terms{ForceTerm::preload, ForceTerm::one_way_friction};
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 10), terms, {1, 0, 3, 0.2}), 13.6, 1e-9);
  EXPECT_NEAR(predicted(record({0, -0.1}, -1, 10), terms, {1, 0, 3, 0.2}), 7.6, 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 10), {ForceTerm::one_way_friction}, {1, 0.1, 0.2}),
              10 * std::exp(0.12 * pi), 1e-9);
}

TEST(ForceModel, ASensorThatIsNotLinearShowsALargeForceTooSmall) {
  EXPECT_TRUE(law_of(ForceTerm::bent_sensor).outside);
  // A tenth at the scale of force, four tenths at twice of it, whatever its sign.
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 20), {ForceTerm::bent_sensor}, {1, 0, 0.1}), 28, 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, -10), {ForceTerm::bent_sensor}, {1, 0, 0.1}), -11,
              1e-9);
}

/// A tenth of the input after long, 1 - 1/e of it after the time constant: 0.1 s from the start.
TEST(ForceModel, AnInputThatSettlesStartsAnewInEachSession) {
  EXPECT_TRUE(law_of(ForceTerm::drifting_gain).outside);
  const ForceTerms terms{ForceTerm::drifting_gain};
  EXPECT_NEAR(predicted(record({0}, 1, 10), terms, {1, 0, 0.1, 0.1}), 10, 1e-9);
  EXPECT_NEAR(predicted(record({0, 0.1}, 1, 10), terms, {1, 0, 0.1, 0.1}),
              10 * (1 + 0.1 * (1 - std::exp(-1))), 1e-9);
  ForceRecord late = record({0, 0.1}, 1, 10);
  late.time_s = {100, 100.1};
  EXPECT_NEAR(predicted(late, terms, {1, 0, 0.1, 0.1}), 10 * (1 + 0.1 * (1 - std::exp(-1))), 1e-9);
}

/// 0.2 N/K at 30 C, of an input that shows twice the force.
TEST(ForceModel, AZeroThatGoesWithTheTemperatureIsNoFriction) {
  EXPECT_TRUE(law_of(ForceTerm::warm_sensor).outside);
  ForceRecord warm = record({0, 0.1}, 1, 10);
  EXPECT_FALSE(is_shown(ForceTerm::warm_sensor, std::span(&warm, 1)));
  warm.sheath_temperature_C = {30, 30};
  EXPECT_TRUE(is_shown(ForceTerm::warm_sensor, std::span(&warm, 1)));
  EXPECT_NEAR(predicted(warm, {ForceTerm::warm_sensor}, {2, 0, 0.2}), 24, 1e-9);
}

TEST(ForceModel, WhatACurrentShowsALoadCellDoesNot) {
  std::vector<ForceRecord> records{record({0, 0.1}, 1, 10), record({0, 0.1}, 1, 10)};
  records[0].input_N_per_A = 2;
  EXPECT_FALSE(is_shown(ForceTerm::current_offset, records));
  EXPECT_FALSE(is_shown(ForceTerm::gear_asymmetry, records));
  records[1].input_N_per_A = 2;
  EXPECT_TRUE(is_shown(ForceTerm::current_offset, records));
  EXPECT_TRUE(is_shown(ForceTerm::gear_asymmetry, records));
  EXPECT_FALSE(is_shown(ForceTerm::temperature, records));
}

TEST(ForceModel, ScalesAreOfAllRecords) {
  std::vector<ForceRecord> records{record({-0.1, 0.1}, 0.2, 3), record({0, 0}, -0.4, -3)};
  const ForceScales scales = scales_of(records);
  EXPECT_DOUBLE_EQ(scales.force_N, 3);
  EXPECT_GT(scales.speed_m_s, 0);
  EXPECT_GT(scales_of({}).stroke_m, 0);
}

}  // namespace
}  // namespace host_sim::effects
