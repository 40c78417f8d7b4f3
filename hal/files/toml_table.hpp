#pragma once

#include <toml++/toml.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hal/files/text.hpp"

namespace hal::files {

/// Parses TOML 1.0; `file` stands for the file in errors.
/// @throws InputError
toml::table parse_toml(std::string_view text, std::string_view file);

/// A value as a message shows it.
std::string describe(const toml::node& node);

/// The shortest digits that read back as this number, and as a float.
/// @pre it is finite
std::string toml_float(double value);

/// A table of a TOML file, for reading values with errors that say where they are.
class TomlTable {
 public:
  /// `name` is that of the table in errors, empty for the whole file, which has no place either.
  TomlTable(std::string_view file, const toml::table& values, std::string name,
            toml::source_position place);

  const std::string& file() const noexcept { return file_; }
  const std::string& name() const noexcept { return name_; }
  const toml::table& values() const noexcept { return *values_; }
  toml::source_position place() const noexcept { return place_; }

  /// Where a key stands; the place of the table if it is not there.
  toml::source_position place_of(std::string_view key) const;

  bool has(std::string_view key) const { return values_->contains(key); }

  /// The value of a key. @throws InputError if it is not there
  const toml::node& node(std::string_view key, std::string_view accepted) const;

  /// A number in its range. @throws InputError
  double number(const NumberKey& key) const;

  /// The same, or `standard` where the key is not there.
  double number_or(const NumberKey& key, double standard) const;

  /// A text that is not empty and has no hidden characters. @throws InputError
  std::string text(std::string_view key) const;

  /// true or false; false where the key is not there. @throws InputError
  bool flag(std::string_view key) const;

  /// A table in this one. @throws InputError where it is no table
  TomlTable table(std::string_view key) const;

  /// The tables of an array of tables. @throws InputError where it is not there or holds others
  std::vector<TomlTable> tables(std::string_view key, std::string_view accepted) const;

  /// Throws InputError for a key that is neither one of `numbers` nor of `others`, with a hint
  /// where it has the name of a number but for its unit.
  void refuse_unknown_keys(std::span<const NumberKey> numbers,
                           std::span<const std::string_view> others) const;

  [[noreturn]] void fail(toml::source_position at, std::string_view found,
                         std::string_view accepted) const;

 private:
  [[noreturn]] void fail_unknown(const toml::key& found, std::span<const NumberKey> numbers,
                                 std::span<const std::string_view> others) const;
  std::string in_table() const;
  std::string name_of(std::string_view key) const;

  std::string file_;
  const toml::table* values_;
  std::string name_;
  toml::source_position place_;
};

}  // namespace hal::files
