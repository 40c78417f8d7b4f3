#include "firmware/boards/linux/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "host_sim/io/input_error.hpp"
#include "host_sim/io/printable.hpp"

namespace board {

std::string described(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& value) {
    if constexpr (toml::is_string<decltype(value)>) {
      text << host_sim::in_quotes(value.get());
    } else if constexpr (toml::is_table<decltype(value)>) {
      text << "a table";
    } else if constexpr (toml::is_array<decltype(value)>) {
      text << "an array";
    } else {
      text << value;
    }
  });
  return text.str();
}

TomlTable::TomlTable(std::string_view file, std::string title, const toml::table& table,
                     std::initializer_list<std::string_view> keys)
    : file_(file), title_(std::move(title)), table_(table) {
  for (const auto& [key, node] : table_) {
    if (std::find(keys.begin(), keys.end(), key.str()) == keys.end()) {
      refuse(key.str(), fmt::format("unknown key {} in {}", host_sim::in_quotes(key.str()), title_),
             fmt::format("{}", fmt::join(keys, ", ")));
    }
  }
}

toml::source_position TomlTable::place(std::string_view key) const {
  const auto found = table_.find(key);
  return found == table_.end() ? table_.source().begin : found->first.source().begin;
}

void TomlTable::refuse(std::string_view key, std::string_view found,
                       std::string_view accepted) const {
  const toml::source_position at = place(key);
  throw host_sim::InputError(file_, at.line, at.column, found, accepted);
}

void TomlTable::refuse(std::string_view key, std::string_view accepted) const {
  refuse(key, fmt::format("{} is {}", key, described(*table_.get(key))), accepted);
}

const toml::node& TomlTable::node(std::string_view key, std::string_view accepted) const {
  const toml::node* const found = table_.get(key);
  if (found == nullptr) {
    refuse(key, fmt::format("no key {} in {}", key, title_), accepted);
  }
  return *found;
}

std::string TomlTable::text(std::string_view key, std::string_view accepted) const {
  const auto* const value = node(key, accepted).as_string();
  if (value == nullptr || value->get().empty() || value->get().find('\0') != std::string::npos) {
    refuse(key, accepted);
  }
  return value->get();
}

std::string TomlTable::text_or(std::string_view key, std::string_view accepted,
                               std::string_view otherwise) const {
  return has(key) ? text(key, accepted) : std::string(otherwise);
}

std::size_t TomlTable::choice(std::string_view key,
                              std::span<const std::string_view> choices) const {
  const std::string accepted = fmt::format("{} \"{}\"", key, fmt::join(choices, "\", \""));
  const std::string value = text(key, accepted);
  const auto found = std::find(choices.begin(), choices.end(), value);
  if (found == choices.end()) {
    refuse(key, accepted);
  }
  return static_cast<std::size_t>(found - choices.begin());
}

double TomlTable::number(std::string_view key, NumberRange range) const {
  const std::string accepted = fmt::format("{} {}..{}", key, range.minimum, range.maximum);
  const toml::node& found = node(key, accepted);
  const auto value = found.is_number() ? found.value<double>() : std::nullopt;
  if (!value || !(*value >= range.minimum && *value <= range.maximum)) {
    refuse(key, accepted);
  }
  return *value;
}

double TomlTable::number_or(std::string_view key, NumberRange range, double otherwise) const {
  return has(key) ? number(key, range) : otherwise;
}

int TomlTable::integer(std::string_view key, int minimum, int maximum) const {
  const std::string accepted = fmt::format("{} {}..{}, a whole number", key, minimum, maximum);
  const auto* const value = node(key, accepted).as_integer();
  if (value == nullptr || value->get() < minimum || value->get() > maximum) {
    refuse(key, accepted);
  }
  return static_cast<int>(value->get());
}

int TomlTable::integer_or(std::string_view key, int minimum, int maximum, int otherwise) const {
  return has(key) ? integer(key, minimum, maximum) : otherwise;
}

TomlTable TomlTable::table(std::string_view key,
                           std::initializer_list<std::string_view> keys) const {
  const std::string accepted = fmt::format("a table [{}]", key);
  const auto* const found = node(key, accepted).as_table();
  if (found == nullptr) {
    refuse(key, accepted);
  }
  return {file_, fmt::format("[{}]", key), *found, keys};
}

}  // namespace board
