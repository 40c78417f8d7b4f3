#include "hal/files/candump.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/io/support.hpp"

namespace host_sim {

using hal::files::candump_line;
using hal::files::CandumpReader;
using hal::files::LoggedFrame;
using hal::files::memory_source;
using hal::files::parse_candump_line;

namespace {

using Direction = LoggedFrame::Direction;
using FrameKind = LoggedFrame::Kind;
using test::complaint_of;
using testing::HasSubstr;
using testing::StartsWith;

LoggedFrame parsed(std::string_view text) {
  return parse_candump_line({"log", 3, text});
}

std::string complaint(std::string_view text) {
  return complaint_of([&] { parsed(text); });
}

std::vector<std::uint8_t> bytes_of(const LoggedFrame& frame) {
  std::vector<std::uint8_t> bytes;
  for (const std::byte byte : frame.payload()) {
    bytes.push_back(std::to_integer<std::uint8_t>(byte));
  }
  return bytes;
}

TEST(Candump, ReadsADataFrame) {
  const LoggedFrame frame = parsed("(1436509052.249713) vcan0 044#2A366C2BBA");
  EXPECT_EQ(frame.time_us, 1'436'509'052'249'713u);
  EXPECT_EQ(frame.interface, "vcan0");
  EXPECT_EQ(frame.kind, FrameKind::kData);
  EXPECT_EQ(frame.direction, Direction::kUnknown);
  EXPECT_EQ(frame.id, 0x44u);
  EXPECT_FALSE(frame.extended);
  EXPECT_EQ(bytes_of(frame), (std::vector<std::uint8_t>{0x2a, 0x36, 0x6c, 0x2b, 0xba}));
}

TEST(Candump, ReadsIdentifiersOfBothKinds) {
  EXPECT_EQ(parsed("(0.000000) can0 7FF#").id, 0x7ffu);
  EXPECT_FALSE(parsed("(0.000000) can0 7ff#").extended);
  EXPECT_EQ(parsed("(0.000000) can0 18DA01F1#").id, 0x18da01f1u);
  EXPECT_TRUE(parsed("(0.000000) can0 00000001#").extended);
}

TEST(Candump, ReadsWhatComesAfterTheFrame) {
  EXPECT_EQ(parsed("(0.000000) can0 123#01 R").direction, Direction::kReceived);
  EXPECT_EQ(parsed("(0.000000) can0 123#01 T").direction, Direction::kSent);
  EXPECT_EQ(parsed("(0.000000) can0 123# R").direction, Direction::kReceived);
  EXPECT_EQ(parsed("(0.000000) can0 123#R R").direction, Direction::kReceived);
}

TEST(Candump, ReadsRemoteFrames) {
  const LoggedFrame frame = parsed("(0.000000) can0 123#R5");
  EXPECT_EQ(frame.kind, FrameKind::kRemote);
  EXPECT_EQ(frame.length, 5);
  EXPECT_EQ(parsed("(0.000000) can0 123#R").length, 0);
  EXPECT_FALSE(frame.classic().has_value());
}

TEST(Candump, ReadsFramesOfCanFd) {
  const LoggedFrame frame = parsed("(0.000000) can0 123##3000102030405060708090A0B");
  EXPECT_EQ(frame.kind, FrameKind::kFd);
  EXPECT_EQ(frame.fd_flags, 3);
  EXPECT_EQ(frame.length, 12);
  EXPECT_EQ(bytes_of(frame)[11], 11);
  EXPECT_EQ(parsed("(0.000000) can0 123##0").length, 0);
  EXPECT_EQ(parsed("(0.000000) can0 123##0" + std::string(128, 'F')).length, 64);
  EXPECT_FALSE(frame.classic().has_value());
}

// CAN_ERR_FLAG and CAN_ERR_BUSOFF of linux/can/error.h.
TEST(Candump, ReadsWhatTheControllerTells) {
  const LoggedFrame frame = parsed("(0.000000) can0 20000040#0000000000000000");
  EXPECT_EQ(frame.kind, FrameKind::kError);
  EXPECT_EQ(frame.id, 0x40u);
  EXPECT_EQ(frame.length, 8);
  EXPECT_FALSE(frame.classic().has_value());
}

TEST(Candump, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(complaint("(1.0) can0 123#"),
            "log:3:5: ') can0 123#'; accepted: (seconds.microseconds) with 6 digits of "
            "microseconds");
  EXPECT_EQ(complaint("(1.000000) can0 123#012"),
            "log:3:24: the line ends; accepted: 0 to 8 bytes of 2 hexadecimal digits");
  EXPECT_THAT(complaint(""), StartsWith("log:3:1: the line ends; accepted: (seconds"));
  EXPECT_THAT(complaint("1.000000 can0 123#"), StartsWith("log:3:1: "));
  EXPECT_THAT(complaint("(1.0000000) can0 123#"), StartsWith("log:3:4: "));
  EXPECT_THAT(complaint("(1234567890123.000000) can0 123#"), StartsWith("log:3:2: "));
  EXPECT_THAT(complaint("(1.000000)  123#"), HasSubstr("an interface name"));
  EXPECT_THAT(complaint("(1.000000) abcdefghijklmnop 123#"), HasSubstr("an interface name"));
  EXPECT_THAT(complaint("(1.000000) can0"), HasSubstr("an interface name"));
  EXPECT_THAT(complaint("(1.000000) can\x01 123#"), HasSubstr("an interface name"));
}

TEST(Candump, RefusesWrongIdentifiers) {
  for (const char* id :
       {"12", "1234", "800", "FFF", "40000000", "FFFFFFFF", "123456789", "12G", ""}) {
    EXPECT_THAT(complaint(std::string("(1.000000) can0 ") + id + "#00"),
                HasSubstr("accepted: 3 hexadecimal digits up to 7FF, or 8"))
        << id;
  }
}

TEST(Candump, RefusesWrongContent) {
  for (const char* data :
       {"0", "0G", "001122334455667788", "R9", "RR", "01 X", "01 R ", "01 ", "01R"}) {
    EXPECT_THAT(complaint(std::string("(1.000000) can0 123#") + data),
                HasSubstr("accepted: 0 to 8 bytes"))
        << data;
  }
  for (const std::string& data : {std::string("#"), std::string("#G"), "#0" + std::string(18, '0'),
                                  "#0" + std::string(130, '0')}) {
    EXPECT_THAT(complaint("(1.000000) can0 123#" + data), HasSubstr("accepted: after ##")) << data;
  }
}

TEST(Candump, ReadsALogLineByLine) {
  CandumpReader reader(memory_source("# a log\n(1.000000) can0 123#01\r\n\n"), "log");
  const auto frame = reader.next();
  ASSERT_TRUE(frame.has_value());
  EXPECT_EQ(frame->id, 0x123u);
  EXPECT_THAT(complaint_of([&] { reader.next(); }), StartsWith("log:3:1: "));
}

TEST(Candump, ReadsALastLineWithoutEnd) {
  CandumpReader reader(memory_source("(1.000000) can0 123#01"), "log");
  EXPECT_TRUE(reader.next().has_value());
  EXPECT_FALSE(reader.next().has_value());
  EXPECT_FALSE(CandumpReader(memory_source(""), "log").next().has_value());
}

TEST(Candump, SaysThatAFileIsMissing) {
  EXPECT_EQ(complaint_of([] { CandumpReader("/nowhere/can.log"); }),
            "/nowhere/can.log: cannot be opened: No such file or directory; accepted: a log of "
            "candump -L, or - for standard input");
}

TEST(Candump, WritesAsCandumpDoes) {
  hal::CanFrame frame{.id = 0x44, .length = 2};
  frame.data[0] = std::byte{0x2a};
  EXPECT_EQ(candump_line(1'436'509'052'249'713, "vcan0", frame),
            "(1436509052.249713) vcan0 044#2A00\n");
  frame.extended = true;
  EXPECT_EQ(candump_line(1, "can0", frame), "(0000000000.000001) can0 00000044#2A00\n");
}

RC_GTEST_PROP(CandumpProperty, WhatIsWrittenIsReadBack, ()) {
  hal::CanFrame frame;
  frame.extended = *rc::gen::arbitrary<bool>();
  frame.id = *rc::gen::inRange<std::uint32_t>(0, frame.extended ? 0x2000'0000 : 0x800);
  frame.length = *rc::gen::inRange<std::uint8_t>(0, 9);
  for (std::size_t i = 0; i < frame.length; ++i) {
    frame.data[i] = static_cast<std::byte>(*rc::gen::arbitrary<std::uint8_t>());
  }
  const auto time_us = *rc::gen::inRange<std::uint64_t>(0, 10'000'000'000'000'000);
  const std::string text = candump_line(time_us, "can0", frame);
  CandumpReader reader(memory_source(text), "log");
  const auto logged = reader.next();
  RC_ASSERT(logged.has_value());
  RC_ASSERT(logged->time_us == time_us);
  RC_ASSERT(logged->classic() == frame);
  RC_ASSERT(!reader.next().has_value());
}

}  // namespace
}  // namespace host_sim
