#include "host_sim/command_line/nearest.hpp"

#include <gtest/gtest.h>

#include "tests/command_line/small_program.hpp"

namespace {

using namespace host_sim::command_line;
using Words = std::vector<std::string>;
using std::nullopt;

const Words kVerbs{"replay", "plan", "pack", "calibrate"};
const Words kOptions{"--report", "--risk"};

TEST(Nearest, HasOneLetterMoreLessOtherOrSwapped) {
  EXPECT_EQ(nearest("replaay", kVerbs), "replay");
  EXPECT_EQ(nearest("repay", kVerbs), "replay");
  EXPECT_EQ(nearest("reploy", kVerbs), "replay");
  EXPECT_EQ(nearest("replya", kVerbs), "replay");
  EXPECT_EQ(nearest("--rsik", kOptions), "--risk");
}

// Of three letters in four, one third is one; two swaps of a word of nine are two.
TEST(Nearest, AllowsAThirdOfTheLetters) {
  EXPECT_EQ(nearest("pln", kVerbs), "plan");
  EXPECT_EQ(nearest("pxxk", kVerbs), nullopt);
  EXPECT_EQ(nearest("claibarte", kVerbs), "calibrate");
  EXPECT_EQ(nearest("", kVerbs), nullopt);
  EXPECT_EQ(nearest("replay", {}), nullopt);
}

TEST(Nearest, TakesABeginningOfThreeLetters) {
  EXPECT_EQ(nearest("cal", kVerbs), "calibrate");
  EXPECT_EQ(nearest("--rep", kOptions), "--report");
  EXPECT_EQ(nearest("ca", kVerbs), nullopt);
}

// As near as each other: the first.
TEST(Nearest, TakesTheFirstOfTwo) {
  EXPECT_EQ(nearest("plak", {"plan", "play"}), "plan");
  EXPECT_EQ(nearest("plak", {"play", "plan"}), "play");
}

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
