#include "hal/qemu_mps2/uart.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>

#include "hal/byte_stream.hpp"
#include "hal/can_port.hpp"
#include "hal/slcan/port.hpp"
#include "tests/hal/qemu_mps2/uart_model.hpp"

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
