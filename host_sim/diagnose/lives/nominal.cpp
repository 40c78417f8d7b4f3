#include "host_sim/diagnose/lives/nominal.hpp"

#include <cmath>

#include "host_sim/diagnose/lives/tension.hpp"

namespace host_sim::diagnose::lives {

life_law::LifeData life_data_of(const LifeSample& sample) {
  life_law::LifeData data;
  data.reserve(sample.size());
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    life_law::LifeDatum datum;
    for (const LifeSample::Block& block : specimen.blocks) {
      datum.blocks.push_back({block.effective_N, block.cycles});
    }
    datum.failed = specimen.failed;
    if (specimen.load != LifeSample::kNoLoad) {
      datum.level = specimen.load;
    }
    data.push_back(std::move(datum));
  }
  return data;
}

NominalFit fit_nominal(const LifeSample& sample) {
  const life_law::LifeFit fit = life_law::fit_life(life_data_of(sample));
  if (fit.problem != statistics::FitProblem::none) {
    return {.problem = fit.problem};
  }
  const life_law::LifeLaw law = fit.law();
  const double centre = centre_ln_N(sample, LifeSettings{});
  return {.centre_ln_N = centre,
          .ln_life_at_centre = std::log(law.scale) - law.exponent * centre,
          .exponent = law.exponent,
          .shape = law.shape,
          .log_likelihood = fit.log_likelihood};
}

}  // namespace host_sim::diagnose::lives
