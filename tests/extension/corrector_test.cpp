#include "lifemodel/extension/corrector.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "hal/files/input_error.hpp"
#include "host_sim/extension/fixed.hpp"
#include "host_sim/extension/tension.hpp"
#include "lifemodel/pack/pack.hpp"
#include "tests/extension/models.hpp"
#include "tests/lifemodel/support.hpp"

namespace lifemodel::extension {
namespace {

using host_sim::Covariates;
using pack::from_double;
using pack::to_double;

constexpr double kUltimate_N = 177.4;
/// What the conversion of a sample may lose of the ultimate tension, and of the tension itself.
constexpr double kAbsolute_N = 5e-7 * kUltimate_N;
constexpr double kRelative = 1e-6;

/// The same model in fixed point and in double precision.
struct Both {
  explicit Both(std::string_view tables)
      : model(extension_test::model_with(tables)),
        parameters(lifemodel_test::parameters_of(lifemodel_test::paper_constants())),
        extension(host_sim::fixed_extension(model, model.extensions, "m.toml")),
        corrector(parameters, extension),
        exact(model) {
    extension.each([&](Effect effect, auto& part) {
      EXPECT_TRUE(!extension.has(effect) || part.plausible());
    });
  }
  Both(const Both&) = delete;
  Both& operator=(const Both&) = delete;

  double output_N(double tension_N, const Covariates& at) {
    const SheathSample sample{pack::tension(tension_N, kUltimate_N),
                              from_double<Angle>(at.bend_angle_rad), fixed_covariates(at)};
    return kUltimate_N * to_double(corrector.input_tension(sample, flags));
  }
  double current_N(double current_A, const Covariates& at) {
    const DriveSample sample{from_double<MotorCurrent>(current_A), fixed_covariates(at)};
    return kUltimate_N * to_double(corrector.input_tension(sample, flags));
  }
  double exact_output_N(double tension_N, const Covariates& at) {
    return exact.from_output_N(tension_N, at);
  }

  static lifemodel::extension::Covariates fixed_covariates(const Covariates& at) {
    lifemodel::extension::Covariates fixed;
    fixed.velocity = from_double<Velocity>(at.velocity_m_s);
    fixed.rotor.raw = std::llround(
        std::ldexp(at.motor_angle_rad / (2 * std::numbers::pi), RotorAngle::kFractionBits));
    fixed.sheath = from_double<Temperature>(at.sheath_temperature_C);
    fixed.winding = from_double<Temperature>(at.winding_temperature_C);
    return fixed;
  }

