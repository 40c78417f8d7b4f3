#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "support.hpp"

namespace lifemodel {
namespace {

using lifemodel_test::newtons;
using lifemodel_test::to_newtons;
using nlohmann::json;
using pack::to_double;

/// Steps of 1e-6, so that decimals that differ only by rounding compare equal.
long long rounded(double value) {
  return std::llround(value * 1e6);
}

struct Count {
  std::vector<std::pair<double, double>> full;  ///< without direction: lower, higher
  std::vector<std::pair<double, double>> half;

  void full_cycle(Tension a, Tension b) {
    full.emplace_back(std::min(to_newtons(a), to_newtons(b)),
                      std::max(to_newtons(a), to_newtons(b)));
  }
  void half_cycle(Tension a, Tension b) {
    half.emplace_back(std::min(to_newtons(a), to_newtons(b)),
                      std::max(to_newtons(a), to_newtons(b)));
  }
};

struct ObserveInto {
  Count* count;
  void full(Tension a, Tension b, CycleDamage) const { count->full_cycle(a, b); }
  void half(Tension a, Tension b, CycleDamage) const { count->half_cycle(a, b); }
};

struct OpenInto {
  Count* count;
  void full(Tension a, Tension b) const { count->full_cycle(a, b); }
  void half(Tension a, Tension b) const { count->half_cycle(a, b); }
};

/// The whole count of a series by the parts that the estimator is made of.
Count count_series(const std::vector<double>& series) {
  Count count;
  TurningPoints filter;
  Residue<512> residue;
  std::vector<FullCycle> closed(1);
  struct Half {
    Count* count;
    void half(Tension a, Tension b) const { count->half_cycle(a, b); }
    void overflow() const { FAIL(); }
  } finals{&count};
  const auto take = [&](Tension point) {
    std::uint32_t taken = 0;
    while (taken == 0) {
      const auto done =
          residue.take([&](std::uint32_t) { return point; }, 0, 1, 1, closed.data(), finals);
      taken = done.taken;
      if (done.closed != 0) {
        count.full_cycle(closed[0].from(), closed[0].to());
      }
    }
  };
  for (const double value : series) {
    filter.push(newtons(value), TensionRange::from_raw(1), take);
  }
  if (filter.directed()) {
    residue.open(filter.run().candidate(), OpenInto{&count});
  }
  return count;
}

using Multiset = std::map<std::tuple<long long, long long>, double>;

Multiset by_range_and_mean(const Count& count) {
  Multiset result;
  for (const auto& [low, high] : count.full) {
    result[{rounded(high - low), rounded((low + high) / 2)}] += 1;
  }
  for (const auto& [low, high] : count.half) {
    result[{rounded(high - low), rounded((low + high) / 2)}] += 0.5;
  }
  return result;
}

std::map<long long, double> by_range(const Multiset& counts) {
  std::map<long long, double> result;
  for (const auto& [key, count] : counts) {
    result[std::get<0>(key)] += count;
  }
  return result;
}

/// Counts agree where ranges and means agree to 1e-5 (values in the files have that many digits).
void expect_near(const Multiset& ours, const json& expected) {
  double total_ours = 0;
  for (const auto& [key, count] : ours) {
    total_ours += count;
  }
  double total_expected = 0;
  for (const auto& row : expected) {
    const double range = row[0];
    const double mean = row[1];
    const double count = row[2];
    total_expected += count;
    double found = 0;
    for (const auto& [key, n] : ours) {
      if (std::llabs(std::get<0>(key) - rounded(range)) <= 10 &&
          std::llabs(std::get<1>(key) - rounded(mean)) <= 10) {
        found += n;
      }
    }
    EXPECT_DOUBLE_EQ(found, count) << "range " << range << " mean " << mean;
  }
  EXPECT_DOUBLE_EQ(total_ours, total_expected);
}

Multiset expected_halves_and_fulls(const json& fulls, const json& residue) {
  Count count;
  for (const auto& cycle : fulls) {
    const double n = cycle.size() > 2 ? cycle[2].get<double>() : 1;
    for (int i = 0; i < static_cast<int>(n); ++i) {
      count.full_cycle(newtons(cycle[0].get<double>()), newtons(cycle[1].get<double>()));
    }
  }
  for (std::size_t i = 1; i < residue.size(); ++i) {
    count.half_cycle(newtons(residue[i - 1].get<double>()), newtons(residue[i].get<double>()));
  }
  return by_range_and_mean(count);
}

class Vectors : public testing::Test {
 protected:
  static json read(const char* name) {
    const std::filesystem::path path = std::filesystem::path(TENDONLIFE_VECTORS) / name;
    std::ifstream file(path);
    return file ? json::parse(file) : json{};
  }
};

TEST_F(Vectors, RainflowCounts) {
  const json vectors = read("rainflow_vectors.json");
  if (vectors.is_null()) {
    GTEST_SKIP() << "NO REFERENCE VECTORS in " << TENDONLIFE_VECTORS
                 << ": rainflow counts were not compared with published ones";
  }
  int compared = 0;
  for (const auto& vector : vectors) {
    SCOPED_TRACE(vector["name"].get<std::string>());
    const std::string method = vector["method"];
    const auto series = vector["series"].get<std::vector<double>>();
    const json& expected = vector["expected"];
    const Count count = count_series(series);
    const Multiset ours = by_range_and_mean(count);
    if (method == "astm_3point_half_residue" || method == "fourpoint_residue_half") {
      if (expected.contains("cycles_range_mean_count")) {
        expect_near(ours, expected["cycles_range_mean_count"]);
      }
      if (expected.contains("counts_by_range")) {
        const auto ranges = by_range(ours);
        double total = 0;
        for (const auto& row : expected["counts_by_range"]) {
          double found = 0;
          for (const auto& [range, n] : ranges) {
            found += std::llabs(range - rounded(row[0])) <= 10 ? n : 0;
          }
          EXPECT_DOUBLE_EQ(found, row[1].get<double>()) << row.dump();
          total += row[1].get<double>();
        }
        double all = 0;
        for (const auto& [range, n] : ranges) {
          all += n;
        }
        EXPECT_DOUBLE_EQ(all, total);
      }
      ++compared;
    } else if (method == "fourpoint") {
      const json& fulls = expected.contains("cycles_from_to") ? expected["cycles_from_to"]
                                                              : expected["counts_from_to"];
      EXPECT_EQ(ours, expected_halves_and_fulls(fulls, expected["residue"]));
      double closed = 0;
      for (const auto& cycle : fulls) {
        closed += cycle.size() > 2 ? cycle[2].get<double>() : 1;
      }
      EXPECT_EQ(static_cast<double>(count.full.size()), closed);
      ++compared;
    } else if (method == "racetrack") {
      TurningPoints filter;
      std::vector<double> filtered;
      const auto hysteresis = TensionRange::from_raw(
          distance(newtons(expected["h"].get<double>()), newtons(0)).raw() - 1);
      for (const double value : series) {
        filter.push(newtons(value), hysteresis,
                    [&](Tension t) { filtered.push_back(to_newtons(t)); });
      }
      filtered.push_back(to_newtons(filter.run().candidate()));
      const auto wanted = expected["filtered"].get<std::vector<double>>();
      ASSERT_EQ(filtered.size(), wanted.size());
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_NEAR(filtered[i], wanted[i], 1e-6);
      }
      ++compared;
    } else {
      // Other rules for the residue: the closed cycles and the residue itself are the same, so the
      // rule is applied to our residue here.
      std::map<long long, double> ranges;
      for (const auto& [low, high] : count.full) {
        ranges[rounded(high - low)] += 1;
      }
      if (method == "fourpoint_residue_full" || method == "fourpoint_residue_repeated") {
        std::vector<double> twice;
        if (method == "fourpoint_residue_repeated") {
          twice = series;
          twice.insert(twice.end(), series.begin(), series.end());
          ranges.clear();
          const Count repeated = count_series(twice);
          for (const auto& [low, high] : repeated.full) {
            ranges[rounded(high - low)] += 1;
          }
          for (const auto& [low, high] : count.full) {
            ranges[rounded(high - low)] -= 1;
          }
          std::erase_if(ranges, [](const auto& entry) { return entry.second == 0; });
        } else {
          for (const auto& [low, high] : count.half) {
            ranges[rounded(high - low)] += 1;
          }
        }
      } else if (method == "residue_din45667") {
        std::vector<long long> rising;
        std::vector<long long> falling;
        const Count& all = count;
        ASSERT_TRUE(all.full.empty());
        for (std::size_t i = 0; i < all.half.size(); ++i) {
          // Class width 1, as the vector says: values are rounded to whole classes.
          const long long range =
              std::llround(all.half[i].second) - std::llround(all.half[i].first);
          (i % 2 == 0 ? rising : falling).push_back(range);
        }
        std::sort(rising.rbegin(), rising.rend());
        std::sort(falling.rbegin(), falling.rend());
        for (std::size_t i = 0; i < std::min(rising.size(), falling.size()); ++i) {
          ranges[rounded(static_cast<double>(std::min(rising[i], falling[i])))] += 1;
        }
      } else {
        ADD_FAILURE() << "unknown method " << method;
      }
      std::map<long long, double> wanted;
      for (const auto& row : expected["counts_by_range"]) {
        wanted[rounded(row[0])] += row[1].get<double>();
      }
      EXPECT_EQ(ranges, wanted);
      ++compared;
    }
  }
  EXPECT_EQ(compared, static_cast<int>(vectors.size()));
  EXPECT_GE(compared, 20);
}

TEST_F(Vectors, GerberEffectiveStress) {
  const json vectors = read("damage_vectors.json");
  if (vectors.is_null()) {
    GTEST_SKIP() << "NO REFERENCE VECTORS in " << TENDONLIFE_VECTORS
                 << ": damage was not compared with published values";
  }
  int rows = 0;
  int elementary = 0;
  for (const auto& vector : vectors) {
    const std::string kind = vector["kind"];
    if (kind == "gerber") {
      for (const auto& row : vector["rows_Su_Sa_Sm_Sar"]) {
        // With exponent 1 and scale 2^20 the damage of a cycle is its effective stress in 2^-20.
        const double amplitude = row[1];
        const double mean = row[2];
        auto constants = lifemodel_test::paper_constants();
        constants.ultimate_tension_N = row[0];
        const auto stress = [&](double value) {
          return pack::tension(value, constants.ultimate_tension_N);
        };
        constants.ipl_exponent = 1;
        constants.ipl_scale = 1048576;
        const auto law = lifemodel_test::parameters_of(constants).law;
        if (std::fabs(mean) + amplitude >= constants.ultimate_tension_N) {
          EXPECT_EQ(to_double(law(stress(mean + amplitude), stress(mean - amplitude))), 1);
        } else {
          EXPECT_NEAR(to_double(law(stress(mean + amplitude), stress(mean - amplitude))) * 1048576 /
                          row[3].get<double>(),
                      1, 2e-6)
              << row.dump();
        }
        ++rows;
      }
    } else if (kind == "gerber_life") {
      // N = 0.5 (Sar / sig_f)^(1 / b): exponent -1/b = 12.8 is beyond 12, so only the stress is
      // compared.
      auto constants = lifemodel_test::paper_constants();
      constants.ultimate_tension_N = vector["Su"];
      constants.ipl_exponent = 1;
      constants.ipl_scale = 1048576;
      const double sa = vector["Sa"];
      const double sm = vector["Sm"];
      EXPECT_NEAR(to_double(lifemodel_test::parameters_of(constants).law(
                      pack::tension(sm + sa, constants.ultimate_tension_N),
                      pack::tension(sm - sa, constants.ultimate_tension_N))) *
                      1048576,
                  vector["Sar"].get<double>(), 0.06);
    } else if (kind == "miner_elementary") {
      auto constants = lifemodel_test::paper_constants();
      constants.ultimate_tension_N = 1000;
      constants.ipl_exponent = vector["k"].get<double>();
      constants.ipl_scale =
          vector["ND"].get<double>() * std::pow(vector["SD"].get<double>(), constants.ipl_exponent);
      const auto law = lifemodel_test::parameters_of(constants).law;
      const auto amplitude = vector["amplitude"].get<std::vector<double>>();
      const auto cycles = vector["cycles"].get<std::vector<double>>();
      const auto damage = vector["damage"].get<std::vector<double>>();
      for (std::size_t i = 0; i < amplitude.size(); ++i) {
        const double ours = cycles[i] * to_double(law(pack::tension(amplitude[i], 1000),
                                                      pack::tension(-amplitude[i], 1000)));
        EXPECT_NEAR(ours, damage[i], vector["rtol"].get<double>() * damage[i]);
      }
      ++elementary;
    }
  }
  EXPECT_EQ(rows, 69);
  EXPECT_EQ(elementary, 3);
}

}  // namespace
}  // namespace lifemodel
