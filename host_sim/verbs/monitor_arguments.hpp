#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "host_sim/monitor/record/log_folder.hpp"
#ifdef TENDONLIFE_MQTT
#include "host_sim/monitor/mqtt/mqtt_observer.hpp"
#endif

namespace host_sim {

/// The pace of a log that is not waited for.
inline constexpr double kAsFastAsItGoes = 0;

struct MonitorArguments {
  std::string interface;
  std::string log;
  std::optional<double> replay_speed;
  double bit_rate_bit_s = 1e6;
  std::string http;
  std::string http_token;
  std::string record;
  monitor::Rotation rotation;
#ifdef TENDONLIFE_MQTT
  std::optional<monitor::BrokerAddress> mqtt;
#endif
  bool once = false;
  double listen_s = 3;
};

/// Adds the options of `monitor`, which fill `arguments`.
void add_monitor_options(CLI::App& verb, MonitorArguments& arguments);

/// What of the command line would do nothing beside the rest of it, in words; empty where all does.
std::string without_effect(const CLI::App& verb, const MonitorArguments& arguments);

}  // namespace host_sim
