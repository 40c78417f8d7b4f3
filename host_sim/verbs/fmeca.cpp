#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>

#include "host_sim/fmeca/assessment.hpp"
#include "host_sim/report/fmeca/html.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

/// The command line of `fmeca`.
struct FmecaArguments {
  std::string table_file;
  std::string field;
  std::string json;
  std::string table;
  std::string report;

  [[nodiscard]] std::array<std::string, 3> outputs() const { return {json, table, report}; }
};

int run_fmeca(const FmecaArguments& arguments) {
  check_files("fmeca", {.reads = {{"TABLE", arguments.table_file}, {"--field", arguments.field}},
                        .writes = {{"--json", arguments.json},
                                   {"--table", arguments.table},
                                   {"--report", arguments.report}},
                        .fills = {}});
  const fmeca::RiskTable risks =
      arguments.table_file.empty() ? fmeca::paper_table() : fmeca::read_table(arguments.table_file);
  const fmeca::FieldCounts field =
      arguments.field.empty() ? fmeca::FieldCounts() : fmeca::read_field(arguments.field, risks);
  const fmeca::Assessment assessment = fmeca::assess(risks, field);
  auto json = open_if_asked(arguments.json);
  auto table = open_if_asked(arguments.table);
  auto report = open_if_asked(arguments.report);
  if (json) {
    json->write(fmeca::fmeca_json(assessment));
  }
  if (table) {
    table->write(fmeca::fmeca_table(assessment));
  }
  if (report) {
    write_fmeca_report(report->stream(), assessment, kProgramVersion);
  }
  commit_all({&json, &table, &report});
  std::ostream& summary = summary_stream(arguments.outputs());
  fmeca::write_fmeca(summary, assessment);
  write_next(summary, arguments.field.empty()
                          ? "--field FILE rates the occurrence by records of the field"
                          : "--report fmeca.html draws this");
  return 0;
}

}  // namespace

void add_fmeca(CLI::App& app, int& status) {
  auto arguments = std::make_shared<FmecaArguments>();
  CLI::App* verb = app.add_subcommand(
      "fmeca", "Failure modes by their risk, and what of this product watches each of them");
  verb->add_option("TABLE", arguments->table_file,
                   "Failure modes as TOML; without it Table 2 of the paper");
  verb->add_option("--field", arguments->field,
                   "Rate the occurrence by these field records: CSV with failure, events, "
                   "operating_hours");
  verb->add_option("--json", arguments->json, "Write the result as JSON; - is standard output");
  verb->add_option("--table", arguments->table, "Write a row for each failure mode as CSV");
  verb->add_option("--report", arguments->report,
                   "Write a page with the criticality matrix as HTML");
  verb->footer(
      "Example: host_sim fmeca --report fmeca.html\n"
      "         host_sim fmeca host_sim/examples/fmeca/soft_robot.toml --field "
      "host_sim/examples/fmeca/field.csv");
  verb->callback([arguments, &status] { status = run_fmeca(*arguments); });
}

}  // namespace host_sim
