#include "tests/blind/oracle/visibility.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "host_sim/synth/campaign/lives.hpp"
#include "host_sim/synth/campaign/sessions.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace blind {
namespace {

/// Rows of samples whose noise is independent and of standard deviation 1: what a Kalman filter of
/// the sources fails to predict. A column of zeros stays.
Eigen::MatrixX3d whitened(const Eigen::MatrixX3d& columns, const std::vector<NoiseSource>& noise) {
  const auto sources = static_cast<Eigen::Index>(noise.size());
  Eigen::VectorXd ar1(sources), sd(sources);
  for (Eigen::Index k = 0; k < sources; ++k) {
    ar1(k) = noise[static_cast<std::size_t>(k)].ar1;
  }
  const Eigen::VectorXd innovations = 1 - ar1.array().square();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(sources, sources);
  Eigen::MatrixX3d states = Eigen::MatrixX3d::Zero(sources, 3);
  Eigen::MatrixX3d white(columns.rows(), 3);
  for (Eigen::Index i = 0; i < columns.rows(); ++i) {
    for (Eigen::Index k = 0; k < sources; ++k) {
      sd(k) = noise[static_cast<std::size_t>(k)].sd[static_cast<std::size_t>(i)];
    }
    const Eigen::VectorXd with_row = covariance * sd;
    const double variance = sd.dot(with_row);
    const Eigen::RowVector3d error = columns.row(i) - sd.transpose() * states;
    white.row(i) = error / std::sqrt(variance);
    states = ar1.asDiagonal() * (states + with_row * error / variance).eval();
    covariance -= with_row * with_row.transpose() / variance;
    covariance = (ar1.asDiagonal() * covariance * ar1.asDiagonal()).eval();
    covariance.diagonal() += innovations;
  }
  return white;
}

using host_sim::synth::LifeSpecimen;
using host_sim::synth::SynthPlan;

double log_cycles(const LifeSpecimen& specimen) {
  const auto& cycles = specimen.result.cycles;
  return std::log(std::accumulate(cycles.begin(), cycles.end(), 0.0));
}

Eigen::VectorXd log_cycles_of(const std::vector<LifeSpecimen>& specimens) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(specimens.size()));
  for (std::size_t i = 0; i < specimens.size(); ++i) {
    all(static_cast<Eigen::Index>(i)) = log_cycles(specimens[i]);
  }
  return all;
}

/// How ln N of each specimen answers to ln A and to gamma, those in blocks as well.
Eigen::MatrixX2d answers_to_law(const SynthPlan& plan, std::uint64_t seed,
                                const Eigen::VectorXd& base) {
  constexpr double kStep = 0.1;
  SynthPlan scaled = plan;
  scaled.model.life->ipl_scale *= std::exp(kStep);
  SynthPlan steeper = plan;
  steeper.model.life->ipl_exponent += kStep;
  Eigen::MatrixX2d law(base.size(), 2);
  law << (log_cycles_of(run_lives(scaled, seed)) - base) / kStep,
      (log_cycles_of(run_lives(steeper, seed)) - base) / kStep;
  return law;
}

/// What is left of ln N once A and gamma are refitted by least squares (Gauss and Newton): blocks
/// answer to a large change otherwise than to a small one.
Eigen::VectorXd left_by_law(SynthPlan plan, std::uint64_t seed, const Eigen::VectorXd& wanted) {
  constexpr int kSteps = 10;
  Eigen::VectorXd least = wanted - log_cycles_of(run_lives(plan, seed));
  Eigen::VectorXd left = least;
  for (int step = 0; step < kSteps; ++step) {
    const Eigen::MatrixX2d law = answers_to_law(plan, seed, wanted - left);
    const Eigen::Vector2d change = law.colPivHouseholderQr().solve(left);
    plan.model.life->ipl_scale *= std::exp(change(0));
    plan.model.life->ipl_exponent += change(1);
    left = wanted - log_cycles_of(run_lives(plan, seed));
    if (left.norm() < least.norm()) {
      least = left;
    }
  }
  return least;
}

using host_sim::synth::Channels;
using host_sim::synth::Setting;
using host_sim::synth::SynthPlan;

