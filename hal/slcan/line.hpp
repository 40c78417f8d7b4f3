#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "hal/can_frame.hpp"

namespace hal::slcan {

/// The digit that Linux' slcan writes: upper case. @pre value < 16
constexpr char hex_digit(std::uint32_t value) {
  return static_cast<char>(value < 10 ? '0' + value : 'A' + value - 10);
}

/// Of either case.
constexpr std::optional<std::uint32_t> hex_value(char digit) {
  if (digit >= '0' && digit <= '9') {
    return static_cast<std::uint32_t>(digit - '0');
  }
  if (digit >= 'A' && digit <= 'F') {
    return static_cast<std::uint32_t>(digit - 'A' + 10);
  }
  if (digit >= 'a' && digit <= 'f') {
    return static_cast<std::uint32_t>(digit - 'a' + 10);
  }
  return std::nullopt;
}

/// A number of at most 8 digits and nothing else.
constexpr std::optional<std::uint32_t> hex_number(std::string_view digits) {
  std::uint32_t number = 0;
  for (const char digit : digits) {
    const auto value = hex_value(digit);
    if (!value) {
      return std::nullopt;
    }
    number = (number << 4) | *value;
  }
  return number;
}

/// The longest line without its end: `T`, 8 digits of id, 1 of length, 16 of data.
inline constexpr std::size_t kLongestLine = 26;

/// Ends a line, and as an answer says yes.
inline constexpr char kEnd = '\r';
/// As an answer: no.
inline constexpr char kBell = '\a';

/// A line of bounded length with its end. @pre put() has room for it
class Text {
 public:
  constexpr void put(char c) { characters_[size_++] = c; }
  constexpr void put_hex(std::uint32_t value, int digits) {
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4) {
      put(hex_digit((value >> shift) & 15u));
    }
  }
  [[nodiscard]] constexpr std::string_view view() const { return {characters_.data(), size_}; }
  [[nodiscard]] std::span<const std::byte> bytes() const {
    return std::as_bytes(std::span(characters_).first(size_));
  }

 private:
  std::array<char, kLongestLine + 1> characters_{};
  std::size_t size_ = 0;
};

/// A frame as a line writes it. A remote frame asks for `frame.length` bytes and carries none.
struct FrameLine {
  CanFrame frame;
  bool remote = false;

  friend constexpr bool operator==(const FrameLine&, const FrameLine&) = default;
};

inline constexpr std::uint32_t kHighestStandardId = 0x7ff;
inline constexpr std::uint32_t kHighestExtendedId = 0x1fff'ffff;

/// tiiil, Tiiiiiiiil, riiil or Riiiiiiiil, the data in hexadecimal digits, and the end of the line.
/// @pre id and length are in their range
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
constexpr bool is_frame_line(std::string_view line) {
  return !line.empty() && std::string_view("tTrR").find(line.front()) != std::string_view::npos;
}

/// Reads a line without its end. Nothing where a digit is missing, wrong or too many, or where id
/// or length are out of range.
constexpr std::optional<FrameLine> parse_frame(std::string_view line) {
  if (!is_frame_line(line)) {
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

/// Puts lines together, byte by byte. Line feeds are passed over, so that a terminal can be used.
class LineReader {
 public:
  enum class Event : unsigned char {
    none,     ///< the line continues
    line,     ///< line() is whole
    too_long  ///< a line has ended that was longer than any can be; it is dropped
  };

  constexpr Event take(std::byte byte) {
    const char c = static_cast<char>(byte);
    if (complete_) {
      complete_ = false;
      size_ = 0;
    }
    if (c == '\n') {
      return Event::none;
    }
    if (c != kEnd) {
      if (size_ < line_.size()) {
        line_[size_] = c;
      }
      size_ += size_ <= line_.size() ? 1 : 0;
      return Event::none;
    }
    complete_ = true;
    return size_ > line_.size() ? Event::too_long : Event::line;
  }

  /// Without its end. Valid after Event::line, until the next byte.
  [[nodiscard]] constexpr std::string_view line() const { return {line_.data(), size_}; }

 private:
  std::array<char, kLongestLine> line_{};
  std::size_t size_ = 0;  ///< one past the capacity where the line is too long
  bool complete_ = false;
};

}  // namespace hal::slcan
