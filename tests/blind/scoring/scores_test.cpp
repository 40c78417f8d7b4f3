#include "tests/blind/scoring/scores.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/blind/report/markdown.hpp"
#include "tests/blind/support.hpp"

namespace blind::test {
namespace {

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
