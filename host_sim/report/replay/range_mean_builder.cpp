#include "host_sim/report/replay/range_mean_builder.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace host_sim {
namespace {

constexpr double kClassesReal = RangeMeanBuilder::kClasses;
/// Class numbers stay below this, so that neighbours are exact in a double.
constexpr double kLargestClass = 1LL << 50;

}  // namespace

RangeMeanBuilder::RangeMeanBuilder(double first_step_N)
    : range_step_N_(first_step_N), mean_step_N_(first_step_N), cells_(kClasses * kClasses) {
  if (!std::isfinite(first_step_N) || first_step_N <= 0) {
    throw std::invalid_argument("RangeMeanBuilder: the class width must be finite and above 0");
  }
}

void RangeMeanBuilder::push(double from_N, double to_N, double count, double damage) {
  const double range_N = std::abs(to_N - from_N);
  const double mean_N = from_N + (to_N - from_N) / 2;

  while (std::floor(range_N / range_step_N_) >= kClassesReal) {
    widen_ranges();
  }
  double mean_class = std::floor(mean_N / mean_step_N_);
  const auto fits = [this](double candidate) {
    const double lowest = empty_ ? candidate : std::min(lowest_mean_class_, candidate);
    const double highest = empty_ ? candidate : std::max(highest_mean_class_, candidate);
    return std::abs(candidate) < kLargestClass && highest - lowest < kClassesReal;
  };
  while (!fits(mean_class)) {
    widen_means();
    mean_class = std::floor(mean_N / mean_step_N_);
  }
  lowest_mean_class_ = empty_ ? mean_class : std::min(lowest_mean_class_, mean_class);
  highest_mean_class_ = empty_ ? mean_class : std::max(highest_mean_class_, mean_class);
  empty_ = false;

  const double range_class = std::floor(range_N / range_step_N_);
  highest_range_class_ = std::max(highest_range_class_, range_class);
  Cell& target = cell(range_class, mean_class);
  target.count += count;
  target.damage += damage;
}

RangeMeanMatrix RangeMeanBuilder::finish() const {
  RangeMeanMatrix matrix;
  matrix.range_step_N = range_step_N_;
  matrix.mean_step_N = mean_step_N_;
  if (empty_) {
    return matrix;
  }
  matrix.mean_min_N = lowest_mean_class_ * mean_step_N_;
  matrix.ranges = static_cast<std::size_t>(highest_range_class_) + 1;
  matrix.means = static_cast<std::size_t>(highest_mean_class_ - lowest_mean_class_) + 1;
  for (std::size_t r = 0; r < matrix.ranges; ++r) {
    for (std::size_t m = 0; m < matrix.means; ++m) {
      const std::size_t mean_slot = slot(lowest_mean_class_ + static_cast<double>(m));
      const Cell& source = cells_[r * kClasses + mean_slot];
      matrix.count.push_back(source.count);
      matrix.damage.push_back(source.damage);
    }
  }
  return matrix;
}

std::size_t RangeMeanBuilder::slot(double mean_class) {
  const double wrapped = mean_class - kClassesReal * std::floor(mean_class / kClassesReal);
  return static_cast<std::size_t>(wrapped);
}

RangeMeanBuilder::Cell& RangeMeanBuilder::cell(double range_class, double mean_class) {
  return cells_[static_cast<std::size_t>(range_class) * kClasses + slot(mean_class)];
}

void RangeMeanBuilder::widen_ranges() {
  std::vector<Cell> merged(cells_.size());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Cell& into = merged[i / kClasses / 2 * kClasses + i % kClasses];
    into.count += cells_[i].count;
    into.damage += cells_[i].damage;
  }
  cells_ = std::move(merged);
  range_step_N_ *= 2;
  highest_range_class_ = std::floor(highest_range_class_ / 2);
}

void RangeMeanBuilder::widen_means() {
  mean_step_N_ *= 2;
  if (empty_) {
    return;
  }
  std::vector<Cell> merged(cells_.size());
  const auto used = static_cast<std::size_t>(highest_mean_class_ - lowest_mean_class_) + 1;
  for (std::size_t i = 0; i < used; ++i) {
    const double mean_class = lowest_mean_class_ + static_cast<double>(i);
    const std::size_t from = slot(mean_class);
    const std::size_t into = slot(std::floor(mean_class / 2));
    for (std::size_t r = 0; r < kClasses; ++r) {
      merged[r * kClasses + into].count += cells_[r * kClasses + from].count;
      merged[r * kClasses + into].damage += cells_[r * kClasses + from].damage;
    }
  }
  cells_ = std::move(merged);
  lowest_mean_class_ = std::floor(lowest_mean_class_ / 2);
  highest_mean_class_ = std::floor(highest_mean_class_ / 2);
}

}  // namespace host_sim
