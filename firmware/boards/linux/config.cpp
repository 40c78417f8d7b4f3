#include "firmware/boards/linux/config.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>

#include "hal/files/input_file.hpp"
#include "hal/files/toml_table.hpp"

namespace boards::linux_controller {
namespace {

namespace fs = std::filesystem;
using hal::files::TomlTable;

constexpr std::array<std::string_view, 3> kRealTime{"off", "prefer", "require"};
constexpr std::array<std::string_view, 3> kSensorKinds{"iio", "iio-buffer", "profile"};
constexpr std::array<std::string_view, 2> kAtEnd{"stop", "repeat"};

using Keys = std::initializer_list<std::string_view>;

/// Refuses other keys than these.
TomlTable with_keys(TomlTable table, Keys keys) {
  table.refuse_unknown_keys({}, std::span(keys.begin(), keys.size()));
  return table;
}

[[noreturn]] void refuse(const TomlTable& table, std::string_view key, std::string_view found,
                         std::string_view accepted) {
  table.fail(table.place_of(key), found, accepted);
}

[[noreturn]] void refuse(const TomlTable& table, std::string_view key, std::string_view accepted) {
  refuse(table, key, fmt::format("{} is {}", key, hal::files::describe(table.node(key, accepted))),
         accepted);
}

/// A text that is not empty.
std::string text(const TomlTable& table, std::string_view key, std::string_view accepted) {
  const auto* const value = table.node(key, accepted).as_string();
  if (value == nullptr || value->get().empty() || value->get().find('\0') != std::string::npos) {
    refuse(table, key, accepted);
  }
  return value->get();
}

std::string text_or(const TomlTable& table, std::string_view key, std::string_view accepted,
                    std::string_view standard) {
  return table.has(key) ? text(table, key, accepted) : std::string(standard);
}

/// The place of the text among `choices`.
std::size_t choice(const TomlTable& table, std::string_view key,
                   std::span<const std::string_view> choices) {
  const std::string accepted = fmt::format("{} \"{}\"", key, fmt::join(choices, "\", \""));
  const auto found = std::find(choices.begin(), choices.end(), text(table, key, accepted));
  if (found == choices.end()) {
    refuse(table, key, accepted);
  }
  return static_cast<std::size_t>(found - choices.begin());
}

int integer(const TomlTable& table, std::string_view key, int minimum, int maximum) {
  const std::string accepted = fmt::format("{} {}..{}, a whole number", key, minimum, maximum);
  const auto* const value = table.node(key, accepted).as_integer();
  if (value == nullptr || value->get() < minimum || value->get() > maximum) {
    refuse(table, key, accepted);
  }
  return static_cast<int>(value->get());
}

class ConfigReader {
 public:
  ConfigReader(std::string_view name, const toml::table& root, const fs::path& folder)
      : folder_(folder),
        root_(with_keys({name, root, "", {1, 1}},
                        {"schema", "node", "can", "loop", "store", "sensor", "tendon", "gpio"})) {}

  Config read() {
    static_cast<void>(integer(root_, "schema", 1, 1));
    read_node();
    read_can();
    read_loop();
    config_.store = path(with_keys(root_.table("store"), {"folder"}), "folder",
                         "a folder to keep the lives in");
    read_sensor();
    read_tendons();
    read_gpio();
    return config_;
  }

 private:
  fs::path path(const TomlTable& table, std::string_view key, std::string_view accepted) const {
    return folder_ / text(table, key, accepted);
  }

  void read_node() {
    const TomlTable node = with_keys(root_.table("node"), {"id", "serial", "authority_key"});
    config_.node = static_cast<protocol::Node>(integer(node, "id", 1, 127));
    constexpr std::string_view kSerial = "serial of 1 to 12 characters";
    config_.serial = text_or(node, "serial", kSerial, "");
    if (config_.serial.size() > 12) {
      refuse(node, "serial", kSerial);
    }
    if (node.has("authority_key")) {
      config_.authority_key = path(node, "authority_key", "a file with the key of this node");
    }
  }

  void read_can() {
    const TomlTable can = with_keys(root_.table("can"), {"interface", "log"});
    config_.can.interface = text(can, "interface", "the name of a CAN interface, or \"none\"");
    if (can.has("log")) {
      if (config_.can.interface != kNoBus) {
        refuse(can, "log", "a log beside a bus",
               "log where interface is \"none\"; candump logs a bus");
      }
      config_.can.log = path(can, "log", "a file for the frames");
    }
  }

