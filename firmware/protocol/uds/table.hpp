#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "firmware/protocol/authority/gate.hpp"
#include "lifemodel/extension/extended_block.hpp"

namespace protocol::uds {

/// What can be read, by data identifier. Identifiers are sent with the high byte first, as
/// ISO 14229-1 has it; the data behind them are little-endian, as everything else of this node.
///
/// | identifier | bytes | data |
/// |---|---|---|
/// | 0x0200 + t | 61 | life record of tendon t: see LifeRecordData |
/// | 0x0220 + t | 4 | CRC-32 of the parameter block of tendon t; 0 without one |
/// | 0x0260 + t | 8 | which parameters tendon t counts with: see write_parameters() |
/// | 0x0240 | 4 | storage counter |
/// | 0x0241 | 16 | a fresh nonce; reading it closes the one before |
/// | 0x0242 | 18 | authority: see AuthorityData |
/// | 0x1000 + i | 16 | line i of the log, from the oldest: see LogData |
/// | 0xf18c | 12 | serial number of the controller |
/// | 0xf195 | 2 | version of the frame plan; of the firmware, major in the high 4 bits |
///
/// 0x0200 .. 0x1fff are the manufacturer's (ISO 14229-1, annex C.1).
struct DataRow {
  std::uint16_t first;
  std::uint16_t last;
  std::uint8_t bytes;
  const char* name;
};

inline constexpr std::uint8_t kMostTendons = 32;
inline constexpr std::size_t kLifeBytes = 61;
inline constexpr std::size_t kAuthorityBytes = 18;
inline constexpr std::size_t kLogBytes = 16;
inline constexpr std::size_t kParametersBytes = 8;

inline constexpr DataRow kLife{0x0200, 0x0200 + kMostTendons - 1, kLifeBytes,
                               "life record of a tendon"};
inline constexpr DataRow kConfiguration{0x0220, 0x0220 + kMostTendons - 1, 4,
                                        "CRC-32 of the parameter block of a tendon"};
inline constexpr DataRow kParameters{0x0260, 0x0260 + kMostTendons - 1, kParametersBytes,
                                     "parameters that a tendon counts with, or why it does not"};
inline constexpr DataRow kStorageCounter{0x0240, 0x0240, 4, "storage counter"};
inline constexpr DataRow kNonce{0x0241, 0x0241, 16, "a fresh nonce, good for one command in 5 s"};
inline constexpr DataRow kAuthority{0x0242, 0x0242, kAuthorityBytes, "state of the authority"};
inline constexpr DataRow kLog{0x1000, 0x1fff, kLogBytes, "line of the log, from the oldest"};
inline constexpr DataRow kSerial{0xf18c, 0xf18c, 12, "serial number of the controller"};
inline constexpr DataRow kVersion{0xf195, 0xf195, 2, "versions of frame plan and firmware"};

// With a deduced type GCC 12 would put it into RAM.
inline constexpr std::array<DataRow, 9> kDataTable{
    kLife,      kConfiguration, kParameters, kStorageCounter, kNonce,
    kAuthority, kLog,           kSerial,     kVersion};

/// Routines that are started under authority:
///
///   31 01, routine (the high byte first), arguments, storage counter (4, little-endian), code (8)
///
/// with the code of authority::mac(). Arguments:
///
/// | routine | bytes | arguments |
/// |---|---|---|
/// | 0x0201 | 1 | tendon: a new wire was put in, its epoch begins |
/// | 0x0202 | 85 or 129 | tendon, parameter block of version 1 or 2 without an extension |
/// | 0x0203 | 1 | tendon: the parameter block that was transferred before, see Transfer |
///
/// The answer is 71 01 and the routine.
struct RoutineRow {
  std::uint16_t routine;
  std::uint8_t argument_bytes;
  std::uint8_t or_bytes;  ///< another size of the arguments; the same where there is one alone
  const char* name;

  [[nodiscard]] constexpr bool takes(std::size_t bytes) const {
    return bytes == argument_bytes || bytes == or_bytes;
  }
};

inline constexpr RoutineRow kOpenEpoch{0x0201, 1, 1, "open a new epoch of a tendon"};
inline constexpr RoutineRow kLoadParameters{
    0x0202, 1 + lifemodel::kBlockBytes, 1 + lifemodel::kWatchedBlockBytes,
    "load the parameter block of a tendon, of version 1 or 2"};
inline constexpr RoutineRow kLoadTransferred{0x0203, 1, 1,
                                             "load the parameter block that was transferred"};

inline constexpr std::array<RoutineRow, 3> kRoutineTable{kOpenEpoch, kLoadParameters,
                                                         kLoadTransferred};

/// Added to a service in its positive answer.
inline constexpr std::uint8_t kPositive = 0x40;
/// The sub-function that starts a routine.
inline constexpr std::uint8_t kStartRoutine = 0x01;
/// Before the arguments: service, sub-function, routine.
inline constexpr std::size_t kRoutineHeadBytes = 4;
/// Behind the arguments: storage counter and code.
inline constexpr std::size_t kProofBytes = 4 + authority::kMacBytes;

/// The longest request and answer of this server.
inline constexpr std::size_t kMostMessageBytes =
    kRoutineHeadBytes + kLoadParameters.or_bytes + kProofBytes;

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
    if (row.or_bytes != row.argument_bytes) {
      out(" or ");
      detail::number(out, row.or_bytes);
    }
    out(" + ");
    detail::number(out, kProofBytes);
    out(" | ");
    out(row.name);
    out(" |\n");
  }
  out("| 0x34, 0x36, 0x37 | | ");
  detail::number(out, lifemodel::kMostExtendedBytes);
  out(" at most | transfer a parameter block in parts |\n");
}

}  // namespace protocol::uds
