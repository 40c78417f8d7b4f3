#include "hal/linux/edge_follower.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <deque>

namespace hal::linux_os {
namespace {

struct ScriptedLine {
  Result<std::size_t> read(std::span<Edge> out) {
    if (broken) {
      return Error::failed;
    }
    const std::size_t count = std::min(out.size(), edges.size());
    std::copy_n(edges.begin(), count, out.begin());
    edges.erase(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }
  Result<bool> level() {
    ++levels_read;
    return level_broken ? Result<bool>(Error::failed) : Result<bool>(now);
  }
  // An edge that the kernel saw; `reported` where it is not lost.
  void edge(bool asserted, bool reported = true) {
    ++number;
    now = asserted;
    if (reported) {
      edges.push_back({asserted, number, number, number * 1'000ULL});
    }
  }

  std::deque<Edge> edges;
  std::uint32_t number = 0;
  bool now = false;
  bool broken = false;
  bool level_broken = false;
  int levels_read = 0;
};

class FollowedLine : public testing::Test {
 protected:
  bool asserted() {
    const Result<bool> result = follower_.asserted();
    EXPECT_TRUE(result);
    return result && *result;
  }

  ScriptedLine line_;
  EdgeFollower<ScriptedLine> follower_{line_};
};

TEST_F(FollowedLine, TheFirstCallReadsTheLevel) {
  line_.now = true;
  EXPECT_TRUE(asserted());
  EXPECT_EQ(line_.levels_read, 1);
}

TEST_F(FollowedLine, EdgesAloneAreFollowedAfterwards) {
  EXPECT_FALSE(asserted());
  line_.edge(true);
  EXPECT_TRUE(asserted());
  EXPECT_TRUE(asserted()) << "it stays";
  line_.edge(false);
  EXPECT_FALSE(asserted());
  EXPECT_EQ(line_.levels_read, 1) << "nothing was lost";
  EXPECT_EQ(follower_.last_edge_ns(), 2'000U);
}

TEST_F(FollowedLine, APulseBetweenTwoCallsIsSeenOnce) {
  EXPECT_FALSE(asserted());
  line_.edge(true);
  line_.edge(false);
  EXPECT_TRUE(asserted());
  EXPECT_FALSE(asserted());
}

TEST_F(FollowedLine, AfterLostEdgesTheLevelIsReadAgain) {
  EXPECT_FALSE(asserted());
  line_.edge(true, false);
  line_.edge(false, false);
  line_.edge(true, false);
  line_.edge(false);
  line_.now = true;  // and what came next is not reported yet
  EXPECT_TRUE(asserted());
  EXPECT_EQ(line_.levels_read, 2);
  EXPECT_EQ(follower_.lost_edges(), 3U);
  line_.now = false;
  EXPECT_TRUE(asserted()) << "the level that was read counts until the next edge";
}

TEST_F(FollowedLine, ALostPulseCountsAsAsserted) {
  EXPECT_FALSE(asserted());
  line_.edge(true, false);
  line_.edge(false);
  EXPECT_TRUE(asserted());
  EXPECT_FALSE(asserted());
}

TEST_F(FollowedLine, AHoleInTheNumbersOfTheRequestCountsToo) {
  EXPECT_FALSE(asserted());
  line_.edges.push_back({false, 2, 1, 0});
  EXPECT_TRUE(asserted());
  EXPECT_EQ(line_.levels_read, 2);
}

TEST_F(FollowedLine, AFaultIsToldAndTheLevelReadAfterIt) {
  EXPECT_FALSE(asserted());
  line_.broken = true;
  EXPECT_EQ(follower_.asserted().error(), Error::failed);
  line_.broken = false;
  line_.now = true;
  EXPECT_TRUE(asserted());
  EXPECT_EQ(line_.levels_read, 2);
}

TEST_F(FollowedLine, ALevelThatCannotBeReadIsAFault) {
  line_.level_broken = true;
  EXPECT_EQ(follower_.asserted().error(), Error::failed);
  line_.level_broken = false;
  EXPECT_FALSE(asserted());
}

TEST_F(FollowedLine, AFloodOfEdgesEndsTheCall) {
  EXPECT_FALSE(asserted());
  for (int i = 0; i < 500; ++i) {
    line_.edge(i % 2 == 0);
  }
  EXPECT_TRUE(asserted());
  EXPECT_EQ(line_.edges.size(), 436U);
}

// Whatever is lost: an assertion that the kernel saw is never missed, and once all that was
// reported is read the answer is the level.
RC_GTEST_PROP(FollowedLineProperty, NoAssertionIsMissed, ()) {
  ScriptedLine line;
  EdgeFollower<ScriptedLine> follower(line);
  RC_ASSERT(!*follower.asserted());
  const auto steps = *rc::gen::container<std::vector<std::pair<bool, bool>>>(
      rc::gen::pair(rc::gen::arbitrary<bool>(), rc::gen::arbitrary<bool>()));
  bool seen_by_kernel = false;
  for (const auto& [reported, look] : steps) {
    line.edge(!line.now, reported);
    seen_by_kernel = seen_by_kernel || line.now;
    if (reported && look) {
      const Result<bool> result = follower.asserted();
      RC_ASSERT(*result || !seen_by_kernel);
      RC_ASSERT(*follower.asserted() == line.now);
      seen_by_kernel = false;
    }
  }
}

}  // namespace
}  // namespace hal::linux_os