  void read_loop() {
    const TomlTable loop = with_keys(root_.table("loop"), {"rate_Hz", "real_time", "priority"});
    config_.loop.period_us =
        static_cast<std::uint32_t>(std::lround(1e6 / loop.number({"rate_Hz", "Hz", {1, 20'000}})));
    if (loop.has("real_time")) {
      config_.loop.real_time = static_cast<RealTime>(choice(loop, "real_time", kRealTime));
    }
    if (loop.has("priority")) {
      config_.loop.priority = integer(loop, "priority", 1, 98);
    }
  }

  void read_sensor() {
    const TomlTable sensor =
        with_keys(root_.table("sensor"), {"kind", "device", "trigger", "at_end"});
    SensorConfig& config = config_.sensor;
    config.kind = static_cast<SensorKind>(choice(sensor, "kind", kSensorKinds));
    only_for(sensor, {"at_end"}, config.kind == SensorKind::profile, "kind is \"profile\"");
    only_for(sensor, {"device"}, config.kind != SensorKind::profile, "kind is \"iio\"");
    only_for(sensor, {"trigger"}, config.kind == SensorKind::iio_buffer, "kind is \"iio-buffer\"");
    if (config.kind == SensorKind::profile) {
      config.at_end = static_cast<AtEnd>(choice(sensor, "at_end", kAtEnd));
    } else {
      config.device = text(sensor, "device", "an IIO device, e.g. \"iio:device0\" or its name");
      config.trigger = text_or(sensor, "trigger", "the name of an IIO trigger", "");
    }
  }

  static void only_for(const TomlTable& table, Keys keys, bool allowed, std::string_view when) {
    for (const std::string_view key : keys) {
      if (table.has(key) && !allowed) {
        refuse(table, key, fmt::format("{} is of no use here", key),
               fmt::format("{} where {}", key, when));
      }
    }
  }

  void read_tendons() {
    const std::string accepted = fmt::format("1 to {} tables [[tendon]]", kMostTendons);
    const auto* const array = root_.node("tendon", accepted).as_array();
    if (array == nullptr || array->empty() || array->size() > kMostTendons ||
        !array->is_homogeneous<toml::table>()) {
      refuse(root_, "tendon",
             array == nullptr ? "tendon is no array of tables"
                              : fmt::format("tendon has {} entries", array->size()),
             accepted);
    }
    for (const toml::node& entry : *array) {
      read_tendon(*entry.as_table());
    }
  }

  void read_tendon(const toml::table& entry) {
    const TomlTable tendon =
        with_keys({root_.file(), entry, "[tendon]", entry.source().begin},
                  {"parameters", "channel", "ampere_per_unit", "profile", kCovariateNames[0],
                   kCovariateNames[1], kCovariateNames[2], kCovariateNames[3]});
    const bool profile = config_.sensor.kind == SensorKind::profile;
    only_for(tendon, {"profile"}, profile, "the sensor is a profile");
    only_for(tendon, {"channel", "ampere_per_unit"}, !profile, "the sensor is of IIO");
    TendonConfig config;
    config.parameters = path(tendon, "parameters", "a parameter block, made by `host_sim pack`");
    if (profile) {
      config.profile = path(tendon, "profile", "a profile (CSV)");
    } else {
      config.channel = channel(tendon);
      config.ampere_per_unit =
          tendon.number_or({"ampere_per_unit", "", {-1e6, 1e6}}, config.ampere_per_unit);
    }
    for (std::size_t i = 0; i < kCovariates; ++i) {
      only_for(tendon, {kCovariateNames[i]}, !profile, "the sensor is of IIO");
      if (tendon.has(kCovariateNames[i])) {
        config.covariates[i] = covariate(tendon.table(kCovariateNames[i]), i);
      }
    }
    config_.tendons.push_back(config);
  }

  [[nodiscard]] std::variant<IioQuantity, BusQuantity> covariate(const TomlTable& table,
                                                                 std::size_t which) const {
    if (table.has("can_id")) {
      return bus_quantity(with_keys(table, {"can_id", "extended", "start_bit", "bits", "signed",
                                            "factor", "zero", "timeout_ms"}));
    }
    with_keys(table, {"device", "channel", "per_unit"});
    // The unit of IIO is 1 rad and 0.001 degrees Celsius; it has none for a way.
    constexpr std::array<double, kCovariates> kPerUnit{0, 1, 1e-3, 1e-3};
    IioQuantity quantity;
    quantity.device = text(table, "device", "an IIO device, or can_id and what lies in its frame");
    quantity.channel = channel(table);
    quantity.per_unit = kPerUnit[which] == 0
                            ? table.number({"per_unit", "", {-1e9, 1e9}})
                            : table.number_or({"per_unit", "", {-1e9, 1e9}}, kPerUnit[which]);
    return quantity;
  }

  [[nodiscard]] BusQuantity bus_quantity(const TomlTable& table) const {
    if (config_.can.interface == kNoBus) {
      refuse(table, "can_id", "a frame, and no bus", "can_id where [can] has an interface");
    }
    BusQuantity quantity;
    quantity.extended = table.flag("extended");
    quantity.id = static_cast<std::uint32_t>(
        integer(table, "can_id", 0, quantity.extended ? 0x1fff'ffff : 0x7ff));
    quantity.start_bit = static_cast<unsigned>(integer(table, "start_bit", 0, 63));
    quantity.bits =
        static_cast<unsigned>(integer(table, "bits", 1, 64 - static_cast<int>(quantity.start_bit)));
    quantity.is_signed = table.flag("signed");
    quantity.factor = table.number_or({"factor", "", {-1e9, 1e9}}, 1);
    quantity.zero = table.number_or({"zero", "", {-1e9, 1e9}}, 0);
    quantity.timeout_ms = static_cast<std::uint32_t>(integer(table, "timeout_ms", 1, 60'000));
    return quantity;
  }

  static std::string channel(const TomlTable& tendon) {
    constexpr std::string_view kAccepted = "a channel of the IIO device, e.g. \"in_current0\"";
    std::string channel = text(tendon, "channel", kAccepted);
    if (channel.find('/') != std::string::npos) {
      refuse(tendon, "channel", kAccepted);
    }
    return channel;
  }

  static LineConfig line(const TomlTable& table, std::string_view key) {
    constexpr std::string_view kAccepted =
        "the name or offset of a line as a text, or { line = \"...\", active_low = true }";
    if (table.node(key, kAccepted).is_string()) {
      return {text(table, key, kAccepted), false};
    }
    if (!table.node(key, kAccepted).is_table()) {
      refuse(table, key, kAccepted);
    }
    const TomlTable entry = with_keys(table.table(key), {"line", "active_low"});
    const auto* const low =
        entry.has("active_low") ? entry.node("active_low", "true or false").as_boolean() : nullptr;
    if (entry.has("active_low") && low == nullptr) {
      refuse(entry, "active_low", "true or false");
    }
    return {text(entry, "line", "the name or offset of a line as a text"),
            low != nullptr && low->get()};
  }

  static std::optional<LineConfig> line_if_any(const TomlTable& table, std::string_view key) {
    return table.has(key) ? std::optional(line(table, key)) : std::nullopt;
  }

  void read_gpio() {
    const TomlTable gpio =
        with_keys(root_.table("gpio"), {"chip", "drive_enable", "brake", "emergency_stop",
                                        "debounce_ms", "status_light", "watchdog"});
    GpioConfig config;
    config.chip = text(gpio, "chip", "a gpiochip by path, name or label, or \"none\"");
    if (config.chip == kNoBus) {
      only_for(
          gpio,
          {"drive_enable", "brake", "emergency_stop", "debounce_ms", "status_light", "watchdog"},
          false, "chip is not \"none\"");
      return;
    }
    config.drive_enable = line(gpio, "drive_enable");
    config.brake = line(gpio, "brake");
    config.emergency_stop = line(gpio, "emergency_stop");
    config.debounce = std::chrono::microseconds(
        std::lround(1e3 * gpio.number_or({"debounce_ms", "ms", {1, 5}}, 2)));
    config.status_light = line_if_any(gpio, "status_light");
    config.watchdog = line_if_any(gpio, "watchdog");
    config_.gpio = config;
  }

  fs::path folder_;
  TomlTable root_;
  Config config_;
};

}  // namespace

Config parse_config(std::string_view text, std::string_view name, const fs::path& folder) {
  const toml::table root = hal::files::parse_toml(text, name);
  return ConfigReader(name, root, folder).read();
}

Config read_config(const fs::path& path) {
  const std::string text =
      hal::files::read_text_file(path, "a configuration (TOML) of at most 1 MiB");
  return parse_config(text, path.string(), path.parent_path());
}

}  // namespace boards::linux_controller
