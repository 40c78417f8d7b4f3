#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <system_error>

#include "host_sim/command_line/numbers.hpp"
#include "host_sim/replay/flag_names.hpp"
#include "host_sim/verbs/fail_on.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/replay_arguments.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

constexpr std::array<const char*, 6> kForOneProfile{
    "--trajectory", "--trajectory-step", "--report", "--can", "--node", "--start-cycle"};

void add_inputs(CLI::App& verb, ReplayArguments& arguments) {
  verb.add_option("PROFILE", arguments.profiles,
                  "CSV with time_s and input_tension_N, motor_current_A, or output_tension_N and "
                  "tendon_velocity_m_s; - is standard input. Several of them, or a folder with all "
                  "*.csv in it and below, give one table")
      ->required();
  verb.add_option("--model", arguments.model,
                  "The model, a TOML file. In a table without it: for each profile the model.toml "
                  "in its folder or nearest above it in the folder given");
  verb.add_option("--input", arguments.input,
                  "Which columns to take where the profile holds more than one kind")
      ->check(CLI::IsMember({"input_tension", "motor_current", "output_tension"}));
}

void add_outputs(CLI::App& verb, ReplayArguments& arguments) {
  verb.add_option("--json", arguments.json, "Write the result as JSON; - is standard output");
  verb.add_option("--trajectory", arguments.trajectory, "Write readings over time as CSV");
  verb.add_option("--trajectory-step", arguments.trajectory_step_s,
                  "Least time between two rows of the trajectory in seconds; 0 is every sample")
      ->check(command_line::not_negative())
      ->capture_default_str();
  verb.add_option("--report", arguments.report, "Write a page with plots as HTML");
  CLI::Option* can = verb.add_option(
      "--can", arguments.can,
      "Write what the firmware sends on the bus as candump -L does; time 0 is the first sample");
  verb.add_option("--node", arguments.node, "CANopen node id of the firmware")
      ->check(command_line::in_range(1, 127))
      ->needs(can)
      ->default_str("1");
}

void add_table(CLI::App& verb, ReplayArguments& arguments) {
  verb.add_option("--table", arguments.table,
                  "Write one row for each profile as CSV; - is standard output");
  verb.add_option("--threads", arguments.threads,
                  "How many profiles at once; all cores without it. The table does not depend on "
                  "it. Under mpirun its ranks share the profiles, where the program was built with "
                  "MPI")
      ->check(command_line::in_range(1U, kMostThreads));
}

bool wants_table(const ReplayArguments& arguments) {
  std::error_code ignored;
  return arguments.profiles.size() > 1 || !arguments.table.empty() ||
         std::filesystem::is_directory(arguments.profiles.front(), ignored);
}

/// What does not go together in a table of profiles; empty where all does.
std::string conflict_in_table(const CLI::App& verb, const ReplayArguments& arguments) {
  for (const char* option : kForOneProfile) {
    if (verb.count(option) > 0) {
      return std::string(option) + " is for one profile, not for a table of them";
    }
  }
  const auto& profiles = arguments.profiles;
  if (std::find(profiles.begin(), profiles.end(), "-") != profiles.end()) {
    return "standard input is no profile of a table; accepted: files and folders";
  }
  if (arguments.table.empty() && arguments.json.empty()) {
    return "several profiles give a table: --table FILE or --json FILE is required; - is standard "
           "output";
  }
  return {};
}

/// What has no effect without another option; empty where all has one.
std::string conflict_of_one(const CLI::App& verb, const ReplayArguments& arguments) {
  if (verb.count("--threads") > 0) {
    return "--threads is for a table of profiles, not for one";
  }
  if (verb.count("--trajectory-step") > 0 && arguments.trajectory.empty()) {
    return "--trajectory-step requires --trajectory";
  }
  return {};
}

int run(const CLI::App& verb, const ReplayArguments& arguments) {
  const bool table = wants_table(arguments);
  if (!table && arguments.model.empty()) {
    throw CLI::RequiredError("--model");
  }
  const std::string error =
      table ? conflict_in_table(verb, arguments) : conflict_of_one(verb, arguments);
  if (!error.empty()) {
    throw CLI::ValidationError("replay", error);
  }
  VerbFiles files = arguments.files();
  if (!table) {
    files.reads.push_back({"PROFILE", arguments.profiles.front()});
  }
  check_files("replay", files);
  return table ? replay_many(arguments) : replay_one(arguments);
}

}  // namespace

void add_replay(CLI::App& app, int& status) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* verb = app.add_subcommand("replay", "How much life a recorded profile uses");
  add_inputs(*verb, *arguments);
  add_outputs(*verb, *arguments);
  add_table(*verb, *arguments);
  verb->add_option("--start-cycle", arguments->start_cycle,
                   "Cycles that the sheath has seen before, for a model with friction_wear")
      ->default_str("0");
  add_fail_on(*verb, arguments->fail_on, all_flag_names(),
              "Exit with status 3 if one of these flags is raised");
  verb->footer(
      "Example: host_sim replay host_sim/examples/upper_arm.csv --model "
      "host_sim/examples/upper_arm.toml --report upper_arm.html\n"
      "         host_sim replay host_sim/examples/*.csv --model host_sim/examples/upper_arm.toml "
      "--table fleet.csv");
  verb->callback([verb, arguments, &status] { status = run(*verb, *arguments); });
}

}  // namespace host_sim
