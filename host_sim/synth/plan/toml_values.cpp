#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/synth/plan/tables.hpp"

namespace host_sim::synth {

using hal::files::describe;
using hal::files::NumberKey;
using hal::files::range_text;
using hal::files::TomlTable;

namespace {

constexpr std::size_t kLongestList = 10'000;

std::string accepted_list(const NumberKey& key) {
  return fmt::format("{} {}, or a list of such numbers", key.name, range_text(key.range));
}

double number_in_list(const TomlTable& table, const NumberKey& key, const toml::node& node) {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value || !key.range.contains(*value)) {
    table.fail(node.source().begin, fmt::format("{} holds {}", key.name, describe(node)),
               accepted_list(key));
  }
  return *value;
}

}  // namespace

double number_or(const TomlTable& table, const NumberKey& key, double standard) {
  return table.has(key.name) ? table.number(key) : standard;
}

std::size_t whole_or(const TomlTable& table, const NumberKey& key, std::size_t standard) {
  if (!table.has(key.name)) {
    return standard;
  }
  const double value = table.number(key);
  if (value != std::floor(value)) {
    table.fail(table.place_of(key.name), fmt::format("{} is {}", key.name, value),
               fmt::format("a whole number, {}", range_text(key.range)));
  }
  return static_cast<std::size_t>(value);
}

std::vector<double> numbers(const TomlTable& table, const NumberKey& key) {
  const toml::node& node = table.node(key.name, accepted_list(key));
  const toml::array* const array = node.as_array();
  if (array == nullptr) {
    return {table.number(key)};
  }
  if (array->empty() || array->size() > kLongestList) {
    table.fail(table.place_of(key.name), fmt::format("{} has {} numbers", key.name, array->size()),
               fmt::format("1..{} numbers", kLongestList));
  }
  std::vector<double> values;
  for (const toml::node& element : *array) {
    values.push_back(number_in_list(table, key, element));
  }
  return values;
}

std::vector<double> numbers_or(const TomlTable& table, const NumberKey& key, double standard) {
  return table.has(key.name) ? numbers(table, key) : std::vector<double>{standard};
}

std::size_t choice_of(const TomlTable& table, std::string_view key,
                      std::span<const std::string_view> names) {
  if (!table.has(key)) {
    return 0;
  }
  const std::string accepted = fmt::format("{} as one of {}", key, fmt::join(names, ", "));
  const toml::node& node = table.node(key, accepted);
  const auto* const text = node.as_string();
  const auto found =
      text == nullptr ? names.end() : std::find(names.begin(), names.end(), text->get());
  if (found == names.end()) {
    table.fail(table.place_of(key), fmt::format("{} is {}", key, describe(node)), accepted);
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<TomlTable> tables(const TomlTable& above, std::string_view key) {
  return above.has(key) ? above.tables(key, fmt::format("tables [[{}.{}]]", above.name(), key))
                        : std::vector<TomlTable>();
}

}  // namespace host_sim::synth
