#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "hal/files/output_file.hpp"
#include "hal/files/text.hpp"
#include "host_sim/verbs/assets.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

using hal::files::printable;

namespace {

/// A file to start from.
struct StartFile {
  const char* what;
  std::string_view text;
  const char* next;  ///< with {} for the file, and {1} for its folder
};

const std::array<StartFile, 4>& start_files() {
  static const std::array<StartFile, 4> files{{
      {"model", verb_assets::model_toml, "host_sim replay PROFILE --model {0}"},
      {"campaign", verb_assets::campaign_toml,
       "specimens.csv beside it, or sessions.csv, as it says; then host_sim calibrate {1}, "
       "host_sim "
       "diagnose {1}"},
      {"plan", verb_assets::plan_toml, "host_sim plan --for-diagnosis {0}"},
      {"controller", verb_assets::controller_toml,
       "host_sim pack MODEL --out tendon0.block; then tendonlife_controller --config {0} --check"},
  }};
  return files;
}

struct InitArguments {
  std::string what;
  std::string out;
};

/// What a user has filled in is not written over. @throws OutputError
void require_new(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) {
    throw hal::files::OutputError(path.string(),
                                  "it is there already; accepted: another name after --out");
  }
}

void run_init(const InitArguments& arguments) {
  const auto file = std::ranges::find(start_files(), arguments.what,
                                      [](const StartFile& one) { return std::string(one.what); });
  const std::string path = arguments.out.empty() ? arguments.what + ".toml" : arguments.out;
  check_files("init", {.reads = {}, .writes = {{"--out", path}}, .fills = {}});
  require_new(path);
  hal::files::write_file(path, file->text);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::ostream& summary = summary_stream({&path, 1});
  fmt::print(summary, "{}: every key with its unit, its range and where to take it from\n",
             path == "-" ? file->what + std::string(".toml") : printable(path));
  write_next(summary, fmt::format(fmt::runtime(file->next), path == "-" ? "FILE" : shell_word(path),
                                  folder.empty() ? "." : shell_word(folder.string())));
}

}  // namespace

void add_init(CLI::App& app, int&) {
  auto arguments = std::make_shared<InitArguments>();
  CLI::App* verb = app.add_subcommand("init", "A commented file to start from");
  std::vector<std::string> names;
  for (const StartFile& file : start_files()) {
    names.emplace_back(file.what);
  }
  verb->add_option(
          "WHAT", arguments->what,
          "The model of a tendon; campaign.toml of a campaign; the plan of a campaign, for "
          "plan and synth; or the configuration of tendonlife_controller")
      ->required()
      ->check(CLI::IsMember(names));
  verb->add_option("--out", arguments->out,
                   "Where to write it, nothing is overwritten; WHAT.toml without it; - is standard "
                   "output");
  verb->footer(
      "Example: host_sim init model --out my_wire.toml\n"
      "         host_sim init plan && host_sim plan --for-diagnosis plan.toml");
  verb->callback([arguments] { run_init(*arguments); });
}

}  // namespace host_sim
