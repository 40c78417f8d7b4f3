#include "host_sim/report/replay/turning_point_builder.hpp"

#include <algorithm>

namespace host_sim {
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

}  // namespace host_sim
