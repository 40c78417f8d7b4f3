// What the image takes of a period, for check_budget.py.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>

#include "tests/virtual_g431/image.hpp"

namespace virtual_g431 {
namespace {

using ::testing::IsEmpty;

constexpr unsigned kControl = exception::kInterrupt0 + 18;
/// 1.5 cycles an instruction, 12 + 10 for the exception.
constexpr double kPeriodCycles = 17'000;
double cycles(std::uint64_t instructions) {
  return 1.5 * static_cast<double>(instructions) + 22;
}

/// Three phases that add up to nothing, of an amplitude of so many counts.
PhaseCounts phases(std::uint32_t counts) {
  return {2048 + 2 * (counts / 2), 2048 - counts / 2, 2048 - counts / 2};
}

class Instructions : public Image {
 protected:
  struct Figures {
    Core::Count control, settle;
  };

  /// Three seconds of the signal, and what the bus is given each millisecond.
  Figures run(const std::function<PhaseCounts(Ticks)>& signal, int frames_each_ms) {
    contents = FlashContents();
    SetUp();
    Board board(contents);
    // The zeros are measured at rest.
    board.converters.signal = [&](Ticks time) {
      return time < 300 * kMillisecond ? kAtRest : signal(time);
    };
    board.power_on();
    board.run(400 * kMillisecond);
    board.core->forget_counts();
    for (int ms = 0; ms < 2'000; ++ms) {
      for (int i = 0; i < frames_each_ms; ++i) {
        board.can.send({.id = protocol::id_of<protocol::Command>(kNode)});
      }
      board.run(kMillisecond);
    }
    EXPECT_THAT(board.broken_rules(), IsEmpty());
    EXPECT_THAT(board.resets, IsEmpty());
    return {board.core->instructions(kControl), board.core->instructions(exception::kPendSv)};
  }
};

TEST_F(Instructions, OfControlAndSettling) {
  const auto sine = [](Ticks time) {
    const double angle = 2 * std::numbers::pi * 2 * to_ms(time) / 1000;
    return phases(static_cast<std::uint32_t>(std::lround(98 + 60 * std::sin(angle))));
  };
  // A turning point in each period: as many cycles close as can.
  std::mt19937 random(1);
  const auto noise = [&random](Ticks) {
    return phases(34 + static_cast<std::uint32_t>(random() % 136));
  };
  const Figures calm = run(sine, 0);
  const Figures rough = run(noise, 15);
  const auto worst = [&](auto part) { return std::max((calm.*part).worst, (rough.*part).worst); };
  const std::uint64_t control = worst(&Figures::control);
  const std::uint64_t settle = worst(&Figures::settle);
  const std::uint64_t periods = calm.control.calls;
  const double left = kPeriodCycles - cycles(control) - cycles(settle);
  std::cout << "control " << calm.control.total / periods << " .. " << control << ", settling "
            << calm.settle.total / periods << " .. " << settle << " instructions; at worst " << left
            << " of 17,000 cycles are left\n";
  EXPECT_GT(left, 0);
  std::ofstream(G431_MEASURED) << "{\n  \"control_sine\": " << calm.control.total / periods
                               << ",\n  \"control_worst\": " << control
                               << ",\n  \"settle_sine\": " << calm.settle.total / periods
                               << ",\n  \"settle_worst\": " << settle
                               << ",\n  \"both_worst\": " << control + settle << "\n}\n";
}

}  // namespace
}  // namespace virtual_g431
