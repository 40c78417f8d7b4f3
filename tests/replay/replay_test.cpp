#include "host_sim/replay/replay.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hal/files/input_error.hpp"
#include "hal/files/input_file.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/replay/profile_input.hpp"
#include "host_sim/replay/results.hpp"

namespace host_sim {

using hal::files::InputError;
using hal::files::InputKind;
using hal::files::memory_source;
using hal::files::ProfileReader;

namespace {

Model paper_model() {
  return {.cable = {.diameter_mm = 0.457, .ultimate_tension_N = 177.4},
          .sheath = {.friction_coefficient = 0.128, .bend_angle_deg = 270},
          .drive = Model::Drive{.torque_constant_Nm_per_A = 0.0325,
                                .gear_ratio = 9,
                                .gear_efficiency = 0.88,
                                .spool_radius_mm = 12.5,
                                .current_offset_A = 0},
          .counting = {.sample_rate_Hz = 10, .hysteresis_N = 0.2},
          .life = {.mean_stress = Model::MeanStress::kGerber,
                   .ipl_scale = 1.53e5,
                   .ipl_exponent = 1.38,
                   .weibull_shape = 5.94}};
}

ReplayResult replay_text(const std::string& text, const Model& model,
                         const ReplayOptions& options = {}) {
  ProfileReader profile(memory_source(text), "profile.csv");
  return replay(profile, model, "model.toml", options);
}

/// Rows of 10 Hz with these values.
std::string rows(const std::string& header, const std::vector<std::string>& values) {
  std::string text = header + "\n";
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += std::to_string(i / 10) + "." + std::to_string(i % 10) + "," + values[i] + "\n";
  }
  return text;
}

std::string tension_cycles(int cycles) {
  std::vector<std::string> values;
  for (int i = 0; i < cycles; ++i) {
    values.insert(values.end(), {"10", "60"});
  }
  values.emplace_back("10");
  return rows("time_s,input_tension_N", values);
}

// T_a 25, T_m 35: T_eff = 25 / (1 - (35 / 177.4)^2) = 26.0125 N; 26.0125^1.38 / 1.53e5 = 5.8649e-4
constexpr double kCycleDamage = 5.86490e-4;

/// tension_cycles() for a wire of another strength, every tension in proportion.
std::string tension_cycles(int cycles, double times) {
  const std::string low = fmt::format("{:.17g}", 10 * times);
  const std::string high = fmt::format("{:.17g}", 60 * times);
  std::vector<std::string> values;
  for (int i = 0; i < cycles; ++i) {
    values.insert(values.end(), {low, high});
  }
  values.push_back(low);
  return rows("time_s,input_tension_N", values);
}

// A life is that of T_eff/T_u alone where A grows as T_u^gamma.
TEST(Replay, WiresOfOneNewtonAndOfOneMeganewton) {
  for (const double ultimate_N : {1.0, 1.0004, 1e6}) {
    Model model = paper_model();
    const double times = ultimate_N / 177.4;
    model.cable.ultimate_tension_N = ultimate_N;
    model.counting.hysteresis_N *= times;
    model.life.ipl_scale *= std::pow(times, 1.38);
    model.drive->torque_constant_Nm_per_A *= times;
    const ReplayResult result = replay_text(tension_cycles(20, times), model);
    EXPECT_NEAR(result.damage.total, 20 * kCycleDamage, 2e-7) << ultimate_N;
    EXPECT_NEAR(result.equivalent_effective_tension_N, 26.0125 * times, 1e-3 * times) << ultimate_N;
    EXPECT_LT(std::fabs(result.relative_error), 2e-6) << ultimate_N;
    EXPECT_TRUE(result.flags.empty()) << ultimate_N;
  }
}

TEST(Replay, TensionByHand) {
  const ReplayResult result = replay_text(tension_cycles(20), paper_model());
  EXPECT_EQ(result.samples, 41u);
  EXPECT_NEAR(result.duration_s, 4.0, 1e-12);
  EXPECT_EQ(result.cycles.closed, 19u);
  EXPECT_EQ(result.cycles.open_half, 2u);
  EXPECT_NEAR(result.damage.total, 20 * kCycleDamage, 2e-7);
  EXPECT_NEAR(result.damage.closed, 19 * kCycleDamage, 2e-7);
  EXPECT_NEAR(result.damage.open, kCycleDamage, 2e-8);
  EXPECT_NEAR(result.equivalent_effective_tension_N, 26.0125, 1e-3);
  // B10 of beta 5.94 is at D = 0.684648.
  EXPECT_NEAR(result.repeats_to.b10, 0.684648 / (20 * kCycleDamage), 1e-2);
  EXPECT_LT(std::fabs(result.relative_error), 2e-6);
  EXPECT_TRUE(result.flags.empty());
  EXPECT_TRUE(result.warnings.empty());
}

TEST(Replay, CurrentGivesTheSameDamageAsItsTension) {
  // 20.592 N/A: 10 N and 60 N
  std::vector<std::string> values;
  for (int i = 0; i < 20; ++i) {
    values.insert(values.end(), {"0.485625485625", "2.913752913753"});
  }
  values.emplace_back("0.485625485625");
  const ReplayResult result = replay_text(rows("time_s,motor_current_A", values), paper_model());
  EXPECT_EQ(result.input, InputKind::kMotorCurrent);
  EXPECT_NEAR(result.damage.total, 20 * kCycleDamage, 2e-7);
  EXPECT_LT(std::fabs(result.relative_error), 2e-6);
}

TEST(Replay, ConstantOutputTensionIsAmplifiedByTheSheath) {
  // 49 N over 270 deg: 89.569 N pulling, 26.806 N releasing, alpha 1124.78.
  std::vector<std::string> values;
  for (int i = 0; i < 20; ++i) {
    values.insert(values.end(), {"49,0.1", "49,0", "49,-0.1", "49,0"});
  }
  values.emplace_back("49,0.1");
  const ReplayResult result =
      replay_text(rows("time_s,output_tension_N,tendon_velocity_m_s", values), paper_model());
  EXPECT_EQ(result.cycles.closed, 19u);
  EXPECT_NEAR(20 / result.damage.total, 1124.78, 0.05);
  EXPECT_LT(std::fabs(result.relative_error), 2e-6);
}

TEST(Replay, BendAngleOfTheProfileReplacesThatOfTheModel) {
  std::vector<std::string> values;
  for (int i = 0; i < 20; ++i) {
    values.insert(values.end(), {"49,0.1,270", "49,-0.1,270"});
  }
  values.emplace_back("49,0.1,270");
  Model model = paper_model();
  model.sheath.bend_angle_deg = 90;
  const ReplayResult result = replay_text(
      rows("time_s,output_tension_N,tendon_velocity_m_s,bend_angle_deg", values), model);
  EXPECT_NEAR(20 / result.damage.total, 1124.78, 0.05);
}

TEST(Replay, NoBendAndNoChangeUseNothing) {
  Model model = paper_model();
  model.sheath.bend_angle_deg = 0;
  std::vector<std::string> values;
  for (int i = 0; i < 40; ++i) {
    values.emplace_back(i % 2 == 0 ? "49,0.1" : "49,-0.1");
  }
  const ReplayResult result =
      replay_text(rows("time_s,output_tension_N,tendon_velocity_m_s", values), model);
  EXPECT_EQ(result.damage.total, 0);
  EXPECT_EQ(result.reference_damage.total, 0);
  EXPECT_EQ(result.relative_error, 0);
  EXPECT_EQ(result.survival_probability, 1);
  EXPECT_TRUE(std::isinf(result.repeats_to.b10));
  EXPECT_TRUE(nlohmann::json::parse(replay_json(result))["repeats_to"]["B10"].is_null());
}

TEST(Replay, ACurrentProfileNeedsADrive) {
  Model model = paper_model();
  model.drive.reset();
  try {
    replay_text("time_s,motor_current_A\n0,1\n0.1,2\n", model);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("model.toml"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("[drive]"), std::string::npos) << error.what();
  }
}

TEST(Replay, FlagsAndGapsAreTold) {
  ReplayReport report;
  ReplayOptions options;
  options.report = &report;
  const ReplayResult result =
      replay_text("time_s,input_tension_N\n0,10\n0.1,60\n0.2,-5\n0.9,60\n1.0,180\n1.1,10\n1.2,60\n",
                  paper_model(), options);
  EXPECT_EQ(result.gaps, 1u);
  EXPECT_EQ(report.tension.gaps, std::vector<std::size_t>{3});
  EXPECT_TRUE(report.loop.time_s.empty()) << "no output tension";
  std::ostringstream summary;
  write_summary(summary, result, "profile.csv", "model.toml");
  EXPECT_NE(summary.str().find("\n  gaps          1, in which 6 samples are missing\n"),
            std::string::npos)
      << summary.str();
  EXPECT_EQ(result.flags, (std::vector<std::string>{"overload", "negative_tension", "gap"}));
  EXPECT_EQ(result.missing_samples, 6u);
  EXPECT_EQ(result.overloads, 1u);
  EXPECT_GT(result.damage.total, 1);
  EXPECT_LT(std::fabs(result.relative_error), 2e-6);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(Replay, ALoopIsOfTwoCyclesOfTheOutputTension) {
  std::vector<std::string> values;
  for (int i = 0; i < 5; ++i) {
    values.insert(values.end(), {"10,1", "20,1", "30,1", "20,-1"});
  }
  ReplayReport report;
  ReplayOptions options;
  options.report = &report;
  replay_text(rows("time_s,output_tension_N,tendon_velocity_m_s", values), paper_model(), options);
  EXPECT_EQ(report.loop.time_s.size(), 9u) << "4 samples a cycle, and the first of the next";
  EXPECT_EQ(report.loop.input_N.size(), 9u);
  // exp(0.128 * 1.5 pi) = 1.82793 times the output tension while pulling, over it letting go.
  const auto [low, high] = std::ranges::minmax(report.loop.input_N);
  EXPECT_NEAR(high, 30 * 1.82793, 1e-3);
  EXPECT_NEAR(low, 20 / 1.82793, 1e-3);
}

TEST(Replay, TensionHeldAtTheUltimateOneIsAnOverload) {
  const ReplayResult result =
      replay_text("time_s,input_tension_N\n0,180\n0.1,180\n0.2,180\n", paper_model());
  EXPECT_EQ(result.flags, std::vector<std::string>{"overload"});
  EXPECT_EQ(result.overloads, 1u);
  EXPECT_EQ(result.cycles.open_half, 1u);
  EXPECT_EQ(result.damage.total, 0.5);
  EXPECT_EQ(result.reference_damage.total, 0.5);
  EXPECT_NEAR(result.survival_probability, 0.98384, 1e-5);  // exp(-0.5^5.94)
}

TEST(Replay, AnotherSampleRateIsAWarning) {
  Model model = paper_model();
  model.counting.sample_rate_Hz = 1000;
  const ReplayResult result = replay_text(tension_cycles(5), model);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].find("10 Hz"), std::string::npos) << result.warnings[0];
  EXPECT_NEAR(result.damage.total, 5 * kCycleDamage, 1e-7);
}

