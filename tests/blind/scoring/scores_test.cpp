#include "tests/blind/scoring/scores.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/blind/scoring/markdown.hpp"
#include "tests/blind/support.hpp"

namespace blind::test {
namespace {

TEST(Proportion, NoneOfSomeHasTheBoundsOfTheRuleOfThree) {
  const Proportion none{0, 1000};
  EXPECT_EQ(none.lower(), 0);
  // (1 - p)^1000 = 0.025
  EXPECT_NEAR(none.upper(), 1 - std::pow(0.025, 1e-3), 1e-9);
}

TEST(Proportion, AllOfSomeIsItsMirrorImage) {
  const Proportion all{20, 20};
  EXPECT_EQ(all.upper(), 1);
  EXPECT_NEAR(all.lower(), std::pow(0.025, 1.0 / 20), 1e-9);
}

// Clopper and Pearson's own chart, and R's binom.test(7, 20): 0.1539092 .. 0.5921885.
TEST(Proportion, SevenOfTwenty) {
  const Proportion seven{7, 20};
  EXPECT_NEAR(seven.lower(), 0.1539092, 1e-6);
  EXPECT_NEAR(seven.upper(), 0.5921885, 1e-6);
}

TEST(Proportion, NoneOfNoneSaysNothing) {
  const Proportion nothing;
  EXPECT_TRUE(std::isnan(nothing.value()));
  EXPECT_EQ(nothing.lower(), 0);
  EXPECT_EQ(nothing.upper(), 1);
  EXPECT_EQ(text_of(nothing), "-");
}

// Sums of binomials: fewer than 51 of 60 at 0.904 have 0.0586, fewer than 52 0.1181; fewer than 48
// at 0.865 have 0.0547, fewer than 49 0.1033.
TEST(Proportion, ASampleHasToReachMostOfIt) {
  EXPECT_EQ((Proportion{904, 1000}.least_of(60)), 51u);
  EXPECT_EQ((Proportion{865, 1000}.least_of(60)), 48u);
  EXPECT_EQ((Proportion{10, 10}.least_of(60)), 60u);
  EXPECT_EQ((Proportion{0, 10}.least_of(60)), 0u);
}

TEST(Proportion, CountsWhatItIsTold) {
  Proportion proportion;
  proportion.add(true);
  proportion.add(false);
  proportion.add(true);
  proportion.add(true);
  EXPECT_EQ(proportion.value(), 0.75);
}

TEST(Calibration, NoAnswersHaveNoError) {
  EXPECT_EQ(Calibration().error(), 0);
}

TEST(Calibration, ThreeOfFourAtThreeQuartersIsPerfect) {
  Calibration calibration;
  for (const bool right : {true, true, true, false}) {
    calibration.add(0.75, right);
  }
  EXPECT_EQ(calibration.error(), 0);
}

// Bin 0.9 .. 1: three answers of 0.95, two right, |2 - 2.85| = 0.85. Bin 0.5 .. 0.6: one answer of
// 0.5, right, |1 - 0.5| = 0.5. (0.85 + 0.5) / 4.
TEST(Calibration, ErrorIsWeightedByAnswers) {
  Calibration calibration;
  calibration.add(0.95, true);
  calibration.add(0.95, true);
  calibration.add(0.95, false);
  calibration.add(0.5, true);
  EXPECT_NEAR(calibration.error(), 1.35 / 4, 1e-12);
}

// Within one bin too much confidence and too little cancel; across bins they do not.
TEST(Calibration, BinsDoNotCancel) {
  Calibration calibration;
  calibration.add(0.15, true);
  calibration.add(0.85, false);
  EXPECT_NEAR(calibration.error(), 0.85, 1e-12);
}

TEST(Calibration, CertaintyBelongsToTheLastBin) {
  Calibration calibration;
  calibration.add(1, true);
  EXPECT_EQ(calibration.bins()[9].answers, 1U);
  EXPECT_EQ(calibration.bins()[9].right, 1U);
}

Record visible(Record record, double sigmas) {
  record.visibility = {sigmas};
  return record;
}

Record refused() {
  Record record = answered(hiding({"slack"}), Verdict::none, {});
  record.error = "sessions.csv: one session; accepted: at least two";
  return record;
}

/// Two with nothing hidden, three with one, two with two, two from outside, and one refused.
std::vector<Record> some() {
  return {
      answered(hiding({}), Verdict::none, {{"none", 0.9}}),
      answered(hiding({}), Verdict::unknown, {{"unknown", 0.6}}),
      visible(answered(hiding({"slack"}), Verdict::named, {{"slack", 0.97}}, {"slack"}), 9),
      visible(answered(hiding({"slack"}), Verdict::none, {{"none", 0.8}}), 2),
      visible(answered(hiding({"presliding"}), Verdict::named, {{"slack", 0.96}}, {"slack"}), 4),
      visible(answered(hiding({"filter_lag", "slack"}), Verdict::named,
                       {{"filter_lag+slack", 0.99}}, {"filter_lag", "slack"}),
              5),
      visible(answered(hiding({"filter_lag", "slack"}), Verdict::ambiguous, {{"slack", 0.9}}), 4),
      answered(hiding_outside("stick_slip"), Verdict::unknown, {{"unknown", 0.7}}),
      answered(hiding_outside("humidity_cycle"), Verdict::none, {{"none", 0.7}}),
      refused(),
  };
}

void expect(const Proportion& proportion, std::size_t holds, std::size_t of) {
  EXPECT_EQ(proportion.holds, holds);
  EXPECT_EQ(proportion.of, of);
}

TEST(Scores, CountsByWhatIsHidden) {
  const Scores scores = scores_of(some());
  EXPECT_EQ(scores.refused, 1U);
  expect(scores.none_named, 0, 2);
  expect(scores.none_alarmed, 1, 2);
  expect(scores.one.first, 1, 3);
  expect(scores.one_at_3.first, 1, 2);
  expect(scores.one_at_5.first, 1, 1);
  expect(scores.one_named_at_5, 1, 1);
  expect(scores.effects.at("slack").first, 1, 2);
  expect(scores.effects.at("presliding").first, 0, 1);
  expect(scores.named_right, 2, 3);
  expect(scores.two_first, 1, 2);
  expect(scores.two_first_at_5, 1, 1);
  expect(scores.two_named, 1, 2);
  expect(scores.outside_unknown, 1, 2);
  expect(scores.outside_named, 0, 2);
  expect(scores.outside.at("stick_slip"), 1, 1);
  EXPECT_EQ((scores.confusion.at({"presliding", "slack"})), 1U);
}

TEST(Scores, SeveralAreCountedByHowMuchOfThemIsFound) {
  const Scores scores = scores_of({
      answered(hiding({"slack", "presliding", "compliance"}), Verdict::named,
               {{"slack+presliding+compliance", 0.99}}, {"slack", "presliding", "compliance"}),
      answered(hiding({"slack", "presliding", "compliance"}), Verdict::named,
               {{"presliding+slack", 0.99}}, {"presliding", "slack"}),
      answered(hiding({"slack", "presliding", "compliance"}), Verdict::ambiguous,
               {{"filter_lag+slack", 0.6}}),
      answered(hiding({"slack", "presliding", "compliance"}), Verdict::unknown, {{"unknown", 0.9}}),
  });
  expect(scores.three_first, 1, 4);
  expect(scores.three_named, 1, 4);
  expect(scores.two_first, 0, 0);
  EXPECT_EQ((scores.confusion.at({"three", "all of them"})), 1U);
  EXPECT_EQ((scores.confusion.at({"three", "some of them"})), 1U);
  EXPECT_EQ((scores.confusion.at({"three", "others"})), 1U);
  EXPECT_EQ((scores.confusion.at({"three", "unknown"})), 1U);
}

TEST(Scores, WhatIsHeldBackFromTuningIsCountedApart) {
  const Scores scores = scores_of({
      answered(hiding_outside("stick_slip"), Verdict::named, {{"slack", 0.97}}, {"slack"}),
      answered(hiding_outside("resonance"), Verdict::unknown, {{"unknown", 0.7}}),
      answered(hiding_outside("moving_mass"), Verdict::named, {{"slack", 0.97}}, {"slack"}),
  });
  expect(scores.outside_named, 2, 3);
  expect(scores.held_back_unknown, 1, 2);
  expect(scores.held_back_named, 1, 2);
}

TEST(Scores, MeanSetAndItsCoverage) {
  std::vector<Record> records = some();
  records.resize(2);
  records[0].findings.credible_set = {"none"};
  records[1].findings.credible_set = {"unknown", "slack", "presliding"};
  const Scores scores = scores_of(records);
  expect(scores.covered, 1, 2);
  EXPECT_EQ(scores.set_size, 2);
}

TEST(Scores, ParametersAreThoseOfRightNames) {
  Record record = answered(hiding({"friction_preload"}), Verdict::named,
                           {{"friction_preload", 0.99}}, {"friction_preload"});
  record.truth.hidden[0].numbers["force_N"] = {2};
  record.findings.effects[0].parameters = {{"preload_N", "N", 1.9, 1.8, 1.95}};
  const Scores scores = scores_of({record});
  ASSERT_EQ(scores.parameter_errors.size(), 1U);
  EXPECT_NEAR(scores.parameter_errors[0], 0.05, 1e-12);
  expect(scores.parameters_covered, 0, 1);
  record.truth.kind = CampaignKind::two;
  record.truth.hidden.push_back({"presliding", false, {{"length_mm", {1}}}, {}});
  expect(scores_of({record}).parameters_covered, 0, 0);
  expect(scores_of({record}).parameters_covered_of_several, 0, 1);
}

TEST(Scores, QuantilesLieBetweenNumbers) {
  EXPECT_EQ(quantile({1, 2, 4}, 0.5), 2);
  EXPECT_EQ(quantile({1, 2, 4}, 0.75), 3);
  EXPECT_EQ(quantile({1, 2, 4}, 1), 4);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(Tables, StandBetweenTheirMarks) {
  const std::string readme =
      "before\n<!-- blind-table-lives:begin -->\nold\n<!-- blind-table-lives:end -->\nafter\n";
  EXPECT_EQ(
      with_tables(readme, "lives", "new\n"),
      "before\n<!-- blind-table-lives:begin -->\nnew\n<!-- blind-table-lives:end -->\nafter\n");
  EXPECT_THROW(with_tables(readme, "recordings", "new\n"), std::runtime_error);
}

std::string with_thousands(int seed) {
  return fmt::format("{},{:03}", seed / 1000, seed % 1000);
}

TEST(Tables, AreOfTheSeedsThatTheReadmeNames) {
  std::ifstream file(TENDONLIFE_README);
  std::stringstream readme;
  readme << file.rdbuf();
  const std::string sentence = fmt::format(
      "tables are of seeds from {} on for recordings and from {} on for lives.",
      with_thousands(BLIND_FIRST_SEED_RECORDINGS), with_thousands(BLIND_FIRST_SEED_LIVES));
  EXPECT_NE(readme.str().find(sentence), std::string::npos) << sentence;
}

TEST(Tables, SayWhatWasCounted) {
  const std::string text = markdown_of(scores_of(some()), "nine");
  EXPECT_NE(text.find("| right when named | 66.7 % (9.4 .. 99.2, 2 of 3) | >= 99 % | missed |\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("| slack | none 1, slack 1 |"), std::string::npos) << text;
}

// One of three effects is right first; nothing is named where nothing is hidden.
TEST(Tables, SayWhetherAGoalIsMet) {
  constexpr std::string_view kRightFirst = "one effect, right first, over all | 33.3 % ";
  const auto line_with = [](const std::string& text, std::string_view start) {
    const std::size_t begin = text.find(start);
    return begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
  };
  const Scores scores = scores_of(some());
  EXPECT_TRUE(
      line_with(markdown_of(scores, "", 0.34), kRightFirst).ends_with("| >= 34 % | missed |"));
  EXPECT_TRUE(line_with(markdown_of(scores, "", 0.33), kRightFirst).ends_with("| >= 33 % | met |"));
  EXPECT_TRUE(line_with(markdown_of(scores, ""), "named something where nothing is hidden")
                  .ends_with("| <= 0.4 % | met |"));
  EXPECT_TRUE(line_with(markdown_of(scores, ""), "any alarm").ends_with("|  |  |"));
  EXPECT_TRUE(line_with(markdown_of(scores, ""), "slack | 50.0 %").ends_with("| missed |"));
}

}  // namespace
}  // namespace blind::test
