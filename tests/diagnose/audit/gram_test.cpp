#include "host_sim/diagnose/gram.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>

#include "tests/diagnose/audit/sessions.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<Session> few_sessions() {
  return testing::sessions_of({{.bend_angle_rad = 1.5, .start_cycle = 10, .duration_s = 1},
                               {.bend_angle_rad = 3, .mean_N = 40, .duration_s = 2}});
}

Eigen::Index index(std::size_t column) {
  return static_cast<Eigen::Index>(column);
}

/// The sum of c(t) d(t) over the samples, column by column and term by term.
double product(const Eigen::MatrixXd& columns, Eigen::Index one, Eigen::Index other) {
  double sum = 0;
  for (Eigen::Index t = 0; t < columns.rows(); ++t) {
    sum += columns(t, one) * columns(t, other);
  }
  return sum;
}

void expect_products(const Eigen::MatrixXd& gram, const Eigen::MatrixXd& columns) {
  ASSERT_EQ(gram.rows(), columns.cols());
  for (Eigen::Index i = 0; i < gram.rows(); ++i) {
    for (Eigen::Index j = 0; j < gram.cols(); ++j) {
      const double scale = columns.col(i).norm() * columns.col(j).norm();
      ASSERT_NEAR(gram(i, j), product(columns, i, j), 1e-12 * scale) << i << ' ' << j;
    }
  }
}

TEST(GramLayout, StartsWithInterceptAndFrictionAndEndsWithTheResidual) {
  const GramLayout layout = layout_of(few_sessions(), testing::baseline());
  EXPECT_EQ(layout.label(0), "intercept");
  EXPECT_EQ(layout.label(1), "friction");
  EXPECT_EQ(layout.label(layout.residual()), "residual");
  EXPECT_EQ(layout.residual() + 1, layout.size());
}

TEST(GramLayout, LabelsEachColumnOnceByEffectShapeAndColumn) {
  const GramLayout layout = layout_of(few_sessions(), testing::baseline());
  std::set<std::string> labels;
  for (std::size_t i = 0; i < layout.size(); ++i) {
    EXPECT_TRUE(labels.insert(layout.label(i)).second) << layout.label(i);
  }
  const GramLayout::Effect& position = layout.of("friction_position");
  ASSERT_EQ(position.blocks.size(), 6U);
  EXPECT_EQ(position.blocks[1].count, 16U);
  EXPECT_THAT(position.blocks[1].shape, ElementsAre(0.02));
  EXPECT_EQ(layout.label(position.blocks[1].first + 2), "friction_position[1].2");
  EXPECT_THROW(static_cast<void>(layout.of("no_such_effect")), std::out_of_range);
}

TEST(GramLayout, LeavesOutWhatOneSessionCannotGive) {
  std::vector<Session> sessions = few_sessions();
  sessions[1].covariates.sheath_temperature_C.clear();
  const GramLayout layout = layout_of(sessions, testing::baseline());
  EXPECT_TRUE(layout.of("friction_temperature").blocks.empty());
  EXPECT_THAT(layout.of("friction_temperature").missing, HasSubstr("sheath_temperature_C"));
  EXPECT_EQ(layout.of("friction_wear").missing, "");
}

TEST(GramLayout, OfNoSessionsHasNoSignatures) {
  const GramLayout layout = layout_of({}, testing::baseline());
  EXPECT_EQ(layout.size(), 3U);
  EXPECT_THAT(layout.of("slack").missing, HasSubstr("recordings"));
}

TEST(Poses, CountAnglesWithinADegreeAsOne) {
  const std::vector<Session> sessions =
      testing::sessions_of({{.bend_angle_rad = 3, .duration_s = 1},
                            {.bend_angle_rad = 1.5, .duration_s = 1},
                            {.bend_angle_rad = 3.01, .duration_s = 1},
                            {.bend_angle_rad = 3.1, .duration_s = 1}});
  EXPECT_THAT(poses_of(sessions),
              ElementsAre(DoubleNear(1.5, 1e-12), DoubleNear(3, 1e-12), DoubleNear(3.1, 1e-12)));
}

TEST(Columns, AreInterceptFrictionAndResidualByHand) {
  std::vector<Session> sessions = few_sessions();
  recording::Covariates& c = sessions[0].covariates;
  c.direction[4] = -1;
  c.current_tension_N[4] = 50;
  c.output_tension_N[4] = 60;
  const GramLayout layout = layout_of(sessions, testing::baseline());
  const Eigen::MatrixXd columns = columns_of(sessions[0], layout, testing::baseline());
  EXPECT_EQ(columns(4, 0), 1);
  EXPECT_EQ(columns(4, 1), 1.5);
  EXPECT_NEAR(columns(4, index(layout.residual())), std::log(1.2) - 0.128 * 1.5, 1e-14);
  EXPECT_NEAR(columns(7, index(layout.residual())), 0, 1e-14);
}

TEST(Gram, IsAllInnerProductsOfASession) {
  std::vector<Session> sessions = few_sessions();
  sessions[1].covariates.output_tension_N[9] *= 1.1;
  const Grams grams = gram_of(sessions, {.probes = {}, .baseline = testing::baseline()});
  ASSERT_EQ(grams.sessions.size(), 2U);
  EXPECT_EQ(grams.sessions[1].session, "s1");
  EXPECT_EQ(grams.sessions[0].samples, 50U);
  EXPECT_NEAR(grams.sessions[1].bend_angle_rad, 3, 1e-12);
  ASSERT_EQ(grams.baseline.poses_rad.size(), 2U);
  for (std::size_t s = 0; s < 2; ++s) {
    expect_products(grams.sessions[s].gram, columns_of(sessions[s], grams.layout, grams.baseline));
  }
}

