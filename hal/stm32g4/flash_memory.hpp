#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"
#include "hal/stm32g4/register.hpp"

namespace hal::stm32g4 {

/// Flash interface of category 2 devices, RM0440 5.7.
template <Word W>
struct FlashRegisters {
  W acr, pdkeyr, keyr, optkeyr, sr, cr, eccr;
  W reserved_1c;
  W optr;
};
static_assert(offsetof(FlashRegisters<Register>, keyr) == 0x08);
static_assert(offsetof(FlashRegisters<Register>, sr) == 0x10);
static_assert(offsetof(FlashRegisters<Register>, cr) == 0x14);
static_assert(offsetof(FlashRegisters<Register>, eccr) == 0x18);
static_assert(offsetof(FlashRegisters<Register>, optr) == 0x20);

namespace flash {
// ACR, 5.7.1
inline constexpr std::uint32_t kLatencyMask = 15, kLatency4 = 4;
inline constexpr std::uint32_t kPrefetch = bit(8), kInstructionCache = bit(9);
inline constexpr std::uint32_t kDataCache = bit(10), kDataCacheReset = bit(12);
// KEYR, 5.7.3
inline constexpr std::uint32_t kKey1 = 0x45670123, kKey2 = 0xCDEF89AB;
// SR, 5.7.5
inline constexpr std::uint32_t kEndOfOperation = bit(0), kOperationError = bit(1);
inline constexpr std::uint32_t kProgramError = bit(3), kWriteProtected = bit(4);
inline constexpr std::uint32_t kAlignmentError = bit(5), kSizeError = bit(6);
inline constexpr std::uint32_t kSequenceError = bit(7), kMissError = bit(8), kFastError = bit(9);
inline constexpr std::uint32_t kReadProtected = bit(14), kOptionError = bit(15);
inline constexpr std::uint32_t kBusy = bit(16);
inline constexpr std::uint32_t kAnyError = kOperationError | kProgramError | kWriteProtected |
                                           kAlignmentError | kSizeError | kSequenceError |
                                           kMissError | kFastError | kReadProtected | kOptionError;
// CR, 5.7.6
inline constexpr std::uint32_t kProgram = bit(0), kPageErase = bit(1), kStart = bit(16);
inline constexpr std::uint32_t kLock = bit(31);
constexpr std::uint32_t page(std::uint32_t number) {
  return number << 3;
}
// ECCR, 5.7.7
inline constexpr std::uint32_t kEccInterrupt = bit(24);
inline constexpr std::uint32_t kEccCorrected = bit(30), kEccDetected = bit(31);
}  // namespace flash

/// What is programmed and protected by one error code.
struct DoubleWord {
  std::uint32_t low;
  std::uint32_t high;
};

/// The flash as memory; offsets count bytes from its start, in multiples of 8.
template <class T>
concept FlashArray = requires(T& array, std::uint32_t offset, DoubleWord value) {
  { array.load(offset) } -> std::same_as<DoubleWord>;
  { array.store(offset, value) } -> std::same_as<void>;
};

/// Erases and programs by the flash interface (RM0440 5.3.5 to 5.3.8). With one bank every fetch
/// from flash stalls meanwhile: what has to continue, and this code itself, must run from RAM.
template <Word W, FlashArray ArrayT>
class FlashOperations {
 public:
  FlashOperations(FlashRegisters<W>& registers, ArrayT& array)
      : registers_(registers), array_(array) {}

  /// `page` counts from the start of the flash. 22 ms.
  Error erase(std::uint32_t page) {
    if (begin() != Error::none) {
      return Error::failed;
    }
    registers_.cr.write(flash::kPageErase | flash::page(page));
    registers_.cr.write(flash::kPageErase | flash::page(page) | flash::kStart);
    return finish();
  }

  /// 85 us. failed where the double word was not erased, or is protected.
  Error program(std::uint32_t offset, DoubleWord value) {
    if (begin() != Error::none) {
      return Error::failed;
    }
    registers_.cr.write(flash::kProgram);
    array_.store(offset, value);
    return finish();
  }

  /// Takes an ECC NMI: true where a guarded read met a damaged double word, false where anything
  /// else caused it.
  [[nodiscard]] bool isr_ecc_error() {
    const std::uint32_t status = registers_.eccr.read();
    if ((status & flash::kEccDetected) == 0) {
      return false;
    }
    registers_.eccr.write((status & flash::kEccInterrupt) | flash::kEccDetected);
    hit_ = 1;
    return guarded_ != 0;
  }

  /// Reads a double word; false, and zeros, where it is damaged beyond correction.
  [[nodiscard]] bool read(std::uint32_t offset, DoubleWord& out) {
    hit_ = 0;
    guarded_ = 1;
    out = array_.load(offset);
    guarded_ = 0;
    if (hit_ == 0) {
      return true;
    }
    out = {0, 0};
    return false;
  }

