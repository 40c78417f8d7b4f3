#include "host_sim/compare/compare.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>

#include "hal/files/interruption.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/report/compare/html.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

/// The command line of `compare`.
struct CompareArguments {
  std::array<std::string, 2> sides;
  std::string profile;
  std::string model;
  std::string json;
  std::string report;

  [[nodiscard]] std::array<std::string, 2> outputs() const { return {json, report}; }
};

[[noreturn]] void refuse_compare(const std::string& why) {
  throw CLI::ValidationError("compare", why);
}

bool is_model(const std::string& path) {
  return path.ends_with(".toml");
}

/// Whether the two are models; refuses what does not go together.
bool of_models(const CompareArguments& arguments) {
  const auto& [a, b] = arguments.sides;
  const bool models = is_model(a);
  if (models != is_model(b)) {
    refuse_compare(
        fmt::format("{} is a model and {} is a profile; accepted: two models (*.toml) "
                    "with --profile, or two profiles with --model",
                    models ? a : b, models ? b : a));
  }
  if (models && !arguments.model.empty()) {
    refuse_compare("--model is for two profiles; accepted: two models with --profile");
  }
  if (!models && !arguments.profile.empty()) {
    refuse_compare("--profile is for two models (*.toml); accepted: two profiles with --model");
  }
  if (models && arguments.profile.empty()) {
    refuse_compare("--profile is required: the profile whose life the two models give");
  }
  if (!models && arguments.model.empty()) {
    refuse_compare("--model is required: the model that gives the life of the two profiles");
  }
  for (const std::string& path : {a, b, arguments.profile}) {
    if (path == "-") {
      refuse_compare(
          "standard input is no profile to compare, as it is read more than once; "
          "accepted: files");
    }
  }
  return models;
}

compare::Replayed replayed_of(const std::string& profile, const std::string& model) {
  return {profile, model, read_extended_model(model)};
}

int run_compare(const CompareArguments& arguments) {
  const bool models = of_models(arguments);
  const auto& [a, b] = arguments.sides;
  check_files("compare", {.reads = {{"A", a},
                                    {"B", b},
                                    {"--profile", arguments.profile},
                                    {"--model", arguments.model}},
                          .writes = {{"--json", arguments.json}, {"--report", arguments.report}},
                          .fills = {}});
  const compare::Comparison comparison =
      compare::compare(models ? replayed_of(arguments.profile, a) : replayed_of(a, arguments.model),
                       models ? replayed_of(arguments.profile, b) : replayed_of(b, arguments.model),
                       models, hal::files::stop_if_interrupted);
  auto json = open_if_asked(arguments.json);
  auto report = open_if_asked(arguments.report);
  if (json) {
    json->write(compare::compare_json(comparison));
  }
  if (report) {
    write_compare_report(report->stream(), comparison, kProgramVersion);
  }
  commit_all({&json, &report});
  std::ostream& summary = summary_stream(arguments.outputs());
  compare::write_compare(summary, comparison);
  write_next(summary, arguments.report.empty() ? "--report compare.html draws this"
                                               : "host_sim replay --help: one of them in detail");
  return 0;
}

}  // namespace

void add_compare(CLI::App& app, int& status) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* verb = app.add_subcommand(
      "compare", "Two models or two profiles: which lets a wire live longer, and what differs");
  verb->add_option("A", arguments->sides[0], "A model (*.toml), or a profile as replay reads it")
      ->required();
  verb->add_option("B", arguments->sides[1], "Another of the same kind")->required();
  verb->add_option("--profile", arguments->profile,
                   "Of two models: the profile that both are replayed with");
  verb->add_option("--model", arguments->model,
                   "Of two profiles: the model that both are replayed with, a TOML file");
  verb->add_option("--json", arguments->json, "Write the result as JSON; - is standard output");
  verb->add_option("--report", arguments->report, "Write a page with plots as HTML");
  verb->footer(
      "Example: host_sim init model --out other.toml\n"
      "         host_sim compare host_sim/examples/upper_arm.toml other.toml --profile "
      "host_sim/examples/upper_arm.csv --report compare.html\n"
      "         head -n 6001 host_sim/examples/upper_arm.csv > half.csv\n"
      "         host_sim compare host_sim/examples/upper_arm.csv half.csv --model "
      "host_sim/examples/upper_arm.toml");
  verb->callback([arguments, &status] { status = run_compare(*arguments); });
}

}  // namespace host_sim
