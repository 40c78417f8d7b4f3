/// What SocketCAN and GPIO of a real kernel do beyond the contract: interfaces that go and come,
/// lines that others hold, and errors that name what is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <string>

#include "hal/linux/device_error.hpp"
#include "hal/linux/gpiod_lines.hpp"
#include "hal/linux/socketcan.hpp"
#include "tests/hal/contract/frames.hpp"
#include "tests/kernel/kernel_rig.hpp"

namespace hal::linux_os {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "no error";
}

std::string chip() {
  return kernel_test::setting("TENDONLIFE_CHIP");
}

/// A vcan interface of the test.
class Interface {
 public:
  Interface() { add(); }
  ~Interface() { std::system("ip link delete probe0 2>/dev/null"); }
  void add() { kernel_test::run("ip link add dev probe0 type vcan && ip link set probe0 up"); }
  void remove() { kernel_test::run("ip link delete probe0"); }
  void set(const char* state) { kernel_test::run(std::string("ip link set probe0 ") + state); }
};

TEST(SocketCanOnKernel, NamesAMissingInterfaceAndThoseThatAreThere) {
  CanCalls calls;
  EXPECT_THAT(
      error_of([&] { SocketCan(calls, "can7", kernel_test::kEveryFrame); }),
      AllOf(HasSubstr("can7: no such network interface"), HasSubstr(kernel_test::near_end())));
}

TEST(SocketCanOnKernel, RefusesWhatIsNoCanInterface) {
  CanCalls calls;
  EXPECT_THAT(error_of([&] { SocketCan(calls, "lo", kernel_test::kEveryFrame); }),
              HasSubstr("lo: not a CAN interface"));
}

TEST(SocketCanOnKernel, IsOffWhileTheInterfaceIsDown) {
  Interface interface;
  CanCalls calls;
  SocketCan can(calls, "probe0", kernel_test::kEveryFrame);
  ASSERT_EQ(can.send(hal_test::frame(0x181, 1, 0)), Error::none);
  interface.set("down");
  EXPECT_EQ(can.send(hal_test::frame(0x181, 1, 0)), Error::off);
  EXPECT_EQ(can.status().state, CanState::off);
  interface.set("up");
  EXPECT_TRUE(kernel_test::eventually([&] { return can.recover() == Error::none; }));
  EXPECT_EQ(can.send(hal_test::frame(0x181, 1, 0)), Error::none);
  EXPECT_EQ(can.counts().downs, 1u);
}

TEST(SocketCanOnKernel, OpensAnInterfaceAgainThatHadVanished) {
  Interface interface;
  CanCalls calls;
  SocketCan can(calls, "probe0", kernel_test::kEveryFrame);
  interface.remove();
  EXPECT_NE(can.send(hal_test::frame(0x181, 1, 0)), Error::none);
  EXPECT_EQ(can.status().state, CanState::off);
  interface.add();
  EXPECT_TRUE(kernel_test::eventually([&] { return can.recover() == Error::none; }));
  EXPECT_EQ(can.send(hal_test::frame(0x181, 1, 0)), Error::none);
  EXPECT_EQ(can.counts().reopened, 1u);
}

TEST(SocketCanOnKernel, TellsTheStateThatErrorFramesTellOf) {
  Interface interface;
  CanCalls calls;
  SocketCan can(calls, "probe0", kernel_test::kEveryFrame);
  const auto becomes = [&](CanState state, std::uint8_t controller) {
    ::can_frame frame{};
    frame.can_id = CAN_ERR_FLAG | CAN_ERR_CRTL;
    frame.can_dlc = CAN_ERR_DLC;
    frame.data[1] = controller;
    kernel_test::write_raw("probe0", frame);
    return kernel_test::eventually([&] {
      EXPECT_EQ(can.receive(), std::nullopt);
      return can.status().state == state;
    });
  };
  EXPECT_TRUE(becomes(CanState::warning, CAN_ERR_CRTL_TX_WARNING));
  EXPECT_TRUE(becomes(CanState::passive, CAN_ERR_CRTL_RX_PASSIVE));
  EXPECT_TRUE(becomes(CanState::active, CAN_ERR_CRTL_ACTIVE));
}

