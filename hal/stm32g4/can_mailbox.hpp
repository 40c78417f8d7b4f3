#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hal/can_frame.hpp"
#include "lifemodel/support/shared_word.hpp"

namespace hal::stm32g4 {

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

}  // namespace hal::stm32g4
