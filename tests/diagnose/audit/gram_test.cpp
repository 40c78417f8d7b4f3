#include "host_sim/diagnose/audit/gram.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/diagnose/audit/records.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<effects::ForceRecord> few_records() {
  return testing::records_of({{.bend_angle_rad = 1.5, .start_cycle = 10, .duration_s = 1},
                              {.bend_angle_rad = 3, .mean_N = 40, .duration_s = 2}});
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

TEST(GramLayout, HasTheColumnsOfEachCaseOnceOneAfterTheOther) {
  const auto records = few_records();
  const GramLayout layout = layout_of(records, scales_of(records));
  std::size_t next = GramLayout::kFirstCase;
  for (const GramLayout::Effect& effect : layout.effects) {
    for (const GramLayout::Case& one : effect.cases) {
      EXPECT_EQ(one.first, next) << effect.effect->id;
      EXPECT_EQ(one.count, 1 + one.parameters.size()) << effect.effect->id;
      next += one.count;
    }
    EXPECT_LT(effect.typical, effect.cases.size()) << effect.effect->id;
  }
  EXPECT_EQ(layout.size, next);
  EXPECT_THROW(static_cast<void>(layout.of("no_such_effect")), std::out_of_range);
}

// A lag of 5 ms at either end, which physics allows to be 20 times as large; a preload of a
// twentieth of the larger rms force, up to ten times that force.
TEST(GramLayout, HasACaseOfUsualSizeForEachStart) {
  const auto records = few_records();
  const effects::ForceScales scales = sharp_scales_of(records);
  const GramLayout layout = layout_of(records, scales);
  const auto& lag = layout.of("filter_lag").cases;
  ASSERT_EQ(lag.size(), 2U);
  EXPECT_THAT(lag[0].parameters, ElementsAre(0.005));
  EXPECT_THAT(lag[1].parameters, ElementsAre(-0.005));
  const auto& preload = layout.of("friction_preload").cases;
  ASSERT_EQ(preload.size(), 1U);
  EXPECT_THAT(preload[0].parameters, ElementsAre(0.05 * scales.larger_N()));
  EXPECT_NEAR(preload[0].most, 200, 1e-9);
}

TEST(GramLayout, LeavesOutWhatOneRecordCannotShow) {
  auto records = few_records();
  records[1].sheath_temperature_C.clear();
  const GramLayout layout = layout_of(records, scales_of(records));
  EXPECT_TRUE(layout.of("friction_temperature").cases.empty());
  EXPECT_THAT(layout.of("friction_temperature").missing, HasSubstr("sheath_temperature_C"));
  EXPECT_EQ(layout.of("friction_wear").missing, "");
}

TEST(GramLayout, SaysWhichChannelAnEffectNeeds) {
  auto records = few_records();
  for (effects::ForceRecord& record : records) {
    record.cycle.clear();
    record.winding_temperature_C.clear();
    record.rotor_rad.clear();
  }
  const GramLayout layout = layout_of(records, scales_of(records));
  EXPECT_THAT(layout.of("friction_wear").missing, HasSubstr("start_cycle"));
  EXPECT_THAT(layout.of("torque_gain").missing, HasSubstr("winding_temperature_C"));
  EXPECT_THAT(layout.of("torque_ripple").missing, HasSubstr("motor_angle_rad"));
}

TEST(GramLayout, ALoadCellHidesWhatTheDriveDoes) {
  auto records = few_records();
  for (effects::ForceRecord& record : records) {
    record.input_N_per_A = 0;
  }
  for (const GramLayout::Effect& effect : layout_of(records, scales_of(records)).effects) {
    const std::string_view id = effect.effect->id;
    const bool of_drive = id == "current_offset" || id == "torque_gain" || id == "gear_asymmetry" ||
                          id == "torque_ripple";
    EXPECT_EQ(effect.missing.find("load cell") != std::string::npos, of_drive) << id;
  }
}

