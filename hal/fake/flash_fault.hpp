#pragma once

#include <cstdint>

namespace hal::fake {

/// What goes wrong with one operation of a Flash.
struct FlashFault {
  enum class Kind : std::uint8_t {
    cut_before,  ///< power goes, and nothing has happened
    cut_torn,    ///< power goes halfway: what was touched cannot be read any more
    cut_half,    ///< power goes halfway: some bits are as they should be, and nothing notices
    cut_after,   ///< power goes, and everything has happened
    refuse,      ///< nothing happens, and the device says so
    lose,        ///< nothing happens, and the device says that it did
  };

  Kind kind = Kind::cut_before;
  std::uint64_t seed = 1;  ///< decides which bits
};

/// What is wrong with a page for good.
enum class BadPage : std::uint8_t {
  no,
  erase_fails,
  keeps_bits,  ///< an erase seems to succeed, and its first unit stays as it was
  program_fails,
};

}  // namespace hal::fake
