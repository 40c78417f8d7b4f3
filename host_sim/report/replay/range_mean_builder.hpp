#pragma once

#include <cstddef>
#include <vector>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

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

}  // namespace host_sim
