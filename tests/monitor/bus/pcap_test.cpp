#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/monitor/bus/pcap_reader.hpp"
#include "tests/monitor/bus/capture.hpp"

namespace host_sim::monitor {

using hal::files::InputError;

namespace {

using test::pcap_head;
using test::pcap_packet;
using test::raw;

constexpr std::uint32_t kSocketCan = 227, kCooked = 113, kCooked2 = 276, kEthernet = 1;

const std::string kStatus = raw({0, 0, 0x01, 0x85, 8, 0, 0, 0, 0xd1, 0x12, 3, 4, 5, 6, 7, 8});

std::vector<SeenFrame> read_pcap(std::string bytes) {
  PcapReader reader(::fmemopen(bytes.data(), bytes.size(), "rb"), "run.pcap");
  std::vector<SeenFrame> all;
  while (auto seen = reader.next()) {
    all.push_back(std::move(*seen));
  }
  return all;
}

std::string pcap_error(const std::string& bytes) {
  try {
    (void)read_pcap(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

void expect_status(const SeenFrame& seen) {
  EXPECT_EQ(seen.frame.id, 0x185u);
  EXPECT_FALSE(seen.frame.extended);
  EXPECT_EQ(seen.frame.length, 8);
  EXPECT_EQ(seen.frame.data[0], std::byte{0xd1});
  EXPECT_EQ(seen.frame.data[7], std::byte{8});
  EXPECT_FALSE(seen.flexible_data_rate);
}

TEST(Pcap, ReadsClassicFrames) {
  const auto all =
      read_pcap(pcap_head(kSocketCan) + pcap_packet(1'600'000'000, 250'001, kStatus) +
                pcap_packet(1'600'000'001, 0, raw({0x98, 0xda, 0xf1, 5, 1, 0, 0, 0, 0x11})));
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].time_ns, 1'600'000'000'250'001'000);
  expect_status(all[0]);
  EXPECT_EQ(all[1].frame.id, 0x18daf105u);
  EXPECT_TRUE(all[1].frame.extended);
}

TEST(Pcap, ReadsTimesInNanoseconds) {
  const auto all =
      read_pcap(pcap_head(kSocketCan, 0xa1b23c4d) + pcap_packet(5, 123'456'789, kStatus));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].time_ns, 5'123'456'789);
}

TEST(Pcap, ReadsTheNewerForm) {
  const auto all = read_pcap(test::pcapng(kSocketCan, 1'600'000'000'000'000'007, kStatus));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].time_ns, 1'600'000'000'000'000'007);
  expect_status(all[0]);
}

TEST(Pcap, ReadsCookedCaptures) {
  const std::string head = raw({0, 1, 1, 0x18, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  const auto all =
      read_pcap(pcap_head(kCooked) + pcap_packet(1, 0, head + raw({0, 0x0c}) + kStatus) +
                pcap_packet(1, 0, head + raw({8, 0}) + std::string(20, '\x45')) +
                pcap_packet(1, 0, head + raw({0, 0x0d}) + kStatus));
  ASSERT_EQ(all.size(), 2u);
  expect_status(all[0]);
  EXPECT_TRUE(all[1].flexible_data_rate);
  const std::string head2 = raw({0, 0x0c, 0, 0, 0, 0, 0, 3, 1, 0x18, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  const auto other = read_pcap(pcap_head(kCooked2) + pcap_packet(1, 0, head2 + kStatus));
  ASSERT_EQ(other.size(), 1u);
  expect_status(other[0]);
}

TEST(Pcap, ReadsRemoteErrorAndFlexibleFrames) {
  std::string flexible = raw({0, 0, 1, 0x85, 12, 0x05, 0, 0});
  flexible.append(12, '\x22');
  const auto all =
      read_pcap(pcap_head(kSocketCan) + pcap_packet(1, 0, raw({0x40, 0, 1, 0x85, 8, 0, 0, 0})) +
                pcap_packet(1, 0, raw({0x20, 0, 0, 0x40, 8, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0})) +
                pcap_packet(1, 0, flexible));
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[0].remote_request);
  EXPECT_EQ(all[0].frame.length, 8);
  ASSERT_TRUE(all[1].error);
  EXPECT_TRUE(all[1].error->bus_off);
  EXPECT_TRUE(all[2].flexible_data_rate);
  EXPECT_EQ(all[2].fd_flags, 1);
  EXPECT_EQ(all[2].fd_data.size(), 12u);
}

TEST(Pcap, RefusesOtherLinkTypes) {
  EXPECT_NE(pcap_error(pcap_head(kEthernet)).find("link type EN10MB; accepted: "),
            std::string::npos);
}

TEST(Pcap, RefusesPacketsThatAreCutShort) {
  const std::string whole = pcap_head(kSocketCan) + pcap_packet(1, 0, kStatus);
  for (std::size_t size = 25; size < whole.size(); ++size) {
    EXPECT_NE(pcap_error(whole.substr(0, size)), "none") << size;
  }
  EXPECT_EQ(pcap_error(whole), "none");
  EXPECT_NE(pcap_error(pcap_head(kSocketCan) + pcap_packet(1, 0, kStatus.substr(0, 15)))
                .find("packet 1 is cut short"),
            std::string::npos);
  EXPECT_NE(pcap_error(pcap_head(kSocketCan) +
                       pcap_packet(1, 0, raw({0, 0, 1, 0x85, 9, 0, 0, 0}) + std::string(64, 'x'))),
            "none");
}

TEST(Pcap, RefusesTimesThatAreNone) {
  EXPECT_NE(pcap_error(pcap_head(kSocketCan) + pcap_packet(1, 0xffff'ff00, kStatus))
                .find("packet 1 has a time that is none"),
            std::string::npos);
}

}  // namespace
}  // namespace host_sim::monitor
