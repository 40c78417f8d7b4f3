#include "hal/files/nearest.hpp"

#include <gtest/gtest.h>

namespace {

using hal::files::nearest;
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

}  // namespace
