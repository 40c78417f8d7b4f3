#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/protocol/isotp/pdu.hpp"
#include "firmware/protocol/isotp/receiver.hpp"
#include "firmware/protocol/isotp/sender.hpp"
#include "hal/can_frame.hpp"
#include "hal/clock.hpp"
#include "hal/error.hpp"

namespace protocol::isotp {

/// Messages of up to kMaxBytes between two addresses over classic CAN (ISO 15765-2), one at a time
/// in each direction, both directions at once.
///
/// A message arrives whole and as it was sent, or is counted as lost; the link then takes the next
/// one. That holds as long as frames keep their order from one message to the next, as they do on a
/// bus: the protocol has no check sum.
///
/// Sends nothing by itself: the owner asks for the next frame when its share of the bus has room
/// for one, and keeps it until the controller takes it. Each call is bounded by one frame.
template <std::size_t kMaxBytes>
class Link {
  static_assert(kMaxBytes > kSingleBytes && kMaxBytes <= kMostBytes);

 public:
  constexpr explicit Link(Address outgoing, Pace pace = {})
      : outgoing_(outgoing), receiver_(pace, counts_), sender_(counts_) {}
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// Takes a frame from the bus; those of other addresses are left alone.
  constexpr void on_frame(const hal::CanFrame& frame, hal::Time now) {
    if (Address::of(frame) != outgoing_.reversed()) {
      return;
    }
    expire(now);
    const auto pdu = read(frame);
    if (!pdu) {
      count(counts_.malformed);
      return;
    }
    switch (pdu->type) {
      case PduType::single:
        return receiver_.on_single(*pdu);
      case PduType::first:
        return receiver_.on_first(*pdu);
      case PduType::consecutive:
        return receiver_.on_consecutive(*pdu, now);
      case PduType::flow_control:
        return sender_.on_flow_control(*pdu, now);
    }
  }

  /// Whether next_frame() has one.
  [[nodiscard]] constexpr bool ready(hal::Time now) const {
    return receiver_.has_answer() || sender_.ready(now);
  }

  /// The next frame to send, where it is time for one.
  [[nodiscard]] constexpr std::optional<hal::CanFrame> next_frame(hal::Time now) {
    expire(now);
    if (receiver_.has_answer()) {
      const Pdu pdu = receiver_.take_answer(now);
      const std::uint8_t control[] = {
          static_cast<std::uint8_t>(0x30 | static_cast<std::uint8_t>(pdu.status)), pdu.block_size,
          pdu.st_min};
      return make_frame(outgoing_.id(), control, {});
    }
    if (sender_.ready(now)) {
      return sender_.take(outgoing_.id(), now);
    }
    return std::nullopt;
  }

  /// The message that arrived; empty while there is none. It stays, and no other is taken, until
  /// clear().
  [[nodiscard]] constexpr std::span<const std::byte> received() const {
    return receiver_.message();
  }
  constexpr void clear() { receiver_.clear(); }

  /// Begins to send a message, which is copied. busy: the last one is still under way;
  /// out_of_range: it is empty or too long.
  constexpr hal::Error send(std::span<const std::byte> message) { return sender_.start(message); }
  [[nodiscard]] constexpr bool sending() const { return sender_.busy(); }

  [[nodiscard]] constexpr const Counts& counts() const { return counts_; }

 private:
  constexpr void expire(hal::Time now) {
    receiver_.expire(now);
    sender_.expire(now);
  }

  Address outgoing_;
  Counts counts_{};
  Receiver<kMaxBytes> receiver_;
  Sender<kMaxBytes> sender_;
};

}  // namespace protocol::isotp
