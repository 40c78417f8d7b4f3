#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"
#include "hal/qemu_mps2/register.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::qemu_mps2 {

/// The APB UART of the Cortex-M System Design Kit, Technical Reference Manual (DDI 0479), 4.3.
struct UartRegisters {
  Register data;
  Register state;
  Register control;
  Register interrupt;  ///< reads which are pending; writing ones clears those
  Register baud_divider;
};
static_assert(offsetof(UartRegisters, data) == 0x00);
static_assert(offsetof(UartRegisters, state) == 0x04);
static_assert(offsetof(UartRegisters, control) == 0x08);
static_assert(offsetof(UartRegisters, interrupt) == 0x0c);
static_assert(offsetof(UartRegisters, baud_divider) == 0x10);

namespace uart {

/// STATE. Overruns are cleared by writing ones.
inline constexpr std::uint32_t kTransmitFull = 1u << 0;
inline constexpr std::uint32_t kReceiveFull = 1u << 1;
inline constexpr std::uint32_t kTransmitOverrun = 1u << 2;
inline constexpr std::uint32_t kReceiveOverrun = 1u << 3;

/// CTRL.
inline constexpr std::uint32_t kTransmitEnable = 1u << 0;
inline constexpr std::uint32_t kReceiveEnable = 1u << 1;
inline constexpr std::uint32_t kReceiveInterruptEnable = 1u << 3;

/// INTSTATUS and INTCLEAR.
inline constexpr std::uint32_t kReceiveInterrupt = 1u << 1;

/// BAUDDIV: the clock is divided by 16 at least.
inline constexpr std::uint32_t kLowestDivider = 16;
inline constexpr std::uint32_t kHighestDivider = 0xf'ffff;

}  // namespace uart

/// Driver of the APB UART. The device holds one byte each way, so an interrupt takes what arrives
/// into a queue of `kQueue` bytes; what leaves is written by the caller, as fast as the device
/// takes it.
///
/// `Registers` has the members of UartRegisters, each with read() and write().
template <class Registers = UartRegisters, std::size_t kQueue = 256>
class Uart {
  static_assert(std::has_single_bit(kQueue));

 public:
  explicit Uart(Registers& registers) : registers_(registers) {}

  /// 8 data bits, no parity, one stop bit. out_of_range where the divider of the clock is; then
  /// nothing has happened.
  Error start(std::uint32_t clock_Hz, std::uint32_t bits_per_s) {
    const std::uint32_t divider = bits_per_s == 0 ? 0 : clock_Hz / bits_per_s;
    if (divider < uart::kLowestDivider || divider > uart::kHighestDivider) {
      return Error::out_of_range;
    }
    registers_.control.write(0);
    registers_.baud_divider.write(divider);
    registers_.state.write(uart::kTransmitOverrun | uart::kReceiveOverrun);
    registers_.interrupt.write(uart::kReceiveInterrupt);
    registers_.control.write(uart::kTransmitEnable | uart::kReceiveEnable |
                             uart::kReceiveInterruptEnable);
    return Error::none;
  }

  /// The receive interrupt: takes the byte that has arrived. Where the queue is full it is lost and
  /// counted.
  void isr_receive() {
    registers_.interrupt.write(uart::kReceiveInterrupt);
    const std::uint32_t state = registers_.state.read();
    if ((state & uart::kReceiveOverrun) != 0) {
      registers_.state.write(uart::kReceiveOverrun);
      lost_.set_relaxed(lost_.own() + 1);
    }
    if ((state & uart::kReceiveFull) == 0) {
      return;
    }
    const auto byte = static_cast<std::byte>(registers_.data.read());
    const std::uint32_t arrived = arrived_.own();
    if (arrived - taken_.acquire() == kQueue) {
      lost_.set_relaxed(lost_.own() + 1);
      return;
    }
    queue_[arrived % kQueue] = byte;
    arrived_.release(arrived + 1);
  }

  std::size_t try_read(std::span<std::byte> out) {
    const std::uint32_t taken = taken_.own();
    const std::uint32_t waiting = arrived_.acquire() - taken;
    std::size_t count = 0;
    while (count < out.size() && count < waiting) {
      out[count] = queue_[(taken + count) % kQueue];
      ++count;
    }
    taken_.release(taken + static_cast<std::uint32_t>(count));
    return count;
  }

  std::size_t try_write(std::span<const std::byte> in) {
    std::size_t count = 0;
    while (count < in.size() && (registers_.state.read() & uart::kTransmitFull) == 0) {
      registers_.data.write(static_cast<std::uint32_t>(in[count++]));
    }
    return count;
  }

  /// Times that bytes were lost on their way in, modulo 2^32.
  [[nodiscard]] std::uint32_t lost() const { return lost_.relaxed(); }

 private:
  Registers& registers_;
  std::array<std::byte, kQueue> queue_{};
  lifemodel::SharedWord<std::uint32_t> arrived_;
  lifemodel::SharedWord<std::uint32_t> taken_;
  lifemodel::SharedWord<std::uint32_t> lost_;
};

}  // namespace hal::qemu_mps2
