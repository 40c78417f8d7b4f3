#include "firmware/app/bus_watch.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hal/error.hpp"

namespace app {
namespace {

/// A controller that is off from go_off() until `stubborn` recoveries have been asked for.
class Controller {
 public:
  explicit Controller(const hal::Time& now) : now_(now) {}
  hal::Error send(const hal::CanFrame&) { return off ? hal::Error::off : hal::Error::none; }
  std::optional<hal::CanFrame> receive() { return std::nullopt; }
  hal::CanStatus status() {
    hal::CanStatus status;
    status.state = off ? hal::CanState::off : hal::CanState::active;
    return status;
  }
  hal::Error recover() {
    asked_ms.push_back(now_.us / 1000);
    off = asked_ms.size() < stubborn;
    return hal::Error::none;
  }

  bool off = false;
  std::size_t stubborn = 1;
  std::vector<std::uint64_t> asked_ms;

 private:
  const hal::Time& now_;
};

TEST(BusWatch, AsksAgainWithPausesThatDouble) {
  hal::Time now{};
  Controller controller(now);
  BusWatch watch(controller);
  using Turn = BusWatch<Controller>::Turn;
  controller.off = true;
  controller.stubborn = 10;
  EXPECT_EQ(watch.look(now), Turn::went_off);
  Turn last = Turn::none;
  for (std::uint32_t ms = 1; ms < 60'000 && last != Turn::came_back; ++ms) {
    now = hal::milliseconds(ms);
    last = watch.look(now);
  }
  EXPECT_EQ(last, Turn::came_back);
  EXPECT_EQ(controller.asked_ms, (std::vector<std::uint64_t>{100, 300, 700, 1'500, 3'100, 6'300,
                                                             12'700, 22'700, 32'700, 42'700}));
}

TEST(BusWatch, ABusThatGoesOffAgainSoonWaitsLonger) {
  hal::Time now{};
  Controller controller(now);
  BusWatch watch(controller);
  const auto run_to = [&](std::uint32_t ms) {
    while (now < hal::milliseconds(ms)) {
      now = now + hal::milliseconds(1);
      (void)watch.look(now);
    }
  };
  controller.off = true;
  run_to(500);  // off at 1, asked at 101
  controller.off = true;
  controller.stubborn = 2;
  run_to(2'000);  // off at 501, asked 400 ms later
  controller.off = true;
  controller.stubborn = 3;
  now = hal::seconds(60);
  run_to(61'000);  // long after: 100 ms
  EXPECT_EQ(controller.asked_ms, (std::vector<std::uint64_t>{101, 901, 60'101}));
}

}  // namespace
}  // namespace app
