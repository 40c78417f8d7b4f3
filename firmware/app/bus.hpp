#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/e2e.hpp"
#include "firmware/protocol/messages.hpp"
#include "hal/can_frame.hpp"
#include "hal/can_port.hpp"
#include "hal/clock.hpp"

namespace app {

/// Bits that a classic frame takes on the bus at worst, with all stuff bits and the space behind
/// it (ISO 11898-1): 47 + 8 n and a stuff bit after each 4 of 34 + 8 n, or 67 and 54 where
/// extended.
constexpr std::uint32_t worst_bits(const hal::CanFrame& frame) {
  const std::uint32_t data = 8u * frame.length;
  return frame.extended ? 67 + data + (54 + data - 1) / 4 : 47 + data + (34 + data - 1) / 4;
}

/// Bounds the load of one node: in any span of time at most kBitsPerSecond times its length and
/// kBurstBits more. Room for one frame of 8 bytes is kept for what is urgent.
class BusBudget {
 public:
  static constexpr std::uint32_t kBitsPerSecond = 2'800;
  static constexpr std::uint32_t kBurstBits = 1'350;
  static constexpr std::uint32_t kReserveBits = 135;

  void start(hal::Time now) {
    credit_us_ = kFull_us;
    last_ = now;
  }

  void advance(hal::Time now) {
    const std::uint64_t elapsed_us = (now - last_).us;
    last_ = now;
    const std::uint32_t room_us = kFull_us - credit_us_;
    credit_us_ =
        elapsed_us < room_us ? credit_us_ + static_cast<std::uint32_t>(elapsed_us) : kFull_us;
  }

  [[nodiscard]] bool allows(std::uint32_t bits) const { return allows_urgent(bits + kReserveBits); }
  [[nodiscard]] bool allows_urgent(std::uint32_t bits) const {
    return credit_us_ >= bits * kBit_us;
  }
  /// @pre allows_urgent(bits)
  void spend(std::uint32_t bits) { credit_us_ -= bits * kBit_us; }

 private:
  /// Time that one bit has to be saved up for, rounded up.
  static constexpr std::uint32_t kBit_us = (1'000'000 + kBitsPerSecond - 1) / kBitsPerSecond;
  static constexpr std::uint32_t kFull_us = kBurstBits * kBit_us;

  std::uint32_t credit_us_ = 0;
  hal::Time last_{};
};

/// Brings the controller back from bus-off, with a pause that doubles from 100 ms to 10 s while it
/// goes off again within ten seconds.
template <hal::CanPort CanT>
class BusWatch {
 public:
  explicit BusWatch(CanT& can) : can_(can) {}

  /// What has become of the bus since the last look.
  enum class Turn : std::uint8_t { none, went_off, came_back };

  Turn look(hal::Time now) {
    status_ = can_.status();
    const bool off = status_.state == hal::CanState::off;
    if (off && !off_) {
      off_ = true;
      pause_ = now < quiet_from_ ? doubled(pause_) : kShortest;
      retry_ = now + pause_;
      return Turn::went_off;
    }
    if (off && now >= retry_) {
      (void)can_.recover();
      pause_ = doubled(pause_);
      retry_ = now + pause_;
    }
    if (!off && off_) {
      off_ = false;
      quiet_from_ = now + kLongest;
      return Turn::came_back;
    }
    return Turn::none;
  }

  [[nodiscard]] const hal::CanStatus& status() const { return status_; }

 private:
  static constexpr hal::Time kShortest = hal::milliseconds(100);
  static constexpr hal::Time kLongest = hal::seconds(10);

  static constexpr hal::Time doubled(hal::Time pause) {
    return pause + pause < kLongest ? pause + pause : kLongest;
  }

  CanT& can_;
  hal::CanStatus status_;
  bool off_ = false;
  hal::Time pause_ = kShortest;
  hal::Time retry_{};
  hal::Time quiet_from_{};
};

/// Takes commands: those that are whole, new and known. All others are counted and change nothing.
class Listener {
 public:
  explicit Listener(protocol::Node node)
      : checker_(protocol::e2e::stream_of<protocol::Command>(node)) {}

  /// The command in a frame. Nothing where the frame is another, or is refused.
  std::optional<protocol::Command> take(const hal::CanFrame& frame) {
    const protocol::e2e::Status status = checker_.check(frame);
    if (status == protocol::e2e::Status::other_frame) {
      return std::nullopt;
    }
    const auto command = protocol::decode<protocol::Command>(frame);
    if (!protocol::e2e::is_usable(status) || !command || selects_no_page(*command)) {
      refused_ += refused_ != std::numeric_limits<std::uint32_t>::max() ? 1u : 0u;
      return std::nullopt;
    }
    return *command;
  }

  /// Stops at its highest value.
  [[nodiscard]] std::uint32_t refused() const { return refused_; }

 private:
  static bool selects_no_page(const protocol::Command& command) {
    return command.code == protocol::CommandCode::select_page &&
           command.argument >= protocol::detail::kPages;
  }

  protocol::e2e::Checker checker_;
  std::uint32_t refused_ = 0;
};

}  // namespace app
