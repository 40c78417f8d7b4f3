#include <gtest/gtest.h>

#include "hal/files/text.hpp"

namespace host_sim {

using hal::files::other_unit;

namespace {

TEST(OtherUnit, FindsTheForeignSuffix) {
  EXPECT_EQ(other_unit("input_tension_kN", "input_tension_N", "N"), "kN");
  EXPECT_EQ(other_unit("tendon_velocity_mm_s", "tendon_velocity_m_s", "m_s"), "mm_s");
  EXPECT_EQ(other_unit("time", "time_s", "s"), "");
  EXPECT_EQ(other_unit("gear_ratio_percent", "gear_ratio", ""), "percent");
}

TEST(OtherUnit, IsNoneForTheNameItselfAndForOtherNames) {
  EXPECT_EQ(other_unit("time_s", "time_s", "s"), std::nullopt);
  EXPECT_EQ(other_unit("timer_s", "time_s", "s"), std::nullopt);
  EXPECT_EQ(other_unit("tim", "time_s", "s"), std::nullopt);
  EXPECT_EQ(other_unit("", "time_s", "s"), std::nullopt);
  EXPECT_EQ(other_unit("time_s;tension_N", "time_s", "s"), std::nullopt);
}

}  // namespace
}  // namespace host_sim
