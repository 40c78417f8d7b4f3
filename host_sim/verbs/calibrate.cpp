#include <CLI/CLI.hpp>
#include <memory>

#include "host_sim/calibrate/output/output.hpp"
#include "host_sim/command_line/numbers.hpp"
#include "host_sim/command_line/type_names.hpp"
#include "host_sim/recording/recording.hpp"
#include "host_sim/verbs/calibrate_arguments.hpp"
#include "host_sim/verbs/fail_on.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

constexpr std::size_t kMostBootstraps = 10'000'000;

void add_outputs(CLI::App& verb, CalibrateArguments& arguments) {
  verb.add_option("--out", arguments.out,
                  "Write the model with the fitted life, which replay and pack read");
  verb.add_option("--json", arguments.json, "Write the result as JSON; - is standard output");
  verb.add_option("--report", arguments.report, "Write a page with plots as HTML");
}

void add_batch(CLI::App& verb, CalibrateArguments& arguments) {
  CLI::Option* table =
      verb.add_option("--table", arguments.table, "Write one row for each campaign as CSV");
  CLI::Option* batch = verb.add_flag("--batch", arguments.batch,
                                     "CAMPAIGN is a folder of campaigns; under mpirun its ranks "
                                     "share them, where the program was built with MPI")
                           ->needs(table)
                           ->excludes("--out")
                           ->excludes("--report");
  table->needs(batch);
}

void add_computation(CLI::App& verb, CalibrateArguments& arguments) {
  verb.add_option("--seed", arguments.seed, "Of all random numbers")->capture_default_str();
  verb.add_option("--bootstraps", arguments.bootstraps, "Replicates for p-values and bands")
      ->check(command_line::in_range(std::size_t{1}, kMostBootstraps))
      ->capture_default_str();
  verb.add_option("--threads", arguments.threads,
                  "How many threads; all cores without it. The result does not depend on it")
      ->check(command_line::in_range(1U, kMostThreads));
  verb.add_option("--use-tension", arguments.use_tensions_N,
                  "Effective tensions in N that the life is wanted for")
      ->delimiter(',')
      ->check(command_line::above(0));
  verb.add_flag("--keep-all-levels", arguments.keep_all_levels,
                "Fit the law also to levels whose shape is not that of the others");
}

}  // namespace

calibrate::CalibrateOptions CalibrateArguments::options() const {
  calibrate::CalibrateOptions options;
  options.seed = seed;
  options.bootstraps = bootstraps;
  options.threads = threads;
  options.keep_all_levels = keep_all_levels;
  options.use_tensions_N = use_tensions_N;
  return options;
}

VerbFiles CalibrateArguments::files(std::span<const std::string> campaigns) const {
  VerbFiles files{
      .reads = {},
      .writes = {{"--out", out}, {"--json", json}, {"--report", report}, {"--table", table}},
      .fills = {}};
  for (const std::string& campaign : campaigns) {
    for (const NamedPath& read : named("CAMPAIGN", recording::files_of_campaign(campaign))) {
      files.reads.push_back(read);
    }
  }
  return files;
}

void add_calibrate(CLI::App& app, int& status) {
  auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* verb = app.add_subcommand("calibrate", "The life model from specimens run to failure");
  verb->add_option("CAMPAIGN", arguments->folder,
                   "Folder with campaign.toml, specimens.csv and, for loads in blocks, blocks.csv")
      ->required()
      ->type_name(command_line::kFolder);
  add_outputs(*verb, *arguments);
  add_batch(*verb, *arguments);
  add_computation(*verb, *arguments);
  add_fail_on(*verb, arguments->fail_on, calibrate::all_findings(),
              "Exit with status 3 if one of these is found: a level left out, one shape rejected, "
              "the law rejected, a validation level that differs");
  verb->footer(
      "Example: host_sim calibrate host_sim/examples/tendon_alt --out model.toml --report "
      "calibration.html");
  verb->callback([arguments, &status] {
    // The campaigns of a batch are listed later.
    const std::span<const std::string> alone(&arguments->folder, arguments->batch ? 0 : 1);
    check_files("calibrate", arguments->files(alone));
    status = arguments->batch ? calibrate_batch(*arguments) : calibrate_one(*arguments);
  });
}

}  // namespace host_sim
