#include "firmware/app/status_light.hpp"

#include <gtest/gtest.h>

namespace app {
namespace {

using protocol::LifeState;

/// How often the light goes on in the two seconds after `from_s`.
int flashes(StatusLight& light, std::uint32_t from_s, LifeState state, bool at_fault) {
  int count = 0;
  bool before = light.lit(hal::seconds(from_s), state, at_fault);
  count += before ? 1 : 0;
  for (std::uint32_t ms = 1; ms < 2'000; ++ms) {
    const bool now = light.lit(hal::seconds(from_s) + hal::milliseconds(ms), state, at_fault);
    count += now && !before ? 1 : 0;
    before = now;
  }
  return count;
}

TEST(StatusLight, FlashesAsOftenAsTheLifeIsUsed) {
  StatusLight light;
  light.start({});
  EXPECT_EQ(flashes(light, 2, LifeState::inspect, false), 1);
  EXPECT_EQ(flashes(light, 4, LifeState::replace, false), 2);
  EXPECT_EQ(flashes(light, 6, LifeState::worn, false), 3);
}

TEST(StatusLight, IsLitWhileAllIsWell) {
  StatusLight light;
  light.start({});
  for (std::uint32_t ms = 0; ms < 10'000; ms += 7) {
    EXPECT_TRUE(light.lit(hal::milliseconds(ms), LifeState::normal, false));
  }
}

TEST(StatusLight, BlinksSlowlyAtAFaultAndFastToIdentify) {
  StatusLight light;
  light.start({});
  EXPECT_EQ(flashes(light, 2, LifeState::normal, true), 2);
  EXPECT_EQ(flashes(light, 4, LifeState::unknown, false), 2);
  light.identify(hal::seconds(6), 2);
  EXPECT_EQ(flashes(light, 6, LifeState::normal, false), 20);
  EXPECT_TRUE(light.lit(hal::milliseconds(8'050), LifeState::normal, false));
}

}  // namespace
}  // namespace app
