#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/can_frame.hpp"
#include "hal/can_port.hpp"
#include "hal/stm32g4/register.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::stm32g4 {

/// CAN controller, RM0440 44.4.
template <Word W>
struct FdcanRegisters {
  W crel, endn;
  W reserved_08;
  W dbtp, test, rwd, cccr, nbtp, tscc, tscv, tocc, tocv;
  W reserved_30[4];
  W ecr, psr, tdcr;
  W reserved_4c;
  W ir, ie, ils, ile;
  W reserved_60[8];
  W rxgfc, xidam, hpms;
  W reserved_8c;
  W rxf0s, rxf0a, rxf1s, rxf1a;
  W reserved_a0[8];
  W txbc, txfqs, txbrp, txbar, txbcr, txbto, txbcf, txbtie, txbcie, txefs, txefa;
  W reserved_ec[5];
  W ckdiv;
};
static_assert(offsetof(FdcanRegisters<Register>, cccr) == 0x18);
static_assert(offsetof(FdcanRegisters<Register>, nbtp) == 0x1C);
static_assert(offsetof(FdcanRegisters<Register>, ecr) == 0x40);
static_assert(offsetof(FdcanRegisters<Register>, psr) == 0x44);
static_assert(offsetof(FdcanRegisters<Register>, ir) == 0x50);
static_assert(offsetof(FdcanRegisters<Register>, rxgfc) == 0x80);
static_assert(offsetof(FdcanRegisters<Register>, rxf0s) == 0x90);
static_assert(offsetof(FdcanRegisters<Register>, txbc) == 0xC0);
static_assert(offsetof(FdcanRegisters<Register>, txbar) == 0xCC);
static_assert(offsetof(FdcanRegisters<Register>, ckdiv) == 0x100);

namespace fdcan {
// CCCR, 44.4.6
inline constexpr std::uint32_t kInit = bit(0), kConfigure = bit(1);
// NBTP, 44.4.7: all fields are one less than what they stand for
constexpr std::uint32_t bit_timing(std::uint32_t prescaler, std::uint32_t segment1,
                                   std::uint32_t segment2, std::uint32_t jump) {
  return (jump - 1) << 25 | (prescaler - 1) << 16 | (segment1 - 1) << 8 | (segment2 - 1);
}
// ECR, 44.4.12
constexpr std::uint32_t transmit_errors(std::uint32_t ecr) {
  return ecr & 0xFFu;
}
constexpr std::uint32_t receive_errors(std::uint32_t ecr) {
  return ecr >> 8 & 0x7Fu;
}
inline constexpr std::uint32_t kReceivePassive = bit(15);
// PSR, 44.4.13
inline constexpr std::uint32_t kPassive = bit(5), kWarning = bit(6), kBusOff = bit(7);
// IR, 44.4.15
inline constexpr std::uint32_t kFifo0Lost = bit(2);
// RXGFC, 44.4.19
inline constexpr std::uint32_t kRejectRemoteExtended = bit(0), kRejectRemoteStandard = bit(1);
inline constexpr std::uint32_t kRejectOtherExtended = 2u << 2, kRejectOtherStandard = 2u << 4;
constexpr std::uint32_t filters(std::uint32_t standard, std::uint32_t extended) {
  return standard << 16 | extended << 24;
}
// RXF0S, 44.4.22
constexpr std::uint32_t fill_level(std::uint32_t rxf0s) {
  return rxf0s & 0xFu;
}
constexpr std::uint32_t get_index(std::uint32_t rxf0s) {
  return rxf0s >> 8 & 3u;
}
// TXFQS, 44.4.27
inline constexpr std::uint32_t kTransmitFull = bit(21);
constexpr std::uint32_t put_index(std::uint32_t txfqs) {
  return txfqs >> 16 & 3u;
}
}  // namespace fdcan

/// A frame in the message RAM: two header words and 64 bytes of data, RM0440 44.3.6, 44.3.7.
template <Word W>
struct MessageElement {
  W header[2];
  W data[16];
};

/// Message RAM of one controller, whose layout is fixed: RM0440 44.3.3. Words only.
template <Word W>
struct MessageRam {
  static constexpr std::size_t kStandardFilters = 28;
  static constexpr std::size_t kExtendedFilters = 8;
  static constexpr std::size_t kFifo = 3;

  W standard_filter[kStandardFilters];
  W extended_filter[kExtendedFilters][2];
  MessageElement<W> rx_fifo0[kFifo];
  MessageElement<W> rx_fifo1[kFifo];
  W tx_event[kFifo][2];
  MessageElement<W> tx_buffer[kFifo];
};
static_assert(offsetof(MessageRam<Register>, extended_filter) == 0x070);
static_assert(offsetof(MessageRam<Register>, rx_fifo0) == 0x0B0);
static_assert(offsetof(MessageRam<Register>, rx_fifo1) == 0x188);
static_assert(offsetof(MessageRam<Register>, tx_event) == 0x260);
static_assert(offsetof(MessageRam<Register>, tx_buffer) == 0x278);
static_assert(sizeof(MessageRam<Register>) == 0x350);

