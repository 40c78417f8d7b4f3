#include "host_sim/io/number_range.hpp"

#include <fmt/format.h>

namespace host_sim {

bool NumberRange::contains(double value) const {
  return value <= maximum && (above_minimum ? value > minimum : value >= minimum);
}

std::string range_text(const NumberRange& range) {
  return range.above_minimum ? fmt::format("above {} up to {}", range.minimum, range.maximum)
                             : fmt::format("{}..{}", range.minimum, range.maximum);
}

}  // namespace host_sim