SynthPlan silent(const Scenario& scenario) {
  SynthPlan plan = host_sim::synth::parse_synth_plan(scenario.plan, "blind plan");
  plan.noise = {};
  plan.scatter = {};
  return plan;
}

SynthPlan without(SynthPlan plan, const std::string& id) {
  std::erase_if(plan.departures, [&](const auto& hidden) { return hidden.id == id; });
  return plan;
}

std::vector<double> difference(std::vector<double> one, const std::vector<double>& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    one[i] -= other[i];
  }
  return one;
}

using host_sim::synth::Channels;
using host_sim::synth::Setting;
using host_sim::synth::SynthPlan;

struct Samples {
  std::vector<double> log_ratio, signed_bend_rad, output_N;
};

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Samples samples_of(const SynthPlan& plan, const Scenario& scenario) {
  Samples samples;
  for (const Setting& setting : host_sim::synth::settings_of(*plan.recordings, scenario.seed)) {
    const Channels channels = session_channels(
        plan, setting, session_scatter(plan, scenario.seed, setting.number), scenario.seed);
    append(samples.log_ratio, log_ratio(channels, scenario.input));
    append(samples.signed_bend_rad, signed_bend_rad(channels));
    append(samples.output_N, channels[hal::files::kOutputTensionColumn]);
  }
  return samples;
}

/// log_ratio = gain - mu phi s by least squares; what is left of the output tension.
double rmse_N(const Samples& samples) {
  const auto count = static_cast<double>(samples.log_ratio.size());
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t i = 0; i < samples.log_ratio.size(); ++i) {
    const double x = samples.signed_bend_rad[i];
    const double y = samples.log_ratio[i];
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  const double slope = (sum_xy - sum_x * sum_y / count) / (sum_xx - sum_x * sum_x / count);
  const double gain = (sum_y - slope * sum_x) / count;
  double squares = 0;
  for (std::size_t i = 0; i < samples.log_ratio.size(); ++i) {
    const double left = samples.log_ratio[i] - gain - slope * samples.signed_bend_rad[i];
    const double error_N = samples.output_N[i] * (1 - std::exp(-left));
    squares += error_N * error_N;
  }
  return std::sqrt(squares / count);
}

}  // namespace

using host_sim::synth::Channels;

namespace {

using host_sim::synth::EndNoise;

constexpr double kLeastReading = 1e-6;

const std::vector<double>& at_drive(const Channels& channels, Input input) {
  return channels[input == Input::load_cell ? hal::files::kInputTensionColumn
                                            : hal::files::kMotorCurrentColumn];
}

/// |dy/dt| by differences of neighbours.
std::vector<double> slopes_1_s(const std::vector<double>& readings,
                               const std::vector<double>& time_s) {
  std::vector<double> slopes(readings.size());
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, slopes.size() - 1);
    slopes[i] = std::abs(readings[after] - readings[before]) / (time_s[after] - time_s[before]);
  }
  return slopes;
}

/// The sources of one end whose sd is not 0 throughout.
/// @param weight of the reading of each sample in what is disturbed
void add_sources(const EndNoise& end, double absolute_sd, double jitter_s,
                 const std::vector<double>& readings, const std::vector<double>& time_s,
                 const std::vector<double>& weight, std::vector<NoiseSource>& sources) {
  const auto add = [&](std::vector<double> sd, double factor, double ar1) {
    if (factor > 0) {
      for (std::size_t i = 0; i < sd.size(); ++i) {
        sd[i] = factor * std::abs(sd[i]) * weight[i];
      }
      sources.push_back({std::move(sd), ar1});
    }
  };
  add(readings, end.relative_sd, end.ar1);
  add(std::vector<double>(readings.size(), 1), absolute_sd, end.ar1);
  add(slopes_1_s(readings, time_s), jitter_s, 0);
}

double absolute_sd_of(const EndNoise& input_end, Input input) {
  return input == Input::load_cell ? input_end.absolute_N : input_end.absolute_A;
}

std::vector<double> over(std::vector<double> readings) {
  for (double& value : readings) {
    value = 1 / std::max(kLeastReading, value);
  }
  return readings;
}

}  // namespace