TEST(SocketCanOnKernel, CountsFramesThatFoundNoRoom) {
  Interface interface;
  CanCalls calls;
  SocketCan can(calls, "probe0", kernel_test::kEveryFrame);
  kernel_test::run("cangen probe0 -g 0 -n 5000 -I 181 -L 8");
  while (can.receive()) {
  }
  kernel_test::run("cansend probe0 181#00");
  EXPECT_TRUE(kernel_test::eventually([&] { return can.receive().has_value(); }));
  EXPECT_GT(can.status().lost, 0u);
}

TEST(SocketCanOnKernel, StampsFramesAndSaysWhoDid) {
  Interface interface;
  CanCalls calls;
  SocketCan can(calls, "probe0", kernel_test::kEveryFrame);
  kernel_test::run("cansend probe0 181#00");
  ASSERT_TRUE(kernel_test::eventually([&] { return can.receive().has_value(); }));
  EXPECT_EQ(can.counts().timestamp_source, TimestampSource::software);
  EXPECT_GT(can.counts().timestamp_ns, 0);
}

TEST(GpioOnKernel, NamesAMissingChipAndThoseThatAreThere) {
  EXPECT_THAT(error_of([] { GpioOutput("gpiochip77", LineSpec{"0"}); }),
              AllOf(HasSubstr("gpiochip77: no such gpiochip"), HasSubstr(chip())));
}

TEST(GpioOnKernel, NamesAMissingLine) {
  EXPECT_THAT(error_of([] { GpioOutput(chip(), LineSpec{"no_such_line"}); }),
              HasSubstr("no line 'no_such_line'"));
  EXPECT_THAT(error_of([] { GpioOutput(chip(), LineSpec{"64"}); }), HasSubstr("no line '64'"));
}

TEST(GpioOnKernel, SaysWhoHoldsALine) {
  const GpioOutput holder(chip(), LineSpec{"drive"});
  EXPECT_THAT(error_of([] { GpioOutput(chip(), LineSpec{"drive"}); }),
              HasSubstr("line 'drive' is in use by 'tendonlife'"));
}

TEST(GpioOnKernel, FindsALineByItsNameOrOffset) {
  const kernel_test::WorldLine world(1);
  for (const char* const line : {"drive", "1"}) {
    GpioOutput output(chip(), LineSpec{line});
    EXPECT_EQ(output.set(true), Error::none);
    EXPECT_TRUE(world.value()) << line;
  }
}

TEST(GpioOnKernel, AnOutputFallsWhenItIsReleased) {
  const kernel_test::WorldLine world(1);
  world.pull(false);
  {
    GpioOutput output(chip(), LineSpec{"drive"});
    ASSERT_EQ(output.set(true), Error::none);
    EXPECT_TRUE(world.value());
  }
  EXPECT_FALSE(world.value());
}

TEST(GpioOnKernel, SeesAPullThatIsOverBeforeItLooks) {
  const kernel_test::WorldLine world(0);
  world.pull(false);
  GpioEmergencyStop stop(chip(), LineSpec{"stop"}, 2ms);
  ASSERT_TRUE(stop.asserted());
  world.pull(true);
  kernel_test::wait(100ms);
  world.pull(false);
  kernel_test::wait(100ms);
  EXPECT_TRUE(*stop.asserted());
  EXPECT_FALSE(*stop.asserted());
}

TEST(GpioOnKernel, AfterLostEdgesTheLevelCounts) {
  const kernel_test::WorldLine world(0);
  world.pull(false);
  GpioEmergencyStop stop(chip(), LineSpec{"stop"}, 0us);
  ASSERT_FALSE(*stop.asserted());
  // The kernel keeps 16 edges a line.
  for (int i = 0; i < 100; ++i) {
    world.pull(i % 2 == 0);
    kernel_test::wait(2ms);
  }
  world.pull(true);
  kernel_test::wait(50ms);
  EXPECT_TRUE(*stop.asserted());
  EXPECT_GT(stop.follower().lost_edges(), 0u);
  EXPECT_TRUE(*stop.asserted());
  world.pull(false);
  kernel_test::wait(50ms);
  EXPECT_FALSE(*stop.asserted());
}

}  // namespace
}  // namespace hal::linux_os
