#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/protocol/isotp/pdu.hpp"
#include "hal/can_frame.hpp"
#include "hal/clock.hpp"
#include "hal/error.hpp"

namespace protocol::isotp {

/// Cuts a message of up to kMaxBytes into frames, as fast as its receiver allows.
template <std::size_t kMaxBytes>
class Sender {
 public:
  constexpr explicit Sender(Counts& counts) : counts_(counts) {}

  [[nodiscard]] constexpr bool busy() const { return state_ != State::idle; }

  constexpr hal::Error start(std::span<const std::byte> message) {
    if (busy()) {
      return hal::Error::busy;
    }
    if (message.empty() || message.size() > kMaxBytes) {
      return hal::Error::out_of_range;
    }
    for (std::size_t i = 0; i < message.size(); ++i) {
      bytes_[i] = message[i];
    }
    size_ = message.size();
    sent_ = 0;
    waits_ = 0;
    sequence_ = 1;
    state_ = State::starting;
    return hal::Error::none;
  }

  constexpr void expire(hal::Time now) {
    if (state_ == State::waiting && now >= deadline_) {
      count(counts_.send_timeout);
      state_ = State::idle;
    }
  }

  constexpr void on_flow_control(const Pdu& pdu, hal::Time now) {
    if (state_ != State::waiting) {
      count(counts_.unexpected);
      return;
    }
    if (pdu.status == FlowStatus::continue_to_send) {
      waits_ = 0;
      block_left_ = pdu.block_size;
      separation_ = separation(pdu.st_min);
      next_ = now;
      state_ = State::sending;
    } else if (pdu.status == FlowStatus::wait && ++waits_ <= kMostWaits) {
      deadline_ = now + kFlowControlTimeout;
    } else {
      count(counts_.send_refused);
      state_ = State::idle;
    }
  }

  /// Whether there is a frame to send now.
  [[nodiscard]] constexpr bool ready(hal::Time now) const {
    return state_ == State::starting || (state_ == State::sending && now >= next_);
  }
  /// Takes that frame.
  /// @pre ready(now)
  constexpr hal::CanFrame take(std::uint32_t id, hal::Time now) {
    return state_ == State::starting ? begin(id, now) : send_next(id, now);
  }

 private:
  enum class State : std::uint8_t { idle, starting, waiting, sending };

  constexpr hal::CanFrame begin(std::uint32_t id, hal::Time now) {
    if (size_ <= kSingleBytes) {
      const std::uint8_t control[] = {static_cast<std::uint8_t>(size_)};
      const auto data = next_bytes(kSingleBytes);
      finish();
      return make_frame(id, control, data);
    }
    const std::uint8_t control[] = {static_cast<std::uint8_t>(0x10 | (size_ >> 8)),
                                    static_cast<std::uint8_t>(size_)};
    await_flow_control(now);
    return make_frame(id, control, next_bytes(kFirstBytes));
  }

  constexpr hal::CanFrame send_next(std::uint32_t id, hal::Time now) {
    const std::uint8_t control[] = {static_cast<std::uint8_t>(0x20 | sequence_)};
    const auto data = next_bytes(kConsecutiveBytes);
    sequence_ = following(sequence_);
    next_ = separation_ == hal::Time{} ? now : now + separation_ + kFrameTime;
    if (sent_ == size_) {
      finish();
    } else if (block_left_ != 0 && --block_left_ == 0) {
      await_flow_control(now);
    }
    return make_frame(id, control, data);
  }

  /// The next bytes of the message.
  constexpr std::span<const std::byte> next_bytes(std::size_t most) {
    const std::size_t left = size_ - sent_;
    const auto data = std::span(bytes_).subspan(sent_, left < most ? left : most);
    sent_ += data.size();
    return data;
  }
  constexpr void await_flow_control(hal::Time now) {
    state_ = State::waiting;
    deadline_ = now + kFlowControlTimeout;
  }
  constexpr void finish() {
    state_ = State::idle;
    count(counts_.sent);
  }

  Counts& counts_;
  hal::Time deadline_{};
  hal::Time next_{};
  hal::Time separation_{};
  std::size_t size_ = 0;
  std::size_t sent_ = 0;
  State state_ = State::idle;
  std::uint8_t sequence_ = 0;
  std::uint8_t block_left_ = 0;
  std::uint8_t waits_ = 0;
  std::array<std::byte, kMaxBytes> bytes_{};
};

}  // namespace protocol::isotp
