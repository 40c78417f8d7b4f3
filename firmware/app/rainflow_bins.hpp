#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "lifemodel/damage/damage.hpp"
#include "lifemodel/quantity/units.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace app {

/// Closed cycles by range and mean, in eighths of the ultimate tension. The highest range class is
/// open above, the lowest mean class open below and the highest open above. Each bin stops at its
/// highest value.
class RainflowBins {
 public:
  static constexpr std::uint32_t kClasses = 8;
  static constexpr std::uint32_t kBins = kClasses * kClasses;

  void count(lifemodel::Tension from, lifemodel::Tension to) {
    auto& bin = bins_[range_class(from, to) * kClasses + mean_class(from, to)];
    const std::uint32_t cycles = bin.own();
    bin.set_relaxed(cycles + (cycles != std::numeric_limits<std::uint32_t>::max() ? 1u : 0u));
  }
  /// While another context counts, too. Precondition: bin < kBins; its range class is bin /
  /// kClasses, its mean class bin % kClasses.
  [[nodiscard]] std::uint32_t cycles(std::uint32_t bin) const { return bins_[bin].relaxed(); }

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
  static constexpr std::uint32_t kEighth = 1u << (lifemodel::Tension::kFractionBits - 3);
  std::array<lifemodel::SharedWord<std::uint32_t>, kBins> bins_{};
};

/// Fills the bins of one tendon while cycles are counted.
struct BinCycles {
  RainflowBins* bins;
  void full(lifemodel::Tension from, lifemodel::Tension to, lifemodel::CycleDamage) const {
    bins->count(from, to);
  }
  void half(lifemodel::Tension, lifemodel::Tension, lifemodel::CycleDamage) const {}
};

}  // namespace app
