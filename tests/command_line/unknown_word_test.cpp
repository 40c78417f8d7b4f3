#include "host_sim/command_line/unknown_word.hpp"

#include <gtest/gtest.h>

#include "tests/command_line/small_program.hpp"

namespace {

using namespace host_sim::command_line;
using Words = std::vector<std::string>;
using std::nullopt;

class FirstUnknown : public testing::Test {
 protected:
  std::optional<UnknownWord> first(const Words& words) { return first_unknown(program_, words); }

  host_sim_test::SmallProgram small_;
  Command program_ = read_command(small_.app);
};

TEST_F(FirstUnknown, IsAVerb) {
  const auto unknown = first({"ctu", "a.bar"});
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->word, "ctu");
  EXPECT_EQ(unknown->path, "");
  EXPECT_EQ(unknown->known, (Words{"cut", "sell"}));
  EXPECT_EQ(unknown->nearest, "cut");
  EXPECT_FALSE(unknown->is_option());
}

TEST_F(FirstUnknown, IsAVerbOfAVerb) {
  const auto unknown = first({"sell", "manny"});
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->path, "sell");
  EXPECT_EQ(unknown->nearest, "many");
}

TEST_F(FirstUnknown, IsAnOptionWithoutItsValue) {
  const auto unknown = first({"cut", "--oot=x"});
  ASSERT_TRUE(unknown);
  EXPECT_EQ(unknown->word, "--oot");
  EXPECT_EQ(unknown->path, "cut");
  EXPECT_EQ(unknown->nearest, "--out");
  EXPECT_TRUE(unknown->is_option());
}

TEST_F(FirstUnknown, IsNoValueAndNoPositional) {
  EXPECT_EQ(first({"cut", "a.bar", "--out", "--oot", "--dry"}), nullopt);
  EXPECT_EQ(first({"cut", "sel", "-o", "there", "--depth=--x"}), nullopt);
  EXPECT_EQ(first({"cut", "--", "--oot"}), nullopt);
  EXPECT_EQ(first({}), nullopt);
}

}  // namespace
