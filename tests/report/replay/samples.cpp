#include "tests/report/replay/samples.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <span>

#include "host_sim/replay/given_survival.hpp"
#include "host_sim/report/replay/plot_builders.hpp"

namespace host_sim::samples {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kUltimateTension_N = 177.4;
constexpr double kScale = 1.53e5;
constexpr double kExponent = 1.38;
constexpr double kShape = 5.94;
constexpr double kHysteresis_N = 0.2;

/// Damage of one cycle by eqs. (11) and (19) of the paper.
double cycle_damage(double from_N, double to_N) {
  const double amplitude_N = std::abs(to_N - from_N) / 2;
  const double mean_ratio = (from_N + to_N) / 2 / kUltimateTension_N;
  return std::pow(amplitude_N / (1 - mean_ratio * mean_ratio), kExponent) / kScale;
}

/// Counts a signal the plain way, for pages only: four-point rainflow, residue as half cycles.
class Recorder {
 public:
  void push(double time_s, double tension_N) {
    tension_.push(time_s, tension_N);
    ++samples_;
    end_s_ = time_s;
    const double move_N = tension_N - extreme_.tension_N;
    if (samples_ == 1 || move_N * direction_ > 0) {
      extreme_ = {time_s, tension_N};
    } else if (std::abs(move_N) > kHysteresis_N) {
      turn(extreme_);
      direction_ = move_N > 0 ? 1 : -1;
      extreme_ = {time_s, tension_N};
    }
  }

  [[nodiscard]] ReplayReport finish() {
    turn(extreme_);
    ReplayReport report;
    for (std::size_t i = 1; i < residue_.size(); ++i) {
      const double damage = cycle_damage(residue_[i - 1], residue_[i]) / 2;
      range_mean_.push(residue_[i - 1], residue_[i], 0.5, damage);
      report.damage.open += damage;
      ++report.cycles.open_half;
    }
    report.samples = samples_;
    report.duration_s = end_s_;
    report.cycles.closed = closed_;
    report.damage.closed = damage_;
    report.damage.total = damage_ + report.damage.open;
    report.tension = tension_.finish();
    report.turning_points = turning_points_.finish();
    report.range_mean = range_mean_.finish();
    trajectory_.push(end_s_, report.damage.total);
    report.trajectory = trajectory_.finish();
    return report;
  }

 private:
  void turn(const TurningPoint& point) {
    turning_points_.push(point.time_s, point.tension_N);
    residue_.push_back(point.tension_N);
    while (residue_.size() >= 4 && inner_range_closes()) {
      const auto last = residue_.end();
      const double damage = cycle_damage(last[-3], last[-2]);
      range_mean_.push(last[-3], last[-2], 1, damage);
      damage_ += damage;
      ++closed_;
      residue_.erase(last - 3, last - 1);
    }
    double open = 0;
    for (std::size_t i = 1; i < residue_.size(); ++i) {
      open += cycle_damage(residue_[i - 1], residue_[i]) / 2;
    }
    trajectory_.push(point.time_s, damage_ + open);
  }

  [[nodiscard]] bool inner_range_closes() const {
    const auto last = residue_.end();
    const double inner = std::abs(last[-2] - last[-3]);
    return inner <= std::abs(last[-3] - last[-4]) && inner <= std::abs(last[-1] - last[-2]);
  }

