#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace protocol::schema {

/// What a raw value of a signal stands for.
struct ValueName {
  std::uint32_t value = 0;
  std::string_view name;  ///< [a-z0-9_]
};

/// An unsigned number in a frame, little-endian. Texts are ASCII on one line, without double
/// quotes, semicolons and backslashes, so that every reader of a DBC file takes them.
struct Signal {
  std::string_view name;          ///< unique in its frame; a letter, then letters and digits
  std::uint8_t start_bit = 0;     ///< of its lowest bit; bit 0 is the lowest of byte 0
  std::uint8_t bits = 0;          ///< 1 .. 32
  std::string_view factor = "1";  ///< physical value of one step, a decimal without exponent
  std::string_view unit = {};     ///< of the physical value; empty where it has none
  std::string_view comment = {};  ///< what it tells
  std::span<const ValueName> values = {};
  bool stops = false;      ///< what is larger is told as the largest value, which means "or more"
  bool is_closed = false;  ///< only named values may appear; set by field() from the member's type
};

/// The largest raw value that `bits` hold.
constexpr std::uint32_t largest(std::uint8_t bits) {
  return bits >= 32 ? 0xffff'ffffu : (std::uint32_t{1} << bits) - 1;
}

/// Whether a raw value stands for itself or more: the end of a range that stops, or, where that has
/// a name, the value before it.
constexpr bool is_at_least(const Signal& signal, std::uint32_t raw) {
  std::uint32_t end = largest(signal.bits);
  for (const ValueName& value : signal.values) {
    end -= value.value == largest(signal.bits) ? 1u : 0u;
  }
  return signal.stops && raw == end;
}

/// The bits of a payload that the signal takes, byte 0 lowest.
constexpr std::uint64_t mask_of(const Signal& signal) {
  return std::uint64_t{largest(signal.bits)} << signal.start_bit;
}

}  // namespace protocol::schema
