#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "firmware/app/models.hpp"
#include "host_sim/command_line/options.hpp"
#include "host_sim/extension/model_file.hpp"
#include "host_sim/monitor/bus/frame_source.hpp"
#include "host_sim/monitor/bus/socketcan_source.hpp"
#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/fleet/watch.hpp"
#include "host_sim/monitor/http/live_page.hpp"
#include "host_sim/monitor/record/frame_archive.hpp"
#include "host_sim/monitor/record/log_folder.hpp"
#include "host_sim/monitor/record/recorder.hpp"
#include "host_sim/monitor/specimens/specimen_file.hpp"
#include "host_sim/monitor/terminal/table.hpp"
#include "host_sim/monitor/terminal/terminal.hpp"
#include "host_sim/replay/constants.hpp"
#include "host_sim/verbs/outputs.hpp"
#include "host_sim/verbs/verbs.hpp"
#ifdef TENDONLIFE_MQTT
#include "host_sim/monitor/mqtt/mqtt_observer.hpp"
#endif

namespace host_sim {
namespace {

/// The pace of a log that is not waited for.
constexpr double kAsFastAsItGoes = 0;

struct MonitorArguments {
  std::string interface;
  std::string log;
  std::optional<double> replay_speed;
  double bit_rate_bit_s = 1e6;
  std::string http;
  std::string http_token;
  std::string record;
  monitor::Rotation rotation;
  std::string specimens;
  std::string model;
#ifdef TENDONLIFE_MQTT
  std::optional<monitor::BrokerAddress> mqtt;
#endif
  bool once = false;
  double listen_s = 3;
};

constexpr const char* kTokenVariable = "TENDONLIFE_HTTP_TOKEN";

std::string speed_error(const std::string& text, std::optional<double>& speed) {
  if (text == "max") {
    speed = kAsFastAsItGoes;
    return {};
  }
  double value = 0;
  if (!CLI::detail::lexical_cast(text, value) || !(value >= 0 && value <= 1e9)) {
    return "'" + text + "' is none; accepted: a number from 0 to 1e9, or max";
  }
  speed = value;
  return {};
}

void add_source_options(CLI::App& verb, MonitorArguments& arguments) {
  CLI::Option* const interface =
      verb.add_option("--interface", arguments.interface, "A CAN interface: can0, vcan0")
          ->type_name(command_line::kInterface)
          ->check([](const std::string& name) {
            return name.empty() || name.size() > 15 ? "a name has 1 to 15 characters"
                                                    : std::string();
          });
  CLI::Option* const log =
      verb.add_option("--log", arguments.log,
                      "A log: of candump -L, Vector ASC, PCAP or PCAPNG; - is a log of candump -L "
                      "on standard input")
          ->excludes(interface);
  interface->excludes(log);
  verb.add_option_function<std::string>(
          "--replay-speed",
          [&arguments](const std::string& text) {
            if (const std::string error = speed_error(text, arguments.replay_speed);
                !error.empty()) {
              throw CLI::ValidationError("--replay-speed", error);
            }
          },
          "Pace of a log: 1 is as recorded, 2 twice as fast, 0 or max as fast as it goes; 1, and "
          "max with --once")
      ->type_name("SPEED")
      ->needs(log);
  verb.add_option("--bit-rate", arguments.bit_rate_bit_s,
                  "Of the bus in bit/s: what its load is a share of")
      ->check(command_line::in_range(1e3, 1e9))
      ->capture_default_str();
}

void add_page_options(CLI::App& verb, MonitorArguments& arguments, CLI::Option* once) {
  verb.add_option("--http", arguments.http,
                  "Show a live page at this ADDRESS:PORT, such as 127.0.0.1:8080, which only this "
                  "machine can reach; it exports the frames of --record, else the newest 32 MiB")
      ->type_name("ADDRESS:PORT")
      ->excludes(once);
  verb.add_option("--http-token", arguments.http_token,
                  "What a browser has to bring, as ?token= or in the header Authorization: Bearer; "
                  "needed where others can reach the page")
      ->type_name("TOKEN")
      ->envname(kTokenVariable);
}

void add_record_options(CLI::App& verb, MonitorArguments& arguments) {
  CLI::Option* const record =
      verb.add_option(
              "--record", arguments.record,
              "Record every frame to logs of candump -L in this folder, synced each second; "
              "what is there is continued")
          ->type_name(command_line::kFolder);
  verb.add_option("--record-rotate", arguments.rotation.bytes,
                  "Size of a log: bytes, or with K, M or G")
      ->transform(CLI::AsSizeValue(false))
      ->check(command_line::in_range(std::uint64_t{1024}, std::uint64_t{1} << 40))
      ->needs(record)
      ->default_str("64M");
  verb.add_option("--record-keep", arguments.rotation.keep, "Logs that are kept, the newest")
      ->check(command_line::in_range(1, 1'000'000))
      ->needs(record)
      ->capture_default_str();
}

void add_specimen_options(CLI::App& verb, MonitorArguments& arguments) {
  CLI::Option* const specimens =
      verb.add_option("--specimens", arguments.specimens,
                      "Write each tendon that breaks, or is replaced whole, to a specimens.csv for "
                      "calibrate, when its cycles are known; what is there is continued")
          ->type_name(command_line::kFile);
  CLI::Option* const model = verb.add_option("--model", arguments.model,
                                             "The model that the nodes count with, a TOML file")
                                 ->type_name(command_line::kFile)
                                 ->needs(specimens);
  specimens->needs(model);
}

#ifdef TENDONLIFE_MQTT
void add_mqtt_option(CLI::App& verb, MonitorArguments& arguments) {
  verb.add_option_function<std::string>(
          "--mqtt",
          [&arguments](const std::string& text) {
            arguments.mqtt = monitor::broker_address_of(text);
            if (!arguments.mqtt) {
              throw CLI::ValidationError("--mqtt", "'" + text + "' is none; accepted: HOST:PORT");
            }
          },
          "Publish each node to the MQTT broker at HOST:PORT: retained JSON under "
          "tendonlife/NODE/status")
      ->type_name("HOST:PORT");
}
#endif

void add_monitor_options(CLI::App& verb, MonitorArguments& arguments) {
  add_source_options(verb, arguments);
  add_record_options(verb, arguments);
  add_specimen_options(verb, arguments);
#ifdef TENDONLIFE_MQTT
  add_mqtt_option(verb, arguments);
#endif
  CLI::Option* const once = verb.add_flag(
      "--once", arguments.once,
      "Print one table and end: when the log does, or after --listen. Exit with status 3 where a "
      "node is to be replaced or worn, has a tendon that broke or hangs loose, has vanished, has "
      "frames that failed the integrity check, or has its id in common with another, and with "
      "status 1 where a record is not complete");
  add_page_options(verb, arguments, once);
  verb.add_option("--listen", arguments.listen_s, "Seconds that --once listens to an interface")
      ->check(command_line::in_range(0.1, 1e6))
      ->needs(once)
      ->capture_default_str();
}

/// What of the command line would do nothing beside the rest of it, for people; empty where all
/// does.
std::string without_effect(const CLI::App& verb, const MonitorArguments& arguments) {
  if (verb.count("--listen") > 0 && arguments.interface.empty()) {
    return "--listen requires --interface: a log ends by itself";
  }
  const bool given = verb.count("--http-token") > 0 && std::getenv(kTokenVariable) == nullptr;
  return given && arguments.http.empty() ? "--http-token requires --http" : "";
}

/// What was asked for beside the table, such as a record, was not done in full.
constexpr int kNotDone = 1;

using monitor::FleetView;
using monitor::FrameSource;
using monitor::NodeView;
using monitor::Observer;

std::unique_ptr<FrameSource> open_source_of(const MonitorArguments& arguments) {
  if (!arguments.interface.empty()) {
    return std::make_unique<monitor::SocketCanSource>(arguments.interface);
  }
  const double speed = arguments.replay_speed.value_or(arguments.once ? kAsFastAsItGoes : 1.0);
  return std::make_unique<monitor::LogSource>(monitor::open_log(arguments.log), arguments.log,
                                              speed);
}

std::string interface_in_lines(const MonitorArguments& arguments) {
  return arguments.interface.empty() ? "log" : arguments.interface;
}

bool needs_attention(const NodeView& node) {
  return node.life_state() >= protocol::LifeState::replace || node.two_controllers ||
         node.vanished || node.integrity_failures() != 0 ||
         (node.status && (node.status->value.broken || node.status->value.slack));
}

void print_table(const FleetView& view, const monitor::TableStyle& style) {
  for (const std::string& line : monitor::table_of(view, style)) {
    std::cout << line << '\n';
  }
}

/// What follows the bus beside the fleet.
class Followers {
 public:
  Followers(const MonitorArguments& arguments, bool on_terminal,
            std::optional<monitor::SpecimenFile>& specimens) {
    if (specimens) {
      observers_.push_back(&*specimens);
    }
    if (!arguments.record.empty()) {
      begin_record(arguments);
    } else if (on_terminal || !arguments.http.empty()) {
      observers_.push_back(&recent_.emplace(interface_in_lines(arguments)));
    }
    if (!arguments.http.empty()) {
      begin_page(arguments);
    }
#ifdef TENDONLIFE_MQTT
    if (arguments.mqtt) {
      observers_.push_back(&mqtt_.emplace(*arguments.mqtt));
    }
#endif
  }

