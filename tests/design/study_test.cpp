// What is said of a design: the derivatives are those of (11) to (22), taken by hand.
#include "host_sim/design/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "hal/files/input_error.hpp"
#include "tests/design/paper_wire.hpp"

namespace host_sim::design {
namespace {

using host_sim_test::paper_model;
using host_sim_test::paper_tendon;

Study paper_study(Unknown unknown = Unknown::life, double life_cycles = 0,
                  const TestRequest& test = {}) {
  return study(paper_model(),
               solve(paper_model(), {.unknown = unknown,
                                     .tendon = paper_tendon(),
                                     .load_ratio = 1.0,
                                     .life_cycles = life_cycles,
                                     .risk = 0.1}),
               test);
}

TEST(Study, Elasticities) {
  std::map<std::string, Elasticity> of;
  double last = 1e9;
  for (const Elasticity& one : paper_study().elasticities) {
    EXPECT_LE(std::abs(one.value), last + 1e-6) << one.input;
    last = std::abs(one.value);
    of[one.input] = one;
  }
  ASSERT_EQ(of.size(), 5U);
  // r = T_m / T_u = 58.18747 / 177.4, g = mu phi = 0.603186, T_m = 49 cosh g, T_a = 49 sinh g.
  const double r2 = std::pow(58.187475 / 177.4, 2);
  const double g = 0.603185789;
  const double gerber = 2 * r2 / (1 - r2);
  EXPECT_NEAR(of["output tension"].value, -1.38 * (1 + gerber), 1e-6);
  EXPECT_NEAR(of["bend angle"].value, -1.38 * g * (1 / std::tanh(g) + gerber * std::tanh(g)), 1e-6);
  EXPECT_NEAR(of["friction coefficient"].value, of["bend angle"].value, 1e-6);
  EXPECT_NEAR(of["diameter of the wire"].value, 2 * 1.38 * (1 + r2) / (1 - r2), 1e-6);
  // d ln (-ln(1 - x)) / d ln x / beta
  EXPECT_NEAR(of["risk"].value, 0.1 / 0.9 / 0.1053605157 / 5.94, 1e-6);
  // 44.1 and 53.9 N: T_eff 31.38124 * 0.9 / (1 - 0.81 r2) and 31.38124 * 1.1 / (1 - 1.21 r2).
  const double own = 31.38124 / (1 - r2);
  EXPECT_NEAR(of["output tension"].life_tenth_less,
              std::pow(31.38124 * 0.9 / (1 - 0.81 * r2) / own, -1.38), 1e-6);
  EXPECT_NEAR(of["output tension"].life_tenth_more,
              std::pow(31.38124 * 1.1 / (1 - 1.21 * r2) / own, -1.38), 1e-6);
}

TEST(Study, ElasticityOfTheLowestTensionAlone) {
  Tendon tendon = paper_tendon();
  tendon.output_min_N = 24.5;
  const Design design{Unknown::life, tendon, life_at(paper_model(), tendon, 0.1), 0.1};
  double found = 0;
  for (const Elasticity& one : study(paper_model(), design, {}).elasticities) {
    found = one.input == "lowest output tension" ? one.value : found;
  }
  // T_in,max = 49 / eta and T_in,min = 24.5 eta: dT_m = dT_in,min / 2 and dT_a = -dT_in,min / 2.
  const double high_N = 49 / 0.5470660198;
  const double low_N = 24.5 * 0.5470660198;
  const double mean_N = (high_N + low_N) / 2;
  const double amplitude_N = (high_N - low_N) / 2;
  const double r2 = std::pow(mean_N / 177.4, 2);
  EXPECT_NEAR(found, -1.38 * low_N / 2 * (-1 / amplitude_N + 2 * r2 / (1 - r2) / mean_N), 1e-6);
}

TEST(Study, TornByATenthMore) {
  Tendon tendon = paper_tendon();
  tendon.output_min_N = tendon.output_max_N = 95;
  const Design design{Unknown::life, tendon, life_at(paper_model(), tendon, 0.1), 0.1};
  for (const Elasticity& one : study(paper_model(), design, {}).elasticities) {
    EXPECT_EQ(one.life_tenth_more == 0, one.input != "risk" && one.value < 0) << one.input;
  }
}

TEST(Study, SafetyFactors) {
  const Safety solved = paper_study().safety;
  EXPECT_NEAR(solved.strength, 177.4 * 0.5470660198 / 49, 1e-8);
  EXPECT_NEAR(solved.at_risk.life, 1, 1e-12);
  EXPECT_NEAR(solved.at_risk.tension, 1, 1e-12);
  // (ln 0.5 / ln 0.9)^(1/5.94)
  EXPECT_NEAR(solved.at_half.life, 1.3732047, 1e-6);

  // Life may fall from 770.081 to 500 cycles: the effective tension may grow by
  // (770.0814/500)^(1/1.38) = 1.367470 to 48.08627 N, where 0.00215467 t^2 + 0.640433 t - 48.08627
  // = 0: t = 62.10667, 1.267483 times 49.
  const Study checked = paper_study(Unknown::safety, 500);
  EXPECT_NEAR(checked.life_cycles, 770.081, 1e-3);
  EXPECT_NEAR(checked.safety.at_risk.life, 770.0814 / 500, 1e-6);
  EXPECT_NEAR(checked.safety.at_risk.tension, 1.267483, 1e-6);

  // Lives as short as 50 cycles are had up to the tension that tears the wire.
  EXPECT_NEAR(paper_study(Unknown::safety, 50).safety.at_risk.tension, solved.strength, 1e-12);
  // A life that is too long has a factor below 1.
  EXPECT_LT(paper_study(Unknown::safety, 2000).safety.at_risk.tension, 1);
}

TEST(Study, AccelerationFactor) {
  EXPECT_FALSE(paper_study().test.has_value());
  // 3.1: T_d = AF T_a. At 60 N: T_a = 38.42601, T_m = 71.24997, T_eff = 45.81605;
  // (45.81605/35.16440)^1.38.
  const Study at_60 = paper_study(Unknown::life, 0, {.output_max_N = 60, .bend_angle_deg = {}});
  EXPECT_NEAR(at_60.test->factor, 770.0813675 / 534.4979226, 1e-8);
  EXPECT_NEAR(at_60.test->life_cycles, 534.4979226, 1e-5);
  // The paper's levels: 270 deg tested at 450 deg, 35.16440 and 70.98909 N.
  const Study at_450 = paper_study(Unknown::life, 0, {.output_max_N = {}, .bend_angle_deg = 450});
  EXPECT_NEAR(at_450.test->factor, std::pow(70.99 / 35.1644, 1.38), 1e-3);
  EXPECT_THROW(
      static_cast<void>(paper_study(Unknown::life, 0, {.output_max_N = 98, .bend_angle_deg = {}})),
      hal::files::InputError);
}

TEST(Study, CurvesEndWhereTheWireIsTorn) {
  const Study of = paper_study();
  ASSERT_EQ(of.curves.size(), 5U);
  for (std::size_t i = 0; i < of.curves.size(); ++i) {
    const Curve& curve = of.curves[i];
    EXPECT_EQ(curve.bend_angle_deg, 90 + 90 * static_cast<double>(i));
    const double torn_N = 177.4 * std::exp(-0.128 * curve.bend_angle_deg * std::acos(-1.0) / 180);
    EXPECT_NEAR(curve.output_max_N.back(), std::min(2.2 * 49, torn_N), 1e-9);
    for (std::size_t k = 1; k < curve.life_cycles.size(); ++k) {
      EXPECT_LT(curve.life_cycles[k], curve.life_cycles[k - 1]);
    }
  }
}

TEST(Study, AnEndlessLifeHasNothingToChange) {
  Tendon tendon = paper_tendon();
  tendon.bend_angle_deg = 0;
  const Study of =
      study(paper_model(),
            solve(paper_model(),
                  {.unknown = Unknown::life, .tendon = tendon, .load_ratio = {}, .risk = 0.1}),
            {});
  EXPECT_TRUE(of.elasticities.empty());
  std::ostringstream out;
  write_design(out, of, {"0", 20.0});
  EXPECT_NE(out.str().find("Life has no end"), std::string::npos);
  EXPECT_NE(out.str().find("unlimited"), std::string::npos);
  const auto json = nlohmann::json::parse(design_json(of, {"0", 20.0}));
  EXPECT_TRUE(json["life_cycles"].is_null());
  EXPECT_TRUE(json["life_hours"].is_null());
}

/// The paper's law as if its fit were known to be this sure.
Model uncertain_model() {
  Model model = paper_model();
  // The life at the pivot: 1.53e5 / 50^1.38 = 692.0107.
  model.life.interval = Model::Life::Interval{.level = 0.95,
                                              .ipl_scale = {1e5, 2e5},
                                              .ipl_exponent = {1.28, 1.58},
                                              .weibull_shape = {4.94, 6.94},
                                              .pivot_tension_N = 50,
                                              .life_at_pivot = {650, 740}};
  return model;
}

Study uncertain_study(const Tendon& tendon, double risk) {
  const Model model = uncertain_model();
  return study(
      model,
      solve(model, {.unknown = Unknown::life, .tendon = tendon, .load_ratio = {}, .risk = risk}),
      {});
}

TEST(Study, IntervalOfTheLife) {
  EXPECT_FALSE(paper_study().interval.has_value());
  // In logarithms. Life at the pivot: ln(692.0107 / 650), ln(740 / 692.0107). Exponent at 35.16440
  // N, below the pivot: a smaller one shortens life, 0.1 and 0.2 times ln(50 / 35.16440). Shape:
  // ln(0.1053605) times 1 / 4.94 - 1 / 5.94 and 1 / 5.94 - 1 / 6.94.
  const double ratio = std::log(50 / 35.1644024127);
  const double hazard = std::log(-std::log(0.9));
  const double below =
      std::hypot(std::log(692.0107 / 650), 0.1 * ratio, hazard * (1 / 4.94 - 1 / 5.94));
  const double above =
      std::hypot(std::log(740 / 692.0107), 0.2 * ratio, hazard * (1 / 5.94 - 1 / 6.94));
  const Study of = uncertain_study(paper_tendon(), 0.1);
  ASSERT_TRUE(of.interval.has_value());
  EXPECT_EQ(of.interval->level, 0.95);
  EXPECT_NEAR(std::log(770.0813675 / of.interval->low_cycles), below, 1e-6);
  EXPECT_NEAR(std::log(of.interval->high_cycles / 770.0813675), above, 1e-6);

  // Above the pivot a larger exponent shortens life: at 450 deg 70.98908 N. Beyond 63.2 % a larger
  // shape does: ln(-ln 0.1) > 0.
  Tendon bent = paper_tendon();
  bent.bend_angle_deg = 450;
  const Study hard = uncertain_study(bent, 0.9);
  const double other_ratio = std::log(hard.stress.effective_tension_N / 50);
  const double other_hazard = std::log(-std::log(0.1));
  EXPECT_NEAR(
      std::log(hard.life_cycles / hard.interval->low_cycles),
      std::hypot(std::log(692.0107 / 650), 0.2 * other_ratio, other_hazard * (1 / 5.94 - 1 / 6.94)),
      1e-6);
  EXPECT_NEAR(
      std::log(hard.interval->high_cycles / hard.life_cycles),
      std::hypot(std::log(740 / 692.0107), 0.1 * other_ratio, other_hazard * (1 / 4.94 - 1 / 5.94)),
      1e-6);
}

TEST(Study, IntervalOfAThickerWireIsThatOfEqualStress) {
  // A wire of four times the cross-section under four times the load.
  Tendon thick = paper_tendon();
  thick.diameter_mm = 0.914;
  thick.output_max_N = thick.output_min_N = 196;
  const auto own = uncertain_study(paper_tendon(), 0.1).interval;
  const auto other = uncertain_study(thick, 0.1).interval;
  EXPECT_NEAR(other->low_cycles / own->low_cycles, 1, 1e-12);
  EXPECT_NEAR(other->high_cycles / own->high_cycles, 1, 1e-12);
}

TEST(Study, TellsTheInterval) {
  const Study of = uncertain_study(paper_tendon(), 0.1);
  const auto json = nlohmann::json::parse(design_json(of, {"0", {}}));
  EXPECT_EQ(json["life_interval_cycles"]["level"], 0.95);
  EXPECT_LT(json["life_interval_cycles"]["low"], 770.0);
  EXPECT_GT(json["life_interval_cycles"]["high"], 771.0);
  EXPECT_TRUE(nlohmann::json::parse(design_json(paper_study(), {"0", {}}))["life_interval_cycles"]
                  .is_null());
  std::ostringstream out;
  write_design(out, of, {"0", {}});
  EXPECT_NE(out.str().find("\n    95 % interval      "), std::string::npos) << out.str();
}

TEST(Study, TellsLivesInHours) {
  const auto json = nlohmann::json::parse(design_json(paper_study(), {"0", 20.0}));
  EXPECT_NEAR(json["life_hours"].get<double>(), 770.0813675 / 1200, 1e-9);
  EXPECT_FALSE(nlohmann::json::parse(design_json(paper_study(), {"0", {}})).contains("life_hours"));
}

}  // namespace
}  // namespace host_sim::design
