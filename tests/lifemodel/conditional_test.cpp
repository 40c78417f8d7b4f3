#include "lifemodel/life/conditional.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "host_sim/reference/equations.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::damage_of;
using pack::to_double;

WeibullShape shape_of(double value) {
  return pack::from_double<WeibullShape>(value);
}
Ratio ratio_of(double value) {
  return pack::from_double<Ratio>(value);
}

/// The stated relative error.
double stated(double shape) {
  return 2e-6 + 1e-7 * shape;
}

double further(double shape, double used, Hazard hazard) {
  const Damage already = used == 0 ? Damage{} : damage_of(used);
  return to_double(further_damage(shape_of(shape), already, hazard));
}

// (-ln 0.9)^(1/5.94) = 0.684648 is B10. There D^beta = -ln 0.9, so that 10 % risk is where it has
// doubled: 0.684648 (2^(1/5.94) - 1) = 0.0847407. 50 %: -ln 0.9 + ln 2 = 0.798508,
// 0.798508^(1/5.94) = 0.962828, less 0.684648; 90 %: 2.407946^(1/5.94) = 1.159445, less 0.684648.
TEST(FurtherDamage, OfThePapersWireAtItsB10) {
  const double b10 = 0.684648495;
  EXPECT_NEAR(further(5.94, b10, kHazard10), 0.0847407, 3e-7);
  EXPECT_NEAR(further(5.94, b10, kHazard50), 0.278179, 1e-6);
  EXPECT_NEAR(further(5.94, b10, kHazard90), 0.474797, 1e-6);
  EXPECT_NEAR(to_double(break_risk(shape_of(5.94), damage_of(b10), damage_of(0.0847407))), 0.1,
              1e-6);
}

TEST(FurtherDamage, OfANewWireIsItsLife) {
  EXPECT_NEAR(further(5.94, 0, kHazard10), 0.684648, 2e-6);
  EXPECT_NEAR(further(5.94, 0, kHazard50), 0.940163, 2e-6);
  EXPECT_NEAR(further(5.94, 0, kHazard90), 1.150745, 2e-6);
  EXPECT_NEAR(further(5.94, 1e-20, kHazard10), 0.684648, 2e-6);
}

/// The tables of lifemodel/life/README.md, to the digits that they have.
TEST(FurtherDamage, IsThatOfTheTablesOnThePage) {
  struct Row {
    double used;
    double broken_percent;
    std::array<double, 3> further;  // to 1, 10 and 50 %
  };
  const std::array<Row, 5> rows{{{0, 0, {0.461, 0.685, 0.940}},
                                 {0.685 / 2, 0.2, {0.131, 0.344, 0.598}},
                                 {0.684648, 10, {0.011, 0.085, 0.278}},
                                 {0.940163, 50, {0.002, 0.023, 0.116}},
                                 {1.150745, 90, {0.001, 0.009, 0.052}}}};
  for (const Row& row : rows) {
    EXPECT_NEAR(100 * (1 - std::exp(-std::pow(row.used, 5.94))), row.broken_percent, 0.05);
    EXPECT_NEAR(further(5.94, row.used, Hazard::of(ratio_of(0.01))), row.further[0], 6e-4);
    EXPECT_NEAR(further(5.94, row.used, kHazard10), row.further[1], 6e-4);
    EXPECT_NEAR(further(5.94, row.used, kHazard50), row.further[2], 6e-4);
  }
}

TEST(FurtherDamage, WithoutAgeingDoesNotDependOnTheDamage) {
  for (const double used : {0.0, 1e-25, 1e-6, 0.1, 1.0, 17.0, 1e5}) {
    EXPECT_NEAR(further(1, used, kHazard10), 0.1053605, 3e-7) << used;
    EXPECT_NEAR(further(1, used, kHazard50), 0.6931472, 1.5e-6) << used;
    EXPECT_NEAR(further(1, used, kHazard90), 2.3025851, 5e-6) << used;
  }
}

// beta 2: sqrt(1 + ln 2) - 1; beta 0.5: (1 + ln 2)^2 - 1; at D = 1.
TEST(FurtherDamage, WhereItHasAClosedForm) {
  EXPECT_NEAR(further(2, 1, kHazard50), 0.3012098, 7e-7);
  EXPECT_NEAR(further(0.5, 1, kHazard50), 1.8667473, 4e-6);
}

// (1 + 1e4)^50 with d = 1e-195: nothing is left.
TEST(FurtherDamage, BelowTheResolutionIsNone) {
  EXPECT_EQ(further_damage(shape_of(50), damage_of(1e4), kHazard90), Damage{});
  EXPECT_GT(further_damage(shape_of(50), damage_of(2), kHazard90), Damage{});
}

