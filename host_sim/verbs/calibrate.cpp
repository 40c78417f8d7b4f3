#include "host_sim/calibrate/calibrate.hpp"

#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "hal/files/text.hpp"
#include "host_sim/calibrate/output/output.hpp"
#include "host_sim/campaign/campaign.hpp"
#include "host_sim/campaign/nominal_model.hpp"
#include "host_sim/command_line/options.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/recording/recording.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/report/calibrate/html.hpp"
#include "host_sim/verbs/outcome.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

using hal::files::InputError;
using hal::files::printable;
using hal::files::stop_if_interrupted;

namespace {

namespace fs = std::filesystem;

/// The command line of `calibrate`.
struct CalibrateArguments {
  std::string folder;
  std::string out;
  std::string json;
  std::string report;
  std::string table;
  bool batch = false;
  std::uint64_t seed = 1;
  std::size_t bootstraps = 10'000;
  unsigned threads = 0;
  std::vector<double> use_tensions_N;
  bool keep_all_levels = false;
  std::vector<std::string> fail_on;

  [[nodiscard]] std::array<std::string, 4> outputs() const { return {out, json, report, table}; }
  /// @param campaigns that are read
  [[nodiscard]] VerbFiles files(std::span<const std::string> campaigns) const;
  [[nodiscard]] calibrate::CalibrateOptions options() const;
};

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

calibrate::CalibrateResult with_progress(const Campaign& campaign,
                                         const CalibrateArguments& arguments) {
  Progress progress("calibrate");
  std::mutex mutex;
  calibrate::CalibrateOptions options = arguments.options();
  options.progress = [&](double share) {
    stop_if_interrupted();
    const std::lock_guard lock(mutex);
    progress.update_share(share);
  };
  return calibrate::calibrate(campaign, options);
}

/// A model that replay and the packer read.
std::string checked_model(const Campaign& campaign, const calibrate::CalibrateResult& result,
                          const std::string& path) {
  std::string text = calibrate::model_text(campaign, result, kProgramVersion);
  parameters_of(parse_model(text, path), path);
  return text;
}

/// One campaign. @return the exit status @throws InputError, OutputError, Interruption
int calibrate_one(const CalibrateArguments& arguments) {
  const Campaign campaign = read_campaign(arguments.folder);
  if (!arguments.out.empty()) {
    require_nominal_model(campaign);
  }
  auto out = open_if_asked(arguments.out);
  auto json = open_if_asked(arguments.json);
  auto page = open_if_asked(arguments.report);

  const calibrate::CalibrateResult result = with_progress(campaign, arguments);
  if (out) {
    out->write(checked_model(campaign, result, arguments.out));
  }
  if (json) {
    json->write(calibrate::calibrate_json(result));
  }
  if (page) {
    write_calibrate_report(page->stream(), result, kProgramVersion);
  }
  commit_all({&out, &json, &page});
  std::ostream& summary = summary_stream(arguments.outputs());
  calibrate::write_summary(summary, result);
  write_next(summary, arguments.out.empty()
                          ? "--out model.toml writes the fitted model"
                          : fmt::format("host_sim diagnose {} finds what the law leaves out; "
                                        "host_sim replay PROFILE --model {}",
                                        shell_word(arguments.folder), shell_word(arguments.out)));
  return fails_on(arguments.fail_on, calibrate::found_in(result)) ? kFoundInData : 0;
}

std::string name_of(const std::string& folder) {
  return fs::path(folder).filename().string();
}

std::vector<std::string> folders_of(const std::string& folder) {
  std::vector<std::string> folders;
  for (const fs::path& campaign : list_campaigns(folder)) {
    folders.push_back(campaign.string());
  }
  if (folders.empty()) {
    throw InputError(folder, 0, 0, "no campaign in it",
                     "a folder of folders that hold a campaign.toml");
  }
  return folders;
}

batch::Answer calibrated(const std::string& folder, const calibrate::CalibrateOptions& options) {
  const std::string name = name_of(folder);
  const calibrate::CalibrateResult result = calibrate::calibrate(read_campaign(folder), options);
  std::string object = calibrate::calibrate_json(result, -1);
  object.pop_back();
  return {calibrate::table_row(name, result),
          fmt::format("{{\"folder\":{},\"result\":{}}}", nlohmann::json(printable(name)).dump(),
                      object),
          {},
          calibrate::found_in(result)};
}

batch::Answer refused(const std::string& folder, const std::string& error) {
  const std::string name = name_of(folder);
  const nlohmann::ordered_json object{{"folder", printable(name)}, {"error", error}};
  return {calibrate::refused_row(name, error), object.dump(), error, {}};
}

int report(const CalibrateArguments& arguments, BatchOutputs& outputs,
           const std::vector<batch::Answer>& answers) {
  outputs.write(calibrate::table_head(), "campaigns", answers);
  const std::size_t errors = report_errors(answers);
  std::ostream& summary = summary_stream(arguments.outputs());
  fmt::print(summary, "{}: {} campaigns calibrated, {} refused\n", printable(arguments.folder),
             answers.size() - errors, errors);
  write_next(summary, "host_sim calibrate CAMPAIGN --report fit.html draws one of them");
  return status_of(answers, arguments.fail_on);
}

/// All campaigns of a folder, by all ranks. The same.
int calibrate_batch(const CalibrateArguments& arguments) {
  batch::Ranks ranks;
  BatchOutputs outputs;
  batch::Batch batch;
  batch.label = "calibrate";
  batch.threads = arguments.threads;
  batch.list = [&] {
    std::vector<std::string> folders = folders_of(arguments.folder);
    check_files("calibrate", arguments.files(folders));
    outputs.open(arguments.table, arguments.json);
    return folders;
  };
  batch.work = [options = arguments.options()](const std::string& folder,
                                               const batch::Means& means) {
    calibrate::CalibrateOptions own = options;
    own.threads = means.threads;
    own.progress = means.progress;
    return calibrated(folder, own);
  };
  batch.refuse = [](const std::string& folder, const std::exception& error) {
    return refused(folder, batch::error_line(error, folder));
  };
  batch.report = [&](const std::vector<batch::Answer>& answers) {
    return report(arguments, outputs, answers);
  };
  return run_batch(ranks, batch);
}

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