namespace message_ram {
// Standard filter element, 44.3.9: mask filter into FIFO 0
constexpr std::uint32_t standard_filter(std::uint32_t id) {
  return 2u << 30 | 1u << 27 | id << 16 | 0x7FFu;
}
// Extended filter element, 44.3.10: mask filter into FIFO 0
constexpr std::uint32_t extended_filter_0(std::uint32_t id) {
  return 1u << 29 | id;
}
inline constexpr std::uint32_t kExtendedFilter1 = 2u << 30 | 0x1FFFFFFFu;
// Elements, 44.3.6 and 44.3.7
inline constexpr std::uint32_t kExtendedId = bit(30), kRemote = bit(29);
inline constexpr unsigned kStandardIdShift = 18, kLengthShift = 16;
}  // namespace message_ram

namespace detail {
constexpr std::uint32_t word_at(const CanFrame& frame, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    word |= std::to_integer<std::uint32_t>(frame.data[offset + i]) << (8 * i);
  }
  return word;
}
}  // namespace detail

/// Writes a data frame of classic CAN, RM0440 44.3.7. Stores no event.
template <Word W>
void put_message(MessageElement<W>& element, const CanFrame& frame) {
  element.header[0].write(frame.extended ? message_ram::kExtendedId | (frame.id & 0x1FFFFFFFu)
                                         : (frame.id & 0x7FFu) << message_ram::kStandardIdShift);
  element.header[1].write(std::uint32_t{frame.length} << message_ram::kLengthShift);
  element.data[0].write(detail::word_at(frame, 0));
  element.data[1].write(detail::word_at(frame, 4));
}

/// Reads one, RM0440 44.3.6; nothing where it is a remote frame. A length above 8 means 8.
template <Word W>
std::optional<CanFrame> take_message(const MessageElement<W>& element) {
  const std::uint32_t id = element.header[0].read();
  if ((id & message_ram::kRemote) != 0) {
    return std::nullopt;
  }
  CanFrame frame;
  frame.extended = (id & message_ram::kExtendedId) != 0;
  frame.id = frame.extended ? id & 0x1FFFFFFFu : id >> message_ram::kStandardIdShift & 0x7FFu;
  const std::uint32_t length = element.header[1].read() >> message_ram::kLengthShift & 0xFu;
  frame.length = static_cast<std::uint8_t>(std::min<std::uint32_t>(length, 8));
  const std::uint32_t words[2] = {element.data[0].read(), element.data[1].read()};
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = static_cast<std::byte>(words[i / 4] >> (8 * (i % 4)));
  }
  return frame;
}

/// Frames on their way from an interrupt to the idle loop. Neither waits for the other.
template <std::size_t kCapacity>
class CanMailbox {
  static_assert(kCapacity != 0 && (kCapacity & (kCapacity - 1)) == 0, "a power of two");

 public:
  /// False, and the frame is lost, where there is no room.
  [[nodiscard]] bool isr_put(const CanFrame& frame) {
    const std::uint32_t head = head_.own();
    if (head - tail_.acquire() == kCapacity) {
      return false;
    }
    frames_[head % kCapacity] = frame;
    head_.release(head + 1);
    return true;
  }
  [[nodiscard]] std::optional<CanFrame> take() {
    const std::uint32_t tail = tail_.own();
    if (head_.acquire() == tail) {
      return std::nullopt;
    }
    const CanFrame frame = frames_[tail % kCapacity];
    tail_.release(tail + 1);
    return frame;
  }

 private:
  lifemodel::SharedWord<std::uint32_t> head_;
  lifemodel::SharedWord<std::uint32_t> tail_;
  std::array<CanFrame, kCapacity> frames_{};
};

/// The frames that a node listens to, one id each.
struct CanFilters {
  std::uint32_t standard_id;
  std::uint32_t extended_id;
};

/// hal::CanPort on FDCAN1: classic CAN, 1 Mbit/s, sample point 87.6 %.
///
/// The hardware holds three received frames and the shortest frame takes 47 us, so the interrupt
/// of a 10 kHz control loop moves them to a mailbox before any is lost.
template <Word W>
class CanController {
 public:
  static constexpr std::size_t kMailbox = 32;

  CanController(FdcanRegisters<W>& registers, MessageRam<W>& ram)
      : registers_(registers), ram_(ram) {}

