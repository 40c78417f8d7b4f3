#include "host_sim/io/progress.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

namespace host_sim {
namespace {

TEST(ProgressText, ShowsShareRateAndTimeLeft) {
  // 1 of 4 GB in 10 s: 100 MB/s, 30 s left; 25 % of a bar of 20.
  EXPECT_EQ(progress_text("replay", 1'000'000'000, 4'000'000'000, 10.0, 58),
            "replay [#####---------------]  25 %  100.0 MB/s  0:30 left");
}

TEST(ProgressText, ShowsMinutesAndHours) {
  EXPECT_NE(progress_text("", 1, 126, 1.0, 80).find("2:05 left"), std::string::npos);
  EXPECT_NE(progress_text("", 1, 3726, 1.0, 80).find("1:02:05 left"), std::string::npos);
}

TEST(ProgressText, EndsAtAHundredPercent) {
  EXPECT_NE(progress_text("", 5, 5, 1.0, 80).find("100 %"), std::string::npos);
  EXPECT_NE(progress_text("", 999, 5, 1.0, 80).find("100 %"), std::string::npos);
  EXPECT_NE(progress_text("", 999'999, 1'000'000, 1.0, 80).find(" 99 %"), std::string::npos);
}

TEST(ProgressText, DoesWithoutATotal) {
  EXPECT_EQ(progress_text("replay", 210'000'000, 0, 2.0, 80), "replay  210.0 MB  105.0 MB/s");
}

TEST(ProgressText, DoesWithoutElapsedTime) {
  EXPECT_EQ(progress_text("a", 0, 100, 0.0, 20), "a   0 %  0.0 MB/s");
}

TEST(ProgressText, FitsItsWidth) {
  for (std::size_t width = 0; width < 120; ++width) {
    EXPECT_LE(progress_text("a long name of a file.csv", 1, 3, 1.0, width).size(), width);
    EXPECT_LE(progress_text("a long name of a file.csv", 1, 0, 1.0, width).size(), width);
  }
}

TEST(ProgressText, KeepsControlCharactersOut) {
  EXPECT_EQ(progress_text("a\x1b[2J", 1, 0, 1.0, 80).find('\x1b'), std::string::npos);
}

TEST(ShareText, ShowsShareAndTimeLeft) {
  // A quarter in 10 s leaves 30 s; 25 % of a bar of 20.
  EXPECT_EQ(share_text("calibrate", 0.25, 10.0, 49),
            "calibrate [#####---------------]  25 %  0:30 left");
}

TEST(ShareText, KeepsWithinZeroAndAHundredPercent) {
  EXPECT_EQ(share_text("a", 0.0, 5.0, 10), "a   0 %");
  EXPECT_EQ(share_text("a", -1.0, 5.0, 10), "a   0 %");
  EXPECT_NE(share_text("a", 1.5, 5.0, 80).find("100 %  0:00 left"), std::string::npos);
  for (std::size_t width = 0; width < 120; ++width) {
    EXPECT_LE(share_text("a long name of a file.csv", 0.3, 1.0, width).size(), width);
  }
}

/// The other side of a terminal, 60 columns wide.
class Terminal {
 public:
  Terminal() : outside_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    if (outside_ >= 0 && ::grantpt(outside_) == 0 && ::unlockpt(outside_) == 0) {
      inside_ = ::open(::ptsname(outside_), O_RDWR | O_NOCTTY);
      winsize size{};
      size.ws_col = 60;
      ::ioctl(inside_, TIOCSWINSZ, &size);
    }
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() {
    if (inside_ >= 0) {
      ::close(inside_);
    }
    ::close(outside_);
  }

  int inside() const { return inside_; }

  /// Everything written so far; nothing can be written afterwards.
  std::string shown() {
    ::close(std::exchange(inside_, -1));
    std::string text;
    std::array<char, 4096> part{};
    for (;;) {
      const ssize_t count = ::read(outside_, part.data(), part.size());
      if (count <= 0) {
        return text;
      }
      text.append(part.data(), static_cast<std::size_t>(count));
    }
  }

 private:
  int outside_;
  int inside_ = -1;
};

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

class ProgressOnTerminal : public testing::Test {
 protected:
  void SetUp() override {
    ::setenv("TERM", "xterm", 1);
    if (terminal_.inside() < 0) {
      GTEST_SKIP() << "no pseudo terminal";
    }
  }

  Terminal terminal_;
};

TEST_F(ProgressOnTerminal, DrawsAtALimitedRateAndErases) {
  const auto start = std::chrono::steady_clock::now();
  {
    Progress progress("replay", 1000, terminal_.inside());
    for (int i = 0; i < 350; ++i) {
      progress.update(500);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  const double elapsed_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const std::string shown = terminal_.shown();
  EXPECT_NE(shown.find("50 %"), std::string::npos) << shown;
  const std::size_t draws = count_of(shown, "replay");
  EXPECT_GE(draws, 1U);
  EXPECT_LE(static_cast<double>(draws), elapsed_s * 10.0 + 1.0);
  EXPECT_TRUE(shown.ends_with("\r\x1b[K"));
  EXPECT_EQ(shown.find('\n'), std::string::npos);
}

TEST_F(ProgressOnTerminal, DrawsShares) {
  {
    Progress progress("calibrate", 0, terminal_.inside());
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
    progress.update_share(0.5);
    progress.update_share(0.9);
  }
  const std::string shown = terminal_.shown();
  EXPECT_NE(shown.find("50 %"), std::string::npos) << shown;
  EXPECT_EQ(shown.find("90 %"), std::string::npos) << shown;
  EXPECT_TRUE(shown.ends_with("\r\x1b[K"));
}

TEST_F(ProgressOnTerminal, ShowsNothingForShortWork) {
  {
    Progress progress("replay", 1000, terminal_.inside());
    progress.update(500);
  }
  EXPECT_EQ(terminal_.shown(), "");
}

TEST_F(ProgressOnTerminal, RespectsADumbTerminal) {
  ::setenv("TERM", "dumb", 1);
  {
    Progress progress("replay", 1000, terminal_.inside());
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
    progress.update(500);
  }
  EXPECT_EQ(terminal_.shown(), "");
}

TEST(Progress, IsSilentWithoutATerminal) {
  ::setenv("TERM", "xterm", 1);
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  {
    Progress progress("replay", 1000, ends[1]);
    std::this_thread::sleep_for(std::chrono::milliseconds(120));
    progress.update(500);
  }
  ::close(ends[1]);
  char byte = 0;
  EXPECT_EQ(::read(ends[0], &byte, 1), 0);
  ::close(ends[0]);
}

}  // namespace
}  // namespace host_sim
