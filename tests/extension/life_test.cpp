#include "host_sim/extension/life.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/extension/fixed.hpp"
#include "host_sim/reference/reference.hpp"
#include "lifemodel/extension/life.hpp"
#include "lifemodel/pack/pack.hpp"
#include "tests/extension/models.hpp"
#include "tests/lifemodel/support.hpp"
#include "tests/reference/vectors.hpp"

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

/// 20 N of bend on T_a = 25 N: the law of mean stress sees 45 N.
TEST(ExtendedLife, TheBendJoinsTheAmplitudeOfTheLawOfMeanStress) {
  const std::string bend = bending(1, 400, 0.05);
  // Smith, Watson and Topper: sqrt((35 + 45) 45) = 60
  EXPECT_NEAR(effective_N(mean_stress(1, 0.5) + bend, 35, 25), 60, 1e-10);
  EXPECT_NEAR(effective_N(mean_stress(1, 0) + bend, 35, 25), 45 / (1 - 35 / 177.4), 1e-10);
  // By a share of a quarter: sqrt((35 + 25) 25)^(3/4) 60^(1/4)
  EXPECT_NEAR(effective_N(mean_stress(1, 0.5) + bending(0.25, 400, 0.05), 35, 25),
              std::pow(1500, 0.375) * std::pow(60, 0.25), 1e-10);
}

/// Ranges of published programs; w up to what a model may give.
TEST(ExtendedLife, WalkerAndGoodmanOfPublishedVectors) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "damage_vectors.json");
  int checked = 0;
  for (const auto& vector : *vectors) {
    const auto kind = vector.at("kind").get<std::string>();
    const double walker = kind == "swt" ? 0.5 : vector.value("gamma", 0.0);
    if ((kind != "walker_amplitude" && kind != "swt" && kind != "goodman") || walker > 0.8) {
      continue;
    }
    const double scale = kUltimate_N / vector.value("Su", kUltimate_N);
    for (std::size_t i = 0; i < vector["S"].size(); ++i) {
      const double amplitude_N = scale * vector["S"][i].get<double>() / 2;
      const double mean_N = scale * vector["Sm"][i].get<double>();
      EXPECT_NEAR(2 * effective_N(mean_stress(1, walker), mean_N, amplitude_N) / scale,
                  vector["St"][i].get<double>(), 1e-5)
          << kind << ' ' << walker;
      ++checked;
    }
  }
  EXPECT_GE(checked, 4 * (4 + 1 + 1));
}

