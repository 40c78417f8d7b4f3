#include "host_sim/replay/until_date.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lifemodel/pack/pack.hpp"
#include "tests/lifemodel/support.hpp"

namespace host_sim {
namespace {

constexpr double kUltimate_N = 177.4;

lifemodel::Parameters parameters_of(double ipl_scale, double ipl_exponent, double shape) {
  return *lifemodel::pack::parameters({.ultimate_tension_N = kUltimate_N,
                                       .hysteresis_N = 0.2,
                                       .ipl_scale = ipl_scale,
                                       .ipl_exponent = ipl_exponent,
                                       .weibull_shape = shape,
                                       .friction_coefficient = 0.128,
                                       .bend_angle_rad = 4.712,
                                       .tension_per_current_N_A = {},
                                       .current_offset_A = 0,
                                       .sample_period_s = 1e-3,
                                       .model_digest = 1});
}

lifemodel::Reading reading_of(double damage, std::uint64_t closed, std::uint64_t open_half = 0) {
  lifemodel::Reading reading{};
  reading.total = lifemodel_test::damage_of(damage);
  reading.closed_cycles = lifemodel::Cycles::from_raw(closed);
  reading.open_half_cycles = lifemodel::HalfCycles::from_raw(open_half);
  return reading;
}

/// A minute of 60 cycles of 2^-14 lives: with gamma 2 and 1024 cycles at the ultimate tension those
/// of a quarter of it, without a mean. The wire has no memory.
UntilDate of_minutes(double minutes, double least_N = 0, double used = 0.5) {
  return until_date({"2027-06-30", minutes / 60, 1, 0.1}, used, reading_of(60 * 0x1p-14, 59, 2),
                    lifemodel::pack::tension(44.35, kUltimate_N), 60,
                    parameters_of(1024 * kUltimate_N * kUltimate_N, 2, 1), kUltimate_N, least_N);
}

// 116 minutes need 0.424805, -ln 0.9 = 0.1053605 is allowed: 0.248021 of the cycles, or its root of
// the tension, 0.498017. As it is 28.7704 minutes are 10 % risk, and the date 1 - exp(-0.424805).
TEST(UntilDate, TellsWhatLastsAndWhatItCosts) {
  const UntilDate until = of_minutes(116);
  EXPECT_TRUE(until.reachable);
  EXPECT_FALSE(until.lasts_as_it_is());
  EXPECT_NEAR(until.repeats, 116, 1e-9);
  EXPECT_NEAR(until.hours_to_risk * 60, 28.7704, 1e-3);
  EXPECT_NEAR(until.risk_as_it_is, 0.346103, 1e-5);
  EXPECT_NEAR(until.peak_tension_N, 44.35, 1e-6);
  EXPECT_NEAR(until.highest_tension_N, 22.0871, 1e-3);
  EXPECT_NEAR(until.tension_given_up(), 0.501983, 1e-5);
  EXPECT_NEAR(until.pace, 0.248021, 1e-6);
  EXPECT_NEAR(until.cycles_given_up(), 0.751979, 1e-6);
  EXPECT_NEAR(until.life_gained(), 4.03192, 1e-4);
  EXPECT_NEAR(until.risk_with, 0.1, 1e-5);
}

// 14 minutes need 0.0512695, so 0.25 sqrt(2.05503) of the ultimate tension would do.
TEST(UntilDate, TellsWhatMoreThereIs) {
  const UntilDate until = of_minutes(14);
  EXPECT_TRUE(until.lasts_as_it_is());
  EXPECT_NEAR(until.highest_tension_N, 63.5774, 1e-3);
  EXPECT_EQ(until.tension_given_up(), 0);
  EXPECT_EQ(until.pace, 1);
  EXPECT_EQ(until.life_gained(), 1);
  EXPECT_NEAR(until.risk_as_it_is, 0.0499774, 1e-6);
  EXPECT_NEAR(until.risk_with, 0.0499774, 1e-6);
}

// 10 to 60 N by the paper's exponent and shape and 1000 times its life, ten hours less a minute:
// the numbers of tests/app/derating_test.cpp.
TEST(UntilDate, IsTheAdviceOfABoard) {
  const UntilDate until =
      until_date({"2027-06-30", 599.0 / 60, 1, 0.1}, 1.75947e-3,
                 reading_of(3000 / 1.705058e6, 3000), lifemodel::pack::tension(60, kUltimate_N), 60,
                 parameters_of(1.53e8, 1.38, 5.94), kUltimate_N, 0);
  EXPECT_NEAR(until.highest_tension_N, 1005.753 / 4000 * kUltimate_N, 1e-3);
  EXPECT_NEAR(until.pace, 2591.799 / 4000, 1e-5);
  EXPECT_NEAR(until.risk_with, 0.1, 1e-5);
}

TEST(UntilDate, AWireHasToPull) {
  EXPECT_TRUE(of_minutes(116, 22.08).reachable);
  EXPECT_FALSE(of_minutes(116, 22.09).reachable);
  EXPECT_TRUE(of_minutes(14, 100).reachable);
  // Hardly any cycle is left to a wire that is so worn.
  const UntilDate worn = until_date({"2027-06-30", 1, 24, 1e-6}, 1e6, reading_of(1, 10),
                                    lifemodel::pack::tension(60, kUltimate_N), 60,
                                    parameters_of(1.53e5, 1.38, 50), kUltimate_N, 0);
  EXPECT_FALSE(worn.reachable);
}

TEST(UntilDate, WithoutDamageItLasts) {
  const UntilDate until = until_date({"2027-06-30", 220, 8, 0.1}, 0.3, reading_of(0, 0), {}, 60,
                                     parameters_of(1.53e5, 1.38, 5.94), kUltimate_N, 0.4);
  EXPECT_TRUE(until.reachable && until.lasts_as_it_is());
  EXPECT_EQ(until.hours_to_risk, std::numeric_limits<double>::infinity());
  EXPECT_EQ(until.risk_as_it_is, 0);
  EXPECT_EQ(until.life_gained(), 1);
  EXPECT_EQ(until.tension_given_up(), 0);
}

}  // namespace
}  // namespace host_sim
