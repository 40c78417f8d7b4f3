#pragma once

#include <concepts>
#include <cstdint>

#include "hal/error.hpp"
#include "hal/stm32g4/registers/flash.hpp"

namespace hal::stm32g4 {

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
/// from flash stalls meanwhile: what has to go on, and this code itself, must run from RAM.
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

}  // namespace hal::stm32g4
