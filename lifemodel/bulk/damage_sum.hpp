#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/damage/damage.hpp"

namespace lifemodel::bulk {

/// A sum of the damage of cycles, the same as Damage::add() of each, by one addition for each: the
/// mantissas of each position by themselves. For up to 2^32 cycles, below 2^24 lives.
class DamageSum {
 public:
  /// `lane` may be any number: neighbouring additions to different ones do not wait for each other.
  void add(unsigned lane, CycleDamage cycle) {
    const int below = std::max(-cycle.position, 0);
    const auto place = static_cast<std::size_t>(std::max(cycle.position, 0));
    sums_[lane % kSums][place] += cycle.mantissa >> below;
  }

  [[nodiscard]] Damage total() const {
    Damage result;
    for (std::size_t place = 0; place < kPositions; ++place) {
      std::uint64_t sum = 0;
      for (const auto& sums : sums_) {
        sum += sums[place];
      }
      Flags flags;  // stays empty: see above
      const auto position = static_cast<std::int32_t>(place);
      for (const auto& [word, at] :
           {CycleDamage{static_cast<std::uint32_t>(sum), position},
            CycleDamage{static_cast<std::uint32_t>(sum >> 32), position + 32}}) {
        if (word != 0) {
          result.add({word, at}, flags);
        }
      }
    }
    return result;
  }

 private:
  static constexpr std::size_t kPositions = static_cast<std::size_t>(kWholeLife.position) + 1;
  static constexpr std::size_t kSums = 4;
  std::array<std::array<std::uint64_t, kPositions>, kSums> sums_{};
};

}  // namespace lifemodel::bulk
