#pragma once

#include <cstddef>

#include "hal/stm32g4/registers/word.hpp"

namespace hal::stm32g4 {

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

}  // namespace hal::stm32g4
