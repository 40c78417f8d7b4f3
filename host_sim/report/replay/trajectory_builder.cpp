#include "host_sim/report/replay/trajectory_builder.hpp"

#include <algorithm>

namespace host_sim {

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

}  // namespace host_sim