  /// In the order in which they see a frame.
  [[nodiscard]] const std::vector<Observer*>& observers() const {
    return observers_;
  }
  /// What there is of the past. @pre frames are recorded, or shown on a terminal or a page
  [[nodiscard]] const monitor::FrameArchive& archive() const {
    return recorded_ ? static_cast<const monitor::FrameArchive&>(*recorded_) : *recent_;
  }

 private:
  void begin_record(const MonitorArguments& arguments) {
    record_.emplace(arguments.record, arguments.rotation, interface_in_lines(arguments));
    if (!record_->repaired().empty()) {
      std::cerr << record_->repaired() << '\n';
    }
    observers_.push_back(&*record_);
    recorded_.emplace(arguments.record, [this] { record_->flush(); });
  }

  void begin_page(const MonitorArguments& arguments) {
    monitor::LivePageOptions options{.address = monitor::parse_address(arguments.http),
                                     .archive = archive()};
    if (!arguments.http_token.empty()) {
      options.token = arguments.http_token;
    }
    page_.emplace(options);
    std::cerr << "live page: " << page_->url() << '\n';
    observers_.push_back(&*page_);
  }

  std::vector<Observer*> observers_;
  // The page ends before the frames that it shows.
  std::optional<monitor::Recorder> record_;
  std::optional<monitor::RecordedFolder> recorded_;
  std::optional<monitor::RecentFrames> recent_;
  std::optional<monitor::LivePage> page_;
#ifdef TENDONLIFE_MQTT
  std::optional<monitor::MqttObserver> mqtt_;
#endif
};

std::vector<std::string> troubles_of(const std::vector<Observer*>& observers) {
  std::vector<std::string> troubles;
  for (const Observer* observer : observers) {
    if (std::string trouble = observer->trouble(); !trouble.empty()) {
      troubles.push_back(std::move(trouble));
    }
  }
  return troubles;
}

/// Reports on standard error what keeps the others from their work: when it has lasted a moment,
/// when it changes, though no more often than once a minute, and when it is over.
class TroubleReport final : public Observer {
 public:
  explicit TroubleReport(const std::vector<Observer*>& observers) {
    for (const Observer* observer : observers) {
      reports_.push_back({.observer = observer});
    }
  }