std::vector<NoiseSource> noise_sources(const host_sim::synth::Noise& noise,
                                       const Channels& channels, Input input) {
  const auto& time_s = channels[hal::files::kTime];
  const auto& output = channels[hal::files::kOutputTensionColumn];
  const auto& input_end = at_drive(channels, input);
  std::vector<NoiseSource> sources;
  add_sources(noise.output, noise.output.absolute_N, noise.jitter_s, output, time_s, over(output),
              sources);
  add_sources(noise.input, absolute_sd_of(noise.input, input), noise.jitter_s, input_end, time_s,
              over(input_end), sources);
  return sources;
}

namespace {

/// Newtons, or amperes, at the drive for each newton at the load, by least squares.
double slope_of(const std::vector<double>& input_end, const std::vector<double>& output) {
  return std::inner_product(input_end.begin(), input_end.end(), output.begin(), 0.0) /
         std::inner_product(output.begin(), output.end(), output.begin(), 0.0);
}

constexpr double kMoreFriction = 0.01;

/// The sessions of one setting with the effect, without it, and without it with more friction.
struct Sessions {
  Channels with, base, more;
};

/// In logarithms a gain moves all samples alike.
Information log_information(const Sessions& sessions, Disturbance disturbance,
                            const host_sim::synth::Noise& noise, Input input) {
  const std::vector<double> base = log_ratio(sessions.base, input);
  const std::vector<double> trace = difference(log_ratio(sessions.with, input), base);
  const std::vector<double> by_friction = difference(log_ratio(sessions.more, input), base);
  Eigen::MatrixX3d columns(static_cast<Eigen::Index>(trace.size()), 3);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    columns.row(static_cast<Eigen::Index>(i)) << trace[i], 1, by_friction[i] / kMoreFriction;
  }
  disturbance.noise = noise_sources(noise, sessions.base, input);
  return session_information(columns, disturbance);
}

/// Of signed forces there is no logarithm: the trace is what the effect does to the force at the
/// drive beyond what it does to that at the load.
Information signed_information(const Sessions& sessions, Disturbance disturbance,
                               const host_sim::synth::Noise& noise, Input input) {
  const auto& output = sessions.base[hal::files::kOutputTensionColumn];
  const auto& input_end = at_drive(sessions.base, input);
  const double slope = slope_of(input_end, output);
  Eigen::MatrixX3d columns(static_cast<Eigen::Index>(output.size()), 3);
  for (std::size_t i = 0; i < output.size(); ++i) {
    const double moved = at_drive(sessions.with, input)[i] - input_end[i];
    const double moved_output_N = sessions.with[hal::files::kOutputTensionColumn][i] - output[i];
    const double by_friction = at_drive(sessions.more, input)[i] - input_end[i];
    columns.row(static_cast<Eigen::Index>(i)) << moved - slope * moved_output_N, input_end[i],
        by_friction / kMoreFriction;
  }
  const auto& time_s = sessions.base[hal::files::kTime];
  add_sources(noise.output, noise.output.absolute_N, noise.jitter_s, output, time_s,
              std::vector<double>(output.size(), std::abs(slope)), disturbance.noise);
  add_sources(noise.input, absolute_sd_of(noise.input, input), noise.jitter_s, input_end, time_s,
              std::vector<double>(output.size(), 1), disturbance.noise);
  return session_information(columns, disturbance);
}

double visibility(const Scenario& scenario, const std::string& id) {
  const SynthPlan noisy = host_sim::synth::parse_synth_plan(scenario.plan, "blind plan");
  const SynthPlan all = silent(scenario);
  const SynthPlan fewer = without(all, id);
  SynthPlan rougher = fewer;
  rougher.model.sheath->friction_coefficient += kMoreFriction;
  const Disturbance scatter{{}, noisy.scatter.log_gain_sd, noisy.scatter.friction_sd};
  const auto information_of =
      scenario.design == Design::two_sided ? signed_information : log_information;
  Information information = Information::Zero();
  for (const Setting& setting : host_sim::synth::settings_of(*all.recordings, scenario.seed)) {
    const auto session = [&](const SynthPlan& plan) {
      return session_channels(plan, setting, {}, scenario.seed);
    };
    information += information_of({session(all), session(fewer), session(rougher)}, scatter,
                                  noisy.noise, scenario.input);
  }
  return sigmas_of(information);
}

}  // namespace

