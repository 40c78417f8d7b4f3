#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/protocol/codec.hpp"
#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/frame.hpp"
#include "hal/can_frame.hpp"

/// End-to-end protection of the frames that carry life: AUTOSAR E2E Profile 22, a CRC-8 and a 4-bit
/// counter in the frame, and data ids that are not sent. On 8 bytes CRC-8H2F finds every error of
/// up to 3 bits.
namespace protocol::e2e {

/// CRC-8H2F of AUTOSAR (CP SWS CRC Library, 7.2.1.2): polynomial 0x2f, initial value and final
/// inversion 0xff, not reflected, check value 0xdf. Four bits a step.
class Crc8h2f {
 public:
  constexpr void add(std::uint8_t byte) {
    remainder_ = step(static_cast<std::uint8_t>(remainder_ ^ byte));
  }
  [[nodiscard]] constexpr std::uint8_t value() const {
    return static_cast<std::uint8_t>(~remainder_);
  }

 private:
  static constexpr std::array<std::uint8_t, 16> kTable = [] {
    std::array<std::uint8_t, 16> table{};
    for (std::uint32_t high = 0; high < 16; ++high) {
      std::uint32_t value = high << 4;
      for (int bit = 0; bit < 4; ++bit) {
        value = (value << 1) ^ ((value & 0x80) != 0 ? 0x2fu : 0u);
      }
      table[high] = static_cast<std::uint8_t>(value);
    }
    return table;
  }();

  static constexpr std::uint8_t step(std::uint8_t value) {
    for (int half = 0; half < 2; ++half) {
      value = static_cast<std::uint8_t>((value << 4) ^ kTable[value >> 4]);
    }
    return value;
  }

  std::uint8_t remainder_ = 0xff;
};

inline constexpr std::uint8_t kCounters = 16;  ///< 0 .. 15

/// The lists of 16 data ids of Profile 22, one for each protected frame and node.
///
/// Frame list `l`, 0 .. 3, and node `n` together are the number k = 128 l + n, and with products of
/// polynomials over GF(2)
///   id[counter] = (k mod 256) xor (counter x m),  m = 0x06 where l < 2, else 0x0c.
/// Lists of one m have no id at the same counter; lists of different m have at most one, because
/// counter x (0x06 xor 0x0c) takes no value twice. There are more lists than the 256 that could
/// differ everywhere, so nothing does better: a frame taken for another passes at one counter of 16
/// at most, and never twice running.
///
/// An error in the counter also changes the id that is expected, and most m let some errors of 3
/// bits cancel so. With 0x06 and 0x0c, and the header at byte 0 or at byte 3, none does.
class DataIds {
 public:
  constexpr DataIds(std::uint8_t list, Node node)
      : base_(static_cast<std::uint8_t>((list << 7) | (node & 0x7f))),
        shift_(static_cast<std::uint8_t>(1 + (list >> 1))) {}

  [[nodiscard]] constexpr std::uint8_t at(std::uint8_t counter) const {
    return static_cast<std::uint8_t>(base_ ^ ((counter ^ (counter << 1)) << shift_));
  }

 private:
  std::uint8_t base_;
  std::uint8_t shift_;
};

/// All frames of one kind of one node: what their protection depends on.
struct Stream {
  std::uint32_t id = 0;
  std::uint8_t length = 0;
  std::uint8_t crc_byte = 0;
  DataIds data_ids;
};

/// @pre the frame is protected
constexpr Stream stream_of(const schema::Frame& frame, Node node) {
  return {.id = id_of(frame, node),
          .length = frame.length,
          .crc_byte = frame.integrity->crc_byte,
          .data_ids = DataIds(frame.integrity->id_list, node)};
}
template <class Message>
requires(schema::Layout<Message>::kFrame.integrity.has_value()) constexpr Stream
    stream_of(Node node) {
  return stream_of(schema::Layout<Message>::kFrame, node);
}

/// The counter in the frame.
constexpr std::uint8_t counter_of(const Stream& stream, const hal::CanFrame& frame) {
  return std::to_integer<std::uint8_t>(frame.data[stream.crc_byte + 1u]) & 0x0f;
}

/// The CRC of Profile 22 over all bytes but its own, and the data id after them (AUTOSAR FO PRS E2E
/// Protocol, Profile 22, calculation of the CRC).
/// @pre crc_byte < data.size()
constexpr std::uint8_t crc_over(std::span<const std::byte> data, std::size_t crc_byte,
                                std::uint8_t data_id) {
  Crc8h2f crc;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (i != crc_byte) {
      crc.add(std::to_integer<std::uint8_t>(data[i]));
    }
  }
  crc.add(data_id);
  return crc.value();
}

