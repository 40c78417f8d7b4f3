#include "host_sim/batch/deal.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "hal/files/interruption.hpp"

namespace {

using host_sim::batch::deal;
using host_sim::batch::Ranks;

// Where the tests are built with MPI, it starts once in a process: run them by ctest.

TEST(Deal, GivesAnswersInOrderWithAnyBytes) {
  Ranks ranks;
  ASSERT_EQ(ranks.count(), 1U);
  EXPECT_EQ(ranks.broadcast("text"), "text");
  const std::vector<std::string> answers =
      deal(ranks, 100, 3, [](std::size_t i) { return std::string(i, '\0') + std::to_string(i); });
  ASSERT_EQ(answers.size(), 100U);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    EXPECT_EQ(answers[i], std::string(i, '\0') + std::to_string(i));
  }
  EXPECT_TRUE(ranks.has_left());
}

TEST(Deal, TellsWhyTheWorkFailed) {
  Ranks ranks;
  try {
    deal(ranks, 5, 2, [](std::size_t i) -> std::string {
      return i == 3 ? throw std::runtime_error("three") : "";
    });
    FAIL() << "no exception";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "three");
  }
  EXPECT_TRUE(ranks.has_left());
}

TEST(Deal, AnInterruptionStaysOne) {
  Ranks ranks;
  EXPECT_THROW(
      deal(ranks, 2, 1, [](std::size_t) -> std::string { throw hal::files::Interruption(); }),
      hal::files::Interruption);
}

TEST(Deal, NothingToDoIsNoError) {
  Ranks ranks;
  EXPECT_TRUE(deal(ranks, 0, 0, [](std::size_t) { return std::string(); }).empty());
}

}  // namespace
