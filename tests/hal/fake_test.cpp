#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <vector>

#include "hal/fake/can_port.hpp"
#include "hal/fake/devices.hpp"
#include "tests/hal/contract/frames.hpp"

namespace hal::fake {
namespace {

using hal_test::frame;

TEST(FakeClock, NeverRunsBack) {
  Clock clock;
  clock.advance_to(milliseconds(7));
  clock.advance_to(milliseconds(3));
  EXPECT_EQ(clock.now(), milliseconds(7));
}

TEST(Random, IsThePublishedSequence) {
  // The first outputs for the seed 1234567, as published with the algorithm's C source.
  Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
  EXPECT_EQ(random.next(), 9817491932198370423u);
}

TEST(Faults, WithoutRulesAllIsWell) {
  Faults<Error> faults;
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(faults.next(seconds(1)), std::nullopt);
  }
  EXPECT_EQ(faults.calls(), 10u);
  EXPECT_EQ(faults.faults(), 0u);
}

TEST(Faults, ARangeOfTimeIsHalfOpen) {
  Faults<Error> faults;
  faults.during(milliseconds(10), milliseconds(20), Error::failed);
  EXPECT_EQ(faults.next(microseconds(9'999)), std::nullopt);
  EXPECT_EQ(faults.next(milliseconds(10)), Error::failed);
  EXPECT_EQ(faults.next(microseconds(19'999)), Error::failed);
  EXPECT_EQ(faults.next(milliseconds(20)), std::nullopt);
}

TEST(Faults, CallsAreCountedFromZero) {
  Faults<Error> faults;
  faults.on_calls(2, 3, Error::missing);
  std::vector<int> hit;
  for (int call = 0; call < 8; ++call) {
    if (faults.next({}) == Error::missing) {
      hit.push_back(call);
    }
  }
  EXPECT_EQ(hit, (std::vector{2, 3, 4}));
}

TEST(Faults, TheFirstRuleThatAppliesDecides) {
  Faults<Error> faults;
  faults.on_calls(1, 1, Error::missing).during({}, seconds(1), Error::failed);
  EXPECT_EQ(faults.next({}), Error::failed);
  EXPECT_EQ(faults.next({}), Error::missing);
  EXPECT_EQ(faults.next({}), Error::failed);
  faults.clear();
  EXPECT_EQ(faults.next({}), std::nullopt);
}

TEST(Faults, ChanceIsAsRareAsAskedForAndRepeatable) {
  const auto hits = [](std::uint64_t seed) {
    Faults<Error> faults(seed);
    faults.at_random(100'000, Error::failed);
    std::vector<bool> result;
    for (int i = 0; i < 100'000; ++i) {
      result.push_back(faults.next({}).has_value());
    }
    // 10,000 expected, standard deviation 95.
    EXPECT_NEAR(static_cast<double>(faults.faults()), 10'000, 600);
    return result;
  };
  EXPECT_EQ(hits(7), hits(7));
  EXPECT_NE(hits(7), hits(8));
}

TEST(FakeSensor, PlaysItsScriptOneSampleACall) {
  using lifemodel::MotorCurrent;
  Clock clock;
  Sensor<MotorCurrent> sensor(clock);
  const std::array script{MotorCurrent::from_raw(1), MotorCurrent::from_raw(2),
                          MotorCurrent::from_raw(3)};
  sensor.play(0, script);
  sensor.faults.on_calls(1, 1, Error::failed);
  EXPECT_EQ((*sensor.isr_read(0)).raw(), 1);
  EXPECT_EQ(sensor.isr_read(0).error(), Error::failed);
  EXPECT_EQ((*sensor.isr_read(0)).raw(), 3) << "the sample of the fault is gone";
  EXPECT_EQ(sensor.isr_read(0).error(), Error::missing);
  EXPECT_EQ(sensor.isr_read(1).error(), Error::out_of_range);
}

TEST(FakeDigital, EdgesComeAtTheirTime) {
  Clock clock;
  DigitalIn line(clock);
  line.edge_at(milliseconds(5), true);
  line.edge_at(milliseconds(6), false);
  EXPECT_FALSE(*line.asserted());
  clock.advance_to(milliseconds(5));
  EXPECT_TRUE(*line.asserted());
  clock.advance_to(milliseconds(6));
  EXPECT_FALSE(*line.asserted());
}

TEST(FakeDigital, AnOutputThatFailsStaysAsItWas) {
  Clock clock;
  DigitalOut line(clock);
  clock.advance(milliseconds(3));
  EXPECT_EQ(line.set(true), Error::none);
  line.faults.on_calls(1, 1, Error::failed);
  clock.advance(milliseconds(3));
  EXPECT_EQ(line.set(false), Error::failed);
  EXPECT_TRUE(line.asserted());
  EXPECT_EQ(line.changed_at(), milliseconds(3));
  EXPECT_EQ(line.changes(), 1u);
}

TEST(FakeWatchdog, RemembersThatItHasBitten) {
  Clock clock;
  Watchdog watchdog(clock, milliseconds(10));
  clock.advance(milliseconds(10));
  EXPECT_FALSE(watchdog.bitten());
  clock.advance(microseconds(1));
  watchdog.feed();
  EXPECT_TRUE(watchdog.bitten());
  EXPECT_EQ(watchdog.feeds(), 1u);
}

TEST(FakeEntropy, IsRepeatableAndZeroWhereItFails) {
  Clock clock;
  Entropy a(clock, 5);
  Entropy b(clock, 5);
  std::array<std::byte, 8> from_a{};
  std::array<std::byte, 8> from_b{};
  ASSERT_EQ(a.fill(from_a), Error::none);
  ASSERT_EQ(b.fill(from_b), Error::none);
  EXPECT_EQ(from_a, from_b);
  a.faults.on_calls(1, 1, Error::failed);
  EXPECT_EQ(a.fill(from_a), Error::failed);
  EXPECT_EQ(from_a, (std::array<std::byte, 8>{}));
}

TEST(FakeCanListener, HearsWhatIsSent) {
  Clock clock;
  std::vector<std::pair<Time, CanFrame>> heard;
  auto listener = [&](Time time, const CanFrame& one) { heard.emplace_back(time, one); };
  CanListener port(clock, listener);
  static_assert(hal::CanPort<decltype(port)>);
  clock.advance(seconds(2));
  EXPECT_EQ(port.send(frame(1, 2, 3)), Error::none);
  ASSERT_EQ(heard.size(), 1u);
  EXPECT_EQ(heard[0], std::pair(seconds(2), frame(1, 2, 3)));
}

class FakeCan : public testing::Test {
 protected:
  std::vector<CanFrame> received(CanPort& port) {
    std::vector<CanFrame> frames;
    while (const auto one = port.receive()) {
      frames.push_back(*one);
    }
    return frames;
  }
  void send(std::uint8_t n) { ASSERT_EQ(a_.send(frame(0x100, 8, n)), Error::none); }

  Clock clock_;
  CanBus bus_{clock_};
  CanPort a_{bus_};
  CanPort b_{bus_};
  CanPort c_{bus_};
};

TEST_F(FakeCan, EverybodyElseHearsAFrame) {
  send(1);
  EXPECT_EQ(received(b_), std::vector{frame(0x100, 8, 1)});
  EXPECT_EQ(received(c_), std::vector{frame(0x100, 8, 1)});
  EXPECT_TRUE(received(a_).empty());
  EXPECT_EQ(bus_.sent(), (std::vector{CanEvent{clock_.now(), 0, frame(0x100, 8, 1)}}));
}

TEST_F(FakeCan, ALostFrameWasSentAndIsNotHeard) {
  bus_.mishaps.on_calls(0, 1, CanMishap::lost);
  send(1);
  send(2);
  EXPECT_EQ(received(b_), std::vector{frame(0x100, 8, 2)});
  EXPECT_EQ(bus_.sent().size(), 2u);
}

TEST_F(FakeCan, ADuplicatedFrameIsHeardTwice) {
  bus_.mishaps.on_calls(0, 1, CanMishap::duplicated);
  send(1);
  EXPECT_EQ(received(b_), (std::vector{frame(0x100, 8, 1), frame(0x100, 8, 1)}));
}

TEST_F(FakeCan, ADelayedFrameIsOvertaken) {
  bus_.mishaps.on_calls(0, 1, CanMishap::delayed);
  send(1);
  send(2);
  EXPECT_EQ(received(b_), std::vector{frame(0x100, 8, 2)});
  clock_.advance(bus_.delay - microseconds(1));
  EXPECT_TRUE(received(b_).empty());
  clock_.advance(microseconds(1));
  EXPECT_EQ(received(b_), std::vector{frame(0x100, 8, 1)});
  EXPECT_EQ(received(c_).size(), 2u);
}

TEST_F(FakeCan, ACorruptedFrameDiffersInOneBitOfItsLength) {
  bus_.mishaps.during({}, seconds(1), CanMishap::corrupted);
  for (std::uint8_t length = 0; length <= 8; ++length) {
    const CanFrame whole = frame(0x123, length, 0);
    ASSERT_EQ(a_.send(whole), Error::none);
    const auto heard = received(b_);
    ASSERT_EQ(heard.size(), 1u);
    int bits = std::popcount(heard[0].id ^ whole.id);
    for (std::size_t i = 0; i < 8; ++i) {
      bits += std::popcount(static_cast<unsigned>(heard[0].data[i] ^ whole.data[i]));
      EXPECT_TRUE(i < length || heard[0].data[i] == std::byte{});
    }
    EXPECT_EQ(bits, 1);
    EXPECT_LE(heard[0].id, 0x7ffu);
  }
}

TEST_F(FakeCan, AFullQueueIsFullForACountOrATime) {
  a_.faults.on_calls(1, 2, SendFault::full).during(seconds(1), seconds(2), SendFault::full);
  send(1);
  EXPECT_EQ(a_.send(frame(0x100, 8, 2)), Error::full);
  EXPECT_EQ(a_.send(frame(0x100, 8, 2)), Error::full);
  send(2);
  clock_.advance(seconds(1));
  EXPECT_EQ(a_.send(frame(0x100, 8, 3)), Error::full);
  clock_.advance(seconds(1));
  send(3);
  EXPECT_EQ(received(b_).size(), 3u);
}

TEST_F(FakeCan, PassiveHealsFrameByFrame) {
  a_.faults.on_calls(0, 1, SendFault::passive);
  send(0);
  EXPECT_EQ(a_.status().state, CanState::passive);
  EXPECT_EQ(a_.status().transmit_errors, 128);
  send(1);
  EXPECT_EQ(a_.status().state, CanState::warning);
  for (int i = 0; i < 32; ++i) {
    send(2);
  }
  EXPECT_EQ(a_.status().transmit_errors, 95);
  EXPECT_EQ(a_.status().state, CanState::active);
}

TEST_F(FakeCan, OffEndsByRecoveryAloneAndAfterItsTime) {
  a_.faults.on_calls(0, 1, SendFault::off);
  EXPECT_EQ(a_.send(frame(0x100, 8, 0)), Error::off);
  EXPECT_EQ(a_.status(), (CanStatus{CanState::off, 255, 0, 1, 0}));
  clock_.advance(seconds(10));
  EXPECT_EQ(a_.send(frame(0x100, 8, 0)), Error::off);
  ASSERT_EQ(b_.send(frame(0x100, 8, 9)), Error::none);
  EXPECT_TRUE(received(a_).empty()) << "who is off hears nothing";
  EXPECT_EQ(a_.recover(), Error::none);
  clock_.advance(a_.recovery - microseconds(1));
  EXPECT_EQ(a_.recover(), Error::none) << "asking again does not begin again";
  EXPECT_EQ(a_.send(frame(0x100, 8, 0)), Error::off);
  clock_.advance(microseconds(1));
  send(0);
  EXPECT_EQ(a_.status(), (CanStatus{CanState::active, 0, 0, 1, 0}));
}

TEST_F(FakeCan, AFilterKeepsFramesAwayAndARoomIsFinite) {
  b_.filter = [](const CanFrame& one) { return one.id == 0x201; };
  b_.room = 2;
  for (int i = 0; i < 3; ++i) {
    send(1);
    ASSERT_EQ(a_.send(frame(0x201, 1, 1)), Error::none);
  }
  EXPECT_EQ(received(b_).size(), 2u);
  EXPECT_EQ(b_.status().lost, 1u);
}

}  // namespace
}  // namespace hal::fake
