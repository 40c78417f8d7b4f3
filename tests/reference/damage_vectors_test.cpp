#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "host_sim/reference/cycle_damage.hpp"
#include "host_sim/reference/equations.hpp"
#include "tests/reference/vectors.hpp"

namespace host_sim::reference::testing {
namespace {

using nlohmann::json;

const std::map<std::string, std::string>& other_laws() {
  static const std::map<std::string, std::string> laws{
      {"miner_haibach", "a second slope below the endurance limit"},
      {"miner_original", "no damage below the endurance limit"},
      {"miner_consistent", "an endurance limit that falls with the damage"},
      {"walker_amplitude", "mean stress by Walker"},
      {"swt", "mean stress by Smith, Watson and Topper"},
      {"goodman", "mean stress by Goodman"}};
  return laws;
}

TEST(DamageVectors, EveryKindIsCheckedOrNamedAsAnotherLaw) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "damage_vectors.json");
  EXPECT_FALSE(vectors->empty());
  for (const json& vector : *vectors) {
    const auto kind = vector.at("kind").get<std::string>();
    const bool checked = kind == "miner_elementary" || kind == "gerber" || kind == "gerber_life";
    EXPECT_TRUE(checked || other_laws().contains(kind)) << "unknown kind " << kind;
  }
}

// A straight line through (SD, ND) with slope k and no mean stress: A = ND * SD^k, gamma = k.
TEST(DamageVectors, MinerElementary) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "damage_vectors.json");
  int rows = 0;
  for (const json& vector : *vectors) {
    if (vector.at("kind") != "miner_elementary") {
      continue;
    }
    const double k = vector.at("k");
    const Constants constants{
        .ultimate_tension_N = 1e6,
        .hysteresis_N = 0,
        .ipl_scale = vector["ND"].get<double>() * std::pow(vector["SD"].get<double>(), k),
        .ipl_exponent = k,
        .weibull_shape = 1};
    for (std::size_t i = 0; i < vector["amplitude"].size(); ++i) {
      const double amplitude_N = vector["amplitude"][i];
      const double expected = vector["damage"][i];
      const double damage =
          vector["cycles"][i].get<double>() * cycle_damage({-amplitude_N, amplitude_N}, constants);
      EXPECT_NEAR(damage, expected, vector["rtol"].get<double>() * expected);
      ++rows;
    }
  }
  EXPECT_EQ(rows, 24);
}

TEST(DamageVectors, Gerber) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "damage_vectors.json");
  std::size_t rows = 0;
  for (const json& vector : *vectors) {
    if (vector.at("kind") != "gerber") {
      continue;
    }
    for (const json& row : vector.at("rows_Su_Sa_Sm_Sar")) {
      const double expected = row[3];
      EXPECT_NEAR(gerber_effective_tension({.mean_N = row[2], .amplitude_N = row[1]}, row[0]),
                  expected, 1e-14 * expected)
          << row;
      ++rows;
    }
  }
  EXPECT_EQ(rows, 69U);
}

// N = 0.5 * (Sar / sig_f)^(1/b) is the inverse power law with gamma = -1/b, A = 0.5 * sig_f^gamma.
TEST(DamageVectors, GerberLife) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "damage_vectors.json");
  int count = 0;
  for (const json& vector : *vectors) {
    if (vector.at("kind") != "gerber_life") {
      continue;
    }
    const double effective_N = gerber_effective_tension(
        {.mean_N = vector["Sm"], .amplitude_N = vector["Sa"]}, vector["Su"]);
    EXPECT_NEAR(effective_N, vector["Sar"].get<double>(), 0.0501);
    const double gamma = -1.0 / vector["b"].get<double>();
    const double scale = 0.5 * std::pow(vector["sig_f"].get<double>(), gamma);
    const double expected = vector["N"];
    EXPECT_NEAR(ipl_life_cycles(effective_N, scale, gamma), expected, 0.5);
    ++count;
  }
  EXPECT_EQ(count, 1);
}

TEST(DamageVectors, OtherLawsAreNotPartOfTheModel) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "damage_vectors.json");
  std::map<std::string, int> counts;
  for (const json& vector : *vectors) {
    ++counts[vector.at("kind").get<std::string>()];
  }
  std::ostringstream skipped;
  for (const auto& [kind, reason] : other_laws()) {
    skipped << "\n  " << counts[kind] << " x " << kind << ": " << reason;
  }
  GTEST_SKIP() << "NOT CHECKED: these vectors follow laws that the model does not have "
                  "(Gerber, one straight inverse power law, Miner):"
               << skipped.str();
}

}  // namespace
}  // namespace host_sim::reference::testing
