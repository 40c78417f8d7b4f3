#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/can_frame.hpp"
#include "hal/stm32g4/registers/message_ram.hpp"

namespace hal::stm32g4 {

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

}  // namespace hal::stm32g4
