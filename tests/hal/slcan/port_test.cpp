#include "hal/slcan/port.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/hal/slcan/wire.hpp"

namespace hal::slcan {
namespace {

using slcan_test::Wire;
static_assert(CanPort<Port<Wire>>);

constexpr CanFrame kFrame{0x123, false, 2, {std::byte{0x0A}, std::byte{0xB0}}};

class SlcanPort : public testing::Test {
 protected:
  /// What the node answers to a text that makes no frame.
  std::string answer(const std::string& text) {
    wire_.host_writes(text);
    EXPECT_EQ(port_.receive(), std::nullopt);
    return wire_.host_reads();
  }
  void open() { ASSERT_EQ(answer("O\r"), "\r"); }

  Wire wire_;
  Port<Wire> port_{wire_};
};

TEST_F(SlcanPort, IsOpenedAsSlcandDoesIt) {
  EXPECT_EQ(port_.status().state, CanState::off);
  EXPECT_EQ(answer("C\rS8\rO\r"), "\a\r\r");
  EXPECT_EQ(port_.status().state, CanState::active);
  EXPECT_EQ(port_.status().receive_errors, 0);
  EXPECT_EQ(answer("C\r"), "\r");
  EXPECT_EQ(port_.status().state, CanState::off);
}

TEST_F(SlcanPort, AnswersWhatTheManualSays) {
  EXPECT_EQ(answer("V\r"), "V0001\r");
  EXPECT_EQ(answer("N\r"), "N0000\r");
  EXPECT_EQ(answer("F\r"), "\a");
  EXPECT_EQ(answer("Z0\r"), "\r");
  EXPECT_EQ(answer("Z1\r"), "\a");
  EXPECT_EQ(answer("S0\rS9\r"), "\r\a");
  EXPECT_EQ(answer("\r\r\r"), "");
  open();
  EXPECT_EQ(answer("O\rL\rS8\rZ0\r"), "\a\a\a\a");
  EXPECT_EQ(answer("F\r"), "F00\r");
}

TEST_F(SlcanPort, SaysNothingWhileClosed) {
  EXPECT_EQ(port_.send(kFrame), Error::off);
  EXPECT_EQ(port_.recover(), Error::off);
  EXPECT_EQ(answer("t12320AB0\r"), "\a");
  EXPECT_EQ(port_.refused().not_open, 1u);
  EXPECT_EQ(wire_.host_reads(), "");
}

TEST_F(SlcanPort, CarriesFramesBothWays) {
  open();
  EXPECT_EQ(port_.recover(), Error::none);
  EXPECT_EQ(port_.send(kFrame), Error::none);
  EXPECT_EQ(wire_.host_reads(), "t12320AB0\r");
  wire_.host_writes("t12320ab0\rT18DA01F10\r");
  EXPECT_EQ(port_.receive(), kFrame);
  EXPECT_EQ(port_.receive(), (CanFrame{0x18da01f1, true, 0, {}}));
  EXPECT_EQ(port_.receive(), std::nullopt);
  EXPECT_EQ(wire_.host_reads(), "z\rZ\r");
}

TEST_F(SlcanPort, ListensOnly) {
  EXPECT_EQ(answer("L\r"), "\r");
  EXPECT_EQ(port_.send(kFrame), Error::none);
  EXPECT_EQ(wire_.host_reads(), "t12320AB0\r");
  EXPECT_EQ(answer("t12320AB0\r"), "\a");
}

TEST_F(SlcanPort, AcceptsRemoteFramesAndDropsThem) {
  open();
  EXPECT_EQ(answer("r1232\rR000001232\r"), "z\rZ\r");
  EXPECT_EQ(port_.refused().remote, 2u);
}

TEST_F(SlcanPort, CountsWhatItCannotRead) {
  open();
  EXPECT_EQ(answer("t12\r"), "\a");
  EXPECT_EQ(answer("hello\r"), "\a");
  EXPECT_EQ(port_.refused().malformed, 2u);
  EXPECT_EQ(answer(std::string(60, 'T') + "\r"), "\a");
  EXPECT_EQ(port_.refused().too_long, 1u);
  EXPECT_EQ(port_.status().receive_errors, 3);
  EXPECT_EQ(answer("F\rF\r"), "F08\rF00\r");
}

TEST_F(SlcanPort, ErrorsStopAtTheEndOfTheByte) {
  open();
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(answer("?\r"), "\a");
  }
  EXPECT_EQ(port_.status().receive_errors, 255);
  EXPECT_EQ(port_.refused().malformed, 300u);
}

TEST_F(SlcanPort, RefusesFramesThatCannotBe) {
  open();
  EXPECT_EQ(port_.send({0x800, false, 0, {}}), Error::out_of_range);
  EXPECT_EQ(port_.send({0x2000'0000, true, 0, {}}), Error::out_of_range);
  EXPECT_EQ(port_.send({0x1, false, 9, {}}), Error::out_of_range);
  EXPECT_EQ(wire_.host_reads(), "");
}

TEST_F(SlcanPort, IsFullWhenNobodyReads) {
  open();
  wire_.set_room(5);
  int sent = 0;
  while (port_.send(kFrame) == Error::none) {
    ++sent;
  }
  // 512 bytes and the 5 on the line, less the 26 for an answer, hold 49 lines of 10.
  EXPECT_EQ(sent, 49);
  EXPECT_EQ(port_.send(kFrame), Error::full);
  wire_.set_room(10'000);
  EXPECT_EQ(port_.receive(), std::nullopt);
  std::string expected;
  for (int i = 0; i < sent; ++i) {
    expected += "t12320AB0\r";
  }
  EXPECT_EQ(wire_.host_reads(), expected);
  EXPECT_EQ(answer("F\r"), "F02\r");
}

TEST_F(SlcanPort, KeepsCommandsWaitingWhileItsAnswersFindNoRoom) {
  open();
  wire_.set_room(0);
  for (int i = 0; i < 500; ++i) {
    wire_.host_writes("V\r");
    EXPECT_EQ(port_.receive(), std::nullopt);
  }
  EXPECT_GT(wire_.unread(), 0u);
  wire_.set_room(1'000'000);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(port_.receive(), std::nullopt);
  }
  std::string expected;
  for (int i = 0; i < 500; ++i) {
    expected += "V0001\r";
  }
  EXPECT_EQ(wire_.host_reads(), expected);
}

TEST_F(SlcanPort, LooksAtABoundedNumberOfBytes) {
  open();
  wire_.host_writes(std::string(1'000, 'x'));
  EXPECT_EQ(port_.receive(), std::nullopt);
  EXPECT_EQ(wire_.unread(), 1'000 - Port<Wire>::kBite);
}

TEST(SlcanPortStart, MayBeOpenFromTheStart) {
  Wire wire;
  Port<Wire> port(wire, Channel::open);
  EXPECT_EQ(port.send(kFrame), Error::none);
  EXPECT_EQ(wire.host_reads(), "t12320AB0\r");
}

}  // namespace
}  // namespace hal::slcan
