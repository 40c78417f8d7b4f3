#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::monitor {

/// Bits that a frame took on the bus, its stuff bits and the space behind it included, no error
/// frame counted (ISO 11898-1). Of CAN FD, whose second half has another rate, as if it had not:
/// what it takes at most.
std::uint32_t bits_on_bus(const SeenFrame& seen);

/// Frames and bits of the last second, in tenths.
class BusLoad {
 public:
  explicit BusLoad(double bit_rate_bit_s) : bit_rate_bit_s_(bit_rate_bit_s) {}

  void add(std::int64_t time_ns, std::uint32_t bits);
  void advance(std::int64_t now_ns);

  [[nodiscard]] double percent() const;
  [[nodiscard]] double frames_per_s() const;

 private:
  struct Slot {
    std::uint64_t bits = 0;
    std::uint64_t frames = 0;
  };
  static constexpr std::size_t kSlots = 10;
  static constexpr std::int64_t kSlot_ns = 100'000'000;

  [[nodiscard]] Slot sum() const;

  double bit_rate_bit_s_;
  std::array<Slot, kSlots> slots_{};  ///< slot n of all time is at n mod kSlots
  std::int64_t newest_ = 0;           ///< which slot of all time the last one is
  bool started_ = false;
};

}  // namespace host_sim::monitor
