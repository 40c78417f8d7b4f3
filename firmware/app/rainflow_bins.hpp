#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/saturating.hpp"

namespace app {

/// Closed cycles by range and mean, in eighths of the ultimate tension. The highest range class is
/// open above, the lowest mean class open below and the highest open above. Each bin stops at its
/// highest value.
///
/// All bins together are the closed cycles of the last reading. Some of those are not counted for
/// good yet and come again, with the next reading or when they are.
class RainflowBins {
 public:
  static constexpr std::uint32_t kClasses = 8;
  static constexpr std::uint32_t kBins = kClasses * kClasses;

  /// A cycle that is counted for good.
  void count(lifemodel::Tension from, lifemodel::Tension to) { add(counted_, from, to); }
  /// A reading begins: count_read() follows for each cycle that it counts for good or has besides.
  void begin_reading() { read_ = counted_; }
  void count_read(lifemodel::Tension from, lifemodel::Tension to) { add(read_, from, to); }

  /// At the last reading. The range class of a bin is bin / kClasses, its mean class bin %
  /// kClasses.
  /// @pre bin < kBins
  [[nodiscard]] std::uint32_t cycles(std::uint32_t bin) const { return read_[bin]; }

  static constexpr std::uint32_t range_class(lifemodel::Tension from, lifemodel::Tension to) {
    const std::uint32_t eighths = lifemodel::distance(from, to).raw() / kEighth;
    return eighths < kClasses ? eighths : kClasses - 1;
  }
  static constexpr std::uint32_t mean_class(lifemodel::Tension from, lifemodel::Tension to) {
    const std::int32_t mean = from.raw() / 2 + to.raw() / 2;
    if (mean < 0) {
      return 0;
    }
    const std::uint32_t eighths = static_cast<std::uint32_t>(mean) / kEighth;
    return eighths < kClasses ? eighths : kClasses - 1;
  }

 private:
  using Bins = std::array<std::uint32_t, kBins>;
  static constexpr std::uint32_t kEighth = 1u << (lifemodel::Tension::kFractionBits - 3);

  static void add(Bins& bins, lifemodel::Tension from, lifemodel::Tension to) {
    std::uint32_t& bin = bins[range_class(from, to) * kClasses + mean_class(from, to)];
    bin = lifemodel::saturating_add(bin, 1);
  }

  Bins counted_{};
  Bins read_{};
};

/// Fills the bins of one tendon while cycles are counted.
struct BinCycles {
  RainflowBins* bins;
  void full(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage) const {
    bins->count(from, to);
  }
  void half(lifemodel::Tension, lifemodel::Tension, lifemodel::CycleDamage) const {}
};

/// Fills them with the cycles of a reading, after begin_reading().
struct BinReadCycles {
  RainflowBins* bins;
  bool for_good;
  void full(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage) const {
    if (for_good) {
      bins->count(from, to);
    }
    bins->count_read(from, to);
  }
  void half(lifemodel::Tension, lifemodel::Tension, lifemodel::CycleDamage) const {}
};

}  // namespace app
