#include <benchmark/benchmark.h>

#include <cmath>
#include <string>
#include <utility>

#include "lifemodel/bulk/replay.hpp"
#include "tests/lifemodel/support.hpp"

namespace lifemodel_test {
namespace {

using lifemodel::Estimator;
using lifemodel::Tension;

constexpr std::size_t kSamples = 1u << 20;

lifemodel::Parameters parameters() {
  auto constants = paper_constants();
  constants.hysteresis_N = 0.2;
  return parameters_of(constants);
}

Signal noisy_sine() {
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 0.1);
  Signal signal;
  for (std::size_t i = 0; i < kSamples; ++i) {
    signal.push_back(
        newtons(38.5 + 10 * std::sin(static_cast<double>(i) * 2 * M_PI / 1000) + noise(random)));
  }
  return signal;
}

void count(benchmark::State& state, const Signal& signal) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(signal.size()));
}

void by_sample(benchmark::State& state, const Signal& signal) {
  Estimator<1> estimator({parameters()});
  for (auto _ : state) {
    for (const Tension sample : signal) {
      estimator.push(0, sample);
      while (estimator.settle()) {
      }
    }
  }
  benchmark::DoNotOptimize(estimator.reading(0));
  count(state, signal);
}

void by_block(benchmark::State& state, const Signal& signal) {
  Estimator<1, HostLayout> estimator({parameters()});
  for (auto _ : state) {
    estimator.replay(0, signal);
  }
  benchmark::DoNotOptimize(estimator.reading(0));
  count(state, signal);
}

void in_bulk(benchmark::State& state, const Signal& signal,
             const lifemodel::bulk::Instructions& by) {
  Estimator<1> estimator({parameters()});
  lifemodel::bulk::Replay replay(by);
  for (auto _ : state) {
    replay.take(estimator, 0, signal);
  }
  benchmark::DoNotOptimize(estimator.reading(0));
  count(state, signal);
}

/// By each set of instructions that the machine has.
const bool in_bulk_by_each = [] {
  for (const lifemodel::bulk::Instructions* by : lifemodel::bulk::instructions()) {
    for (const auto& [name, signal] :
         {std::pair{"walk", walk(1, kSamples)}, std::pair{"noisy_sine", noisy_sine()},
          std::pair{"white_noise", white_noise(1, kSamples, 0, 100)}}) {
      benchmark::RegisterBenchmark(
          (std::string("in_bulk/") + name + '/' + by->name).c_str(),
          [samples = signal, by](benchmark::State& state) { in_bulk(state, samples, *by); });
    }
  }
  return true;
}();

BENCHMARK_CAPTURE(by_sample, walk, walk(1, kSamples));
BENCHMARK_CAPTURE(by_sample, noisy_sine, noisy_sine());
BENCHMARK_CAPTURE(by_sample, white_noise, white_noise(1, kSamples, 0, 100));
BENCHMARK_CAPTURE(by_block, walk, walk(1, kSamples));
BENCHMARK_CAPTURE(by_block, noisy_sine, noisy_sine());
BENCHMARK_CAPTURE(by_block, white_noise, white_noise(1, kSamples, 0, 100));

}  // namespace
}  // namespace lifemodel_test
