#pragma once

#include <cstdint>

#include "lifemodel/support/result.hpp"

namespace hal {

/// Why a device did not do what it was asked for.
enum class [[nodiscard]] Error : std::uint8_t{
    none,
    full,          ///< no room now; the same call may succeed later
    off,           ///< the device is off the bus or not running
    missing,       ///< no such device, line or channel, or it gave nothing
    busy,          ///< somebody else holds it
    damaged,       ///< what was read cannot be trusted
    failed,        ///< the device reports a fault
    out_of_range,  ///< the arguments are outside what the device has
};

/// The reason in words.
constexpr const char* to_string(Error error) {
  switch (error) {
    case Error::none:
      return "done";
    case Error::full:
      return "no room now";
    case Error::off:
      return "off";
    case Error::missing:
      return "missing";
    case Error::busy:
      return "in use";
    case Error::damaged:
      return "damaged";
    case Error::failed:
      return "failed";
    case Error::out_of_range:
      return "out of range";
  }
  return "unknown";
}

/// A value, or the Error why there is none.
template <class T>
using Result = lifemodel::Result<T, Error>;

}  // namespace hal
