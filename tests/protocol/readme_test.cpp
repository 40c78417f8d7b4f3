#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "firmware/generate/generate.hpp"

namespace protocol::generate {
namespace {

/// What stands in README.md between the marks of this name.
std::string marked(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(TENDONLIFE_README).rdbuf();
  const std::string readme = text.str();
  const std::string begin = "<!-- " + name + ":begin -->\n";
  const std::size_t start = readme.find(begin);
  const std::size_t end = readme.find("<!-- " + name + ":end -->");
  if (start == std::string::npos || end == std::string::npos) {
    return "no marks of " + name;
  }
  return readme.substr(start + begin.size(), end - start - begin.size());
}

TEST(FrameTable, InTheReadmeIsWhatTheSchemaSays) {
  EXPECT_EQ(marked("frame-table"), table())
      << "put what `protocol_generate table` writes between the marks";
}

TEST(ServiceTable, InTheReadmeIsWhatTheServerSays) {
  EXPECT_EQ(marked("service-table"), services())
      << "put what `protocol_generate services` writes between the marks";
}

// One line of each kind, by hand.
TEST(FrameTable, SaysWhereThingsLie) {
  const std::string text = table();
  for (const char* line :
       {"| 0x700 + n | Heartbeat | every 1 s, and boot_up once at the start | b0 NmtState |\n",
        "| | page 4 RainflowBin | one bin of the range and mean matrix | b2.0-4 BinTendon, b2.5-7 "
        "BinRange, b3.0-2 BinMean, b3.3-7 BinHalfCycles, b4-7 BinCycles |\n",
        "| 0x080 + n | Emergency | on every transition, at most 10 a second | b0-1 EmergencyCode, "
        "b2 "
        "ErrorRegister, b3 Crc, b4.0-3 Counter, b5-7 EmergencyDamage x 1e-6 |\n",
        "| 0x18DA nn F1 | Request | on request | UDS over ISO-TP, 29 bits |\n",
        "| LifeState, TendonLifeState | 0 unknown, 1 normal, 2 inspect, 3 replace, 4 worn |\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace protocol::generate
