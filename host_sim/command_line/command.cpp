#include "host_sim/command_line/command.hpp"

#include <CLI/CLI.hpp>

#include "host_sim/command_line/value.hpp"

namespace host_sim::command_line {
namespace {

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
