#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "hal/files/input_error.hpp"
#include "host_sim/fmeca/assessment.hpp"

namespace host_sim::fmeca {
namespace {

using testing::HasSubstr;

/// A table with one failure mode, whose further lines these are.
std::string table_of(const std::string& failure, const std::string& before = "") {
  return "schema = 1\n"
         "[fmeca]\n"
         "name = 'rig'\n"
         "[ratings]\n"
         "severity = 5\n"
         "occurrence = 5\n"
         "[[level]]\n"
         "name = 'low'\n"
         "from = 1\n" +
         before +
         "[[failure]]\n"
         "id = 'one'\n"
         "component = 'c'\n"
         "mode = 'm'\n"
         "cause = 'why'\n" +
         failure;
}

const std::string kRates =
    "[[occurrence_rate]]\nrating = 1\nname = 'never'\nfrom_per_h = 0.0\n"
    "[[occurrence_rate]]\nrating = 3\nname = 'some'\nfrom_per_h = 1e-3\n";
const std::string kRated = "severity = 5\noccurrence = 4\n";

std::string table_error(const std::string& text) {
  try {
    static_cast<void>(parse_table(text, "t.toml"));
  } catch (const hal::files::InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string field_error(const std::string& text, const RiskTable& table) {
  try {
    static_cast<void>(parse_field(hal::files::memory_source(text), "f.csv", table));
  } catch (const hal::files::InputError& error) {
    return error.what();
  }
  return "accepted";
}

FieldCounts field_of(const std::string& text, const RiskTable& table) {
  return parse_field(hal::files::memory_source(text), "f.csv", table);
}

const Assessed& assessed(const Assessment& assessment, const std::string& id) {
  return *std::ranges::find(assessment.modes, id, [](const Assessed& one) { return one.mode->id; });
}

TEST(PaperTable, HasTheNumbersOfTable2) {
  // Occurrence, severity, risk and its name, as printed.
  struct Row {
    const char* component;
    const char* mode;
    const char* cause;
    int occurrence;
    int severity;
    int risk;
    const char* level;
  };
  const std::array<Row, 14> printed{{
      {"actuator", "cable derailment", "low tension, slack", 4, 5, 20, "severe"},
      {"actuator", "spool wear", "large tension, repetitive operation", 2, 3, 6, "moderate"},
      {"actuator", "component breakage", "overloading", 1, 4, 4, "low"},
      {"actuator", "performance degradation", "motor overcurrent", 1, 3, 3, "low"},
      {"force transmission", "efficiency degradation", "abrasion", 5, 2, 10, "high"},
      {"force transmission", "efficiency degradation", "contamination", 3, 2, 6, "moderate"},
      {"force transmission", "wire breakage", "cyclic loading", 4, 5, 20, "severe"},
      {"force transmission", "wire breakage", "overloading", 1, 5, 5, "moderate"},
      {"force transmission", "wire breakage", "abrasion", 1, 5, 5, "moderate"},
      {"force transmission", "wire breakage", "contamination", 1, 5, 5, "moderate"},
      {"soft structure", "tendon path failure", "stress concentration at the tendon fixture point",
       3, 4, 12, "high"},
      {"soft structure", "tendon path failure", "excessive routing curvature", 3, 4, 12, "high"},
      {"soft structure", "polymer tear", "stress concentration", 3, 3, 9, "moderate"},
      {"soft structure", "delamination of dissimilar materials", "stress concentration", 3, 3, 9,
       "moderate"},
  }};
  const RiskTable table = paper_table();
  const Assessment assessment = assess(table, {});
  ASSERT_EQ(table.modes.size(), printed.size());
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const Row& row = printed[i];
    const FailureMode& mode = table.modes[i];
    EXPECT_EQ(mode.component, row.component) << i;
    EXPECT_EQ(mode.mode, row.mode) << i;
    EXPECT_EQ(mode.cause, row.cause) << i;
    EXPECT_EQ(mode.occurrence, row.occurrence) << i;
    EXPECT_EQ(mode.severity, row.severity) << i;
    const Assessed& one = assessed(assessment, mode.id);
    EXPECT_EQ(one.risk, row.risk) << i;
    EXPECT_EQ(table.levels[one.level].name, row.level) << i;
    EXPECT_FALSE(one.rpn.has_value());
  }
}

TEST(PaperTable, RanksAsSection2_1Does) {
  // "The risky failure modes [...] cable derailment [...] and wire breakage due to the cyclic
  // tensile loading, both receiving scores of 20."
  const RiskTable table = paper_table();
  const Assessment assessment = assess(table, {});
  EXPECT_EQ(assessment.modes[0].mode->id, "cable_derailment");
  EXPECT_EQ(assessment.modes[1].mode->id, "wire_fatigue");
  std::vector<std::size_t> ranks;
  for (const Assessed& one : assessment.modes) {
    ranks.push_back(one.rank);
  }
  // 20 20 12 12 10 9 9 6 6 5 5 5 4 3
  EXPECT_EQ(ranks, (std::vector<std::size_t>{1, 1, 3, 3, 5, 6, 6, 8, 8, 10, 10, 10, 13, 14}));
}

TEST(PaperTable, SaysWhatNothingWatches) {
  const RiskTable table = paper_table();
  const auto json = nlohmann::json::parse(fmeca_json(assess(table, {})));
  EXPECT_EQ(json["watched_by_nothing"],
            (std::vector<std::string>{"polymer_tear", "delamination", "spool_wear"}));
  std::ostringstream out;
  write_fmeca(out, assess(table, {}));
  EXPECT_THAT(out.str(), HasSubstr("14 failure modes, 2 severe; nothing watches 3 of them"));
  EXPECT_THAT(out.str(), HasSubstr("watched by nothing: polymer_tear, delamination, spool_wear\n"));
}

TEST(Assessment, MultipliesWithDetectionAndRanksByIt) {
  const std::string second =
      "[[failure]]\nid = 'two'\ncomponent = 'c'\nmode = 'm'\ncause = 'w'\nseverity = 2\n"
      "occurrence = 3\ndetection = 5\n";
  const RiskTable table = parse_table(table_of(kRated + "detection = 1\n" + second), "t.toml");
  const Assessment assessment = assess(table, {});
  EXPECT_TRUE(assessment.has_rpn());
  EXPECT_EQ(assessment.modes[0].mode->id, "two");
  EXPECT_EQ(assessment.modes[0].rpn, 2 * 3 * 5);
  EXPECT_EQ(assessment.modes[0].risk, 6);
  EXPECT_EQ(assessment.modes[1].rpn, 5 * 4 * 1);
  EXPECT_EQ(assessment.modes[1].rank, 2U);
}

TEST(Watch, KnowsFramesSignalsValuesAndEffects) {
  EXPECT_THAT(what_is("LifeStatus").words, HasSubstr("The life of the node at a glance"));
  EXPECT_THAT(what_is("RemainingLife").words, HasSubstr("page 5 RemainingLife"));
  EXPECT_THAT(what_is("LifeStatus.Slack").words, HasSubstr("a tendon hangs loose"));
  EXPECT_EQ(what_is("Emergency.EmergencyCode.overload").words,
            "Emergency: EmergencyCode overload (0xff20)");
  EXPECT_EQ(what_is("effect.friction_wear").words.substr(0, 4), "wear");
  EXPECT_NE(what_is("effect.endurance_limit").words, "");
  EXPECT_NE(what_is("effect.small_cycles").words, "");
}

TEST(Watch, SaysWhatThereIsInsteadOfAnUnknownName) {
  const std::map<std::string, std::string> cases{
      {"LifeStat", "Heartbeat, LifeStatus, Identity"},
      {"LifeStatus.Brokn", "LifeStatus. and one of LifeState, Damage"},
      {"LifeStatus.LifeState.gone", "LifeStatus.LifeState. and one of unknown, normal"},
      {"LifeStatus.Damage.x", "LifeStatus.Damage, which has no named values"},
      {"LifeStatus.LifeState.", "LifeStatus.LifeState. and one of"},
      {"LifeStatus.", "does not end with a dot"},
      {"effect.friction", "effect. and one of "},
      {"effect", "effect. and one of "},
      {"", "Heartbeat"},
  };
  for (const auto& [name, accepted] : cases) {
    EXPECT_EQ(what_is(name).words, "") << name;
    EXPECT_THAT(what_is(name).accepted, HasSubstr(accepted)) << name;
  }
}

TEST(Table, RefusesWhatCannotBeTrusted) {
  std::string late_level = table_of(kRated);
  late_level.replace(late_level.find("from = 1"), 8, "from = 2");
  const std::vector<std::pair<std::string, std::string>> cases{
      {table_of("occurrence = 4\n"),
       "t.toml:10:1: no key severity in [failure]; accepted: "
       "severity 1..5"},
      {table_of("severity = 5\n"), "t.toml:10:1: no key occurrence in [failure]"},
      {table_of("severity = 'high'\noccurrence = 4\n"), "t.toml:15:1: severity is 'high'"},
      {table_of("severity = 6\noccurrence = 4\n"),
       "t.toml:15:1: severity is 6; accepted: severity "
       "1..5"},
      {table_of("severity = 2.5\noccurrence = 4\n"),
       "t.toml:15:1: severity is 2.5; accepted: severity as a whole number from 1 to 5"},
      {table_of("severity = nan\noccurrence = 4\n"), "t.toml:15:1: severity is nan"},
      {table_of(kRated + "detection = 0\n"), "t.toml:17:1: detection is 0"},
      {table_of(kRated + "likelihood = 3\n"),
       "t.toml:17:1: unknown key 'likelihood' in [failure]; "
       "accepted: id, component"},
      {table_of(kRated + "seen_by = 'LifeStatus'\n"),
       "t.toml:17:1: seen_by is 'LifeStatus'; "
       "accepted: seen_by as an array of texts"},
      {table_of(kRated + "seen_by = [3]\n"), "t.toml:17:12: seen_by holds 3"},
      {table_of(kRated + "seen_by = ['LifeStatus.Slack',\n  'LifeStatus.Brokn']\n"),
       "t.toml:18:3: seen_by holds 'LifeStatus.Brokn', which nothing is called; accepted: "
       "LifeStatus. and one of LifeState"},
      {table_of(kRated) + "[[failure]]\nid = 'one'\ncomponent = 'c'\nmode = 'm'\ncause = 'w'\n" +
           kRated,
       "t.toml:18:1: id one a second time"},
      {table_of(kRated) + "[[failure]]\nid = 'two'\ncomponent = 'c'\nmode = 'm'\ncause = 'w'\n" +
           kRated + "detection = 2\n",
       "t.toml:24:1: a detection, which those before have not"},
      {table_of(kRated, "[[level]]\nname = 'high'\nfrom = 1\n"),
       "t.toml:12:1: from is 1; accepted: more than 1 of the level before"},
      {late_level, "t.toml:9:1: from is 2; accepted: from = 1 of the first level"},
      {table_of(kRated, "[[occurrence_rate]]\nrating = 1\nname = 'a'\nfrom_per_h = 0.5\n"),
       "t.toml:13:1: from_per_h is 0.5; accepted: from_per_h = 0 of the first rate"},
      {table_of(kRated, kRates + "[[occurrence_rate]]\nrating = 2\nname = 'a'\nfrom_per_h = 1.0\n"),
       "t.toml:19:1: rating is 2; accepted: more than 3 of the rate before"},
      {table_of(kRated, kRates + "[[occurrence_rate]]\nrating = 4\nname = 'a'\nfrom_per_h = 0.0\n"),
       "t.toml:21:1: from_per_h is 0; accepted: more than 0.001 of the rate before"},
      {table_of(kRated, "[[levels]]\n"), "t.toml:10:3: unknown key 'levels'"},
      {"schema = 2\n", "t.toml:1:1: schema is 2"},
      {"schema = 1\n", "t.toml: no table [fmeca]"},
      {"[fmeca\n", "t.toml:1:"},
  };
  for (const auto& [text, message] : cases) {
    EXPECT_THAT(table_error(text), HasSubstr(message)) << text;
  }
  EXPECT_EQ(table_error(table_of(kRated, kRates)), "accepted");
  std::string id = table_of(kRated);
  id.replace(id.find("'one'"), 5, "'One'");
  EXPECT_THAT(table_error(id), HasSubstr("t.toml:11:1: id is 'One'; accepted: small letters"));
}

TEST(Field, RatesByTheUpperLimitOfTheRate) {
  // Chi-square with 2, 4 and 10 degrees of freedom has its 60 % point at 1.833, 4.045 and 10.473.
  EXPECT_NEAR((FieldCount{0, 1000}.limit_per_h()), 1.8326 / 2 / 1000, 1e-7);
  EXPECT_NEAR((FieldCount{1, 1000}.limit_per_h()), 4.0446 / 2 / 1000, 1e-7);
  EXPECT_NEAR((FieldCount{4, 1000}.limit_per_h()), 10.4732 / 2 / 1000, 1e-7);
}

TEST(Field, ReplacesTheOccurrenceOfWhatWasCounted) {
  const RiskTable table = paper_table();
  // 4 events in 7800 h: 10.473 / 2 / 7800 = 6.7e-4, occasional. None in 7800 h: 1.17e-4,
  // occasional. None in 2e5 h: 4.6e-6, extremely unlikely. 41 in 780 h: 5.5e-2, frequent.
  const FieldCounts counts = field_of(
      "failure,events,operating_hours\nwire_fatigue,3,5200\n# note\nwire_fatigue,1,2600\n"
      "cable_derailment,0,7800\npolymer_tear,0,200000\nspool_wear,41,780\n",
      table);
  EXPECT_EQ(counts.at("wire_fatigue").events, 4U);
  EXPECT_EQ(counts.at("wire_fatigue").operating_h, 7800);
  const Assessment assessment = assess(table, counts);
  EXPECT_EQ(assessed(assessment, "wire_fatigue").occurrence, 3);
  EXPECT_EQ(assessed(assessment, "wire_fatigue").risk, 15);
  EXPECT_EQ(assessed(assessment, "cable_derailment").occurrence, 3);
  EXPECT_EQ(assessed(assessment, "polymer_tear").occurrence, 1);
  EXPECT_EQ(assessed(assessment, "spool_wear").occurrence, 5);
  EXPECT_EQ(assessed(assessment, "spool_wear").risk, 15);
  EXPECT_EQ(assessed(assessment, "sheath_abrasion").occurrence, 5);
  EXPECT_FALSE(assessed(assessment, "sheath_abrasion").field.has_value());
  const auto json = nlohmann::json::parse(fmeca_json(assessment));
  EXPECT_EQ(json["failures"][0]["id"], "cable_derailment");
  EXPECT_EQ(json["failures"][0]["field"]["events"], 0);
  EXPECT_EQ(json["failures"][0]["field"]["rate_per_h"], 0);
}

TEST(Field, RefusesWhatCannotBeTrusted) {
  const RiskTable table = paper_table();
  const std::string head = "failure,events,operating_hours\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {head + "wire,1,100\n",
       "f.csv:2:1: failure 'wire' is not in the table; accepted: cable_derailment, spool_wear"},
      {head + "wire_fatigue,,100\n", "f.csv:2:14: events is empty"},
      {head + "wire_fatigue,1.5,100\n", "f.csv:2:14: events is '1.5'; accepted: a whole number"},
      {head + "wire_fatigue,-1,100\n", "f.csv:2:14: events is '-1', out of range"},
      {head + "wire_fatigue,1,0\n", "f.csv:2:16: operating_hours is '0', out of range"},
      {head + "wire_fatigue,1\n", "f.csv:2:15: 2 fields only"},
      {"failure,events,operating_hours,place\n", "f.csv:1:32: unknown column 'place'"},
      {"failure,events\na,1\n", "f.csv:1:15: no column operating_hours"},
      {head, "f.csv: no rows"},
  };
  for (const auto& [text, message] : cases) {
    EXPECT_THAT(field_error(text, table), HasSubstr(message)) << text;
  }
  EXPECT_THAT(
      field_error(head + "one,1,1\n", parse_table(table_of(kRated), "t.toml")),
      HasSubstr("t.toml: no rates to rate field records by; accepted: [[occurrence_rate]]"));
}

}  // namespace
}  // namespace host_sim::fmeca
