#include "host_sim/verbs/outcome.hpp"

#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <set>

#include "host_sim/command_line/options.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

using hal::files::OutputFile;

namespace {

constexpr const char* kAny = "any";

constexpr int kSomeRefused = 1;

void write_table(OutputFile& file, std::string_view head,
                 const std::vector<batch::Answer>& answers) {
  file.write(head);
  for (const batch::Answer& answer : answers) {
    file.write(answer.row);
  }
}

void write_json(OutputFile& file, std::string_view key, const std::vector<batch::Answer>& answers) {
  file.write(fmt::format("{{\"{}\":[", key));
  const char* before = "\n";
  for (const batch::Answer& answer : answers) {
    file.write(before);
    file.write(answer.json);
    before = ",\n";
  }
  file.write("\n]}\n");
}

bool is_error(const batch::Answer& answer) {
  return !answer.error.empty();
}

}  // namespace

CLI::Option* add_fail_on(CLI::App& verb, std::vector<std::string>& fail_on,
                         std::vector<std::string> names, const std::string& description) {
  names.emplace_back(kAny);
  return command_line::one_at_a_time(verb.add_option("--fail-on", fail_on, description))
      ->delimiter(',')
      ->check(CLI::IsMember(names));
}

bool fails_on(const std::vector<std::string>& fail_on, const std::vector<std::string>& found) {
  return std::any_of(found.begin(), found.end(), [&](const std::string& name) {
    return std::find(fail_on.begin(), fail_on.end(), name) != fail_on.end() ||
           std::find(fail_on.begin(), fail_on.end(), kAny) != fail_on.end();
  });
}

void BatchOutputs::open(const std::string& table_path, const std::string& json_path) {
  table = open_if_asked(table_path);
  json = open_if_asked(json_path);
}

void BatchOutputs::write(std::string_view head, std::string_view key,
                         const std::vector<batch::Answer>& answers) {
  if (table) {
    write_table(*table, head, answers);
  }
  if (json) {
    write_json(*json, key, answers);
  }
  commit_all({&table, &json});
}

std::size_t report_errors(const std::vector<batch::Answer>& answers) {
  std::set<std::string_view> reported;
  std::size_t errors = 0;
  for (const batch::Answer& answer : answers) {
    if (is_error(answer)) {
      ++errors;
      if (reported.insert(answer.error).second) {
        fmt::print(std::cerr, "{}\n", answer.error);
      }
    }
  }
  return errors;
}

int status_of(const std::vector<batch::Answer>& answers, const std::vector<std::string>& fail_on) {
  if (std::any_of(answers.begin(), answers.end(), is_error)) {
    return kSomeRefused;
  }
  const bool found = std::any_of(answers.begin(), answers.end(), [&](const batch::Answer& answer) {
    return fails_on(fail_on, answer.found);
  });
  return found ? kFoundInData : 0;
}

}  // namespace host_sim
