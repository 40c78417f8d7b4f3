#include "lifemodel/state/snapshot.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::newtons;
using lifemodel_test::paper_constants;
using lifemodel_test::parameters_of;
using lifemodel_test::Signal;

using Two = Estimator<2>;

std::vector<std::byte> snapshot_of(const Two& estimator) {
  std::vector<std::byte> buffer(Two::kSnapshotBytes);
  const auto used = estimator.snapshot(buffer);
  return {used.begin(), used.end()};
}

Two estimator() {
  const Parameters p = parameters_of(paper_constants());
  return Two({p, p});
}

TEST(Snapshot, ResumedEqualsUninterruptedFromEverySample) {
  const Signal signal = lifemodel_test::white_noise(6, 300, -10, 120);
  const Signal other = lifemodel_test::spiral(300, 0.2, true);
  std::mt19937 random(3);
  for (std::size_t cut = 0; cut <= signal.size(); ++cut) {
    Two uninterrupted = estimator();
    Two first = estimator();
    Two second = estimator();
    for (std::size_t i = 0; i < signal.size(); ++i) {
      if (i == cut) {
        ASSERT_EQ(second.restore(snapshot_of(first)), SnapshotError::none);
      }
      Two& interrupted = i < cut ? first : second;
      const bool settles = random() % 3 != 0;
      for (Two* one : {&uninterrupted, &interrupted}) {
        one->push(0, signal[i]);
        one->push(1, other[i]);
        if (i % 97 == 0) {
          one->push_missing(1);
        }
        if (settles) {
          one->settle();
        }
      }
    }
    if (cut < signal.size()) {
      ASSERT_EQ(snapshot_of(second), snapshot_of(uninterrupted)) << "cut at " << cut;
    }
  }
}

TEST(Snapshot, ResumesInTheMiddleOfAnOverrun) {
  const Signal signal = lifemodel_test::white_noise(9, 400, 0, 120);
  for (std::size_t cut = 30; cut < 120; ++cut) {
    Two uninterrupted = estimator();
    Two first = estimator();
    Two second = estimator();
    for (std::size_t i = 0; i < signal.size(); ++i) {
      if (i == cut) {
        ASSERT_EQ(second.restore(snapshot_of(first)), SnapshotError::none);
      }
      Two& interrupted = i < cut ? first : second;
      for (Two* one : {&uninterrupted, &interrupted}) {
        one->push(0, signal[i]);
        for (int call = 0; i % 90 == 89 && call < 40; ++call) {
          one->settle();
        }
      }
    }
    ASSERT_EQ(snapshot_of(second), snapshot_of(uninterrupted)) << "cut at " << cut;
  }
}

std::vector<std::byte> some_snapshot() {
  Two used = estimator();
  for (const Tension t : lifemodel_test::white_noise(2, 100, 0, 100)) {
    used.push(0, t);
    used.push(1, t);
    while (used.settle()) {
    }
  }
  return snapshot_of(used);
}

TEST(Snapshot, EverySingleBitErrorIsRefusedAndTheStateStays) {
  const auto good = some_snapshot();
  Two target = estimator();
  for (const Tension t : lifemodel_test::walk(3, 50)) {
    target.push(0, t);
  }
  const auto before = snapshot_of(target);
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    auto bad = good;
    bad[bit / 8] ^= std::byte{1} << (bit % 8);
    ASSERT_NE(target.restore(bad), SnapshotError::none) << "bit " << bit;
  }
  EXPECT_EQ(snapshot_of(target), before);
}

TEST(Snapshot, EveryTruncationIsRefused) {
  const auto good = some_snapshot();
  Two target = estimator();
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_NE(target.restore(std::span(good).first(size)), SnapshotError::none);
  }
  auto longer = good;
  longer.push_back(std::byte{0});
  EXPECT_EQ(target.restore(longer), SnapshotError::wrong_size);
}

TEST(Snapshot, AShortStateWithAFittingFrameIsRefused) {
  const auto good = some_snapshot();
  for (std::size_t size = kSnapshotHeaderBytes + 4; size < good.size(); size += 4) {
    auto bytes =
        std::vector<std::byte>(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size));
    ByteWriter(std::span(bytes).subspan(8)).u32(static_cast<std::uint32_t>(size));
    ByteWriter(std::span(bytes).last(4)).u32(crc32(std::span(bytes).first(size - 4)));
    EXPECT_NE(estimator().restore(bytes), SnapshotError::none) << size;
  }
}

/// Writes a word of the snapshot and makes the CRC fit again.
std::vector<std::byte> forged(std::vector<std::byte> bytes, std::size_t word, std::uint32_t value) {
  ByteWriter(std::span(bytes).subspan(4 * word)).u32(value);
  ByteWriter(std::span(bytes).last(4)).u32(crc32(std::span(bytes).first(bytes.size() - 4)));
  return bytes;
}

