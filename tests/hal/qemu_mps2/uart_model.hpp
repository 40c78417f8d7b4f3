#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

/// The APB UART as its manual describes it (DDI 0479, 4.3), with a line at both ends.
namespace qemu_mps2_test {

class UartModel {
 public:
  struct Data {
    UartModel& model;
    std::uint32_t read() { return model.read_data(); }
    void write(std::uint32_t value) { model.write_data(value); }
  };
  struct State {
    UartModel& model;
    std::uint32_t read() const { return model.state_; }
    void write(std::uint32_t value) { model.state_ &= ~(value & 0xcu); }
  };
  struct Control {
    UartModel& model;
    std::uint32_t read() const { return model.control_; }
    void write(std::uint32_t value) { model.write_control(value); }
  };
  struct Interrupt {
    UartModel& model;
    std::uint32_t read() const { return model.interrupt_; }
    void write(std::uint32_t value) { model.interrupt_ &= ~value; }
  };
  struct BaudDivider {
    UartModel& model;
    std::uint32_t read() const { return model.divider_; }
    void write(std::uint32_t value) {
      EXPECT_EQ(model.control_ & 3u, 0u) << "the divider changes while the device runs";
      model.divider_ = value;
    }
  };

  Data data{*this};
  State state{*this};
  Control control{*this};
  Interrupt interrupt{*this};
  BaudDivider baud_divider{*this};

  /// A byte comes in. True where that raises the interrupt.
  bool arrives(char byte) {
    if ((control_ & 2u) == 0) {
      return false;
    }
    if ((state_ & 2u) != 0) {
      state_ |= 8u;
      return false;
    }
    received_ = static_cast<std::uint8_t>(byte);
    state_ |= 2u;
    if ((control_ & 8u) != 0) {
      interrupt_ |= 2u;
    }
    return (interrupt_ & 2u) != 0;
  }
  /// The byte that waits goes out.
  void leaves() {
    if ((state_ & 1u) != 0) {
      sent_ += pending_;
      state_ &= ~1u;
    }
  }
  /// Bytes leave at once from now on.
  void set_fast() { fast_ = true; }
  [[nodiscard]] const std::string& sent() const { return sent_; }
  [[nodiscard]] std::uint32_t divider() const { return divider_; }

 private:
  std::uint32_t read_data() {
    state_ &= ~2u;
    return received_;
  }
  void write_data(std::uint32_t value) {
    EXPECT_NE(control_ & 1u, 0u) << "written while the transmitter is off";
    EXPECT_EQ(state_ & 1u, 0u) << "written while it is full: the byte before is lost";
    pending_ = static_cast<char>(value);
    state_ |= 1u;
    if (fast_) {
      leaves();
    }
  }
  void write_control(std::uint32_t value) {
    if ((value & 3u) != 0) {
      EXPECT_GE(divider_, 16u) << "started without a divider";
    }
    control_ = value;
  }

  std::uint32_t state_ = 0;
  std::uint32_t control_ = 0;
  std::uint32_t interrupt_ = 0;
  std::uint32_t divider_ = 0;
  std::uint8_t received_ = 0;
  char pending_ = 0;
  bool fast_ = false;
  std::string sent_;
};

}  // namespace qemu_mps2_test
