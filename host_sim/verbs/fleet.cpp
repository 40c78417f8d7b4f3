#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hal/files/input_file.hpp"
#include "host_sim/command_line/options.hpp"
#include "host_sim/fleet/costs.hpp"
#include "host_sim/fleet/fleet_plan.hpp"
#include "host_sim/fleet/fleet_table.hpp"
#include "host_sim/fleet/horizon.hpp"
#include "host_sim/io/compressed.hpp"
#include "host_sim/monitor/tendons/recorded_tendons.hpp"
#include "host_sim/report/fleet/html.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/today.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

struct FleetArguments {
  std::string tendons;
  std::string model;
  std::optional<double> hours_per_day;
  std::optional<double> cost_replacement;
  std::optional<double> cost_break;
  std::string horizon = "90d";
  std::string today;
  std::string out_table;
  std::string json;
  std::string calendar;
  std::string report;
  std::string read_table;
  fleet::PlanRequest request;

  [[nodiscard]] std::array<std::string, 5> outputs() const {
    return {out_table, json, calendar, report, read_table};
  }
  /// @param beside what is read besides the table and the model
  void check(const std::vector<std::filesystem::path>& beside) const {
    VerbFiles files{.reads = {{kTendons, tendons}, {"--model", model}},
                    .writes = {{"--table", out_table},
                               {"--json", json},
                               {"--calendar", calendar},
                               {"--report", report},
                               {"--write-table", read_table}},
                    .fills = {}};
    for (const NamedPath& read : named(kTendons, beside)) {
      files.reads.push_back(read);
    }
    check_files("fleet", files);
  }

  static constexpr const char* kTendons = "TENDONS";
};

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

/// @throws CLI::ValidationError, InputError
monitor::RecordedFleet read_folder(const FleetArguments& arguments) {
  if (!arguments.hours_per_day) {
    throw CLI::ValidationError(
        "fleet", "records do not say how long tendons run each day: give --hours-per-day");
  }
  const auto records = monitor::records_in(arguments.tendons);
  std::vector<std::filesystem::path> logs;
  for (const monitor::Record& record : records) {
    logs.insert(logs.end(), record.logs.begin(), record.logs.end());
  }
  arguments.check(logs);
  return monitor::read_records(arguments.tendons, records, *arguments.hours_per_day,
                               arguments.request.today);
}

/// @throws CLI::ValidationError, InputError
monitor::RecordedFleet read_table(const FleetArguments& arguments) {
  arguments.check({});
  auto rows = fleet::parse_fleet_table(
      open_input(arguments.tendons, "a CSV file of tendons, or a folder of records"),
      arguments.tendons);
  arguments.check(fleet::models_of(rows, arguments.tendons));
  if (arguments.hours_per_day) {
    throw CLI::ValidationError("--hours-per-day", "a table has its own column hours_per_day");
  }
  return {std::move(rows), {}, {}};
}

int run_fleet(FleetArguments& arguments) {
  read_request(arguments);
  const bool of_records = std::filesystem::is_directory(arguments.tendons);
  monitor::RecordedFleet read = of_records ? read_folder(arguments) : read_table(arguments);
  fleet::Fleet tendons = fleet::fleet_of(read.rows, arguments.tendons, arguments.model);
  tendons.broken = read.broken;
  tendons.doubts = read.doubts;
  fleet::set_costs(tendons, arguments.cost_replacement, arguments.cost_break, arguments.tendons);
  auto as_read = open_if_asked(arguments.read_table);
  auto table = open_if_asked(arguments.out_table);
  auto json = open_if_asked(arguments.json);
  auto calendar = open_if_asked(arguments.calendar);
  auto report = open_if_asked(arguments.report);
  const fleet::FleetPlan plan = fleet::make_plan(tendons, arguments.request);
  if (as_read) {
    as_read->write(fleet::fleet_table_text(read.rows, read.broken));
  }
  if (table) {
    table->write(fleet::plan_table(tendons, plan));
  }
  if (json) {
    json->write(fleet::plan_json(tendons, arguments.request, plan));
  }
  if (calendar) {
    calendar->write(fleet::plan_calendar(tendons, arguments.request, plan));
  }
  if (report) {
    write_fleet_report(report->stream(), arguments.tendons, tendons, arguments.request, plan,
                       fleet::course_of(tendons, arguments.request, plan), kProgramVersion);
  }
  commit_all({&as_read, &table, &json, &calendar, &report});
  std::ostream& summary = summary_stream(arguments.outputs());
  fleet::write_plan(summary, arguments.tendons, tendons, arguments.request, plan);
  write_next(summary, arguments.calendar.empty()
                          ? "--calendar fleet.ics puts the dates into a calendar"
                          : "--report fleet.html draws this");
  return 0;
}

constexpr double kLeastShare = 1e-6;

}  // namespace

void add_fleet(CLI::App& app, int& status) {
  auto arguments = std::make_shared<FleetArguments>();
  CLI::App* verb = app.add_subcommand(
      "fleet", "When which tendon is to be replaced, and how many spares it takes");
  verb->add_option("TENDONS", arguments->tendons,
                   "The tendons: a CSV file with damage so far, damage per hour, hours per day, or "
                   "a folder of records of monitor --record")
      ->required();
  verb->add_option("--model", arguments->model,
                   "The life model of tendons that name none, a TOML file");
  verb->add_option("--hours-per-day", arguments->hours_per_day,
                   "Of operation, of tendons that are read from records")
      ->check(command_line::in_range(0.0, 24.0));
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
  constexpr double kMostCost = 1e15;
  verb->add_option("--cost-replacement", arguments->cost_replacement,
                   "What a planned replacement costs, of tendons without cost_replace")
      ->check(command_line::in_range(0.0, kMostCost));
  verb->add_option("--cost-break", arguments->cost_break,
                   "What a break costs, with the replacement after it, of tendons without "
                   "cost_break")
      ->check(command_line::in_range(0.0, kMostCost));
  verb->add_option("--today", arguments->today,
                   "The day of the table, YYYY-MM-DD; else the clock's")
      ->type_name("DATE");
  verb->add_option("--table", arguments->out_table, "Write a row for each tendon as CSV");
  verb->add_option("--json", arguments->json, "Write the plan as JSON; - is standard output");
  verb->add_option("--calendar", arguments->calendar,
                   "Write the dates to replace within the horizon as a calendar, iCalendar");
  verb->add_option("--report", arguments->report, "Write a page with plots as HTML");
  verb->add_option("--write-table", arguments->read_table,
                   "Write the tendons as they were read as CSV, to look at, edit and plan with");
  verb->add_option("--threads", arguments->request.threads,
                   "How many threads; all cores without it. The result does not depend on it")
      ->check(command_line::in_range(1U, kMostThreads));
  verb->footer(
      "Example: host_sim fleet host_sim/examples/fleet/tendons.csv --model "
      "host_sim/examples/upper_arm.toml --horizon 90d --service 0.95 --today 2026-03-02\n"
      "         host_sim fleet host_sim/examples/fleet/tendons.csv --model "
      "host_sim/examples/upper_arm.toml --cost-replacement 100 --cost-break 1000 --report "
      "fleet.html\n"
      "         host_sim fleet records --model host_sim/examples/upper_arm.toml --hours-per-day 8 "
      "--write-table tendons.csv");
  verb->callback([arguments, &status] { status = run_fleet(*arguments); });
}

}  // namespace host_sim
