#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "firmware/boards/linux/config.hpp"
#include "hal/can_port.hpp"
#include "hal/clock.hpp"
#include "hal/devices.hpp"
#include "hal/error.hpp"
#include "hal/files/output_file.hpp"
#include "hal/linux/gpiod_lines.hpp"
#include "hal/linux/monotonic_clock.hpp"
#include "hal/linux/service_manager.hpp"
#include "hal/linux/socketcan.hpp"

namespace boards::linux_controller {

/// The clock of the machine, or a virtual one that only advance() moves.
class BoardClock {
 public:
  explicit BoardClock(bool is_virtual) : virtual_(is_virtual) {}

  [[nodiscard]] hal::Time now() const { return virtual_ ? now_ : machine_.now(); }
  void advance_to(hal::Time time) { now_ = time; }

 private:
  bool virtual_;
  hal::linux_os::MonotonicClock machine_;
  hal::Time now_{};
};
static_assert(hal::Clock<BoardClock>);

/// The bus of the configuration: an interface of SocketCAN, or none, with the frames in a log as
/// `candump -L` writes it.
class BoardCan {
 public:
  /// Hears of every frame that is received.
  using Heard = std::function<void(const hal::CanFrame&)>;

  /// `clock` outlives the port; `also` are frames to receive that are not for the node. Throws
  /// hal::linux_os::DeviceError or hal::files::OutputError.
  BoardCan(const CanConfig& config, protocol::Node node, const BoardClock& clock,
           std::span<const hal::linux_os::CanFilter> also, Heard heard);

  hal::Error send(const hal::CanFrame& frame);
  std::optional<hal::CanFrame> receive();
  [[nodiscard]] hal::CanStatus status() const;
  hal::Error recover();

  /// Nothing without a bus.
  [[nodiscard]] const hal::linux_os::SocketCanCounts* counts() const;
  /// Frames that went into the log.
  [[nodiscard]] std::uint64_t logged() const { return logged_; }
  /// Puts the log in place. Throws hal::files::OutputError.
  void finish();

 private:
  const BoardClock& clock_;
  hal::linux_os::CanCalls calls_;
  std::optional<hal::linux_os::SocketCan> bus_;
  std::optional<hal::files::OutputFile> log_;
  std::uint64_t logged_ = 0;
  Heard heard_;
};
static_assert(hal::CanPort<BoardCan>);

inline hal::linux_os::LineSpec spec_of(const LineConfig& line) {
  return {line.line, line.active_low};
}

/// Drive enable and brake in one request, and the emergency stop. Without a configuration there are
/// no lines: outputs go nowhere, and nobody stops.
class SafetyLines {
 public:
  /// Throws hal::linux_os::DeviceError.
  explicit SafetyLines(const std::optional<GpioConfig>& config) {
    if (config) {
      const std::array lines{spec_of(config->drive_enable), spec_of(config->brake)};
      outputs_.emplace(config->chip, lines);
      stop_.emplace(config->chip, spec_of(config->emergency_stop), config->debounce);
    }
  }
  SafetyLines(const SafetyLines&) = delete;
  SafetyLines& operator=(const SafetyLines&) = delete;

  struct Output {
    hal::Error set(bool on) { return outputs ? outputs->set(index, on) : hal::Error::none; }

    std::optional<hal::linux_os::GpioOutputs>& outputs;
    std::size_t index;
  };
  struct Stop {
    hal::Result<bool> asserted() { return stop ? stop->asserted() : hal::Result<bool>(false); }

    std::optional<hal::linux_os::GpioEmergencyStop>& stop;
  };

  Output drive_enable{outputs_, 0};
  Output brake{outputs_, 1};
  Stop emergency_stop{stop_};

 private:
  std::optional<hal::linux_os::GpioOutputs> outputs_;
  std::optional<hal::linux_os::GpioEmergencyStop> stop_;
};

/// An output that need not be there.
class OptionalOutput {
 public:
  /// Throws hal::linux_os::DeviceError.
  OptionalOutput(const std::optional<GpioConfig>& gpio,
                 std::optional<LineConfig> GpioConfig::*which) {
    if (gpio && (*gpio).*which) {
      output_.emplace(gpio->chip, spec_of(*((*gpio).*which)));
    }
  }
  hal::Error set(bool on) { return output_ ? output_->set(on) : hal::Error::none; }

 private:
  std::optional<hal::linux_os::GpioOutput> output_;
};

/// Toggles the watchdog pin at each feed, and feeds the watchdog of systemd.
class Watchdog {
 public:
  Watchdog(const std::optional<GpioConfig>& gpio, hal::linux_os::ServiceManager& manager)
      : pin_(gpio, &GpioConfig::watchdog), manager_(manager) {}

  void feed() {
    level_ = !level_;
    // A pin that fails is noticed by what it feeds.
    static_cast<void>(pin_.set(level_));
    manager_.alive(hal::linux_os::MonotonicClock().now());
  }

 private:
  OptionalOutput pin_;
  hal::linux_os::ServiceManager& manager_;
  bool level_ = false;
};
static_assert(hal::Watchdog<Watchdog>);

/// Whose turn it is with what has been counted: the control loop's, which settles and never waits,
/// or the application's, which reads.
class SettleTurn {
 public:
  /// Of the application.
  void hold() { mutex_.lock(); }
  void release() { mutex_.unlock(); }

  /// Of the control loop: calls `settle` while it gives true, at most `most` times, unless the
  /// application reads; then what waits is settled in a later period.
  template <class Settle>
  void isr_settle(std::size_t most, Settle&& settle) {
    const std::unique_lock turn(mutex_, std::try_to_lock);
    for (std::size_t i = 0; turn && i < most && settle(); ++i) {
    }
  }

 private:
  std::mutex mutex_;
};
static_assert(hal::Hold<SettleTurn>);

}  // namespace boards::linux_controller
