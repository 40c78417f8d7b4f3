#include "host_sim/fleet/fleet_plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "host_sim/statistics/random.hpp"
#include "tests/fleet/deviate.hpp"

namespace {

using namespace host_sim::fleet;
using host_sim::Model;
using host_sim::statistics::Random;

constexpr double kLife = 1000;

/// Deviations of ln life at 50 N, of the exponent and of ln shape, as intervals of 95 %.
Model::Life life_of(double log_life_sd, double exponent_sd, double log_shape_sd) {
  constexpr double kZ = 1.959963984540054;
  const auto about = [&](double value, double log_sd) {
    return Model::Life::Interval::Ends{value * std::exp(-kZ * log_sd),
                                       value * std::exp(kZ * log_sd)};
  };
  Model::Life life{};
  life.ipl_exponent = 1.5;
  life.weibull_shape = 5.94;
  life.ipl_scale = kLife * std::pow(50, 1.5);
  life.interval = {.level = 0.95,
                   .ipl_scale = about(life.ipl_scale, 0.3),
                   .ipl_exponent = {1.5 - kZ * exponent_sd, 1.5 + kZ * exponent_sd},
                   .weibull_shape = about(5.94, log_shape_sd),
                   .pivot_tension_N = 50,
                   .life_at_pivot = about(kLife, log_life_sd)};
  return life;
}

Fleet fleet_of(std::size_t size, const Tendon& each, const Model::Life& life) {
  Fleet fleet;
  fleet.tendons.assign(size, each);
  fleet.models = {{"model.toml", Model{{}, {}, {}, {}, life}}};
  return fleet;
}

Tendon tendon_at(double damage, double effective_tension_N) {
  Tendon result;
  result.damage = damage;
  result.damage_per_h = 1e-3;
  result.hours_per_day = 10;
  result.effective_tension_N = effective_tension_N;
  return result;
}

PlanRequest request_of(double days) {
  return {.today = parse_date("2026-03-02").value(),
          .horizon = {Horizon::Kind::calendar, days, "-"},
          .service = 0.95};
}

TEST(FleetPlan, ReadsTheDeviationsOfALawFromItsIntervals) {
  const LawBelief law = belief_of(life_of(0.1, 0.2, 0.15));
  EXPECT_NEAR(law.log_life_sd, 0.1, 1e-9);
  EXPECT_NEAR(law.exponent_sd, 0.2, 1e-9);
  EXPECT_NEAR(law.log_shape_sd, 0.15, 1e-9);
  EXPECT_EQ(law.pivot_tension_N, 50);
  EXPECT_EQ(law.shape, 5.94);
  Model::Life plain = life_of(0.1, 0.2, 0.15);
  plain.interval.reset();
  EXPECT_TRUE(belief_of(plain).exact());
}

TEST(FleetPlan, OneTendonBreaksWithItsOwnRisk) {
  const FleetPlan plan =
      make_plan(fleet_of(1, tendon_at(0.8, 25), life_of(0.1, 0.2, 0.1)), request_of(10));
  EXPECT_NEAR(plan.breaks.demand.mean(), plan.tendons[0].risk, 1e-3 * plan.tendons[0].risk);
}

TEST(FleetPlan, TendonsOfOneModelShareWhatIsNotKnownOfIt) {
  constexpr std::size_t kTendons = 30;
  constexpr int kRuns = 20'000;
  const FleetPlan plan =
      make_plan(fleet_of(kTendons, tendon_at(0, 100), life_of(0.1, 0.2, 0.1)), request_of(70));
  // New wires: one law drawn for all, at twice the tension of the pivot, then a life of each.
  std::vector<int> seen(kTendons + 1, 0);
  Random random(5, 0, 0);
  for (int run = 0; run < kRuns; ++run) {
    const double shape = 5.94 * std::exp(0.1 * deviate(random));
    const double life = std::exp(0.1 * deviate(random) - 0.2 * deviate(random) * std::numbers::ln2);
    std::size_t breaks = 0;
    for (std::size_t i = 0; i < kTendons; ++i) {
      breaks += life * std::pow(-std::log(random.uniform()), 1 / shape) < 0.7 ? 1U : 0U;
    }
    ++seen[breaks];
  }
  double so_far = 0;
  for (std::size_t count = 0; count <= kTendons; ++count) {
    so_far += static_cast<double>(seen[count]) / kRuns;
    EXPECT_NEAR(plan.breaks.demand.at_most(count), so_far, 0.015) << count;
  }
  // Were each on its own, 95 % would be met by far fewer.
  const std::vector<double> risks(kTendons, plan.tendons[0].risk);
  EXPECT_GT(plan.breaks.count, poisson_binomial(risks).quantile(0.95) + 4);
}

TEST(FleetPlan, WhatIsDueTakesOneSpareForSure) {
  Fleet fleet = fleet_of(2, tendon_at(1.5, 50), life_of(0, 0, 0));
  fleet.tendons.push_back(tendon_at(0, 50));
  fleet.tendons.back().damage_per_h = 0;
  const FleetPlan plan = make_plan(fleet, request_of(30));
  EXPECT_EQ(plan.due, 2U);
  EXPECT_EQ(plan.on_condition.count, 2U);
  EXPECT_NEAR(plan.breaks_until_due, 0.2, 1e-12);
  EXPECT_EQ(plan.past_b10, 2U);
}

}  // namespace