  host_sim::Model model;
  Parameters parameters;
  Extension extension;
  Corrector corrector;
  host_sim::ExtendedInput exact;
  Flags flags;
};

double drawn(double low, double high) {
  const auto share = *rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 40);
  return std::lerp(low, high, std::ldexp(static_cast<double>(share), -40));
}

Covariates drawn_covariates() {
  Covariates at;
  at.velocity_m_s = drawn(-0.5, 0.5);
  at.direction = at.velocity_m_s < 0 ? -1 : 1;
  at.bend_angle_rad = drawn(0, 2 * std::numbers::pi);
  at.motor_angle_rad = drawn(-300, 300);
  at.sheath_temperature_C = drawn(-20, 80);
  at.winding_temperature_C = drawn(-20, 150);
  return at;
}

bool is_near(double fixed_N, double exact_N) {
  const double most_N = 3.9 * kUltimate_N;
  if (std::abs(exact_N) > most_N) {
    return std::abs(fixed_N) > most_N * 0.99;
  }
  return std::abs(fixed_N - exact_N) <= kAbsolute_N + kRelative * std::abs(exact_N);
}

/// The output, by both, of a tension with covariates that are drawn.
void check_output(const std::string& tables) {
  Both both(tables);
  Covariates at = drawn_covariates();
  const double output_N = drawn(0.5, 120);
  const auto turned = both.corrector.cycles();
  const double fixed_N = both.output_N(output_N, at);
  at.cycle = turned;
  const double exact_N = both.exact_output_N(output_N, at);
  if (!is_near(fixed_N, exact_N)) {
    RC_FAIL(fmt::format("{} N in fixed point, {} N exactly; output {} N, {}", fixed_N, exact_N,
                        output_N, tables));
  }
}

void check_current(const std::string& tables) {
  Both both(tables);
  const Covariates at = drawn_covariates();
  const double current_A = drawn(-2, 8);
  const double fixed_N = both.current_N(current_A, at);
  const double exact_N = both.exact.from_current_N(current_A, at);
  if (!is_near(fixed_N, exact_N)) {
    RC_FAIL(fmt::format("{} N in fixed point, {} N exactly; current {} A, {}", fixed_N, exact_N,
                        current_A, tables));
  }
}

RC_GTEST_PROP(Corrector, Offset, ()) {
  check_current(
      fmt::format("[extension.current_offset]\ncurrent_offset_A = {}\n", drawn(-0.5, 0.5)));
}
RC_GTEST_PROP(Corrector, Droop, ()) {
  check_current(fmt::format("[extension.torque_gain]\ndroop_1_K = {}\nwinding_reference_C = {}\n",
                            drawn(0, 0.005), drawn(-20, 40)));
}
RC_GTEST_PROP(Corrector, Asymmetry, ()) {
  check_current(fmt::format("[extension.gear_asymmetry]\ngear_asymmetry = {}\n", drawn(-0.3, 0.3)));
}
RC_GTEST_PROP(Corrector, Ripple, ()) {
  check_current(
      fmt::format("[extension.torque_ripple]\nripple_sine_A = {}\nripple_cosine_A = {}\n"
                  "ripple_harmonic = {}\n",
                  drawn(-0.5, 0.5), drawn(-0.5, 0.5), *rc::gen::inRange(1, 25)));
}
RC_GTEST_PROP(Corrector, TemperatureOfTheSheath, ()) {
  check_output(
      fmt::format("[extension.friction_temperature]\ntemperature_coefficient_1_K = {}\n"
                  "sheath_reference_C = {}\n",
                  drawn(-0.05, 0.05), drawn(-20, 40)));
}
RC_GTEST_PROP(Corrector, Velocity, ()) {
  check_output(
      fmt::format("[extension.friction_velocity]\nstribeck_friction = {}\n"
                  "viscous_friction_s_m = {}\nstribeck_velocity_m_s = {}\n",
                  drawn(-0.5, 0.5), drawn(-1, 1), drawn(0.002, 0.1)));
}
RC_GTEST_PROP(Corrector, Load, ()) {
  check_output(fmt::format("[extension.friction_load]\nload_exponent = {}\n", drawn(-0.5, 0.5)));
}
RC_GTEST_PROP(Corrector, LoadThatIsHardlyThere, ()) {
  check_output(fmt::format("[extension.friction_load]\nload_exponent = {:e}\n",
                           drawn(-1, 1) * std::pow(10, drawn(-7, -2))));
}
RC_GTEST_PROP(Corrector, Preload, ()) {
  check_output(fmt::format("[extension.friction_preload]\npreload_N = {}\n", drawn(0, 50)));
}
RC_GTEST_PROP(Corrector, Position, ()) {
  std::string table = "[extension.friction_position]\n";
  for (int harmonic = 1; harmonic <= 6; ++harmonic) {
    table += fmt::format("position_sine_{0} = {1}\nposition_cosine_{0} = {2}\n", harmonic,
                         drawn(-0.15, 0.15), drawn(-0.15, 0.15));
  }
  check_output(table + fmt::format("wavelength_m = {}\n", drawn(0.02, 0.32)) +
               fmt::format("[extension.friction_preload]\npreload_N = {}\n", drawn(0, 20)));
}
RC_GTEST_PROP(Corrector, BendAngle, ()) {
  check_output(
      fmt::format("[extension.bend_angle]\nbend_angle_error_rad = [{}, {}, {}]\n"
                  "bend_angles_deg = [60, 150.5, 300]\n",
                  drawn(-0.6, 0.6), drawn(-0.6, 0.6), drawn(-0.6, 0.6)));
}

/// Wear after so many cycles.
void check_wear(const std::string& table, std::uint32_t cycles) {
  Both both(table);
  both.corrector.start_at(cycles);
  Covariates at = drawn_covariates();
  at.velocity_m_s = 0.1;
  at.direction = 1;
  at.cycle = cycles;
  const double output_N = drawn(0.5, 120);
  const double fixed_N = both.output_N(output_N, at);
  const double exact_N = both.exact_output_N(output_N, at);
  if (!is_near(fixed_N, exact_N)) {
    RC_FAIL(fmt::format("{} N in fixed point, {} N exactly after {} cycles; {}", fixed_N, exact_N,
                        cycles, table));
  }
}

RC_GTEST_PROP(Corrector, Wear, ()) {
  check_wear(fmt::format("[extension.friction_wear]\nwear_coefficient = {}\nwear_exponent = {}\n"
                         "run_in_cycles = 0\n",
                         drawn(-1, 6), drawn(0.1, 2)),
             *rc::gen::inRange<std::uint32_t>(0, 5000));
}
RC_GTEST_PROP(Corrector, RunIn, ()) {
  check_wear(fmt::format("[extension.friction_wear]\nwear_coefficient = {}\nwear_exponent = 0\n"
                         "run_in_cycles = {}\n",
                         drawn(-1, 6), drawn(1, 10000)),
             *rc::gen::inRange<std::uint32_t>(0, 100000));
}

RC_GTEST_PROP(Corrector, Lag, ()) {
  Both both(fmt::format("[extension.filter_lag]\nlag_s = {}\n", drawn(0.0001, 0.05)));
  Covariates at;
  for (int i = 0; i < 10; ++i) {
    const double output_N = drawn(20, 21);
    RC_ASSERT(is_near(both.output_N(output_N, at) / 50, both.exact_output_N(output_N, at) / 50));
  }
}

RC_GTEST_PROP(Corrector, ViscousForce, ()) {
  check_output(
      fmt::format("[extension.friction_velocity]\nviscous_N_s_m = {}\n", drawn(0.001, 100)));
}
RC_GTEST_PROP(Corrector, Zero, ()) {
  check_output(fmt::format("[extension.load_cell_zero]\nzero_N = {}\n", drawn(-20, 20)));
}

/// Strokes of any length and speed one after the other, forces of either sign.
RC_GTEST_PROP(Corrector, Presliding, ()) {
  Both both(
      fmt::format("[extension.presliding]\npresliding_length_m = {}\npresliding_share = {}\n"
                  "[extension.friction_preload]\npreload_N = {}\n"
                  "[extension.friction_velocity]\nviscous_N_s_m = {}\n",
                  std::pow(10, drawn(-5, -1)), drawn(0.5, 1), drawn(0, 20), drawn(0, 50)));
  Covariates at;
  at.bend_angle_rad = drawn(0, 2 * std::numbers::pi);
  for (int stroke = 0; stroke < 8; ++stroke) {
    at.direction = *rc::gen::arbitrary<bool>() ? -1 : 1;
    // As a sample can hold it: what it is rounded by adds up along the way.
    at.velocity_m_s = at.direction * to_double(from_double<Velocity>(std::pow(10, drawn(-4, 0))));
    const double output_N = drawn(-100, 100);
    for (int i = 0; i < 40; ++i) {
      const double fixed_N = both.output_N(output_N, at);
      const double exact_N = both.exact_output_N(output_N, at);
      if (!is_near(fixed_N, exact_N)) {
        RC_FAIL(fmt::format("{} N in fixed point, {} N exactly; stroke {}, sample {}", fixed_N,
                            exact_N, stroke, i));
      }
    }
  }
}

/// A correction over one covariate, knots anywhere, of one knot too.
void check_correction(std::string_view covariate, double low, double high) {
  const int count = *rc::gen::inRange(1, 17);
  std::string knots;
  std::string pulling_N;
  std::string letting_go_N;
  for (int i = 0; i < count; ++i) {
    const char* const comma = i == 0 ? "" : ", ";
    knots += fmt::format("{}{}", comma,
                         std::lerp(low, high, (i + drawn(0.1, 0.9)) / static_cast<double>(count)));
    pulling_N += fmt::format("{}{}", comma, drawn(-2, 2));
    letting_go_N += fmt::format("{}{}", comma, drawn(-2, 2));
  }
  const std::string table =
      fmt::format("[extension.empirical]\n{} = [{}]\npulling_N = [{}]\nletting_go_N = [{}]\n",
                  covariate, knots, pulling_N, letting_go_N);
  check_output(table);
  Both both(table);
  Covariates at = drawn_covariates();
  at.velocity_m_s = to_double(from_double<Velocity>(at.velocity_m_s));
  for (int i = 0; i < 20; ++i) {
    if (i % 7 == 6) {  // turns
      at.velocity_m_s = -at.velocity_m_s;
      at.direction = -at.direction;
    }
    RC_ASSERT(is_near(both.output_N(40, at), both.exact_output_N(40, at)));
  }
}

RC_GTEST_PROP(Corrector, CorrectionByTension, ()) {
  check_correction("output_tension_N", 0, 130);
}
RC_GTEST_PROP(Corrector, CorrectionByPosition, ()) {
  check_correction("position_m", -0.5, 0.5);
}
RC_GTEST_PROP(Corrector, CorrectionBySpeed, ()) {
  check_correction("speed_m_s", 0, 0.6);
}
RC_GTEST_PROP(Corrector, CorrectionByTravel, ()) {
  check_correction("travel_m", 0, 0.005);
}

/// Of a drive that works both ways.
RC_GTEST_PROP(Corrector, ForcesOfEitherSign, ()) {
  Both both(
      fmt::format("[extension.friction_load]\nload_exponent = {}\n"
                  "[extension.friction_preload]\npreload_N = {}\n"
                  "[extension.load_cell_zero]\nzero_N = {}\n",
                  drawn(-0.3, 0.3), drawn(0, 20), drawn(-5, 5)));
  const Covariates at = drawn_covariates();
  const double output_N = drawn(-100, 100);
  RC_ASSERT(is_near(both.output_N(output_N, at), both.exact_output_N(output_N, at)));
}

// The 50 N that the law refers to are 8 times 6.25 N, and 1 MN is 2e4 times as much.
TEST(Corrector, FrictionByLoadNeedsAnUltimateTensionAbove6_25N) {
  host_sim::Model model =
      extension_test::model_with("[extension.friction_load]\nload_exponent = 0.2\n");
  for (const double ultimate_N : {6.26, 1e6}) {
    model.cable.ultimate_tension_N = ultimate_N;
    EXPECT_NEAR(std::ldexp(host_sim::fixed_extension(model, model.extensions, "m.toml")
                               .friction_load.log2_reference,
                           -26),
                29 + std::log2(50 / ultimate_N), 1e-7);
  }
  model.cable.ultimate_tension_N = 6.25;
  try {
    host_sim::fixed_extension(model, model.extensions, "m.toml");
    FAIL() << "accepted";
  } catch (const hal::files::InputError& error) {
    EXPECT_STREQ(error.what(),
                 "m.toml: ultimate_tension_N is 6.25 with [extension.friction_load]; accepted: "
                 "more than 6.25 N with it");
  }
}

/// Many at once: the order of the equations is the same.
RC_GTEST_PROP(Corrector, ManyAtOnce, ()) {
  check_output(fmt::format(
      "[extension.bend_angle]\nbend_angle_error_rad = {}\n"
      "[extension.friction_load]\nload_exponent = {}\n"
      "[extension.friction_preload]\npreload_N = {}\n"
      "[extension.friction_temperature]\ntemperature_coefficient_1_K = {}\n"
      "[extension.friction_velocity]\nstribeck_friction = {}\nviscous_friction_s_m = 0.1\n"
      "stribeck_velocity_m_s = 0.02\n",
      drawn(-0.3, 0.3), drawn(-0.2, 0.2), drawn(0, 5), drawn(-0.005, 0.005), drawn(-0.05, 0.05)));
}

RC_GTEST_PROP(Corrector, TheWholeDriveAtOnce, ()) {
  check_current(fmt::format(
      "[extension.current_offset]\ncurrent_offset_A = {}\n"
      "[extension.torque_gain]\ndroop_1_K = {}\n[extension.gear_asymmetry]\ngear_asymmetry = {}\n"
      "[extension.torque_ripple]\nripple_sine_A = {}\nripple_cosine_A = 0\nripple_harmonic = 6\n",
      drawn(-0.1, 0.1), drawn(0, 0.002), drawn(-0.05, 0.05), drawn(-0.1, 0.1)));
}

TEST(Corrector, CountsACycleForTwoTurns) {
  Both both("[extension.friction_preload]\npreload_N = 2\n");
  const auto move = [&](double velocity_m_s) {
    Covariates at;
    at.velocity_m_s = velocity_m_s;
    static_cast<void>(both.output_N(40, at));
    return both.corrector.cycles();
  };
  EXPECT_EQ(move(0.1), 0u);
  EXPECT_EQ(move(-0.0005), 0u);  // not yet turned
  EXPECT_EQ(move(-0.1), 0u);
  EXPECT_EQ(move(0.1), 1u);
  EXPECT_EQ(move(-0.1), 1u);
  EXPECT_EQ(move(0.1), 2u);
}

TEST(Corrector, PreloadWorksAgainstTheMotion) {
  // 49 exp(+-0.128 * 1.5 pi) +- 2 N
  Both both("[extension.friction_preload]\npreload_N = 2\n");
  Covariates at;
  at.bend_angle_rad = 1.5 * std::numbers::pi;
  at.velocity_m_s = 0.1;
  EXPECT_NEAR(both.output_N(49, at), 89.5687 + 2, 1e-3);
  at.velocity_m_s = -0.1;
  EXPECT_NEAR(both.output_N(49, at), 26.8062 - 2, 1e-3);
}

TEST(Corrector, FrictionWorksAgainstTheMotionWhateverTheSignOfTheForce) {
  // -49 exp(-+0.128 * 1.5 pi) +- 2 N
  Both both("[extension.friction_preload]\npreload_N = 2\n");
  Covariates at;
  at.bend_angle_rad = 1.5 * std::numbers::pi;
  at.velocity_m_s = 0.1;
  EXPECT_NEAR(both.output_N(-49, at), -26.8062 + 2, 1e-3);
  at.velocity_m_s = -0.1;
  EXPECT_NEAR(both.output_N(-49, at), -89.5687 - 2, 1e-3);
}

TEST(Corrector, SlipStartsAtNothingAndStandsStillWithTheTendon) {
  // 1 mm at 0.5 m/s and 1 kHz is two samples; 10 (1 - exp(-1)) N.
  Both both(
      "[extension.presliding]\npresliding_length_m = 0.001\n"
      "[extension.friction_preload]\npreload_N = 10\n");
  Covariates at;
  EXPECT_NEAR(both.output_N(0, at), 0, 1e-5);
  at.velocity_m_s = 0.5;
  static_cast<void>(both.output_N(0, at));
  EXPECT_NEAR(both.output_N(0, at), 6.321206, 2e-5);
  at.velocity_m_s = 0;
  for (int i = 0; i < 100; ++i) {
    EXPECT_NEAR(both.output_N(0, at), 6.321206, 2e-5);
  }
}

TEST(Corrector, ACorrectionIsLinearBetweenItsKnots) {
  Both both(
      "[extension.empirical]\nspeed_m_s = [0.1, 0.2]\npulling_N = [1, 3]\n"
      "letting_go_N = [-2, -6]\n");
  const auto at_speed = [&](double velocity_m_s) {
    Covariates at;
    at.velocity_m_s = velocity_m_s;
    return both.output_N(50, at);
  };
  EXPECT_NEAR(at_speed(0.01), 51, 1e-4);
  EXPECT_NEAR(at_speed(0.125), 51.5, 1e-4);
  EXPECT_NEAR(at_speed(0.3), 53, 1e-4);
  EXPECT_NEAR(at_speed(-0.15), 46, 1e-4);
}

TEST(Corrector, AGapLeavesNoRate) {
  Both both("[extension.filter_lag]\nlag_s = 0.005\n");
  const Covariates at;
  static_cast<void>(both.output_N(40, at));
  EXPECT_NEAR(both.output_N(40.1, at), 40.6, 1e-5);
  both.corrector.gap();
  EXPECT_NEAR(both.output_N(50, at), 50, 1e-5);
}

TEST(Corrector, FrictionBeyondItsBoundsIsHeldAndFlagged) {
  Both both(
      "[extension.friction_velocity]\nstribeck_friction = -0.5\nviscous_friction_s_m = 0\n"
      "stribeck_velocity_m_s = 0.1\n");
  Covariates at;
  at.bend_angle_rad = 3;
  EXPECT_NEAR(both.output_N(40, at), 40, 1e-5);
  EXPECT_TRUE(both.flags.has(Flag::saturated));
}

}  // namespace
}  // namespace lifemodel::extension
