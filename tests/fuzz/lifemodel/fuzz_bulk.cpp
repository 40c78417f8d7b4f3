// Any signal, in parts of any length: the state after a bulk replay is that of push() and settle()
// of each sample, by each set of instructions that the machine has and by 1 .. 4 threads.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#include "lifemodel/bulk/parallel_replay.hpp"
#include "tests/lifemodel/support.hpp"

namespace {

using namespace lifemodel;
using Single = Estimator<1>;

std::vector<std::byte> state_of(Single& estimator) {
  estimator.flush(0);
  std::vector<std::byte> bytes(Single::kSnapshotBytes);
  bytes.resize(estimator.snapshot(bytes).size());
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) {
    return 0;
  }
  auto constants = lifemodel_test::paper_constants();
  constants.ipl_exponent = 1 + 11.0 * data[0] / 255;
  constants.ipl_scale = 1e4 * std::pow(constants.ultimate_tension_N, constants.ipl_exponent);
  Parameters parameters = lifemodel_test::parameters_of(constants);
  // In the steps of the samples, so that ranges are just the hysteresis.
  constexpr int kStepBits = Tension::kFractionBits - 15;
  parameters.hysteresis =
      TensionRange::from_raw(data[1] == 0 ? 1u : std::uint32_t{data[1]} * data[1] << kStepBits);
  std::vector<Tension> signal;
  for (std::size_t i = 3; i + 1 < size; i += 2) {
    std::int16_t word = 0;
    std::memcpy(&word, data + i, sizeof word);
    signal.push_back(Tension::from_raw(word * (1 << kStepBits)));
  }
  Single one_by_one({parameters});
  for (const Tension sample : signal) {
    one_by_one.push(0, sample);
    while (one_by_one.settle()) {
    }
  }
  const auto expected = state_of(one_by_one);
  for (const bulk::Instructions* by : bulk::instructions()) {
    Single estimator({parameters});
    bulk::Reducer reducer(*by);
    std::span<const Tension> left(signal);
    std::uint32_t random = data[2];
    while (!left.empty()) {
      random = random * 1664525 + 1013904223;
      const std::size_t length =
          data[2] == 0 ? left.size() : 1 + (random >> 16) % (1u << data[2] % 16);
      const auto part = left.first(std::min(left.size(), length));
      left = left.subspan(part.size());
      const auto stretch = reducer.reduce(part, parameters.hysteresis, parameters.law);
      if (!stretch || !estimator.replay(0, *stretch)) {
        estimator.replay(0, part);
      }
    }
    if (state_of(estimator) != expected) {
      std::fprintf(stderr, "another state by %s\n", by->name);
      std::abort();
    }
  }
  const unsigned threads = 1 + data[2] / 16 % 4;
  const std::size_t stretch = 1 + data[2] % 16;
  Single estimator({parameters});
  bulk::ParallelReplay(threads, *bulk::instructions().front(), stretch).take(estimator, 0, signal);
  if (state_of(estimator) != expected) {
    std::fprintf(stderr, "another state by %u threads\n", threads);
    std::abort();
  }
  return 0;
}
