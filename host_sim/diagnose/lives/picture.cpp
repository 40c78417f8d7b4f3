#include "host_sim/diagnose/lives/picture.hpp"

#include <cmath>

namespace host_sim::diagnose::lives {
namespace {

/// Of equal damage: the power mean of the blocks.
double equivalent_N(const LifeSample::Specimen& specimen, double exponent) {
  double powers = 0;
  for (const LifeSample::Block& block : specimen.blocks) {
    powers += block.cycles * std::pow(block.effective_N, exponent);
  }
  return std::pow(powers / specimen.cycles(), 1 / exponent);
}

}  // namespace

LifePicture picture_of(const LifeSample& sample, const LifeSettings& before,
                       const LifeSettings& after) {
  const std::vector<Residual> residuals_before = residuals_of(sample, before);
  const std::vector<Residual> residuals_after = residuals_of(sample, after);
  LifePicture picture{.points = {}, .shape_before = before.shape, .shape_after = after.shape};
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const LifeSample::Specimen& specimen = sample.specimens[i];
    picture.points.push_back(
        {.specimen = specimen.name,
         .lot = specimen.lot,
         .effective_N = equivalent_N(specimen, before.exponent),
         .ratio_before = std::pow(residuals_before[i].cox_snell, 1 / before.shape),
         .ratio_after = std::pow(residuals_after[i].cox_snell, 1 / after.shape),
         .failed = specimen.failed});
  }
  return picture;
}

}  // namespace host_sim::diagnose::lives
