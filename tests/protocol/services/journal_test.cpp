#include "firmware/protocol/uds/journal.hpp"

#include <gtest/gtest.h>

#include "tests/protocol/services/model_device.hpp"

namespace protocol::testing {
namespace {

using storage::Event;

class JournalTest : public ::testing::Test {
 protected:
  std::vector<Event> events() const {
    std::vector<Event> result;
    for (const auto& line : device_.lines) {
      result.push_back(line.event);
    }
    return result;
  }

  ModelDevice device_{1};
  uds::Journal<ModelDevice> journal_{device_};
};

TEST_F(JournalTest, EveryFailureLeavesALine) {
  for (int i = 0; i < 3; ++i) {
    journal_.refused(Event::wrong_mac, 0, 0x0201);
    journal_.refused(Event::nonce_expired, 0, 0x0201);
  }
  EXPECT_EQ(device_.lines.size(), 6u);
  EXPECT_EQ(journal_.unlogged(), 0u);
}

TEST_F(JournalTest, WhatCostsNothingLeavesOneLineEach) {
  for (int i = 0; i < 5; ++i) {
    for (const Event event : {Event::rejected, Event::disabled, Event::locked_out}) {
      journal_.refused(event, 0, 0x0201);
    }
  }
  EXPECT_EQ(events(), (std::vector{Event::rejected, Event::disabled, Event::locked_out}));
  EXPECT_EQ(journal_.unlogged(), 12u);
}

TEST_F(JournalTest, TheNextLockIsToldAgain) {
  journal_.refused(Event::locked_out, 0, 0x0201);
  journal_.refused(Event::rejected, 0, 0x0201);
  journal_.refused(Event::wrong_mac, 0, 0x0201);
  journal_.refused(Event::locked_out, 0, 0x0201);
  journal_.refused(Event::rejected, 0, 0x0201);
  EXPECT_EQ(events(),
            (std::vector{Event::locked_out, Event::rejected, Event::wrong_mac, Event::locked_out}));
}

TEST_F(JournalTest, ADeedBeginsAnew) {
  journal_.refused(Event::rejected, 0, 0x0201);
  EXPECT_EQ(journal_.about_to(Event::epoch_opened, 0, 7), hal::Error::none);
  journal_.refused(Event::rejected, 0, 0x0201);
  EXPECT_EQ(device_.lines.size(), 3u);
}

TEST_F(JournalTest, RefusalsDoNotFillTheLog) {
  for (int i = 0; i < 100; ++i) {
    journal_.refused(Event::wrong_mac, 0, 0x0201);
  }
  // 64, and one that stands for all that follow.
  EXPECT_EQ(device_.lines.size(), 65u);
  EXPECT_EQ(journal_.unlogged(), 35u);
  EXPECT_EQ(uds::Journal<ModelDevice>(device_).start(), 64u + 9u);
  EXPECT_EQ(journal_.about_to(Event::epoch_opened, 0, 7), hal::Error::none);
  EXPECT_EQ(device_.lines.size(), 66u);

  uds::Journal<ModelDevice> after_restart(device_);
  EXPECT_EQ(after_restart.start(), 0u);
  for (int i = 0; i < 10; ++i) {
    for (const Event event : {Event::rejected, Event::locked_out, Event::counter_rolled_back,
                              Event::wrong_mac, Event::nonce_reused}) {
      after_restart.refused(event, 0, 0x0201);
    }
  }
  EXPECT_EQ(device_.lines.size(), 67u);
  EXPECT_EQ(device_.lines.back().event, Event::wrong_mac);
  EXPECT_EQ(uds::Journal<ModelDevice>(device_).start(), 9u);
}

TEST_F(JournalTest, ARefusalThatFindsNoRoomIsCounted) {
  device_.log_capacity = 0;
  journal_.refused(Event::wrong_mac, 0, 0x0201);
  journal_.not_done(0, 0x0201);
  EXPECT_EQ(journal_.unlogged(), 2u);
  EXPECT_EQ(journal_.about_to(Event::epoch_opened, 0, 7), hal::Error::full);
}

TEST_F(JournalTest, CountsTheFailuresSinceTheLastDeed) {
  EXPECT_EQ(journal_.start(), 0u);
  for (const Event event : {Event::wrong_mac, Event::epoch_opened, Event::wrong_mac,
                            Event::nonce_reused, Event::nonce_expired, Event::counter_rolled_back,
                            Event::locked_out, Event::rejected, Event::disabled, Event::not_done}) {
    EXPECT_EQ(device_.log(event, 0, 0), hal::Error::none);
  }
  EXPECT_EQ(uds::Journal<ModelDevice>(device_).start(), 3u);
  EXPECT_EQ(device_.log(Event::parameters_loaded, 0, 0), hal::Error::none);
  EXPECT_EQ(uds::Journal<ModelDevice>(device_).start(), 0u);
}

}  // namespace
}  // namespace protocol::testing