std::vector<double> log_ratio(const Channels& channels, Input input) {
  const auto& input_end = at_drive(channels, input);
  const auto& output = channels[hal::files::kOutputTensionColumn];
  std::vector<double> result(output.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] =
        std::log(std::max(kLeastReading, output[i]) / std::max(kLeastReading, input_end[i]));
  }
  return result;
}

std::vector<double> signed_bend_rad(const Channels& channels) {
  const auto& velocity = channels[hal::files::kTendonVelocity];
  const auto& bend_deg = channels[hal::files::kBendAngle];
  std::vector<double> result(velocity.size());
  double direction = 1;
  for (std::size_t i = 0; i < result.size(); ++i) {
    direction = velocity[i] > 0 ? 1 : velocity[i] < 0 ? -1 : direction;
    result[i] = direction * bend_deg[i] * std::numbers::pi / 180;
  }
  return result;
}

Information session_information(const Eigen::MatrixX3d& columns, const Disturbance& disturbance) {
  const Eigen::MatrixX3d white = whitened(columns, disturbance.noise);
  const Information without_scatter = white.transpose() * white;
  // Woodbury: the scatter is that of the coefficients in the last two columns.
  const Eigen::Vector2d variances(disturbance.gain_sd * disturbance.gain_sd,
                                  disturbance.friction_sd * disturbance.friction_sd);
  const Eigen::Matrix<double, 3, 2> cross = without_scatter.rightCols<2>();
  const Eigen::Matrix2d inner =
      Eigen::Matrix2d::Identity() +
      Eigen::Matrix2d(variances.asDiagonal()) * without_scatter.bottomRightCorner<2, 2>();
  return without_scatter -
         cross * inner.inverse() * Eigen::Matrix2d(variances.asDiagonal()) * cross.transpose();
}

double sigmas_of(const Information& information) {
  const Eigen::Matrix2d nuisance = information.bottomRightCorner<2, 2>();
  const Eigen::Vector2d cross = information.block<2, 1>(1, 0);
  const double left = information(0, 0) - cross.dot(nuisance.inverse() * cross);
  return std::sqrt(std::max(0.0, left));
}

double life_visibility(const Scenario& scenario, const std::string& id) {
  const SynthPlan all = host_sim::synth::parse_synth_plan(scenario.plan, "blind plan");
  SynthPlan fewer = all;
  std::erase_if(fewer.departures, [&](const auto& departure) { return departure.id == id; });
  const Eigen::VectorXd with = log_cycles_of(run_lives(all, scenario.seed));
  const Eigen::VectorXd left = left_by_law(std::move(fewer), scenario.seed, with);
  const double sd = std::numbers::pi / (std::sqrt(6.0) * all.model.life->weibull_shape);
  return left.norm() / sd;
}

Scenario draw_visible_lives(std::uint64_t seed) {
  constexpr double kBarely = 3;
  constexpr std::uint64_t kAttempts = 200;
  for (std::uint64_t attempt = 0;; ++attempt) {
    Scenario scenario = draw_lives(seed, attempt);
    const bool visible = std::all_of(scenario.hidden.begin(), scenario.hidden.end(),
                                     [&](const HiddenEffect& effect) {
                                       return life_visibility(scenario, effect.id) >= kBarely;
                                     });
    if (visible || attempt + 1 == kAttempts) {
      return scenario;
    }
  }
}

std::vector<double> visibility_of(const Scenario& scenario) {
  std::vector<double> result;
  for (const HiddenEffect& effect : scenario.hidden) {
    result.push_back(scenario.data == Data::lives ? life_visibility(scenario, effect.id)
                                                  : visibility(scenario, effect.id));
  }
  return result;
}

double rmse_floor_N(const Scenario& scenario) {
  if (scenario.data == Data::lives || scenario.design == Design::two_sided) {
    return 0;
  }
  SynthPlan nothing = host_sim::synth::parse_synth_plan(scenario.plan, "blind plan");
  nothing.departures.clear();
  return rmse_N(samples_of(nothing, scenario));
}

double relative_gain(double before, double after, double floor) {
  return (before - after) / (before - floor);
}

}  // namespace blind
