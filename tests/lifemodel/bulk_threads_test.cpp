#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lifemodel/bulk/parallel_replay.hpp"
#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::newtons;
using lifemodel_test::Signal;

constexpr std::size_t kSamples = 60'000;
constexpr std::size_t kStretch = 500;

/// Stretches that are reduced, that reach the ultimate tension, and that nest beyond the residue:
/// in turn, so that some are joined and some replayed one by one.
Signal any_stretches() {
  Signal signal = lifemodel_test::walk(1, kSamples);
  for (std::size_t i = 7 * kStretch; i < kSamples; i += 10 * kStretch) {
    signal[i] = newtons(180);
  }
  const Signal deep = lifemodel_test::spiral(140, 0.25, true);
  for (std::size_t i = 3 * kStretch; i + deep.size() < kSamples; i += 10 * kStretch) {
    std::copy(deep.begin(), deep.end(), signal.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return signal;
}

std::vector<std::byte> state_of(Estimator<1>& estimator) {
  estimator.flush(0);
  std::vector<std::byte> bytes(Estimator<1>::kSnapshotBytes);
  bytes.resize(estimator.snapshot(bytes).size());
  return bytes;
}

TEST(BulkThreads, AnyNumberOfThemGivesTheStateOfSampleBySample) {
  const Parameters parameters = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  for (const Signal& signal :
       {lifemodel_test::walk(2, kSamples), lifemodel_test::white_noise(3, kSamples, 0, 100),
        any_stretches(), Signal{newtons(1)}, Signal{}}) {
    Estimator<1> one_by_one({parameters});
    for (const Tension sample : signal) {
      one_by_one.push(0, sample);
      while (one_by_one.settle()) {
      }
    }
    const auto expected = state_of(one_by_one);
    for (unsigned threads = 1; threads <= 4; ++threads) {
      bulk::ParallelReplay replay(threads, *bulk::instructions().front(), kStretch);
      Estimator<1> estimator({parameters});
      replay.take(estimator, 0, signal);
      EXPECT_EQ(state_of(estimator), expected) << threads << " threads";
    }
  }
}

TEST(BulkThreads, SomeStretchesAreReplayedOneByOne) {
  Estimator<1> estimator({lifemodel_test::parameters_of(lifemodel_test::paper_constants())});
  bulk::ParallelReplay(2, *bulk::instructions().front(), kStretch)
      .take(estimator, 0, any_stretches());
  const Reading reading = estimator.reading(0);
  EXPECT_GT(reading.overloads.raw(), 0u);
  EXPECT_GT(reading.residue_overflows.raw(), 0u);
}

TEST(BulkThreads, OneReplayTakesManySignals) {
  const Parameters parameters = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  const Signal signal = any_stretches();
  Estimator<1> one_by_one({parameters});
  Estimator<1> estimator({parameters});
  bulk::ParallelReplay replay(3, *bulk::instructions().front(), kStretch);
  for (int i = 0; i < 3; ++i) {
    for (const Tension sample : signal) {
      one_by_one.push(0, sample);
      while (one_by_one.settle()) {
      }
    }
    replay.take(estimator, 0, signal);
    EXPECT_EQ(state_of(estimator), state_of(one_by_one));
  }
}

}  // namespace
}  // namespace lifemodel
