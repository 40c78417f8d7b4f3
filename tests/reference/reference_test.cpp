#include "host_sim/reference/reference.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>

#include "host_sim/reference/compensated_sum.hpp"
#include "host_sim/reference/cycle_damage.hpp"
#include "host_sim/reference/equations.hpp"
#include "tests/reference/counts.hpp"
#include "tests/reference/signals.hpp"

namespace host_sim::reference::testing {
namespace {

// The cycle from 28 to 92 N: mean 60, amplitude 32, T_eff = 32 / (1 - 0.6^2) = 50 N,
// d = 50^2 / 25000 = 0.1.
constexpr Constants kRound{.ultimate_tension_N = 100,
                           .hysteresis_N = 0,
                           .ipl_scale = 25'000,
                           .ipl_exponent = 2,
                           .weibull_shape = 5.94};
constexpr Constants kPaper{.ultimate_tension_N = 177.4,
                           .hysteresis_N = 0.2,
                           .ipl_scale = 1.53e5,
                           .ipl_exponent = 1.38,
                           .weibull_shape = 5.94};

Reading read(const Constants& constants, std::span<const double> signal) {
  Reference reference(constants);
  for (const double tension_N : signal) {
    reference.push(tension_N);
  }
  return reference.reading();
}

TEST(CycleDamage, ByHand) {
  EXPECT_DOUBLE_EQ(cycle_damage({28, 92}, kRound), 0.1);
  EXPECT_DOUBLE_EQ(cycle_damage({92, 28}, kRound), 0.1);
  EXPECT_DOUBLE_EQ(cycle_damage({-92, -28}, kRound), 0.1);
  EXPECT_DOUBLE_EQ(cycle_damage({-5, 5}, kRound), 0.001);
}

TEST(CycleDamage, AnOverloadUsesOneLifeAndNoCycleMore) {
  EXPECT_EQ(cycle_damage({99, 100}, kRound), 1.0);
  EXPECT_EQ(cycle_damage({-100, -99}, kRound), 1.0);
  EXPECT_EQ(cycle_damage({0, 500}, kRound), 1.0);
  EXPECT_EQ(cycle_damage({-99.9, 99.9}, {.ultimate_tension_N = 100,
                                         .hysteresis_N = 0,
                                         .ipl_scale = 10,
                                         .ipl_exponent = 2,
                                         .weibull_shape = 1}),
            1.0);
}

TEST(Reference, NothingCountedBeforeTheFirstTurningPoint) {
  const Reading reading = read(kRound, Signal{});
  EXPECT_EQ(reading.damage.total, 0.0);
  EXPECT_EQ(reading.closed_cycles, 0U);
  EXPECT_EQ(reading.open_half_cycles, 0U);
  EXPECT_EQ(reading.peak_tension_N, 0.0);
}

TEST(Reference, OneRangeIsAnOpenHalfCycle) {
  const Reading reading = read(kRound, Signal{28, 92});
  EXPECT_EQ(reading.damage.closed, 0.0);
  EXPECT_DOUBLE_EQ(reading.damage.open, 0.05);
  EXPECT_DOUBLE_EQ(reading.damage.total, 0.05);
  EXPECT_EQ(reading.open_half_cycles, 1U);
  EXPECT_EQ(reading.peak_tension_N, 92.0);
}

// Four ranges: one closed cycle and two open halves.
TEST(Reference, ConstantAmplitudeClosesFullCycles) {
  const Reading reading = read(kRound, Signal{28, 92, 28, 92, 28});
  EXPECT_EQ(reading.closed_cycles, 1U);
  EXPECT_EQ(reading.open_half_cycles, 2U);
  EXPECT_DOUBLE_EQ(reading.damage.closed, 0.1);
  EXPECT_DOUBLE_EQ(reading.damage.open, 0.1);
  EXPECT_DOUBLE_EQ(reading.damage.total, 0.2);
}

// The unconfirmed 95 N already closes 80-40 in the reading; the true count must not be touched.
TEST(Reference, AReadingIncludesTheUnconfirmedExtremumAndChangesNothing) {
  Reference reference(kRound);
  for (const double tension_N : {10.0, 90.0, 20.0, 80.0, 40.0, 95.0}) {
    reference.push(tension_N);
  }
  const Reading first = reference.reading();
  EXPECT_EQ(first.closed_cycles, 2U);
  EXPECT_EQ(first.open_half_cycles, 1U);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(reference.reading().damage.total, first.damage.total);
    EXPECT_EQ(reference.reading().closed_cycles, first.closed_cycles);
  }
  reference.push(10.0);
  EXPECT_EQ(reference.reading().closed_cycles, 2U);
  EXPECT_EQ(reference.reading().open_half_cycles, 2U);
}

TEST(Reference, SwingsSmallerThanTheHysteresisCountForNothing) {
  EXPECT_EQ(read(kPaper, Signal{40, 40.1, 39.95, 40.1, 39.95}).damage.total, 0.0);
}

TEST(Reference, AnOverloadIsCountedAndCharged) {
  const Reading open = read(kRound, Signal{50, 120, 50});
  EXPECT_EQ(open.overload_half_cycles, 2U);
  EXPECT_EQ(open.overload_cycles, 0U);
  EXPECT_EQ(open.damage.total, 1.0);
  EXPECT_EQ(open.peak_tension_N, 120.0);
  const Reading closed = read(kRound, Signal{50, 120, 50, 120, 50});
  EXPECT_EQ(closed.overload_cycles, 1U);
  EXPECT_EQ(closed.overload_half_cycles, 2U);
  EXPECT_EQ(closed.damage.total, 2.0);
}

TEST(Reference, TensionHeldAtTheUltimateOneIsAnOverload) {
  for (const double held_N : {100.0, 130.0, -100.0}) {
    const Reading held = read(kRound, Signal(50, held_N));
    EXPECT_EQ(held.overload_half_cycles, 1U);
    EXPECT_EQ(held.open_half_cycles, 1U);
    EXPECT_EQ(held.damage.total, 0.5);
  }
  EXPECT_EQ(read(kRound, Signal(50, 99.999)).damage.total, 0.0);
  // Coming back, the first turning point takes the place of the way up.
  EXPECT_EQ(read(kRound, Signal{130, 50}).damage.total, 0.5);
}

TEST(Reference, NegativeTensionIsCountedAsItIs) {
  const Reading reading = read(kRound, Signal{-5, 5});
  EXPECT_DOUBLE_EQ(reading.damage.total, 0.0005);
  EXPECT_EQ(read(kRound, Signal{-7, -3}).peak_tension_N, 7.0);
}

TEST(Reference, RefusesASampleThatIsNotFiniteAndGoesOn) {
  Reference reference(kRound);
  reference.push(28);
  EXPECT_THROW(reference.push(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(reference.push(std::numeric_limits<double>::infinity()), std::invalid_argument);
  reference.push(92);
  EXPECT_DOUBLE_EQ(reference.reading().damage.total, 0.05);
  EXPECT_EQ(reference.reading().peak_tension_N, 92.0);
}

TEST(Reference, RefusesConstantsOutOfRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](double Constants::*member, double value) {
    Constants constants = kPaper;
    constants.*member = value;
    return constants;
  };
  for (const auto member : {&Constants::ultimate_tension_N, &Constants::ipl_scale,
                            &Constants::ipl_exponent, &Constants::weibull_shape}) {
    EXPECT_THROW(Reference{with(member, 0.0)}, std::invalid_argument);
    EXPECT_THROW(Reference{with(member, nan)}, std::invalid_argument);
  }
  EXPECT_THROW(Reference{with(&Constants::hysteresis_N, -0.1)}, std::invalid_argument);
  EXPECT_THROW(Reference{with(&Constants::hysteresis_N, nan)}, std::invalid_argument);
  EXPECT_NO_THROW(Reference{with(&Constants::hysteresis_N, 0.0)});
}

RC_GTEST_PROP(Reference, TheTotalIsTheAstmTotalAtEveryPrefix, ()) {
  const Signal signal = *any_signal();
  Constants constants = kRound;
  constants.ultimate_tension_N = *rc::gen::element(60.0, 200.0);
  constants.hysteresis_N = *rc::gen::element(0.0, 0.2, 2.0);
  Reference reference(constants);
  Signal prefix;
  for (const double tension_N : signal) {
    reference.push(tension_N);
    prefix.push_back(tension_N);
    Signal points = turning_points(prefix, constants.hysteresis_N);
    // Held at the ultimate tension from the start: the way up from zero.
    const double peak_N = std::abs(
        *std::ranges::max_element(prefix, {}, [](double sample_N) { return std::abs(sample_N); }));
    if (points.empty() && peak_N >= constants.ultimate_tension_N) {
      points = {0.0, peak_N};
    }
    double expected = 0.0;
    for (const auto& [cycle, count] : count_astm(points).entries) {
      const double amplitude_N = std::abs(cycle.from_N - cycle.to_N) / 2;
      const double mean_N = (cycle.from_N + cycle.to_N) / 2;
      const double ratio = mean_N / constants.ultimate_tension_N;
      const double effective_N = amplitude_N / (1 - ratio * ratio);
      const bool overload =
          std::max(std::abs(cycle.from_N), std::abs(cycle.to_N)) >= constants.ultimate_tension_N;
      const double damage = effective_N * effective_N / constants.ipl_scale;
      expected += count * (overload ? 1.0 : std::min(1.0, damage));
    }
    const Reading reading = reference.reading();
    RC_ASSERT(std::abs(reading.damage.total - expected) <= 1e-12 * expected);
    RC_ASSERT(2 * reading.closed_cycles + reading.open_half_cycles + 1 ==
              std::max<std::uint64_t>(points.size(), 1));
  }
}

RC_GTEST_PROP(Reference, TheReadingNeverFalls, ()) {
  Constants constants = kPaper;
  constants.ultimate_tension_N = *rc::gen::element(50.0, 101.0, 177.4);
  constants.hysteresis_N = *rc::gen::element(0.0, 0.2, 2.0);
  constants.ipl_exponent = *rc::gen::element(1.0, 1.38, 12.0);
  Reference reference(constants);
  double last = 0.0;
  for (const double tension_N : *any_signal()) {
    reference.push(tension_N);
    const double now = reference.reading().damage.total;
    RC_ASSERT(now >= last * (1 - 1e-12));
    last = now;
  }
}

RC_GTEST_PROP(Reference, DamageScalesAsThePowerLawSays, ()) {
  const Signal signal = *grid_signal(-1000, 1000, 0.1);
  const double factor = *rc::gen::element(0.5, 2.0, 16.0);
  Signal scaled = signal;
  for (double& tension_N : scaled) {
    tension_N *= factor;
  }
  Constants constants = kPaper;
  constants.ipl_scale = 1e9;
  Constants scaled_constants = constants;
  scaled_constants.ultimate_tension_N *= factor;
  scaled_constants.hysteresis_N *= factor;
  const double damage = read(constants, signal).damage.total;
  const double scaled_damage = read(scaled_constants, scaled).damage.total;
  RC_ASSERT(std::abs(scaled_damage - damage * std::pow(factor, constants.ipl_exponent)) <=
            1e-12 * scaled_damage);
}

TEST(Reference, MillionsOfCyclesAddUp) {
  constexpr std::uint64_t kCycles = 2'000'000;
  Reference reference({.ultimate_tension_N = 100,
                       .hysteresis_N = 0,
                       .ipl_scale = 25'000e9,
                       .ipl_exponent = 2,
                       .weibull_shape = 5.94});
  for (std::uint64_t i = 0; i <= 2 * kCycles; ++i) {
    reference.push(i % 2 == 0 ? 28.0 : 92.0);
  }
  const Reading reading = reference.reading();
  EXPECT_EQ(reading.closed_cycles, kCycles - 1);
  EXPECT_EQ(reading.open_half_cycles, 2U);
  EXPECT_NEAR(reading.damage.total / (1e-10 * kCycles), 1.0, 1e-15);
}

// After a damage of one, a plain sum would lose every one of these terms.
TEST(CompensatedSum, KeepsTermsBelowTheRoundingOfTheSum) {
  CompensatedSum sum;
  sum.add(1.0);
  for (int i = 0; i < 1'000'000; ++i) {
    sum.add(1e-17);
  }
  EXPECT_DOUBLE_EQ(sum.value() - 1.0, (1.0 + 1e-11) - 1.0);
  sum.add(-1.0);
  EXPECT_NEAR(sum.value(), 1e-11, 1e-21);
}

TEST(Reference, AWireUnderConstantTensionWithoutABendAccumulatesNothing) {
  const double efficiency = capstan_efficiency(0.128, 0.0);
  Reference reference(kPaper);
  Direction direction = Direction::kPulling;
  for (int i = 0; i < 10'000; ++i) {
    direction = direction_of(std::sin(0.01 * i), direction);
    reference.push(input_tension_from_output(49.0, efficiency, direction));
  }
  const Reading reading = reference.reading();
  EXPECT_EQ(reading.damage.total, 0.0);
  EXPECT_EQ(reading.closed_cycles, 0U);
  EXPECT_EQ(reading.open_half_cycles, 0U);
}

}  // namespace
}  // namespace host_sim::reference::testing