TEST(Gram, WeighsAndThenWhitensBeforeItSums) {
  const std::vector<Session> sessions = few_sessions();
  std::vector<std::vector<double>> weights;
  for (const Session& session : sessions) {
    weights.emplace_back(session.covariates.samples(), 1.0);
  }
  weights[0][3] = 0.25;
  const Grams grams = gram_of(
      sessions,
      {.probes = {}, .baseline = testing::baseline(), .autocorrelation = 0.6, .weights = weights});
  Eigen::MatrixXd plain = columns_of(sessions[0], grams.layout, grams.baseline);
  plain.row(3) *= 0.5;
  Eigen::MatrixXd expected = plain;
  expected.row(0) = 0.8 * plain.row(0);
  for (Eigen::Index t = 1; t < plain.rows(); ++t) {
    expected.row(t) = plain.row(t) - 0.6 * plain.row(t - 1);
  }
  expect_products(grams.sessions[0].gram, expected);
  EXPECT_DOUBLE_EQ(grams.sessions[0].log_weights, std::log(0.25));
}

TEST(Gram, IsTheSameForAnyNumberOfThreads) {
  const std::vector<Session> sessions = testing::sessions_of(testing::one_pose());
  const Grams one =
      gram_of(sessions, {.probes = {}, .baseline = testing::baseline(), .threads = 1});
  const Grams three =
      gram_of(sessions, {.probes = {}, .baseline = testing::baseline(), .threads = 3});
  for (std::size_t s = 0; s < sessions.size(); ++s) {
    EXPECT_TRUE(one.sessions[s].gram == three.sessions[s].gram) << s;
  }
}

TEST(Gram, OfSignaturesThatWereKeptIsTheSameToTheBit) {
  const auto sessions = few_sessions();
  GramOptions options{.probes = {}, .baseline = testing::baseline()};
  effects::Baseline other = options.baseline;
  other.friction_coefficient *= 1.1;
  const Grams anew = gram_of(sessions, options);
  GramOptions of_other = options;
  of_other.baseline = other;
  const Grams other_anew = gram_of(sessions, of_other);
  options.kept = of_other.kept = std::make_shared<KeptSignatures>(sessions.size());
  for (int round = 0; round < 2; ++round) {
    for (int again = 0; again < 2; ++again) {
      const Grams kept = gram_of(sessions, options);
      for (std::size_t i = 0; i < sessions.size(); ++i) {
        EXPECT_EQ(kept.sessions[i].gram, anew.sessions[i].gram);
      }
    }
    const Grams kept = gram_of(sessions, of_other);
    for (std::size_t i = 0; i < sessions.size(); ++i) {
      EXPECT_EQ(kept.sessions[i].gram, other_anew.sessions[i].gram);
    }
  }
}

TEST(Gram, TakesProductsThatAreKnownFromAnotherLayout) {
  const auto sessions = few_sessions();
  GramOptions options{.probes = {}, .baseline = testing::baseline()};
  const Grams whole = gram_of(sessions, options);
  const GramLayout::Effect& load = whole.layout.of("friction_load");
  const GramLayout::Effect& position = whole.layout.of("friction_position");
  options.wanted = {{.effect = load.effect, .shapes = {{0.3}, load.blocks[2].shape}},
                    {.effect = position.effect, .shapes = {position.blocks[1].shape}},
                    {.effect = load.effect, .shapes = {load.blocks[2].shape}}};
  const Grams grams = gram_of(sessions, options, &whole);
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    expect_products(grams.sessions[i].gram, columns_of(sessions[i], grams.layout, grams.baseline));
  }
  options.baseline.friction_coefficient *= 1.1;
  const Grams of_another = gram_of(sessions, options, &whole);
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    expect_products(of_another.sessions[i].gram,
                    columns_of(sessions[i], of_another.layout, of_another.baseline));
  }
}

TEST(Gram, TakesProductsOfProbesThatAreKnownForAnyBaseline) {
  const auto sessions = few_sessions();
  GramOptions options{.wanted = {}, .probes = probes_of(sessions), .baseline = testing::baseline()};
  const Grams known = gram_of(sessions, options);
  options.wanted = {whole_catalogue().front()};
  options.probes.erase(options.probes.begin());
  options.probes.back().edges.front() *= 1.01;
  options.baseline.friction_coefficient *= 1.1;
  const Grams grams = gram_of(sessions, options, &known);
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    expect_products(grams.sessions[i].gram, columns_of(sessions[i], grams.layout, grams.baseline));
  }
}

TEST(Gram, RefusesWeightsOfAnotherLength) {
  const std::vector<Session> sessions = few_sessions();
  const std::vector<std::vector<double>> one(1);
  const std::vector<std::vector<double>> two(2, std::vector<double>(3, 1.0));
  EXPECT_THROW(gram_of(sessions, {.probes = {}, .baseline = testing::baseline(), .weights = one}),
               std::logic_error);
  EXPECT_THROW(gram_of(sessions, {.probes = {}, .baseline = testing::baseline(), .weights = two}),
               std::logic_error);
}

}  // namespace
}  // namespace host_sim::diagnose
