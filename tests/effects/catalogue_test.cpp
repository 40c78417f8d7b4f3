#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "host_sim/effects/counting_effect.hpp"
#include "host_sim/effects/life_effect.hpp"
#include "host_sim/effects/tension/force_model.hpp"

namespace host_sim::effects::testing {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> ids_of_tension() {
  std::vector<std::string> ids;
  for (const TensionEffect* const effect : tension_effects()) {
    ids.emplace_back(effect->id);
  }
  return ids;
}

std::vector<std::string> ids_of_lives() {
  std::vector<std::string> ids;
  for (const auto& effect : life_effects()) {
    ids.emplace_back(effect->id());
  }
  return ids;
}

TEST(Catalogue, HoldsTheTensionEffectsInOrder) {
  EXPECT_THAT(
      ids_of_tension(),
      ElementsAre("bend_angle", "channel_delay", "compliance", "current_offset", "filter_lag",
                  "friction_load", "friction_position", "friction_preload", "friction_temperature",
                  "friction_velocity", "friction_wear", "gear_asymmetry", "load_cell_zero",
                  "presliding", "slack", "torque_gain", "torque_ripple"));
  EXPECT_EQ(tension_effect("slack")->term, "backlash or dead zone");
  EXPECT_EQ(tension_effect("giving_sheath"), nullptr);
}

TEST(Catalogue, HoldsTheLifeEffectsInOrder) {
  EXPECT_THAT(ids_of_lives(),
              ElementsAre("ageing", "bending_fatigue", "endurance_limit", "load_sequence",
                          "lot_frailty", "mean_stress", "second_mode"));
}

std::set<std::string> all_ids() {
  std::set<std::string> ids;
  for (const auto& some : {ids_of_tension(), ids_of_lives()}) {
    ids.insert(some.begin(), some.end());
  }
  for (const CountingEffect& effect : kCountingEffects) {
    ids.emplace(effect.id);
  }
  return ids;
}

void expect_sound(const Parameter& parameter) {
  EXPECT_FALSE(parameter.name.empty());
  EXPECT_FALSE(parameter.unit.empty()) << parameter.name;
  EXPECT_LT(parameter.minimum, parameter.maximum) << parameter.name;
  EXPECT_GE(parameter.typical, parameter.minimum) << parameter.name;
  EXPECT_LE(parameter.typical, parameter.maximum) << parameter.name;
}

/// A name ends in its unit, written with underscores, where it has one.
void expect_unit_in_name(const Parameter& parameter) {
  if (parameter.unit == "1") {
    return;
  }
  std::string suffix = "_";
  for (const char letter : parameter.unit) {
    suffix += letter == '/' ? '_' : letter;
  }
  EXPECT_TRUE(parameter.name.ends_with(suffix)) << parameter.name << " in " << parameter.unit;
}

void expect_separations(std::string_view id, std::span<const Separation> separations) {
  EXPECT_FALSE(separations.empty()) << id;
  const std::set<std::string> ids = all_ids();
  for (const Separation& separation : separations) {
    EXPECT_TRUE(ids.contains(std::string(separation.other))) << separation.other;
    EXPECT_NE(separation.other, id);
    EXPECT_FALSE(separation.experiment.empty()) << id;
  }
}

TEST(Catalogue, SaysAllThatIsKnownOfATensionEffect) {
  for (const TensionEffect* const effect : tension_effects()) {
    EXPECT_FALSE(effect->term.empty()) << effect->id;
    EXPECT_FALSE(effect->life_consequence.empty()) << effect->id;
    expect_separations(effect->id, effect->separations);
    for (const TableKey& key : effect->table) {
      EXPECT_TRUE(key.number.name.ends_with(key.number.unit)) << key.number.name;
    }
  }
}

const ForceScales kScales{.speed_m_s = 0.1,
                          .stroke_m = 0.2,
                          .force_N = 10,
                          .input_N = 12,
                          .turn_over_m_s = 0.005,
                          .step_s = 0.01,
                          .cycles = 10000,
                          .poses_rad = {1.5, 3}};

TEST(Catalogue, EachLawStartsWithinItsBounds) {
  for (const ForceTerm term : kForceTerms) {
    const ForceLaw& law = law_of(term);
    EXPECT_FALSE(law.equation.empty()) << law.id();
    EXPECT_FALSE(law.term().empty()) << law.id();
    EXPECT_EQ(law.outside, tension_effect(law.id()) == nullptr) << law.id();
    const auto parameters = parameters_of(term, kScales);
    ASSERT_FALSE(parameters.empty()) << law.id();
    for (const ForceParameter& parameter : parameters) {
      ASSERT_FALSE(parameter.starts.empty()) << law.id();
      EXPECT_LT(parameter.minimum, parameter.maximum) << parameter.name;
      for (const double start : parameter.starts) {
        EXPECT_GE(start, parameter.minimum) << parameter.name;
        EXPECT_LE(start, parameter.maximum) << parameter.name;
        EXPECT_GE(parameter.usual, parameter.minimum < 0 ? parameter.minimum : 0) << parameter.name;
        EXPECT_LE(std::abs(parameter.usual), parameter.maximum) << parameter.name;
      }
    }
  }
}

/// Values of shape come last, each within its bounds.
void expect_shapes(const LifeEffect& effect) {
  ASSERT_FALSE(effect.shapes().empty()) << effect.id();
  const std::span<const Parameter> parameters = effect.parameters();
  std::set<std::vector<double>> distinct;
  for (const std::vector<double>& shape : effect.shapes()) {
    ASSERT_EQ(shape.size(), effect.shapes().front().size()) << effect.id();
    EXPECT_TRUE(distinct.insert(shape).second) << effect.id();
    for (std::size_t i = 0; i < shape.size(); ++i) {
      const Parameter& parameter = parameters[parameters.size() - shape.size() + i];
      EXPECT_GE(shape[i], parameter.minimum) << effect.id() << parameter.name;
      EXPECT_LE(shape[i], parameter.maximum) << effect.id() << parameter.name;
    }
  }
}

TEST(Catalogue, SaysAllThatIsKnownOfALifeEffect) {
  for (const auto& effect : life_effects()) {
    EXPECT_FALSE(effect->term().empty()) << effect->id();
    EXPECT_FALSE(effect->equation().empty()) << effect->id();
    EXPECT_FALSE(effect->life_consequence().empty()) << effect->id();
    expect_separations(effect->id(), effect->separations());
    ASSERT_FALSE(effect->parameters().empty()) << effect->id();
    for (const Parameter& parameter : effect->parameters()) {
      expect_sound(parameter);
      expect_unit_in_name(parameter);
    }
    expect_shapes(*effect);
  }
}

}  // namespace
}  // namespace host_sim::effects::testing
