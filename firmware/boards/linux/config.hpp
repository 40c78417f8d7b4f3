#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "firmware/protocol/messages.hpp"

namespace boards::linux_controller {

/// An interface name that stands for no bus: frames go into a log.
inline constexpr std::string_view kNoBus = "none";

struct CanConfig {
  std::string interface;
  std::filesystem::path log;  ///< without a bus, where the frames go; empty: nowhere
};

/// What to do where the real-time scheduling of the control loop is refused.
enum class RealTime : std::uint8_t { off, prefer, require };

struct LoopConfig {
  std::uint32_t period_us = 1'000;
  RealTime real_time = RealTime::prefer;
  int priority = 50;
};

enum class SensorKind : std::uint8_t { iio, iio_buffer, profile };
enum class AtEnd : std::uint8_t { stop, repeat };

struct SensorConfig {
  SensorKind kind = SensorKind::iio;
  std::string device;   ///< of IIO
  std::string trigger;  ///< of IIO; empty: the one that is set
  AtEnd at_end = AtEnd::stop;
};

/// What the effects of an extended model are written in terms of, as profiles name it.
enum class Covariate : std::uint8_t {
  tendon_velocity,
  motor_angle,
  sheath_temperature,
  winding_temperature,
};
inline constexpr std::size_t kCovariates = 4;
inline constexpr std::array<std::string_view, kCovariates> kCovariateNames{
    "tendon_velocity_m_s", "motor_angle_rad", "sheath_temperature_C", "winding_temperature_C"};

/// A channel of IIO.
struct IioQuantity {
  std::string device;
  std::string channel;
  double per_unit = 1;
};

/// A number in frames of others on the bus, little-endian.
struct BusQuantity {
  std::uint32_t id = 0;
  bool extended = false;  ///< 29 bits
  unsigned start_bit = 0;
  unsigned bits = 16;  ///< 1 .. 64, in the 8 bytes of a frame
  bool is_signed = false;
  double factor = 1;
  double zero = 0;               ///< added
  std::uint32_t timeout_ms = 0;  ///< so long it is used
};

struct TendonConfig {
  std::filesystem::path parameters;
  std::string channel;            ///< of IIO
  double ampere_per_unit = 1e-3;  ///< of IIO
  std::filesystem::path profile;
  std::array<std::optional<std::variant<IioQuantity, BusQuantity>>, kCovariates> covariates;
};

struct LineConfig {
  std::string line;  ///< name, or offset in digits
  bool active_low = false;
};

struct GpioConfig {
  std::string chip;
  LineConfig drive_enable;
  LineConfig brake;
  LineConfig emergency_stop;
  std::chrono::microseconds debounce{2'000};
  std::optional<LineConfig> status_light;
  std::optional<LineConfig> watchdog;
};

inline constexpr std::size_t kMostTendons = 4;

/// What `controller.toml` says; see examples/controller.toml.
struct Config {
  protocol::Node node = 1;
  std::string serial;  ///< at most 12 characters
  std::optional<std::filesystem::path> authority_key;
  CanConfig can;
  LoopConfig loop;
  std::filesystem::path store;
  SensorConfig sensor;
  std::vector<TendonConfig> tendons;  ///< 1 .. kMostTendons
  std::optional<GpioConfig> gpio;     ///< nothing: bench without lines
};

/// Reads a configuration; relative paths in it start at `folder`. Throws hal::files::InputError.
Config parse_config(std::string_view text, std::string_view name,
                    const std::filesystem::path& folder = {});
/// The same of a file of at most 1 MiB; relative paths start at its folder.
Config read_config(const std::filesystem::path& path);

}  // namespace boards::linux_controller
