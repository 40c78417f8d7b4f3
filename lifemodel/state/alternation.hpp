#pragma once

#include "lifemodel/quantity/units.hpp"

namespace lifemodel {

/// Checks that points are turning points: neighbours differ and directions alternate.
class Alternation {
 public:
  constexpr bool next(Tension point) {
    if (count_ != 0) {
      const bool rising = point > last_;
      if (point == last_ || (count_ > 1 && rising == rising_)) {
        return false;
      }
      rising_ = rising;
    }
    last_ = point;
    count_ += count_ < 2 ? 1 : 0;
    return true;
  }
  [[nodiscard]] constexpr bool empty() const { return count_ == 0; }
  /// Precondition: at least two points.
  [[nodiscard]] constexpr bool rising() const { return rising_; }

 private:
  int count_ = 0;
  Tension last_;
  bool rising_ = false;
};

}  // namespace lifemodel
