#include "host_sim/replay/replay.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "host_sim/io/candump.hpp"
#include "host_sim/io/interruption.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/replay/flag_names.hpp"
#include "host_sim/replay/results.hpp"
#include "host_sim/report/replay/html.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {
namespace {

struct Arguments {
  std::string profile;
  std::string model;
  std::string input;
  std::string json;
  std::string trajectory;
  double trajectory_step_s = 0.1;
  std::string report;
  std::string can;
  protocol::Node node = 1;
  std::vector<std::string> fail_on;
};

std::array<std::string, 4> outputs_of(const Arguments& arguments) {
  return {arguments.json, arguments.trajectory, arguments.report, arguments.can};
}

bool found(const std::vector<std::string>& fail_on, const std::vector<std::string>& flags) {
  return std::any_of(flags.begin(), flags.end(), [&](const std::string& flag) {
    return std::find(fail_on.begin(), fail_on.end(), flag) != fail_on.end() ||
           std::find(fail_on.begin(), fail_on.end(), "any") != fail_on.end();
  });
}

int run(const Arguments& arguments) {
  const Model model = read_model(arguments.model);
  ProfileOptions profile_options;
  profile_options.input = input_kind_from(arguments.input);
  ProfileReader profile(arguments.profile, profile_options);
  auto json = open_if_asked(arguments.json);
  auto trajectory = open_if_asked(arguments.trajectory);
  auto page = open_if_asked(arguments.report);
  auto can = open_if_asked(arguments.can);

  ReplayReport report;
  ReplayOptions options;
  options.trajectory = trajectory ? &trajectory->stream() : nullptr;
  options.trajectory_step_s = arguments.trajectory_step_s;
  options.report = page ? &report : nullptr;
  options.node = arguments.node;
  if (can) {
    options.can = [&log = can->stream()](hal::Time time, const hal::CanFrame& frame) {
      stop_if_interrupted();
      log << candump_line(time.us, "can0", frame);
    };
  }
  Progress progress("replay", profile.bytes_total());
  options.progress = [&](std::uint64_t bytes) {
    stop_if_interrupted();
    progress.update(bytes);
  };
  const ReplayResult result = replay(profile, model, arguments.model, options);
  progress.finish();

  if (json) {
    json->write(replay_json(result));
  }
  if (page) {
    report.profile_name = std::filesystem::path(arguments.profile).filename().string();
    report.model_name = std::filesystem::path(arguments.model).filename().string();
    report.program_version = kProgramVersion;
    fill_report(report, result, model);
    write_replay_report(page->stream(), report);
  }
  commit_all({&json, &trajectory, &page, &can});
  write_summary(summary_stream(outputs_of(arguments)), result, arguments.profile, arguments.model);
  return found(arguments.fail_on, result.flags) ? kFoundInData : 0;
}

}  // namespace

void add_replay(CLI::App& app, int& status) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* verb = app.add_subcommand("replay", "How much life a recorded profile uses");
  verb->add_option("PROFILE", arguments->profile,
                   "CSV with time_s and input_tension_N, motor_current_A, or output_tension_N and "
                   "tendon_velocity_m_s; - is standard input")
      ->required();
  verb->add_option("--model", arguments->model, "The model, a TOML file")->required();
  verb->add_option("--input", arguments->input,
                   "Which columns to take where the profile holds more than one kind")
      ->check(CLI::IsMember({"input_tension", "motor_current", "output_tension"}));
  verb->add_option("--json", arguments->json, "Write the result as JSON; - is standard output");
  verb->add_option("--trajectory", arguments->trajectory, "Write readings over time as CSV");
  verb->add_option("--trajectory-step", arguments->trajectory_step_s,
                   "Least time between two rows of the trajectory in seconds; 0 is every sample")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  verb->add_option("--report", arguments->report, "Write a page with plots as HTML");
  CLI::Option* can = verb->add_option(
      "--can", arguments->can,
      "Write what the firmware sends on the bus as candump -L does; time 0 is the first sample");
  verb->add_option("--node", arguments->node, "CANopen node id of the firmware")
      ->check(CLI::Range(1, 127))
      ->needs(can)
      ->capture_default_str();
  std::vector<std::string> choices = all_flag_names();
  choices.emplace_back("any");
  verb->add_option("--fail-on", arguments->fail_on,
                   "Exit with status 3 if one of these flags is raised")
      ->delimiter(',')
      ->check(CLI::IsMember(choices));
  verb->footer(
      "Example: host_sim replay host_sim/examples/upper_arm.csv --model "
      "host_sim/examples/upper_arm.toml --report upper_arm.html");
  verb->callback([arguments, &status] {
    if (const std::string error = conflict_of(outputs_of(*arguments)); !error.empty()) {
      throw CLI::ValidationError("replay", error);
    }
    status = run(*arguments);
  });
}

}  // namespace host_sim
