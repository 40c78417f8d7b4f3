#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

/// Decimal numbers as recordings have them, eight digits at a time.
namespace hal::files {

/// Octets behind the last one of a number that parse_plain_decimal() may read.
inline constexpr std::size_t kPlainDecimalReach = 8;

namespace plain_decimal {

inline constexpr std::uint64_t kMostExact = std::uint64_t{1} << 53;
inline constexpr unsigned kMostDigits = 19;  // fit into 64 bits
inline constexpr std::array<std::uint64_t, 9> kPowers{
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};
// All exact.
inline constexpr std::array<double, kMostDigits + 1> kScales{
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,
    1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19};

struct Digits {
  std::uint64_t value;
  unsigned count;  ///< 8 where there may be more
};

/// Appends the first `kCount` of eight digits, given by their values in the order of the text.
template <unsigned kCount>
[[gnu::always_inline]] inline void append_digits(std::uint64_t values, const char*& at,
                                                 std::uint64_t& number) {
  // In pairs, fours and all eight, with zeros in front.
  constexpr std::uint64_t kPairs = 0x000000FF000000FF;
  std::uint64_t sum = values << (64 - 8 * kCount);
  sum = sum * 10 + (sum >> 8);
  sum = ((sum & kPairs) * (100 + (std::uint64_t{1'000'000} << 32)) +
         ((sum >> 16) & kPairs) * (1 + (std::uint64_t{10'000} << 32))) >>
        32;
  number = number * kPowers[kCount] + sum;
  at += kCount;
}

/// Appends the digits at the front of eight octets; gives how many, 8 where there may be more.
inline unsigned append_front(const char*& at, std::uint64_t& number) {
  std::uint64_t octets = 0;
  std::memcpy(&octets, at, sizeof octets);
  constexpr std::uint64_t kEach = 0x0101010101010101;
  // A digit becomes its value. The first octet that is none is found by its high bit: a carry of
  // the sum reaches those behind it alone.
  const std::uint64_t values = octets ^ kEach * '0';
  const std::uint64_t others = ((values + kEach * (0x80 - 10)) | values) & kEach * 0x80;
  const unsigned count = others == 0 ? 8 : static_cast<unsigned>(std::countr_zero(others)) / 8;
  // A way of its own for each count: columns have as many digits as in the row before, mostly, so
  // that the next field is begun by prediction and does not wait for the count.
  switch (count) {
    case 1:
      append_digits<1>(values, at, number);
      break;
    case 2:
      append_digits<2>(values, at, number);
      break;
    case 3:
      append_digits<3>(values, at, number);
      break;
    case 4:
      append_digits<4>(values, at, number);
      break;
    case 5:
      append_digits<5>(values, at, number);
      break;
    case 6:
      append_digits<6>(values, at, number);
      break;
    case 7:
      append_digits<7>(values, at, number);
      break;
    case 8:
      append_digits<8>(values, at, number);
      break;
    default:
      break;
  }
  return count;
}

/// Appends up to 15 digits to the `count` of a number; false where there are none, more, or too
/// many together.
inline bool append(const char*& at, std::uint64_t& number, unsigned& count) {
  const unsigned first = append_front(at, number);
  count += first;
  if (first != 8) [[likely]] {
    return first != 0 && count <= kMostDigits;
  }
  const unsigned second = append_front(at, number);
  count += second;
  return second != 8 && count <= kMostDigits;
}

}  // namespace plain_decimal

/// Reads the decimal at `position` where it is a plain one: digits, a minus before and a point
/// between them allowed, with the delimiter, a quote or the end of the line behind. Its digits as a
/// whole number and the power of ten by which that is divided are exact in a double, so the one
/// division rounds as std::from_chars() does. Moves `position` behind it and returns true, or
/// returns false, and nothing has changed, where it is any other.
/// @pre kPlainDecimalReach octets more than the number and what is behind it can be read
inline bool parse_plain_decimal(const char*& position, double& value, char delimiter) {
  if constexpr (std::endian::native != std::endian::little) {
    return false;
  }
  const char* at = position;
  const bool negative = *at == '-';
  at += negative ? 1 : 0;
  std::uint64_t digits = 0;
  unsigned count = 0;
  if (!plain_decimal::append(at, digits, count)) {
    return false;
  }
  unsigned decimals = 0;
  if (*at == '.') {
    ++at;
    const unsigned whole = count;
    if (!plain_decimal::append(at, digits, count)) {
      return false;
    }
    decimals = count - whole;
  }
  if (digits > plain_decimal::kMostExact ||
      (*at != delimiter && *at != '\n' && *at != '\r' && *at != '"')) {
    return false;
  }
  const double size =
      static_cast<double>(static_cast<std::int64_t>(digits)) / plain_decimal::kScales[decimals];
  value = negative ? -size : size;
  position = at;
  return true;
}

}  // namespace hal::files
