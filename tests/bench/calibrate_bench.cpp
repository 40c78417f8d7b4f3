#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

#include "host_sim/calibrate/calibrate.hpp"
#include "host_sim/statistics/random.hpp"

namespace host_sim {
namespace {

constexpr std::size_t kSpecimensOfLevel = 20;

Campaign::Specimen specimen(std::size_t number, double tension_N, double cycles) {
  Campaign::Specimen made;
  made.name = std::to_string(number);
  Campaign::Load load;
  load.input_tension_mean_N = tension_N;
  load.effective_tension_N = tension_N;
  made.blocks = {{load, cycles, number + 2}};
  made.line = number + 2;
  return made;
}

/// Five levels of 20 under the law of the paper's section 3.5, and a use far below.
Campaign campaign() {
  const life_law::LifeLaw law{.scale = 1.53e5, .exponent = 1.38, .shape = 5.94};
  statistics::Random random(1, 0, 0);
  Campaign made;
  made.name = "bench";
  for (const double tension_N : {42.5, 50.7, 60.0, 70.8, 85.0}) {
    for (std::size_t k = 0; k < kSpecimensOfLevel; ++k) {
      const double cycles = std::ceil(law.quantile(random.uniform(), tension_N));
      made.specimens.push_back(specimen(made.specimens.size(), tension_N, cycles));
    }
  }
  return made;
}

/// Wall time of a whole calibration on all cores with `range(0)` bootstraps.
void whole_calibration(benchmark::State& state) {
  const Campaign measured = campaign();
  calibrate::CalibrateOptions options;
  options.bootstraps = static_cast<std::size_t>(state.range(0));
  options.use_tensions_N = {25.5};
  for (auto _ : state) {
    benchmark::DoNotOptimize(calibrate::calibrate(measured, options));
  }
}
BENCHMARK(whole_calibration)->Arg(1000)->Arg(10'000)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace host_sim
