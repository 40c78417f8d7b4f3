#include "host_sim/replay/watched.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/replay/constants.hpp"
#include "lifemodel/pack/pack.hpp"

namespace host_sim {

namespace {

/// Of the sheath without load.
double preload_N(const Model& model) {
  const Extension* const preload = extension_of(model.extensions, "friction_preload");
  return preload == nullptr ? 0 : value_if(*preload, "preload_N").value_or(0);
}

lifemodel::WatchLimits limits_of(const Model::Watch& watch, const Model& model) {
  return *lifemodel::pack::watch_limits({.minimum_tension_N = watch.minimum_tension_N,
                                         .broken_tension_N = watch.broken_tension_N,
                                         .broken_travel_mm = watch.broken_travel_mm,
                                         .slack_travel_mm = watch.slack_travel_mm},
                                        model.cable.ultimate_tension_N);
}

}  // namespace

std::string_view to_string(WireEvent event) {
  return event == WireEvent::slack ? "slack" : "broken";
}

Model::Watch suggested_watch(const Model& model) {
  const double play_mm =
      std::max(1.0, model.cable.diameter_mm * radians(model.sheath.bend_angle_deg));
  const double broken_N = preload_N(model) + model.counting.hysteresis_N;
  Model::Watch watch;
  if (broken_N > 0 && 2 * broken_N < model.cable.ultimate_tension_N) {
    watch.minimum_tension_N = 2 * broken_N;
    watch.broken_tension_N = broken_N;
    watch.broken_travel_mm = 10 * play_mm;
    watch.slack_travel_mm = play_mm;
  }
  return watch;
}

WireFollower::WireFollower(const Model& model, const lifemodel::Parameters& parameters, bool motion)
    : watch_(model.watch ? parameters.watch : limits_of(suggested_watch(model), model),
             parameters.hysteresis, parameters.sample_period_us),
      period_s_(1 / model.counting.sample_rate_Hz) {
  watched_.limits = model.watch ? *model.watch : suggested_watch(model);
  watched_.suggested = !model.watch;
  watched_.motion = motion;
}

void WireFollower::take(double time_s, std::uint64_t line, lifemodel::Tension tension,
                        lifemodel::Velocity velocity) {
  watch_.push(tension, velocity);
  just_broken_ = false;
  if (watch_.slack_events() != before_.slack_events || watch_.broken() != before_.broken) {
    note(time_s, line);
  }
}

void WireFollower::note(double time_s, std::uint64_t line) {
  const lifemodel::WatchReading now = watch_.reading();
  const auto add = [&](WireEvent event) {
    if (watched_.found.size() < Watched::kMostFound) {
      watched_.found.push_back({event, time_s, line});
    }
  };
  if (now.slack_events != before_.slack_events) {
    add(WireEvent::slack);
  }
  just_broken_ = now.broken && !before_.broken;
  if (just_broken_) {
    add(WireEvent::broken);
  }
  before_ = now;
}

Watched WireFollower::result() const {
  Watched result = watched_;
  const lifemodel::WatchReading now = watch_.reading();
  result.peak_ratio = std::ldexp(now.peak, -lifemodel::Tension::kFractionBits);
  result.above = now.above;
  result.below_minimum_s = now.below_minimum * period_s_;
  result.slack_events = now.slack_events;
  result.broken = now.broken;
  return result;
}

}  // namespace host_sim
