#pragma once

#include <cstdint>

#include "hal/result.hpp"
#include "hal/stm32g4/registers/gpio.hpp"

namespace hal::stm32g4 {

/// A line of a port, 0 .. 15.
template <Word W>
struct Pin {
  GpioRegisters<W>& port;
  unsigned line;
};

enum class Pull : std::uint8_t { none = 0, up = 1, down = 2 };
enum class Level : std::uint8_t { low, high };

/// Which level of a line is asserted.
enum class Active : std::uint8_t { low, high };

template <Word W>
void drive(Pin<W> pin, Level level) {
  pin.port.bsrr.write(bit(pin.line) << (level == Level::high ? 0 : 16));
}

namespace detail {
template <Word W>
void mode(Pin<W> pin, std::uint32_t value) {
  replace_bits(pin.port.moder, 3u << (2 * pin.line), value << (2 * pin.line));
}
}  // namespace detail

/// An output, push-pull, which has its level before it becomes one (RM0440 9.3.10).
template <Word W>
void make_output(Pin<W> pin, Level level) {
  drive(pin, level);
  clear_bits(pin.port.otyper, bit(pin.line));
  detail::mode(pin, 1);
}

template <Word W>
void make_input(Pin<W> pin, Pull pull) {
  replace_bits(pin.port.pupdr, 3u << (2 * pin.line),
               static_cast<std::uint32_t>(pull) << (2 * pin.line));
  detail::mode(pin, 0);
}

/// Disconnects the digital side (RM0440 9.3.13).
template <Word W>
void make_analog(Pin<W> pin) {
  clear_bits(pin.port.pupdr, 3u << (2 * pin.line));
  detail::mode(pin, 3);
}

/// A line of a peripheral; `function` 0 .. 15 by the data sheet's table, fast edges.
template <Word W>
void make_alternate(Pin<W> pin, std::uint32_t function) {
  const unsigned shift = 4 * (pin.line % 8);
  replace_bits(pin.port.afr[pin.line / 8], 15u << shift, function << shift);
  replace_bits(pin.port.ospeedr, 3u << (2 * pin.line), 2u << (2 * pin.line));
  detail::mode(pin, 2);
}

/// hal::DigitalOut on a line. Becomes an output by start(), not asserted.
template <Word W>
class OutputPin {
 public:
  OutputPin(Pin<W> pin, Active active) : pin_(pin), active_(active) {}

  void start(bool asserted) { make_output(pin_, level(asserted)); }

  /// failed, where the line is not driven to its level, as by a short circuit.
  Error set(bool asserted) {
    drive(pin_, level(asserted));
    // The input stage follows two bus cycles later (RM0440 9.3.10).
    const std::uint32_t expected = level(asserted) == Level::high ? bit(pin_.line) : 0;
    return wait_until(pin_.port.idr, bit(pin_.line), expected, kSettlePolls);
  }

 private:
  static constexpr std::uint32_t kSettlePolls = 64;
  [[nodiscard]] Level level(bool asserted) const {
    return asserted == (active_ == Active::high) ? Level::high : Level::low;
  }
  Pin<W> pin_;
  Active active_;
};

}  // namespace hal::stm32g4
