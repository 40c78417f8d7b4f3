#include "host_sim/extension/life.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "host_sim/extension/fixed.hpp"
#include "lifemodel/extension/life.hpp"
#include "lifemodel/pack/pack.hpp"
#include "tests/extension/models.hpp"
#include "tests/lifemodel/support.hpp"

namespace host_sim {
namespace {

using extension_test::model_with;
using lifemodel_test::newtons;

constexpr double kUltimate_N = 177.4;

double gerber_N(double mean_N, double amplitude_N) {
  return reference::gerber_effective_tension({mean_N, amplitude_N}, kUltimate_N);
}

double effective_N(const std::string& table, double mean_N, double amplitude_N) {
  return extended_effective_tension(model_with(table))({mean_N, amplitude_N},
                                                       gerber_N(mean_N, amplitude_N));
}

std::string mean_stress(double share, double walker) {
  return fmt::format("[extension.mean_stress]\nmean_stress_share = {}\nwalker_exponent = {}\n",
                     share, walker);
}
std::string bending(double share, double bending_N, double ratio) {
  return fmt::format(
      "[extension.bending_fatigue]\nbending_share = {}\nbending_N = {}\n"
      "wire_to_bend_ratio = {}\n",
      share, bending_N, ratio);
}
std::string limit(double share, double of_lowest, double lowest_N) {
  return fmt::format(
      "[extension.endurance_limit]\nendurance_share = {}\nlimit_log_sd = 0\n"
      "limit_of_lowest = {}\nlowest_effective_N = {}\n",
      share, of_lowest, lowest_N);
}

TEST(ExtendedLife, WalkerAndGoodmanByHand) {
  // Smith, Watson and Topper: sqrt((35 + 25) 25)
  EXPECT_NEAR(effective_N(mean_stress(1, 0.5), 35, 25), std::sqrt(1500.0), 1e-10);
  EXPECT_NEAR(effective_N(mean_stress(1, 0), 35, 25), 25 / (1 - 35 / 177.4), 1e-10);
  // Half way between, in logarithms.
  EXPECT_NEAR(effective_N(mean_stress(0.5, 0.5), 35, 25),
              std::sqrt(std::sqrt(1500.0) * gerber_N(35, 25)), 1e-10);
  EXPECT_EQ(effective_N(mean_stress(1, 0.5), -40, 25), 0);
}

TEST(ExtendedLife, BendAndLimitByHand) {
  // 400 N * 0.05 = 20 N on 25 N
  EXPECT_NEAR(effective_N(bending(1, 400, 0.05), 35, 25), gerber_N(35, 25) * 1.8, 1e-10);
  // 0.5 * 20 N under the effective tension
  EXPECT_NEAR(effective_N(limit(1, 0.5, 20), 35, 25), gerber_N(35, 25) - 10, 1e-10);
  EXPECT_EQ(effective_N(limit(1, 0.5, 80), 35, 25), 0);
}

TEST(ExtendedLife, WithoutWhatItsEquationNeedsThereIsNone) {
  EXPECT_FALSE(extended_effective_tension(model_with("")));
  EXPECT_FALSE(extended_effective_tension(
      model_with("[extension.bending_fatigue]\nbending_share = 1\nbending_N = 400\n")));
}

lifemodel::extension::ExtendedLaw law_of(const Model& model) {
  const auto nominal = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  return lifemodel::extension::life_parameters(nominal,
                                               fixed_extension(model, model.extensions, "m.toml"))
      .law;
}

TEST(ExtendedLife, WhatIsNeverPulledAndWhatIsBelowTheLimitDoNoDamage) {
  const double smallest = lifemodel::pack::to_double(lifemodel::kSmallestCycle);
  const auto damage = [](const std::string& table, double from_N, double to_N) {
    return lifemodel::pack::to_double(law_of(model_with(table))(newtons(from_N), newtons(to_N)));
  };
  EXPECT_LE(damage(mean_stress(1, 0.5), -20, -5), 1e-12);
  EXPECT_EQ(damage(limit(1, 0.5, 40), 10, 40), smallest);
  EXPECT_GT(damage(limit(1, 0.5, 20), 10, 40), 1e-6);
}

double drawn(double low, double high) {
  const auto share = *rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 40);
  return std::lerp(low, high, std::ldexp(static_cast<double>(share), -40));
}

/// Damage of a cycle of a wire under tension, at least twice any limit, in fixed point against that
/// of the equations.
void check(const std::string& table) {
  const Model model = model_with(table);
  const double low_N = drawn(0, 150);
  const double high_N = low_N + drawn(2, 20);
  const double fixed = lifemodel::pack::to_double(law_of(model)(newtons(high_N), newtons(low_N)));
  const reference::Constants constants{kUltimate_N, 0, 1.53e5, 1.38, 5.94};
  const double exact =
      reference::cycle_damage({low_N, high_N}, constants, extended_effective_tension(model));
  constexpr double kRelative = 1e-5;
  if (std::abs(fixed - exact) > kRelative * exact) {
    RC_FAIL(fmt::format("{} in fixed point, {} exactly; {} to {} N, {}", fixed, exact, low_N,
                        high_N, table));
  }
}

RC_GTEST_PROP(ExtendedLife, MeanStress, ()) {
  check(mean_stress(drawn(0, 1), drawn(0.05, 0.8)));
}
RC_GTEST_PROP(ExtendedLife, Goodman, ()) {
  check(mean_stress(drawn(0, 1), 0));
}
RC_GTEST_PROP(ExtendedLife, Bending, ()) {
  check(bending(drawn(0, 1), drawn(50, 2000), drawn(0.01, 0.1)));
}
RC_GTEST_PROP(ExtendedLife, Limit, ()) {
  check(limit(drawn(0, 1), 0.1, drawn(1, 5)));
}
RC_GTEST_PROP(ExtendedLife, AllAtOnce, ()) {
  check(mean_stress(drawn(0, 1), 0.5) + bending(drawn(0, 1), 400, 0.02) +
        limit(drawn(0, 1), 0.1, drawn(1, 3)));
}

/// Without its effects the extended law is the nominal one, to the last bit.
RC_GTEST_PROP(ExtendedLife, NoneIsNominal, ()) {
  const auto extended = law_of(model_with(""));
  const auto x = newtons(drawn(-200, 200));
  const auto y = newtons(drawn(-200, 200));
  RC_PRE(x != y);
  const auto a = extended(x, y);
  const auto b = extended.nominal(x, y);
  RC_ASSERT(a.mantissa == b.mantissa && a.position == b.position);
}

/// Widening a cycle never lowers its damage, on which readings that never fall rest.
RC_GTEST_PROP(ExtendedLife, AWiderCycleDoesNoLess, ()) {
  const auto law = law_of(model_with(mean_stress(drawn(0, 1), *rc::gen::element(0.0, 0.5, 0.7)) +
                                     limit(drawn(0, 1), 0.5, drawn(1, 30))));
  const double low_N = drawn(0, 80);
  const double high_N = low_N + drawn(0.001, 80);
  const double more_N = std::pow(10, drawn(-7, 1));
  const auto damage = [&](double from_N, double to_N) {
    return lifemodel::pack::to_double(law(newtons(from_N), newtons(to_N)));
  };
  const double before = damage(high_N, low_N);
  RC_ASSERT(damage(high_N + more_N, low_N) >= before);
  RC_ASSERT(damage(high_N, low_N - more_N) >= before);
}

}  // namespace
}  // namespace host_sim
