#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/error.hpp"
#include "hal/stm32g4/register.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::stm32g4 {

/// One port of general-purpose lines, RM0440 9.4.
template <Word W>
struct GpioRegisters {
  W moder, otyper, ospeedr, pupdr, idr, odr, bsrr, lckr;
  W afr[2];  ///< AFRL, AFRH
  W brr;
};
static_assert(offsetof(GpioRegisters<Register>, idr) == 0x10);
static_assert(offsetof(GpioRegisters<Register>, bsrr) == 0x18);
static_assert(offsetof(GpioRegisters<Register>, afr) == 0x20);
static_assert(offsetof(GpioRegisters<Register>, brr) == 0x28);

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

/// hal::DigitalIn on a line that bounces. The interrupt of the control loop samples it; it changes
/// after `kSamples` equal samples in a row, so a change is seen within that time of its last edge.
template <Word W, std::uint32_t kSamples>
class DebouncedInput {
 public:
  DebouncedInput(Pin<W> pin, Active active) : pin_(pin), active_(active) {}

  /// Takes the level as it is now.
  void start(Pull pull) {
    make_input(pin_, pull);
    asserted_.set_relaxed(level() ? 1 : 0);
    started_.set_relaxed(1);
  }

  void isr_sample() {
    const std::uint32_t now = level() ? 1 : 0;
    differing_ = now == asserted_.own() ? 0 : differing_ + 1;
    if (differing_ == kSamples) {
      asserted_.set_relaxed(now);
      differing_ = 0;
    }
  }

  /// off, before start().
  [[nodiscard]] Result<bool> asserted() const {
    if (started_.relaxed() == 0) {
      return Error::off;
    }
    return asserted_.relaxed() != 0;
  }

 private:
  [[nodiscard]] bool level() const {
    return ((pin_.port.idr.read() & bit(pin_.line)) != 0) == (active_ == Active::high);
  }

  Pin<W> pin_;
  Active active_;
  std::uint32_t differing_ = 0;
  lifemodel::SharedWord<std::uint32_t> asserted_;
  lifemodel::SharedWord<std::uint32_t> started_;
};

}  // namespace hal::stm32g4
