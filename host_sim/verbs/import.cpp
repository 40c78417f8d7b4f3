#include "host_sim/recording/import.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "host_sim/command_line/numbers.hpp"
#include "host_sim/command_line/type_names.hpp"
#include "host_sim/io/byte_source.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

constexpr const char* kExample =
    "Example: host_sim import davinci Tool_4_Maryland_L_4.csv --out davinci";

struct ImportArguments {
  std::string file;
  std::string out;
  recording::DavinciOptions options;
};

void run(const ImportArguments& arguments) {
  check_files(
      "import",
      {.reads = {{"FILE", arguments.file}}, .writes = {}, .fills = {{"--out", arguments.out}}});
  const recording::RecordedCampaign campaign = recording::import_davinci(
      open_source(arguments.file, "a CSV file of the da Vinci cable transmission"),
      arguments.file == "-" ? "standard input" : arguments.file, arguments.options);
  recording::write_campaign(campaign, arguments.out);
  std::cerr << arguments.out << ": " << campaign.recordings.size() << " sessions\n";
}

}  // namespace

void add_import(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand("import", "A campaign folder from measurements of others");
  verb->require_subcommand(1);
  verb->footer(kExample);
  auto arguments = std::make_shared<ImportArguments>();
  CLI::App* davinci = verb->add_subcommand(
      "davinci", "Torques of a cable transmission, O'Neill et al., RA-L 3(4):3027 (2018)");
  davinci->add_option("FILE", arguments->file, "The measurements, a CSV file; - is standard input")
      ->required();
  davinci->add_option("--out", arguments->out, "The campaign folder to write")
      ->required()
      ->type_name(command_line::kFolder);
  davinci
      ->add_option("--pulley-radius-mm", arguments->options.pulley_radius_mm,
                   "Turns torques into tensions")
      ->check(command_line::in_range(0.1, 1000.0))
      ->capture_default_str();
  davinci->footer(kExample);
  davinci->callback([arguments] { run(*arguments); });
}

}  // namespace host_sim
