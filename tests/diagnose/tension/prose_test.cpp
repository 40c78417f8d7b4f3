#include "host_sim/diagnose/tension/prose.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/diagnose/tension/noisy_sessions.hpp"

namespace host_sim::diagnose::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Audit audit_of(std::initializer_list<std::string_view> ids) {
  Audit audit;
  for (const std::string_view id : ids) {
    audit.effects.push_back({});
    audit.effects.back().effect = component(id).effect;
  }
  return audit;
}

Findings ambiguous_between(std::vector<std::string> ids) {
  Findings findings;
  findings.verdict = Verdict::ambiguous;
  findings.credible_set = std::move(ids);
  return findings;
}

TEST(VerdictWords, OfNoneSayHowManyRecordings) {
  EXPECT_THAT(verdict_prose({}, 12), HasSubstr("12 recordings"));
}

TEST(VerdictWords, NameEachEffectWithItsProbability) {
  Findings findings;
  findings.verdict = Verdict::named;
  findings.effects.resize(2);
  findings.effects[0].id = "slack";
  findings.effects[0].term = "backlash";
  findings.effects[0].probability = 0.987;
  findings.effects[1].id = "friction_wear";
  findings.effects[1].term = "wear";
  findings.effects[1].probability = 1;
  EXPECT_THAT(verdict_prose(findings, 8),
              HasSubstr("backlash (slack, 98.7 %) and wear (friction_wear, 100.0 %)."));
}

TEST(VerdictWords, ListWhatMayBe) {
  EXPECT_THAT(verdict_prose(ambiguous_between({"slack", "compliance"}), 8),
              HasSubstr("slack, compliance."));
}

TEST(VerdictWords, OfUnknownSayWhereItShowsMost) {
  Findings findings;
  findings.verdict = Verdict::unknown;
  findings.discrepancies = {{"speed", 30, 0.01, 0.01}, {"tendon position", 70, 0.001, 0.001}};
  EXPECT_THAT(verdict_prose(findings, 8), HasSubstr("against tendon position"));
  EXPECT_THAT(next_experiment(findings, {}), HasSubstr("tendon position"));
  findings.discrepancies.clear();
  EXPECT_THAT(next_experiment(findings, {}), IsEmpty());
}

TEST(NextExperiment, IsThatOfTheCatalogueBetweenTheFirstTwo) {
  const Audit audit = audit_of({"slack", "presliding", "friction_wear"});
  EXPECT_THAT(next_experiment(ambiguous_between({"slack", "presliding"}), audit),
              HasSubstr("pretension"));
  EXPECT_THAT(next_experiment(
                  ambiguous_between({"friction_wear+slack", "friction_wear+presliding"}), audit),
              HasSubstr("pretension"));
}

TEST(NextExperiment, IsMoreOfTheSameWhereOneEffectIsInDoubt) {
  const Audit audit = audit_of({"slack", "presliding"});
  EXPECT_THAT(next_experiment(ambiguous_between({"presliding+slack", "slack"}), audit),
              HasSubstr("Dahl"));
  EXPECT_THAT(next_experiment(ambiguous_between({"slack", "none"}), audit), HasSubstr("backlash"));
}

TEST(NextExperiment, IsNeededOnlyWhereSomethingIsInDoubt) {
  EXPECT_THAT(next_experiment({}, {}), IsEmpty());
  EXPECT_THAT(next_experiment(ambiguous_between({"slack"}), {}), IsEmpty());
  Findings named;
  named.verdict = Verdict::named;
  EXPECT_THAT(next_experiment(named, {}), IsEmpty());
}

}  // namespace
}  // namespace host_sim::diagnose::testing
