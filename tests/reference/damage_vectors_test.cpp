#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "host_sim/reference/cycle_damage.hpp"
#include "host_sim/reference/equations.hpp"
#include "tests/reference/vectors.hpp"

namespace host_sim::reference::testing {
namespace {

using nlohmann::json;

const std::set<std::string>& other_laws() {
  static const std::set<std::string> laws{
      "miner_haibach", "miner_original", "miner_consistent", "walker_amplitude", "swt", "goodman"};
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

// Where such a law departs from the model (Gerber, one straight inverse power law, Miner) the model
// departs from its vectors; where it does not, it follows them.
void expect_another_mean_stress(const json& vector) {
  int others = 0;
  for (std::size_t i = 0; i < vector["S"].size(); ++i) {
    const double range_N = vector["S"][i];
    const double mean_N = vector["Sm"][i];
    const double theirs_N = vector["St"][i];
    const double ours_N =
        2 * gerber_effective_tension({mean_N, range_N / 2}, vector.value("Su", 510.0));
    if (mean_N == 0) {
      EXPECT_NEAR(ours_N, theirs_N, 1e-6) << vector["kind"];
    } else {
      others += std::abs(ours_N - theirs_N) > 0.02 * theirs_N ? 1 : 0;
    }
  }
  EXPECT_EQ(others, vector.value("gamma", 0.0) == 1 ? 0 : 3) << vector["kind"];
}

double elementary_damage(const json& vector, double cycles, double amplitude_N) {
  const double k = vector.at("k");
  const double scale = vector["ND"].get<double>() * std::pow(vector["SD"].get<double>(), k);
  return cycles * cycle_damage({-amplitude_N, amplitude_N}, {.ultimate_tension_N = 1e6,
                                                             .hysteresis_N = 0,
                                                             .ipl_scale = scale,
                                                             .ipl_exponent = k,
                                                             .weibull_shape = 1});
}

void expect_less_below_the_limit(const json& vector) {
  int below = 0;
  for (std::size_t i = 0; i < vector["amplitude"].size(); ++i) {
    const double amplitude_N = vector["amplitude"][i];
    const double theirs = vector["damage"][i];
    const double ours = elementary_damage(vector, vector["cycles"][i], amplitude_N);
    if (amplitude_N >= vector["SD"].get<double>()) {
      EXPECT_NEAR(ours, theirs, vector["rtol"].get<double>() * theirs) << vector["kind"];
    } else if (ours > 0) {
      EXPECT_LT(theirs, 0.6 * ours) << vector["kind"];
      ++below;
    }
  }
  EXPECT_GE(below, 2);
}

/// A life by a limit that falls is longer than the model's, and the same where all is far above it.
void expect_longer_lives(const json& vector) {
  for (std::size_t i = 0; i < vector["S_hat"].size(); ++i) {
    const double most_N = vector["S_hat"][i];
    double cycles = 0;
    double damage = 0;
    for (std::size_t j = 0; j < vector["cycles"].size(); ++j) {
      const double n = vector["cycles"][j];
      cycles += n;
      damage += elementary_damage(vector, n, most_N * vector["rel_amplitude"][j].get<double>());
    }
    const double unit = elementary_damage(vector, 1, most_N);
    const double ours = cycles * unit / damage;
    const double theirs = vector["A"][i];
    const double accepted = vector["atol"];
    EXPECT_GT(theirs, ours - accepted);
    EXPECT_EQ(theirs > ours + accepted, i + 1 < vector["S_hat"].size()) << most_N;
  }
}

TEST(DamageVectors, OtherLawsAreNotPartOfTheModel) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "damage_vectors.json");
  std::map<std::string, int> counts;
  for (const json& vector : *vectors) {
    const auto kind = vector.at("kind").get<std::string>();
    if (!other_laws().contains(kind)) {
      continue;
    }
    ++counts[kind];
    if (vector.contains("St")) {
      expect_another_mean_stress(vector);
    } else if (vector.contains("S_hat")) {
      expect_longer_lives(vector);
    } else {
      expect_less_below_the_limit(vector);
    }
  }
  for (const std::string& kind : other_laws()) {
    EXPECT_GE(counts[kind], 1) << kind;
  }
}

}  // namespace
}  // namespace host_sim::reference::testing