  EnvelopeBuilder tension_;
  TurningPointBuilder turning_points_;
  RangeMeanBuilder range_mean_{kUltimateTension_N / 1024};
  TrajectoryBuilder trajectory_;
  std::vector<double> residue_;
  TurningPoint extreme_;
  double direction_ = 1;
  double damage_ = 0;
  double end_s_ = 0;
  std::uint64_t closed_ = 0;
  std::uint64_t samples_ = 0;
};

void add_model(ReplayReport& report) {
  report.input_kind = "output tension and tendon velocity";
  report.model_name = "upper_arm.toml";
  report.model_digest = "5f3a90c1";
  report.program_version = "0.1.0";
  report.weibull_shape = kShape;
  report.ultimate_tension_N = kUltimateTension_N;
  report.hysteresis_N = kHysteresis_N;
  report.model_constants = {{"ultimate tension", kUltimateTension_N, "N"},
                            {"friction coefficient", 0.128, ""},
                            {"bend angle", 270, "deg"},
                            {"hysteresis", kHysteresis_N, "N"},
                            {"scale A of the inverse power law", kScale, ""},
                            {"exponent gamma of the inverse power law", kExponent, ""},
                            {"Weibull shape beta", kShape, ""}};
}

void add_life(ReplayReport& report) {
  const double damage = report.damage.total;
  const auto repeats = [damage](double broken) {
    return std::pow(-std::log1p(-broken), 1 / kShape) / damage;
  };
  report.reference_damage = report.damage;
  report.reference_damage.total *= 1 + 3.1e-6;
  report.relative_error = damage / report.reference_damage.total - 1;
  report.survival_probability = std::exp(-std::pow(damage, kShape));
  report.repeats_to = {repeats(0.1), repeats(0.5), std::tgamma(1 + 1 / kShape) / damage,
                       repeats(0.9)};
  const double cycles =
      static_cast<double>(report.cycles.closed) + static_cast<double>(report.cycles.open_half) / 2;
  report.equivalent_effective_tension_N = std::pow(kScale * damage / cycles, 1 / kExponent);
}

void add_survivor(ReplayReport& report, double used, const std::string& horizon,
                  bool with_interval) {
  Model::Life life{.mean_stress = Model::MeanStress::kGerber,
                   .ipl_scale = kScale,
                   .ipl_exponent = kExponent,
                   .weibull_shape = kShape};
  if (with_interval) {
    life.interval = Model::Life::Interval{.level = 0.95,
                                          .ipl_scale = {1.1e5, 2.1e5},
                                          .ipl_exponent = {1.30, 1.46},
                                          .weibull_shape = {4.9, 7.1},
                                          .pivot_tension_N = 52,
                                          .life_at_pivot = {620, 690}};
  }
  report.given_survival =
      given_survival({.used = used, .horizon = horizon_from(horizon)}, report.damage.total,
                     report.duration_s, report.equivalent_effective_tension_N, life);
  report.break_curve =
      break_curve(used, report.damage.total, report.equivalent_effective_tension_N, life);
}

/// A crank motion of 3 s between 14 and 55 N with tremor and noise; every stroke differs a little.
ReplayReport motion(double duration_s, double rate_Hz) {
  constexpr double kPeriod_s = 3;
  constexpr double kTremor_Hz = 2.3;
  std::minstd_rand random(20);
  const auto noise = [&random] {
    return 2 * static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max()) - 1;
  };
  Recorder recorder;
  double stroke_N = 20.5;
  const auto samples = static_cast<std::uint64_t>(duration_s * rate_Hz) + 1;
  const auto samples_a_stroke = static_cast<std::uint64_t>(kPeriod_s * rate_Hz);
  for (std::uint64_t i = 0; i < samples; ++i) {
    const double time_s = static_cast<double>(i) / rate_Hz;
    if (i % samples_a_stroke == 0) {
      stroke_N = 20 + 2 * noise();
    }
    const double phase = 2 * std::numbers::pi * time_s;
    const double tremor_N = 0.8 * std::sin(kTremor_Hz * phase) * (1 + noise() / 4);
    recorder.push(time_s, 34.5 - stroke_N * std::cos(phase / kPeriod_s) + tremor_N + noise() / 10);
  }
  ReplayReport report = recorder.finish();
  report.profile_name = "upper_arm.csv";
  add_model(report);
  add_life(report);
  return report;
}

ReplayReport of_samples(std::span<const double> tensions_N) {
  Recorder recorder;
  for (std::size_t i = 0; i < tensions_N.size(); ++i) {
    recorder.push(static_cast<double>(i), tensions_N[i]);
  }
  ReplayReport report = recorder.finish();
  report.profile_name = "a few samples";
  add_model(report);
  return report;
}

