#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

#include "host_sim/monitor/bus/seen_frame.hpp"

namespace host_sim::fuzz {

/// Frames of 16 bytes each, of which 2 are a step of time in ms, 2 flags and id, 1 the length, 8
/// data.
class Frames {
 public:
  explicit Frames(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::optional<monitor::SeenFrame> next() {
    if (bytes_.size() < kFrame) {
      return std::nullopt;
    }
    const auto bytes = bytes_.first<kFrame>();
    bytes_ = bytes_.subspan(kFrame);
    time_ns_ += (bytes[0] | bytes[1] << 8) * std::int64_t{1'000'000};
    monitor::SeenFrame seen;
    seen.time_ns = time_ns_;
    seen.frame.id = (bytes[2] | static_cast<std::uint32_t>(bytes[3]) << 8) & 0x7ff;
    seen.frame.extended = (bytes[3] & 0x10) != 0;
    seen.remote_request = (bytes[3] & 0x20) != 0;
    seen.frame.length = std::min<std::uint8_t>(bytes[4], 8);
    std::memcpy(seen.frame.data.data(), bytes.data() + 8, seen.frame.length);
    if ((bytes[3] & 0xc0) == 0xc0) {
      seen.error.emplace().bus_off = (bytes[4] & 1) != 0;
    }
    return seen;
  }
  /// Of the last one.
  [[nodiscard]] std::int64_t time_ns() const { return time_ns_; }

 private:
  static constexpr std::size_t kFrame = 16;

  std::span<const std::uint8_t> bytes_;
  std::int64_t time_ns_ = 0;
};

}  // namespace host_sim::fuzz
