#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/protocol/isotp/pdu.hpp"
#include "hal/clock.hpp"

namespace protocol::isotp {

/// Puts a message of up to kMaxBytes together again.
template <std::size_t kMaxBytes>
class Receiver {
 public:
  constexpr Receiver(Pace pace, Counts& counts) : counts_(counts), pace_(pace) {}

  /// The whole message; empty while there is none.
  [[nodiscard]] constexpr std::span<const std::byte> message() const {
    return std::span(bytes_).first(state_ == State::whole ? size_ : 0);
  }
  /// Makes room for the next message.
  constexpr void clear() {
    if (state_ == State::whole) {
      state_ = State::idle;
    }
  }

  constexpr void expire(hal::Time now) {
    if (state_ == State::collecting && now >= deadline_) {
      count(counts_.receive_timeout);
      state_ = State::idle;
    }
  }

  constexpr void on_single(const Pdu& pdu) {
    if (!make_room()) {
      return;
    }
    start(pdu);
    finish();
  }

  constexpr void on_first(const Pdu& pdu) {
    if (!make_room()) {
      answer_ = FlowStatus::overflow;
      return;
    }
    if (pdu.length > kMaxBytes) {
      count(counts_.oversized);
      answer_ = FlowStatus::overflow;
      return;
    }
    start(pdu);
    state_ = State::answering;
    answer_ = FlowStatus::continue_to_send;
  }

  constexpr void on_consecutive(const Pdu& pdu, hal::Time now) {
    if (state_ != State::collecting) {
      count(counts_.unexpected);
      return;
    }
    const std::size_t missing = expected_ - size_;
    const std::size_t wanted = missing < kConsecutiveBytes ? missing : kConsecutiveBytes;
    if (pdu.data.size() < wanted) {
      count(counts_.malformed);
      return;
    }
    if (pdu.sequence != sequence_) {
      count(counts_.wrong_sequence);
      state_ = State::idle;
      return;
    }
    append(pdu.data.first(wanted));
    sequence_ = following(sequence_);
    deadline_ = now + kConsecutiveTimeout;
    if (size_ == expected_) {
      finish();
    } else if (block_left_ != 0 && --block_left_ == 0) {
      state_ = State::answering;
      answer_ = FlowStatus::continue_to_send;
    }
  }

  [[nodiscard]] constexpr bool has_answer() const { return answer_ != FlowStatus::invalid; }
  /// Takes the flow control that is due.
  /// @pre has_answer()
  constexpr Pdu take_answer(hal::Time now) {
    const Pdu pdu{.type = PduType::flow_control,
                  .status = answer_,
                  .block_size = pace_.block_size,
                  .st_min = pace_.st_min};
    if (answer_ == FlowStatus::continue_to_send) {
      state_ = State::collecting;
      block_left_ = pace_.block_size;
      deadline_ = now + kConsecutiveTimeout;
    }
    answer_ = FlowStatus::invalid;
    return pdu;
  }

 private:
  enum class State : std::uint8_t { idle, answering, collecting, whole };

  /// Ends what was being received. False where a whole message has to stay.
  constexpr bool make_room() {
    if (state_ == State::whole) {
      count(counts_.not_taken);
      return false;
    }
    if (state_ != State::idle) {
      count(counts_.interrupted);
      state_ = State::idle;
      answer_ = FlowStatus::invalid;
    }
    return true;
  }
  constexpr void start(const Pdu& pdu) {
    size_ = 0;
    expected_ = pdu.length;
    sequence_ = 1;
    append(pdu.data);
  }
  constexpr void append(std::span<const std::byte> data) {
    for (const std::byte byte : data) {
      bytes_[size_++] = byte;
    }
  }
  constexpr void finish() {
    state_ = State::whole;
    count(counts_.received);
  }

  Counts& counts_;
  hal::Time deadline_{};
  std::size_t size_ = 0;
  std::size_t expected_ = 0;
  Pace pace_;
  State state_ = State::idle;
  FlowStatus answer_ = FlowStatus::invalid;  ///< invalid: none is due
  std::uint8_t sequence_ = 0;
  std::uint8_t block_left_ = 0;
  std::array<std::byte, kMaxBytes> bytes_{};
};

}  // namespace protocol::isotp
