#include <filesystem>

#include "hal/files/candump.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "host_sim/extension/read.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/replay/replay.hpp"
#include "host_sim/replay/results.hpp"
#include "host_sim/report/replay/html.hpp"
#include "host_sim/verbs/fail_on.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/replay_arguments.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

using hal::files::candump_line;
using hal::files::input_kind_from;
using hal::files::InputError;
using hal::files::ProfileOptions;
using hal::files::ProfileReader;
using hal::files::stop_if_interrupted;

int replay_one(const ReplayArguments& arguments) {
  const std::string& path = arguments.profiles.front();
  const Model model = read_extended_model(arguments.model);
  if (arguments.start_cycle && extension_of(model.extensions, "friction_wear") == nullptr) {
    throw InputError(arguments.model, 0, 0,
                     "no [extension.friction_wear], and --start-cycle is for a sheath that wears",
                     "such a model, or none of --start-cycle");
  }
  ProfileOptions profile_options;
  profile_options.input = input_kind_from(arguments.input);
  ProfileReader profile(path, profile_options);
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
  options.start_cycle = arguments.start_cycle.value_or(0);
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
    report.profile_name = std::filesystem::path(path).filename().string();
    report.model_name = std::filesystem::path(arguments.model).filename().string();
    report.program_version = kProgramVersion;
    fill_report(report, result, model);
    write_replay_report(page->stream(), report);
  }
  commit_all({&json, &trajectory, &page, &can});
  write_summary(summary_stream(arguments.outputs()), result, path, arguments.model);
  return fails_on(arguments.fail_on, result.flags) ? kFoundInData : 0;
}

}  // namespace host_sim
