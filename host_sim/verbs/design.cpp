#include "host_sim/design/design.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/command_line/options.hpp"
#include "host_sim/design/study.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/report/design/html.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

using command_line::above;
using command_line::in_range;
using design::Unknown;

/// The command line of `design`.
struct DesignArguments {
  std::string model;
  std::string find;
  std::optional<double> bend_angle_deg;
  std::optional<double> friction_coefficient;
  std::optional<double> tension_N;
  std::optional<double> tension_min_N;
  std::optional<double> load_ratio;
  std::optional<double> diameter_mm;
  std::optional<double> ultimate_tension_N;
  std::optional<double> life_cycles;
  std::optional<double> life_hours;
  std::optional<double> cycles_per_minute;
  std::optional<double> risk;
  design::TestRequest test;
  std::string json;
  std::string table;
  std::string report;

  [[nodiscard]] std::array<std::string, 3> outputs() const { return {json, table, report}; }
  [[nodiscard]] bool has_life() const { return life_cycles || life_hours; }
};

[[noreturn]] void refuse_design(const std::string& why) {
  throw CLI::ValidationError("design", why);
}

/// What is solved for: what --find says, or what of tension and life is not given.
Unknown unknown_of(const DesignArguments& arguments) {
  if (!arguments.find.empty()) {
    const auto names = design::unknown_names();
    return static_cast<Unknown>(std::ranges::find(names, arguments.find) - names.begin());
  }
  if (arguments.tension_N && arguments.has_life()) {
    refuse_design(
        "nothing is unknown: leave out --tension or --life, or say by --find what else is wanted");
  }
  if (!arguments.tension_N && !arguments.has_life()) {
    refuse_design("tension and life are both unknown: give --tension or --life");
  }
  return arguments.tension_N ? Unknown::life : Unknown::tension;
}

void check_unknown(const DesignArguments& arguments, Unknown unknown) {
  const std::array<std::pair<Unknown, std::pair<bool, const char*>>, 6> given{
      {{Unknown::life, {arguments.has_life(), "--life"}},
       {Unknown::tension, {arguments.tension_N.has_value(), "--tension"}},
       {Unknown::bend, {arguments.bend_angle_deg.has_value(), "--bend-angle"}},
       {Unknown::friction, {arguments.friction_coefficient.has_value(), "--friction"}},
       {Unknown::wire,
        {arguments.diameter_mm || arguments.ultimate_tension_N,
         "--diameter or --ultimate-tension"}},
       {Unknown::risk, {arguments.risk.has_value(), "--risk"}}}};
  for (const auto& [what, option] : given) {
    if (what == unknown && option.first) {
      refuse_design(fmt::format("--find {}: {} gives it", arguments.find, option.second));
    }
  }
  if (unknown != Unknown::tension && !arguments.tension_N) {
    refuse_design(
        fmt::format("--find {}: the tension is unknown as well: give --tension", arguments.find));
  }
  if (unknown != Unknown::life && !arguments.has_life()) {
    refuse_design(
        fmt::format("--find {}: the life is unknown as well: give --life", arguments.find));
  }
  if (arguments.tension_N && arguments.tension_min_N &&
      *arguments.tension_min_N > *arguments.tension_N) {
    refuse_design(fmt::format("--tension-min: {} N is above --tension, {} N",
                              *arguments.tension_min_N, *arguments.tension_N));
  }
}

/// What the options say, and of the rest the model.
design::Request request_of(const DesignArguments& arguments, const Model& model) {
  design::Request request;
  request.unknown = unknown_of(arguments);
  check_unknown(arguments, request.unknown);
  design::Tendon& tendon = request.tendon;
  tendon.bend_angle_deg = arguments.bend_angle_deg.value_or(model.sheath.bend_angle_deg);
  tendon.friction_coefficient =
      arguments.friction_coefficient.value_or(model.sheath.friction_coefficient);
  tendon.diameter_mm = arguments.ultimate_tension_N
                           ? design::diameter_of(model, *arguments.ultimate_tension_N)
                           : arguments.diameter_mm.value_or(model.cable.diameter_mm);
  tendon.output_max_N = arguments.tension_N.value_or(0);
  tendon.output_min_N =
      arguments.tension_min_N.value_or(arguments.load_ratio.value_or(1) * tendon.output_max_N);
  if (!arguments.tension_min_N) {
    request.load_ratio = arguments.load_ratio.value_or(1);
  }
  request.risk = arguments.risk.value_or(request.risk);
  request.life_cycles = arguments.life_hours
                            ? *arguments.life_hours * 60 * arguments.cycles_per_minute.value_or(0)
                            : arguments.life_cycles.value_or(0);
  return request;
}

