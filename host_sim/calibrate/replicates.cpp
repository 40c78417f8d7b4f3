#include "host_sim/calibrate/replicates.hpp"

#include <algorithm>

#include "host_sim/calibrate/streams.hpp"
#include "host_sim/life_law/life_fit.hpp"
#include "host_sim/life_law/life_simulation.hpp"
#include "host_sim/statistics/parallel.hpp"

namespace host_sim::calibrate {

std::vector<LifeLaw> refitted_laws(std::span<const life_law::LifeDatum> data, const LifeLaw& law,
                                   const CalibrateOptions& options) {
  constexpr std::size_t kChunk = 64;
  const life_law::LifeSimulation simulation(data);
  const life_law::LifeFit start = life_law::fit_life(data);
  std::vector<LifeLaw> laws(options.bootstraps);
  const std::size_t chunks = (laws.size() + kChunk - 1) / kChunk;
  statistics::parallel_for(
      chunks,
      [&](std::size_t chunk) {
        life_law::LifeData drawn;
        const std::size_t end = std::min(laws.size(), (chunk + 1) * kChunk);
        for (std::size_t i = chunk * kChunk; i < end; ++i) {
          statistics::Random random(options.seed, stream_of(Purpose::campaigns), i);
          simulation.draw(law, random, drawn);
          const life_law::LifeFit fit = life_law::fit_life(drawn, start);
          if (fit.problem == statistics::FitProblem::none) {
            laws[i] = fit.law();
          }
        }
      },
      options.threads);
  return laws;
}

}  // namespace host_sim::calibrate
