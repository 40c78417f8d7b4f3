#include "host_sim/command_line/value.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "host_sim/command_line/type_names.hpp"

namespace host_sim::command_line {
namespace {

constexpr std::string_view kText = "TEXT";

/// TYPE:CHECK:CHECK, as CLI11 describes it.
std::pair<std::string, std::string> type_and_checks(const std::string& description) {
  // An address such as HOST:PORT is a type of its own.
  for (const char* type : {"TEXT", "UINT", "INT", "FLOAT"}) {
    const std::string head = std::string(type) + ":";
    if (description.rfind(head, 0) == 0) {
      return {type, description.substr(head.size())};
    }
  }
  return {description, ""};
}

/// The words of {a,b,c}, the check of CLI::IsMember.
std::vector<std::string> choices_of(const std::string& checks) {
  if (checks.size() < 2 || checks.front() != '{' || checks.back() != '}') {
    return {};
  }
  return CLI::detail::split(checks.substr(1, checks.size() - 2), ',');
}

/// The range of "INT in [1 - 127]", the check of CLI::Range.
std::optional<std::string> range_in_words(const std::string& check) {
  const std::size_t begin = check.find(" in [");
  const std::size_t middle = check.find(" - ", begin);
  if (begin == std::string::npos || middle == std::string::npos || check.back() != ']') {
    return std::nullopt;
  }
  const std::size_t low = begin + 5;
  const std::string high = check.substr(middle + 3, check.size() - middle - 4);
  return fmt::format("{} to {}", check.substr(low, middle - low), high);
}

std::string in_words(const std::string& checks) {
  if (auto range = range_in_words(checks)) {
    return *range;
  }
  if (checks == "POSITIVE") {
    return "above 0";
  }
  if (checks == "NONNEGATIVE") {
    return "0 or more";
  }
  constexpr std::string_view kAbove = "ABOVE ";
  return checks.rfind(kAbove, 0) == 0 ? "above " + checks.substr(kAbove.size()) : std::string();
}

ValueKind kind_of(const std::string& name) {
  if (name == kFile) {
    return ValueKind::file;
  }
  if (name == kFolder) {
    return ValueKind::folder;
  }
  return name == kInterface ? ValueKind::interface : ValueKind::other;
}

std::string name_for_people(const std::string& type, bool choice) {
  if (type == kText) {
    return choice ? "NAME" : kFile;
  }
  return type == "UINT" || type == "INT" || type == "FLOAT" ? "NUMBER" : type;
}

}  // namespace

Value value_of(const CLI::Option& option) {
  const auto [type, checks] = type_and_checks(option.get_type_name());
  Value value;
  value.choices = choices_of(checks);
  value.name = name_for_people(type, !value.choices.empty());
  value.kind = value.choices.empty() ? kind_of(value.name) : ValueKind::choice;
  value.accepted = in_words(checks);
  value.preset = option.get_default_str();
  value.separator = option.get_delimiter();
  if (option.get_positional()) {
    value.name = option.get_name(true);
  }
  return value;
}

}  // namespace host_sim::command_line