 private:
  /// Reads of the status that take more than the 40 ms of the longest erase.
  static constexpr std::uint32_t kBusyPolls = 4'000'000;

  /// RM0440 5.3.5: unlocked by two keys; a wrong one locks until reset. Errors of the past are
  /// cleared, or they would forbid to program (PGSERR).
  Error begin() {
    if (wait_until(registers_.sr, flash::kBusy, 0, kBusyPolls) != Error::none) {
      return Error::failed;
    }
    if ((registers_.cr.read() & flash::kLock) != 0) {
      registers_.keyr.write(flash::kKey1);
      registers_.keyr.write(flash::kKey2);
      if ((registers_.cr.read() & flash::kLock) != 0) {
        return Error::failed;
      }
    }
    registers_.sr.write(flash::kAnyError | flash::kEndOfOperation);
    clear_bits(registers_.acr, flash::kDataCache);
    return Error::none;
  }

  Error finish() {
    const Error done = wait_until(registers_.sr, flash::kBusy, 0, kBusyPolls);
    const std::uint32_t status = registers_.sr.read();
    registers_.sr.write(flash::kAnyError | flash::kEndOfOperation);
    registers_.cr.write(0);
    registers_.cr.write(flash::kLock);
    forget_cached();
    return done == Error::none && (status & flash::kAnyError) == 0 ? Error::none : Error::failed;
  }

  /// RM0440 5.3.4: the data cache still has what was there; it is reset while it is off.
  void forget_cached() {
    set_bits(registers_.acr, flash::kDataCacheReset);
    clear_bits(registers_.acr, flash::kDataCacheReset);
    set_bits(registers_.acr, flash::kDataCache);
  }

  FlashRegisters<W>& registers_;
  ArrayT& array_;
  // Shared with the NMI, which nothing holds back.
  volatile std::uint32_t guarded_ = 0;
  volatile std::uint32_t hit_ = 0;
};

/// hal::NonVolatile on some pages of the flash. `OperationsT` has the members erase(), program()
/// and read() of FlashOperations.
template <class OperationsT>
class FlashMemory {
 public:
  static constexpr std::size_t kUnitBytes = 8;
  static constexpr std::size_t kPageBytes = 2048;

  /// `pages` pages from `first_page` on, counted from the start of the flash.
  FlashMemory(OperationsT& operations, std::uint32_t first_page, std::uint32_t pages)
      : operations_(operations), first_page_(first_page), pages_(pages) {}

  [[nodiscard]] std::uint32_t pages() const { return pages_; }

  Error erase(std::uint32_t page) {
    return page < pages_ ? operations_.erase(first_page_ + page) : Error::out_of_range;
  }

  Error program(std::uint32_t address, std::span<const std::byte> in) {
    if (in.size() != kUnitBytes || address % kUnitBytes != 0 || !contains(address, kUnitBytes)) {
      return Error::out_of_range;
    }
    const DoubleWord value{word(in.first(4)), word(in.last(4))};
    DoubleWord now{};
    // All zeros can be programmed over anything (RM0440 5.3.7), which is not what was agreed.
    if (!operations_.read(offset(address), now) || (now.low & now.high) != 0xFFFFFFFFu) {
      return Error::failed;
    }
    return operations_.program(offset(address), value);
  }

  Error read(std::uint32_t address, std::span<std::byte> out) {
    if (!contains(address, out.size())) {
      return Error::out_of_range;
    }
    Error result = Error::none;
    for (std::size_t done = 0; done < out.size();) {
      const auto place = static_cast<std::uint32_t>(address + done);
      const std::uint32_t within = place % kUnitBytes;
      const std::size_t count = std::min<std::size_t>(kUnitBytes - within, out.size() - done);
      DoubleWord value{};
      if (!operations_.read(offset(place - within), value)) {
        result = Error::damaged;
      }
      for (std::size_t i = 0; i < count; ++i) {
        out[done + i] = byte_of(value, within + i);
      }
      done += count;
    }
    return result;
  }

 private:
  [[nodiscard]] bool contains(std::uint32_t address, std::size_t count) const {
    const std::size_t size = pages_ * kPageBytes;
    return address <= size && count <= size - address;
  }
  [[nodiscard]] std::uint32_t offset(std::uint32_t address) const {
    return first_page_ * static_cast<std::uint32_t>(kPageBytes) + address;
  }
  static std::uint32_t word(std::span<const std::byte> bytes) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
    }
    return value;
  }
  static std::byte byte_of(DoubleWord value, std::size_t index) {
    return static_cast<std::byte>((index < 4 ? value.low : value.high) >> (8 * (index % 4)));
  }

  OperationsT& operations_;
  std::uint32_t first_page_;
  std::uint32_t pages_;
};

}  // namespace hal::stm32g4
