#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/saturating.hpp"

namespace app {

/// Closed cycles and, apart from them, open half cycles by range and mean, in eighths of the
/// ultimate tension. The highest range class is open above, the lowest mean class open below and
/// the highest open above. Each count stops at its highest value.
///
/// All bins together are what the last reading has counted. Some of that is not counted for good
/// yet and comes again, with the next reading or when it is; a half cycle that is not may be in
/// another bin then, or be closed.
class RainflowBins {
 public:
  static constexpr std::uint32_t kClasses = 8;
  static constexpr std::uint32_t kBins = kClasses * kClasses;

  /// What is counted for good.
  void count_full(lifemodel::Tension from, lifemodel::Tension to) {
    increase(counted_.cycles[bin_of(from, to)]);
  }
  void count_half(lifemodel::Tension from, lifemodel::Tension to) {
    increase(counted_.half_cycles[bin_of(from, to)]);
  }
  /// A reading begins: what it counts for good or has besides follows.
  void begin_reading() { read_ = counted_; }
  void read_full(lifemodel::Tension from, lifemodel::Tension to) {
    increase(read_.cycles[bin_of(from, to)]);
  }
  void read_half(lifemodel::Tension from, lifemodel::Tension to) {
    const std::uint32_t bin = bin_of(from, to);
    increase(read_.half_cycles[bin]);
    had_half_[bin / 32] |= std::uint32_t{1} << (bin % 32);
  }

  /// At the last reading. The range class of a bin is bin / kClasses, its mean class bin %
  /// kClasses.
  /// @pre bin < kBins
  [[nodiscard]] std::uint32_t cycles(std::uint32_t bin) const { return read_.cycles[bin]; }
  [[nodiscard]] std::uint8_t half_cycles(std::uint32_t bin) const { return read_.half_cycles[bin]; }
  /// Whether it has a cycle, or has had a half one: who was told of that has to hear that it left.
  [[nodiscard]] bool reported(std::uint32_t bin) const {
    return cycles(bin) != 0 || ((had_half_[bin / 32] >> (bin % 32)) & 1u) != 0;
  }

  static constexpr std::uint32_t range_class(lifemodel::Tension from, lifemodel::Tension to) {
    return std::min(lifemodel::distance(from, to).raw() >> kEighthBits, kClasses - 1);
  }
  static constexpr std::uint32_t mean_class(lifemodel::Tension from, lifemodel::Tension to) {
    const std::int32_t mean = (from.raw() >> 1) + (to.raw() >> 1);
    constexpr std::int32_t kHighest = kClasses - 1;
    return static_cast<std::uint32_t>(std::clamp<std::int32_t>(mean >> kEighthBits, 0, kHighest));
  }

 private:
  struct Counts {
    std::array<std::uint32_t, kBins> cycles{};
    std::array<std::uint8_t, kBins> half_cycles{};
  };
  static constexpr int kEighthBits = lifemodel::Tension::kFractionBits - 3;

  static std::uint32_t bin_of(lifemodel::Tension from, lifemodel::Tension to) {
    return range_class(from, to) * kClasses + mean_class(from, to);
  }
  template <class Count>
  static void increase(Count& count) {
    count = lifemodel::saturating_add(count, 1);
  }

  Counts counted_;
  Counts read_;
  std::array<std::uint32_t, kBins / 32> had_half_{};  ///< a bit each
};

/// Fills the bins of one tendon while cycles are counted.
struct BinCycles {
  RainflowBins* bins;
  void full(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage) const {
    bins->count_full(from, to);
  }
  void half(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage) const {
    bins->count_half(from, to);
  }
};

/// Fills them with the cycles of a reading, after begin_reading().
struct BinReadCycles {
  RainflowBins* bins;
  bool for_good;
  void full(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage) const {
    if (for_good) {
      bins->count_full(from, to);
    }
    bins->read_full(from, to);
  }
  void half(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage) const {
    if (for_good) {
      bins->count_half(from, to);
    }
    bins->read_half(from, to);
  }
};

}  // namespace app
