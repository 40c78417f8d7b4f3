#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"
#include "hal/fake/random.hpp"

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

/// Flash in memory that fails as it is asked to. Operations, programs and erases alike, are counted
/// from 0 over the whole life of the object; a fault is tied to the number of an operation.
///
/// A unit is programmed once after each erase, as on an STM32G4: a second time fails and changes
/// nothing. After a power cut every call fails and nothing changes until power_on(). Copies are
/// images that go their own way.
template <std::uint32_t kPages = 20, std::size_t kPage = 2'048, std::size_t kUnit = 8>
class Flash {
 public:
  static constexpr std::size_t kUnitBytes = kUnit;
  static constexpr std::size_t kPageBytes = kPage;
  static constexpr std::size_t kBytes = kPages * kPage;

  constexpr Flash() { bytes_.fill(std::byte{0xff}); }

  static constexpr std::uint32_t pages() { return kPages; }

  constexpr Error erase(std::uint32_t page) {
    if (!powered_) {
      return Error::failed;
    }
    if (page >= kPages) {
      return Error::out_of_range;
    }
    const bool now = operations_++ == fault_operation_;
    if (now && fault_.kind == FlashFault::Kind::refuse) {
      return Error::failed;
    }
    if (now && fault_.kind == FlashFault::Kind::lose) {
      return Error::none;
    }
    if (now) {
      tear_page(page);
      powered_ = false;
      return Error::failed;
    }
    if (bad_[page] == BadPage::erase_fails) {
      return Error::failed;
    }
    ++erases_[page];
    const std::size_t kept = bad_[page] == BadPage::keeps_bits ? kUnit : 0;
    const std::size_t first = page * kPage;
    set(first + kept, first + kPage, Unit::erased);
    return Error::none;
  }

  constexpr Error program(std::uint32_t address, std::span<const std::byte> in) {
    if (!powered_) {
      return Error::failed;
    }
    if (in.size() != kUnit || address % kUnit != 0 || address >= kBytes) {
      return Error::out_of_range;
    }
    const bool now = operations_++ == fault_operation_;
    if (now && fault_.kind == FlashFault::Kind::lose) {
      return Error::none;
    }
    if (now && fault_.kind == FlashFault::Kind::refuse) {
      return Error::failed;
    }
    Unit& unit = units_[address / kUnit];
    if (unit != Unit::erased) {
      ++overwrites_;
      return Error::failed;
    }
    if (now) {
      tear_unit(address, in);
      powered_ = false;
      return Error::failed;
    }
    if (bad_[address / kPage] == BadPage::program_fails) {
      return Error::failed;
    }
    std::ranges::copy(in, bytes_.begin() + address);
    unit = Unit::programmed;
    return Error::none;
  }

  constexpr Error read(std::uint32_t address, std::span<std::byte> out) const {
    std::ranges::fill(out, std::byte{0});
    if (!powered_) {
      return Error::failed;
    }
    if (address > kBytes || out.size() > kBytes - address) {
      return Error::out_of_range;
    }
    std::ranges::copy(std::span(bytes_).subspan(address, out.size()), out.begin());
    bool damaged = false;
    for (std::size_t unit = address / kUnit; unit * kUnit < address + out.size(); ++unit) {
      if (units_[unit] == Unit::torn) {
        hide(unit, address, out);
        damaged = true;
      }
    }
    return damaged ? Error::damaged : Error::none;
  }

  /// The operation with this number goes wrong.
  constexpr void fault(std::uint64_t operation, FlashFault what) {
    fault_operation_ = operation;
    fault_ = what;
  }
  /// Power comes back; a fault that is still to come is forgotten.
  constexpr void power_on() {
    powered_ = true;
    fault_operation_ = kNever;
  }
  constexpr void make_bad(std::uint32_t page, BadPage how) { bad_[page] = how; }
  /// A bit changes and nothing notices.
  constexpr void flip(std::uint32_t address, unsigned bit) {
    bytes_[address] ^= static_cast<std::byte>(1u << bit);
    units_[address / kUnit] = Unit::programmed;
  }
  /// A unit loses more bits than can be corrected.
  constexpr void spoil(std::uint32_t address) { units_[address / kUnit] = Unit::torn; }
  /// Replaces the whole content; nothing in it counts as torn.
  constexpr void load(std::span<const std::byte> image) {
    std::ranges::copy(image.first(std::min(image.size(), kBytes)), bytes_.begin());
    for (std::size_t unit = 0; unit < units_.size(); ++unit) {
      const auto content = std::span(bytes_).subspan(unit * kUnit, kUnit);
      const bool blank =
          std::ranges::all_of(content, [](std::byte b) { return b == std::byte{0xff}; });
      units_[unit] = blank ? Unit::erased : Unit::programmed;
    }
  }

