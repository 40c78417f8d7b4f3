#include "host_sim/monitor/http/frame_lines.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace host_sim::monitor {
namespace {

TEST(NodeOfLine, FollowsTheFramePlan) {
  EXPECT_EQ(node_of_line("(1.000000) can0 185#00\n"), 5);
  EXPECT_EQ(node_of_line("(1.000000) can0 77F#05\n"), 127);
  EXPECT_EQ(node_of_line("(1.000000) can0 085#00 R\n"), 5);
  EXPECT_EQ(node_of_line("(1.000000) can0 18DA05F1#00\n"), 5);
  EXPECT_EQ(node_of_line("(1.000000) can0 18DAF105#00\n"), 5);
  EXPECT_EQ(node_of_line("(1.000000) can0 180#00\n"), std::nullopt);
  EXPECT_EQ(node_of_line("(1.000000) can0 605#00\n"), std::nullopt);
  EXPECT_EQ(node_of_line("(1.000000) can0 00000185#00\n"), std::nullopt);
  EXPECT_EQ(node_of_line("# can0\n"), std::nullopt);
  EXPECT_EQ(node_of_line("185"), std::nullopt);
  EXPECT_EQ(node_of_line(""), std::nullopt);
}

}  // namespace
}  // namespace host_sim::monitor
