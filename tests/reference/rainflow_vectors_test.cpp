// The published counts. Our counters know two treatments of the residue: half cycles (ASTM), and
// left open (four-point). The others are built here from our residue: "repeated" counts the residue
// once more after itself, "full" takes each of its ranges for a full cycle, DIN 45667 pairs its
// rising with its falling ranges by size.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/reference/counts.hpp"
#include "tests/reference/signals.hpp"
#include "tests/reference/vectors.hpp"

namespace host_sim::reference::testing {
namespace {

using nlohmann::json;

/// Runs `check` on each vector of the method and expects the stated number of them.
void for_each_of(const json& vectors, const std::string& method, int expected_count,
                 const std::function<void(const json&)>& check) {
  int count = 0;
  for (const json& vector : vectors) {
    if (vector.at("method") == method) {
      SCOPED_TRACE(vector.at("name").get<std::string>());
      check(vector);
      ++count;
    }
  }
  EXPECT_EQ(count, expected_count) << "vectors of method " << method;
}

Signal points_of(const json& vector) {
  return turning_points(vector.at("series").get<Signal>());
}

void expect_counts(const CountsByRange& counts, const json& expected, double tolerance) {
  ASSERT_EQ(counts.size(), expected.size());
  auto row = expected.begin();
  for (const auto& [range, count] : counts) {
    EXPECT_NEAR(range, row->at(0).get<double>(), tolerance);
    EXPECT_EQ(count, row->at(1).get<double>()) << "range " << range;
    ++row;
  }
}

TEST(RainflowVectors, EveryMethodIsChecked) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  const std::vector<std::string> known{"astm_3point_half_residue",
                                       "fourpoint",
                                       "fourpoint_residue_repeated",
                                       "fourpoint_residue_half",
                                       "residue_din45667",
                                       "fourpoint_residue_full",
                                       "racetrack"};
  EXPECT_FALSE(vectors->empty());
  for (const json& vector : *vectors) {
    EXPECT_NE(std::find(known.begin(), known.end(), vector.at("method")), known.end())
        << vector.at("name") << " has a method that no test here knows: " << vector.at("method");
  }
}

TEST(RainflowVectors, AstmThreePoint) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  for_each_of(*vectors, "astm_3point_half_residue", 4, [](const json& vector) {
    const json& expected = vector.at("expected");
    const double tolerance = expected.value("tolerance", 1e-12);
    const AstmCount count = count_astm(points_of(vector));
    const json& rows = expected.at("cycles_range_mean_count");
    ASSERT_EQ(count.entries.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto& [cycle, weight] = count.entries[i];
      EXPECT_NEAR(std::abs(cycle.to_N - cycle.from_N), rows[i][0].get<double>(), tolerance);
      EXPECT_NEAR((cycle.to_N + cycle.from_N) / 2, rows[i][1].get<double>(), tolerance);
      EXPECT_EQ(weight, rows[i][2].get<double>());
    }
    if (expected.contains("counts_by_range")) {
      expect_counts(counts_by_range(half_cycles(count)), expected["counts_by_range"], tolerance);
    }
  });
}

TEST(RainflowVectors, FourPointWithHalfCyclesAgreesWithTheAstmVectors) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  for (const json& vector : *vectors) {
    SCOPED_TRACE(vector.at("name").get<std::string>());
    const Signal points = points_of(vector);
    EXPECT_EQ(half_cycles(count_four_point(points)), half_cycles(count_astm(points)));
  }
}

