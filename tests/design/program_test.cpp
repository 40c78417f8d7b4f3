#include "tests/replay/program.hpp"

#include <nlohmann/json.hpp>
#include <utility>

namespace {

using nlohmann::json;

using DesignProgram = host_sim_test::Program;
using Names = std::vector<std::string>;

const std::string kDesign = "design --model model.toml ";

TEST_F(DesignProgram, FindsWhatIsLeftOut) {
  ASSERT_EQ(run(kDesign + "--tension 49 --json -"), 0) << err_;
  const json life = json::parse(out_);
  EXPECT_EQ(life["found"], "life");
  EXPECT_NEAR(life["life_cycles"].get<double>(), 770.081, 1e-3);
  EXPECT_NE(err_.find("Life: 770.1 cycles at a risk of 10 %"), std::string::npos) << err_;

  const std::vector<std::pair<std::string, std::string>> finds = {
      {"--life 770.0813675111821", "output_tension_max_N"},
      {"--tension 49 --life 770.0813675111821 --find bend", "bend_angle_deg"},
      {"--tension 49 --life 770.0813675111821 --find friction", "friction_coefficient"},
      {"--tension 49 --life 770.0813675111821 --find wire", "diameter_mm"}};
  for (const auto& [options, key] : finds) {
    ASSERT_EQ(run(kDesign + options + " --json -"), 0) << err_;
    EXPECT_NEAR(json::parse(out_)["tendon"][key].get<double>() / life["tendon"][key].get<double>(),
                1, 1e-11)
        << key;
  }
}

TEST_F(DesignProgram, TakesWhatIsGivenBeforeTheModel) {
  ASSERT_EQ(run(kDesign + "--tension 49 --bend-angle 180 --json -"), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["life_cycles"].get<double>(), 1450.567, 1e-3);
  ASSERT_EQ(run(kDesign + "--tension 49 --friction 0.09 --json -"), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["life_cycles"].get<double>(), 1339.096, 1e-3);
  ASSERT_EQ(run(kDesign + "--tension 49 --ultimate-tension 709.6 --json -"), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["life_cycles"].get<double>(), 6047.190, 1e-3);
  ASSERT_EQ(run(kDesign + "--tension 48.5 --tension-min 28.5 --json -"), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["effective_tension_N"].get<double>(), 39.98338, 1e-4);
  ASSERT_EQ(run(kDesign + "--tension 48.5 --load-ratio 0.5876288659793815 --json -"), 0) << err_;
  EXPECT_NEAR(json::parse(out_)["effective_tension_N"].get<double>(), 39.98338, 1e-4);
}

TEST_F(DesignProgram, TakesALifeInHours) {
  ASSERT_EQ(run(kDesign + "--life-hours 3 --cycles-per-minute 20 --json -"), 0) << err_;
  const json written = json::parse(out_);
  EXPECT_EQ(written["life_cycles"], 3600);
  EXPECT_NEAR(written["life_hours"].get<double>(), 3, 1e-12);
}

TEST_F(DesignProgram, WritesATableAndAPage) {
  ASSERT_EQ(run(kDesign + "--tension 49 --table t.csv --report r.html --test-tension 60"), 0)
      << err_;
  const std::string table = host_sim_test::contents(folder_ / "t.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "what,bend_angle_deg,friction_coefficient,output_tension_min_N,output_tension_max_N,"
            "diameter_mm,input_tension_peak_N,effective_tension_N,life_cycles");
  EXPECT_NE(table.find("\ndesign,270,0.128,49,49,0.457,89.568"), std::string::npos);
  // A header, the design, and 81 points of each of five bend angles.
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 2 + 5 * 81);
  EXPECT_NE(host_sim_test::contents(folder_ / "r.html").find("</html>"), std::string::npos);
  EXPECT_NE(out_.find("acceleration factor     1.441: a test at 60 N"), std::string::npos) << out_;
}

TEST_F(DesignProgram, TellsWhatDoesNotFitInOneLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "design: tension and life are both unknown: give --tension or --life\n"},
      {"--tension 49 --life 100",
       "design: nothing is unknown: leave out --tension or --life, or say by --find what else is "
       "wanted\n"},
      {"--tension 49 --life 100 --find bend --bend-angle 20",
       "design: --find bend: --bend-angle gives it\n"},
      {"--tension 49 --life 100 --find wire --diameter 1",
       "design: --find wire: --diameter or --ultimate-tension gives it\n"},
      {"--tension 49 --life 100 --find tension", "design: --find tension: --tension gives it\n"},
      {"--tension 49 --life 100 --find life", "design: --find life: --life gives it\n"},
      {"--tension 49 --life 100 --find risk --risk 0.1", "design: --find risk: --risk gives it\n"},
      {"--life 100 --find bend",
       "design: --find bend: the tension is unknown as well: give --tension\n"},
      {"--tension 49 --find safety",
       "design: --find safety: the life is unknown as well: give --life\n"},
      {"--tension 20 --tension-min 30", "design: --tension-min: 30 N is above --tension, 20 N\n"},
      {"--tension 49 --risk 0", "--risk: 0 is not a number above 0 and below 1\n"},
      {"--tension 49 --risk 1", "--risk: 1 is not a number above 0 and below 1\n"},
      {"--tension 49 --risk nan", "--risk: nan is not a number above 0 and below 1\n"},
      {"--tension nan", "--tension: nan is not a number from 0.01 to 1e+06\n"},
      {"--tension 49 --find mass", "--find: mass not in {"},
      {"--life-hours 3", "--life-hours requires --cycles-per-minute\n"},
      {"--tension 49 --friction 1.2", "--friction: 1.2 is not a number from 0 to 1\n"},
  };
  for (const auto& [options, message] : cases) {
    EXPECT_EQ(run(kDesign + options + " --json d.json --table d.csv --report d.html"), 2)
        << options;
    EXPECT_EQ(err_.substr(0, message.size()), message) << options;
    EXPECT_EQ(out_, "") << options;
    EXPECT_EQ(files(), (Names{"good.csv", "model.toml"})) << options;
  }
}

TEST_F(DesignProgram, TellsALifeThatNoTensionMeets) {
  EXPECT_EQ(run(kDesign + "--life 1e9 --json d.json --report d.html"), 1);
  EXPECT_EQ(err_,
            "design: no output tension from 0.01 to 97.05 N gives a life of 1e+09 cycles at a risk "
            "of 10 %; accepted: a life of 164.7 to 1.115e+08 cycles\n");
  EXPECT_EQ(files(), (Names{"good.csv", "model.toml"}));
  EXPECT_EQ(run(kDesign + "--tension 49 --test-tension 100 --json d.json"), 1);
  EXPECT_NE(err_.find("the input tension of the test reaches 182.8 N"), std::string::npos) << err_;
  EXPECT_EQ(files(), (Names{"good.csv", "model.toml"}));
}

}  // namespace
