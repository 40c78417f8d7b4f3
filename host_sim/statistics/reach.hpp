#pragma once

#include <algorithm>
#include <cmath>

namespace host_sim::statistics {

/// How far below and above a value lies what several causes leave possible that err on their own:
/// their reaches add up in squares, each side for itself.
struct Reach {
  double below = 0;
  double above = 0;

  /// @param one,other where a cause takes the value at the ends of its own interval
  void add(double value, double one, double other) {
    below = std::hypot(below, std::max(0.0, value - std::min(one, other)));
    above = std::hypot(above, std::max(0.0, std::max(one, other) - value));
  }
};

}  // namespace host_sim::statistics