/// The CRC that the frame ought to have.
/// @pre it has the length of the stream's frames
constexpr std::uint8_t crc_of(const Stream& stream, const hal::CanFrame& frame) {
  return crc_over(frame.payload(), stream.crc_byte, stream.data_ids.at(counter_of(stream, frame)));
}

/// The sender's side of Profile 22, one for each kind of frame and node. Counts from 0.
///
///   Protector protector(stream_of<LifeStatus>(node));
///   hal::CanFrame frame = encode(node, status);
///   protector.protect(frame);
class Protector {
 public:
  constexpr explicit Protector(const Stream& stream) : stream_(stream) {}

  /// Puts counter and CRC into a frame of the stream.
  constexpr void protect(hal::CanFrame& frame) {
    std::byte& counter = frame.data[stream_.crc_byte + 1u];
    counter = (counter & std::byte{0xf0}) | std::byte{counter_};
    frame.data[stream_.crc_byte] = std::byte{crc_of(stream_, frame)};
    counter_ = (counter_ + 1) & 0x0f;
  }

  /// The frame protected last did not leave: the next one has its counter, so that receivers see no
  /// loss.
  constexpr void withdraw() { counter_ = (counter_ - 1) & 0x0f; }

 private:
  Stream stream_;
  std::uint8_t counter_ = 0;
};

/// What a received frame is worth (AUTOSAR FO PRS E2E Protocol, 6.13: E2E_P22Check).
enum class [[nodiscard]] Status : std::uint8_t{
    initial,         ///< the first one whose CRC is right: genuine, but there is nothing to compare
    ok,              ///< the next one
    ok_some_lost,    ///< a later one, no more than the largest delta ahead
    repeated,        ///< the one that was there before
    wrong_sequence,  ///< too far ahead, or of the past; the next one is compared with it
    wrong_crc,       ///< damaged, or of another stream; leaves no trace in the counter
    wrong_length,
    other_frame,  ///< another identifier; not counted
};

/// Whether the content may be used.
constexpr bool is_usable(Status status) {
  return status == Status::initial || status == Status::ok || status == Status::ok_some_lost;
}

/// Since the start; each stops at 2^32 - 1.
struct Counts {
  std::uint32_t good = 0;            ///< initial, ok and ok_some_lost
  std::uint32_t lost = 0;            ///< skipped by ok_some_lost
  std::uint32_t repeated = 0;        ///< also 16, 32, .. lost in a row
  std::uint32_t wrong_sequence = 0;  ///< more lost than the largest delta, or out of order
  std::uint32_t damaged = 0;         ///< wrong_crc and wrong_length

  friend constexpr bool operator==(const Counts&, const Counts&) = default;
};

/// The receiver's side of Profile 22, one for each kind of frame and node. The counter has 16
/// values, so a receiver also has to give up a stream that has been silent for longer than
/// kMaxDelta of its cycles.
class Checker {
 public:
  /// The largest step of the counter that is still a valid sequence: two frames lost.
  static constexpr std::uint8_t kMaxDelta = 3;

  /// `max_delta`: 1 .. 14.
  constexpr explicit Checker(const Stream& stream, std::uint8_t max_delta = kMaxDelta)
      : stream_(stream), max_delta_(max_delta) {}

  constexpr Status check(const hal::CanFrame& frame) {
    if (frame.extended || frame.id != stream_.id) {
      return Status::other_frame;
    }
    if (frame.length != stream_.length) {
      count(counts_.damaged);
      return Status::wrong_length;
    }
    if (std::to_integer<std::uint8_t>(frame.data[stream_.crc_byte]) != crc_of(stream_, frame)) {
      count(counts_.damaged);
      return Status::wrong_crc;
    }
    return compare(counter_of(stream_, frame));
  }

  [[nodiscard]] constexpr const Counts& counts() const { return counts_; }

 private:
  constexpr Status compare(std::uint8_t counter) {
    const bool first = !started_;
    const std::uint8_t delta = (counter - counter_) & 0x0f;
    started_ = true;
    counter_ = counter;
    if (first) {
      count(counts_.good);
      return Status::initial;
    }
    if (delta == 0) {
      count(counts_.repeated);
      return Status::repeated;
    }
    if (delta > max_delta_) {
      count(counts_.wrong_sequence);
      return Status::wrong_sequence;
    }
    count(counts_.good);
    count(counts_.lost, delta - 1u);
    return delta == 1 ? Status::ok : Status::ok_some_lost;
  }

  static constexpr void count(std::uint32_t& counter, std::uint32_t step = 1) {
    constexpr std::uint32_t kLargest = 0xffff'ffff;
    counter = kLargest - counter < step ? kLargest : counter + step;
  }

  Stream stream_;
  std::uint8_t max_delta_;
  bool started_ = false;
  std::uint8_t counter_ = 0;
  Counts counts_;
};

}  // namespace protocol::e2e