TEST(Replay, JsonHasEveryField) {
  const auto json =
      nlohmann::json::parse(replay_json(replay_text(tension_cycles(3), paper_model())));
  EXPECT_EQ(json["samples"], 7);
  EXPECT_EQ(json["cycles"]["closed"], 2);
  EXPECT_EQ(json["cycles"]["open_half"], 2);
  for (const char* part : {"closed", "open", "total"}) {
    EXPECT_TRUE(json["damage"][part].is_number());
    EXPECT_TRUE(json["reference_damage"][part].is_number());
  }
  for (const char* point : {"B10", "B50", "mean", "B90"}) {
    EXPECT_TRUE(json["repeats_to"][point].is_number());
  }
  for (const char* field :
       {"duration_s", "relative_error", "equivalent_effective_tension_N", "survival_probability"}) {
    EXPECT_TRUE(json[field].is_number()) << field;
  }
  EXPECT_TRUE(json["flags"].is_array());
  EXPECT_EQ(json["model_digest"].get<std::string>().size(), 8u);
}

TEST(Replay, TheTrajectoryEndsWithTheResult) {
  std::ostringstream trajectory;
  ReplayOptions options;
  options.trajectory = &trajectory;
  options.trajectory_step_s = 0;
  const ReplayResult result = replay_text(tension_cycles(4), paper_model(), options);
  std::istringstream lines(trajectory.str());
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line,
            "time_s,input_tension_N,damage_closed,damage_open,damage_total,closed_cycles,"
            "open_half_cycles");
  double previous = -1;
  double total = 0;
  int count = 0;
  while (std::getline(lines, line)) {
    double time_s = 0;
    double tension_N = 0;
    double closed = 0;
    double open = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf", &time_s, &tension_N, &closed, &open,
                          &total),
              5);
    EXPECT_GE(total, previous);
    previous = total;
    ++count;
  }
  EXPECT_EQ(count, 9);
  EXPECT_EQ(total, result.damage.total);
}

