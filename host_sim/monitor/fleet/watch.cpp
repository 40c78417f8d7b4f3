#include "host_sim/monitor/fleet/watch.hpp"

#include <algorithm>

#include "hal/files/interruption.hpp"

namespace host_sim::monitor {

using hal::files::Interruption;
using hal::files::stop_if_interrupted;

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kUpdate{50};

/// Frames until the next update is due.
void take_frames(FrameSource& source, Fleet& fleet, std::span<Observer* const> observers) {
  const Clock::time_point until = Clock::now() + kUpdate;
  for (Clock::time_point now = Clock::now(); now < until; now = Clock::now()) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - now);
    const auto seen = source.next(std::max(left, std::chrono::milliseconds(1)));
    if (!seen) {
      return;
    }
    fleet.see(*seen);
    for (Observer* observer : observers) {
      observer->see(*seen);
    }
    if (source.state() == FrameSource::State::ended) {
      return;
    }
  }
}

bool is_over(const FrameSource& source, std::span<Observer* const> observers) {
  const auto wants_end = [](Observer* observer) { return observer->wants_end(); };
  const auto outlives = [](const Observer* observer) { return observer->outlives_log(); };
  return std::any_of(observers.begin(), observers.end(), wants_end) ||
         (source.state() == FrameSource::State::ended &&
          std::none_of(observers.begin(), observers.end(), outlives));
}

bool is_interrupted() {
  try {
    stop_if_interrupted();
    return false;
  } catch (const Interruption&) {
    return true;
  }
}

}  // namespace

void watch(FrameSource& source, Fleet& fleet, std::span<Observer* const> observers,
           std::optional<std::chrono::milliseconds> most) {
  const Clock::time_point began = Clock::now();
  do {
    try {
      take_frames(source, fleet, observers);
    } catch (const Interruption&) {  // of a source that was waited for: the loop ends with it
    }
    fleet.source_is(source.state(), source.description());
    fleet.tick(source.now_ns());
    for (Observer* observer : observers) {
      observer->update(fleet.view());
    }
  } while (!is_over(source, observers) && !is_interrupted() &&
           !(most && Clock::now() - began >= *most));
  for (Observer* observer : observers) {
    observer->finish();
  }
}

}  // namespace host_sim::monitor