/// Constant tension: no cycle, no damage, and a life that no number of repeats ends.
ReplayReport without_damage(std::vector<double> tensions_N) {
  ReplayReport report = of_samples(tensions_N);
  report.repeats_to = {kInfinity, kInfinity, kInfinity, kInfinity};
  report.equivalent_effective_tension_N = kNotANumber;
  report.cycles = {};
  report.range_mean = {};
  add_survivor(report, 0.4, "8h", true);
  return report;
}

ReplayReport overload() {
  ReplayReport report = motion(12, 200);
  report.profile_name = "overload.csv";
  report.damage.closed += 1;
  report.damage.total += 1;
  report.trajectory.damage.back() += 1;
  report.flags = {"saturated", "overload", "negative_tension",
                  "gap",       "overrun",  "residue_overflow"};
  report.warnings = {"the profile was recorded at about 100 Hz, the model says 200 Hz"};
  add_life(report);
  return report;
}

/// A profile that wears so little, or so long, that every axis needs a power of ten.
ReplayReport huge() {
  ReplayReport report = motion(60, 50);
  report.profile_name = "decades.csv";
  report.duration_s *= 1e12;
  report.samples = std::numeric_limits<std::uint64_t>::max();
  report.cycles.closed = 4'000'000'000'000;
  for (double* damage : {&report.damage.closed, &report.damage.open, &report.damage.total}) {
    *damage *= 1e-40;
  }
  for (double& time_s : report.tension.time_s) {
    time_s *= 1e12;
  }
  for (TurningPoint& point : report.turning_points.points) {
    point.time_s *= 1e12;
  }
  for (double& time_s : report.trajectory.time_s) {
    time_s *= 1e12;
  }
  for (double& damage : report.trajectory.damage) {
    damage *= 1e-40;
  }
  for (double& damage : report.range_mean.damage) {
    damage *= 1e-40;
  }
  add_life(report);
  add_survivor(report, 0.4, "1e35", true);
  return report;
}

}  // namespace

ReplayReport typical() {
  return motion(60, 200);
}

ReplayReport survivor(double damage, const std::string& horizon, bool with_interval) {
  ReplayReport report = typical();
  report.profile_name = "whole_now.csv";
  report.peak_ratio = 0.3125;
  report.above = {12, 1, 0};
  report.minimum_tension_N = 0.4;
  report.below_minimum_s = 1.5;
  report.motion = true;
  report.slack_events = 1;
  report.found = {"Loose at 12.5 s, line 2502 of the profile."};
  add_survivor(report, damage, horizon, with_interval);
  return report;
}

ReplayReport hostile() {
  ReplayReport report = motion(15, 50);
  add_survivor(report, 0.4, "1h", true);
  report.given_survival->risk->horizon = "</ul><script>throw 4</script>";
  report.found = {"<style>*{display:none}</style>"};
  report.profile_name =
      "</script><script>throw 1</script>\"'&amp;{{title}} \u00dcberlast \u8155 \xff";
  report.model_name = "--><img src=x onerror=\"throw 2\">";
  report.model_digest = "<b>0</b>";
  report.program_version = "\x01]]>";
  report.input_kind = "<!--<script>";
  report.flags = {"</li></ul><plaintext>"};
  report.warnings = {"<style>*{display:none}</style>"};
  report.model_constants.push_back({"</table><td onclick='throw 3'>", 1, "</td>"});
  return report;
}

std::vector<Sample> all() {
  std::vector<Sample> samples;
  samples.push_back({"typical", 4, typical()});
  samples.push_back({"survivor", 5, survivor(0.4, "0.5h", true)});
  samples.push_back({"survivor_without_fit", 5, survivor(0.684648495, "9", false)});
  samples.push_back({"survivor_worn", 5, survivor(1.5, "2h", true)});
  samples.push_back({"survivor_new", 5, survivor(0, "0.5h", true)});
  samples.push_back({"two_hours", 4, motion(7200, 200)});
  samples.push_back({"overload", 4, overload()});
  samples.push_back({"huge", 5, huge()});
  samples.push_back({"hostile", 5, hostile()});
  samples.push_back({"constant", 2, without_damage({20, 20, 20, 20})});
  samples.push_back({"one_sample", 2, without_damage({20})});
  samples.push_back({"nothing", 0, ReplayReport{}});
  return samples;
}

}  // namespace host_sim::samples
