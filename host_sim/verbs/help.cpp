#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hal/files/text.hpp"
#include "host_sim/command_line/unknown_word.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

/// What is wrong with the word, and what was meant or would be accepted.
std::string complaint_about(const command_line::UnknownWord& unknown) {
  const std::string what = hal::files::in_quotes(unknown.word);
  const std::string of = unknown.path.empty() ? "host_sim" : unknown.path;
  std::string text = unknown.is_option() ? fmt::format("{} has no option {}", of, what)
                                         : fmt::format("{} is no verb of {}", what, of);
  if (unknown.nearest) {
    return text + fmt::format("; did you mean '{}'?", *unknown.nearest);
  }
  return text + fmt::format("; accepted: {}", fmt::join(unknown.known, ", "));
}

/// The help of the verb that the words name, or of the program. @throws CLI::ValidationError
std::string help_of(const CLI::App& app, std::span<const std::string> words) {
  if (const auto unknown = command_line::first_unknown(command_line::read_command(app), words)) {
    throw CLI::ValidationError(complaint_about(*unknown));
  }
  const CLI::App* verb = &app;
  std::string before;
  for (const std::string& word : words) {
    if (verb->get_subcommands({}).empty()) {
      throw CLI::ValidationError(fmt::format("{} has no verbs of its own", verb->get_name()));
    }
    before += (before.empty() ? "" : " ") + verb->get_name();
    verb = verb->get_subcommand(word);
  }
  // The program itself would give the help of the verb that runs.
  return words.empty()
             ? app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal)
             : verb->help(before);
}

void add_names(const CLI::App& app, std::vector<std::string>& names) {
  for (const CLI::App* verb : app.get_subcommands({})) {
    names.push_back(verb->get_name());
    add_names(*verb, names);
  }
}

}  // namespace

std::string usage_failure(const CLI::App& app, std::span<const std::string> words,
                          const CLI::Error& error) {
  const auto kind = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (kind == CLI::ExitCodes::ExtrasError || kind == CLI::ExitCodes::RequiredError) {
    if (const auto unknown = command_line::first_unknown(command_line::read_command(app), words)) {
      return complaint_about(*unknown) + "\nRun with --help for more information.\n";
    }
  }
  return CLI::FailureMessage::simple(&app, error);
}

void add_help(CLI::App& app, int&) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = app.add_subcommand("help", "The help of a verb, as its --help");
  std::vector<std::string> names;
  add_names(app, names);
  // The names are for completion and the manual; which of them follow one another, help_of() knows.
  verb->add_option("VERB", *words, "The verb, and its own verb where it has some")
      ->expected(0, 2)
      ->check(CLI::Validator([](const std::string&) { return std::string(); },
                             fmt::format("{{{}}}", fmt::join(names, ","))));
  verb->footer(
      "Example: host_sim help replay\n"
      "         host_sim help import columns");
  verb->callback([&app, words] { std::cout << help_of(app, *words); });
}

}  // namespace host_sim
