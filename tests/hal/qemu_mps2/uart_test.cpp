#include "hal/qemu_mps2/uart.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "hal/byte_stream.hpp"
#include "hal/can_port.hpp"
#include "hal/slcan/port.hpp"

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

namespace hal::qemu_mps2 {
namespace {

using qemu_mps2_test::UartModel;
static_assert(ByteStream<Uart<>>);
static_assert(CanPort<slcan::Port<Uart<>>>);

class UartTest : public testing::Test {
 protected:
  static constexpr std::size_t kQueue = 8;

  void start() { ASSERT_EQ(uart_.start(25'000'000, 115'200), Error::none); }
  void arrive(std::string_view text) {
    for (const char c : text) {
      if (model_.arrives(c)) {
        uart_.isr_receive();
      }
    }
  }
  std::string read(std::size_t most = 100) {
    std::array<std::byte, 100> bytes{};
    const std::size_t count = uart_.try_read(std::span(bytes).first(most));
    return {reinterpret_cast<const char*>(bytes.data()), count};
  }
  std::size_t write(std::string_view text) {
    return uart_.try_write(std::as_bytes(std::span(text)));
  }

  UartModel model_;
  Uart<UartModel, kQueue> uart_{model_};
};

TEST_F(UartTest, DividesTheClock) {
  start();
  // 25 MHz / 115,200 = 217.01
  EXPECT_EQ(model_.divider(), 217u);
  EXPECT_EQ(model_.control.read(), 0b1011u);
}

TEST_F(UartTest, RefusesSpeedsThatTheClockDoesNotGive) {
  // The divider is 16 .. 2^20 - 1.
  EXPECT_EQ(uart_.start(25'000'000, 1'562'501), Error::out_of_range);
  EXPECT_EQ(uart_.start(25'000'000, 23), Error::out_of_range);
  EXPECT_EQ(uart_.start(25'000'000, 0), Error::out_of_range);
  EXPECT_EQ(model_.control.read(), 0u);
  EXPECT_EQ(uart_.start(25'000'000, 1'562'500), Error::none);
  EXPECT_EQ(model_.divider(), 16u);
  EXPECT_EQ(uart_.start(25'000'000, 24), Error::none);
}

TEST_F(UartTest, GivesWhatArrivedInOrder) {
  start();
  arrive("abc");
  EXPECT_EQ(read(2), "ab");
  arrive("de");
  EXPECT_EQ(read(), "cde");
  EXPECT_EQ(read(), "");
}

TEST_F(UartTest, GoesRoundItsQueue) {
  start();
  for (int i = 0; i < 100; ++i) {
    arrive("01234");
    EXPECT_EQ(read(), "01234");
  }
  EXPECT_EQ(uart_.lost(), 0u);
}

TEST_F(UartTest, CountsBytesThatFindTheQueueFull) {
  start();
  arrive("0123456789");
  EXPECT_EQ(uart_.lost(), 2u);
  EXPECT_EQ(read(), "01234567");
  arrive("x");
  EXPECT_EQ(read(), "x");
}

TEST_F(UartTest, CountsBytesThatTheInterruptWasTooLateFor) {
  start();
  ASSERT_TRUE(model_.arrives('a'));
  ASSERT_FALSE(model_.arrives('b'));
  uart_.isr_receive();
  EXPECT_EQ(uart_.lost(), 1u);
  EXPECT_EQ(read(), "a");
  arrive("c");
  EXPECT_EQ(uart_.lost(), 1u);
  EXPECT_EQ(read(), "c");
}

TEST_F(UartTest, AnInterruptWithoutAByteTakesNone) {
  start();
  uart_.isr_receive();
  EXPECT_EQ(read(), "");
  EXPECT_EQ(uart_.lost(), 0u);
}

TEST_F(UartTest, WritesAsFastAsTheDeviceTakes) {
  start();
  EXPECT_EQ(write("abc"), 1u);
  EXPECT_EQ(write("bc"), 0u);
  model_.leaves();
  EXPECT_EQ(write("bc"), 1u);
  model_.set_fast();
  model_.leaves();
  EXPECT_EQ(write("cdef"), 4u);
  EXPECT_EQ(model_.sent(), "abcdef");
}

TEST_F(UartTest, CarriesSlcan) {
  start();
  model_.set_fast();
  slcan::Port<decltype(uart_)> port(uart_);
  arrive("S8\rO\r");
  EXPECT_EQ(port.receive(), std::nullopt);
  EXPECT_EQ(port.send({0x701, false, 1, {std::byte{0x05}}}), Error::none);
  EXPECT_EQ(model_.sent(), "\r\rt701105\r");
}

}  // namespace
}  // namespace hal::qemu_mps2
