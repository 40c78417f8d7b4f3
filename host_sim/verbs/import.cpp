#include "host_sim/recording/import.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "hal/files/input_file.hpp"
#include "hal/files/profile_columns.hpp"
#include "host_sim/command_line/options.hpp"
#include "host_sim/io/compressed.hpp"
#include "host_sim/recording/import_columns.hpp"
#include "host_sim/verbs/columns.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

namespace {

constexpr const char* kDavinciExample =
    "Example: host_sim import davinci Tool_4_Maryland_L_4.csv --out davinci";
constexpr const char* kColumnsExample =
    "A channel is made as [-][FACTOR*]COLUMN[ in UNIT][+OFFSET]=CHANNEL; rate(COLUMN[ in UNIT]) "
    "is\n"
    "differentiated by time. A column that holds more than letters, digits and _ stands in double\n"
    "quotes. What has the name of a channel is taken as it, other columns are passed over.\n"
    "Example: host_sim import columns host_sim/examples/upper_arm.csv --out drive "
    "--column 1.5*output_tension_N+2=input_tension_N";

struct ImportArguments {
  std::vector<std::string> files;
  std::string out;
  recording::DavinciOptions davinci;
  recording::ColumnsOptions columns;
  bool two_sided = false;
};

void check(const ImportArguments& arguments) {
  std::vector<NamedPath> reads;
  for (const std::string& file : arguments.files) {
    reads.push_back({"FILE", file});
  }
  check_files("import", {.reads = reads, .writes = {}, .fills = {{"--out", arguments.out}}});
}

/// The name of the file without those of its format and its compression.
std::string session_of(const std::filesystem::path& file) {
  const std::filesystem::path extension = file.extension();
  return (extension == ".gz" || extension == ".zst" ? file.stem() : file.filename())
      .stem()
      .string();
}

void write(const recording::RecordedCampaign& campaign, const std::string& folder) {
  recording::write_campaign(campaign, folder);
  const auto count = [](std::size_t number, const char* what) {
    return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
  };
  std::cerr << folder << ": " << count(campaign.recordings.size(), "session")
            << (campaign.passed_over > 0
                    ? ", " + count(campaign.passed_over, "row") + " without a value passed over"
                    : "")
            << "\n";
  write_next(std::cerr, "host_sim diagnose " + shell_word(folder));
}

void import_davinci(const ImportArguments& arguments) {
  check(arguments);
  const std::string& file = arguments.files.front();
  write(recording::import_davinci(open_input(file, "a CSV file of the da Vinci cable transmission"),
                                  hal::files::file_name(file), arguments.davinci),
        arguments.out);
}

void import_columns(const ImportArguments& arguments) {
  if (const std::string conflict = conflict_of(arguments.columns); !conflict.empty()) {
    throw CLI::ValidationError("--column", "needs " + conflict);
  }
  check(arguments);
  recording::RecordedCampaign campaign;
  const std::filesystem::path out = std::filesystem::path(arguments.out + "/.").lexically_normal();
  campaign.campaign_toml =
      recording::unknown_campaign(out.parent_path().filename().string(), arguments.two_sided);
  for (const std::string& file : arguments.files) {
    recording::import_columns(open_input(file, "a table with a line of names"),
                              hal::files::file_name(file), session_of(file), arguments.columns,
                              campaign);
  }
  write(campaign, arguments.out);
}

CLI::App* add_source(CLI::App& verb, ImportArguments& arguments, const char* name, const char* text,
                     const char* footer) {
  CLI::App* source = verb.add_subcommand(name, text);
  source->add_option("FILE", arguments.files, "The measurements, a CSV file; - is standard input")
      ->required();
  source->add_option("--out", arguments.out, "The campaign folder to write")
      ->required()
      ->type_name(command_line::kFolder);
  source->footer(footer);
  return source;
}

}  // namespace

void add_import(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand("import", "A campaign folder from measurements of others");
  verb->require_subcommand(1);
  verb->footer(kDavinciExample);
  auto arguments = std::make_shared<ImportArguments>();

  CLI::App* davinci = add_source(
      *verb, *arguments, "davinci",
      "Torques of a cable transmission, O'Neill et al., RA-L 3(4):3027 (2018)", kDavinciExample);
  davinci->get_option("FILE")->expected(1);
  davinci
      ->add_option("--pulley-radius-mm", arguments->davinci.pulley_radius_mm,
                   "Turns torques into tensions")
      ->check(command_line::in_range(0.1, 1000.0))
      ->capture_default_str();
  davinci->callback([arguments] { import_davinci(*arguments); });

  CLI::App* columns = add_source(*verb, *arguments, "columns",
                                 "Tables of any log; each file is a session", kColumnsExample);
  add_column(*columns, arguments->columns.maps);
  add_map(*columns, arguments->columns.maps);
  columns
      ->add_option("--sample-rate-Hz", arguments->columns.rate_Hz,
                   "Samples per second, where there is no time")
      ->check(command_line::in_range(1e-3, 1e6));
  columns
      ->add_option("--session-column", arguments->columns.session_column,
                   "Rows with the same value in it are a session")
      ->type_name("COLUMN");
  const auto& output = hal::files::profile_columns()[hal::files::kOutputTensionColumn];
  columns
      ->add_option(
          "--dead-load-N", arguments->columns.dead_load_N,
          "What the output carries throughout, where nothing measured it: a weight, or 0 of "
          "a drive that moves nothing")
      ->check(command_line::in_range(output.minimum, output.maximum));
  columns->add_flag("--ignore-missing", arguments->columns.ignore_missing,
                    "Rows in which a column that is taken is empty or nan are passed over");
  columns->add_flag("--two-sided", arguments->two_sided,
                    "The drive works in both directions (antagonistic pair, gear, joint)");
  columns->callback([arguments] { import_columns(*arguments); });
}

}  // namespace host_sim
