#pragma once

#include <cstdint>
#include <optional>

#include "hal/can_port.hpp"
#include "hal/stm32g4/can_mailbox.hpp"
#include "hal/stm32g4/message_codec.hpp"
#include "hal/stm32g4/registers/fdcan.hpp"
#include "hal/stm32g4/registers/message_ram.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::stm32g4 {

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