TEST(Snapshot, AForgedStateThatNoCountCouldLeaveIsRefused) {
  const auto good = some_snapshot();
  Two target = estimator();
  ASSERT_EQ(target.restore(forged(good, 0, kSnapshotMagic)), SnapshotError::none);
  EXPECT_EQ(target.restore(forged(good, 0, 1)), SnapshotError::not_a_snapshot);
  EXPECT_EQ(target.restore(forged(good, 1, 2)), SnapshotError::unknown_version);
  EXPECT_EQ(target.restore(forged(good, 3, 3)), SnapshotError::other_tendons);
  EXPECT_EQ(target.restore(forged(good, 4, 99)), SnapshotError::other_model);
  EXPECT_EQ(target.restore(forged(good, 5, 7)), SnapshotError::implausible);   // phase
  EXPECT_EQ(target.restore(forged(good, 6, 12)), SnapshotError::implausible);  // mirror
  EXPECT_EQ(target.restore(forged(good, 7, 0x80000000u)), SnapshotError::implausible);
  EXPECT_EQ(target.restore(forged(good, 17, 1u << 20)), SnapshotError::implausible);  // flags
  const std::size_t sizes = 4 + 1 + 4 + 7 + 1 + 4 + 17;
  EXPECT_EQ(target.restore(forged(good, sizes, 129)), SnapshotError::implausible);
  EXPECT_EQ(target.restore(forged(good, sizes + 1, 33)), SnapshotError::implausible);
  const auto residue = ByteReader(std::span(good).subspan(4 * (sizes + 2))).u32();
  EXPECT_EQ(target.restore(forged(good, sizes + 3, residue)), SnapshotError::implausible)
      << "two equal turning points";
}

TEST(Alternation, NeighboursDifferAndDirectionsAlternate) {
  const auto accepted = [](std::vector<double> points_N) {
    Alternation alternation;
    std::size_t count = 0;
    for (const Tension point : newtons(points_N)) {
      if (!alternation.next(point)) {
        break;
      }
      ++count;
    }
    return count;
  };
  EXPECT_EQ(accepted({10, 90, 20, 80, 30}), 5u);
  EXPECT_EQ(accepted({90, 10, 80, 20, 70}), 5u);
  EXPECT_EQ(accepted({10, 10}), 1u);
  EXPECT_EQ(accepted({10, 90, 90}), 2u);
  EXPECT_EQ(accepted({10, 90, 95}), 2u);
  EXPECT_EQ(accepted({90, 10, 5}), 2u);
  EXPECT_EQ(accepted({10, 90, 20, 15}), 3u);
  EXPECT_EQ(accepted({90, 10, 80, 85}), 3u);
  EXPECT_EQ(accepted({10, 90, 20, 80, 81}), 4u);
  // What was refused is forgotten.
  Alternation alternation;
  EXPECT_TRUE(alternation.empty());
  EXPECT_TRUE(alternation.next(newtons(10)));
  EXPECT_FALSE(alternation.empty());
  EXPECT_TRUE(alternation.next(newtons(90)));
  EXPECT_TRUE(alternation.rising());
  EXPECT_FALSE(alternation.next(newtons(95)));
  EXPECT_TRUE(alternation.next(newtons(20)));
  EXPECT_FALSE(alternation.rising());
}

/// Residue 10, 90, 20, 80 and waiting 30, 70, 40; each point moved so that two steps go one way.
TEST(Snapshot, TurningPointsThatDoNotAlternateAreRefused) {
  using One = Estimator<1>;
  One counted({parameters_of(paper_constants())});
  for (const double tension_N : {10.0, 90.0, 20.0, 80.0, 30.0}) {
    counted.push(0, newtons(tension_N));
  }
  counted.flush(0);
  for (const double tension_N : {70.0, 40.0, 60.0}) {
    counted.push(0, newtons(tension_N));
  }
  std::vector<std::byte> good(One::kSnapshotBytes);
  good.resize(counted.snapshot(good).size());
  const std::size_t first = good.size() / 4 - 1 - 7;
  const std::vector<double> points_N = {10, 90, 20, 80, 30, 70, 40};
  for (std::size_t i = 0; i < points_N.size(); ++i) {
    ASSERT_EQ(ByteReader(std::span(good).subspan(4 * (first + i))).u32(),
              static_cast<std::uint32_t>(newtons(points_N[i]).raw()));
  }
  ASSERT_EQ(One({parameters_of(paper_constants())}).restore(good), SnapshotError::none);
  const auto with = [&](std::size_t point, double tension_N) {
    const auto raw = static_cast<std::uint32_t>(newtons(tension_N).raw());
    return One({parameters_of(paper_constants())}).restore(forged(good, first + point, raw));
  };
  // In ranges that do not grow: 90, 85, 80.
  EXPECT_EQ(with(2, 85), SnapshotError::implausible);
  EXPECT_EQ(with(3, 15), SnapshotError::implausible);
  // Among those that wait, where any range may follow.
  EXPECT_EQ(with(4, 85), SnapshotError::implausible);
  EXPECT_EQ(with(5, 25), SnapshotError::implausible);
  EXPECT_EQ(with(6, 75), SnapshotError::implausible);
  EXPECT_EQ(with(6, 70), SnapshotError::implausible);
  // And before the candidate, 60.
  EXPECT_EQ(with(6, 65), SnapshotError::implausible);
}

TEST(Snapshot, AnotherModelIsTakenUpOnlyWhenAllowed) {
  const auto good = some_snapshot();
  auto constants = paper_constants();
  constants.model_digest = 77;
  constants.ipl_scale = 2e5;
  const Parameters p = parameters_of(constants);
  Two target({p, p});
  EXPECT_EQ(target.restore(good), SnapshotError::other_model);
  EXPECT_EQ(target.reading(0).total, Damage{});
  EXPECT_EQ(target.restore(good, ModelChange::allow), SnapshotError::none);
  EXPECT_GT(target.reading(0).total, Damage{});
}

}  // namespace
}  // namespace lifemodel
