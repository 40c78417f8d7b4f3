#include "host_sim/diagnose/tension/hypothesis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/diagnose/tension/noisy_sessions.hpp"

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

constexpr double kHidden_N = 1.7;

std::vector<Session> with_preload() {
  return noisy_sessions(small_design(), {.sample_sd = 0.005, .effect = preload(kHidden_N)}, 6);
}

/// ln evidence of an effect alone at shapes.
std::vector<double> evidences(const Evidence& evidence, const effects::TensionEffect& effect,
                              const std::vector<std::vector<double>>& shapes) {
  GramOptions options = evidence.options;
  options.wanted = {{.effect = &effect, .shapes = shapes}};
  const Grams grams = gram_of(evidence.sessions, options);
  const auto grid = scatter_grid(grams, evidence.sample_sd);
  std::vector<double> values;
  for (const GramLayout::Block& block : grams.layout.effects.front().blocks) {
    values.push_back(log_evidence(grid, terms_of(grams.layout.effects.front(), block),
                                  grams.response(), grams.samples()));
  }
  return values;
}

ShapeSearch searched(const Evidence& evidence, std::string_view id) {
  const effects::TensionEffect& effect = *component(id).effect;
  return search_shape(evidence, effect, evidences(evidence, effect, effect.shapes()), {});
}

TEST(MeanOverShapes, IsTheLogarithmOfTheMean) {
  const std::vector<double> logs{std::log(2.0) + 900, std::log(4.0) + 900, std::log(6.0) + 900};
  EXPECT_NEAR(mean_over_shapes(logs), std::log(4.0) + 900, 1e-12);
}

TEST(ShapeSearch, GoesOnBetweenTheShapesOfTheCatalogue) {
  const std::vector<Session> sessions = with_preload();
  const Evidence evidence = evidence_of(sessions, 0.005);
  const ShapeSearch found = searched(evidence, "friction_preload");
  EXPECT_EQ(found.best.effect->id(), "friction_preload");
  // The catalogue has 1.2 and 2.5 N.
  EXPECT_NEAR(found.best.shape.at(0), kHidden_N, 0.15);
  const effects::TensionEffect& effect = *found.best.effect;
  EXPECT_NEAR(found.best_log_evidence, evidences(evidence, effect, {found.best.shape})[0], 1e-6);
  EXPECT_GE(found.best_log_evidence, evidences(evidence, effect, {{1.2}})[0]);
  EXPECT_GE(found.best_log_evidence, evidences(evidence, effect, {{2.5}})[0]);
}

TEST(ShapeSearch, ChargesForTheShapesThatDoNotFit) {
  const std::vector<Session> sessions = with_preload();
  const Evidence evidence = evidence_of(sessions, 0.005);
  const ShapeSearch found = searched(evidence, "friction_preload");
  // Between one shape of nine alone, and all of them alike.
  EXPECT_LT(found.log_evidence, found.best_log_evidence);
  EXPECT_GT(found.log_evidence, found.best_log_evidence - std::log(9.0) - 4);
}

TEST(ShapeSearch, StaysAtWholeHarmonics) {
  const std::vector<Session> sessions = with_preload();
  const ShapeSearch found = searched(evidence_of(sessions, 0.005), "torque_ripple");
  EXPECT_EQ(found.best.shape.at(0), std::round(found.best.shape.at(0)));
}

TEST(ShapeSearch, NeverMixesTwoSigns) {
  const std::vector<Session> sessions = with_preload();
  const ShapeSearch found = searched(evidence_of(sessions, 0.005), "current_offset");
  EXPECT_TRUE(std::isfinite(found.log_evidence));
  EXPECT_NE(found.best.shape.at(0), 0);
}

}  // namespace
}  // namespace host_sim::diagnose::testing
