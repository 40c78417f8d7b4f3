#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/verbs/campaign_program.hpp"

namespace {

using host_sim_test::CampaignProgram;
using host_sim_test::contents;
using nlohmann::json;
namespace fs = std::filesystem;

TEST_F(CampaignProgram, CalibratesThePapersExample) {
  ASSERT_EQ(run("calibrate '" EXAMPLES "/tendon_alt' --bootstraps 200 --out fitted.toml --json "
                "result.json --report page.html"),
            0)
      << err_;
  const json all = json::parse(contents(folder_ / "result.json"));
  // The paper's Table 4: seven levels with those of the application, common shape 5.94.
  EXPECT_EQ(all["levels"].size(), 7U);
  EXPECT_NEAR(all["common_shape"]["value"].get<double>(), 5.94, 0.005);
  EXPECT_NE(out_.find("540 deg, 99.4 N (left out)"), std::string::npos) << out_;
  EXPECT_NE(out_.find("common shape"), std::string::npos);
  EXPECT_NE(contents(folder_ / "page.html").find("</html>"), std::string::npos);
  EXPECT_TRUE(err_.empty()) << err_;
}

TEST_F(CampaignProgram, WritesAModelThatReplayAndPackRead) {
  ASSERT_EQ(run("calibrate c --bootstraps 20 --out fitted.toml --json r.json"), 0) << err_;
  const json law = json::parse(contents(folder_ / "r.json"))["ipl"];
  EXPECT_EQ(run("pack fitted.toml --out block.bin"), 0) << err_;
  ASSERT_EQ(run("replay good.csv --model fitted.toml --json used.json"), 0) << err_;
  // One and a half cycles of 10 to 60 N: mean 35 N, amplitude 25 N, T_u 177.4 N; eqs. (11), (19).
  const double effective_N = 25 / (1 - std::pow(35 / 177.4, 2));
  const double damage =
      1.5 * std::pow(effective_N, law["exponent"].get<double>()) / law["scale"].get<double>();
  const json used = json::parse(contents(folder_ / "used.json"));
  EXPECT_NEAR(used["damage"]["total"].get<double>() / damage, 1, 1e-5);
}

TEST_F(CampaignProgram, ResultsAreTheSameForAnyNumberOfThreads) {
  ASSERT_EQ(run("calibrate c --bootstraps 100 --threads 1 --json 1.json --report 1.html"), 0);
  ASSERT_EQ(run("calibrate c --bootstraps 100 --threads 3 --json 3.json --report 3.html"), 0);
  EXPECT_EQ(contents(folder_ / "1.json"), contents(folder_ / "3.json"));
  EXPECT_EQ(contents(folder_ / "1.html"), contents(folder_ / "3.html"));
  ASSERT_EQ(run("calibrate c --bootstraps 100 --seed 2 --json other.json"), 0);
  EXPECT_NE(contents(folder_ / "1.json"), contents(folder_ / "other.json"));
}

TEST_F(CampaignProgram, JsonOnStandardOutputSendsTheSummaryElsewhere) {
  ASSERT_EQ(run("calibrate c --bootstraps 20 --json -"), 0) << err_;
  EXPECT_EQ(json::parse(out_)["campaign"], "small");
  EXPECT_EQ(err_.rfind("small: 15 specimens", 0), 0U) << err_;
}

TEST_F(CampaignProgram, UseTensionsAreAnswered) {
  ASSERT_EQ(run("calibrate c --bootstraps 20 --use-tension 45,25.5 --json -"), 0) << err_;
  const json uses = json::parse(out_)["use_levels"];
  ASSERT_EQ(uses.size(), 2U);
  EXPECT_EQ(uses[0]["effective_tension_N"], 45);
  EXPECT_EQ(uses[1]["effective_tension_N"], 25.5);
  EXPECT_LT(uses[0]["ci95_B10"][0].get<double>(), uses[0]["B10"].get<double>());
}

TEST_F(CampaignProgram, FailsOnWhatItIsAskedToFailOn) {
  const std::string example = "calibrate '" EXAMPLES "/tendon_alt' --bootstraps 200 --json r.json ";
  EXPECT_EQ(run(example + "--fail-on left-out"), 3);
  EXPECT_TRUE(fs::exists(folder_ / "r.json"));
  EXPECT_EQ(run(example + "--fail-on any"), 3);
  EXPECT_EQ(run(example + "--fail-on shape,fit"), 0);
  EXPECT_EQ(run(example + "--fail-on shape --keep-all-levels"), 3);
  EXPECT_EQ(run("calibrate c --bootstraps 20 --fail-on left-out,validation"), 0);
}

TEST_F(CampaignProgram, WrongUsageIsStatusTwo) {
  for (const char* arguments :
       {"calibrate", "calibrate c --fail-on nothing", "calibrate c --bootstraps 0",
        "calibrate c --threads 0", "calibrate c --use-tension 0", "calibrate c --use-tension -1",
        "calibrate c --use-tension nan", "calibrate c --use-tension inf", "calibrate c --seed x",
        "calibrate c --batch", "calibrate c --table t.csv",
        "calibrate c --batch --table t.csv --out m.toml",
        "calibrate c --batch --table t.csv --report p.html", "calibrate c --json same --out same",
        "calibrate c --json same --report ./same", "calibrate c --json - --out -"}) {
    const auto before = files();
    EXPECT_EQ(run(arguments), 2) << arguments;
    EXPECT_FALSE(err_.empty());
    EXPECT_EQ(files(), before) << arguments;
  }
}

TEST_F(CampaignProgram, HelpHasAnExample) {
  EXPECT_EQ(run("calibrate --help"), 0);
  EXPECT_NE(out_.find("Example: host_sim calibrate host_sim/examples/tendon_alt"),
            std::string::npos);
}

}  // namespace
