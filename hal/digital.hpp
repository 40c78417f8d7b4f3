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

}  // namespace hal
