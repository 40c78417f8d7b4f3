#include "host_sim/diagnose/force/invisible.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace host_sim::diagnose {
namespace {

// No campaign is better than this: calibration and rounding remain.
constexpr double kLeastNoise = 1e-3;  ///< of the rms input force
constexpr double kLeastGainScatter = 1e-3;
constexpr double kLeastFrictionScatter = 1e-3;

NoiseModel noise_of(const ForceData& data, const ForceFit& model) {
  NoiseModel noise;
  noise.session_gain_sd = std::max(data.covariance().log_gain_sd(), kLeastGainScatter);
  noise.session_friction_sd = std::max(data.covariance().friction_sd(), kLeastFrictionScatter);
  const std::vector<std::vector<double>> residuals_N = data.residuals_N(model);
  double square_N2 = 0;
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    const Eigen::VectorXd left_N = data.covariance().beside_refit(j, vector_of(residuals_N[j]));
    square_N2 += data.covariance().weighted_square(j, left_N);
  }
  const double sd_N = std::max(std::sqrt(square_N2 / std::max(data.samples(), 1.0)),
                               kLeastNoise * data.scales().larger_N());
  for (std::size_t j = 0; j < residuals_N.size(); ++j) {
    std::vector<double>& of_record = noise.sample_sd_N.emplace_back();
    for (std::size_t i = 0; i < residuals_N[j].size(); ++i) {
      of_record.push_back(sd_N / std::sqrt(data.covariance().weight(j, i)));
    }
  }
  return noise;
}

}  // namespace

Audit audit_of(const ForceData& data, const ForceFit& model, unsigned threads) {
  return audit(data.records(), model.parameters[1], noise_of(data, model), threads);
}

void add_invisible(const Audit& audit, Findings& findings) {
  const auto is_found = [&](std::string_view id) {
    return std::ranges::find(findings.effects, id, &FoundEffect::id) != findings.effects.end();
  };
  for (const EffectAudit& effect : audit.effects) {
    if (!effect.visible() && !is_found(effect.effect->id)) {
      findings.invisible.push_back({std::string(effect.effect->id), effect.prose});
    }
  }
  for (const EquivalenceClass& group : audit.classes) {
    std::vector<std::string> ids;
    for (const std::size_t member : group.members) {
      ids.emplace_back(audit.effects[member].effect->id);
    }
    const auto holds_all = [&](const std::vector<std::string>& same) {
      return std::ranges::all_of(
          ids, [&](const std::string& id) { return std::ranges::find(same, id) != same.end(); });
    };
    // Of what it is a fit says more than a design.
    if (ids.size() > 1 && std::ranges::none_of(ids, is_found) &&
        std::ranges::none_of(findings.equivalent_sets, holds_all)) {
      findings.equivalent_sets.push_back(std::move(ids));
    }
  }
}

}  // namespace host_sim::diagnose