  /// Joins the bus. The kernel clock is 170 MHz.
  Error start(const CanFilters& filters) {
    // RM0440 44.3.2: CCE can be set only while INIT reads one.
    set_bits(registers_.cccr, fdcan::kInit);
    if (wait_until(registers_.cccr, fdcan::kInit, fdcan::kInit, kPolls) != Error::none) {
      return Error::failed;
    }
    registers_.cccr.write(fdcan::kInit | fdcan::kConfigure);
    registers_.ckdiv.write(0);
    registers_.nbtp.write(fdcan::bit_timing(1, 148, 21, 21));
    registers_.rxgfc.write(fdcan::kRejectRemoteExtended | fdcan::kRejectRemoteStandard |
                           fdcan::kRejectOtherExtended | fdcan::kRejectOtherStandard |
                           fdcan::filters(1, 1));
    // A FIFO: what was sent first leaves first.
    registers_.txbc.write(0);
    clear_ram();
    ram_.standard_filter[0].write(message_ram::standard_filter(filters.standard_id));
    ram_.extended_filter[0][0].write(message_ram::extended_filter_0(filters.extended_id));
    ram_.extended_filter[0][1].write(message_ram::kExtendedFilter1);
    registers_.cccr.write(0);
    return wait_until(registers_.cccr, fdcan::kInit, 0, kPolls);
  }

  Error send(const CanFrame& frame) {
    if (is_off()) {
      return Error::off;
    }
    const std::uint32_t queue = registers_.txfqs.read();
    if ((queue & fdcan::kTransmitFull) != 0) {
      return Error::full;
    }
    const std::uint32_t index = fdcan::put_index(queue);
    put_message(ram_.tx_buffer[index], frame);
    registers_.txbar.write(bit(index));
    return Error::none;
  }

  [[nodiscard]] std::optional<CanFrame> receive() { return mailbox_.take(); }

  /// Empties the hardware's FIFO into the mailbox and looks for bus-off; bounded.
  void isr_receive() {
    for (std::size_t i = 0; i < MessageRam<W>::kFifo; ++i) {
      const std::uint32_t fifo = registers_.rxf0s.read();
      if (fdcan::fill_level(fifo) == 0) {
        break;
      }
      const std::uint32_t index = fdcan::get_index(fifo);
      const auto frame = take_message(ram_.rx_fifo0[index]);
      registers_.rxf0a.write(index);
      if (frame && !mailbox_.isr_put(*frame)) {
        count_lost();
      }
    }
    if ((registers_.ir.read() & fdcan::kFifo0Lost) != 0) {
      registers_.ir.write(fdcan::kFifo0Lost);
      count_lost();
    }
    const bool off = (registers_.psr.read() & fdcan::kBusOff) != 0;
    if (off && !was_off_) {
      bus_offs_.set_relaxed(bus_offs_.own() + 1);
    }
    was_off_ = off;
  }

  [[nodiscard]] CanStatus status() const {
    const std::uint32_t errors = registers_.ecr.read();
    const std::uint32_t protocol = registers_.psr.read();
    CanStatus status;
    status.state = (protocol & fdcan::kBusOff) != 0    ? CanState::off
                   : (protocol & fdcan::kPassive) != 0 ? CanState::passive
                   : (protocol & fdcan::kWarning) != 0 ? CanState::warning
                                                       : CanState::active;
    status.transmit_errors = static_cast<std::uint8_t>(fdcan::transmit_errors(errors));
    // Seven bits, and a flag for 128 and more (RM0440 44.4.12).
    status.receive_errors = (errors & fdcan::kReceivePassive) != 0
                                ? std::uint8_t{128}
                                : static_cast<std::uint8_t>(fdcan::receive_errors(errors));
    status.bus_offs = bus_offs_.relaxed();
    status.lost = lost_.relaxed();
    return status;
  }

  /// Lets the controller wait for 129 times 11 recessive bits and come back (RM0440 44.3.2). What
  /// was given to send leaves then.
  Error recover() {
    if (is_off()) {
      clear_bits(registers_.cccr, fdcan::kInit | fdcan::kConfigure);
    }
    return Error::none;
  }

 private:
  static constexpr std::uint32_t kPolls = 100'000;

  [[nodiscard]] bool is_off() const {
    return (registers_.cccr.read() & fdcan::kInit) != 0 ||
           (registers_.psr.read() & fdcan::kBusOff) != 0;
  }
  void count_lost() { lost_.set_relaxed(lost_.own() + 1); }

  void clear_ram() {
    for (W& word : ram_.standard_filter) {
      word.write(0);
    }
    for (auto& filter : ram_.extended_filter) {
      filter[0].write(0);
      filter[1].write(0);
    }
  }

  FdcanRegisters<W>& registers_;
  MessageRam<W>& ram_;
  CanMailbox<kMailbox> mailbox_;
  lifemodel::SharedWord<std::uint32_t> bus_offs_;
  lifemodel::SharedWord<std::uint32_t> lost_;
  bool was_off_ = false;
};

}  // namespace hal::stm32g4
