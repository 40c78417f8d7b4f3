#include "host_sim/extension/life.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/extension/value.hpp"

namespace host_sim {
namespace {

using reference::MeanAmplitude;

double mean_stress_N(const Extension& effect, double ultimate_N, const MeanAmplitude& input,
                     double gerber_N) {
  const double share = value_of(effect, "mean_stress_share");
  const double walker = value_of(effect, "walker_exponent");
  const double highest_N = std::max(0.0, input.mean_N + input.amplitude_N);
  const double law_N = walker > 0
                           ? std::pow(highest_N, 1 - walker) * std::pow(input.amplitude_N, walker)
                           : input.amplitude_N / (1 - input.mean_N / ultimate_N);
  return std::pow(gerber_N, 1 - share) * std::pow(law_N, share);
}

double bending_fatigue_N(const Extension& effect, const MeanAmplitude& input, double effective_N) {
  return effective_N * std::pow(1 + *bending_amplitude_N(effect) / input.amplitude_N,
                                value_of(effect, "bending_share"));
}

double endurance_N(const Extension& effect, double effective_N) {
  const double left = std::max(0.0, 1 - *endurance_limit_N(effect) / effective_N);
  return effective_N * std::pow(left, value_of(effect, "endurance_share"));
}

}  // namespace

std::optional<double> endurance_limit_N(const Extension& endurance_limit) {
  const auto lowest_N = value_if(endurance_limit, "lowest_effective_N");
  return lowest_N ? std::optional(*lowest_N * value_of(endurance_limit, "limit_of_lowest"))
                  : std::nullopt;
}

std::optional<double> bending_amplitude_N(const Extension& bending_fatigue) {
  const auto ratio = value_if(bending_fatigue, "wire_to_bend_ratio");
  return ratio ? std::optional(*ratio * value_of(bending_fatigue, "bending_N")) : std::nullopt;
}

reference::EffectiveTension extended_effective_tension(const Model& model) {
  const auto effect = [&](std::string_view id) { return extension_of(model.extensions, id); };
  const Extension* const bend = effect("bending_fatigue");
  const Extension* const limit = effect("endurance_limit");
  const bool bends = bend != nullptr && bending_amplitude_N(*bend);
  const bool ends = limit != nullptr && endurance_limit_N(*limit);
  if (effect("mean_stress") == nullptr && !bends && !ends) {
    return {};
  }
  return [model, bends, ends](const MeanAmplitude& input, double gerber_N) {
    double effective_N = gerber_N;
    if (const Extension* const law = extension_of(model.extensions, "mean_stress")) {
      effective_N = mean_stress_N(*law, model.cable.ultimate_tension_N, input, effective_N);
    }
    if (bends && effective_N > 0) {
      effective_N =
          bending_fatigue_N(*extension_of(model.extensions, "bending_fatigue"), input, effective_N);
    }
    if (ends && effective_N > 0) {
      effective_N = endurance_N(*extension_of(model.extensions, "endurance_limit"), effective_N);
    }
    return effective_N;
  };
}

}  // namespace host_sim
