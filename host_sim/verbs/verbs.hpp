#pragma once

#include <span>
#include <string>
#include <string_view>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace host_sim {

inline constexpr std::string_view kProgramVersion = TENDONLIFE_VERSION;

/// Status of a run that found what it was asked to fail on.
inline constexpr int kFoundInData = 3;

/// Of --threads.
inline constexpr unsigned kMostThreads = 1024;

/// Each adds one verb to the program; running it sets `status`, which becomes the exit status.
void add_replay(CLI::App& app, int& status);
void add_calibrate(CLI::App& app, int& status);
void add_compare(CLI::App& app, int& status);
void add_completion(CLI::App& app, int& status);
void add_design(CLI::App& app, int& status);
void add_diagnose(CLI::App& app, int& status);
void add_fleet(CLI::App& app, int& status);
void add_fmeca(CLI::App& app, int& status);
void add_help(CLI::App& app, int& status);
void add_import(CLI::App& app, int& status);
void add_init(CLI::App& app, int& status);
void add_manual(CLI::App& app, int& status);
void add_monitor(CLI::App& app, int& status);
void add_pack(CLI::App& app, int& status);
void add_plan(CLI::App& app, int& status);
void add_schema(CLI::App& app, int& status);
void add_synth(CLI::App& app, int& status);

/// What standard error says of a command line that cannot be used: names the first word that is
/// neither verb nor option with the one that it is nearest to. @param words without the name of the
/// program
std::string usage_failure(const CLI::App& app, std::span<const std::string> words,
                          const CLI::Error& error);

}  // namespace host_sim
