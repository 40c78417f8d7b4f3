#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>

#include "host_sim/io/input_error.hpp"
#include "host_sim/io/interruption.hpp"
#include "host_sim/io/output_file.hpp"
#include "host_sim/verbs/verbs.hpp"

namespace {

constexpr int kBadInput = 1;
constexpr int kUsage = 2;
constexpr int kInterrupted = 130;  // as a shell tells SIGINT

int fail(const std::exception& error) {
  std::cerr << error.what() << '\n';
  return kBadInput;
}

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
  int status = 0;
  host_sim::watch_for_interruption();
  host_sim::add_replay(app, status);
  host_sim::add_calibrate(app, status);
  host_sim::add_diagnose(app, status);
  host_sim::add_import(app, status);
  host_sim::add_monitor(app, status);
  host_sim::add_pack(app, status);
  host_sim::add_plan(app, status);
  host_sim::add_synth(app, status);
  host_sim::add_completion(app, status);
  host_sim::add_manual(app, status);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  } catch (const host_sim::InputError& error) {
    return fail(error);
  } catch (const host_sim::Interruption& error) {
    std::cerr << "host_sim: " << error.what() << '\n';
    return kInterrupted;
  } catch (const host_sim::OutputError& error) {
    return fail(error);
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