/// The input force of the Capstan law at 1.5 rad, of which ln gain is the whole and friction
/// phi s times it; an offset of 0.05 A is 21 N/A times that at every sample; a preload of F is F s.
TEST(Columns, AreWhatEffectsDoToTheInputForce) {
  const auto records = few_records();
  const effects::ForceScales scales = sharp_scales_of(records);
  const GramLayout layout = layout_of(records, scales);
  const Eigen::MatrixXd columns = columns_of(records[0], layout, scales, testing::kMu);
  const auto offset = static_cast<Eigen::Index>(layout.of("current_offset").cases[0].first);
  const auto& preload = layout.of("friction_preload").cases[0];
  const auto of_preload = static_cast<Eigen::Index>(preload.first);
  for (const Eigen::Index row : {Eigen::Index{5}, Eigen::Index{30}}) {
    const auto at = static_cast<std::size_t>(row);
    const double direction = records[0].velocity_m_s[at] > 0 ? 1 : -1;
    EXPECT_NEAR(columns(row, 0), records[0].input_N[at], 1e-6 * records[0].input_N[at]);
    EXPECT_NEAR(columns(row, 1), 1.5 * direction * records[0].input_N[at],
                1e-3 * records[0].input_N[at]);
    EXPECT_NEAR(columns(row, offset), 21 * 0.05, 1e-9);
    EXPECT_NEAR(columns(row, offset + 1), 21, 1e-6);
    EXPECT_NEAR(columns(row, of_preload), direction * preload.parameters[0],
                1e-3 * preload.parameters[0]);
    EXPECT_NEAR(columns(row, of_preload + 1), direction, 1e-3);
  }
}

TEST(Columns, AreZeroWhereASampleDoesNotCount) {
  auto records = few_records();
  records[0].used[7] = false;
  const effects::ForceScales scales = sharp_scales_of(records);
  const Eigen::MatrixXd columns =
      columns_of(records[0], layout_of(records, scales), scales, testing::kMu);
  EXPECT_TRUE((columns.row(7).array() == 0).all());
}

/// As the header says, by hand.
Eigen::MatrixXd whitened(const effects::ForceRecord& record, const GramLayout& layout,
                         const effects::ForceScales& scales, const std::vector<double>& sd_N,
                         double autocorrelation) {
  Eigen::MatrixXd plain = columns_of(record, layout, scales, testing::kMu);
  for (Eigen::Index t = 0; t < plain.rows(); ++t) {
    plain.row(t) /= sd_N[static_cast<std::size_t>(t)];
  }
  Eigen::MatrixXd expected = plain;
  expected.row(0) = std::sqrt(1 - autocorrelation * autocorrelation) * plain.row(0);
  for (Eigen::Index t = 1; t < plain.rows(); ++t) {
    expected.row(t) = plain.row(t) - autocorrelation * plain.row(t - 1);
  }
  return expected;
}

TEST(Gram, IsAllInnerProductsOfASessionOverItsNoise) {
  const auto records = few_records();
  const effects::ForceScales scales = sharp_scales_of(records);
  NoiseModel noise = testing::usual_noise(records);
  for (const double autocorrelation : {0.0, 0.6}) {
    noise.autocorrelation = autocorrelation;
    const Grams grams = gram_of(records, testing::kMu, noise, 0);
    ASSERT_EQ(grams.sessions.size(), 2U);
    for (std::size_t j = 0; j < 2; ++j) {
      expect_products(grams.sessions[j], whitened(records[j], grams.layout, scales,
                                                  noise.sample_sd_N[j], autocorrelation));
    }
  }
}

TEST(Gram, IsTheSameForAnyNumberOfThreads) {
  const auto records = testing::records_of(testing::one_pose());
  const NoiseModel noise = testing::usual_noise(records);
  const Grams one = gram_of(records, testing::kMu, noise, 1);
  const Grams three = gram_of(records, testing::kMu, noise, 3);
  for (std::size_t j = 0; j < records.size(); ++j) {
    EXPECT_TRUE(one.sessions[j] == three.sessions[j]) << j;
  }
}

}  // namespace
}  // namespace host_sim::diagnose
