#include "hal/linux/socketcan.hpp"

#include <gtest/gtest.h>

#include "tests/linux/scripted_can.hpp"

namespace hal::linux_os {
namespace {

using test::received;
using test::ScriptedCan;

constexpr std::uint32_t kBusOff = 0x2000'0040;
constexpr std::uint32_t kRestarted = 0x2000'0100;

class SocketCanPort : public testing::Test {
 protected:
  using Port = BasicSocketCan<ScriptedCan>;

  static CanFrame frame(std::uint32_t id) {
    CanFrame frame;
    frame.id = id;
    frame.length = 8;
    return frame;
  }
  void go_off() {
    calls_.waiting.push_back(received(kBusOff));
    EXPECT_FALSE(port_.receive());
  }

  ScriptedCan calls_;
  std::array<CanFilter, 1> filters_{CanFilter{0x207, CAN_SFF_MASK, false}};
  Port port_{calls_, "can0", filters_};
};

TEST_F(SocketCanPort, AMissingInterfaceIsAnErrorOfTheConstructor) {
  calls_.open_error = ENODEV;
  EXPECT_THROW(Port(calls_, "can9", filters_), DeviceError);
}

TEST_F(SocketCanPort, TheFilterReachesTheKernel) {
  ASSERT_EQ(calls_.filters.size(), 1U);
  EXPECT_EQ(calls_.filters[0].id, 0x207U);
}

TEST_F(SocketCanPort, FramesLeaveInTheirOrder) {
  EXPECT_EQ(port_.send(frame(0x187)), Error::none);
  EXPECT_EQ(port_.send(frame(0x287)), Error::none);
  ASSERT_EQ(calls_.sent.size(), 2U);
  EXPECT_EQ(calls_.sent[0].can_id, 0x187U);
  EXPECT_EQ(calls_.sent[1].can_id, 0x287U);
  EXPECT_EQ(port_.counts().sent, 2U);
}

TEST_F(SocketCanPort, AFullQueueIsFullAndCounted) {
  for (const int error : {ENOBUFS, EAGAIN}) {
    calls_.send_error = error;
    EXPECT_EQ(port_.send(frame(0x187)), Error::full);
  }
  EXPECT_EQ(port_.counts().queue_full, 2U);
  EXPECT_EQ(port_.counts().refused, 0U);
  EXPECT_EQ(port_.status().state, CanState::active);
}

TEST_F(SocketCanPort, AnInterfaceThatIsSetDownIsOffAndComesBack) {
  calls_.send_error = ENETDOWN;
  calls_.up = false;
  EXPECT_EQ(port_.send(frame(0x187)), Error::off);
  EXPECT_EQ(port_.send(frame(0x187)), Error::off);
  EXPECT_EQ(port_.status().state, CanState::off);
  EXPECT_EQ(port_.status().bus_offs, 0U) << "the controller was not off the bus";
  EXPECT_EQ(port_.counts().downs, 1U);
  EXPECT_EQ(port_.recover(), Error::off);

  calls_.send_error = 0;
  calls_.up = true;
  EXPECT_EQ(port_.recover(), Error::none);
  EXPECT_EQ(port_.status().state, CanState::active);
  EXPECT_EQ(port_.send(frame(0x187)), Error::none);
  EXPECT_EQ(calls_.restarts, 0) << "there was nothing to restart";
}

TEST_F(SocketCanPort, AnInterfaceThatIsDownAtTheStartIsOff) {
  calls_.up = false;
  Port port(calls_, "can0", filters_);
  EXPECT_EQ(port.status().state, CanState::off);
  calls_.up = true;
  EXPECT_EQ(port.recover(), Error::none);
  EXPECT_EQ(port.status().state, CanState::active);
}

TEST_F(SocketCanPort, AnInterfaceThatVanishesIsOpenedAgainByItsName) {
  calls_.receive_error = ENODEV;
  calls_.reopen_error = ENODEV;
  EXPECT_FALSE(port_.receive());
  EXPECT_TRUE(calls_.closed);
  EXPECT_EQ(port_.status().state, CanState::off);
  EXPECT_EQ(port_.send(frame(0x187)), Error::off);
  EXPECT_TRUE(calls_.sent.empty());
  EXPECT_EQ(port_.recover(), Error::off);

  calls_.reopen_error = 0;
  EXPECT_EQ(port_.recover(), Error::none);
  EXPECT_EQ(calls_.reopens, 2);
  EXPECT_EQ(port_.counts().reopened, 1U);
  EXPECT_EQ(port_.status().state, CanState::active);
  EXPECT_EQ(port_.send(frame(0x187)), Error::none);
}

TEST_F(SocketCanPort, SendingAlsoNoticesThatTheInterfaceIsGone) {
  calls_.send_error = ENXIO;
  EXPECT_EQ(port_.send(frame(0x187)), Error::off);
  EXPECT_TRUE(calls_.closed);
  EXPECT_EQ(port_.counts().refused, 1U);
}

TEST_F(SocketCanPort, AnotherErrorIsAFaultAndCounted) {
  calls_.send_error = EIO;
  EXPECT_EQ(port_.send(frame(0x187)), Error::failed);
  EXPECT_EQ(port_.counts().refused, 1U);
}

TEST_F(SocketCanPort, ErrorFramesAreTakenInAndNotReceived) {
  calls_.waiting = {received(0x2000'0004), received(0x207, 0x11), received(kBusOff),
                    received(0x207, 0x22)};
  calls_.waiting[0].frame.data[1] = 0x20;
  const auto first = port_.receive();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->data[0], std::byte{0x11});
  EXPECT_EQ(port_.status().state, CanState::passive);
  const auto second = port_.receive();
  ASSERT_TRUE(second);
  EXPECT_EQ(second->data[0], std::byte{0x22});
  EXPECT_EQ(port_.status().state, CanState::off);
  EXPECT_FALSE(port_.receive());
}

TEST_F(SocketCanPort, AFloodOfErrorFramesEndsTheCall) {
  for (int i = 0; i < 1'000; ++i) {
    calls_.waiting.push_back(received(0x2000'0001));
  }
  EXPECT_FALSE(port_.receive());
  EXPECT_EQ(calls_.waiting.size(), 968U);
}

TEST_F(SocketCanPort, NothingIsSentWhileTheControllerIsOff) {
  go_off();
  EXPECT_EQ(port_.send(frame(0x187)), Error::off);
  EXPECT_TRUE(calls_.sent.empty());
  EXPECT_EQ(port_.status().bus_offs, 1U);
}

TEST_F(SocketCanPort, ARestartIsAskedForAndOverWhenTheErrorFrameSaysSo) {
  go_off();
  EXPECT_EQ(port_.recover(), Error::none);
  EXPECT_EQ(calls_.restarts, 1);
  EXPECT_EQ(port_.status().state, CanState::off);
  calls_.waiting.push_back(received(kRestarted));
  EXPECT_FALSE(port_.receive());
  EXPECT_EQ(port_.status().state, CanState::active);
  EXPECT_EQ(port_.counts().faults.restarts, 1U);
  EXPECT_EQ(port_.recover(), Error::none);
  EXPECT_EQ(calls_.restarts, 1);
}

TEST_F(SocketCanPort, WhereTheKernelRestartsOrRefusesItIsStillOff) {
  go_off();
  for (const CanRestart answer : {CanRestart::by_kernel, CanRestart::refused}) {
    calls_.restart_answer = answer;
    EXPECT_EQ(port_.recover(), Error::off);
    EXPECT_EQ(port_.status().state, CanState::off);
  }
}

TEST_F(SocketCanPort, AnInterfaceWithoutControllerGoesOnAtOnce) {
  for (const CanRestart answer : {CanRestart::no_controller, CanRestart::not_off}) {
    go_off();
    calls_.restart_answer = answer;
    EXPECT_EQ(port_.recover(), Error::none);
    EXPECT_EQ(port_.status().state, CanState::active);
  }
  EXPECT_EQ(port_.status().bus_offs, 2U);
}

TEST_F(SocketCanPort, LostFramesAreCountedOverAReopening) {
  calls_.waiting = {received(0x207)};
  calls_.waiting[0].dropped = 5;
  ASSERT_TRUE(port_.receive());
  EXPECT_EQ(port_.status().lost, 5U);

  calls_.receive_error = ENODEV;
  EXPECT_FALSE(port_.receive());
  calls_.receive_error = EAGAIN;
  ASSERT_EQ(port_.recover(), Error::none);
  calls_.waiting = {received(0x207), received(0x207)};
  calls_.waiting[1].dropped = 2;
  ASSERT_TRUE(port_.receive());
  EXPECT_EQ(port_.status().lost, 5U);
  ASSERT_TRUE(port_.receive());
  EXPECT_EQ(port_.status().lost, 7U);
}

TEST_F(SocketCanPort, TheSourceOfATimestampIsKept) {
  calls_.waiting = {received(0x207)};
  calls_.waiting[0].source = TimestampSource::hardware;
  calls_.waiting[0].time_ns = 1'234;
  ASSERT_TRUE(port_.receive());
  EXPECT_EQ(port_.counts().timestamp_source, TimestampSource::hardware);
  EXPECT_EQ(port_.counts().timestamp_ns, 1'234);
}

std::string complaint_about_interface(const std::string& interface) {
  CanCalls calls;
  try {
    BasicSocketCan<CanCalls> port(calls, interface, {});
  } catch (const DeviceError& error) {
    return error.what();
  }
  return {};
}

TEST(SocketCanOfThisMachine, AMissingInterfaceIsNamed) {
  const std::string complaint = complaint_about_interface("tl-missing");
  EXPECT_EQ(complaint,
            "tl-missing: no such network interface; accepted: a CAN interface; there "
            "are: " +
                can_interfaces());
}

TEST(SocketCanOfThisMachine, AnInterfaceOfAnotherKindIsRefused) {
  EXPECT_EQ(complaint_about_interface("lo"),
            "lo: not a CAN interface; accepted: a CAN interface; there are: " + can_interfaces());
}

TEST(SocketCanOfThisMachine, ANameThatIsTooLongIsMissing) {
  EXPECT_NE(
      complaint_about_interface("a-name-of-many-characters").find("no such network interface"),
      std::string::npos);
}

}  // namespace
}  // namespace hal::linux_os
