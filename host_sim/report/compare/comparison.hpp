#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim::compare {

/// One of the two that are compared.
struct Side {
  std::string profile;  ///< file
  std::string model;    ///< file
  /// Cycles are in classes that those of the other side divide, or that divide them.
  ReplayReport report;
  std::string unit;  ///< of what the profile gives: N or A

  /// Of operation as in the profile; infinite without damage.
  [[nodiscard]] double hours(double repeats) const { return repeats * report.duration_s / 3600; }
  [[nodiscard]] double peak_tension_N() const {
    return report.peak_ratio * report.ultimate_tension_N;
  }
};

/// What differs between two models.
struct Difference {
  std::string name;         ///< table.key, as in their files
  std::optional<double> a;  ///< none where the model has no such number
  std::optional<double> b;
  /// The B10 life of A with this one from B, over that of A; none where that cannot be replayed.
  std::optional<double> life_ratio;
};

/// The first samples by which two profiles differ.
struct FirstDifference {
  double time_s = 0;         ///< as A has it, or B where A has ended
  std::uint64_t line_a = 0;  ///< 0: the profile has ended
  std::uint64_t line_b = 0;
  double a = 0;  ///< what the profiles give, in N or A
  double b = 0;
};

/// Cycles of one class of range and mean, halves counting 0.5.
struct CycleClass {
  std::array<double, 2> range_N{};
  std::array<double, 2> mean_N{};
  std::array<double, 2> cycles{};  ///< of A, of B
  std::array<double, 2> damage{};

  [[nodiscard]] double more_damage() const { return damage[1] - damage[0]; }
};

struct Comparison {
  bool of_models = false;  ///< else of profiles
  std::array<Side, 2> sides;
  std::vector<Difference> differences;   ///< of models: what changes the life most is first
  std::optional<FirstDifference> first;  ///< of profiles; none where all samples are equal
  std::vector<CycleClass> classes;       ///< that hold cycles: what differs most in damage is first
  /// Time since the first sample after which the damages are apart by more than kApart of the
  /// larger at the end; none where they never are while both last.
  std::optional<double> apart_s;

  [[nodiscard]] const Side& a() const { return sides[0]; }
  [[nodiscard]] const Side& b() const { return sides[1]; }
};

inline constexpr double kApart = 0.01;

/// How much of `a` is `b`; 1 where both are 0 or infinite, and infinite or 0 where one of them is.
double ratio(double b, double a);

/// "The wire lives 1.75 times as long with model B as with A ...", a sentence.
std::string sentence_of(const Comparison& comparison);

/// A number of both sides, as table and page list them.
struct Quantity {
  std::string name;
  std::string unit;  ///< may be empty
  std::array<double, 2> values{};
};
std::vector<Quantity> quantities_of(const Comparison& comparison);

/// The first difference as a sentence, empty of models.
std::string first_of(const Comparison& comparison);

}  // namespace host_sim::compare
