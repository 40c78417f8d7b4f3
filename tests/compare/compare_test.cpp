#include "host_sim/compare/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace host_sim::compare {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kProfile = "time_s,input_tension_N\n0,10\n0.005,60\n0.01,10\n0.015,60\n";

class Compare : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "compare_XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    profile_ = file("profile.csv", kProfile);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return (folder_ / name).string();
  }
  [[nodiscard]] Comparison models(const Model& b) const {
    return compare({profile_, "a.toml", paper()}, {profile_, "b.toml", b}, true, [] {});
  }
  [[nodiscard]] Comparison profiles(const std::string& text) const {
    return compare({profile_, "m.toml", paper()}, {file("b.csv", text), "m.toml", paper()}, false,
                   [] {});
  }
  static Model paper() {
    return {.cable = {0.457, 177.4},
            .sheath = {0.128, 270},
            .drive = {},
            .counting = {200, 0.2},
            .life = {Model::MeanStress::kGerber, 1.53e5, 1.38, 5.94}};
  }

  fs::path folder_;
  std::string profile_;
};

TEST_F(Compare, ModelsByWhatEachOfTheirNumbersDoesToTheLife) {
  Model b = paper();
  b.cable.diameter_mm = 0.5;
  b.life.ipl_scale *= 2;
  b.life.ipl_exponent = 1.48;
  b.life.weibull_shape = 3;
  const Comparison comparison = models(b);
  ASSERT_EQ(comparison.differences.size(), 4U);
  // Twice the scale is twice the life.
  EXPECT_EQ(comparison.differences[0].name, "life.ipl_scale");
  EXPECT_EQ(comparison.differences[0].a, 1.53e5);
  EXPECT_EQ(comparison.differences[0].b, 3.06e5);
  EXPECT_NEAR(comparison.differences[0].life_ratio.value(), 2, 1e-5);
  // B10 is alpha (-ln 0.9)^(1 / beta): 0.105361^(1 / 3 - 1 / 5.94).
  EXPECT_EQ(comparison.differences[1].name, "life.weibull_shape");
  EXPECT_NEAR(comparison.differences[1].life_ratio.value(), 0.68986, 1e-5);
  // All cycles are of 25 N about 35 N: 25 / (1 - (35 / 177.4)^2) = 26.0125 N by Gerber, and 26.0125
  // to the power of -0.1.
  EXPECT_EQ(comparison.differences[2].name, "life.ipl_exponent");
  EXPECT_NEAR(comparison.differences[2].life_ratio.value(), 0.72190, 1e-5);
  EXPECT_EQ(comparison.differences[3].name, "cable.diameter_mm");
  EXPECT_EQ(comparison.differences[3].life_ratio, 1);
  EXPECT_FALSE(comparison.first);
  EXPECT_THAT(sentence_of(comparison),
              HasSubstr("The wire lives 0.996 times as long with model B as with A"));
}

TEST_F(Compare, TellsATableThatOneModelHasAlone) {
  Model b = paper();
  b.drive = Model::Drive{0.03, 9, 0.9, 12, 0};
  const Comparison comparison = models(b);
  ASSERT_EQ(comparison.differences.size(), 5U);
  EXPECT_EQ(comparison.differences[0].name, "drive.torque_constant_Nm_per_A");
  EXPECT_EQ(comparison.differences[0].a, std::nullopt);
  EXPECT_EQ(comparison.differences[0].b, 0.03);
  EXPECT_EQ(comparison.differences[0].life_ratio, std::nullopt);
}

TEST_F(Compare, ExchangesAnExtensionAsAWhole) {
  Model b = paper();
  b.extensions = {{"mean_stress_exponent", {{"exponent", {3}}}}};
  const Comparison comparison = models(b);
  ASSERT_EQ(comparison.differences.size(), 1U);
  EXPECT_EQ(comparison.differences[0].name, "extension.mean_stress_exponent.exponent");
  EXPECT_EQ(comparison.differences[0].a, std::nullopt);
  EXPECT_EQ(comparison.differences[0].b, 3);
}

TEST_F(Compare, FindsNothingBetweenEqualModels) {
  const Comparison comparison = models(paper());
  EXPECT_TRUE(comparison.differences.empty());
  EXPECT_FALSE(comparison.apart_s);
  EXPECT_THAT(sentence_of(comparison), HasSubstr("lives as long with model B as with A"));
}

TEST_F(Compare, PutsCyclesOfBothIntoTheSameClasses) {
  Model b = paper();
  b.cable.ultimate_tension_N = 300;
  const Comparison comparison = models(b);
  // 10 to 60 N and back, three half cycles: one class.
  ASSERT_EQ(comparison.classes.size(), 1U);
  const CycleClass& only = comparison.classes.front();
  EXPECT_LE(only.range_N[0], 50);
  EXPECT_GT(only.range_N[1], 50);
  EXPECT_LE(only.mean_N[0], 35);
  EXPECT_GT(only.mean_N[1], 35);
  EXPECT_EQ(only.cycles, (std::array{1.5, 1.5}));
  EXPECT_NEAR(only.damage[0], comparison.a().report.damage.total, 1e-12);
  EXPECT_NEAR(only.damage[1], comparison.b().report.damage.total, 1e-12);
  EXPECT_EQ(comparison.apart_s, 0.015) << "the next reading after the first sample";
}

TEST_F(Compare, FindsTheFirstSampleByWhichProfilesDiffer) {
  const Comparison comparison =
      profiles("# made by hand\ntime_s,input_tension_N\n0,10\n0.005,60\n0.01,12\n0.015,60\n");
  ASSERT_TRUE(comparison.first);
  EXPECT_EQ(comparison.first->time_s, 0.01);
  EXPECT_EQ(comparison.first->line_a, 4U);
  EXPECT_EQ(comparison.first->line_b, 5U);
  EXPECT_EQ(comparison.first->a, 10);
  EXPECT_EQ(comparison.first->b, 12);
  EXPECT_EQ(first_of(comparison),
            "The first samples that differ are at 0.01 s: A line 4 with 10 N, B line 5 with 12 N.");
  EXPECT_TRUE(comparison.differences.empty());
}

TEST_F(Compare, TellsWhichProfileEndsFirst) {
  const Comparison comparison = profiles("time_s,input_tension_N\n0,10\n0.005,60\n");
  ASSERT_TRUE(comparison.first);
  EXPECT_EQ(comparison.first->time_s, 0.01);
  EXPECT_EQ(comparison.first->line_b, 0U);
  EXPECT_THAT(first_of(comparison), HasSubstr("A line 4 with 10 N, B has ended."));
  EXPECT_EQ(first_of(profiles(kProfile)), "All samples are equal.");
}

TEST_F(Compare, HasNoRatioOfEndlessLives) {
  const double endless = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ratio(endless, endless), 1);
  EXPECT_EQ(ratio(0, 0), 1);
  EXPECT_EQ(ratio(2, endless), 0);
  EXPECT_EQ(ratio(3, 2), 1.5);
  const Comparison comparison = profiles("time_s,input_tension_N\n0,10\n0.005,10\n0.01,10\n");
  EXPECT_THAT(sentence_of(comparison), HasSubstr("without limit with profile B alone"));
}

TEST_F(Compare, CanBeStopped) {
  const Replayed one{profile_, "m.toml", paper()};
  EXPECT_THROW(
      static_cast<void>(compare(one, one, true, [] { throw std::runtime_error("stopped"); })),
      std::runtime_error);
}

}  // namespace
}  // namespace host_sim::compare