TEST(FurtherDamage, TheSmallestDamageUnderTheLargestShapeIsNone) {
  const Damage smallest = Damage::from_words({1, 0, 0, 0});
  EXPECT_NEAR(to_double(further_damage(shape_of(50), smallest, kHazard50)), 0.992697, 2e-6);
  EXPECT_EQ(break_risk(shape_of(50), smallest, smallest), Ratio::lowest());
}

TEST(FurtherDamage, OfNoRiskAndOfCertainty) {
  const Damage used = damage_of(0.5);
  EXPECT_EQ(further_damage(shape_of(5.94), used, Ratio::lowest()), Damage{});
  EXPECT_EQ(further_damage(shape_of(5.94), used, Ratio::highest()), Damage::highest());
  EXPECT_GT(further_damage(shape_of(5.94), used, Ratio::from_raw(1)), Damage{});
  EXPECT_LT(further_damage(shape_of(0.5), used, Ratio::from_raw((1u << 30) - 1)), damage_of(500));
}

TEST(FurtherDamage, BeyondAllDamagesIsTheHighest) {
  constexpr Hazard kHighest{std::numeric_limits<std::int32_t>::max()};
  EXPECT_EQ(further_damage(shape_of(0.5), Damage{}, kHighest), Damage::highest());
  EXPECT_GT(further_damage(shape_of(0.5), damage_of(1), kHighest), damage_of(1.6e7));
}

TEST(Hazard, OfRisksIsTheirLogarithm) {
  EXPECT_NEAR(Hazard::of(ratio_of(0.1)).log2, kHazard10.log2, 150);
  EXPECT_NEAR(Hazard::of(ratio_of(0.5)).log2, kHazard50.log2, 150);
  EXPECT_NEAR(Hazard::of(ratio_of(0.9)).log2, kHazard90.log2, 150);
  double worst = 0;
  for (double risk = 0x1p-30; risk < 1; risk *= 1.003) {
    for (const Ratio x : {ratio_of(risk), ratio_of(1 - risk)}) {
      if (x != Ratio::lowest() && x != Ratio::highest()) {
        const double hazard = std::exp2(std::ldexp(Hazard::of(x).log2, -26));
        worst = std::max(worst, std::fabs(hazard / -std::log1p(-to_double(x)) - 1));
      }
    }
  }
  EXPECT_LE(worst, 1.5e-6);
}

TEST(BreakRisk, OfNothingAndOfEverything) {
  for (const double shape : {0.5, 1.0, 5.94, 50.0}) {
    for (const double used : {1e-30, 0.3, 1.0, 40.0}) {
      EXPECT_EQ(break_risk(shape_of(shape), damage_of(used), Damage{}), Ratio::lowest());
      EXPECT_EQ(break_risk(shape_of(shape), damage_of(used), Damage::highest()), Ratio::highest());
    }
    EXPECT_EQ(break_risk(shape_of(shape), Damage{}, Damage::highest()), Ratio::highest());
    EXPECT_EQ(break_risk(shape_of(shape), Damage::highest(), Damage::highest()) > ratio_of(0.5),
              true);
  }
}

struct Draw {
  double shape;
  double used;
  double risk;
};

/// Shapes 0.5 .. 50, damages 1e-30 .. 1e7 and most of them 1e-3 .. 3, risks 2^-30 .. 1; and a grid
/// of all.
template <class Check>
void over_random_draws_and_a_grid(Check&& check) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int i = 0; i < 300'000; ++i) {
    const double shape = 0.5 * std::pow(100, uniform(random));
    const double used = i % 4 == 0 ? std::pow(10, -30 + 37 * uniform(random))
                                   : std::pow(10, -3 + 3.5 * uniform(random));
    check(Draw{shape, used, i % 2 == 0 ? uniform(random) : std::exp2(-30 * uniform(random))});
  }
  for (const double shape : {0.5, 0.99, 1.0, 2.1, 5.94, 13.0, 50.0}) {
    for (double used = 1e-4; used < 30; used *= 1.07) {
      for (const double risk : {1e-6, 1e-3, 0.06, 0.0606, 0.0607, 0.1, 0.5, 0.9, 0.999999}) {
        check(Draw{shape, used, risk});
      }
    }
  }
}

