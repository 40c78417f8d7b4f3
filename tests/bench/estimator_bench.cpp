#include <benchmark/benchmark.h>
#include <dlfcn.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lifemodel/bulk/parallel_replay.hpp"
#include "lifemodel/bulk/replay.hpp"
#include "tests/lifemodel/support.hpp"

namespace lifemodel_test {
namespace {

using lifemodel::Estimator;
using lifemodel::Tension;

constexpr std::size_t kSamples = 1u << 20;
constexpr double kHysteresis_N = 0.2;

lifemodel::Parameters parameters() {
  auto constants = paper_constants();
  constants.hysteresis_N = kHysteresis_N;
  return parameters_of(constants);
}

/// 38.5 N +- 10 N, 1000 samples a cycle, with noise of this standard deviation.
Signal sine(double noise_N) {
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  Signal signal;
  for (std::size_t i = 0; i < kSamples; ++i) {
    signal.push_back(newtons(38.5 + 10 * std::sin(static_cast<double>(i) * 2 * M_PI / 1000) +
                             noise_N * noise(random)));
  }
  return signal;
}

struct Named {
  const char* name;
  Signal signal;
};

const std::vector<Named>& signals() {
  static const std::vector<Named> all{{"walk", walk(1, kSamples)},
                                      {"noisy_sine", sine(0.1)},
                                      {"white_noise", white_noise(1, kSamples, 0, 100)},
                                      {"sine", sine(0)}};
  return all;
}

/// Root mean square from one sample to the next.
double step_N(const Signal& signal) {
  double square_N2 = 0;
  for (std::size_t i = 1; i < signal.size(); ++i) {
    const double step = to_newtons(signal[i]) - to_newtons(signal[i - 1]);
    square_N2 += step * step;
  }
  return std::sqrt(square_N2 / static_cast<double>(signal.size() - 1));
}

/// What a figure is of: how much turns depends on the steps and on the hysteresis.
void count(benchmark::State& state, const Signal& signal) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(signal.size()));
  std::array<char, 64> label{};
  std::snprintf(label.data(), label.size(), "steps of %.3g N, hysteresis %.3g N", step_N(signal),
                kHysteresis_N);
  state.SetLabel(label.data());
}

void by_sample(benchmark::State& state, const Signal& signal) {
  Estimator<1> estimator({parameters()});
  for (auto _ : state) {
    for (const Tension sample : signal) {
      if (estimator.push(0, sample)) {
        estimator.settle();
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

/// Wall time, by the number of threads.
void by_threads(benchmark::State& state, const Signal& signal) {
  Signal longer;
  for (int i = 0; i < 8; ++i) {
    longer.insert(longer.end(), signal.begin(), signal.end());
  }
  Estimator<1> estimator({parameters()});
  lifemodel::bulk::ParallelReplay replay(static_cast<unsigned>(state.range(0)));
  for (auto _ : state) {
    replay.take(estimator, 0, longer);
  }
  benchmark::DoNotOptimize(estimator.reading(0));
  count(state, longer);
}

/// Another counter in the folder of $TENDONLIFE_PEER, a build of its own: libpeer.so with this
/// function.
using PeerCount = void (*)(const double* tension_N, std::size_t samples, double hysteresis_N);

PeerCount peer() {
  const char* folder = std::getenv("TENDONLIFE_PEER");
  if (folder == nullptr) {
    return nullptr;
  }
  void* const library = dlopen((std::string(folder) + "/libpeer.so").c_str(), RTLD_NOW);
  void* const function = library == nullptr ? nullptr : dlsym(library, "peer_count");
  if (function == nullptr) {
    throw std::runtime_error(dlerror());
  }
  return reinterpret_cast<PeerCount>(function);
}

void by_peer(benchmark::State& state, const Signal& signal, PeerCount peer_count) {
  std::vector<double> tension_N;
  for (const Tension sample : signal) {
    tension_N.push_back(to_newtons(sample));
  }
  for (auto _ : state) {
    peer_count(tension_N.data(), tension_N.size(), kHysteresis_N);
    benchmark::ClobberMemory();
  }
  count(state, signal);
}

template <class Function, class... Arguments>
benchmark::internal::Benchmark* add(const std::string& name, const Named& named, Function function,
                                    Arguments... arguments) {
  return benchmark::RegisterBenchmark(
      (name + '/' + named.name).c_str(),
      [&signal = named.signal, function, arguments...](benchmark::State& state) {
        function(state, signal, arguments...);
      });
}

void add_all() {
  const PeerCount peer_count = peer();
  for (const Named& named : signals()) {
    for (const lifemodel::bulk::Instructions* by : lifemodel::bulk::instructions()) {
      add(std::string("in_bulk/") + by->name, named,
          [by](benchmark::State& state, const Signal& signal) { in_bulk(state, signal, *by); });
    }
    add("by_block", named, by_block);
    add("by_sample", named, by_sample);
    add("by_threads", named, by_threads)->Arg(1)->Arg(2)->UseRealTime();
    if (peer_count != nullptr) {
      add("peer", named, by_peer, peer_count);
    }
  }
}

}  // namespace
}  // namespace lifemodel_test

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  try {
    lifemodel_test::add_all();
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "TENDONLIFE_PEER: %s\n", error.what());
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
}
