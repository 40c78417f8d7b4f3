#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "host_sim/diagnose/lives/life_sample.hpp"

namespace host_sim::diagnose::lives::test {

/// A specimen under one fully reversed load, where T_eff is the amplitude.
inline LifeSample::Specimen reversed(double tension_N, double cycles, bool failed = true) {
  LifeSample::Specimen specimen;
  specimen.blocks = {{.mean_N = 0,
                      .amplitude_N = tension_N,
                      .effective_N = tension_N,
                      .cycles = cycles,
                      .level = 0,
                      .wire_to_bend_ratio = 0}};
  specimen.failed = failed;
  return specimen;
}

/// A sample of these specimens; `centre_N` is where ln_life_at_centre is.
inline LifeSample sample_with(std::vector<LifeSample::Specimen> specimens, double centre_N) {
  LifeSample sample;
  sample.specimens = std::move(specimens);
  sample.levels = sample.loads = sample.lots = sample.groups = 1;
  for (const LifeSample::Specimen& specimen : sample.specimens) {
    sample.lots = std::max(sample.lots, specimen.lot_number + 1);
  }
  sample.lowest_N = sample.highest_N = centre_N;
  sample.ultimate_tension_N = 177.4;
  sample.reference =
      std::make_shared<const std::vector<LifeSample::Specimen>>(std::vector{reversed(centre_N, 1)});
  return sample;
}

}  // namespace host_sim::diagnose::lives::test
