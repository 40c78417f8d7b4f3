#pragma once

#include <concepts>

#include "hal/error.hpp"
#include "hal/result.hpp"

namespace hal {

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

}  // namespace hal
