#include "host_sim/replay/replay.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <system_error>
#include <thread>

#include "hal/files/candump.hpp"
#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "host_sim/command_line/options.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/fleet/horizon.hpp"
#include "host_sim/io/compressed.hpp"
#include "host_sim/io/progress.hpp"
#include "host_sim/model/model.hpp"
#include "host_sim/replay/results.hpp"
#include "host_sim/report/replay/flags.hpp"
#include "host_sim/report/replay/html.hpp"
#include "host_sim/verbs/columns.hpp"
#include "host_sim/verbs/outcome.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/replay_arguments.hpp"
#include "host_sim/verbs/today.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace host_sim {

using hal::files::candump_line;
using hal::files::input_kind_from;
using hal::files::InputError;
using hal::files::ProfileOptions;
using hal::files::ProfileReader;
using hal::files::stop_if_interrupted;

namespace {

constexpr std::array<const char*, 9> kForOneProfile{
    "--trajectory", "--trajectory-step", "--report",    "--can", "--node", "--start-cycle",
    "--used",       "--horizon",         "--until-date"};

constexpr double kLeastHoursPerDay = 1e-3;

void add_inputs(CLI::App& verb, ReplayArguments& arguments) {
  verb.add_option("PROFILE", arguments.profiles,
                  "CSV with time_s and input_tension_N, motor_current_A, or output_tension_N and "
                  "tendon_velocity_m_s; - is standard input. Several of them, or a folder with all "
                  "*.csv in it and below, give one table. gzip and zstd are read as they are")
      ->required();
  verb.add_option("--model", arguments.model,
                  "The model, a TOML file. In a table without it: for each profile the model.toml "
                  "in its folder or nearest above it in the folder given");
  verb.add_option("--input", arguments.input,
                  "Which columns to take where the profile holds more than one kind")
      ->check(CLI::IsMember({"input_tension", "motor_current", "output_tension"}));
  add_columns(verb, arguments.columns);
}

void add_outputs(CLI::App& verb, ReplayArguments& arguments) {
  verb.add_option("--json", arguments.json, "Write the result as JSON; - is standard output");
  verb.add_option("--trajectory", arguments.trajectory, "Write readings over time as CSV");
  verb.add_option("--trajectory-step", arguments.trajectory_step_s,
                  "Least time between two rows of the trajectory in seconds; 0 is every sample")
      ->check(command_line::not_negative())
      ->capture_default_str();
  verb.add_option("--report", arguments.report, "Write a page with plots as HTML");
  verb.add_option("--specimens", arguments.specimens,
                  "Write how long each wire was seen to live as a specimens.csv for calibrate: "
                  "failed up to its break, else suspended at the end of the profile");
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
                  "How many profiles at once, or how many threads read the one; all cores without "
                  "it. The results do not depend on it. Under mpirun its ranks share the profiles, "
                  "where the program was built with MPI")
      ->check(command_line::in_range(1U, kMostThreads));
}

void add_until_date(CLI::App& verb, ReplayArguments& arguments) {
  CLI::Option* until = verb.add_option(
      "--until-date", arguments.until_date,
      "Tells the highest tension, or the pace, with which a wire at --used lasts until that day");
  until->type_name("DATE");
  verb.add_option("--today", arguments.today, "The day of --used, YYYY-MM-DD; else the clock's")
      ->type_name("DATE")
      ->needs(until);
  verb.add_option("--hours-per-day", arguments.hours_per_day,
                  "Of operation as in the profile, on each day until the date")
      ->check(command_line::in_range(kLeastHoursPerDay, 24.0))
      ->needs(until)
      ->capture_default_str();
  verb.add_option("--risk", arguments.risk, "Of a break until the date that is accepted")
      ->check(command_line::in_range(1e-6, 0.99))
      ->needs(until)
      ->capture_default_str();
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
  if (arguments.table.empty() && arguments.json.empty() && arguments.specimens.empty()) {
    return "several profiles give a table: --table FILE or --json FILE is required; - is standard "
           "output";
  }
  return {};
}

/// What has no effect without another option; empty where all has one.
std::string conflict_of_one(const CLI::App& verb, const ReplayArguments& arguments) {
  if (verb.count("--threads") > 0 && arguments.profiles.front() == "-") {
    return "--threads is for files, standard input is parsed as it comes";
  }
  if (verb.count("--trajectory-step") > 0 && arguments.trajectory.empty()) {
    return "--trajectory-step requires --trajectory";
  }
  return {};
}

/// What the command line says of the date; nothing where there is none. @throws
/// CLI::ValidationError
std::optional<AskedUntil> asked_until(const ReplayArguments& arguments) {
  if (arguments.until_date.empty()) {
    return std::nullopt;
  }
  const fleet::Date today = today_of(arguments.today);
  const auto until = fleet::parse_date(arguments.until_date);
  const double days = until ? static_cast<double>((*until - today).count()) : 0;
  if (!(days > 0 && days <= fleet::kLongestHorizon_days)) {
    throw CLI::ValidationError(
        "--until-date", "'" + arguments.until_date + "' is " + (until ? "no day to come" : "none") +
                            "; accepted: a date after today, " + fleet::date_text(today) +
                            ", by up to 100 years (YYYY-MM-DD)");
  }
  return AskedUntil{arguments.until_date, days, arguments.hours_per_day, arguments.risk};
}

