#include "host_sim/extension/life.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/model/model.hpp"

namespace host_sim {
namespace {

using reference::MeanAmplitude;

/// A cycle with the bend in its amplitude. Where the bend is large the laws of Gerber and Goodman
/// fall near the ultimate tension as the cycle widens, and `bend_alone`, about the tension that is
/// furthest out, does more: it is the least law above them that does not fall.
double gerber_N(double ultimate_N, const MeanAmplitude& cycle, double bend_N) {
  const double furthest_N = std::abs(cycle.mean_N) + cycle.amplitude_N;
  const double bend_alone = reference::gerber_effective_tension({furthest_N, bend_N}, ultimate_N);
  return std::max(bend_alone, reference::gerber_effective_tension(
                                  {cycle.mean_N, cycle.amplitude_N + bend_N}, ultimate_N));
}

double goodman_N(double ultimate_N, const MeanAmplitude& cycle, double bend_N) {
  const double bend_alone = bend_N / (1 - (cycle.mean_N + cycle.amplitude_N) / ultimate_N);
  return std::max(bend_alone, (cycle.amplitude_N + bend_N) / (1 - cycle.mean_N / ultimate_N));
}

double walker_N(double walker, const MeanAmplitude& cycle, double bend_N) {
  const double amplitude_N = cycle.amplitude_N + bend_N;
  return std::pow(std::max(0.0, cycle.mean_N + amplitude_N), 1 - walker) *
         std::pow(amplitude_N, walker);
}

double mean_stress_N(const Extension* effect, double ultimate_N, const MeanAmplitude& cycle,
                     double bend_N) {
  const double share = effect != nullptr ? value_of(*effect, "mean_stress_share") : 0;
  const double nominal_N = gerber_N(ultimate_N, cycle, bend_N);
  if (share == 0) {
    return nominal_N;
  }
  const double walker = value_of(*effect, "walker_exponent");
  const double law_N =
      walker > 0 ? walker_N(walker, cycle, bend_N) : goodman_N(ultimate_N, cycle, bend_N);
  return std::pow(nominal_N, 1 - share) * std::pow(law_N, share);
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
  return [model, bends, ends](const MeanAmplitude& input, double) {
    const auto mean_N = [&](double bend_N) {
      return mean_stress_N(extension_of(model.extensions, "mean_stress"),
                           model.cable.ultimate_tension_N, input, bend_N);
    };
    double effective_N = mean_N(0);
    if (bends) {
      const Extension& fatigue = *extension_of(model.extensions, "bending_fatigue");
      const double share = value_of(fatigue, "bending_share");
      effective_N =
          std::pow(effective_N, 1 - share) * std::pow(mean_N(*bending_amplitude_N(fatigue)), share);
    }
    if (ends && effective_N > 0) {
      effective_N = endurance_N(*extension_of(model.extensions, "endurance_limit"), effective_N);
    }
    return effective_N;
  };
}

}  // namespace host_sim