std::vector<std::pair<double, double>> sorted(const std::vector<Cycle>& cycles) {
  std::vector<std::pair<double, double>> pairs;
  pairs.reserve(cycles.size());
  for (const Cycle& cycle : cycles) {
    pairs.emplace_back(cycle.from_N, cycle.to_N);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<std::pair<double, double>> expected_cycles(const json& expected) {
  std::vector<std::pair<double, double>> pairs;
  if (expected.contains("cycles_from_to")) {
    pairs.reserve(expected["cycles_from_to"].size());
    for (const json& row : expected["cycles_from_to"]) {
      pairs.emplace_back(row[0], row[1]);
    }
  } else {
    for (const json& row : expected.at("counts_from_to")) {
      pairs.insert(pairs.end(), row[2].get<std::size_t>(), {row[0], row[1]});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(RainflowVectors, FourPoint) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  for_each_of(*vectors, "fourpoint", 11, [](const json& vector) {
    const FourPointCount count = count_four_point(points_of(vector));
    EXPECT_EQ(sorted(count.closed), expected_cycles(vector.at("expected")));
    EXPECT_EQ(count.residue, vector.at("expected").at("residue").get<Signal>());
  });
}

TEST(RainflowVectors, ResidueAsHalfCycles) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  for_each_of(*vectors, "fourpoint_residue_half", 1, [](const json& vector) {
    expect_counts(counts_by_range(half_cycles(count_four_point(points_of(vector)))),
                  vector.at("expected").at("counts_by_range"), 0.0);
  });
}

CountsByRange closed_by_range(const FourPointCount& count) {
  return counts_by_range(half_cycles(FourPointCount{count.closed, {}}));
}

TEST(RainflowVectors, ResidueAsFullCycles) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  for_each_of(*vectors, "fourpoint_residue_full", 1, [](const json& vector) {
    const FourPointCount count = count_four_point(points_of(vector));
    CountsByRange counts = closed_by_range(count);
    for (std::size_t i = 1; i < count.residue.size(); ++i) {
      counts[std::abs(count.residue[i] - count.residue[i - 1])] += 1.0;
    }
    expect_counts(counts, vector.at("expected").at("counts_by_range"), 0.0);
  });
}

TEST(RainflowVectors, ResidueRepeated) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  for_each_of(*vectors, "fourpoint_residue_repeated", 1, [](const json& vector) {
    const FourPointCount once = count_four_point(points_of(vector));
    Signal twice = once.residue;
    twice.insert(twice.end(), once.residue.begin(), once.residue.end());
    CountsByRange counts = closed_by_range(once);
    for (const auto& [range, count] : closed_by_range(count_four_point(turning_points(twice)))) {
      counts[range] += count;
    }
    expect_counts(counts, vector.at("expected").at("counts_by_range"), 0.0);
  });
}

// The vector is counted in classes of width one, centred on the whole numbers.
TEST(RainflowVectors, ResidueByDin45667) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  for_each_of(*vectors, "residue_din45667", 1, [](const json& vector) {
    Signal series = vector.at("series").get<Signal>();
    for (double& value : series) {
      value = std::round(value);
    }
    const FourPointCount count = count_four_point(turning_points(series));
    Signal rising;
    Signal falling;
    for (std::size_t i = 1; i < count.residue.size(); ++i) {
      const double swing = count.residue[i] - count.residue[i - 1];
      (swing > 0 ? rising : falling).push_back(std::abs(swing));
    }
    std::sort(rising.rbegin(), rising.rend());
    std::sort(falling.rbegin(), falling.rend());
    CountsByRange counts = closed_by_range(count);
    for (std::size_t i = 0; i < std::min(rising.size(), falling.size()); ++i) {
      counts[std::min(rising[i], falling[i])] += 1.0;
    }
    expect_counts(counts, vector.at("expected").at("counts_by_range"), 0.0);
  });
}

TEST(RainflowVectors, RacetrackFilter) {
  TENDONLIFE_LOAD_VECTORS_OR_SKIP(vectors, "rainflow_vectors.json");
  for_each_of(*vectors, "racetrack", 1, [](const json& vector) {
    const json& expected = vector.at("expected");
    EXPECT_EQ(turning_points(vector.at("series").get<Signal>(), expected.at("h").get<double>()),
              expected.at("filtered").get<Signal>());
  });
}

}  // namespace
}  // namespace host_sim::reference::testing
