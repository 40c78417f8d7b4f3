#include "firmware/app/emergencies.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace app {
namespace {

using Code = protocol::EmergencyCode;

std::vector<protocol::Emergency> report_all(Emergencies& emergencies) {
  std::vector<protocol::Emergency> reported;
  while (const auto next = emergencies.next()) {
    reported.push_back(*next);
    emergencies.reported();
  }
  return reported;
}

TEST(Emergencies, AnEventIsToldOnceAndItsEndOnce) {
  Emergencies emergencies;
  EXPECT_FALSE(emergencies.waiting());
  emergencies.set(Code::storage, true);
  emergencies.set(Code::storage, true);
  EXPECT_EQ(report_all(emergencies), (std::vector<protocol::Emergency>{{Code::storage, 0x81, 0}}));
  emergencies.set(Code::storage, false);
  EXPECT_EQ(report_all(emergencies), (std::vector<protocol::Emergency>{{Code::none, 0x00, 0}}));
  EXPECT_FALSE(emergencies.waiting());
}

TEST(Emergencies, WhatEndedBeforeItWasToldIsToldAllTheSame) {
  Emergencies emergencies;
  emergencies.set(Code::bus, true);
  emergencies.set(Code::bus, false);
  EXPECT_EQ(report_all(emergencies),
            (std::vector<protocol::Emergency>{{Code::bus, 0x11, 0}, {Code::none, 0x00, 0}}));
}

TEST(Emergencies, TheMostUrgentGoesFirstAndTheRegisterShowsAllThatIsActive) {
  Emergencies emergencies;
  emergencies.set(Code::bus, true);
  emergencies.set(Code::sensor, true);
  emergencies.set(Code::emergency_stop, true);
  EXPECT_EQ(report_all(emergencies),
            (std::vector<protocol::Emergency>{
                {Code::emergency_stop, 0x93, 0}, {Code::sensor, 0x93, 0}, {Code::bus, 0x93, 0}}));
  emergencies.set(Code::sensor, false);
  EXPECT_EQ(report_all(emergencies), (std::vector<protocol::Emergency>{{Code::none, 0x91, 0}}));
}

TEST(Emergencies, ABrokenTendonGoesBeforeALifeThatIsUsedUp) {
  Emergencies emergencies;
  for (const Code code : {Code::life_replace, Code::tendon_slack, Code::life_worn, Code::overload,
                          Code::tendon_broken, Code::emergency_stop}) {
    emergencies.set(code, true);
  }
  std::vector<Code> codes;
  for (const protocol::Emergency& emergency : report_all(emergencies)) {
    EXPECT_EQ(emergency.error_register, 0xa3);
    codes.push_back(emergency.code);
  }
  EXPECT_EQ(codes, (std::vector<Code>{Code::emergency_stop, Code::tendon_broken, Code::overload,
                                      Code::life_worn, Code::tendon_slack, Code::life_replace}));
}

TEST(Emergencies, ABreakAloneIsOfTheDeviceProfile) {
  Emergencies emergencies;
  emergencies.set(Code::tendon_broken, true);
  EXPECT_EQ(report_all(emergencies),
            (std::vector<protocol::Emergency>{{Code::tendon_broken, 0x21, 0}}));
}

TEST(Emergencies, ThereIsRoomForEveryEventAtOnce) {
  Emergencies emergencies;
  const std::vector<Code> all{
      Code::emergency_stop, Code::life_inspect,  Code::life_replace, Code::life_worn,
      Code::overload,       Code::sensor,        Code::storage,      Code::record_damaged,
      Code::parameters,     Code::settings,      Code::bus,          Code::deadline,
      Code::authority,      Code::tendon_broken, Code::tendon_slack};
  for (int round = 0; round < 3; ++round) {
    for (const Code code : all) {
      emergencies.set(code, true);
      emergencies.set(code, false);
    }
  }
  const auto reported = report_all(emergencies);
  EXPECT_EQ(reported.size(), all.size() + 1);
  for (const Code code : all) {
    EXPECT_TRUE(std::any_of(reported.begin(), reported.end(),
                            [code](const auto& emergency) { return emergency.code == code; }));
  }
}

TEST(Emergencies, WhatIsActiveCanBeToldAgain) {
  Emergencies emergencies;
  emergencies.set(Code::overload, true);
  emergencies.set(Code::bus, true);
  emergencies.set(Code::bus, false);
  report_all(emergencies);
  emergencies.report_again();
  EXPECT_EQ(report_all(emergencies), (std::vector<protocol::Emergency>{{Code::overload, 0x03, 0}}));
}

}  // namespace
}  // namespace app
