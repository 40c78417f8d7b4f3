#include "host_sim/monitor/fleet/bus_load.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>

namespace host_sim::monitor {
namespace {

/// Where bit stuffing is after a bit (ISO 11898-1, 10.5): the last bit on the bus, and how many of
/// its kind in a row, 1 to 4, for after five comes a stuff bit of the other kind.
struct Stuffing {
  bool last = true;
  std::uint8_t run = 1;
  std::uint8_t stuffed = 0;  ///< stuff bits so far

  constexpr void put(bool bit) {
    run = bit == last ? static_cast<std::uint8_t>(run + 1) : std::uint8_t{1};
    last = bit;
    if (run == 5) {
      last = !bit;
      run = 1;
      ++stuffed;
    }
  }
  [[nodiscard]] constexpr std::size_t state() const {
    return (last ? 4u : 0u) + static_cast<std::size_t>(run - 1);
  }
};

constexpr std::size_t kBytes = 256;
constexpr std::size_t kStates = 8;

/// What eight bits more do to each state.
struct AfterByte {
  std::uint8_t state;
  std::uint8_t stuffed;
};
constexpr auto kAfterByte = [] {
  std::array<std::array<AfterByte, kBytes>, kStates> table{};
  for (std::size_t state = 0; state < kStates; ++state) {
    for (std::size_t byte = 0; byte < kBytes; ++byte) {
      Stuffing stuffing{state >= 4, static_cast<std::uint8_t>(state % 4 + 1)};
      for (std::size_t bit = 8; bit-- > 0;) {
        stuffing.put(((byte >> bit) & 1u) != 0);
      }
      table[state][byte] = {static_cast<std::uint8_t>(stuffing.state()), stuffing.stuffed};
    }
  }
  return table;
}();

/// CRC-15 of the standard, 0x4599: what is left of a byte shifted out.
constexpr auto kCrcOfByte = [] {
  std::array<std::uint16_t, kBytes> table{};
  for (std::uint32_t byte = 0; byte < kBytes; ++byte) {
    std::uint32_t crc = byte << 7;
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc << 1) ^ ((crc & 0x4000u) != 0 ? 0x4599u : 0u);
    }
    table[byte] = static_cast<std::uint16_t>(crc & 0x7fffu);
  }
  return table;
}();

class BitCounter {
 public:
  void put(std::uint32_t byte) {
    const AfterByte after = kAfterByte[state_][byte & 0xffu];
    state_ = after.state;
    stuffed_ += after.stuffed;
  }
  void take_into_crc(std::uint32_t byte) {
    crc_ = ((crc_ << 8) ^ kCrcOfByte[((crc_ >> 7) ^ byte) & 0xffu]) & 0x7fffu;
  }
  /// Followed by a bit of the other kind than its last, which completes no run.
  void put_crc() {
    const std::uint32_t with_one_more = (crc_ << 1) | (~crc_ & 1u);
    put(with_one_more >> 8);
    put(with_one_more);
  }
  [[nodiscard]] std::uint32_t stuffed() const { return stuffed_; }

 private:
  std::size_t state_ = Stuffing{}.state();
  std::uint32_t stuffed_ = 0;
  std::uint32_t crc_ = 0;
};

constexpr std::uint32_t kCrcBits = 15;
/// CRC delimiter, acknowledgement and its delimiter, end of frame, and the space between frames.
constexpr std::uint32_t kTail = 1 + 1 + 1 + 7 + 3;

/// Start of frame to the length, in the low bits.
struct Head {
  std::uint64_t value;
  std::uint32_t bits;
};

Head head_of(const SeenFrame& seen) {
  const std::uint64_t id = seen.frame.id;
  const std::uint64_t length = seen.frame.length & 0xfu;
  const std::uint64_t remote = seen.remote_request ? 1 : 0;
  if (!seen.frame.extended) {  // id, RTR, IDE and r0
    return {(id & 0x7ff) << 7 | remote << 6 | length, 19};
  }
  const std::uint64_t base = (id >> 18) & 0x7ff;  // SRR and IDE after it; RTR, r1, r0 at the end
  return {base << 27 | 3u << 25 | (id & 0x3'ffff) << 7 | remote << 6 | length, 39};
}

/// Filled up to whole bytes in front: for the CRC with zeros, which leave it as it is, and for
/// stuffing with recessive bits in turn with others, as of a bus at rest.
void add(BitCounter& counter, const Head& head) {
  constexpr std::uint64_t kInTurn = 0x55'5555'5555;
  const std::uint32_t bytes = (head.bits + 7) / 8;
  const std::uint64_t filled = head.value | kInTurn << head.bits;
  for (std::uint32_t byte = bytes; byte-- > 0;) {
    counter.take_into_crc(static_cast<std::uint32_t>(head.value >> (8 * byte)));
    counter.put(static_cast<std::uint32_t>(filled >> (8 * byte)));
  }
}

std::uint32_t most_bits_of_fd(const SeenFrame& seen) {
  const auto stuffed = static_cast<std::uint32_t>(42 + 8 * seen.fd_data.size());
  return stuffed + stuffed / 4 + 29 + kTail;
}

}  // namespace

std::uint32_t bits_on_bus(const SeenFrame& seen) {
  if (seen.flexible_data_rate) {
    return most_bits_of_fd(seen);
  }
  const Head head = head_of(seen);
  BitCounter counter;
  add(counter, head);
  const auto payload = seen.remote_request ? std::span<const std::byte>() : seen.frame.payload();
  for (const std::byte data : payload) {
    const auto byte = std::to_integer<std::uint32_t>(data);
    counter.take_into_crc(byte);
    counter.put(byte);
  }
  counter.put_crc();
  const auto data_bits = static_cast<std::uint32_t>(8 * payload.size());
  return head.bits + data_bits + kCrcBits + counter.stuffed() + kTail;
}

void BusLoad::add(std::int64_t time_ns, std::uint32_t bits) {
  advance(time_ns);
  Slot& slot = slots_[static_cast<std::size_t>(newest_) % kSlots];
  slot.bits += bits;
  ++slot.frames;
}

void BusLoad::advance(std::int64_t now_ns) {
  const std::int64_t now = std::max<std::int64_t>(now_ns, 0) / kSlot_ns;
  if (!started_ || now - newest_ >= static_cast<std::int64_t>(kSlots)) {
    slots_ = {};
    newest_ = now;
    started_ = true;
    return;
  }
  while (newest_ < now) {
    ++newest_;
    slots_[static_cast<std::size_t>(newest_) % kSlots] = {};
  }
}

BusLoad::Slot BusLoad::sum() const {
  return std::accumulate(slots_.begin(), slots_.end(), Slot{}, [](Slot sum, const Slot& slot) {
    return Slot{sum.bits + slot.bits, sum.frames + slot.frames};
  });
}

double BusLoad::percent() const {
  return 100.0 * static_cast<double>(sum().bits) / bit_rate_bit_s_;
}

double BusLoad::frames_per_s() const {
  return static_cast<double>(sum().frames);
}

}  // namespace host_sim::monitor
