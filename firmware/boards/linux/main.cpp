#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <optional>
#include <string>

#include "firmware/boards/linux/config.hpp"
#include "firmware/boards/linux/controller.hpp"
#include "firmware/boards/linux/setup.hpp"
#include "hal/error.hpp"
#include "hal/files/output_file.hpp"

namespace {

constexpr int kFault = 1;
constexpr int kUsage = 2;

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

extern "C" void ask_to_stop(int) {
  stop_asked = true;
}

void watch_for_signals() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  for (const int signal : {SIGINT, SIGTERM}) {
    sigaction(signal, &action, nullptr);
  }
}

struct Arguments {
  std::string config;
  std::string report;
  bool virtual_clock = false;
  bool check = false;
};

void add_options(CLI::App& app, Arguments& arguments) {
  app.add_option("--config", arguments.config, "The configuration, a TOML file")->required();
  app.add_option("--report", arguments.report,
                 "Where to write how the run ended, as JSON; - is standard output");
  app.add_flag("--virtual-clock", arguments.virtual_clock,
               "Play a profile as fast as possible, the same in every run");
  app.add_flag("--check", arguments.check, "Read the configuration and what it names, and end");
  app.set_version_flag("--version", TENDONLIFE_VERSION);
  app.footer(
      "SIGTERM and SIGINT switch the drive off, save the lives and end the program.\n"
      "Exit status: 0 done, 1 bad configuration, device or store, 2 wrong usage.\n"
      "Example: tendonlife_controller --config /etc/tendonlife/controller.toml --check");
}

void warn_of_missing_lines(const boards::linux_controller::Config& config) {
  if (!config.gpio) {
    std::cerr << "tendonlife_controller: no lines are configured: there is no emergency stop\n";
  }
}

void write(const boards::linux_controller::Report& report, const std::string& path) {
  std::cout << boards::linux_controller::to_text(report);
  if (!path.empty()) {
    hal::files::OutputFile out(path);
    out.write(boards::linux_controller::to_json(report));
    out.commit();
  }
}

int control(const Arguments& arguments) {
  const boards::linux_controller::Setup setup = boards::linux_controller::read_setup(
      boards::linux_controller::read_config(arguments.config), arguments.virtual_clock);
  if (arguments.check) {
    return 0;
  }
  warn_of_missing_lines(setup.config);
  const boards::linux_controller::Report report = boards::linux_controller::run(setup, stop_asked);
  write(report, arguments.report);
  if (report.saved != hal::Error::none) {
    std::cerr << "the lives could not be saved: "
              << (report.store_problem.empty() ? hal::to_string(report.saved)
                                               : report.store_problem)
              << '\n';
    return kFault;
  }
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app{"Controls an actuator and keeps the life of its tendons"};
  app.name("tendonlife_controller");
  Arguments arguments;
  add_options(app, arguments);
  app.get_formatter()->label("TEXT", "FILE");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kUsage;
  }
  watch_for_signals();
  return control(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return kFault;
  } catch (...) {
    std::fputs("tendonlife_controller: out of resources\n", stderr);
    return kFault;
  }
}
