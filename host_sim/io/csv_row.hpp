#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace host_sim {

/// A line of CSV (RFC 4180) that is put together field by field.
class CsvRow {
 public:
  /// Text in quotes where it needs them, made printable.
  void add(std::string_view text);
  void add(const char* text) { add(std::string_view(text)); }
  void add(std::unsigned_integral auto count) { fields_.push_back(std::to_string(count)); }
  /// The shortest decimal that reads back as `value`; nothing for NaN, `inf` for infinity.
  void add(double value);
  /// Empty fields until there are `count`.
  void fill_to(std::size_t count) { fields_.resize(count); }

  /// With the end of the line.
  [[nodiscard]] std::string line() const;

 private:
  std::vector<std::string> fields_;
};

/// The header line of these columns.
std::string csv_head(std::span<const std::string_view> columns);

}  // namespace host_sim
