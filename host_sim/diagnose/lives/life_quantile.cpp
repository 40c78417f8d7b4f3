#include "host_sim/diagnose/lives/life_quantile.hpp"

#include <cmath>

#include "host_sim/diagnose/lives/quadrature.hpp"
#include "host_sim/diagnose/lives/specimen_life.hpp"

namespace host_sim::diagnose::lives {
namespace {

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
