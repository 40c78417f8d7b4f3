#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace host_sim {

/// A number for people, as UTF-8: rounded to `significant` digits (1..17), thousands grouped,
/// powers of ten outside 1e-3..1e6; "unlimited" for infinity and "not defined" for NaN.
[[nodiscard]] std::string number_text(double value, int significant = 3);

/// A whole number in full, thousands grouped.
[[nodiscard]] std::string count_text(std::uint64_t value);

/// A count with its noun, which takes an s unless there is one; rounded from a thousand million on.
[[nodiscard]] std::string counted_text(std::uint64_t value, std::string_view noun);

/// `number_text` with its unit; the unit is left out when the value is not finite or it is empty.
[[nodiscard]] std::string quantity_text(double value, std::string_view unit, int significant = 3);

/// A fraction of 1 as a percentage. A fraction that is not 0 or 1 never reads as 0 % or 100 %.
[[nodiscard]] std::string percent_text(double fraction);

/// A span of time in the largest fitting unit from seconds to years (of 365.25 days).
[[nodiscard]] std::string duration_text(double duration_s);

/// A p-value: "0.12", "below 0.001", "not computed".
[[nodiscard]] std::string p_text(double p);

}  // namespace host_sim
