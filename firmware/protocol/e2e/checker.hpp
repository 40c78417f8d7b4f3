#pragma once

#include <cstdint>

#include "firmware/protocol/e2e/stream.hpp"

namespace protocol::e2e {

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