  void update(const FleetView& /*view*/) override {
    const Clock::time_point now = Clock::now();
    for (Report& report : reports_) {
      report.keep_up(now);
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kMoment{500};  // what a broker needs to answer
  static constexpr std::chrono::seconds kChangesApart{60};

  struct Report {
    const Observer* observer = nullptr;
    std::string reported = {};
    Clock::time_point since = {};  ///< of a trouble that is not reported yet, or of the last line
    bool pending = false;

    void keep_up(Clock::time_point now) {
      const std::string trouble = observer->trouble();
      if (trouble == reported) {
        pending = false;
        return;
      }
      if (reported.empty() && !std::exchange(pending, true)) {
        since = now;
      }
      const bool due = trouble.empty() ||
                       now - since >= (reported.empty() ? Clock::duration(kMoment) : kChangesApart);
      if (due) {
        std::cerr << (trouble.empty() ? "it is over: " + reported : trouble) << std::endl;
        reported = trouble;
        since = now;
        pending = false;
      }
    }
  };

  std::vector<Report> reports_;
};

int run(const MonitorArguments& arguments) {
  std::optional<monitor::SpecimenFile> specimens;
  if (!arguments.specimens.empty()) {
    const Model model = read_extended_model(arguments.model);
    specimens.emplace(arguments.specimens, model.life,
                      app::configuration_of(extended_parameters_of(model, arguments.model)));
  }
  const auto source = open_source_of(arguments);
  monitor::Fleet fleet(arguments.bit_rate_bit_s);
  const bool on_terminal = !arguments.once && monitor::can_draw();
  const Followers followers(arguments, on_terminal, specimens);
  const std::vector<Observer*>& observers = followers.observers();
  {
    std::optional<monitor::Terminal> terminal;
    TroubleReport report(observers);
    std::vector<Observer*> all = observers;
    if (on_terminal) {
      terminal.emplace(followers.archive(), [&observers] { return troubles_of(observers); });
      all.push_back(&*terminal);
    } else {
      all.push_back(&report);
    }
    std::optional<std::chrono::milliseconds> most;
    if (arguments.once && !arguments.interface.empty()) {
      most = std::chrono::milliseconds(static_cast<std::int64_t>(arguments.listen_s * 1000));
    }
    watch(*source, fleet, all, most);
  }
  print_table(fleet.view(), on_terminal ? monitor::terminal_style() : monitor::TableStyle{});
  const std::vector<std::string> troubles = troubles_of(observers);
  for (const std::string& trouble : troubles) {
    std::cerr << trouble << '\n';
  }
  const auto& nodes = fleet.view().nodes;
  const bool found = std::any_of(nodes.begin(), nodes.end(),
                                 [](const auto& node) { return needs_attention(node.second); });
  if (arguments.once && found) {
    return kFoundInData;
  }
  return troubles.empty() ? 0 : kNotDone;
}

}  // namespace

void add_monitor(CLI::App& app, int& status) {
  auto arguments = std::make_shared<MonitorArguments>();
  CLI::App* verb =
      app.add_subcommand("monitor", "What the nodes of a bus report of their lives, live");
  add_monitor_options(*verb, *arguments);
  verb->footer(
      "On a terminal space pauses, the arrows, page keys and Home go back, End on to the newest, "
      "and q "
      "ends it. A table is printed when the log or the program ends.\n"
      "Example: host_sim monitor --interface can0 --record logs\n"
      "         host_sim monitor --interface can0 --http 127.0.0.1:8080\n"
      "         host_sim monitor --log run.log --replay-speed 10");
  verb->callback([verb, arguments, &status] {
    if (arguments->interface.empty() == arguments->log.empty()) {
      throw CLI::RequiredError("One of --interface and --log");
    }
    if (const std::string error = without_effect(*verb, *arguments); !error.empty()) {
      throw CLI::ValidationError("monitor", error);
    }
    check_files("monitor", {.reads = {{"--log", arguments->log}, {"--model", arguments->model}},
                            .writes = {{"--specimens", arguments->specimens}},
                            .fills = {{"--record", arguments->record}}});
    status = run(*arguments);
  });
}

}  // namespace host_sim