/// @throws InputError where no tension lets the wire last
void require_reachable(const UntilDate& until, const std::string& path) {
  if (!until.reachable) {
    throw InputError(
        path, 0, 0,
        fmt::format(
            "no tension lets a wire at damage {:.6g} last until {}: {:.4g} h at {:.4g} % risk "
            "of a break, where this profile takes {:.4g} h to it",
            until.used, until.asked.date, until.asked.hours(), 100 * until.asked.risk,
            until.hours_to_risk),
        "an earlier date, fewer --hours-per-day, a higher --risk, or a new wire");
  }
}

std::string next_step(const ReplayArguments& arguments) {
  return arguments.report.empty()
             ? "--report replay.html draws this"
             : fmt::format("host_sim pack {} --out block.bin puts the model on a board",
                           shell_word(arguments.model));
}

/// The only profile. @return the exit status @throws InputError, OutputError, Interruption
int replay_one(const ReplayArguments& arguments) {
  const std::string& path = arguments.profiles.front();
  const auto until = asked_until(arguments);
  const Model model = read_extended_model(arguments.model);
  if (arguments.start_cycle && extension_of(model.extensions, "friction_wear") == nullptr) {
    throw InputError(arguments.model, 0, 0,
                     "no [extension.friction_wear], and --start-cycle is for a sheath that wears",
                     "such a model, or none of --start-cycle");
  }
  ProfileOptions profile_options;
  profile_options.columns = arguments.columns;
  profile_options.input = input_kind_from(arguments.input);
  profile_options.threads = arguments.threads != 0
                                ? arguments.threads
                                : std::max(1U, std::thread::hardware_concurrency());
  ProfileReader profile(open_input(path, hal::files::kAcceptedProfile), hal::files::file_name(path),
                        profile_options);
  auto json = open_if_asked(arguments.json);
  auto trajectory = open_if_asked(arguments.trajectory);
  auto page = open_if_asked(arguments.report);
  auto can = open_if_asked(arguments.can);
  auto specimens = open_if_asked(arguments.specimens);

  ReplayReport report;
  ReplayOptions options;
  options.trajectory = trajectory ? &trajectory->stream() : nullptr;
  options.trajectory_step_s = arguments.trajectory_step_s;
  options.report = page ? &report : nullptr;
  options.node = arguments.node;
  options.start_cycle = arguments.start_cycle.value_or(0);
  if (arguments.used || !arguments.horizon.empty()) {
    options.survivor = {arguments.used.value_or(0),
                        arguments.horizon.empty() ? std::nullopt : horizon_from(arguments.horizon)};
  }
  options.until = until;
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
  if (result.until_date) {
    require_reachable(*result.until_date, path);
  }

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
  if (specimens) {
    if (!result.seen_life) {
      throw InputError(path, 0, 0, "no cycle, and --specimens is for lives in cycles",
                       "a profile with at least half a cycle");
    }
    specimens->write(specimens_head() +
                     specimen_row(std::filesystem::path(path).stem().string(), *result.seen_life));
  }
  commit_all({&json, &trajectory, &page, &can, &specimens});
  std::ostream& summary = summary_stream(arguments.outputs());
  write_summary(summary, result, path, arguments.model);
  write_next(summary, next_step(arguments));
  return fails_on(arguments.fail_on, found_in(result)) ? kFoundInData : 0;
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
  verb->add_option("--used", arguments->used,
                   "Damage that the wire has survived before, 1 is its characteristic life: tells "
                   "its life given that it is whole")
      ->check(command_line::not_negative())
      ->default_str("0");
  verb->add_option("--horizon", arguments->horizon,
                   "Tells the probability of a break within that many repeats, or hours of the "
                   "profile with an h, given that the wire is whole: 200, 8h")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return horizon_from(text)
                       ? std::string()
                       : text + " is no horizon; accepted: repeats or hours above 0: 200, 8h";
          },
          "REPEATS|HOURSh"));
  add_until_date(*verb, *arguments);
  add_fail_on(*verb, arguments->fail_on, all_findings(),
              "Exit with status 3 if one of these is found");
  verb->footer(
      "Example: host_sim replay host_sim/examples/upper_arm.csv --model "
      "host_sim/examples/upper_arm.toml --report upper_arm.html\n"
      "         host_sim replay host_sim/examples/*.csv --model host_sim/examples/upper_arm.toml "
      "--table fleet.csv");
  verb->callback([verb, arguments, &status] { status = run(*verb, *arguments); });
}

}  // namespace host_sim
