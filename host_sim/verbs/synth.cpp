#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "host_sim/command_line/options.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/synth/campaign/folder.hpp"
#include "host_sim/synth/campaign/make.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

struct SynthArguments {
  std::string plan;
  std::string out;
  std::string truth;
  std::string json;
  std::uint64_t seed = 1;
  unsigned threads = 0;
  bool force = false;

  [[nodiscard]] std::array<std::string, 2> outputs() const { return {truth, json}; }
};

synth::Truth make(const SynthArguments& arguments, const synth::SynthPlan& plan,
                  const synth::StagedFolder& folder) {
  Progress progress("synth");
  std::mutex mutex;
  synth::MakeOptions options{arguments.seed, arguments.threads, {}};
  options.progress = [&](double share) {
    const std::lock_guard lock(mutex);
    progress.update_share(share);
  };
  return synth::make_campaign(plan, options, folder.inside());
}

std::string json_text(const SynthArguments& arguments, const synth::SynthPlan& plan,
                      const synth::Truth& truth, const std::string& digest) {
  const nlohmann::ordered_json json{{"campaign", arguments.out},
                                    {"name", plan.name},
                                    {"seed", arguments.seed},
                                    {"sessions", truth.settings.size()},
                                    {"specimens", plan.lives ? plan.lives->specimens() : 0},
                                    {"truth_sha256", digest}};
  return json.dump(2) + "\n";
}

int run(const SynthArguments& arguments) {
  check_files("synth", {.reads = {{"--plan", arguments.plan}},
                        .writes = {{"--truth", arguments.truth}, {"--json", arguments.json}},
                        .fills = {{"--out", arguments.out}}});
  const synth::SynthPlan plan = synth::read_synth_plan(arguments.plan);
  auto truth_file = open_if_asked(arguments.truth);
  auto json = open_if_asked(arguments.json);
  synth::StagedFolder folder(arguments.out, arguments.force);
  const synth::Truth truth = make(arguments, plan, folder);
  const std::string text = synth::truth_json(plan, arguments.seed, truth);
  const std::string digest = synth::sha256(text);
  if (truth_file) {
    truth_file->write(text);
  }
  if (json) {
    json->write(json_text(arguments, plan, truth, digest));
  }
  folder.commit();
  commit_all({&truth_file, &json});
  std::ostream& summary = summary_stream(arguments.outputs());
  summary << fmt::format("{}: {} recordings, {} specimens\nSHA-256 of the truth: {}\n",
                         arguments.out, truth.settings.size(),
                         plan.lives ? plan.lives->specimens() : 0, digest);
  write_next(summary, "host_sim diagnose " + shell_word(arguments.out));
  return 0;
}

}  // namespace

void add_synth(CLI::App& app, int& status) {
  auto arguments = std::make_shared<SynthArguments>();
  CLI::App* verb = app.add_subcommand(
      "synth", "A campaign by simulation, with effects that are hidden in it as its plan says");
  verb->add_option("--plan", arguments->plan, "What to simulate, a TOML file")->required();
  verb->add_option("--out", arguments->out, "The folder to make")
      ->required()
      ->type_name(command_line::kFolder);
  verb->add_option("--seed", arguments->seed, "Of the random numbers")->capture_default_str();
  verb->add_option("--truth", arguments->truth,
                   "Write what is hidden as JSON, outside the folder; - is standard output");
  verb->add_option("--json", arguments->json, "Write the result as JSON; - is standard output");
  verb->add_flag("--force", arguments->force, "Replace a campaign that stands there");
  verb->add_option("--threads", arguments->threads,
                   "0 is one for each core; the files do not depend on it")
      ->check(command_line::in_range(0, 1024))
      ->capture_default_str();
  verb->footer(
      "Example: host_sim synth --plan host_sim/examples/synth/crossed.toml --out crossed "
      "--truth crossed.truth.json --seed 7");
  verb->callback([arguments, &status] { status = run(*arguments); });
}

}  // namespace host_sim