int run_design(const DesignArguments& arguments) {
  check_files("design", {.reads = {{"--model", arguments.model}},
                         .writes = {{"--json", arguments.json},
                                    {"--table", arguments.table},
                                    {"--report", arguments.report}},
                         .fills = {}});
  const Model model = read_model(arguments.model);
  const design::Design found = design::solve(model, request_of(arguments, model));
  const design::Study study = design::study(model, found, arguments.test);
  const design::Telling telling{model_digest(model), arguments.cycles_per_minute};
  auto json = open_if_asked(arguments.json);
  auto table = open_if_asked(arguments.table);
  auto report = open_if_asked(arguments.report);
  if (json) {
    json->write(design::design_json(study, telling));
  }
  if (table) {
    table->write(design::design_table(model, study));
  }
  if (report) {
    write_design_report(report->stream(), model, study, telling, kProgramVersion);
  }
  commit_all({&json, &table, &report});
  std::ostream& summary = summary_stream(arguments.outputs());
  design::write_design(summary, study, telling);
  write_next(summary, arguments.report.empty()
                          ? "--report design.html draws this"
                          : "host_sim plan --help: how many specimens prove it");
  return 0;
}

void add_load(CLI::App& verb, DesignArguments& arguments) {
  verb.add_option("--tension", arguments.tension_N,
                  "Highest tension at the output of the sheath over a cycle, in N")
      ->check(in_range(design::kLeastTension_N, 1e6));
  CLI::Option* least =
      verb.add_option("--tension-min", arguments.tension_min_N,
                      "Lowest tension there, in N; without it the tension is constant")
          ->check(in_range(0.0, 1e6));
  verb.add_option("--load-ratio", arguments.load_ratio, "Or the lowest over the highest")
      ->check(in_range(0.0, 1.0))
      ->excludes(least);
}

void add_tendon(CLI::App& verb, DesignArguments& arguments) {
  verb.add_option("--bend-angle", arguments.bend_angle_deg,
                  "Total bend of the sheath in degrees; that of the model without it")
      ->check(in_range(0.0, design::kMostBend_deg));
  verb.add_option("--friction", arguments.friction_coefficient,
                  "Friction coefficient; that of the model without it")
      ->check(in_range(0.0, 1.0));
  CLI::Option* diameter =
      verb.add_option("--diameter", arguments.diameter_mm,
                      "Diameter in mm of a wire like that of the model, which is taken without it")
          ->check(in_range(0.01, design::kThickestWire_mm));
  verb.add_option("--ultimate-tension", arguments.ultimate_tension_N,
                  "Or the tension in N that tears this wire")
      ->check(in_range(1.0, 1e6))
      ->excludes(diameter);
}

void add_life(CLI::App& verb, DesignArguments& arguments) {
  CLI::Option* life =
      verb.add_option("--life", arguments.life_cycles, "Wanted life in cycles")->check(above(0));
  CLI::Option* rate =
      verb.add_option("--cycles-per-minute", arguments.cycles_per_minute, "For a life in hours")
          ->check(above(0));
  verb.add_option("--life-hours", arguments.life_hours, "Or the wanted life in hours")
      ->check(above(0))
      ->needs(rate)
      ->excludes(life);
  verb.add_option("--risk", arguments.risk,
                  "Share of the wires that may break within that life; 0.1 (B10) without it")
      ->check(command_line::number_that<double>([](double value) { return value > 0 && value < 1; },
                                                "BETWEEN 0 AND 1", "above 0 and below 1"));
}

}  // namespace

void add_design(CLI::App& app, int& status) {
  auto arguments = std::make_shared<DesignArguments>();
  CLI::App* verb = app.add_subcommand(
      "design", "What tension, bend, friction or wire a wanted life allows, or the life of these");
  verb->add_option("--model", arguments->model, "The wire, its sheath and the law, a TOML file")
      ->required();
  const auto names = design::unknown_names();
  verb->add_option("--find", arguments->find,
                   "What is solved for; without it tension or life, whichever is not given. Safety "
                   "is by how much all that is given is on the safe side")
      ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
  add_load(*verb, *arguments);
  add_tendon(*verb, *arguments);
  add_life(*verb, *arguments);
  verb->add_option("--test-tension", arguments->test.output_max_N,
                   "Highest output tension in N of an accelerated test of the design")
      ->check(in_range(design::kLeastTension_N, 1e6));
  verb->add_option("--test-bend-angle", arguments->test.bend_angle_deg,
                   "Total bend in degrees of that test")
      ->check(in_range(0.0, design::kMostBend_deg));
  verb->add_option("--json", arguments->json, "Write the result as JSON; - is standard output");
  verb->add_option("--table", arguments->table,
                   "Write the design and life over tension for several bend angles as CSV");
  verb->add_option("--report", arguments->report, "Write a page with plots as HTML");
  verb->footer(
      "Example: host_sim design --model host_sim/examples/upper_arm.toml --tension 49 --report "
      "design.html\n"
      "         host_sim design --model host_sim/examples/upper_arm.toml --life 1000 "
      "--load-ratio 0.6\n"
      "         host_sim design --model host_sim/examples/upper_arm.toml --tension 49 --life 1000 "
      "--find bend");
  verb->callback([arguments, &status] { status = run_design(*arguments); });
}

}  // namespace host_sim
