#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "firmware/protocol/uds/table.hpp"

namespace protocol::uds {

namespace detail {

/// `0x` and the digits of `value`.
template <std::size_t kDigits>
constexpr std::array<char, kDigits + 2> hex(std::uint32_t value) {
  std::array<char, kDigits + 2> text{'0', 'x'};
  for (std::size_t i = 0; i < kDigits; ++i) {
    text[kDigits + 1 - i] = "0123456789abcdef"[(value >> (4 * i)) & 0xf];
  }
  return text;
}

/// Writes decimals.
template <class Out>
constexpr void number(Out& out, std::uint32_t value) {
  std::array<char, 10> digits{};
  std::size_t at = digits.size();
  do {
    digits[--at] = static_cast<char>('0' + value % 10);
    value /= 10;
  } while (value != 0);
  out(std::string_view(digits.data() + at, digits.size() - at));
}

template <class Out>
constexpr void identifier(Out& out, std::uint16_t value) {
  const auto text = hex<4>(value);
  out(std::string_view(text.data(), text.size()));
}

}  // namespace detail

/// Writes the tables of data identifiers and routines in Markdown, piece by piece, to
/// `out(std::string_view)`.
template <std::invocable<std::string_view> Out>
constexpr void describe(Out&& out) {
  out("| service | identifier | bytes | what |\n|---|---|---|---|\n");
  for (const DataRow& row : kDataTable) {
    out("| 0x22 read | ");
    detail::identifier(out, row.first);
    if (row.last != row.first) {
      out(" .. ");
      detail::identifier(out, row.last);
    }
    out(" | ");
    detail::number(out, row.bytes);
    out(" | ");
    out(row.name);
    out(" |\n");
  }
  for (const RoutineRow& row : kRoutineTable) {
    out("| 0x31 start | ");
    detail::identifier(out, row.routine);
    out(" | ");
    detail::number(out, row.argument_bytes);
    out(" + ");
    detail::number(out, kProofBytes);
    out(" | ");
    out(row.name);
    out(" |\n");
  }
}

}  // namespace protocol::uds
