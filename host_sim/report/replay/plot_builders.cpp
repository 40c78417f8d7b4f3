#include "host_sim/report/replay/plot_builders.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace host_sim {

EnvelopeBuilder::EnvelopeBuilder(std::size_t max_buckets)
    : max_buckets_(std::max<std::size_t>(2, max_buckets + max_buckets % 2)) {}

void EnvelopeBuilder::push(double time_s, double tension_N) {
  const Bucket sample{time_s, time_s, tension_N, tension_N, after_gap_};
  if (!buckets_.empty() && !after_gap_ && samples_in_last_ < samples_per_bucket_) {
    merge(buckets_.back(), sample);
    ++samples_in_last_;
    return;
  }
  if (buckets_.size() == max_buckets_) {
    halve();
  }
  buckets_.push_back(sample);
  samples_in_last_ = 1;
  after_gap_ = false;
}

Envelope EnvelopeBuilder::finish() const {
  Envelope envelope;
  envelope.samples_per_bucket = samples_per_bucket_;
  for (const Bucket& bucket : buckets_) {
    if (bucket.after_gap) {
      envelope.gaps.push_back(envelope.time_s.size());
    }
    envelope.time_s.push_back(bucket.first_s + (bucket.last_s - bucket.first_s) / 2);
    envelope.low_N.push_back(bucket.low_N);
    envelope.high_N.push_back(bucket.high_N);
  }
  return envelope;
}

void EnvelopeBuilder::merge(Bucket& into, const Bucket& later) {
  into.last_s = later.last_s;
  into.low_N = std::min(into.low_N, later.low_N);
  into.high_N = std::max(into.high_N, later.high_N);
}

void EnvelopeBuilder::halve() {
  const bool keep_gaps =
      4 * static_cast<std::size_t>(std::ranges::count(buckets_, true, &Bucket::after_gap)) <=
      max_buckets_;
  std::size_t kept = 0;
  bool paired = true;
  for (const Bucket& bucket : buckets_) {
    if (paired || (bucket.after_gap && keep_gaps)) {
      buckets_[kept++] = bucket;
      paired = false;
    } else {
      merge(buckets_[kept - 1], bucket);
      paired = true;
    }
  }
  buckets_.resize(kept);
  samples_per_bucket_ *= 2;
}

namespace {

constexpr std::size_t kPointsKeptPerRun = 2;

}  // namespace

TurningPointBuilder::TurningPointBuilder(std::size_t max_points)
    : max_runs_(std::max<std::size_t>(2, (max_points + 3) / 4 * 2)) {}

void TurningPointBuilder::push(double time_s, double tension_N) {
  const TurningPoint point{time_s, tension_N};
  const Run run{point, point, true};
  ++total_;
  if (!runs_.empty() && points_in_last_ < points_per_run_) {
    merge(runs_.back(), run);
    ++points_in_last_;
    return;
  }
  if (runs_.size() == max_runs_) {
    halve();
  }
  runs_.push_back(run);
  points_in_last_ = 1;
}

TurningPoints TurningPointBuilder::finish() const {
  TurningPoints result;
  result.total = total_;
  result.points.reserve(kPointsKeptPerRun * runs_.size());
  for (const Run& run : runs_) {
    const bool low_is_earlier = run.low.time_s <= run.high.time_s;
    result.points.push_back(low_is_earlier ? run.low : run.high);
    if (!run.single) {
      result.points.push_back(low_is_earlier ? run.high : run.low);
    }
  }
  return result;
}

void TurningPointBuilder::merge(Run& into, const Run& later) {
  if (later.low.tension_N < into.low.tension_N) {
    into.low = later.low;
  }
  if (later.high.tension_N >= into.high.tension_N) {
    into.high = later.high;
  }
  into.single = false;
}

void TurningPointBuilder::halve() {
  const std::size_t half = runs_.size() / 2;
  for (std::size_t i = 0; i < half; ++i) {
    Run merged = runs_[2 * i];
    merge(merged, runs_[2 * i + 1]);
    runs_[i] = merged;
  }
  runs_.resize(half);
  points_per_run_ *= 2;
}

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

TrajectoryBuilder::TrajectoryBuilder(std::size_t max_points)
    : max_points_(std::max<std::size_t>(2, max_points + max_points % 2)) {}

void TrajectoryBuilder::push(double time_s, double damage) {
  last_ = {time_s, damage};
  if (pushed_ % stride_ == 0 && kept_.size() == max_points_) {
    const std::size_t half = kept_.size() / 2;
    for (std::size_t i = 0; i < half; ++i) {
      kept_[i] = kept_[2 * i];
    }
    kept_.resize(half);
    stride_ *= 2;
  }
  if (pushed_ % stride_ == 0) {
    kept_.push_back(last_);
  }
  ++pushed_;
}

Trajectory TrajectoryBuilder::finish() const {
  Trajectory trajectory;
  const auto append = [&trajectory](const Reading& reading) {
    trajectory.time_s.push_back(reading.time_s);
    trajectory.damage.push_back(reading.damage);
  };
  std::for_each(kept_.begin(), kept_.end(), append);
  const bool last_is_kept = pushed_ == 0 || (pushed_ - 1) % stride_ == 0;
  if (!last_is_kept) {
    append(last_);
  }
  return trajectory;
}

LifeCurve life_curve(double damage_per_repeat, double weibull_shape, std::size_t points) {
  constexpr double kLastBroken = 0.999;
  LifeCurve curve;
  const double last_damage = std::pow(-std::log1p(-kLastBroken), 1 / weibull_shape);
  const double last_repeat = last_damage / damage_per_repeat;
  if (!(damage_per_repeat > 0) || !std::isfinite(damage_per_repeat) || !(weibull_shape > 0) ||
      !std::isfinite(last_repeat)) {
    return curve;
  }
  for (std::size_t i = 0; i < points; ++i) {
    const double fraction = static_cast<double>(i) / static_cast<double>(points - 1);
    curve.repeats.push_back(fraction * last_repeat);
    curve.broken.push_back(-std::expm1(-std::pow(fraction * last_damage, weibull_shape)));
  }
  return curve;
}

}  // namespace host_sim
