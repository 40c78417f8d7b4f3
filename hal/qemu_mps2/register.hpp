#pragma once

#include <cstdint>

namespace hal::qemu_mps2 {

/// A register of a device; lies where the device has it.
class Register {
 public:
  [[nodiscard]] std::uint32_t read() const { return value_; }
  void write(std::uint32_t value) { value_ = value; }

 private:
  volatile std::uint32_t value_;
};
static_assert(sizeof(Register) == 4);

}  // namespace hal::qemu_mps2
