#include <benchmark/benchmark.h>

#include "host_sim/plan/plan.hpp"

namespace host_sim::plan {
namespace {

/// Wall time of a plan on all cores: the paper's law and levels, B10 far below.
void whole_plan(benchmark::State& state) {
  PlanRequest request;
  request.conditions = {{.scale = 1.53e5, .exponent = 1.38, .shape = 5.94},
                        {42.5, 50.7, 60.0, 70.8}};
  request.goal = {.use_tension_N = 25.5, .ratio = 1.25};
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_plan(request));
  }
}
BENCHMARK(whole_plan)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace host_sim::plan
