#pragma once

#include <cstdint>

#include "firmware/boards/b_g431b_esc1/registers.hpp"
#include "hal/stm32g4/flash_memory.hpp"

namespace boards::b_g431b_esc1 {

/// The flash where the bus sees it.
class FlashArray {
 public:
  [[nodiscard]] hal::stm32g4::DoubleWord load(std::uint32_t offset) {
    const volatile std::uint32_t* words = at(offset);
    const hal::stm32g4::DoubleWord value{words[0], words[1]};
    // An NMI for these words has been taken when this is through.
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    return value;
  }
  void store(std::uint32_t offset, hal::stm32g4::DoubleWord value) {
    volatile std::uint32_t* words = at(offset);
    words[0] = value.low;
    // The two halves must not swap places (RM0440 5.3.7).
    __asm__ volatile("isb" ::: "memory");
    words[1] = value.high;
    __asm__ volatile("dsb" ::: "memory");
  }

 private:
  static volatile std::uint32_t* at(std::uint32_t offset) {
    return reinterpret_cast<volatile std::uint32_t*>(registers::addresses::kFlashArray + offset);
  }
};

/// Operations of hal::stm32g4::FlashMemory. What writes runs from RAM and keeps settling away, for
/// that is in flash: while the bank is busy nothing fetches from it, and no sample is lost.
class BoardFlash {
 public:
  [[nodiscard]] hal::Error erase(std::uint32_t page);
  [[nodiscard]] hal::Error program(std::uint32_t offset, hal::stm32g4::DoubleWord value);
  [[nodiscard]] bool read(std::uint32_t offset, hal::stm32g4::DoubleWord& out) {
    return operations_.read(offset, out);
  }
  [[nodiscard]] bool isr_ecc_error() { return operations_.isr_ecc_error(); }

 private:
  FlashArray array_;
  hal::stm32g4::FlashOperations<registers::Register, FlashArray> operations_{registers::flash(),
                                                                             array_};
};

}  // namespace boards::b_g431b_esc1