TEST(Replay, TheLastSampleIsAlwaysInTheTrajectory) {
  std::ostringstream trajectory;
  ReplayOptions options;
  options.trajectory = &trajectory;
  options.trajectory_step_s = 100;
  replay_text(tension_cycles(4), paper_model(), options);
  const std::string text = trajectory.str();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_NE(text.find("\n0.8,"), std::string::npos);
}

TEST(Replay, ThePlotsHoldEveryCycleAndTheDamage) {
  ReplayReport report;
  ReplayOptions options;
  options.report = &report;
  const ReplayResult result = replay_text(tension_cycles(30), paper_model(), options);
  double cycles = 0;
  double damage = 0;
  for (std::size_t i = 0; i < report.range_mean.count.size(); ++i) {
    cycles += report.range_mean.count[i];
    damage += report.range_mean.damage[i];
  }
  EXPECT_DOUBLE_EQ(cycles, 30);
  EXPECT_NEAR(damage, result.damage.total, 1e-12);
  EXPECT_EQ(report.turning_points.total, 61u);
  EXPECT_EQ(report.trajectory.damage.back(), result.damage.total);
  EXPECT_NEAR(report.turning_points.points[1].time_s, 0.1, 1e-12);
  EXPECT_NEAR(report.turning_points.points[1].tension_N, 60, 1e-6);
}

