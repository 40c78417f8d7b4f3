#include "host_sim/monitor/fleet/bus_load.hpp"

#include <algorithm>
#include <numeric>

namespace host_sim::monitor {
namespace {

/// Counts the stuffed part of a frame bit by bit (ISO 11898-1, 10.5 bit stuffing; CRC-15 0x4599).
class BitCounter {
 public:
  void add(std::uint32_t value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit) {
      const bool one = ((value >> bit) & 1u) != 0;
      take_into_crc(one);
      put(one);
    }
  }
  void add_crc() {
    const std::uint32_t crc = crc_;
    add(crc, 15);
  }
  [[nodiscard]] std::uint32_t bits() const { return bits_; }

 private:
  void take_into_crc(bool one) {
    const bool invert = one != ((crc_ & 0x4000u) != 0);
    crc_ = (crc_ << 1) & 0x7fffu;
    crc_ ^= invert ? 0x4599u : 0u;
  }
  void put(bool one) {
    ++bits_;
    run_ = one == last_ ? run_ + 1 : 1;
    last_ = one;
    if (run_ == 5) {  // a stuff bit of the other kind begins the next run
      ++bits_;
      last_ = !one;
      run_ = 1;
    }
  }

  std::uint32_t crc_ = 0;
  std::uint32_t bits_ = 0;
  bool last_ = true;  // the bus is recessive before
  int run_ = 0;
};

/// CRC delimiter, acknowledgement and its delimiter, end of frame, and the space between frames.
constexpr std::uint32_t kTail = 1 + 1 + 1 + 7 + 3;

void add_head(BitCounter& bits, const SeenFrame& seen) {
  const std::uint32_t remote = seen.remote_request ? 1 : 0;
  bits.add(0, 1);  // start of frame
  if (seen.frame.extended) {
    bits.add(seen.frame.id >> 18, 11);
    bits.add(3, 2);  // SRR and IDE
    bits.add(seen.frame.id & 0x3'ffff, 18);
    bits.add(remote << 2, 3);  // RTR, r1, r0
  } else {
    bits.add(seen.frame.id, 11);
    bits.add(remote << 2, 3);  // RTR, IDE, r0
  }
  bits.add(seen.frame.length, 4);
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
  BitCounter bits;
  add_head(bits, seen);
  if (!seen.remote_request) {
    for (const std::byte byte : seen.frame.payload()) {
      bits.add(std::to_integer<std::uint32_t>(byte), 8);
    }
  }
  bits.add_crc();
  return bits.bits() + kTail;
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
