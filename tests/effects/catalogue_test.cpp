#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "host_sim/effects/counting_effect.hpp"
#include "host_sim/effects/life_effect.hpp"
#include "tests/effects/trace.hpp"

namespace host_sim::effects::testing {
namespace {

using ::testing::ElementsAre;

template <typename Effects>
std::vector<std::string> ids_of(const Effects& effects) {
  std::vector<std::string> ids;
  for (const auto& effect : effects) {
    ids.emplace_back(effect->id());
  }
  return ids;
}

TEST(Catalogue, HoldsTheTensionEffectsInOrder) {
  EXPECT_THAT(ids_of(tension_effects()),
              ElementsAre("bend_angle", "compliance", "current_offset", "filter_lag",
                          "friction_load", "friction_position", "friction_preload",
                          "friction_temperature", "friction_velocity", "friction_wear",
                          "gear_asymmetry", "presliding", "slack", "torque_gain", "torque_ripple"));
}

TEST(Catalogue, HoldsTheCountingAndTheLifeEffectsInOrder) {
  EXPECT_THAT(ids_of(counting_effects()), ElementsAre("small_cycles", "undersampling"));
  EXPECT_THAT(ids_of(life_effects()),
              ElementsAre("ageing", "bending_fatigue", "endurance_limit", "load_sequence",
                          "lot_frailty", "mean_stress", "second_mode"));
}

std::set<std::string> all_ids() {
  std::set<std::string> ids;
  for (const auto& some :
       {ids_of(tension_effects()), ids_of(counting_effects()), ids_of(life_effects())}) {
    ids.insert(some.begin(), some.end());
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

template <typename Effect>
void expect_told(const Effect& effect) {
  EXPECT_FALSE(effect.term().empty()) << effect.id();
  EXPECT_FALSE(effect.equation().empty()) << effect.id();
  EXPECT_FALSE(effect.life_consequence().empty()) << effect.id();
  EXPECT_FALSE(effect.separations().empty()) << effect.id();
  const std::set<std::string> ids = all_ids();
  for (const Separation& separation : effect.separations()) {
    EXPECT_TRUE(ids.contains(std::string(separation.other))) << separation.other;
    EXPECT_NE(separation.other, effect.id());
    EXPECT_FALSE(separation.experiment.empty()) << effect.id();
  }
}

template <typename Effect>
void expect_parameters(const Effect& effect) {
  ASSERT_FALSE(effect.parameters().empty()) << effect.id();
  for (const Parameter& parameter : effect.parameters()) {
    expect_sound(parameter);
    expect_unit_in_name(parameter);
  }
}

/// Shape parameters come last, and each value is within its bounds.
template <typename Effect>
void expect_shapes(const Effect& effect) {
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

TEST(Catalogue, SaysAllThatIsKnownOfATensionEffect) {
  for (const auto& effect : tension_effects()) {
    expect_told(*effect);
    expect_parameters(*effect);
    expect_shapes(*effect);
  }
}

TEST(Catalogue, SaysAllThatIsKnownOfALifeEffect) {
  for (const auto& effect : life_effects()) {
    expect_told(*effect);
    expect_parameters(*effect);
    expect_shapes(*effect);
  }
}

TEST(Catalogue, SaysAllThatIsKnownOfACountingEffect) {
  for (const auto& effect : counting_effects()) {
    expect_told(*effect);
    expect_sound(effect->parameter());
    expect_unit_in_name(effect->parameter());
  }
}

/// One session at one pose, one temperature and so few cycles that they are one.
recording::Covariates one_session() {
  recording::Covariates c = trace();
  for (auto* const same :
       {&c.cycle, &c.bend_angle_rad, &c.sheath_temperature_C, &c.winding_temperature_C}) {
    std::ranges::fill(*same, same->front());
  }
  return c;
}

/// Whether all that the columns hold is a gain and a friction: one value while pulling, another
/// while letting go.
bool is_gain_and_friction(const std::vector<std::vector<double>>& columns,
                          const std::vector<double>& direction) {
  for (const std::vector<double>& column : columns) {
    std::map<double, double> values;
    for (std::size_t i = 0; i < column.size(); ++i) {
      const double value = values.emplace(direction[i], column[i]).first->second;
      if (std::abs(column[i] - value) > 1e-12) {
        return false;
      }
    }
  }
  return true;
}

TEST(Catalogue, SaysWhichEffectsShiftSessionsOnly) {
  const recording::Covariates session = one_session();
  Baseline baseline = kBaseline;
  baseline.poses_rad = {session.bend_angle_rad.front()};
  for (const auto& effect : tension_effects()) {
    bool in_every_shape = true;
    for (const std::vector<double>& shape : effect->shapes()) {
      in_every_shape =
          in_every_shape &&
          is_gain_and_friction(columns(effect->id(), session, shape, baseline), session.direction);
    }
    EXPECT_EQ(effect->shifts_sessions(), in_every_shape) << effect->id();
  }
}

TEST(Catalogue, GivesOneColumnForEachLinearParameterInEachShape) {
  const recording::Covariates c = trace();
  for (const auto& effect : tension_effects()) {
    for (const std::vector<double>& shape : effect->shapes()) {
      const Signature signature = effect->signature(c, kBaseline, shape);
      EXPECT_EQ(signature.shape, shape);
      EXPECT_EQ(signature.columns.size(), effect->parameters().size() - shape.size())
          << effect->id();
      for (const std::vector<double>& column : signature.columns) {
        EXPECT_EQ(column.size(), c.samples()) << effect->id();
      }
    }
  }
}

TEST(Catalogue, EveryShapeIsASignatureOfItsOwn) {
  const recording::Covariates c = trace();
  for (const auto& effect : tension_effects()) {
    if (effect->id() == "compliance" || effect->id() == "slack") {
      continue;  // steps: neighbouring shapes agree where no sample lies between
    }
    std::set<std::vector<std::vector<double>>> seen;
    for (const std::vector<double>& shape : effect->shapes()) {
      EXPECT_TRUE(seen.insert(effect->signature(c, kBaseline, shape).columns).second)
          << effect->id();
    }
  }
}

}  // namespace
}  // namespace host_sim::effects::testing
