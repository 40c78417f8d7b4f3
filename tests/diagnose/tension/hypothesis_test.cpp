#include "host_sim/diagnose/tension/hypothesis.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace host_sim::diagnose::testing {
namespace {

Component part(std::string_view id) {
  for (const auto& effect : effects::tension_effects()) {
    if (effect->id() == id) {
      return {effect.get(), {}};
    }
  }
  return {};
}

TEST(Hypothesis, OfTwoThatAreHardToTellApartIsConfounded) {
  EXPECT_TRUE(confounded(std::vector{part("current_offset"), part("friction_load")}));
  EXPECT_TRUE(confounded(std::vector{part("friction_temperature"), part("friction_wear")}));
  EXPECT_FALSE(confounded(std::vector{part("friction_wear"), part("torque_ripple")}));
  EXPECT_FALSE(confounded(std::vector{part("friction_load")}));
  EXPECT_FALSE(confounded({}));
}

TEST(Hypothesis, OfTwoAtReversalsIsEntangled) {
  EXPECT_TRUE(entangled(std::vector{part("compliance"), part("slack")}));
  EXPECT_FALSE(entangled(std::vector{part("compliance"), part("friction_load")}));
}

}  // namespace
}  // namespace host_sim::diagnose::testing
