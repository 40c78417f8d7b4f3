#include "host_sim/verbs/columns.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/files/profile_columns.hpp"
#include "hal/files/text.hpp"
#include "host_sim/command_line/options.hpp"

namespace host_sim {

using hal::files::ColumnMap;
using hal::files::ColumnOptions;
using hal::files::in_quotes;

namespace {

std::string problem_of_map(const std::string& text) {
  try {
    hal::files::column_map(text);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return {};
}

/// @throws CLI::ValidationError
void check_line_by_line(const std::vector<ColumnMap>& maps) {
  for (auto map = maps.begin(); map != maps.end(); ++map) {
    if (map->rate) {
      throw CLI::ValidationError("--column",
                                 "rate() is for host_sim import columns, which has the whole file");
    }
    const auto same = [&](const ColumnMap& before) {
      return before.channel == map->channel || before.column == map->column;
    };
    if (std::find_if(maps.begin(), map, same) != map) {
      throw CLI::ValidationError(
          "--column", std::string(hal::files::profile_columns()[map->channel].name) + " or " +
                          in_quotes(map->column) +
                          " a second time; accepted: each channel and each column once");
    }
  }
}

}  // namespace

CLI::Option* add_column(CLI::App& verb, std::vector<ColumnMap>& maps) {
  return command_line::one_at_a_time(
             verb.add_option_function<std::vector<std::string>>(
                 "--column",
                 [&maps](const std::vector<std::string>& texts) {
                   maps.clear();
                   std::transform(texts.begin(), texts.end(), std::back_inserter(maps),
                                  hal::files::column_map);
                 },
                 "Takes a column of the file as a channel: force=input_tension_N, or 't in "
                 "ms=time_s', '-2*F+3=output_tension_N'; once for each channel"))
      ->type_name("COLUMN=CHANNEL")
      ->check(CLI::Validator(problem_of_map, ""));
}

CLI::Option* add_map(CLI::App& verb, std::vector<ColumnMap>& maps) {
  const auto as_column = [](const std::string& text) {
    const std::size_t equals = text.find('=');
    return equals == std::string::npos ? text
                                       : text.substr(equals + 1) + "=" + text.substr(0, equals);
  };
  return command_line::one_at_a_time(
             verb.add_option_function<std::vector<std::string>>(
                 "--map",
                 [&maps, as_column](const std::vector<std::string>& texts) {
                   for (const std::string& text : texts) {
                     maps.push_back(hal::files::column_map(as_column(text)));
                   }
                 },
                 "The same the other way round: input_tension_N=force, 'output_tension_N=-2*F+3'"))
      ->type_name("CHANNEL=COLUMN")
      ->check(CLI::Validator(
          [as_column](const std::string& text) {
            return text.find('=') == std::string::npos
                       ? hal::files::in_quotes(text) +
                             ": no = behind a channel; accepted: "
                             "CHANNEL=COLUMN, with COLUMN as --column "
                             "takes it"
                       : problem_of_map(as_column(text));
          },
          ""));
}

void add_columns(CLI::App& verb, ColumnOptions& columns) {
  columns.given_by_options = true;
  add_column(verb, columns.maps);
  verb.add_flag("--ignore-extra", columns.ignore_extra,
                "Columns that are no channels are passed over");
  verb.parse_complete_callback([&columns] { check_line_by_line(columns.maps); });
}

}  // namespace host_sim
