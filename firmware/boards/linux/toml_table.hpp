#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace board {

/// A number that a key takes, ends included.
struct NumberRange {
  double minimum;
  double maximum;
};

/// A table of a TOML file, of which every key is known. Everything throws host_sim::InputError with
/// file, line and column, what was found and what is accepted.
class TomlTable {
 public:
  /// `title` is the table in errors, e.g. `[can]`. Refuses keys other than `keys`.
  TomlTable(std::string_view file, std::string title, const toml::table& table,
            std::initializer_list<std::string_view> keys);

  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

  /// A text that is not empty. `accepted` says in an error what the key takes.
  [[nodiscard]] std::string text(std::string_view key, std::string_view accepted) const;
  [[nodiscard]] std::string text_or(std::string_view key, std::string_view accepted,
                                    std::string_view otherwise) const;
  /// The place of the text among `choices`.
  [[nodiscard]] std::size_t choice(std::string_view key,
                                   std::span<const std::string_view> choices) const;
  [[nodiscard]] double number(std::string_view key, NumberRange range) const;
  [[nodiscard]] double number_or(std::string_view key, NumberRange range, double otherwise) const;
  [[nodiscard]] int integer(std::string_view key, int minimum, int maximum) const;
  [[nodiscard]] int integer_or(std::string_view key, int minimum, int maximum, int otherwise) const;

  /// The table at a key.
  [[nodiscard]] TomlTable table(std::string_view key,
                                std::initializer_list<std::string_view> keys) const;
  [[nodiscard]] const toml::node& node(std::string_view key, std::string_view accepted) const;

  /// Refuses what stands at `key`.
  [[noreturn]] void refuse(std::string_view key, std::string_view accepted) const;
  /// Refuses `key` itself, for the reason `found`.
  [[noreturn]] void refuse(std::string_view key, std::string_view found,
                           std::string_view accepted) const;

  [[nodiscard]] std::string_view file() const { return file_; }

 private:
  [[nodiscard]] toml::source_position place(std::string_view key) const;

  std::string_view file_;
  std::string title_;
  const toml::table& table_;
};

/// What a node holds, for errors: its value, `a table` or `an array`.
std::string described(const toml::node& node);

}  // namespace board
