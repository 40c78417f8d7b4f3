#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace hal::files {

/// `text` as one line that is safe on a terminal: control characters, line separators, characters
/// that change the writing direction or are invisible, and bytes that are not UTF-8 become `\xNN`
/// (`\n`, `\r`, `\t` by name). At most `limit` characters of the input are kept; `...` marks a cut.
std::string printable(std::string_view text, std::size_t limit = std::string_view::npos);

/// `'text'`, printable and at most 40 characters long: for quoting a value in a message.
std::string in_quotes(std::string_view text);

/// Number of UTF-8 characters in `text`; a byte that does not continue a character counts as one.
std::size_t character_count(std::string_view text);

/// Reads the decimal number at `position`, correctly rounded; a leading `+` is accepted. Moves
/// `position` behind it and returns true, or returns false if there is no number or if a double
/// cannot hold it. `inf` and `nan` are read as such: check the value.
bool parse_number(const char*& position, const char* end, double& value);

/// If `name` differs from `known` by its unit suffix alone, that suffix (empty if it has none),
/// e.g. `kN` for `input_tension_kN` against `input_tension_N` with the unit `N`. A known name
/// without a unit has the empty `unit`.
std::optional<std::string_view> other_unit(std::string_view name, std::string_view known,
                                           std::string_view unit);

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

}  // namespace hal::files
