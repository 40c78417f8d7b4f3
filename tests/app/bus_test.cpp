#include <gtest/gtest.h>

#include "rig.hpp"

namespace app {
namespace {

using protocol::Command;
using protocol::CommandCode;
using protocol::LifeStatus;
using protocol::e2e::Status;

/// What a receiver makes of the frames of one kind.
template <class Message, class AnyRig>
protocol::e2e::Counts received(const AnyRig& rig) {
  protocol::e2e::Checker checker(protocol::e2e::stream_of<Message>(kNode));
  for (const hal::fake::CanEvent& event : rig.bus.sent()) {
    (void)checker.check(event.frame);
  }
  return checker.counts();
}

TEST(Bus, EveryProtectedFrameFollowsTheOneBefore) {
  Rig rig;
  rig.can.faults.at_random(300'000, hal::fake::SendFault::full);
  rig.start();
  rig.idle(300);
  rig.stop.set(true);
  rig.run(5'000);
  for (const auto& counts : {received<LifeStatus>(rig), received<protocol::detail::Bus>(rig),
                             received<protocol::Emergency>(rig)}) {
    EXPECT_GT(counts.good, 0u);
    EXPECT_EQ(counts.lost + counts.repeated + counts.wrong_sequence + counts.damaged, 0u);
  }
}

/// A tester that sends commands.
class Commander {
 public:
  explicit Commander(protocol::Node node = kNode)
      : node_(node), protector_(protocol::e2e::stream_of<Command>(node)) {}

  hal::CanFrame frame(CommandCode code, std::uint8_t argument) {
    hal::CanFrame frame = protocol::encode(node_, Command{code, argument});
    protector_.protect(frame);
    return frame;
  }

 private:
  protocol::Node node_;
  protocol::e2e::Protector protector_;
};

TEST(Bus, ACommandSelectsTheNextPage) {
  Rig rig;
  Commander commander;
  rig.start();
  rig.idle(1'050);
  ASSERT_EQ(rig.tester.send(commander.frame(CommandCode::select_page, 7)), hal::Error::none);
  rig.bus.forget();
  rig.idle(100);
  EXPECT_EQ(rig.sent<protocol::detail::Timing>().size(), 1u);
}

TEST(Bus, APageThatWasAskedForIsNotLeftOut) {
  Rig rig;
  Commander commander;
  rig.start();
  rig.idle(1'050);
  ASSERT_EQ(rig.tester.send(commander.frame(CommandCode::select_page, 7)), hal::Error::none);
  rig.can.faults.during(rig.clock.now(), rig.clock.now() + hal::milliseconds(450),
                        hal::fake::SendFault::full);
  rig.bus.forget();
  rig.idle(460);
  EXPECT_EQ(rig.sent<protocol::detail::Timing>().size(), 1u);
}

TEST(Bus, ADamageThatGrowsForAMinuteLeavesRoomForOtherPages) {
  // About 3e-6 of a life a second: unsaved for up to a minute once the credit of saves is used.
  Rig rig(1.53e9);
  rig.start();
  rig.run(60'000);
  EXPECT_GE(rig.sent<protocol::detail::Bus>().size(), 60u);
  EXPECT_LE(rig.sent<protocol::detail::Storage>().size(), 60u + 40u);
}

TEST(Bus, ABurstIsFasterThanTheCycleAndStaysWithinTheBudget) {
  Rig rig;
  Commander commander;
  rig.start();
  rig.idle(3'000);
  rig.bus.forget();
  ASSERT_EQ(rig.tester.send(commander.frame(CommandCode::burst, 255)), hal::Error::none);
  rig.idle(10'000);
  std::uint64_t bits = 0;
  for (const hal::fake::CanEvent& event : rig.bus.sent()) {
    bits += event.sender == 0 ? worst_bits(event.frame) : 0;
  }
  EXPECT_LE(bits, BusBudget::kBurstBits + 10 * BusBudget::kBitsPerSecond);
  EXPECT_GE(rig.sent<protocol::detail::Identity>().size(), 11u);
}

TEST(Bus, ACommandMakesTheLightBlink) {
  Rig rig;
  Commander commander;
  rig.start();
  rig.idle(1'000);
  const std::uint32_t before = rig.light.changes();
  ASSERT_EQ(rig.tester.send(commander.frame(CommandCode::identify, 2)), hal::Error::none);
  rig.idle(2'000);
  EXPECT_NEAR(static_cast<double>(rig.light.changes() - before), 40, 2);
}

TEST(Bus, WhatIsNotACommandIsRefusedAndCounted) {
  Rig rig;
  Commander commander;
  rig.start();
  rig.idle(100);
  const hal::CanFrame good = commander.frame(CommandCode::select_page, 3);
  ASSERT_EQ(rig.tester.send(good), hal::Error::none);
  rig.idle(10);
  EXPECT_EQ(rig.app->conditions().refused, 0);

  // Replayed, damaged, unknown, short: one each.
  hal::CanFrame damaged = commander.frame(CommandCode::select_page, 3);
  damaged.data[2] ^= std::byte{0x10};
  hal::CanFrame brief = good;
  brief.length = 3;
  for (const hal::CanFrame& bad :
       {good, damaged, commander.frame(static_cast<CommandCode>(9), 0), brief}) {
    ASSERT_EQ(rig.tester.send(bad), hal::Error::none);
    rig.idle(10);
  }
  EXPECT_EQ(rig.app->conditions().refused, 4);

  // Of another node: none of our business.
  ASSERT_EQ(rig.tester.send(Commander(kNode + 1).frame(CommandCode::identify, 1)),
            hal::Error::none);
  rig.idle(10);
  EXPECT_EQ(rig.app->conditions().refused, 4);
}

TEST(Bus, ABabblingNeighbourIsSurvived) {
  Rig rig;
  rig.start();
  for (int i = 0; i < 2'000; ++i) {
    for (int k = 0; k < 40; ++k) {
      hal::CanFrame noise;
      noise.id = static_cast<std::uint32_t>(k * 50);
      noise.length = 8;
      ASSERT_EQ(rig.tester.send(noise), hal::Error::none);
    }
    rig.step(10);
  }
  EXPECT_NEAR(static_cast<double>(rig.sent<LifeStatus>().size()), 20, 1);
  EXPECT_FALSE(rig.watchdog.bitten());
  EXPECT_GT(rig.can.status().lost, 0u);
}

}  // namespace
}  // namespace app
