#include "host_sim/fleet/break_risk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "host_sim/statistics/random.hpp"
#include "tests/fleet/deviate.hpp"

namespace {

using host_sim::fleet::BreakRisk;
using host_sim::fleet::LawBelief;
using host_sim::fleet::Tendon;
using host_sim::statistics::Random;

constexpr double kShape = 5.94;
const double kB10 = std::pow(-std::log(0.9), 1 / kShape);

Tendon tendon(double damage, double damage_per_h, double rate_log_sd = 0) {
  Tendon result;
  result.damage = damage;
  result.damage_per_h = damage_per_h;
  result.rate_log_sd = rate_log_sd;
  return result;
}

TEST(FleetBreakRisk, AtB10TenPerCentMoreTakeAFurther0085) {
  // ln 0.9 doubled: (2 0.10536)^(1/5.94) = 0.76939, less B10 = 0.68464.
  const BreakRisk risk({.shape = kShape}, tendon(kB10, 1e-3));
  EXPECT_NEAR(risk.hours_to(0.1), 84.75, 0.02);
  EXPECT_NEAR(risk.within(84.75), 0.1, 3e-5);
  EXPECT_NEAR(risk.within_at_fit(84.75), 0.1, 3e-5);
}

TEST(FleetBreakRisk, OfANewTendonIsTheWholeLife) {
  const BreakRisk risk({.shape = kShape}, tendon(0, 1e-3));
  EXPECT_NEAR(risk.hours_to(0.1), 1000 * kB10, 1e-5);
  EXPECT_NEAR(risk.within(1000), 1 - std::exp(-1), 1e-12);
  EXPECT_EQ(risk.within(0), 0);
}

TEST(FleetBreakRisk, OfAnExponentialLifeForgetsTheDamage) {
  for (const double used : {0.0, 0.3, 20.0}) {
    EXPECT_NEAR(BreakRisk({.shape = 1}, tendon(used, 1e-3)).within(500), 1 - std::exp(-0.5), 1e-12);
  }
}

TEST(FleetBreakRisk, OfWhatDoesNoDamageIsNone) {
  const BreakRisk risk({.shape = kShape, .log_shape_sd = 0.1, .log_life_sd = 0.1},
                       tendon(0.9, 0, 0.5));
  EXPECT_EQ(risk.within(1e6), 0);
  EXPECT_EQ(risk.hours_to(0.5), std::numeric_limits<double>::infinity());
}

TEST(FleetBreakRisk, OfARateNextToNoneComesAfterMoreHoursThanANumberHolds) {
  // B10 of an exponential life is at 0.10536 of it: 0.10536 / 1e-300 h, and 0.10536 / 1e-310 h.
  EXPECT_NEAR(BreakRisk({.shape = 1}, tendon(0.3, 1e-300)).hours_to(0.1) / 1e300, 0.1053605, 1e-6);
  EXPECT_EQ(BreakRisk({.shape = 1}, tendon(0.3, 1e-310)).hours_to(0.1),
            std::numeric_limits<double>::infinity());
}

TEST(FleetBreakRisk, StaysANumberWhereAPowerIsBelowEveryNumber) {
  const BreakRisk risk({.shape = kShape}, tendon(1e-300, 1e-3));
  EXPECT_NEAR(risk.within(1000), 1 - std::exp(-1), 1e-12);
  EXPECT_EQ(BreakRisk({.shape = kShape}, tendon(1e-300, 1e-307)).within(1e-297), 0);
}

TEST(FleetBreakRisk, StaysANumberFarBeyondEveryLife) {
  for (const double used : {3.0, 100.0}) {
    const BreakRisk risk({.shape = 8, .log_shape_sd = 0.3, .log_life_sd = 0.5},
                         tendon(used, 1e-3, 0.5));
    const double hours = risk.hours_to(0.1);
    EXPECT_GT(hours, 0) << used;
    EXPECT_NEAR(risk.within(hours), 0.1, 1e-6) << used;
    EXPECT_NEAR(risk.within(1e9), 1, 1e-9) << used;
  }
}

/// Share of the wires that are whole at the tendon's damage and break within `hours`: laws, rates
/// and lives drawn.
double simulated(const LawBelief& law, const Tendon& each, double hours) {
  double whole = 0;
  double broken = 0;
  Random random(3, 0, 0);
  for (int run = 0; run < 400'000; ++run) {
    const double shape = law.shape * std::exp(law.log_shape_sd * deviate(random));
    const double log_life =
        law.log_life_sd * deviate(random) -
        law.exponent_sd * deviate(random) *
            std::log(each.effective_tension_N.value_or(law.pivot_tension_N) / law.pivot_tension_N);
    const double sd = each.rate_log_sd;
    const double rate = each.damage_per_h * std::exp(sd * deviate(random) - 0.5 * sd * sd);
    const double life = std::exp(log_life) * std::pow(-std::log(random.uniform()), 1 / shape);
    if (life > each.damage) {
      ++whole;
      broken += life <= each.damage + rate * hours ? 1 : 0;
    }
  }
  return broken / whole;
}

TEST(FleetBreakRisk, IsWhatSimulatedLivesGive) {
  const LawBelief exact{.shape = kShape};
  LawBelief unsure{.shape = kShape, .log_shape_sd = 0.15, .log_life_sd = 0.1};
  unsure.pivot_tension_N = 50;
  LawBelief far = unsure;
  far.exponent_sd = 0.2;
  Tendon light = tendon(0.75, 1e-3, 0.2);
  light.effective_tension_N = 25;  // half of the pivot: another 0.2 ln 2 = 0.139
  struct Case {
    LawBelief law;
    Tendon each;
    double hours;
  };
  for (const auto& [law, each, hours] :
       {Case{exact, tendon(0.7, 1e-3, 0.4), 150}, Case{unsure, tendon(0.1, 1e-3), 500},
        Case{unsure, tendon(0.7, 1e-3), 150}, Case{unsure, tendon(1.1, 1e-3), 60},
        Case{far, light, 150}, Case{far, tendon(0.75, 1e-3, 0.2), 150}}) {
    const double risk = BreakRisk(law, each).within(hours);
    EXPECT_NEAR(simulated(law, each, hours), risk, 4 * std::sqrt(risk * (1 - risk) / 1e5)) << risk;
  }
}

TEST(FleetBreakRisk, SurvivalIsEvidenceOfAStrongLaw) {
  const LawBelief law{.shape = kShape, .log_life_sd = 0.2};
  // Of those that live beyond their characteristic life, most have a stronger law than the fitted.
  const BreakRisk old(law, tendon(1.2, 1e-3));
  EXPECT_LT(old.within(100), 0.6 * old.within_at_fit(100));
  EXPECT_LT(old.within(100), old.within_of_all_laws(100));
  // Of a new tendon nothing is learnt, and a law that is not known is a risk.
  const BreakRisk fresh(law, tendon(0, 1e-3));
  EXPECT_NEAR(fresh.within(500), fresh.within_of_all_laws(500), 1e-12);
  EXPECT_GT(fresh.within(500), 1.5 * fresh.within_at_fit(500));
}

}  // namespace
