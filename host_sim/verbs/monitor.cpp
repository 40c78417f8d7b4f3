#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/monitor/bus/log_source.hpp"
#include "host_sim/monitor/bus/socketcan_source.hpp"
#include "host_sim/monitor/fleet/fleet.hpp"
#include "host_sim/monitor/http/page_observer.hpp"
#include "host_sim/monitor/http/recent_frames.hpp"
#include "host_sim/monitor/http/recorded_folder.hpp"
#include "host_sim/monitor/record/record_observer.hpp"
#include "host_sim/monitor/terminal/table.hpp"
#include "host_sim/monitor/terminal/terminal.hpp"
#include "host_sim/monitor/watch/watch.hpp"
#include "host_sim/verbs/monitor_arguments.hpp"
#include "host_sim/verbs/verbs.hpp"
#ifdef TENDONLIFE_MQTT
#include "host_sim/monitor/mqtt/mqtt_observer.hpp"
#endif

namespace host_sim {
namespace {

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
  const bool used_up = node.status && (node.status->value.state == protocol::LifeState::replace ||
                                       node.status->value.state == protocol::LifeState::worn);
  return used_up || node.vanished || node.integrity_failures() != 0;
}

void print_table(const FleetView& view) {
  for (const std::string& line : monitor::table_of(view, {})) {
    std::cout << line << '\n';
  }
}

/// What follows the bus beside the fleet.
class Followers {
 public:
  explicit Followers(const MonitorArguments& arguments) {
    if (!arguments.record.empty()) {
      begin_record(arguments);
    }
    if (!arguments.http.empty()) {
      begin_page(arguments);
    }
#ifdef TENDONLIFE_MQTT
    if (arguments.mqtt) {
      told_.push_back(&mqtt_.emplace(*arguments.mqtt));
    }
#endif
  }

  /// In the order in which they are told.
  [[nodiscard]] const std::vector<Observer*>& told() const {
    return told_;
  }

 private:
  void begin_record(const MonitorArguments& arguments) {
    record_.emplace(arguments.record, arguments.rotation, interface_in_lines(arguments));
    if (!record_->repaired().empty()) {
      std::cerr << record_->repaired() << '\n';
    }
    told_.push_back(&*record_);
    recorded_.emplace(arguments.record, [this] { record_->flush(); });
  }

  void begin_page(const MonitorArguments& arguments) {
    monitor::LivePageOptions options{.address = monitor::parse_address(arguments.http)};
    if (!arguments.http_token.empty()) {
      options.token = arguments.http_token;
    }
    if (recorded_) {
      options.archive = &*recorded_;
    } else {
      recent_.emplace(interface_in_lines(arguments));
      told_.push_back(&*recent_);
      options.archive = &*recent_;
    }
    page_.emplace(options);
    std::cerr << "live page: " << page_->page().url() << '\n';
    told_.push_back(&*page_);
  }

  std::vector<Observer*> told_;
  // The page ends before the frames that it exports.
  std::optional<monitor::RecordObserver> record_;
  std::optional<monitor::RecordedFolder> recorded_;
  std::optional<monitor::RecentFrames> recent_;
  std::optional<monitor::PageObserver> page_;
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

int run(const MonitorArguments& arguments) {
  const auto source = open_source_of(arguments);
  monitor::Fleet fleet(arguments.bit_rate_bit_s);
  const Followers followers(arguments);
  const std::vector<Observer*>& observers = followers.told();
  const bool on_terminal = !arguments.once && monitor::can_draw();
  {
    std::optional<monitor::Terminal> terminal;
    std::vector<Observer*> all = observers;
    if (on_terminal) {
      terminal.emplace([&observers] { return troubles_of(observers); });
      all.push_back(&*terminal);
    }
    std::optional<std::chrono::milliseconds> most;
    if (arguments.once && !arguments.interface.empty()) {
      most = std::chrono::milliseconds(static_cast<std::int64_t>(arguments.listen_s * 1000));
    }
    watch(*source, fleet, all, most);
  }
  if (!on_terminal) {
    print_table(fleet.view());
  }
  for (const std::string& trouble : troubles_of(observers)) {
    std::cerr << trouble << '\n';
  }
  const auto& nodes = fleet.view().nodes;
  const bool found = std::any_of(nodes.begin(), nodes.end(),
                                 [](const auto& node) { return needs_attention(node.second); });
  return arguments.once && found ? kFoundInData : 0;
}

}  // namespace

void add_monitor(CLI::App& app, int& status) {
  auto arguments = std::make_shared<MonitorArguments>();
  CLI::App* verb =
      app.add_subcommand("monitor", "What the nodes of a bus tell of their lives, live");
  add_monitor_options(*verb, *arguments);
  verb->footer(
      "On a terminal q ends it; elsewhere it prints a table when the log or the program ends.\n"
      "Example: host_sim monitor --interface can0 --record logs\n"
      "         host_sim monitor --interface can0 --http 127.0.0.1:8080\n"
      "         host_sim monitor --log run.log --replay-speed 10");
  verb->callback([arguments, &status] {
    if (arguments->interface.empty() == arguments->log.empty()) {
      throw CLI::RequiredError("One of --interface and --log");
    }
    status = run(*arguments);
  });
}

}  // namespace host_sim
