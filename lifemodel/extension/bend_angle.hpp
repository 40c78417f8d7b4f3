#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

/// Error of the bend angle: mu (phi + delta), with the delta of the pose next in phi.
struct BendAngle {
  static constexpr std::size_t kPoses = 8;
  struct Pose {
    std::int32_t angle = 0;  ///< rad, Q26
    std::int32_t error = 0;
  };
  std::int32_t poses = 0;
  std::array<Pose, kPoses> pose{};

  [[nodiscard]] constexpr bool plausible() const {
    if (poses < 1 || poses > static_cast<std::int32_t>(kPoses)) {
      return false;
    }
    for (const Pose& each : pose) {
      constexpr std::int32_t kMost = 1 << Angle::kFractionBits;
      if (!Angle::checked(each.angle) || each.error < -kMost || each.error > kMost) {
        return false;
      }
    }
    return true;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(poses);
    for (Pose& each : pose) {
      word(each.angle);
      word(each.error);
    }
  }

  [[nodiscard]] constexpr Angle corrected(Angle nominal) const {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(poses); ++i) {
      nearest = away(i, nominal) < away(nearest, nominal) ? i : nearest;
    }
    return Angle::from_raw(
        held(std::int64_t{nominal.raw()} + pose[nearest].error, 0, Angle::highest().raw()));
  }

 private:
  [[nodiscard]] constexpr std::int32_t away(std::size_t i, Angle nominal) const {
    const std::int32_t difference = nominal.raw() - pose[i].angle;
    return difference < 0 ? -difference : difference;
  }
};

}  // namespace lifemodel::extension
