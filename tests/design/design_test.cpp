// Expected values come from the equations of the paper worked out by hand, as each test says.
#include "host_sim/design/design.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "hal/files/input_error.hpp"
#include "tests/design/paper_wire.hpp"

namespace host_sim::design {
namespace {

using host_sim_test::paper_model;
using host_sim_test::paper_tendon;

constexpr double kPi = 3.14159265358979323846;

Tendon with(const std::function<void(Tendon&)>& change) {
  Tendon tendon = paper_tendon();
  change(tendon);
  return tendon;
}

std::string error_of(const Request& request, const Model& model = paper_model()) {
  try {
    static_cast<void>(solve(model, request));
  } catch (const hal::files::InputError& error) {
    return error.what();
  }
  return "solved";
}

TEST(Stress, OfTheUpperArm) {
  // Section 4: 28.5 .. 48.5 N at 270 deg. eta = exp(-0.128 * 4.712389) = 0.547066;
  // (1/eta + eta)/2 = 1.187499, (1/eta - eta)/2 = 0.640433, so T_in,m = 45.7187 + 6.4043 and
  // T_in,a = 24.6567 + 11.8750; T_eff = 36.5317 / (1 - (52.1231/177.4)^2). The paper: 39.9 N.
  const Stress stress = stress_of(paper_model(), with([](Tendon& tendon) {
                                    tendon.output_min_N = 28.5;
                                    tendon.output_max_N = 48.5;
                                  }));
  EXPECT_NEAR(stress.efficiency, 0.547066, 1e-6);
  EXPECT_NEAR(stress.input.mean_N, 52.1231, 1e-4);
  EXPECT_NEAR(stress.input.amplitude_N, 36.5317, 1e-4);
  EXPECT_NEAR(stress.peak_N(), 88.6548, 1e-3);
  EXPECT_NEAR(stress.effective_tension_N, 39.98338, 1e-4);
  EXPECT_FALSE(stress.breaks_at_once());
}

TEST(Life, OfTheGuidelines) {
  // (11) to (14) give 35.16440, 22.22425 and 23.55000 N; lives go with their power of -1.38:
  // (35.16440/22.22425)^1.38 = 1.884, (35.16440/23.55000)^1.38 = 1.739.
  const double life = life_at(paper_model(), paper_tendon(), 0.1);
  // B10: 1.53e5 / 35.16440^1.38 * 0.1053605^(1/5.94) = 1124.784 * 0.684648
  EXPECT_NEAR(life, 770.081, 1e-3);
  const double less_bend =
      life_at(paper_model(), with([](Tendon& s) { s.bend_angle_deg = 180; }), 0.1);
  EXPECT_NEAR(less_bend / life, 1.8836537, 1e-6);
  const double less_friction =
      life_at(paper_model(), with([](Tendon& s) { s.friction_coefficient = 0.09; }), 0.1);
  EXPECT_NEAR(less_friction / life, 1.7389014, 1e-6);
}

TEST(Life, OfAWireTwiceAsThick) {
  // Four times the cross-section hold 709.6 N, and (11) with it divided by 4 gives 7.89893 N on the
  // wire of the model: 31.38124 / (1 - (58.18747/709.6)^2) / 4.
  const Tendon thick = with([](Tendon& s) { s.diameter_mm = 0.914; });
  const Stress stress = stress_of(paper_model(), thick);
  EXPECT_NEAR(stress.ultimate_tension_N, 709.6, 1e-9);
  EXPECT_NEAR(stress.effective_tension_N, 4 * 7.89842, 2e-4);
  EXPECT_NEAR(life_at(paper_model(), thick, 0.1), 6047.190, 1e-3);
  EXPECT_DOUBLE_EQ(diameter_of(paper_model(), 709.6), 0.914);
}

/// Whatever was left out comes back.
struct Case {
  const char* name;
  Unknown unknown;
  void (*forget)(Request&);
  double (*value)(const Design&);
};

class EachUnknown : public testing::TestWithParam<Case> {};

TEST_P(EachUnknown, ComesBack) {
  const Case& what = GetParam();
  for (const double diameter_mm : {0.457, 0.8}) {
    for (const double ratio : {0.0, 0.4, 1.0}) {
      for (const double risk : {0.001, 0.1, 0.9}) {
        Request request{.unknown = what.unknown,
                        .tendon = {.bend_angle_deg = 230,
                                   .friction_coefficient = 0.11,
                                   .output_max_N = 61,
                                   .output_min_N = ratio * 61,
                                   .diameter_mm = diameter_mm},
                        .load_ratio = ratio,
                        .life_cycles = 0,
                        .risk = risk};
        request.life_cycles = life_at(paper_model(), request.tendon, risk);
        const Design whole{what.unknown, request.tendon, request.life_cycles, risk};
        what.forget(request);
        const Design found = solve(paper_model(), request);
        EXPECT_NEAR(what.value(found) / what.value(whole), 1, 1e-12)
            << diameter_mm << " mm, ratio " << ratio << ", risk " << risk;
        EXPECT_NEAR(found.tendon.load_ratio(), ratio, 1e-15);
      }
    }
  }
}

constexpr double kGone = -1e9;

INSTANTIATE_TEST_SUITE_P(
    Design, EachUnknown,
    testing::Values(Case{"life", Unknown::life, [](Request& r) { r.life_cycles = kGone; },
                         [](const Design& d) { return d.life_cycles; }},
                    Case{"tension", Unknown::tension,
                         [](Request& r) { r.tendon.output_max_N = r.tendon.output_min_N = kGone; },
                         [](const Design& d) { return d.tendon.output_max_N; }},
                    Case{"tension_above_a_least", Unknown::tension,
                         [](Request& r) {
                           r.load_ratio.reset();
                           r.tendon.output_max_N = kGone;
                         },
                         [](const Design& d) { return d.tendon.output_max_N; }},
                    Case{"bend", Unknown::bend, [](Request& r) { r.tendon.bend_angle_deg = kGone; },
                         [](const Design& d) { return d.tendon.bend_angle_deg; }},
                    Case{"friction", Unknown::friction,
                         [](Request& r) { r.tendon.friction_coefficient = kGone; },
                         [](const Design& d) { return d.tendon.friction_coefficient; }},
                    Case{"wire", Unknown::wire, [](Request& r) { r.tendon.diameter_mm = kGone; },
                         [](const Design& d) { return d.tendon.diameter_mm; }},
                    Case{"risk", Unknown::risk, [](Request& r) { r.risk = kGone; },
                         [](const Design& d) { return d.risk; }}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(Solve, TensionOfAThousandCycles) {
  // T_eff = (1.53e5 * 0.684648 / 1000)^(1/1.38) = 29.09936 N; with q_m = 1.187499 and
  // q_a = 0.640433 per newton, 29.09936 (1 - (1.187499 t / 177.4)^2) = 0.640433 t gives
  // 0.001303896 t^2 + 0.640433 t - 29.09936 = 0, t = 41.86807.
  const Design found = solve(paper_model(), {.unknown = Unknown::tension,
                                             .tendon = paper_tendon(),
                                             .load_ratio = 1.0,
                                             .life_cycles = 1000,
                                             .risk = 0.1});
  EXPECT_NEAR(found.tendon.output_max_N, 41.86807, 1e-5);
}

TEST(Solve, RiskOfAThousandCycles) {
  // 1 - exp(-(1000 / 1124.784)^5.94)
  const Design found = solve(paper_model(), {.unknown = Unknown::risk,
                                             .tendon = paper_tendon(),
                                             .load_ratio = {},
                                             .life_cycles = 1000,
                                             .risk = 0});
  EXPECT_NEAR(found.risk, 0.3918518, 1e-6);
}

TEST(Solve, AStraightSheathWhereTheLifeAllowsNoBend) {
  Request request{.unknown = Unknown::bend,
                  .tendon = with([](Tendon& s) {
                    s.output_min_N = 0;
                    s.bend_angle_deg = 0;
                  }),
                  .load_ratio = {},
                  .life_cycles = 0,
                  .risk = 0.1};
  request.life_cycles = life_at(paper_model(), request.tendon, 0.1);
  EXPECT_NEAR(solve(paper_model(), request).tendon.bend_angle_deg, 0, 1e-9);
}

TEST(Solve, SaysWhichLivesThereAre) {
  Request request{.unknown = Unknown::tension,
                  .tendon = paper_tendon(),
                  .load_ratio = 1.0,
                  .life_cycles = 1e9,
                  .risk = 0.1};
  // The wire is torn at 0.547066 * 177.4 = 97.05 N.
  EXPECT_EQ(error_of(request),
            "design: no output tension from 0.01 to 97.05 N gives a life of 1e+09 cycles at a risk "
            "of 10 %; accepted: a life of 164.7 to 1.115e+08 cycles");
  request.load_ratio.reset();
  request.tendon.output_min_N = 40;
  request.life_cycles = 2000;
  EXPECT_EQ(error_of(request),
            "design: no output tension from 40 to 97.05 N gives a life of 2000 cycles at a risk of "
            "10 %; accepted: a life of 152.7 to 1076 cycles");
  request.unknown = Unknown::bend;
  request.tendon = paper_tendon();
  request.life_cycles = 100;
  // ln(177.4 / 49) / 0.128 = 10.05146 rad
  EXPECT_EQ(error_of(request),
            "design: no bend angle from 0 to 575.9 deg gives a life of 100 cycles at a risk of 10 "
            "%; accepted: a life of at least 149.5 cycles");
  request.unknown = Unknown::friction;
  EXPECT_EQ(error_of(request).substr(0, 48), "design: no friction coefficient from 0 to 0.273 ");
  request.unknown = Unknown::wire;
  request.life_cycles = 1e12;
  EXPECT_NE(error_of(request).find("no diameter of the wire from 0.3247 to 200 mm gives"),
            std::string::npos)
      << error_of(request);
}

TEST(Solve, SaysWhereNothingWears) {
  Request request{.unknown = Unknown::tension,
                  .tendon = with([](Tendon& s) { s.bend_angle_deg = 0; }),
                  .load_ratio = 1.0,
                  .life_cycles = 1000,
                  .risk = 0.1};
  EXPECT_EQ(error_of(request),
            "design: no output tension from 0.01 to 177.4 N gives a life of 1000 cycles at a risk "
            "of 10 %, as nothing there varies the tension; accepted: a load that varies, or a "
            "sheath with bend and friction");
  request.unknown = Unknown::life;
  EXPECT_EQ(solve(paper_model(), request).life_cycles, std::numeric_limits<double>::infinity());
}

TEST(Solve, RefusesALoadThatTearsTheWire) {
  for (const Unknown unknown : {Unknown::life, Unknown::risk, Unknown::safety}) {
    EXPECT_EQ(error_of({.unknown = unknown,
                        .tendon = with([](Tendon& s) { s.output_max_N = 100; }),
                        .load_ratio = {},
                        .life_cycles = 100,
                        .risk = 0.1}),
              "design: the input tension reaches 182.8 N, and the wire holds 177.4 N; accepted: an "
              "output tension below 97.05 N");
  }
  EXPECT_NE(error_of({.unknown = Unknown::bend,
                      .tendon = with([](Tendon& s) { s.output_max_N = 180; }),
                      .load_ratio = {},
                      .life_cycles = 100,
                      .risk = 0.1})
                .find("below 177.4 N"),
            std::string::npos);
}

TEST(Solve, BendAndFrictionByTheirProduct) {
  Request request{.unknown = Unknown::bend,
                  .tendon = paper_tendon(),
                  .load_ratio = {},
                  .life_cycles = 1000,
                  .risk = 0.1};
  const double bend_rad = solve(paper_model(), request).tendon.bend_angle_deg * kPi / 180;
  request.unknown = Unknown::friction;
  const double friction = solve(paper_model(), request).tendon.friction_coefficient;
  EXPECT_NEAR(friction * 270 * kPi / 180, 0.128 * bend_rad, 1e-12);
}

}  // namespace
}  // namespace host_sim::design
