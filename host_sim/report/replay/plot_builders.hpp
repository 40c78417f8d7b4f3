#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// Reduces a stream of samples to at most `max_buckets` bands. A bucket holds a run of neighbouring
/// samples; when all are full, pairs merge and the runs double. Every bucket keeps its exact
/// minimum and maximum.
class EnvelopeBuilder {
 public:
  /// `max_buckets` is rounded up to an even number of at least 2.
  explicit EnvelopeBuilder(std::size_t max_buckets = 2000);

  /// Adds a finite sample; time must not fall. Amortised constant time.
  void push(double time_s, double tension_N);
  /// Samples are missing before the next one: it begins a bucket, unless there are so many gaps
  /// that a quarter of all buckets does.
  void gap() { after_gap_ = !buckets_.empty(); }

  [[nodiscard]] Envelope finish() const;

 private:
  struct Bucket {
    double first_s;
    double last_s;
    double low_N;
    double high_N;
    bool after_gap;
  };
  static void merge(Bucket& into, const Bucket& later);
  void halve();

  bool after_gap_ = false;
  std::size_t max_buckets_;
  std::uint64_t samples_per_bucket_ = 1;
  std::uint64_t samples_in_last_ = 0;
  std::vector<Bucket> buckets_;
};

/// Keeps at most `max_points` turning points of a stream. While all fit, all are kept. Beyond that
/// the list is thinned: of every run of k neighbouring turning points only the lowest and the
/// highest stay, and k doubles when the room is used up. The extremes of the whole stream are
/// therefore always among the kept points, and the points stay spread over the whole time.
class TurningPointBuilder {
 public:
  /// `max_points` is rounded up to a multiple of 4, at least 4.
  explicit TurningPointBuilder(std::size_t max_points = 2000);

  /// Adds a turning point; time must not fall. Amortised constant time.
  void push(double time_s, double tension_N);

  [[nodiscard]] TurningPoints finish() const;

 private:
  /// The lowest and the highest of a run; the same point twice in a run of one.
  struct Run {
    TurningPoint low;
    TurningPoint high;
    bool single;
  };
  static void merge(Run& into, const Run& later);
  void halve();

  std::size_t max_runs_;
  std::uint64_t points_per_run_ = 2;
  std::uint64_t points_in_last_ = 0;
  std::uint64_t total_ = 0;
  std::vector<Run> runs_;
};

/// Sorts counted cycles into at most `kClasses` classes of range by `kClasses` classes of mean. The
/// classes start `first_step_N` wide; when a cycle does not fit, that axis doubles its class width
/// and neighbours merge, so count and damage are conserved. Class borders lie on multiples of the
/// width, so the matrix does not depend on the order of the cycles.
class RangeMeanBuilder {
 public:
  static constexpr std::size_t kClasses = 64;

  /// `first_step_N` must be finite and above 0; throws std::invalid_argument otherwise.
  explicit RangeMeanBuilder(double first_step_N);

  /// Adds a cycle from one turning point to the next; both finite, `count` 1 or 0.5.
  void push(double from_N, double to_N, double count, double damage);

  /// The used part of the grid: ranges from 0, means from the lowest to the highest used class.
  [[nodiscard]] RangeMeanMatrix finish() const;

 private:
  struct Cell {
    double count = 0;
    double damage = 0;
  };
  /// The grid is addressed by the class number of the mean modulo kClasses.
  [[nodiscard]] static std::size_t slot(double mean_class);
  [[nodiscard]] Cell& cell(double range_class, double mean_class);
  void widen_ranges();
  void widen_means();

  double range_step_N_;
  double mean_step_N_;
  bool empty_ = true;
  double highest_range_class_ = 0;
  double lowest_mean_class_ = 0;
  double highest_mean_class_ = 0;
  std::vector<Cell> cells_;
};

/// Keeps at most `max_points` + 1 readings of a stream: every k-th and always the first and the
/// last, where k doubles when the room is used up.
class TrajectoryBuilder {
 public:
  /// `max_points` is rounded up to an even number of at least 2.
  explicit TrajectoryBuilder(std::size_t max_points = 1000);

  /// Adds a reading; time must not fall. Amortised constant time.
  void push(double time_s, double damage);

  [[nodiscard]] Trajectory finish() const;

 private:
  struct Reading {
    double time_s;
    double damage;
  };

  std::size_t max_points_;
  std::uint64_t stride_ = 1;
  std::uint64_t pushed_ = 0;
  Reading last_{};
  std::vector<Reading> kept_;
};

/// Share of broken wires over repeats of one profile; both vectors have equal length.
struct LifeCurve {
  std::vector<double> repeats;
  std::vector<double> broken;  ///< 0..1
};

/// The Weibull distribution 1 - exp(-(n D)^beta) of the life n in repeats of a profile that does
/// damage D a pass, at `points` (at least 2) evenly spaced n from 0 to where 99.9 % have broken.
/// Empty when the damage is not above 0, or a number is not finite.
/// Source: eqs. (15) and (19) of the paper with Miner's sum in place of the constant load.
[[nodiscard]] LifeCurve life_curve(double damage_per_repeat, double weibull_shape,
                                   std::size_t points = 201);

}  // namespace host_sim
