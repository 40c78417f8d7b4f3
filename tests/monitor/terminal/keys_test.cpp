#include <gtest/gtest.h>

#include "host_sim/monitor/terminal/terminal.hpp"

namespace host_sim::monitor {
namespace {

using Keys = std::vector<Key>;

TEST(Keys, AreWhatTerminalsSendForThem) {
  EXPECT_EQ(keys_of("q"), Keys{Key::end});
  EXPECT_EQ(keys_of("\x03"), Keys{Key::end});
  EXPECT_EQ(keys_of(" "), Keys{Key::pause});
  EXPECT_EQ(keys_of("\x1b[D\x1b[C"), (Keys{Key::back, Key::on}));
  EXPECT_EQ(keys_of("\x1bOD\x1bOC"), (Keys{Key::back, Key::on}));
  EXPECT_EQ(keys_of("\x1b[5~\x1b[6~"), (Keys{Key::far_back, Key::far_on}));
  EXPECT_EQ(keys_of("\x1b[H\x1bOH\x1b[1~"), (Keys{Key::oldest, Key::oldest, Key::oldest}));
  EXPECT_EQ(keys_of("\x1b[F\x1bOF\x1b[4~"), (Keys{Key::newest, Key::newest, Key::newest}));
}

TEST(Keys, OthersAreLeftOut) {
  EXPECT_EQ(keys_of(""), Keys{});
  EXPECT_EQ(keys_of("x\x1b[A\x1b[15~\xff\x1b"), Keys{});
  EXPECT_EQ(keys_of("\x1b[Aqx"), Keys{Key::end});
}

}  // namespace
}  // namespace host_sim::monitor
