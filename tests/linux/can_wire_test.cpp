// Expected values from linux/can/error.h: the classes stand in the id, the controller's state in
// byte 1, the error counters in bytes 6 and 7.

#include "hal/linux/can_wire.hpp"

#include <gtest/gtest.h>

namespace hal::linux_os {
namespace {

::can_frame error_frame(std::uint32_t classes, std::uint8_t controller = 0, std::uint8_t tec = 0,
                        std::uint8_t rec = 0) {
  ::can_frame frame{};
  frame.can_id = 0x2000'0000U | classes;
  frame.can_dlc = 8;
  frame.data[1] = controller;
  frame.data[6] = tec;
  frame.data[7] = rec;
  return frame;
}

class CanErrorFrame : public testing::Test {
 protected:
  void take(const ::can_frame& frame) { take_error_frame(frame, status_, faults_); }

  CanStatus status_;
  CanFaults faults_;
};

TEST_F(CanErrorFrame, BusOffIsCountedOnceUntilItIsOver) {
  take(error_frame(0x40));
  take(error_frame(0x40));
  EXPECT_EQ(status_.state, CanState::off);
  EXPECT_EQ(status_.bus_offs, 1U);

  take(error_frame(0x100));
  EXPECT_EQ(status_.state, CanState::active);
  EXPECT_EQ(faults_.restarts, 1U);

  take(error_frame(0x40));
  EXPECT_EQ(status_.bus_offs, 2U);
}

TEST_F(CanErrorFrame, TheControllerTellsItsState) {
  take(error_frame(0x4, 0x08));
  EXPECT_EQ(status_.state, CanState::warning);
  take(error_frame(0x4, 0x20));
  EXPECT_EQ(status_.state, CanState::passive);
  take(error_frame(0x4, 0x04));
  EXPECT_EQ(status_.state, CanState::warning);
  take(error_frame(0x4, 0x10));
  EXPECT_EQ(status_.state, CanState::passive);
  take(error_frame(0x4, 0x40));
  EXPECT_EQ(status_.state, CanState::active);
}

TEST_F(CanErrorFrame, OverflowsAreCountedAndChangeNoState) {
  take(error_frame(0x4, 0x20));
  take(error_frame(0x4, 0x01));
  take(error_frame(0x4, 0x02));
  EXPECT_EQ(faults_.overflows, 2U);
  EXPECT_EQ(status_.state, CanState::passive);
}

TEST_F(CanErrorFrame, CountersTellTheState) {
  take(error_frame(0x200, 0, 95, 12));
  EXPECT_EQ(status_.transmit_errors, 95);
  EXPECT_EQ(status_.receive_errors, 12);
  EXPECT_EQ(status_.state, CanState::active);
  take(error_frame(0x200, 0, 0, 96));
  EXPECT_EQ(status_.state, CanState::warning);
  take(error_frame(0x200, 0, 128, 96));
  EXPECT_EQ(status_.state, CanState::passive);
  take(error_frame(0x200, 0, 127, 127));
  EXPECT_EQ(status_.state, CanState::warning);
}

TEST_F(CanErrorFrame, NothingButARestartEndsBusOff) {
  take(error_frame(0x40));
  take(error_frame(0x4, 0x40));
  take(error_frame(0x200, 0, 0, 0));
  EXPECT_EQ(status_.state, CanState::off);
}

TEST_F(CanErrorFrame, ARestartAndBusOffInOneFrameIsOff) {
  take(error_frame(0x140));
  EXPECT_EQ(status_.state, CanState::off);
  EXPECT_EQ(status_.bus_offs, 1U);
}

TEST_F(CanErrorFrame, TransmitTimeoutsAreCounted) {
  take(error_frame(0x1));
  EXPECT_EQ(faults_.transmit_timeouts, 1U);
  EXPECT_EQ(status_.state, CanState::active);
}

// The layout of struct can_frame: id with flags in the upper three bits, length, data.
TEST(CanWire, FramesInBothFormatsKeepTheirContent) {
  CanFrame frame;
  frame.id = 0x187;
  frame.length = 2;
  frame.data[0] = std::byte{0x5a};
  frame.data[1] = std::byte{0x01};
  ::can_frame wire = to_kernel(frame);
  EXPECT_EQ(wire.can_id, 0x187U);
  EXPECT_EQ(wire.can_dlc, 2);
  EXPECT_EQ(wire.data[0], 0x5a);
  EXPECT_EQ(wire.data[1], 0x01);
  EXPECT_EQ(from_kernel(wire), frame);

  frame.extended = true;
  frame.id = 0x18da'07f1;
  wire = to_kernel(frame);
  EXPECT_EQ(wire.can_id, 0x98da'07f1U);
  EXPECT_EQ(from_kernel(wire), frame);
}

TEST(CanWire, OnlyDataFramesComeThrough) {
  ::can_frame wire{};
  wire.can_id = 0x4000'0187;
  EXPECT_FALSE(from_kernel(wire)) << "a remote frame";
  wire.can_id = 0x2000'0040;
  EXPECT_FALSE(from_kernel(wire)) << "an error frame";
  wire.can_id = 0x187;
  wire.can_dlc = 9;
  EXPECT_FALSE(from_kernel(wire)) << "no length of classic CAN";
}

// The kernel passes a frame where (id & mask) == (filter id & mask) (linux/can.h).
bool passes(const ::can_filter& filter, std::uint32_t id) {
  return (id & filter.can_mask) == (filter.can_id & filter.can_mask);
}

TEST(CanWire, AFilterPassesOneFormatAndNoRemoteFrames) {
  const ::can_filter base = to_kernel(CanFilter{0x207, CAN_SFF_MASK, false});
  EXPECT_TRUE(passes(base, 0x207));
  EXPECT_FALSE(passes(base, 0x206));
  EXPECT_FALSE(passes(base, 0x8000'0207)) << "29 bits";
  EXPECT_FALSE(passes(base, 0x4000'0207)) << "remote";

  const ::can_filter extended = to_kernel(CanFilter{0x18da'07f1, CAN_EFF_MASK, true});
  EXPECT_TRUE(passes(extended, 0x98da'07f1));
  EXPECT_FALSE(passes(extended, 0x98da'08f1));
  EXPECT_FALSE(passes(extended, 0x18da'07f1)) << "11 bits";
  EXPECT_FALSE(passes(extended, 0xd8da'07f1)) << "remote";
}

}  // namespace
}  // namespace hal::linux_os
