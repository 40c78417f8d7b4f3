#include "tests/diagnose/tension/noisy_sessions.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace host_sim::diagnose::testing {

double normal(statistics::Random& random) {
  const double radius = std::sqrt(-2 * std::log(random.uniform()));
  return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

std::vector<Session> noisy_sessions(const std::vector<Run>& runs, const Disturbances& disturbances,
                                    std::uint64_t seed) {
  std::vector<Session> sessions = sessions_of(runs);
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    recording::Covariates& c = sessions[s].covariates;
    statistics::Random random(seed, 0, s);
    const double gain = disturbances.session_gain_sd * normal(random);
    const double friction = disturbances.session_friction_sd * normal(random);
    double noise = disturbances.sample_sd * normal(random);
    for (std::size_t i = 0; i < c.samples(); ++i) {
      const double effect = disturbances.effect ? disturbances.effect(c, i) : 0;
      c.output_tension_N[i] *=
          std::exp(gain - friction * c.bend_angle_rad[i] * c.direction[i] + noise + effect);
      noise = disturbances.ar1 * noise + std::sqrt(1 - disturbances.ar1 * disturbances.ar1) *
                                             disturbances.sample_sd * normal(random);
    }
  }
  return sessions;
}

std::function<double(const recording::Covariates& covariates, std::size_t i)> preload(
    double force_N) {
  return [force_N](const recording::Covariates& c, std::size_t i) {
    return std::log(1 - force_N * c.direction[i] / c.current_tension_N[i]);
  };
}

std::vector<Run> small_design() {
  std::vector<Run> runs;
  for (const double bend_angle_rad : {1.5, 6.0}) {
    for (const double mean_N : {15.0, 30.0, 60.0}) {
      for (const double frequency_Hz : {0.5, 1.0}) {
        const double order = static_cast<double>(runs.size());
        runs.push_back({.bend_angle_rad = bend_angle_rad,
                        .frequency_Hz = frequency_Hz,
                        .mean_N = mean_N,
                        .sheath_C = 20 + std::fmod(17 * order, 30),
                        .winding_C = 25 + std::fmod(35 * order, 60),
                        .start_cycle = std::fmod(500 * order, 1300),
                        .duration_s = 4});
      }
    }
  }
  return runs;
}

Evidence evidence_of(const std::vector<Session>& sessions, double sample_sd) {
  Evidence evidence;
  evidence.sessions = sessions;
  evidence.options.wanted.clear();
  evidence.options.baseline = baseline();
  evidence.options.baseline.poses_rad = poses_of(sessions);
  evidence.sample_sd = sample_sd;
  return evidence;
}

Component component(std::string_view id, std::vector<double> shape) {
  for (const auto& effect : effects::tension_effects()) {
    if (effect->id() == id) {
      return {effect.get(), std::move(shape)};
    }
  }
  throw std::out_of_range("no such effect");
}

}  // namespace host_sim::diagnose::testing
