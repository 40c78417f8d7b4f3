#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

/// Files that a recording is made of. All words are little-endian.
namespace firmware::qemu_mps2 {

inline constexpr std::size_t kTendons = 2;

/// Samples: this header, then for each sample one word a tendon, the raw motor current or
/// hal::qemu_mps2::kNoSample.
struct ProfileHeader {
  static constexpr std::uint32_t kMagic = 0x46504c54;  ///< "TLPF"
  static constexpr std::uint32_t kVersion = 1;
  static constexpr std::size_t kBytes = 16;

  std::uint32_t magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint32_t tendons = kTendons;
  std::uint32_t sample_period_us = 1'000;  ///< 10 .. 1,000
};

inline constexpr std::uint32_t kShortestPeriod_us = 10;
inline constexpr std::uint32_t kLongestPeriod_us = 1'000;

enum class EventKind : std::uint32_t {
  line = 1,        ///< the host writes this text, padded with zeros
  emergency_stop,  ///< pulled where the first word is not 0
  sensor_failed,   ///< where the first word is not 0
  missed,          ///< the control loop leaves out as many periods as the first word says
  stalled,         ///< the serial line takes nothing more where the first word is not 0
};

/// What happens besides, in the order of time: u32 at_ms, u32 kind, 32 bytes of payload each.
struct Event {
  static constexpr std::size_t kBytes = 40;
  static constexpr std::size_t kPayloadBytes = 32;

  std::uint32_t at_ms = 0;
  EventKind kind = EventKind::line;
  std::array<std::byte, kPayloadBytes> payload{};
};

}  // namespace firmware::qemu_mps2
