#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/effects/specimens.hpp"

namespace host_sim::effects::testing {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

double law_life(double effective_N) {
  return kLife.ipl_scale / std::pow(effective_N, kLife.ipl_exponent);
}

TEST(MeanStress, PutsAnotherLawInPlaceOfGerber) {
  std::vector<Campaign::Specimen> specimens{specimen("a", 30)};
  specimens[0].blocks[0].load = load(50, 30);
  const double gerber = law_life(30 / (1 - std::pow(50 / 177.4, 2)));
  EXPECT_NEAR(life_columns("mean_stress", specimens, {0})[0][0],
              std::log(law_life(30 / (1 - 50 / 177.4)) / gerber), 1e-12);
  EXPECT_NEAR(life_columns("mean_stress", specimens, {0.5})[0][0],
              std::log(law_life(std::sqrt(80.0 * 30)) / gerber), 1e-12);
  EXPECT_NEAR(life_columns("mean_stress", specimens, {0.7})[0][0],
              std::log(law_life(std::pow(80, 0.3) * std::pow(30, 0.7)) / gerber), 1e-12);
  // both laws find a tensile mean worse than Gerber does
  EXPECT_LT(life_columns("mean_stress", specimens, {0})[0][0], 0);
  EXPECT_LT(life_columns("mean_stress", specimens, {0.5})[0][0], 0);
}

TEST(MeanStress, IsNothingWithoutAMean) {
  const std::vector<Campaign::Specimen> specimens{specimen("a", 30)};
  for (const std::vector<double>& shape : life_effect("mean_stress").shapes()) {
    EXPECT_NEAR(life_columns("mean_stress", specimens, shape)[0][0], 0, 1e-15);
  }
}

TEST(MeanStress, OfBlocksIsWhatMinerMakesOfEachBlocksNewLife) {
  std::vector<Campaign::Specimen> specimens{in_blocks("a", {{10, 100}, {20, 100}})};
  specimens[0].blocks[1].load = load(90, 20);
  const double second_N = 20 / (1 - std::pow(90 / 177.4, 2));
  const double before = 100 / law_life(10) + 100 / law_life(second_N);
  const double after = 100 / law_life(10) + 100 / law_life(20 / (1 - 90 / 177.4));
  EXPECT_NEAR(life_columns("mean_stress", specimens, {0})[0][0], std::log(before / after), 1e-12);
}

TEST(BendingFatigue, AddsToTheAmplitude) {
  std::vector<Campaign::Specimen> specimens{specimen("a", 20), specimen("b", 20)};
  specimens[0].wire_to_bend_ratio = 0.05;
  specimens[1].wire_to_bend_ratio = 0;
  const auto found = life_columns("bending_fatigue", specimens, {400});
  EXPECT_NEAR(found[0][0], std::log(0.25), 1e-12);  // 20 N more: twice the tension
  EXPECT_EQ(found[0][1], 0);
}

TEST(EnduranceLimit, LengthensTheLifeOfLowLoadsAndScattersIt) {
  const std::vector<Campaign::Specimen> specimens{specimen("a", 10), specimen("b", 20),
                                                  specimen("c", 40)};
  const auto found = life_columns("endurance_limit", specimens, {0.5});  // at 5 N
  EXPECT_NEAR(found[0][0], std::log(law_life(5) / law_life(10)), 1e-12);
  EXPECT_NEAR(found[0][2], std::log(law_life(35) / law_life(40)), 1e-12);
  const Scatter scatter = life_scatter("endurance_limit", specimens, {0.5});
  const double step = 1e-5;
  for (std::size_t i = 0; i < 3; ++i) {
    const double effective_N = 10 * std::pow(2, static_cast<double>(i));
    const double slope = (std::log(law_life(effective_N - 5 * std::exp(step))) -
                          std::log(law_life(effective_N - 5 * std::exp(-step)))) /
                         (2 * step);
    EXPECT_NEAR(scatter.log_life_sd[i], std::abs(slope), 1e-6);
  }
  EXPECT_THAT(scatter.shared_by, ElementsAre(0, 1, 2));
}

TEST(LoadSequence, HighThenLowEndsSoonerThanMinerSays) {
  // lives 250 and 1000: half of the first, then x = 0.5^(0.25^0.4) = 0.671589
  const std::vector<Campaign::Specimen> high_low{in_blocks("a", {{20, 125}, {10, 500}})};
  EXPECT_NEAR(life_columns("load_sequence", high_low, {0.4})[0][0], std::log(1.5 - 0.671589), 1e-6);
  // and 0.5^(4^0.4) = 0.299141 the other way round
  const std::vector<Campaign::Specimen> low_high{in_blocks("a", {{10, 500}, {20, 125}})};
  EXPECT_NEAR(life_columns("load_sequence", low_high, {0.4})[0][0], std::log(1.5 - 0.299141), 1e-6);
}

TEST(LoadSequence, IsNothingForOneLoadInTwoBlocksAndWhereTheFirstBlockUsesUpAll) {
  const std::vector<Campaign::Specimen> specimens{in_blocks("a", {{10, 300}, {10, 700}}),
                                                  in_blocks("b", {{20, 400}, {10, 100}}),
                                                  specimen("c", 10)};
  const auto found = life_columns("load_sequence", specimens, {0.4});
  EXPECT_THAT(found[0], Each(::testing::DoubleNear(0, 1e-15)));
}

TEST(SecondMode, ReachesLevelsFromTheTopOrFromTheBottom) {
  const std::vector<Campaign::Specimen> specimens{specimen("a", 10), specimen("b", 20),
                                                  specimen("c", 40)};
  EXPECT_THAT(life_columns("second_mode", specimens, {1})[0], ElementsAre(0, 0, 1));
  EXPECT_THAT(life_columns("second_mode", specimens, {2})[0], ElementsAre(0, 1, 1));
  EXPECT_THAT(life_columns("second_mode", specimens, {-1})[0], ElementsAre(1, 0, 0));
  EXPECT_THAT(life_scatter("second_mode", specimens, {-2}).log_life_sd, ElementsAre(1, 1, 0));
}

TEST(LotFrailty, HasOneDrawForEachLotAndMovesNoMean) {
  std::vector<Campaign::Specimen> specimens{specimen("a", 10), specimen("b", 20),
                                            specimen("c", 20)};
  specimens[1].lot = "other";
  const Scatter scatter = life_scatter("lot_frailty", specimens);
  EXPECT_THAT(scatter.log_life_sd, Each(1));
  EXPECT_THAT(scatter.shared_by, ElementsAre(0, 1, 0));
  EXPECT_TRUE(life_columns("lot_frailty", specimens).empty());
  EXPECT_EQ(life_effect("lot_frailty").kind(), LifeEffectKind::scatter);
}

TEST(Ageing, ShortensLifeByTheDay) {
  std::vector<Campaign::Specimen> specimens{specimen("a", 10), specimen("b", 10)};
  specimens[0].days = 12;
  specimens[1].days = 0;
  EXPECT_THAT(life_columns("ageing", specimens)[0], ElementsAre(-12, 0));
}

TEST(LifeMissing, SaysWhatToRecord) {
  const std::vector<Campaign::Specimen> one{specimen("a", 10), specimen("b", 20)};
  const LifeCovariates c = life_covariates_of(one, kLife);
  EXPECT_THAT(life_effect("ageing").missing(c), HasSubstr("days"));
  EXPECT_THAT(life_effect("bending_fatigue").missing(c), HasSubstr("wire_to_bend_ratio"));
  EXPECT_THAT(life_effect("load_sequence").missing(c), HasSubstr("blocks.csv"));
  EXPECT_THAT(life_effect("lot_frailty").missing(c), HasSubstr("lot"));
  EXPECT_THAT(life_effect("endurance_limit").missing(c), HasSubstr("three levels"));
  EXPECT_EQ(life_effect("second_mode").missing(c), "");
  EXPECT_EQ(life_effect("mean_stress").missing(c), "");
}

TEST(LifeKinds, ColumnsAndScatterAreThereWhereTheKindSaysSo) {
  std::vector<Campaign::Specimen> specimens{specimen("a", 10), specimen("b", 20),
                                            in_blocks("c", {{40, 5}, {10, 7}})};
  for (Campaign::Specimen& one : specimens) {
    one.days = 1;
    one.wire_to_bend_ratio = 0.03;
  }
  const LifeCovariates c = life_covariates_of(specimens, kLife);
  for (const auto& effect : life_effects()) {
    const bool moves = effect->kind() != LifeEffectKind::scatter;
    const bool scatters = effect->kind() != LifeEffectKind::mean;
    for (const std::vector<double>& shape : effect->shapes()) {
      const Signature signature = effect->signature(c, kLife, shape);
      const Scatter scatter = effect->scatter(c, kLife, shape);
      EXPECT_EQ(signature.columns.size(), moves ? 1U : 0U) << effect->id();
      EXPECT_EQ(scatter.log_life_sd.size(), scatters ? 3U : 0U) << effect->id();
      EXPECT_EQ(scatter.shared_by.size(), scatters ? 3U : 0U) << effect->id();
      EXPECT_EQ(effect->parameters().size(),
                shape.size() + signature.columns.size() + (scatters ? 1U : 0U))
          << effect->id();
    }
  }
}

}  // namespace
}  // namespace host_sim::effects::testing
