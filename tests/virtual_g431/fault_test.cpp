#include <gmock/gmock.h>

#include "tests/virtual_g431/image.hpp"

namespace virtual_g431 {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// What goes wrong with the board: where the drive is then, and how the board comes back.
class Fault : public Image {
 protected:
  void start(Board& board) {
    board.power_on();
    ASSERT_TRUE(board.run_until([&] { return board.drive_enabled(); }, kSecond));
    board.run(100 * kMillisecond);
    ASSERT_THAT(board.edges, SizeIs(2));
  }
  /// When the drive went off after `since`.
  static Ticks drive_off(const Board& board, Ticks since) {
    for (const Board::Edge& edge : board.edges) {
      if (edge.at >= since && edge.drive && !edge.high) {
        return edge.at - since;
      }
    }
    return kNever;
  }
  static Ticks brake_on(const Board& board, Ticks since) {
    for (const Board::Edge& edge : board.edges) {
      if (edge.at >= since && !edge.drive && !edge.high) {
        return edge.at - since;
      }
    }
    return kNever;
  }
};

/// The clock security system: safe at once, and again from the internal oscillator.
TEST_F(Fault, CrystalFailsLater) {
  Board board(contents);
  start(board);
  const Ticks failed_at = board.agenda.now();
  board.clocks.fail_crystal();
  board.run(kSecond);
  EXPECT_LT(drive_off(board, failed_at), 20 * kMicrosecond);
  EXPECT_LT(brake_on(board, failed_at), 20 * kMicrosecond);
  ASSERT_THAT(board.resets, SizeIs(1));
  EXPECT_EQ(board.resets[0].cause, ResetCause::software);
  EXPECT_TRUE(board.drive_enabled());
  EXPECT_EQ(board.clocks.hclk(), 8u);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(Fault, TriggerIsDeadFromTheStart) {
  Board board(contents);
  board.tim1.dead = true;
  board.power_on();
  board.run(kSecond);
  EXPECT_THAT(board.edges, IsEmpty());
  EXPECT_GT(board.resets.size(), 1u);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// Nothing looks at the stop any more: the watchdog takes the drive away, and it stays away.
TEST_F(Fault, TriggerDiesLater) {
  Board board(contents);
  start(board);
  const Ticks died_at = board.agenda.now();
  board.tim1.dead = true;
  board.run(2 * kSecond);
  // Dead for 100 ms, then not fed for 250 ms.
  EXPECT_LT(drive_off(board, died_at), 360 * kMillisecond);
  ASSERT_GT(board.resets.size(), 1u);
  EXPECT_EQ(board.resets[0].cause, ResetCause::watchdog);
  EXPECT_THAT(board.edges, SizeIs(4)) << "the drive came back";
  EXPECT_FALSE(board.drive_enabled());
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(Fault, ConvertersNeverGetReady) {
  Board board(contents);
  board.converters.broken = true;
  board.power_on();
  board.run(kSecond);
  EXPECT_THAT(board.edges, IsEmpty());
  EXPECT_GT(board.resets.size(), 1u);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(Fault, AnAmplifierIsBroken) {
  Board board(contents);
  board.converters.signal = [](Ticks) { return PhaseCounts{2048, 4095, 2048}; };
  board.power_on();
  board.run(kSecond);
  EXPECT_TRUE(reported(board, protocol::EmergencyCode::sensor));
  ASSERT_FALSE(sent<protocol::LifeStatus>(board).empty());
  EXPECT_FALSE(sent<protocol::LifeStatus>(board).back().sensor_ok);
  EXPECT_THAT(board.resets, IsEmpty());
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// The contact opens: drive off within 2.1 ms and two periods, until a restart with it closed.
TEST_F(Fault, EmergencyStop) {
  Board board(contents);
  start(board);
  const Ticks opened_at = board.agenda.now();
  board.open_stop(true);
  board.run(300 * kMillisecond);
  EXPECT_GE(drive_off(board, opened_at), 1900 * kMicrosecond);
  EXPECT_LT(drive_off(board, opened_at), 2200 * kMicrosecond);
  EXPECT_LT(drive_off(board, opened_at), brake_on(board, opened_at));
  EXPECT_LT(brake_on(board, opened_at), 2200 * kMicrosecond);
  EXPECT_TRUE(reported(board, protocol::EmergencyCode::emergency_stop));
  EXPECT_TRUE(sent<protocol::LifeStatus>(board).back().locked);

  board.open_stop(false);
  board.run(kSecond);
  EXPECT_FALSE(board.drive_enabled());
  EXPECT_FALSE(board.brake_released());
  EXPECT_THAT(board.resets, IsEmpty());
  board.power_off();
  board.power_on();
  EXPECT_TRUE(board.run_until([&] { return board.drive_enabled(); }, kSecond));
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(Fault, AContactThatBouncesIsNoStop) {
  Board board(contents);
  start(board);
  for (int i = 0; i < 20; ++i) {
    board.open_stop(true);
    board.run(1500 * kMicrosecond);
    board.open_stop(false);
    board.run(500 * kMicrosecond);
  }
  EXPECT_TRUE(board.drive_enabled());
  EXPECT_THAT(board.edges, SizeIs(2));
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(Fault, StopIsOpenAtTheStart) {
  Board board(contents);
  board.open_stop(true);
  board.power_on();
  board.run(kSecond);
  EXPECT_THAT(board.edges, IsEmpty());
  EXPECT_TRUE(reported(board, protocol::EmergencyCode::emergency_stop));
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// The frame of an exception comes into the lowest 32 bytes of the stack.
TEST_F(Fault, StackRunsOver) {
  Board board(contents);
  start(board);
  const auto [guard, size] = board.core->guarded();
  ASSERT_EQ(guard, 0x20000000u);
  ASSERT_EQ(size, 32u);
  board.core->enforce_guard();
  board.run(10 * kMillisecond);
  ASSERT_EQ(board.core->faults(), 0u) << "the stack is as deep as it was measured";
  ASSERT_TRUE(board.run_until([&] { return board.core->in_thread() && board.core->asleep(); },
                              kMillisecond, kMicrosecond));
  board.core->set_stack_pointer(guard + size + 8);
  const Ticks ran_over_at = board.agenda.now();
  board.run(kSecond);
  EXPECT_LT(drive_off(board, ran_over_at), 120 * kMicrosecond);
  EXPECT_LT(brake_on(board, ran_over_at), 120 * kMicrosecond);
  EXPECT_EQ(board.core->faults(), 1u);
  ASSERT_THAT(board.resets, SizeIs(1));
  EXPECT_EQ(board.resets[0].cause, ResetCause::software);
  EXPECT_TRUE(board.drive_enabled());
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// The control loop goes on, but nobody looks after bus, store and watchdog.
TEST_F(Fault, IdleLoopStandsStill) {
  Board board(contents);
  start(board);
  ASSERT_TRUE(board.run_until([&] { return board.core->in_thread(); }, kMillisecond, kMicrosecond));
  board.core->hang_at(0x10000000);
  const Ticks hung_at = board.agenda.now();
  board.run(kSecond);
  EXPECT_LT(drive_off(board, hung_at), 255 * kMillisecond);
  EXPECT_GT(drive_off(board, hung_at), 240 * kMillisecond);
  ASSERT_THAT(board.resets, SizeIs(1));
  EXPECT_EQ(board.resets[0].cause, ResetCause::watchdog);
  EXPECT_TRUE(board.drive_enabled());
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(Fault, CodeIsDamaged) {
  Board board(contents);
  start(board);
  const Ticks met_at = board.agenda.now();
  board.flash.meet_damage(0x1000);
  board.run(kSecond);
  EXPECT_LT(drive_off(board, met_at), 20 * kMicrosecond);
  EXPECT_LT(brake_on(board, met_at), 20 * kMicrosecond);
  ASSERT_THAT(board.resets, SizeIs(1));
  EXPECT_EQ(board.resets[0].cause, ResetCause::software);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

/// The brake does not open: the drive stays off, and the watchdog starts it over and over.
TEST_F(Fault, BrakeLineIsShorted) {
  Board board(contents);
  board.port_a.shorten(15, false);
  board.power_on();
  board.run(2 * kSecond);
  EXPECT_THAT(board.edges, IsEmpty());
  ASSERT_GT(board.resets.size(), 1u);
  EXPECT_EQ(board.resets[0].cause, ResetCause::watchdog);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

TEST_F(Fault, NoiseIsBroken) {
  Board board(contents);
  board.noise.broken = true;
  board.power_on();
  board.run(kSecond);
  EXPECT_THAT(board.resets, IsEmpty());
  EXPECT_TRUE(board.drive_enabled());
  EXPECT_GE(sent<protocol::LifeStatus>(board).size(), 9u);
  EXPECT_THAT(board.broken_rules(), IsEmpty());
}

}  // namespace
}  // namespace virtual_g431
