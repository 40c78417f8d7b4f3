#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <memory>
#include <thread>

#include "support.hpp"

namespace lifemodel {
namespace {

struct Layout {
  static constexpr std::size_t kResidue = 128;
  static constexpr std::size_t kQueue = 1u << 18;
};

TEST(Interrupt, PushOnOneThreadSettleAndReadOnAnotherLosesNothing) {
  const Parameters p = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  const auto signal = lifemodel_test::white_noise(31, 200'000, 0, 100);
  auto shared = std::make_unique<Estimator<1, Layout>>(std::array{p});
  std::atomic<bool> done = false;
  std::thread producer([&] {
    for (const Tension sample : signal) {
      shared->push(0, sample);
    }
    done = true;
  });
  Damage before;
  while (!done) {
    shared->settle();
    const Reading now = shared->reading(0);
    EXPECT_LE(before, now.total);
    before = now.total;
  }
  producer.join();
  Estimator<1> alone({p});
  alone.replay(0, signal);
  EXPECT_EQ(shared->reading(0).total, alone.reading(0).total);
}

struct HurriedLayout {
  static constexpr std::size_t kResidue = 128;
  static constexpr std::size_t kQueue = 16;
};

/// Notes a cycle that is none.
struct Ranges {
  bool& empty;
  void full(Tension from, Tension to, CycleDamage) { empty |= from == to; }
  void half(Tension from, Tension to, CycleDamage) { empty |= from == to; }
};

/// Whatever push() may note, while it is read: saturation, gaps, overloads, overruns.
TEST(Interrupt, WhatPushNotesIsReadWhileItIsNoted) {
  const Parameters p = lifemodel_test::parameters_of(lifemodel_test::paper_constants());
  constexpr std::uint32_t kSamples = 60'000;
  Estimator<1, HurriedLayout> shared({p});
  std::atomic<bool> done = false;
  std::thread producer([&] {
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      // 120 A are 2471 N, beyond 4 T_u.
      shared.push(0, pack::from_double<MotorCurrent>(i < 100 ? 0 : i % 2 == 0 ? 120 : 1));
      if (i % 8 == 0) {
        shared.push_missing(0, 3);
      }
    }
    done = true;
  });
  Reading before{};
  bool empty = false;
  while (!done) {
    const Reading now = shared.reading(0, Ranges{empty});
    EXPECT_EQ(now.flags | before.flags, now.flags);
    EXPECT_LE(before.gaps, now.gaps);
    EXPECT_LE(before.missing_samples, now.missing_samples);
    EXPECT_LE(before.total, now.total);
    before = now;
  }
  producer.join();
  const Reading last = shared.reading(0, Ranges{empty});
  EXPECT_FALSE(empty);
  EXPECT_TRUE(last.flags.has(Flag::saturated) && last.flags.has(Flag::overload));
  EXPECT_EQ(last.gaps.raw(), kSamples / 8);
  EXPECT_EQ(last.missing_samples.raw(), 3 * kSamples / 8);
}

}  // namespace
}  // namespace lifemodel