TEST(SampleClock, FindsWhatIsMissing) {
  SampleClock clock(0.01);
  EXPECT_EQ(clock.missing_before(5.00), 0u);
  EXPECT_EQ(clock.missing_before(5.01), 0u);
  EXPECT_EQ(clock.missing_before(5.0249), 0u) << "jitter of half a period is no gap";
  EXPECT_EQ(clock.missing_before(5.0449), 1u);
  EXPECT_EQ(clock.missing_before(5.1449), 9u);
  EXPECT_EQ(clock.missing_before(5.1549), 0u);
  EXPECT_EQ(clock.samples(), 6u);
  EXPECT_NEAR(clock.duration_s(), 0.1549, 1e-12);
  EXPECT_FALSE(clock.other_rate());
}

TEST(SampleClock, KnowsAnotherRateFromGaps) {
  SampleClock clock(0.001);
  for (int i = 0; i < 100; ++i) {
    clock.missing_before(0.01 * i);
  }
  EXPECT_TRUE(clock.other_rate());
  EXPECT_NEAR(clock.rate_Hz(), 100, 1e-9);
}

TEST(SampleClock, AHugeGapDoesNotOverflow) {
  SampleClock clock(1e-5);
  clock.missing_before(0);
  EXPECT_EQ(clock.missing_before(1e9), 4'000'000'000u);
}

// Half of 1.25 .. 1.5 and of log2 of 500 .. 2000.
TEST(ReplayConstants, ABoardKnowsHowSureTheFitIs) {
  Model model = paper_model();
  EXPECT_FALSE(parameters_of(model, "m.toml").uncertainty.known());
  model.life.interval = Model::Life::Interval{.level = 0.95,
                                              .ipl_scale = {9e4, 2.6e5},
                                              .ipl_exponent = {1.25, 1.5},
                                              .weibull_shape = {4.9, 7.1},
                                              .pivot_tension_N = 50,
                                              .life_at_pivot = {500, 2000}};
  const auto uncertainty = parameters_of(model, "m.toml").uncertainty;
  EXPECT_TRUE(uncertainty.known());
  EXPECT_EQ(std::ldexp(uncertainty.exponent, -27), 0.125);
  EXPECT_EQ(std::ldexp(uncertainty.log2_life, -21), 1);
  model.life.interval->level = 0.9;
  EXPECT_THROW(static_cast<void>(parameters_of(model, "m.toml")), InputError);
}

}  // namespace

}  // namespace host_sim
