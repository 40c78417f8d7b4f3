#include "host_sim/statistics/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace host_sim::statistics {
namespace {

TEST(ParallelFor, EachOnce) {
  for (const unsigned threads : {0U, 1U, 3U, 50U}) {
    std::vector<int> calls(20);
    parallel_for(
        calls.size(), [&](std::size_t i) { ++calls[i]; }, threads);
    EXPECT_EQ(calls, std::vector<int>(20, 1));
  }
}

TEST(ParallelFor, NothingToDo) {
  parallel_for(0, [](std::size_t) { FAIL(); });
}

TEST(ParallelFor, AnExceptionEndsTheRest) {
  std::atomic<int> calls = 0;
  const auto fail_early = [&](std::size_t) {
    ++calls;
    throw std::runtime_error("no");
  };
  EXPECT_THROW(parallel_for(1000, fail_early, 3), std::runtime_error);
  EXPECT_LE(calls, 3);
}

}  // namespace
}  // namespace host_sim::statistics
