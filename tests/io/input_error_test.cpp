#include "hal/files/input_error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace host_sim {

using hal::files::InputError;

namespace {

TEST(InputError, SaysPlaceFoundAndAccepted) {
  const InputError error("run.csv", 7, 3, "time_s is 'x'", "a number");
  EXPECT_STREQ(error.what(), "run.csv:7:3: time_s is 'x'; accepted: a number");
  EXPECT_EQ(error.file(), "run.csv");
  EXPECT_EQ(error.line(), 7U);
  EXPECT_EQ(error.column(), 3U);
  EXPECT_EQ(error.found(), "time_s is 'x'");
  EXPECT_EQ(error.accepted(), "a number");
}

TEST(InputError, LeavesOutWhatThereIsNot) {
  EXPECT_STREQ(InputError("f", 7, 0, "a", "b").what(), "f:7: a; accepted: b");
  EXPECT_STREQ(InputError("f", 0, 0, "a", "b").what(), "f: a; accepted: b");
}

TEST(InputError, IsOneLineWhateverTheTexts) {
  const InputError error("a\nb.csv", 1, 2, "found\r\n\x1b[2J", "x\ty");
  EXPECT_STREQ(error.what(), "a\\nb.csv:1:2: found\\r\\n\\x1b[2J; accepted: x\\ty");
}

TEST(InputError, HoldsLinesBeyond32Bits) {
  EXPECT_STREQ(InputError("f", 5'000'000'000, 1, "a", "b").what(),
               "f:5000000000:1: a; accepted: b");
}

}  // namespace
}  // namespace host_sim
