#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <streambuf>
#include <string>
#include <vector>

#include "hal/files/input_error.hpp"
#include "hal/files/interruption.hpp"
#include "hal/files/output_file.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace {

constexpr int kBadInput = 1;
constexpr int kUsage = 2;
constexpr int kInterrupted = 130;  // as a shell tells SIGINT

int fail(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return kBadInput;
}

/// A descriptor that is closed would be that of the next file which is opened.
void take_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) < 0) {
      ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

/// What people read has to arrive as well: while it lives, std::cout remembers why it could not.
class StandardOutput {
 public:
  StandardOutput() : file_("-"), before_(std::cout.rdbuf(file_.stream().rdbuf())) {}
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;
  ~StandardOutput() {
    std::cout.flush();
    std::cout.rdbuf(before_);
  }

  /// @throws OutputError
  void finish() { file_.commit(); }

 private:
  hal::files::OutputFile file_;
  std::streambuf* before_;
};

int run(int argc, char** argv) {
  CLI::App app{"Life of tendons from recorded profiles, through the code that runs on the board"};
  app.name("host_sim");
  app.set_version_flag("--version", std::string(host_sim::kProgramVersion));
  app.require_subcommand(1);
  app.get_formatter()->label("TEXT", "FILE");
  app.footer(
      "Exit status: 0 done, 1 bad input, 2 wrong usage, 3 a limit or fault was found in the data.\n"
      "The examples of each verb are told from the source tree; installed they lie "
      "in " TENDONLIFE_DOCUMENTS
      ".\n"
      "Example: host_sim replay --help");
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  app.failure_message([&words](const CLI::App* program, const CLI::Error& error) {
    return host_sim::usage_failure(*program, words, error);
  });
  int status = 0;
  take_standard_descriptors();
  hal::files::watch_for_interruption();
  StandardOutput output;
  host_sim::add_replay(app, status);
  host_sim::add_calibrate(app, status);
  host_sim::add_compare(app, status);
  host_sim::add_design(app, status);
  host_sim::add_diagnose(app, status);
  host_sim::add_fleet(app, status);
  host_sim::add_fmeca(app, status);
  host_sim::add_import(app, status);
  host_sim::add_init(app, status);
  host_sim::add_monitor(app, status);
  host_sim::add_pack(app, status);
  host_sim::add_plan(app, status);
  host_sim::add_schema(app, status);
  host_sim::add_synth(app, status);
  host_sim::add_completion(app, status);
  host_sim::add_manual(app, status);
  host_sim::add_help(app, status);
  try {
    try {
      app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      status = app.exit(error) == 0 ? 0 : kUsage;
    }
    output.finish();
  } catch (const hal::files::InputError& error) {
    return fail(error);
  } catch (const hal::files::Interruption& error) {
    std::cerr << "host_sim: " << error.what() << '\n';
    return kInterrupted;
  } catch (const hal::files::OutputError& error) {
    return fail(error);
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(hal::files::OutputError(error.path1().string(), error.code().message()));
  } catch (const std::exception& error) {
    std::cerr << "host_sim: ";
    return fail(error);
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (...) {
    std::fputs("host_sim: out of resources\n", stderr);
    return kBadInput;
  }
}
