#include "host_sim/diagnose/lives/likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host_sim/diagnose/lives/quadrature.hpp"
#include "host_sim/diagnose/lives/specimen_life.hpp"

namespace host_sim::diagnose::lives {
namespace {

using Members = std::vector<const SpecimenLife*>;

/// A normal density near that of a shared draw, given the lives.
struct Near {
  double mode = 0;
  double sd = 1;
};

/// As if all were Weibull in their damage, which has a mode by Newton's steps.
Near near_of(const Members& members, double log_sd) {
  double at = 0;
  double curvature = 0;
  constexpr int kSteps = 30;
  for (int step = 0; step < kSteps; ++step) {
    double slope = -at / (log_sd * log_sd);
    curvature = 1 / (log_sd * log_sd);
    for (const SpecimenLife* life : members) {
      const double power = std::exp(std::min(life->shape() * (life->ln_damage() - at), 50.0));
      slope += life->shape() * (power - (life->failed() ? 1 : 0));
      curvature += life->shape() * life->shape() * power;
    }
    const double move = std::clamp(slope / curvature, -0.5, 0.5);
    at += move;
    if (std::abs(move) < 1e-10) {
      break;
    }
  }
  return {.mode = at, .sd = 1 / std::sqrt(curvature)};
}

double log_shared(const Members& members, double log_sd) {
  const Near near = near_of(members, log_sd);
  double sum = -std::numeric_limits<double>::infinity();
  for (const NormalNode& node : gauss_hermite_nodes()) {
    const double shift = near.mode + near.sd * node.at;
    double value = node.ln_weight + node.at * node.at / 2 + std::log(near.sd / log_sd) -
                   shift * shift / (2 * log_sd * log_sd);
    for (const SpecimenLife* life : members) {
      value += life->log_likelihood(shift);
    }
    sum = log_sum(sum, value);
  }
  return sum;
}

std::vector<SpecimenLife> lives_of(const LifeSample& sample, const LifeSettings& settings) {
  const LifeFrame frame = frame_of(sample, settings);
  std::vector<SpecimenLife> lives;
  lives.reserve(sample.size());
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    lives.emplace_back(sample, specimen, settings, frame);
  }
  return lives;
}

bool shares(const LifeSettings& settings) {
  return settings.lot_log_sd > 0 || settings.group_log_sd > 0;
}

std::vector<Members> shared_by(const LifeSample& sample, const LifeSettings& settings,
                               const std::vector<SpecimenLife>& lives) {
  const bool by_lot = settings.lot_log_sd > 0;
  std::vector<Members> all(by_lot ? sample.lots : sample.groups);
  for (std::size_t i = 0; i < lives.size(); ++i) {
    const LifeSample::Specimen& specimen = sample.specimens[i];
    all[by_lot ? specimen.lot_number : specimen.group].push_back(&lives[i]);
  }
  return all;
}

double shared_sd(const LifeSettings& settings) {
  return settings.lot_log_sd > 0 ? settings.lot_log_sd : settings.group_log_sd;
}

double survival_at(const LifeSample& sample, const LifeSample::Specimen& specimen,
                   const LifeSettings& settings, const LifeFrame& frame) {
  const SpecimenLife life(sample, specimen, settings, frame);
  const double log_sd = std::hypot(settings.lot_log_sd, settings.group_log_sd);
  if (log_sd == 0) {
    return std::exp(life.log_survival(0));
  }
  double sum = 0;
  for (const NormalNode& node : even_nodes()) {
    sum += std::exp(node.ln_weight + life.log_survival(log_sd * node.at));
  }
  return sum;
}

}  // namespace

double log_likelihood(const LifeSample& sample, const LifeSettings& settings) {
  const std::vector<SpecimenLife> lives = lives_of(sample, settings);
  double sum = 0;
  if (shares(settings)) {
    for (const Members& members : shared_by(sample, settings, lives)) {
      sum += members.empty() ? 0 : log_shared(members, shared_sd(settings));
    }
    return sum;
  }
  for (const SpecimenLife& life : lives) {
    sum += life.log_likelihood(0);
  }
  return sum;
}

std::vector<Residual> residuals_of(const LifeSample& sample, const LifeSettings& settings) {
  const std::vector<SpecimenLife> lives = lives_of(sample, settings);
  std::vector<Residual> residuals(lives.size());
  if (shares(settings)) {
    for (const Members& members : shared_by(sample, settings, lives)) {
      const double mode = members.empty() ? 0 : near_of(members, shared_sd(settings)).mode;
      for (const SpecimenLife* life : members) {
        residuals[static_cast<std::size_t>(life - lives.data())].shared = mode;
      }
    }
  }
  for (std::size_t i = 0; i < lives.size(); ++i) {
    residuals[i].cox_snell = -lives[i].log_survival(residuals[i].shared);
  }
  return residuals;
}

double survival(const LifeSample& sample, const LifeSample::Specimen& specimen,
                const LifeSettings& settings) {
  return survival_at(sample, specimen, settings, frame_of(sample, settings));
}

double quantile_cycles(const LifeSample& sample, LifeSample::Specimen specimen,
                       const LifeSettings& settings, double p) {
  const LifeFrame frame = frame_of(sample, settings);
  double low = 0;
  double high = 60;  // ln cycles
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    specimen.blocks.back().cycles = std::exp(middle);
    (survival_at(sample, specimen, settings, frame) > 1 - p ? low : high) = middle;
  }
  return std::exp((low + high) / 2);
}

}  // namespace host_sim::diagnose::lives
