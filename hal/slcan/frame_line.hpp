#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "hal/can_frame.hpp"
#include "hal/slcan/text.hpp"

namespace hal::slcan {

/// A frame as a line tells it. A remote frame asks for `frame.length` bytes and carries none.
struct FrameLine {
  CanFrame frame;
  bool remote = false;

  friend constexpr bool operator==(const FrameLine&, const FrameLine&) = default;
};

inline constexpr std::uint32_t kHighestStandardId = 0x7ff;
inline constexpr std::uint32_t kHighestExtendedId = 0x1fff'ffff;

/// tiiil, Tiiiiiiiil, riiil or Riiiiiiiil, the data in hexadecimal digits, and the end of the line.
/// Precondition: id and length are in their range.
constexpr Text format(const FrameLine& line) {
  const CanFrame& frame = line.frame;
  Text text;
  const char small = line.remote ? 'r' : 't';
  text.put(frame.extended ? static_cast<char>(small - 'a' + 'A') : small);
  text.put_hex(frame.id, frame.extended ? 8 : 3);
  text.put_hex(frame.length, 1);
  if (!line.remote) {
    for (const std::byte byte : frame.payload()) {
      text.put_hex(static_cast<std::uint32_t>(byte), 2);
    }
  }
  text.put(kEnd);
  return text;
}

/// Whether this is a line of a frame, right or wrong.
constexpr bool tells_frame(std::string_view line) {
  return !line.empty() && std::string_view("tTrR").find(line.front()) != std::string_view::npos;
}

/// Reads a line without its end. Nothing where a digit is missing, wrong or too many, or where id
/// or length are out of range.
constexpr std::optional<FrameLine> parse_frame(std::string_view line) {
  if (!tells_frame(line)) {
    return std::nullopt;
  }
  FrameLine result;
  result.remote = line.front() == 'r' || line.front() == 'R';
  result.frame.extended = line.front() == 'T' || line.front() == 'R';
  line.remove_prefix(1);
  const std::size_t id_digits = result.frame.extended ? 8 : 3;
  if (line.size() < id_digits + 1) {
    return std::nullopt;
  }
  const auto id = hex_number(line.substr(0, id_digits));
  const auto length = hex_value(line[id_digits]);
  line.remove_prefix(id_digits + 1);
  if (!id || *id > (result.frame.extended ? kHighestExtendedId : kHighestStandardId) || !length ||
      *length > result.frame.data.size() || line.size() != (result.remote ? 0 : 2 * *length)) {
    return std::nullopt;
  }
  result.frame.id = *id;
  result.frame.length = static_cast<std::uint8_t>(*length);
  for (std::size_t i = 0; 2 * i < line.size(); ++i) {
    const auto byte = hex_number(line.substr(2 * i, 2));
    if (!byte) {
      return std::nullopt;
    }
    result.frame.data[i] = static_cast<std::byte>(*byte);
  }
  return result;
}

}  // namespace hal::slcan