/// 150 .. 170 N with 20 N of bend: the bend alone, at 170 N, is beyond 30 N about 160 N.
TEST(ExtendedLife, NearTheUltimateTensionTheBendAloneCounts) {
  const std::string bend = bending(1, 400, 0.05);
  EXPECT_NEAR(effective_N(bend, 160, 10), 20 / (1 - std::pow(170 / 177.4, 2)), 1e-9);
  EXPECT_NEAR(effective_N(bend, -160, 10), 20 / (1 - std::pow(170 / 177.4, 2)), 1e-9);
  EXPECT_NEAR(effective_N(mean_stress(1, 0) + bend, 160, 10), 20 / (1 - 170 / 177.4), 1e-9);
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
  check(mean_stress(drawn(0, 1), *rc::gen::element(0.0, 0.5)) + bending(drawn(0, 1), 400, 0.02) +
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

/// Any of the effects, alone or together, of any size that a model may give.
std::string any_effects() {
  const unsigned which = *rc::gen::inRange(0u, 8u);
  const double share = *rc::gen::element(0.0, 0.3, 1.0);
  std::string tables;
  if ((which & 1u) != 0) {
    tables += mean_stress(*rc::gen::element(drawn(0, 1), 1.0),
                          *rc::gen::element(0.0, 0.1, 0.5, drawn(0, 0.8), 0.8));
  }
  if ((which & 2u) != 0) {
    tables += bending(std::max(share, drawn(0, 1)), drawn(50, 2000), drawn(0, 0.13));
  }
  if ((which & 4u) != 0) {
    tables += limit(std::max(share, drawn(0, 1)), drawn(0.1, 0.95), drawn(1, 60));
  }
  return tables;
}

/// Doubles resolve 1 - (T/T_u)^2 to this up to so near the ultimate tension.
constexpr double kRounding = 1e-9;
constexpr double kResolved_N = kUltimate_N - 2e-4;

/// On this readings that never fall rest, in fixed point and in the equations: every pair of cycles
/// of which one lies within the other, up to the ultimate tension.
RC_GTEST_PROP(ExtendedLife, AWiderCycleDoesNoLess, ()) {
  const std::string tables = any_effects();
  const Model model = model_with(tables);
  const auto law = law_of(model);
  const auto effective = extended_effective_tension(model);
  const reference::Constants constants{kUltimate_N, 0, 1.53e5, 1.38, 5.94};
  for (int i = 0; i < 50; ++i) {
    // Far apart or near each other, anywhere or next to the ultimate tension.
    const auto some = [](double low_N, double high_N) {
      const double part = *rc::gen::element(0.0, drawn(0, 1), std::pow(10, drawn(-8, 0)),
                                            1 - std::pow(10, drawn(-8, 0)), 1.0);
      return std::lerp(low_N, high_N, part);
    };
    const double wide_low_N = some(-kUltimate_N, kUltimate_N - 1e-3);
    const double wide_high_N = some(wide_low_N + 1e-3, kUltimate_N);
    const double low_N = some(wide_low_N, wide_high_N - 1e-4);
    const double high_N = some(low_N + 1e-5, wide_high_N);
    const auto fixed = [&](double from_N, double to_N) {
      return lifemodel::pack::to_double(law(newtons(from_N), newtons(to_N)));
    };
    const auto exact = [&](double from_N, double to_N) {
      return reference::cycle_damage({from_N, to_N}, constants, effective);
    };
    const std::string what = fmt::format("{:.9f} .. {:.9f} in {:.9f} .. {:.9f} N, {}", low_N,
                                         high_N, wide_low_N, wide_high_N, tables);
    if (!(fixed(high_N, low_N) <= fixed(wide_high_N, wide_low_N))) {
      RC_FAIL("in fixed point: " + what);
    }
    if (std::max(-wide_low_N, wide_high_N) <= kResolved_N &&
        !(exact(high_N, low_N) <= exact(wide_high_N, wide_low_N) * (1 + kRounding))) {
      RC_FAIL("in the equations: " + what);
    }
  }
}

/// What is counted of a signal never falls with any of the effects, and both counts agree.
RC_GTEST_PROP(ExtendedLife, TheReadingNeverFalls, ()) {
  using Layout = lifemodel::extension::ExtendedLife<lifemodel::DefaultLayout>;
  const std::string tables = any_effects();
  const Model model = model_with(tables);
  const auto nominal = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  lifemodel::Estimator<1, Layout> estimator({lifemodel::extension::life_parameters(
      nominal, fixed_extension(model, model.extensions, "m.toml"))});
  reference::Reference reference({kUltimate_N, 0, 1.53e5, 1.38, 5.94},
                                 extended_effective_tension(model));
  const double top_N = *rc::gen::element(60.0, 170.0, 177.39);
  const double least_N = *rc::gen::element(0.0, 0.9, 0.99) * top_N;
  lifemodel::Damage before;
  double exact_before = 0;
  for (int i = 0; i < 60; ++i) {
    const double tension_N = drawn(least_N, top_N);
    estimator.push(0, newtons(tension_N));
    reference.push(tension_N);
    const lifemodel::Damage now = estimator.reading(0).total;
    const double exact = reference.reading().damage.total;
    if (now < before || exact < exact_before * (1 - kRounding)) {
      RC_FAIL(fmt::format("sample {}: {} after {}, exactly {} after {}, {}", i,
                          lifemodel::pack::to_double(now), lifemodel::pack::to_double(before),
                          exact, exact_before, tables));
    }
    before = now;
    exact_before = exact;
  }
}

}  // namespace
}  // namespace host_sim
