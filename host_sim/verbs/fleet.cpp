#include <CLI/CLI.hpp>
#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hal/files/input_file.hpp"
#include "host_sim/command_line/options.hpp"
#include "host_sim/fleet/fleet_plan.hpp"
#include "host_sim/fleet/fleet_table.hpp"
#include "host_sim/fleet/horizon.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

struct FleetArguments {
  std::string table;
  std::string model;
  std::string horizon = "90d";
  std::string today;
  std::string out_table;
  std::string json;
  std::string calendar;
  fleet::PlanRequest request;

  [[nodiscard]] std::array<std::string, 3> outputs() const { return {out_table, json, calendar}; }
  [[nodiscard]] VerbFiles files(const std::vector<std::filesystem::path>& models) const {
    VerbFiles files{.reads = {{"TABLE", table}, {"--model", model}},
                    .writes = {{"--table", out_table}, {"--json", json}, {"--calendar", calendar}},
                    .fills = {}};
    for (const NamedPath& read : named("TABLE", models)) {
      files.reads.push_back(read);
    }
    return files;
  }
};

fleet::Date today_of(const std::string& text) {
  if (text.empty()) {
    return std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  }
  const auto date = fleet::parse_date(text);
  if (!date) {
    throw CLI::ValidationError(
        "--today", "'" + text + "' is none; accepted: " + std::string(fleet::kDateAccepted));
  }
  return *date;
}

/// What the command line says of time and probability. @throws CLI::ValidationError
void read_request(FleetArguments& arguments) {
  fleet::PlanRequest& request = arguments.request;
  request.today = today_of(arguments.today);
  const auto horizon = fleet::parse_horizon(arguments.horizon, request.today);
  if (!horizon) {
    throw CLI::ValidationError("--horizon", "'" + arguments.horizon + "' is none; accepted: " +
                                                std::string(fleet::kHorizonAccepted));
  }
  request.horizon = *horizon;
}

int run_fleet(FleetArguments& arguments) {
  read_request(arguments);
  check_files("fleet", arguments.files({}));
  const auto rows = fleet::parse_fleet_table(
      hal::files::open_source(arguments.table, "a CSV file of tendons"), arguments.table);
  check_files("fleet", arguments.files(fleet::models_of(rows, arguments.table)));
  const fleet::Fleet tendons = fleet::fleet_of(rows, arguments.table, arguments.model);
  auto table = open_if_asked(arguments.out_table);
  auto json = open_if_asked(arguments.json);
  auto calendar = open_if_asked(arguments.calendar);
  const fleet::FleetPlan plan = fleet::make_plan(tendons, arguments.request);
  if (table) {
    table->write(fleet::plan_table(tendons, plan));
  }
  if (json) {
    json->write(fleet::plan_json(tendons, arguments.request, plan));
  }
  if (calendar) {
    calendar->write(fleet::plan_calendar(tendons, arguments.request, plan));
  }
  commit_all({&table, &json, &calendar});
  fleet::write_plan(summary_stream(arguments.outputs()), arguments.table, tendons,
                    arguments.request, plan);
  return 0;
}

constexpr double kLeastShare = 1e-6;

}  // namespace

void add_fleet(CLI::App& app, int& status) {
  auto arguments = std::make_shared<FleetArguments>();
  CLI::App* verb = app.add_subcommand(
      "fleet", "When which tendon is to be replaced, and how many spares it takes");
  verb->add_option("TABLE", arguments->table,
                   "The tendons, a CSV file: damage so far, damage per hour, hours per day")
      ->required();
  verb->add_option("--model", arguments->model,
                   "The life model of tendons that name none, a TOML file");
  verb->add_option("--horizon", arguments->horizon,
                   "How far ahead: 90d, 12w, 6m, 2000h of operation, or a date")
      ->type_name("TIME")
      ->capture_default_str();
  verb->add_option("--service", arguments->request.service,
                   "Probability with which the spares are to be enough")
      ->check(command_line::in_range(kLeastShare, 1 - kLeastShare))
      ->capture_default_str();
  verb->add_option("--risk", arguments->request.risk,
                   "Replace when the risk of a break since today is this")
      ->check(command_line::in_range(kLeastShare, 0.99))
      ->capture_default_str();
  verb->add_option("--today", arguments->today,
                   "The day of the table, YYYY-MM-DD; else the clock's")
      ->type_name("DATE");
  verb->add_option("--table", arguments->out_table, "Write a row for each tendon as CSV");
  verb->add_option("--json", arguments->json, "Write the plan as JSON; - is standard output");
  verb->add_option("--calendar", arguments->calendar,
                   "Write the dates to replace within the horizon as a calendar, iCalendar");
  verb->add_option("--threads", arguments->request.threads,
                   "How many threads; all cores without it. The result does not depend on it")
      ->check(command_line::in_range(1U, kMostThreads));
  verb->footer(
      "Example: host_sim fleet host_sim/examples/fleet/tendons.csv --model "
      "host_sim/examples/upper_arm.toml --horizon 90d --service 0.95 --today 2026-03-02");
  verb->callback([arguments, &status] { status = run_fleet(*arguments); });
}

}  // namespace host_sim
