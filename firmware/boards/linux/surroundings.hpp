#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "firmware/boards/linux/config.hpp"
#include "hal/can_frame.hpp"
#include "hal/clock.hpp"
#include "hal/error.hpp"
#include "hal/linux/can_calls.hpp"
#include "hal/linux/iio.hpp"
#include "lifemodel/extension/needs.hpp"
#include "lifemodel/extension/sample.hpp"

namespace boards::linux_controller {

/// The number in a frame of others; nothing where the frame is another or too short.
std::optional<double> value_in(const BusQuantity& quantity, const hal::CanFrame& frame);

/// A value that one thread finds and the control loop takes, until it is too old.
class HeldValue {
 public:
  explicit HeldValue(hal::Time longest) : longest_(longest) {}

  void put(double value, hal::Time now) {
    value_.store(value, std::memory_order_relaxed);
    at_us_.store(now.us, std::memory_order_release);
  }
  /// missing: there was none in time.
  [[nodiscard]] hal::Result<double> isr_get(hal::Time now) const {
    const hal::Time at{at_us_.load(std::memory_order_acquire)};
    if (at == hal::Time{} || now > at + longest_) {
      return hal::Error::missing;
    }
    return value_.load(std::memory_order_relaxed);
  }

 private:
  static_assert(std::atomic<double>::is_always_lock_free);

  hal::Time longest_;
  std::atomic<double> value_{0};
  std::atomic<std::uint64_t> at_us_{0};  ///< 0: never
};

/// What motor current is sampled in, for the effects of an extended model: channels of IIO, and
/// numbers in frames of others on the bus. A velocity and an angle of IIO are read in the control
/// loop, whose time they take; a temperature of IIO every 100 ms by the other thread.
class Surroundings {
 public:
  static constexpr hal::Time kSlowPeriod = hal::milliseconds(100);
  /// A temperature of IIO is used for so long.
  static constexpr hal::Time kSlowLongest = hal::seconds(1);

  /// Throws hal::linux_os::DeviceError.
  explicit Surroundings(const Config& config, const std::filesystem::path& sysfs = "/sys");
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  /// At this instant; an error of the first quantity that has no value. What is not configured is
  /// 0.
  hal::Result<lifemodel::extension::Covariates> isr_read(std::size_t tendon, hal::Time now);

  /// Of the application's thread.
  void poll(hal::Time now);
  /// Of the application's thread: a frame of whatever node.
  void take(const hal::CanFrame& frame, hal::Time now);

 private:
  struct Quantity {
    Covariate covariate{};
    std::optional<BusQuantity> bus;
    std::optional<hal::linux_os::IioValue> channel;
    std::unique_ptr<HeldValue> held;  ///< of what is not read in the control loop

    [[nodiscard]] hal::Result<double> isr_value(hal::Time now) const;
  };

  std::vector<std::vector<Quantity>> tendons_;
  hal::Time next_slow_{};
};

/// The frames that a configuration takes quantities from.
std::vector<hal::linux_os::CanFilter> filters_of(const Config& config);

/// What a controller with this configuration measures besides motor current.
lifemodel::extension::Measured measured_by(const TendonConfig& tendon);

}  // namespace boards::linux_controller
