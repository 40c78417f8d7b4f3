#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string>

#include "host_sim/command_line/numbers.hpp"
#include "host_sim/command_line/type_names.hpp"
#include "host_sim/verbs/monitor_arguments.hpp"

namespace host_sim {
namespace {

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
              "what is there is gone on with")
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
          "Tell the MQTT broker at HOST:PORT of each node: retained JSON under "
          "tendonlife/NODE/status")
      ->type_name("HOST:PORT");
}
#endif

}  // namespace

void add_monitor_options(CLI::App& verb, MonitorArguments& arguments) {
  add_source_options(verb, arguments);
  add_record_options(verb, arguments);
#ifdef TENDONLIFE_MQTT
  add_mqtt_option(verb, arguments);
#endif
  CLI::Option* const once = verb.add_flag(
      "--once", arguments.once,
      "Print one table and end: when the log does, or after --listen. Exit with status 3 where a "
      "node is to be replaced or worn, has vanished, has frames that failed the integrity check, "
      "or "
      "has its id in common with another, and with status 1 where a record is not complete");
  add_page_options(verb, arguments, once);
  verb.add_option("--listen", arguments.listen_s, "Seconds that --once listens to an interface")
      ->check(command_line::in_range(0.1, 1e6))
      ->needs(once)
      ->capture_default_str();
}

std::string without_effect(const CLI::App& verb, const MonitorArguments& arguments) {
  if (verb.count("--listen") > 0 && arguments.interface.empty()) {
    return "--listen requires --interface: a log ends by itself";
  }
  const bool told = verb.count("--http-token") > 0 && std::getenv(kTokenVariable) == nullptr;
  return told && arguments.http.empty() ? "--http-token requires --http" : "";
}

}  // namespace host_sim
