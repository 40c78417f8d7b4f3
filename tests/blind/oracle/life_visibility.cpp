#include "tests/blind/oracle/life_visibility.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "host_sim/synth/campaign/lives.hpp"
#include "host_sim/synth/plan/plan.hpp"

namespace blind {
namespace {

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
  scaled.life->ipl_scale *= std::exp(kStep);
  SynthPlan steeper = plan;
  steeper.life->ipl_exponent += kStep;
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
    plan.life->ipl_scale *= std::exp(change(0));
    plan.life->ipl_exponent += change(1);
    left = wanted - log_cycles_of(run_lives(plan, seed));
    if (left.norm() < least.norm()) {
      least = left;
    }
  }
  return least;
}

}  // namespace

double life_visibility(const Scenario& scenario, const std::string& id) {
  const SynthPlan all = host_sim::synth::parse_synth_plan(scenario.plan, "blind plan");
  SynthPlan fewer = all;
  std::erase_if(fewer.hidden, [&](const auto& hidden) { return hidden.id == id; });
  const Eigen::VectorXd with = log_cycles_of(run_lives(all, scenario.seed));
  const Eigen::VectorXd left = left_by_law(std::move(fewer), scenario.seed, with);
  const double sd = std::numbers::pi / (std::sqrt(6.0) * all.life->weibull_shape);
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

}  // namespace blind
