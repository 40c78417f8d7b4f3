#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "host_sim/model/model.hpp"
#include "host_sim/replay/replay.hpp"

namespace host_sim::compare {

/// A profile and the model that it is replayed with, by their files.
struct Replayed {
  std::string profile;
  std::string model_file;
  Model model;
};

/// One of the two that are compared.
struct Side {
  Replayed of;
  ReplayResult result;
  ReplayReport report;  ///< its plots; cycles in classes that those of the other side divide

  /// Of operation as in the profile; infinite without damage.
  [[nodiscard]] double hours(double repeats) const { return repeats * result.duration_s / 3600; }
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

/// Both replayed, and what differs. @param of_models two models with one profile, else two profiles
/// with one model
/// @param look is called now and then, and may throw
/// @throws InputError as replay()
Comparison compare(const Replayed& a, const Replayed& b, bool of_models,
                   const std::function<void()>& look);

/// "B lives 1.75 times as long as A: ..." in one sentence.
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

/// One object with the fields of the file format; what is infinite is null.
std::string compare_json(const Comparison& comparison);

/// A few lines for people.
void write_compare(std::ostream& out, const Comparison& comparison);

}  // namespace host_sim::compare
