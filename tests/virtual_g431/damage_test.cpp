#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <numbers>

#include "tests/virtual_g431/image.hpp"
#include "tests/virtual_g431/reference.hpp"
#include "tests/virtual_g431/tester.hpp"

namespace virtual_g431 {
namespace {

using ::testing::IsEmpty;

/// Zeros of the three amplifiers, as unequal as a board has them.
constexpr PhaseCounts kZeros{2061, 2040, 2049};

/// A motor that turns at 20 Hz with an amplitude in counts.
PhaseCounts phases(double time_s, double amplitude) {
  PhaseCounts counts = kZeros;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double angle = 2 * std::numbers::pi * (20 * time_s - static_cast<double>(i) / 3);
    counts[i] += static_cast<std::uint32_t>(std::lround(amplitude * std::cos(angle)));
  }
  return counts;
}

class Damage : public Image {
 protected:
  /// Seconds in all; the motor stands still for the last half.
  static double duration_s() {
    const char* asked = std::getenv("TENDONLIFE_VIRTUAL_SECONDS");
    return asked == nullptr ? 3 : std::max(3.0, std::atof(asked));
  }
  /// What was heard, as candump -L writes it.
  static void write_log(const Board& board, const char* path) {
    std::ofstream out(path);
    for (const auto& [at, frame] : board.can.heard) {
      const std::uint64_t us = at / kMicrosecond;
      out << '(' << us / 1'000'000 << '.' << std::setw(6) << std::setfill('0') << us % 1'000'000
          << ") can0 " << std::hex << std::uppercase << std::setw(frame.extended ? 8 : 3)
          << frame.id << '#';
      for (const std::byte byte : frame.payload()) {
        out << std::setw(2) << std::to_integer<unsigned>(byte);
      }
      out << std::dec << '\n';
    }
  }
  /// 1 .. 5 A at 31 Hz and 7 Hz for a while, then at rest.
  static PhaseCounts profile(Ticks time) {
    const double time_s = to_ms(time) / 1000;
    const double share = std::sin(2 * std::numbers::pi * 31 * time_s) +
                         0.4 * std::sin(2 * std::numbers::pi * 7 * time_s);
    const bool runs = time_s > 0.1 && time_s < duration_s() - 0.5;
    return runs ? phases(time_s, 102 + 48 * share) : kZeros;
  }
};

/// Every status carries what the host counts for the same counts up to a time before the frame.
TEST_F(Damage, IsThatOfTheHostToTheLastDigit) {
  Board board(contents);
  board.converters.signal = profile;
  board.power_on();
  board.run(static_cast<Ticks>(duration_s()) * kSecond);
  ASSERT_THAT(board.broken_rules(), IsEmpty());
  ASSERT_THAT(board.resets, IsEmpty());

  Reference reference(kZeros);
  std::size_t played = 0;
  std::vector<std::uint32_t> last_readings;
  std::size_t compared = 0;
  std::uint32_t damage_ppb = 0;
  for (const CanController::Heard& heard : board.can.heard) {
    const auto status = protocol::decode<protocol::LifeStatus>(heard.frame);
    if (heard.frame.id != protocol::id_of<protocol::LifeStatus>(kNode) || !status) {
      continue;
    }
    last_readings.clear();
    for (; played < board.periods.size() && board.periods[played].at < heard.at; ++played) {
      reference.period(board.periods[played].counts);
    }
    if (board.agenda.now() - heard.at < 300 * kMillisecond) {
      EXPECT_EQ(status->damage_ppb, reference.damage_ppb());
      ++compared;
    }
    EXPECT_GE(status->damage_ppb, damage_ppb);
    damage_ppb = status->damage_ppb;
  }
  EXPECT_GE(compared, 2u);
  EXPECT_GT(damage_ppb, 1000u);
  write_log(board, G431_LOG);
  std::ofstream(G431_LOG ".damage_ppb") << reference.damage_ppb() << '\n';

  expect_damage(board, reference.damage());
}

/// One wrong count of one converter in the zeros, or one lost sample, would show.
TEST_F(Damage, ChangesWithASingleCount) {
  const auto damage_with_zero = [](std::uint32_t zero) {
    Reference reference({zero, kZeros[1], kZeros[2]});
    for (std::uint32_t i = 0; i < 30'000; ++i) {
      reference.period(profile(i * 100 * kMicrosecond));
    }
    return reference.damage_ppb();
  };
  EXPECT_NE(damage_with_zero(kZeros[0]), damage_with_zero(kZeros[0] + 1));
}

}  // namespace
}  // namespace virtual_g431
