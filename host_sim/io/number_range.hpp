#pragma once

#include <string>
#include <string_view>

namespace host_sim {

/// The finite numbers that a value may be.
struct NumberRange {
  double minimum;
  double maximum;
  bool above_minimum = false;  ///< the minimum itself is not allowed

  /// False for what is not a number.
  [[nodiscard]] bool contains(double value) const;
};

/// The range in words, e.g. `0.01..10`, `above 0 up to 1e+300`.
std::string range_text(const NumberRange& range);

/// A number that a file may give by name.
struct NumberKey {
  std::string_view name;
  std::string_view unit;  ///< the suffix of `name`, empty if it has none
  NumberRange range;
};

}  // namespace host_sim
