#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/bus/asc_reader.hpp"

namespace host_sim::monitor {

using hal::files::InputError;
using hal::files::memory_source;

namespace {

std::vector<SeenFrame> read_asc(std::string_view text) {
  AscReader reader(memory_source(text), "run.asc");
  std::vector<SeenFrame> all;
  while (auto seen = reader.next()) {
    all.push_back(std::move(*seen));
  }
  return all;
}

std::string asc_error(std::string_view text) {
  try {
    (void)read_asc(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

std::vector<int> bytes(const hal::CanFrame& frame) {
  std::vector<int> out;
  for (const std::byte byte : frame.payload()) {
    out.push_back(std::to_integer<int>(byte));
  }
  return out;
}

constexpr std::string_view kHead =
    "date Sat Sep 30 15:06:13.191 2017\n"
    "base hex  timestamps absolute\n"
    "internal events logged\n"
    "// version 9.0.0\n"
    "Begin Triggerblock Sat Sep 30 15:06:13.191 2017\n"
    "   0.000000 Start of measurement\n";

std::string with_head(std::string_view lines) {
  return std::string(kHead).append(lines);
}

TEST(Asc, ReadsDataFramesOfBothWidths) {
  const auto all =
      read_asc(with_head("   0.015991 1  185             Rx   d 3 FF 00 a1\n"
                         "   2.500000 2  18DAF105x       Tx   d 0  Length = 3 BitCount = 4\n"
                         "End TriggerBlock\n"));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].time_ns, 15'991'000);
  EXPECT_EQ(all[0].frame.id, 0x185u);
  EXPECT_FALSE(all[0].frame.extended);
  EXPECT_EQ(bytes(all[0].frame), (std::vector<int>{0xff, 0x00, 0xa1}));
  EXPECT_EQ(all[1].time_ns, 2'500'000'000);
  EXPECT_EQ(all[1].frame.id, 0x18daf105u);
  EXPECT_TRUE(all[1].frame.extended);
  EXPECT_EQ(all[1].frame.length, 0);
}

TEST(Asc, ReadsDecimalNumbers) {
  const auto all = read_asc("base dec timestamps absolute\n0.1 1 389 Rx d 2 255 10\n");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].frame.id, 389u);
  EXPECT_EQ(bytes(all[0].frame), (std::vector<int>{255, 10}));
}

// Each time is that since the event before, of whatever kind.
TEST(Asc, AddsUpRelativeTimes) {
  const auto all = read_asc(
      "base hex timestamps relative\n"
      "0.5 1 100 Rx d 0\n"
      "0.25 1 Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%\n"
      "0.000000001 1 100 Rx d 0\n");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].time_ns, 500'000'000);
  EXPECT_EQ(all[1].time_ns, 750'000'001);
}

TEST(Asc, ReadsRemoteAndErrorFrames) {
  const auto all =
      read_asc(with_head("0.1 1 100 Rx r\n"
                         "0.2 1 101x Tx r 8\n"
                         "0.3 1 ErrorFrame ECC: 10100010\n"
                         "0.4 CAN 1 Status:chip status busoff - TxErr: 248 RxErr: 0\n"
                         "0.5 CAN 1 Status:chip status error active\n"));
  ASSERT_EQ(all.size(), 5u);
  EXPECT_TRUE(all[0].remote_request);
  EXPECT_EQ(all[0].frame.length, 0);
  EXPECT_TRUE(all[1].remote_request);
  EXPECT_EQ(all[1].frame.length, 8);
  ASSERT_TRUE(all[2].error);
  EXPECT_FALSE(all[2].error->bus_off);
  ASSERT_TRUE(all[3].error);
  EXPECT_TRUE(all[3].error->bus_off);
  ASSERT_TRUE(all[4].error);
  EXPECT_TRUE(all[4].error->restarted);
}

// 0x303000 has bit 12, EDL; 0x200000 has not: the second is a frame of classic CAN.
TEST(Asc, ReadsLinesOfFlexibleDataRate) {
  const auto all = read_asc(with_head(
      "30.1 CANFD   1 Rx        300                                   1 0 9 12 01 02 03 04 05 06 "
      "07 "
      "08 09 0a 0b 0c   102203  133      303000 e0006659 46500250 4b140250 20011736 2001040d\n"
      "30.2 CANFD   2 Tx        1C4D80A7x  SomeName                   0 0 2  2 12 C2   102203  133 "
      "  "
      "200000 e0006659\n"
      "30.3 CANFD   1 Rx        301                                   0 1 1  1 55\n"
      "30.4 CANFD   1 Rx   ErrorFrame Not Acknowledge error\n"));
  ASSERT_EQ(all.size(), 4u);
  EXPECT_TRUE(all[0].flexible_data_rate);
  EXPECT_EQ(all[0].frame.id, 0x300u);
  EXPECT_EQ(all[0].fd_flags, 1);
  ASSERT_EQ(all[0].fd_data.size(), 12u);
  EXPECT_EQ(all[0].fd_data[11], std::byte{0x0c});
  EXPECT_FALSE(all[1].flexible_data_rate);
  EXPECT_TRUE(all[1].frame.extended);
  EXPECT_EQ(bytes(all[1].frame), (std::vector<int>{0x12, 0xc2}));
  EXPECT_TRUE(all[2].flexible_data_rate);
  EXPECT_EQ(all[2].fd_flags, 2);
  EXPECT_TRUE(all[3].error);
}

TEST(Asc, SkipsWhatIsNoFrameOfTheBus) {
  EXPECT_TRUE(read_asc(with_head("0.1 1 185 TxRq d 1 00\n"
                                 "0.2 SV: 2 0 1 ::Env = 3\n"
                                 "0.3 CAN 1 Overload frame\n"
                                 "// 0.4 1 185 Rx d 1 00\n"
                                 "\n"))
                  .empty());
}

TEST(Asc, RefusesWhatCannotBeTrusted) {
  EXPECT_EQ(asc_error("base hex timestamps absolute\n0.1 1 800 Rx d 0\n"),
            "run.asc:2:7: '800'; accepted: an identifier up to 7FF, or up to 1FFFFFFF with x");
  EXPECT_EQ(
      asc_error("0.1 1 20000000x Rx d 0\n"),
      "run.asc:1:7: '20000000x'; accepted: an identifier up to 7FF, or up to 1FFFFFFF with x");
  EXPECT_EQ(asc_error("0.1 1 100 Rx d 9 1 2 3 4 5 6 7 8 9\n"),
            "run.asc:1:16: '9'; accepted: a length of 0 to 8 bytes");
  EXPECT_EQ(asc_error("0.1 1 100 Rx d 3 11 22\n"),
            "run.asc:1:23: the line ends; accepted: as many bytes as the length says");
  EXPECT_EQ(asc_error("0.1 1 100 Rx d 1 100\n"),
            "run.asc:1:18: '100'; accepted: as many bytes as the length says");
  EXPECT_EQ(asc_error("0.1 1 100 Rx x 1\n"), "run.asc:1:14: 'x'; accepted: d and a length, or r");
  EXPECT_EQ(asc_error("base oct timestamps absolute\n"),
            "run.asc:1:6: 'oct'; accepted: base hex or dec, then timestamps absolute or relative");
  EXPECT_NE(asc_error("0.1x 1 100 Rx d 0\n").find("accepted: seconds"), std::string::npos);
  EXPECT_NE(asc_error("hello\n").find("run.asc:1:1: 'hello'"), std::string::npos);
}

}  // namespace
}  // namespace host_sim::monitor
