#include "firmware/app/bus.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <type_traits>
#include <vector>

#include "hal/error.hpp"
#include "rig.hpp"

namespace app {
namespace {

hal::CanFrame frame_of(std::uint8_t length, bool extended) {
  hal::CanFrame frame;
  frame.length = length;
  frame.extended = extended;
  return frame;
}

// Davis et al., Controller Area Network schedulability analysis, 2007: 55 + 10 n bits for 11-bit
// identifiers and 80 + 10 n for 29-bit ones.
TEST(BusBudget, AFrameTakesAsManyBitsAsPublished) {
  for (std::uint8_t n = 0; n <= 8; ++n) {
    EXPECT_EQ(worst_bits(frame_of(n, false)), 55u + 10u * n) << +n;
    EXPECT_EQ(worst_bits(frame_of(n, true)), 80u + 10u * n) << +n;
  }
}

TEST(BusBudget, TheRegularPlanFits) {
  // Ten status, ten detail frames and a heartbeat a second.
  EXPECT_LE(20 * worst_bits(frame_of(8, false)) + worst_bits(frame_of(1, false)),
            BusBudget::kBitsPerSecond);
}

TEST(BusBudget, AnUrgentFrameFindsRoomWhereOthersDoNot) {
  BusBudget budget;
  budget.start({});
  while (budget.allows(135)) {
    budget.spend(135);
  }
  EXPECT_TRUE(budget.allows_urgent(135));
  budget.spend(135);
  EXPECT_FALSE(budget.allows_urgent(135));
}

TEST(BusBudget, InEverySpanOfTimeTheLoadIsBounded) {
  std::mt19937 random(11);
  BusBudget budget;
  hal::Time now = hal::seconds(5);
  budget.start(now);
  struct Sent {
    std::uint64_t at_us;
    std::uint64_t bits;
  };
  std::vector<Sent> sent;
  for (int step = 0; step < 3000; ++step) {
    // Pauses at first, then a node that always has something to say.
    const bool eager = step > 1'000;
    now = now +
          hal::microseconds(!eager && random() % 5 == 0 ? random() % 2'000'000 : random() % 40'000);
    budget.advance(now);
    const auto bits = static_cast<std::uint32_t>(55 + 10 * (random() % 9));
    if (eager || random() % 2 == 0 ? budget.allows_urgent(bits) : budget.allows(bits)) {
      budget.spend(bits);
      sent.push_back({now.us, bits});
    }
  }
  ASSERT_GT(sent.size(), 500u);
  for (std::size_t first = 0; first < sent.size(); ++first) {
    std::uint64_t bits = 0;
    for (std::size_t last = first; last < sent.size(); ++last) {
      bits += sent[last].bits;
      const std::uint64_t span_us = sent[last].at_us - sent[first].at_us;
      ASSERT_LE(bits * 1'000'000,
                BusBudget::kBurstBits * 1'000'000ull + BusBudget::kBitsPerSecond * span_us);
    }
  }
}

/// A controller that is off from go_off() until `stubborn` recoveries have been asked for.
class Controller {
 public:
  explicit Controller(const hal::Time& now) : now_(now) {}
  hal::Error send(const hal::CanFrame&) { return off ? hal::Error::off : hal::Error::none; }
  std::optional<hal::CanFrame> receive() { return std::nullopt; }
  hal::CanStatus status() {
    hal::CanStatus status;
    status.state = off ? hal::CanState::off : hal::CanState::active;
    return status;
  }
  hal::Error recover() {
    asked_ms.push_back(now_.us / 1000);
    off = asked_ms.size() < stubborn;
    return hal::Error::none;
  }

  bool off = false;
  std::size_t stubborn = 1;
  std::vector<std::uint64_t> asked_ms;

 private:
  const hal::Time& now_;
};

TEST(BusWatch, AsksAgainWithPausesThatDouble) {
  hal::Time now{};
  Controller controller(now);
  BusWatch watch(controller);
  using Turn = BusWatch<Controller>::Turn;
  controller.off = true;
  controller.stubborn = 10;
  EXPECT_EQ(watch.look(now), Turn::went_off);
  Turn last = Turn::none;
  for (std::uint32_t ms = 1; ms < 60'000 && last != Turn::came_back; ++ms) {
    now = hal::milliseconds(ms);
    last = watch.look(now);
  }
  EXPECT_EQ(last, Turn::came_back);
  EXPECT_EQ(controller.asked_ms, (std::vector<std::uint64_t>{100, 300, 700, 1'500, 3'100, 6'300,
                                                             12'700, 22'700, 32'700, 42'700}));
}

TEST(BusWatch, ABusThatGoesOffAgainSoonWaitsLonger) {
  hal::Time now{};
  Controller controller(now);
  BusWatch watch(controller);
  const auto run_to = [&](std::uint32_t ms) {
    while (now < hal::milliseconds(ms)) {
      now = now + hal::milliseconds(1);
      (void)watch.look(now);
    }
  };
  controller.off = true;
  run_to(500);  // off at 1, asked at 101
  controller.off = true;
  controller.stubborn = 2;
  run_to(2'000);  // off at 501, asked 400 ms later
  controller.off = true;
  controller.stubborn = 3;
  now = hal::seconds(60);
  run_to(61'000);  // long after: 100 ms
  EXPECT_EQ(controller.asked_ms, (std::vector<std::uint64_t>{101, 901, 60'101}));
}

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
  // Nine tenths of its share of 600 pages.
  EXPECT_GE(rig.sent<protocol::detail::Bus>().size(), 540u / protocol::detail::kPages);
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
  EXPECT_GE(rig.sent<protocol::detail::Identity>().size(), 100u / protocol::detail::kPages);
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
  EXPECT_EQ(rig.app->node_state().refused, 0);

  // Replayed, damaged, unknown, short, of a page that there is not: one each.
  hal::CanFrame damaged = commander.frame(CommandCode::select_page, 3);
  damaged.data[2] ^= std::byte{0x10};
  hal::CanFrame brief = good;
  brief.length = 3;
  for (const hal::CanFrame& bad :
       {good, damaged, commander.frame(static_cast<CommandCode>(9), 0), brief,
        commander.frame(CommandCode::select_page, protocol::detail::kPages)}) {
    ASSERT_EQ(rig.tester.send(bad), hal::Error::none);
    rig.idle(10);
  }
  EXPECT_EQ(rig.app->node_state().refused, 5);

  // Of another node: none of our business.
  ASSERT_EQ(rig.tester.send(Commander(kNode + 1).frame(CommandCode::identify, 1)),
            hal::Error::none);
  rig.idle(10);
  EXPECT_EQ(rig.app->node_state().refused, 5);
}

TEST(Bus, APageThatThereIsNotIsNeverAnswered) {
  const LifeBook<1> book;
  const std::array<RainflowBins, 1> bins{};
  const NodeState state;
  Reporter<1> reporter(book, bins, state);
  for (int page = 0; page < 256; ++page) {
    int sent = -1;
    const bool left = reporter.with_page(static_cast<std::uint8_t>(page), [&](const auto& message) {
      sent = std::decay_t<decltype(message)>::kPage;
      return true;
    });
    EXPECT_EQ(left, page < protocol::detail::kPages) << page;
    EXPECT_EQ(sent, page < protocol::detail::kPages ? page : -1);
  }
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