  [[nodiscard]] constexpr bool powered() const { return powered_; }
  [[nodiscard]] constexpr std::uint64_t operations() const { return operations_; }
  [[nodiscard]] constexpr std::uint32_t erases(std::uint32_t page) const { return erases_[page]; }
  /// Programs of units that were not erased.
  [[nodiscard]] constexpr std::uint32_t overwrites() const { return overwrites_; }
  [[nodiscard]] constexpr std::span<const std::byte> content() const { return bytes_; }

 private:
  enum class Unit : std::uint8_t { erased, programmed, torn };
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};

  constexpr void set(std::size_t from, std::size_t to, Unit unit) {
    std::fill(bytes_.begin() + static_cast<std::ptrdiff_t>(from),
              bytes_.begin() + static_cast<std::ptrdiff_t>(to), std::byte{0xff});
    std::fill(units_.begin() + static_cast<std::ptrdiff_t>(from / kUnit),
              units_.begin() + static_cast<std::ptrdiff_t>(to / kUnit), unit);
  }

  /// The part of a unit that lies in `out`, which starts at `address`, reads as zeros.
  static constexpr void hide(std::size_t unit, std::size_t address, std::span<std::byte> out) {
    const std::size_t from = std::max(unit * kUnit, address) - address;
    const std::size_t to = std::min((unit + 1) * kUnit - address, out.size());
    std::ranges::fill(out.subspan(from, to - from), std::byte{0});
  }

  constexpr void tear_unit(std::uint32_t address, std::span<const std::byte> in) {
    Unit& unit = units_[address / kUnit];
    switch (fault_.kind) {
      case FlashFault::Kind::cut_after:
        std::ranges::copy(in, bytes_.begin() + address);
        unit = Unit::programmed;
        return;
      case FlashFault::Kind::cut_torn:
        unit = Unit::torn;
        return;
      case FlashFault::Kind::cut_half: {
        // Programming clears bits: some of those that it had to clear are still set.
        Random random(fault_.seed);
        for (std::size_t i = 0; i < kUnit; ++i) {
          bytes_[address + i] = in[i] | static_cast<std::byte>(random.next());
        }
        unit = Unit::programmed;
        return;
      }
      case FlashFault::Kind::cut_before:
      case FlashFault::Kind::refuse:
      case FlashFault::Kind::lose:
        return;
    }
  }

  constexpr void tear_page(std::uint32_t page) {
    const std::size_t first = page * kPage;
    if (fault_.kind == FlashFault::Kind::cut_before) {
      return;
    }
    ++erases_[page];
    if (fault_.kind == FlashFault::Kind::cut_after) {
      set(first, first + kPage, Unit::erased);
      return;
    }
    Random random(fault_.seed);
    for (std::size_t at = first; at < first + kPage; at += kUnit) {
      tear_erased(at, random);
    }
  }
  /// One unit of a page whose erase was cut: old, erased, torn, or with some bits set.
  constexpr void tear_erased(std::size_t at, Random& random) {
    switch (random.below(4)) {
      case 0:
        return;
      case 1:
        set(at, at + kUnit, Unit::erased);
        return;
      case 2:
        units_[at / kUnit] =
            fault_.kind == FlashFault::Kind::cut_torn ? Unit::torn : Unit::programmed;
        return;
      default:
        for (std::size_t i = 0; i < kUnit; ++i) {
          bytes_[at + i] |= static_cast<std::byte>(random.next());
        }
        units_[at / kUnit] = Unit::programmed;
    }
  }

  std::array<std::byte, kBytes> bytes_;
  std::array<Unit, kBytes / kUnit> units_{};
  std::array<BadPage, kPages> bad_{};
  std::array<std::uint32_t, kPages> erases_{};
  std::uint64_t operations_ = 0;
  std::uint64_t fault_operation_ = kNever;
  FlashFault fault_{};
  std::uint32_t overwrites_ = 0;
  bool powered_ = true;
};

}  // namespace hal::fake
