#include "firmware/protocol/uds/table.hpp"

#include <gtest/gtest.h>

#include <string>

namespace protocol::testing {
namespace {

TEST(Describe, IsTheTableInMarkdown) {
  std::string text;
  uds::describe([&text](std::string_view piece) { text += piece; });
  EXPECT_EQ(text,
            "| service | identifier | bytes | what |\n"
            "|---|---|---|---|\n"
            "| 0x22 read | 0x0200 .. 0x021f | 61 | life record of a tendon |\n"
            "| 0x22 read | 0x0220 .. 0x023f | 4 | CRC-32 of the parameter block of a tendon |\n"
            "| 0x22 read | 0x0260 .. 0x027f | 8 | parameters that a tendon counts with, or why it "
            "does not |\n"
            "| 0x22 read | 0x0240 | 4 | storage counter |\n"
            "| 0x22 read | 0x0241 | 16 | a fresh nonce, good for one command in 5 s |\n"
            "| 0x22 read | 0x0242 | 18 | state of the authority |\n"
            "| 0x22 read | 0x1000 .. 0x1fff | 16 | line of the log, from the oldest |\n"
            "| 0x22 read | 0xf18c | 12 | serial number of the controller |\n"
            "| 0x22 read | 0xf195 | 2 | versions of frame plan and firmware |\n"
            "| 0x31 start | 0x0201 | 1 + 12 | open a new epoch of a tendon |\n"
            "| 0x31 start | 0x0202 | 85 or 129 + 12 | load the parameter block of a tendon, of "
            "version 1 or 2 |\n"
            "| 0x31 start | 0x0203 | 1 + 12 | load the parameter block that was transferred |\n"
            "| 0x34, 0x36, 0x37 | | 616 at most | transfer a parameter block in parts |\n");
}

}  // namespace
}  // namespace protocol::testing
