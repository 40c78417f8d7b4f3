#include "host_sim/diagnose/lives/life_settings.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim::diagnose::lives {
namespace {

/// Share of T_u where Gerber and Goodman are no laws any more.
constexpr double kLargestMean = 0.98;

}  // namespace

double damaging_N(const LifeSample& sample, const LifeSample::Block& block,
                  const LifeSettings& settings) {
  const double bending_N = settings.bending_N * block.wire_to_bend_ratio;
  const double amplitude_N = block.amplitude_N + bending_N;
  const double mean_N = block.mean_N + (settings.bending_from_zero ? bending_N : 0);
  if (!settings.walker_exponent) {
    const auto left = [&](double tension_N) {
      const double share = std::min(tension_N / sample.ultimate_tension_N, kLargestMean);
      return 1 - share * share;
    };
    return bending_N == 0 ? block.effective_N
                          : block.effective_N * amplitude_N / block.amplitude_N *
                                left(block.mean_N) / left(mean_N);
  }
  const double walker = *settings.walker_exponent;
  if (walker == 0) {
    return amplitude_N / (1 - std::min(mean_N / sample.ultimate_tension_N, kLargestMean));
  }
  return std::pow(mean_N + amplitude_N, 1 - walker) * std::pow(amplitude_N, walker);
}

double centre_ln_N(const LifeSample& sample, const LifeSettings& settings) {
  double sum = 0;
  for (const LifeSample::Specimen& specimen : *sample.reference) {
    sum += std::log(damaging_N(sample, specimen.last(), settings));
  }
  return sum / static_cast<double>(sample.reference->size());
}

}  // namespace host_sim::diagnose::lives
