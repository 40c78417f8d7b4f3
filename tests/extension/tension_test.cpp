#include "host_sim/extension/tension.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/extension/models.hpp"

namespace host_sim {
namespace {

using extension_test::model_with;

constexpr double kPhi = 1.5 * std::numbers::pi;  // 270 deg
constexpr double kMu = 0.128;

Covariates pulling() {
  Covariates at;
  at.bend_angle_rad = kPhi;
  return at;
}

double from_output_N(std::string_view tables, double output_N, const Covariates& at) {
  return ExtendedInput(model_with(tables)).from_output_N(output_N, at);
}

double from_current_N(std::string_view tables, double current_A, const Covariates& at) {
  return ExtendedInput(model_with(tables)).from_current_N(current_A, at);
}

TEST(ExtendedInput, WithoutExtensionsItIsTheCapstanLaw) {
  Covariates at = pulling();
  EXPECT_NEAR(from_output_N("", 49, at), 49 * std::exp(kMu * kPhi), 1e-12);
  at.direction = -1;
  EXPECT_NEAR(from_output_N("", 49, at), 49 * std::exp(-kMu * kPhi), 1e-12);
}

TEST(ExtendedInput, WithoutExtensionsItIsTheDrive) {
  // 0.0325 * 9 * 0.88 / 0.0125 = 20.592 N/A
  EXPECT_NEAR(from_current_N("", 2, pulling()), 41.184, 1e-12);
}

TEST(ExtendedInput, WearGrowsWithTheCycles) {
  Covariates at = pulling();
  at.cycle = 4000;
  // 1 + 0.3 * 4^0.5 = 1.6
  EXPECT_NEAR(from_output_N("[extension.friction_wear]\nwear_coefficient = 0.3\n"
                            "wear_exponent = 0.5\nrun_in_cycles = 0\n",
                            49, at),
              49 * std::exp(1.6 * kMu * kPhi), 1e-10);
}

TEST(ExtendedInput, RunInFades) {
  Covariates at = pulling();
  at.cycle = 1000 * std::numbers::ln2;
  // 1 + 0.3 / 2 after n0 ln 2 cycles
  EXPECT_NEAR(from_output_N("[extension.friction_wear]\nwear_coefficient = 0.3\n"
                            "wear_exponent = 0\nrun_in_cycles = 1000\n",
                            49, at),
              49 * std::exp(1.15 * kMu * kPhi), 1e-10);
}

TEST(ExtendedInput, TemperatureCountsFromItsReference) {
  Covariates at = pulling();
  at.sheath_temperature_C = 45;
  EXPECT_NEAR(from_output_N("[extension.friction_temperature]\n"
                            "temperature_coefficient_1_K = 0.01\nsheath_reference_C = 25\n",
                            49, at),
              49 * std::exp(1.2 * kMu * kPhi), 1e-10);
}

TEST(ExtendedInput, VelocityAddsToMu) {
  Covariates at = pulling();
  at.direction = -1;
  at.velocity_m_s = -0.02;
  // 0.05/e + 0.5 * 0.02
  const double mu = kMu + 0.05 / std::numbers::e + 0.01;
  EXPECT_NEAR(from_output_N("[extension.friction_velocity]\nstribeck_friction = 0.05\n"
                            "viscous_friction_s_m = 0.5\nstribeck_velocity_m_s = 0.02\n",
                            49, at),
              49 * std::exp(-mu * kPhi), 1e-10);
}

TEST(ExtendedInput, LoadFollowsTheSheath) {
  // With k = 1: T_in + ... : dT/dphi = mu 50 N, so T grows evenly.
  EXPECT_NEAR(from_output_N("[extension.friction_load]\nload_exponent = 1\n", 30, pulling()),
              30 + 50 * kMu * kPhi, 1e-10);
  // With k = -1: dT/dphi = mu T^2 / 50 N, so 1/T falls evenly.
  EXPECT_NEAR(from_output_N("[extension.friction_load]\nload_exponent = -1\n", 30, pulling()),
              1 / (1 / 30.0 - kMu * kPhi / 50), 1e-10);
}

TEST(ExtendedInput, LoadDependenceOfNoneIsTheCapstanLaw) {
  EXPECT_NEAR(from_output_N("[extension.friction_load]\nload_exponent = 1e-9\n", 30, pulling()),
              30 * std::exp(kMu * kPhi), 1e-6);
}

TEST(ExtendedInput, PreloadHelpsWhileLettingGo) {
  Covariates at = pulling();
  EXPECT_NEAR(from_output_N("[extension.friction_preload]\npreload_N = 2\n", 49, at),
              49 * std::exp(kMu * kPhi) + 2, 1e-12);
  at.direction = -1;
  EXPECT_NEAR(from_output_N("[extension.friction_preload]\npreload_N = 2\n", 49, at),
              49 * std::exp(-kMu * kPhi) - 2, 1e-12);
}

TEST(ExtendedInput, PositionGoesWithTheRotor) {
  Covariates at = pulling();
  // A quarter of the wavelength of 0.08 m: 0.02 m = theta * 0.0125 m / 9.
  at.motor_angle_rad = 0.02 * 9 / 0.0125;
  const std::string table =
      "[extension.friction_position]\nposition_sine_1 = 0.2\nposition_cosine_1 = 0.4\n"
      "position_sine_2 = 0.3\nposition_cosine_2 = 0.05\nposition_sine_3 = 0.01\n"
      "position_cosine_3 = 0.6\nposition_sine_4 = 0\nposition_cosine_4 = 0\nposition_sine_5 = 0\n"
      "position_cosine_5 = 0\nposition_sine_6 = 0\nposition_cosine_6 = 0\nwavelength_m = 0.08\n";
  // sin, cos of 90, 180 and 270 deg: 1 + 0.2 - 0.05 - 0.01
  EXPECT_NEAR(from_output_N(table, 49, at), 49 * std::exp(1.14 * kMu * kPhi), 1e-10);
}

TEST(ExtendedInput, PositionIsThatOfThePreloadToo) {
  Covariates at = pulling();
  at.motor_angle_rad = 0.02 * 9 / 0.0125;  // a quarter of the wavelength
  std::string table =
      "[extension.friction_preload]\npreload_N = 10\n[extension.friction_position]\n";
  for (int harmonic = 1; harmonic <= 6; ++harmonic) {
    const std::string number = std::to_string(harmonic);
    table += "position_sine_" + number + (harmonic == 1 ? " = 0.2\n" : " = 0\n") +
             "position_cosine_" + number + " = 0\n";
  }
  EXPECT_NEAR(from_output_N(table + "wavelength_m = 0.08\n", 49, at),
              49 * std::exp(1.2 * kMu * kPhi) + 12, 1e-10);
}

TEST(ExtendedInput, ViscousForceGoesWithTheSpeedAndNotWithTheLoad) {
  Covariates at = pulling();
  at.velocity_m_s = 0.2;
  constexpr const char* kTable = "[extension.friction_velocity]\nviscous_N_s_m = 30\n";
  EXPECT_NEAR(from_output_N(kTable, 49, at), 49 * std::exp(kMu * kPhi) + 6, 1e-10);
  EXPECT_NEAR(from_output_N(kTable, 0, at), 6, 1e-12);
  at.direction = -1;
  at.velocity_m_s = -0.2;
  EXPECT_NEAR(from_output_N(kTable, 49, at), 49 * std::exp(-kMu * kPhi) - 6, 1e-10);
}

TEST(ExtendedInput, FrictionOfAForceTheOtherWayWorksAgainstTheMotionToo) {
  Covariates at = pulling();
  constexpr const char* kTable = "[extension.friction_preload]\npreload_N = 2\n";
  // Friction makes less of -49 N where the motion is against it, by 49 (1 - exp(-mu phi)).
  EXPECT_NEAR(from_output_N(kTable, -49, at), -49 * std::exp(-kMu * kPhi) + 2, 1e-12);
  at.direction = -1;
  EXPECT_NEAR(from_output_N(kTable, -49, at), -49 * std::exp(kMu * kPhi) - 2, 1e-12);
}

TEST(ExtendedInput, LoadDependenceIsOfTheSizeOfTheForce) {
  Covariates at = pulling();
  at.direction = -1;
  EXPECT_NEAR(from_output_N("[extension.friction_load]\nload_exponent = 1\n", -30, at),
              -30 - 50 * kMu * kPhi, 1e-10);
}

TEST(ExtendedInput, TheZeroOfTheLoadCellIsTakenOut) {
  EXPECT_NEAR(from_output_N("[extension.load_cell_zero]\nzero_N = -1.5\n", 49, pulling()),
              50.5 * std::exp(kMu * kPhi), 1e-10);
}

/// dz/dx = (s - z)/l: from 0 after a length 1 - 1/e; turned, from there to -1.
TEST(ExtendedInput, FrictionTurnsOverAlongTheWay) {
  const std::string table =
      "[extension.presliding]\npresliding_length_m = 0.001\n"
      "[extension.friction_preload]\npreload_N = 10\n"
      "[extension.friction_velocity]\nviscous_N_s_m = 50\n";
  ExtendedInput input(model_with(table));
  Covariates at = pulling();
  at.velocity_m_s = 0.1;  // 0.1 mm a sample, and 5 N of viscous friction
  double last_N = 0;
  for (int i = 0; i < 10; ++i) {
    last_N = input.from_output_N(49, at);
  }
  const double first = 1 - 1 / std::numbers::e;
  EXPECT_NEAR(last_N, 49 * std::exp(kMu * kPhi * first) + 15 * first, 1e-10);
  at.velocity_m_s = 0;  // what stands still keeps its slip
  EXPECT_NEAR(input.from_output_N(49, at), 49 * std::exp(kMu * kPhi * first) + 10 * first, 1e-10);
  at.velocity_m_s = -0.1;
  at.direction = -1;
  for (int i = 0; i < 5; ++i) {
    last_N = input.from_output_N(49, at);
  }
  const double second = -1 + (first + 1) / std::sqrt(std::numbers::e);
  EXPECT_NEAR(last_N, 49 * std::exp(kMu * kPhi * second) + 15 * second, 1e-10);
}

/// 1 N at 10, 3 N at 20 while pulling, and twice that the other way round while letting go.
std::string correction(std::string_view covariate, std::string_view knots) {
  return "[extension.empirical]\n" + std::string(covariate) + " = [" + std::string(knots) +
         "]\npulling_N = [1, 3]\nletting_go_N = [-2, -6]\n";
}

TEST(ExtendedInput, ACorrectionIsLinearBetweenItsKnotsAndConstantBeyond) {
  const std::string table = correction("output_tension_N", "10, 20");
  Covariates at;  // no bend
  EXPECT_NEAR(from_output_N(table, 5, at), 5 + 1, 1e-12);
  EXPECT_NEAR(from_output_N(table, 10, at), 10 + 1, 1e-12);
  EXPECT_NEAR(from_output_N(table, 12.5, at), 12.5 + 1.5, 1e-12);
  EXPECT_NEAR(from_output_N(table, 20, at), 20 + 3, 1e-12);
  EXPECT_NEAR(from_output_N(table, 90, at), 90 + 3, 1e-12);
  EXPECT_NEAR(from_output_N(table, -15, at), -15 + 2, 1e-12);  // by its size
  at.direction = -1;
  EXPECT_NEAR(from_output_N(table, 15, at), 15 - 4, 1e-12);
}

TEST(ExtendedInput, ACorrectionGoesWithItsCovariate) {
  Covariates at;
  at.velocity_m_s = 0.15;
  EXPECT_NEAR(from_output_N(correction("speed_m_s", "0.1, 0.2"), 50, at), 52, 1e-12);
  at.motor_angle_rad = -0.015 * 9 / 0.0125;
  EXPECT_NEAR(from_output_N(correction("position_m", "-0.02, -0.01"), 50, at), 52, 1e-12);
  // 0.15 mm a sample; the travel begins anew where the motion turns.
  ExtendedInput input(model_with(correction("travel_m", "0.0002, 0.0004")));
  EXPECT_NEAR(input.from_output_N(50, at), 51, 1e-12);
  EXPECT_NEAR(input.from_output_N(50, at), 52, 1e-12);
  EXPECT_NEAR(input.from_output_N(50, at), 53, 1e-12);
  at.velocity_m_s = -0.15;
  at.direction = -1;
  EXPECT_NEAR(input.from_output_N(50, at), 48, 1e-12);
  EXPECT_NEAR(input.from_output_N(50, at), 46, 1e-12);
}

TEST(ExtendedInput, AShareOfFrictionTurnsOverAtOnce) {
  ExtendedInput input(
      model_with("[extension.presliding]\npresliding_length_m = 0.001\npresliding_share = 0.25\n"));
  Covariates at = pulling();
  at.velocity_m_s = 1;  // a length a sample
  const double slip = 1 - 0.25 / std::numbers::e;
  EXPECT_NEAR(input.from_output_N(49, at), 49 * std::exp(kMu * kPhi * slip), 1e-10);
}

TEST(ExtendedInput, BendAngleTakesTheErrorOfTheNextPose) {
  const std::string table =
      "[extension.bend_angle]\nbend_angle_error_rad = [0.1, -0.2]\nbend_angles_deg = [90, 270]\n";
  Covariates at = pulling();
  EXPECT_NEAR(from_output_N(table, 49, at), 49 * std::exp(kMu * (kPhi - 0.2)), 1e-10);
  at.bend_angle_rad = 2.0;
  EXPECT_NEAR(from_output_N(table, 49, at), 49 * std::exp(kMu * 2.1), 1e-10);
}

TEST(ExtendedInput, OffsetDroopAsymmetryAndRippleChangeTheCurrent) {
  Covariates at = pulling();
  at.direction = -1;
  at.winding_temperature_C = 60;
  at.motor_angle_rad = std::numbers::pi / 12;
  EXPECT_NEAR(from_current_N("[extension.current_offset]\ncurrent_offset_A = 0.05\n", 2, at),
              20.592 * 1.95, 1e-10);
  EXPECT_NEAR(from_current_N("[extension.torque_gain]\ndroop_1_K = 0.001\n", 2, at),
              20.592 * 2 * 0.96, 1e-10);
  EXPECT_NEAR(from_current_N("[extension.gear_asymmetry]\ngear_asymmetry = 0.02\n", 2, at),
              20.592 * 2 * 0.98, 1e-10);
  // 6 theta = 90 deg
  EXPECT_NEAR(from_current_N("[extension.torque_ripple]\nripple_sine_A = 0.1\n"
                             "ripple_cosine_A = 0.3\nripple_harmonic = 6\n",
                             2, at),
              20.592 * 2.1, 1e-10);
}

TEST(ExtendedInput, ALagOfTheOutputIsTakenOutOfARamp) {
  ExtendedInput input(model_with("[extension.filter_lag]\nlag_s = 0.005\n"));
  Covariates at;  // no bend
  EXPECT_NEAR(input.from_output_N(40, at), 40, 1e-12);
  // 0.1 N in 1 ms for 5 ms
  EXPECT_NEAR(input.from_output_N(40.1, at), 40.6, 1e-10);
  input.gap();
  EXPECT_NEAR(input.from_output_N(41, at), 41, 1e-12);
  // Held at an eighth of the ultimate tension.
  EXPECT_NEAR(input.from_output_N(81, at), 81 + 177.4 / 8, 1e-10);
}

TEST(ExtendedInput, ANegativeLagIsThatOfTheInput) {
  ExtendedInput input(model_with("[extension.filter_lag]\nlag_s = -0.005\n"));
  const Covariates at;
  static_cast<void>(input.from_output_N(40, at));
  EXPECT_NEAR(input.from_output_N(40.1, at), 40.1, 1e-12);
  input.gap();
  static_cast<void>(input.from_current_N(2, at));
  EXPECT_NEAR(input.from_current_N(2.01, at), 20.592 * 2.06, 1e-10);
}

TEST(ExtendedInput, MuStaysWithinItsBounds) {
  Covariates at = pulling();
  at.cycle = 1e9;
  const double most = ExtendedFriction::kMostFactor * kMu;
  EXPECT_NEAR(from_output_N("[extension.friction_wear]\nwear_coefficient = 1\n"
                            "wear_exponent = 2\nrun_in_cycles = 0\n",
                            1, at),
              std::exp(most * kPhi), 1e-9);
  EXPECT_NEAR(from_output_N("[extension.friction_wear]\nwear_coefficient = -1\n"
                            "wear_exponent = 2\nrun_in_cycles = 0\n",
                            1, at),
              1, 1e-12);
}

}  // namespace
}  // namespace host_sim
