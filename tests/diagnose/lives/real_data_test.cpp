#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/diagnose/diagnosis.hpp"
#include "tests/diagnose/lives/texts.hpp"

namespace host_sim::diagnose {
namespace {

using ::testing::HasSubstr;

const std::string kWires = TENDONLIFE_SHARED "/data/steel_wire_SN/data.csv";
const std::string kRunOuts = TENDONLIFE_SHARED "/data/life_tables/jsme_woehler_runouts.csv";
const std::string kLaminate = TENDONLIFE_SHARED "/data/life_tables/laminate_R_ratios.csv";

/// Rows of a file behind its header; none where there is no file.
std::vector<std::vector<std::string>> rows_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream in(line.substr(0, line.find('\r')));
    rows.emplace_back();
    for (std::string field; std::getline(in, field, ',');) {
      rows.back().push_back(field);
    }
  }
  return rows;
}

std::string not_checked(const std::string& path) {
  return "NOT CHECKED: there is no " + path +
         "; configure with -DTENDONLIFE_SHARED=<folder that holds data/>";
}

/// A row of specimens.csv. 1 MPa, or 1,000 psi, stands for 1 N.
std::string specimen(std::size_t number, double mean_N, double amplitude_N,
                     const std::string& cycles, bool failed) {
  return fmt::format("s{},1,{},{},{},{},fit\n", 100 + number, mean_N, amplitude_N, cycles,
                     failed ? "failed" : "suspended");
}

// Chen and Liu, Probabilistic physics-guided machine learning for fatigue data analysis, 2020: the
// wires of Shen (1994) have a limit near 78 to 80 ksi and scatter that grows towards it.
TEST(DiagnoseSteelWire, NamesALimitWithScatter) {
  const auto rows = rows_of(kWires);
  if (rows.empty()) {
    GTEST_SKIP() << not_checked(kWires);
  }
  std::string text = lives::test::kHeader;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += specimen(i, 0, std::stod(rows[i][0]) / 1000, rows[i][1], rows[i][2] == "1");
  }
  const LifeDiagnosis diagnosis = diagnose_lives(lives::test::campaign_of(text, 400), {});
  const Findings& findings = diagnosis.findings;
  ASSERT_EQ(findings.verdict, Verdict::named);
  ASSERT_EQ(findings.effects.size(), 1U);
  EXPECT_EQ(findings.effects[0].id, "endurance_limit");
  const Estimate& limit_log_sd = findings.effects[0].parameters.at(0);
  EXPECT_EQ(limit_log_sd.name, "limit_log_sd");
  EXPECT_GT(limit_log_sd.low, 0.02);
  EXPECT_NEAR(79.92 * findings.effects[0].parameters.at(1).value, 79, 79 * 0.03);
  for (const Discrepancy& discrepancy : findings.discrepancies) {
    if (discrepancy.covariate == "curvature" || discrepancy.covariate == "shape") {
      EXPECT_LT(discrepancy.p, 0.01) << discrepancy.covariate;
    }
  }
  const Metric& score = findings.gain.metrics.at(0);
  EXPECT_EQ(score.name, "log_predictive_density");
  EXPECT_GE(score.after - score.before, 1.0);
}

// Lives of JSME with 8 of 30 suspended, no covariate of which shows anything. By an integration
// over the limits in steps of 1/400 of their scatter the largest log likelihood of a lognormal
// limit is -335.84, at 285.1 MPa and 0.0615, against -339.52 of the straight line.
TEST(DiagnoseJsmeRunOuts, NamesALimitThatDiffersBySpecimen) {
  const auto rows = rows_of(kRunOuts);
  if (rows.empty()) {
    GTEST_SKIP() << not_checked(kRunOuts);
  }
  std::string text = lives::test::kHeader;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += specimen(i, 0, std::stod(rows[i][0]), rows[i][1], rows[i][2] == "Failure");
  }
  for (const char* life : {"", lives::test::kPaperLife}) {
    const Findings findings =
        diagnose_lives(lives::test::campaign_of(text, 400, life), {}).findings;
    ASSERT_EQ(findings.verdict, Verdict::named) << findings.prose;
    ASSERT_EQ(findings.effects.size(), 1U) << findings.prose;
    EXPECT_EQ(findings.effects[0].id, "endurance_limit");
    const Estimate& limit_log_sd = findings.effects[0].parameters.at(0);
    EXPECT_GT(limit_log_sd.low, 0.01);
    EXPECT_LT(limit_log_sd.low, 0.0615);
    EXPECT_GT(limit_log_sd.high, 0.0615);
    const Estimate& limit = findings.effects[0].parameters.at(1);
    EXPECT_LT(284.39 * limit.low, 285.1);
    EXPECT_GT(284.39 * limit.high, 285.1);
    EXPECT_THAT(findings.prose, HasSubstr("No covariate alone shows it"));
  }
}

// A laminate at the stress ratios -1, 0.1 and 0.5. Log likelihoods with T_u 400: Gerber -607.3,
// Goodman -592.7, Walker with 0.6 -594.9.
TEST(DiagnoseLaminate, RejectsGerberForGoodman) {
  const auto rows = rows_of(kLaminate);
  if (rows.empty()) {
    GTEST_SKIP() << not_checked(kLaminate);
  }
  std::string text = lives::test::kHeader;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double ratio = std::stod(rows[i][0]);
    if (ratio < 1) {
      const double highest_N = std::stod(rows[i][2]);
      text +=
          specimen(i, highest_N * (1 + ratio) / 2, highest_N * (1 - ratio) / 2, rows[i][3], true);
    }
  }
  const Findings findings = diagnose_lives(lives::test::campaign_of(text, 400, ""), {}).findings;
  ASSERT_EQ(findings.verdict, Verdict::named) << findings.prose;
  ASSERT_EQ(findings.effects.size(), 1U) << findings.prose;
  EXPECT_EQ(findings.effects[0].id, "mean_stress");
  EXPECT_EQ(findings.effects[0].term, "mean-stress law: Goodman's in place of Gerber's");
  EXPECT_THAT(findings.prose, HasSubstr("Against Gerber's law of mean stress, which is rejected, "
                                        "twice the log likelihood is 29.1 larger with Goodman's "
                                        "and 24.6 larger with Walker's."));
}

const LifeDiagnosis& of_the_paper() {
  static const LifeDiagnosis kDiagnosis = diagnose_lives(read_campaign(TENDONLIFE_EXAMPLE), {});
  return kDiagnosis;
}

/// Table 4 of the paper: at 540 deg a shape of 3.34 against 5.94, left out as another mechanism.
TEST(DiagnosePaper, SuspectsASecondModeAt540Degrees) {
  const Findings& findings = of_the_paper().findings;
  EXPECT_THAT(findings.prose, HasSubstr("99.4 N have a Weibull shape of 3.34 against 5.94"));
  EXPECT_THAT(findings.prose, HasSubstr("(p = 0.002"));
  const auto effect = std::ranges::find_if(findings.candidates, [](const Candidate& candidate) {
    return candidate.id != "none" && candidate.id != "unknown";
  });
  EXPECT_EQ(effect->id, "second_mode");
  EXPECT_NE(findings.verdict, Verdict::named);
}

/// Section 4.1: ten specimens of the application are too few to decide on their deviation.
TEST(DiagnosePaper, SaysHowManySpecimensWouldDecide) {
  EXPECT_THAT(of_the_paper().findings.prose, HasSubstr("not decidable with 10"));
  EXPECT_THAT(of_the_paper().findings.prose,
              HasSubstr("would find such a deviation at 5 % in 80 %"));
}

}  // namespace
}  // namespace host_sim::diagnose
