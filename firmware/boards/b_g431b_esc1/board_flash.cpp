#include "firmware/boards/b_g431b_esc1/board_flash.hpp"

#include "firmware/boards/b_g431b_esc1/interrupts.hpp"

// This file lies in RAM; see the linker script.
namespace board {
namespace {

class WithoutSettling {
 public:
  WithoutSettling() { mask_priority(kSettlePriority); }
  WithoutSettling(const WithoutSettling&) = delete;
  WithoutSettling& operator=(const WithoutSettling&) = delete;
  ~WithoutSettling() { mask_priority(before_); }

 private:
  std::uint32_t before_ = masked_priority();
};

}  // namespace

hal::Error BoardFlash::erase(std::uint32_t page) {
  const WithoutSettling only_the_loop;
  return operations_.erase(page);
}

hal::Error BoardFlash::program(std::uint32_t offset, hal::stm32g4::DoubleWord value) {
  const WithoutSettling only_the_loop;
  return operations_.program(offset, value);
}

}  // namespace board