TEST(FurtherDamage, IsWithinTheStatedErrorOfTheEquations) {
  double worst = 0;
  over_random_draws_and_a_grid([&](const Draw& draw) {
    const WeibullShape shape = shape_of(draw.shape);
    const Damage used = damage_of(draw.used);
    const Ratio risk = ratio_of(draw.risk);
    if (risk == Ratio::lowest() || risk == Ratio::highest()) {
      return;
    }
    const double exact = host_sim::reference::weibull_further_damage(
        to_double(used), to_double(risk), to_double(shape));
    const double error = std::fabs(to_double(further_damage(shape, used, risk)) - exact);
    const double relative = (error - 0x1p-104) / exact / stated(draw.shape);
    ASSERT_LE(relative, 1) << "shape " << draw.shape << " used " << draw.used << " risk "
                           << draw.risk;
    worst = std::max(worst, relative);
  });
  EXPECT_GE(worst, 0.3) << "the stated error is not the error";
}

TEST(BreakRisk, IsWithinTheStatedErrorOfTheEquations) {
  over_random_draws_and_a_grid([&](const Draw& draw) {
    const WeibullShape shape = shape_of(draw.shape);
    const Damage used = damage_of(draw.used);
    const Damage more = damage_of(std::pow(draw.risk, 3) * 1.5 + 1e-12);
    const double exact =
        host_sim::reference::weibull_break_risk(to_double(used), to_double(more), to_double(shape));
    ASSERT_NEAR(to_double(break_risk(shape, used, more)), exact,
                exact * stated(draw.shape) + 0x1p-30)
        << "shape " << draw.shape << " used " << draw.used << " further " << to_double(more);
  });
}

TEST(BreakRisk, AfterTheFurtherDamageOfARiskIsThatRisk) {
  over_random_draws_and_a_grid([&](const Draw& draw) {
    const WeibullShape shape = shape_of(draw.shape);
    const Ratio risk = ratio_of(draw.risk);
    const Damage used = damage_of(draw.used);
    const Damage more = further_damage(shape, used, risk);
    if (more > damage_of(1e-22) && more < Damage::highest()) {
      // A relative error of d is at most max(1, shape) times as large in the risk.
      const double allowed = stated(draw.shape) * (1 + std::max(1.0, draw.shape));
      ASSERT_NEAR(to_double(break_risk(shape, used, more)), to_double(risk),
                  to_double(risk) * allowed + 0x1p-30)
          << "shape " << draw.shape << " used " << draw.used << " risk " << draw.risk;
    }
  });
}

// To the stated error: further damage falls with age where the wire ages (shape above 1), rises
// where it outlives its early failures, and always rises with the risk; the risk the other way
// round.
TEST(ConditionalLife, IsMonotoneInEachArgument) {
  over_random_draws_and_a_grid([&](const Draw& draw) {
    const WeibullShape shape = shape_of(draw.shape);
    const double slack = 1 + 2 * stated(draw.shape);
    const Damage used = damage_of(draw.used);
    const Damage later = damage_of(draw.used * 1.1);
    const Ratio risk = ratio_of(draw.risk * 0.9);
    const Damage more = further_damage(shape, used, risk);
    if (risk.raw() < 1000 || more <= damage_of(1e-20)) {
      return;
    }
    ASSERT_GT(further_damage(shape, used, ratio_of(draw.risk)), more);
    const double now = to_double(more);
    const double then = to_double(further_damage(shape, later, risk));
    const double risk_now = to_double(break_risk(shape, used, more));
    const double risk_then = to_double(break_risk(shape, later, more));
    if (draw.shape >= 1) {
      ASSERT_LE(then, now * slack) << draw.shape << " " << draw.used << " " << draw.risk;
      ASSERT_GE(risk_then * slack + 0x1p-29, risk_now);
    } else {
      ASSERT_GE(then * slack, now) << draw.shape << " " << draw.used << " " << draw.risk;
      ASSERT_LE(risk_then, risk_now * slack + 0x1p-29);
    }
    ASSERT_GE(to_double(break_risk(shape, used, more.multiplied(2))) * slack + 0x1p-29, risk_now);
  });
}

// 0.0847407 / 0.02 = 4.24 from B10 on, where the whole life has none left.
TEST(RepeatsWithin, OfAWireThatHasOutlivedItsB10) {
  const Damage used = damage_of(0.6846486);
  const Damage each = damage_of(0.02);
  EXPECT_EQ(repeats_within(further_damage(shape_of(5.94), used, kHazard10), each), 4u);
  const auto life = lifemodel_test::parameters_of(lifemodel_test::paper_constants()).life;
  EXPECT_EQ(remaining_repeats(used, each, life.b10), 0u);
  EXPECT_EQ(repeats_within(damage_of(0.02), Damage{}), 4294967295u);
  EXPECT_EQ(repeats_within(Damage{}, damage_of(0.02)), 0u);
}

}  // namespace
}  // namespace lifemodel
