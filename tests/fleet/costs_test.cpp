#include "host_sim/fleet/costs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/statistics/random.hpp"

namespace {

using namespace host_sim::fleet;
using host_sim::statistics::Random;

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kWireShape = 5.94;

/// A wire's life in characteristic lives.
double drawn_life(Random& random, double shape) {
  return std::pow(-std::log(random.uniform()), 1 / shape);
}

TEST(FleetCosts, MeanDamageIsThatOfTheWholeLifeWithoutALimit) {
  EXPECT_NEAR(mean_damage(1, kNever), 1, 1e-14);
  EXPECT_NEAR(mean_damage(2, kNever), std::sqrt(std::numbers::pi) / 2, 1e-14);
  EXPECT_NEAR(mean_damage(1, 0.5), 1 - std::exp(-0.5), 1e-14);
  EXPECT_NEAR(mean_damage(2, 1), std::sqrt(std::numbers::pi) / 2 * std::erf(1.0), 1e-14);
}

TEST(FleetCosts, TheCheapestLimitByHand) {
  // Shape 2 at T = 1: 2 (sqrt(pi) / 2) erf(1) - (1 - 1/e) = 1.493648 - 0.632121 = 0.861528 has to
  // be replacement / (break - replacement); the cost is then (break - replacement) beta T = 2.
  const TendonCosts costs{0.8615277, 1.8615277};
  EXPECT_NEAR(cheapest_limit(2, costs), 1, 1e-6);
  EXPECT_NEAR(cost_per_damage(2, 1, costs), 2, 1e-6);
  // Never: wires that do not wear, and breaks that cost no more than a replacement.
  EXPECT_EQ(cheapest_limit(1, {1, 100}), kNever);
  EXPECT_EQ(cheapest_limit(kWireShape, {1, 1}), kNever);
  EXPECT_NEAR(cost_per_damage(1, kNever, {1, 100}), 100, 1e-12);
  EXPECT_LT(cheapest_limit(kWireShape, {0, 1}), 1e-3);
}

TEST(FleetCosts, TheCheapestLimitCostsLeast) {
  for (const double ratio : {1.2, 3.0, 10.0, 1000.0}) {
    const TendonCosts costs{1, ratio};
    const double best = cheapest_limit(kWireShape, costs);
    const double cost = cost_per_damage(kWireShape, best, costs);
    for (const double factor : {0.5, 0.95, 1.05, 2.0}) {
      EXPECT_GT(cost_per_damage(kWireShape, factor * best, costs), cost) << ratio << ' ' << factor;
    }
    EXPECT_LE(cost, cost_per_damage(kWireShape, kNever, costs)) << ratio;
  }
}

TEST(FleetCosts, InTheLongRunAreWhatSimulatedWiresCost) {
  const TendonCosts costs{100, 1000};
  for (const double limit : {0.6, 0.8, 1.1, kNever}) {
    Random random(7, 0, 0);
    constexpr int kWires = 200'000;
    double cost = 0;
    double damage = 0;
    for (int wire = 0; wire < kWires; ++wire) {
      const double life = drawn_life(random, kWireShape);
      cost += life < limit ? costs.of_break : costs.replacement;
      damage += std::min(life, limit);
    }
    // The scatter of the cost of a wire is at most 450; the mean damage at least 0.59.
    EXPECT_NEAR(cost / damage, cost_per_damage(kWireShape, limit, costs),
                4 * 450 / 0.59 / std::sqrt(kWires))
        << limit;
  }
}

TEST(FleetCosts, OnConditionByHand) {
  // Shape 2, a hazard of 0.5: spans of 0.5 add (2k + 1) / 4 each, so the second one reaches it.
  const double risk = -std::expm1(-0.5);
  EXPECT_NEAR(limit_on_condition(2, 0.5, risk), std::sqrt(0.25 + 0.5), 1e-12);
  // A horizon beyond the life: the risk of a new wire.
  EXPECT_NEAR(limit_on_condition(2, 10, risk), std::sqrt(0.5), 1e-12);
  // Spans of 0.001: (2k + 1) / 1e6 reaches 0.5 at k = 250000, a damage of 250.
  EXPECT_NEAR(limit_on_condition(2, 1e-3, risk), 250, 1e-2);
  EXPECT_EQ(limit_on_condition(1, 0.4, risk), kNever);
  EXPECT_NEAR(limit_on_condition(1, 1, risk), 0.5, 1e-12);
  EXPECT_EQ(limit_on_condition(2, 0, risk), kNever);
  EXPECT_EQ(limit_on_condition(0.5, 1e-4, 0.5), kNever);
}

TEST(FleetCosts, OnConditionIsWhatPlanningAgainAtEachHorizonComesTo) {
  constexpr double kSpan = 0.07;
  constexpr double kRisk = 0.03;
  const TendonCosts costs{100, 1000};
  Random random(9, 0, 0);
  constexpr int kWires = 40'000;
  double cost = 0;
  double damage = 0;
  for (int wire = 0; wire < kWires; ++wire) {
    const double life = drawn_life(random, kWireShape);
    double used = 0;
    BreakRisk risk({.shape = kWireShape}, {.damage = used, .damage_per_h = 1});
    while (life > used + kSpan && risk.within(kSpan) < kRisk) {
      used += kSpan;
      risk = BreakRisk({.shape = kWireShape}, {.damage = used, .damage_per_h = 1});
    }
    const double until = risk.within(kSpan) < kRisk ? kNever : used + risk.hours_to(kRisk);
    cost += life < until ? costs.of_break : costs.replacement;
    damage += std::min(life, until);
  }
  EXPECT_NEAR(cost / damage,
              cost_per_damage(kWireShape, limit_on_condition(kWireShape, kSpan, kRisk), costs),
              4 * 450 / 0.5 / std::sqrt(kWires));
}

Fleet fleet_with(std::vector<Tendon> tendons) {
  Fleet fleet;
  fleet.tendons = std::move(tendons);
  host_sim::Model::Life life{};
  life.weibull_shape = kWireShape;
  fleet.models = {{"model.toml", host_sim::Model{{}, {}, {}, {}, life}}};
  return fleet;
}

PlanRequest ten_days() {
  return {.today = parse_date("2026-03-02").value(),
          .horizon = {Horizon::Kind::calendar, 10, "10d"},
          .service = 0.95};
}

TEST(FleetCosts, UntilTheHorizonByHand) {
  // Ten days of 0.01, beyond B10: 0.79^5.94 - 0.69^5.94 = 0.24655 - 0.11035, a risk of 0.12733.
  Fleet fleet =
      fleet_with({{.name = "old", .damage = 0.69, .damage_per_h = 1e-3, .hours_per_day = 10},
                  {.name = "idle", .damage = 0.3}});
  set_costs(fleet, 100, 1000, "t.csv");
  const FleetPlan plan = make_plan(fleet, ten_days());
  ASSERT_TRUE(plan.costs);
  EXPECT_NEAR(plan.costs->run_to_break.cost, 127.33, 0.05);
  EXPECT_NEAR(plan.costs->run_to_break.breaks, 0.12733, 5e-5);
  // Today, whole.
  EXPECT_EQ(plan.costs->at_b10.cost, 100);
  EXPECT_EQ(plan.costs->at_b10.planned, 1);
  // On its date: 0.1 of 1000 and 0.9 of 100.
  EXPECT_NEAR(plan.costs->on_condition.cost, 190, 1e-9);
  EXPECT_NEAR(plan.costs->on_condition.planned, 0.9, 1e-12);
  // 3.6525 characteristic lives a year, each wire of Gamma(1 + 1/5.94) = 0.92720 of them.
  EXPECT_NEAR(plan.costs->run_to_break.cost_per_year, 3.6525 * 1000 / 0.92720, 0.1);
}

TEST(FleetCosts, BeforeB10TheRiskIsThatUntilIt) {
  // 0.64 and 44.6 hours of 0.001: B10 = 0.68464 after four days; 0.10536 - 0.07056 of hazard.
  Fleet fleet = fleet_with({{.damage = 0.64, .damage_per_h = 1e-3, .hours_per_day = 10}});
  set_costs(fleet, 100, 1000, "t.csv");
  const FleetPlan plan = make_plan(fleet, ten_days());
  EXPECT_NEAR(plan.costs->at_b10.breaks, -std::expm1(-0.03480), 5e-5);
  EXPECT_NEAR(plan.costs->at_b10.cost, 100 + 900 * plan.costs->at_b10.breaks, 1e-9);
}

std::string refusal(Fleet fleet, std::optional<double> replacement,
                    std::optional<double> of_break) {
  try {
    set_costs(fleet, replacement, of_break, "t.csv");
    return "set";
  } catch (const hal::files::InputError& error) {
    return error.what();
  }
}

TEST(FleetCosts, AreThoseOfEachTendonOrOfAll) {
  Fleet fleet = fleet_with({{.name = "a", .break_cost = 50}, {.name = "b"}});
  Fleet set = fleet;
  set_costs(set, 10, 70, "t.csv");
  EXPECT_EQ(set.tendons[0].break_cost, 50);
  EXPECT_EQ(set.tendons[1].break_cost, 70);
  EXPECT_EQ(set.tendons[1].replacement_cost, 10);
  EXPECT_EQ(refusal(fleet, {}, 70),
            "t.csv: tendon 'a' has no cost_replace; accepted: --cost-replacement for all, or "
            "cost_replace of each tendon");
  EXPECT_EQ(refusal(fleet, 10, {}),
            "t.csv: tendon 'b' has no cost_break; accepted: --cost-break for all, or cost_break of "
            "each tendon");
  EXPECT_EQ(
      refusal(fleet, 60, 70),
      "t.csv: a break of tendon 'a' costs 50, less than its replacement; accepted: 60 or more: "
      "the replacement after it is part of it");
  Fleet none = fleet_with({{.name = "a"}});
  set_costs(none, {}, {}, "t.csv");
  EXPECT_FALSE(make_plan(none, ten_days()).costs);
}

}  // namespace
