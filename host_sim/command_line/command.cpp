#include "host_sim/command_line/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>
#include <string_view>
#include <utility>

#include "host_sim/command_line/options.hpp"

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

/// The value of an option or positional, from its type and the checks on it.
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

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& letter : option.get_snames()) {
    names.push_back("-" + letter);
  }
  for (const std::string& word : option.get_lnames()) {
    names.push_back("--" + word);
  }
  return names;
}

Option read_option(const CLI::Option& option) {
  const bool has_value = option.get_items_expected_max() > 0;
  return {.names = names_of(option),
          .description = option.get_description(),
          .environment = option.get_envname(),
          .has_value = has_value,
          .required = option.get_required(),
          .repeats = option.get_items_expected_max() > 1,
          .value = has_value ? value_of(option) : Value{}};
}

}  // namespace

Command read_command(const CLI::App& app) {
  Command command;
  command.name = app.get_name();
  command.description = app.get_description();
  command.footer = app.get_footer();
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional()) {
      command.positionals.push_back({.description = option->get_description(),
                                     .required = option->get_required(),
                                     .repeats = option->get_items_expected_max() > 1,
                                     .value = value_of(*option)});
    } else {
      command.options.push_back(read_option(*option));
    }
  }
  for (const CLI::App* verb : app.get_subcommands({})) {
    command.verbs.push_back(read_command(*verb));
  }
  return command;
}

}  // namespace host_sim::command_line
