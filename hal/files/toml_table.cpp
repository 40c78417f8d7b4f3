#include "hal/files/toml_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/text.hpp"
#include "hal/files/toml_depth.hpp"

namespace hal::files {
namespace {

std::string accepted_text(const NumberKey& key) {
  return fmt::format("{} {}", key.name, range_text(key.range));
}

bool is_known(std::string_view name, std::span<const NumberKey> numbers,
              std::span<const std::string_view> others) {
  return std::any_of(numbers.begin(), numbers.end(),
                     [name](const NumberKey& key) { return key.name == name; }) ||
         std::find(others.begin(), others.end(), name) != others.end();
}

}  // namespace

toml::table parse_toml(std::string_view text, std::string_view file) {
  if (const auto at = TomlDepth(text).first_too_deep()) {
    throw InputError(file, at->line, at->column, fmt::format("more than {} levels", kMostTomlDepth),
                     fmt::format("TOML of at most {} levels", kMostTomlDepth));
  }
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError(file, at.line, at.column, error.description(), "TOML 1.0");
  }
}

std::string describe(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& value) {
    if constexpr (toml::is_string<decltype(value)>) {
      text << in_quotes(value.get());
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

std::string toml_float(double value) {
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

TomlTable::TomlTable(std::string_view file, const toml::table& values, std::string name,
                     toml::source_position place)
    : file_(file), values_(&values), name_(std::move(name)), place_(place) {}

toml::source_position TomlTable::place_of(std::string_view key) const {
  const auto found = values_->find(key);
  return found == values_->end() ? place_ : found->first.source().begin;
}

const toml::node& TomlTable::node(std::string_view key, std::string_view accepted) const {
  const toml::node* const found = values_->get(key);
  if (found == nullptr) {
    fail(place_, fmt::format("no key {}{}", key, in_table()), accepted);
  }
  return *found;
}

double TomlTable::number(const NumberKey& key) const {
  const std::string accepted = accepted_text(key);
  const toml::node& found = node(key.name, accepted);
  const auto value = found.is_number() ? found.value<double>() : std::nullopt;
  if (!value || !key.range.contains(*value)) {
    fail(place_of(key.name), fmt::format("{} is {}", key.name, describe(found)), accepted);
  }
  return *value;
}

double TomlTable::number_or(const NumberKey& key, double standard) const {
  return has(key.name) ? number(key) : standard;
}

std::string TomlTable::text(std::string_view key) const {
  const std::string accepted = fmt::format("{} as a text of visible characters", key);
  const toml::node& found = node(key, accepted);
  const auto* const value = found.as_string();
  if (value == nullptr || value->get().empty() || printable(value->get()) != value->get()) {
    fail(place_of(key), fmt::format("{} is {}", key, describe(found)), accepted);
  }
  return value->get();
}

bool TomlTable::flag(std::string_view key) const {
  if (!has(key)) {
    return false;
  }
  const std::string accepted = fmt::format("{} as true or false", key);
  const toml::node& found = node(key, accepted);
  const auto* const value = found.as_boolean();
  if (value == nullptr) {
    fail(place_of(key), fmt::format("{} is {}", key, describe(found)), accepted);
  }
  return value->get();
}

TomlTable TomlTable::table(std::string_view key) const {
  const std::string name = name_of(key);
  const toml::node* const found = values_->get(key);
  if (found == nullptr) {
    fail(place_, fmt::format("no table [{}]", name), fmt::format("a table [{}]", name));
  }
  if (!found->is_table()) {
    fail(place_of(key), fmt::format("{} is {}", key, describe(*found)),
         fmt::format("a table [{}]", name));
  }
  return {file_, *found->as_table(), name, place_of(key)};
}

std::vector<TomlTable> TomlTable::tables(std::string_view key, std::string_view accepted) const {
  const toml::array* const array = node(key, accepted).as_array();
  if (array == nullptr) {
    fail(place_of(key), fmt::format("{} is {}", key, describe(node(key, accepted))), accepted);
  }
  std::vector<TomlTable> found;
  for (const toml::node& element : *array) {
    if (!element.is_table()) {
      fail(element.source().begin, fmt::format("{} holds {}", key, describe(element)), accepted);
    }
    found.emplace_back(file_, *element.as_table(), name_of(key), element.source().begin);
  }
  return found;
}

std::string TomlTable::name_of(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

void TomlTable::refuse_unknown_keys(std::span<const NumberKey> numbers,
                                    std::span<const std::string_view> others) const {
  for (const auto& [key, node] : *values_) {
    if (!is_known(key.str(), numbers, others)) {
      fail_unknown(key, numbers, others);
    }
  }
}

void TomlTable::fail(toml::source_position at, std::string_view found,
                     std::string_view accepted) const {
  throw InputError(file_, at.line, at.column, found, accepted);
}

void TomlTable::fail_unknown(const toml::key& found, std::span<const NumberKey> numbers,
                             std::span<const std::string_view> others) const {
  std::vector<std::string_view> known;
  for (const NumberKey& key : numbers) {
    if (const auto unit = other_unit(found.str(), key.name, key.unit)) {
      fail(found.source().begin,
           unit->empty()
               ? fmt::format("key {} without its unit", in_quotes(found.str()))
               : fmt::format("unknown unit {} of key {}", in_quotes(*unit), in_quotes(found.str())),
           accepted_text(key));
    }
    known.push_back(key.name);
  }
  known.insert(known.end(), others.begin(), others.end());
  const bool is_table = values_->get(found.str())->is_table();
  fail(found.source().begin,
       fmt::format("unknown {} {}{}", is_table ? "table" : "key", in_quotes(found.str()),
                   in_table()),
       fmt::format("{}", fmt::join(known, ", ")));
}

std::string TomlTable::in_table() const {
  return name_.empty() ? "" : fmt::format(" in [{}]", name_);
}

}  // namespace hal::files
