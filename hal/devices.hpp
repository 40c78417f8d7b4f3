#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include "hal/error.hpp"
#include "lifemodel/quantity/units.hpp"

namespace hal {

/// Gives what a tendon is loaded with: motor current, or, with a load cell, input tension.
///
/// isr_read() gives the newest sample in constant time, from the interrupt of the control loop.
/// missing: no new sample since the last call; failed: the sensor reports a fault or a value that
/// it cannot measure.
template <class T>
concept Sensor = requires(T& sensor, std::size_t tendon) {
  typename T::Sample;
  { sensor.isr_read(tendon) } -> std::same_as<Result<typename T::Sample>>;
};

template <class T>
concept CurrentSensor = Sensor<T> && std::same_as<typename T::Sample, lifemodel::MotorCurrent>;

/// A debounced input line. True is asserted, whatever level that is.
template <class T>
concept DigitalIn = requires(T& line) {
  { line.asserted() } -> std::same_as<Result<bool>>;
};

/// An output line. True is asserted, whatever level that is.
template <class T>
concept DigitalOut = requires(T& line) {
  { line.set(true) } -> std::same_as<Error>;
};

/// Sets both lines of a motor. The drive goes off before the brake closes, and on after the brake
/// has opened: where that fails it stays off. The first error of the two.
template <DigitalOut DriveT, DigitalOut BrakeT>
Error set_motion(DriveT& drive_enable, bool drives, BrakeT& brake, bool holds) {
  if (!drives) {
    const Error off = drive_enable.set(false);
    const Error braked = brake.set(holds);
    return off != Error::none ? off : braked;
  }
  const Error opened = brake.set(holds);
  const Error on = drive_enable.set(opened == Error::none);
  return opened != Error::none ? opened : on;
}

/// Holds back the context that settles, while the context below it reads. The interrupt that
/// samples continues. Does not nest.
template <class T>
concept Hold = requires(T& hold) {
  { hold.hold() } -> std::same_as<void>;
  { hold.release() } -> std::same_as<void>;
};

/// For boards where the same context settles and reads.
struct NoHold {
  void hold() {}
  void release() {}
};

/// Resets the controller, or drops its safety line, unless it is fed in time.
template <class T>
concept Watchdog = requires(T& watchdog) {
  { watchdog.feed() } -> std::same_as<void>;
};

/// Random bytes that nobody can foretell. failed, and nothing usable, where the source is broken.
template <class T>
concept Entropy = requires(T& source, std::span<std::byte> out) {
  { source.fill(out) } -> std::same_as<Error>;
};

}  // namespace hal
