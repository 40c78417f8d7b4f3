#include "host_sim/monitor/bus/frame_source.hpp"

#include <algorithm>
#include <thread>
#include <utility>

namespace host_sim::monitor {

LogSource::LogSource(std::unique_ptr<LogReader> reader, std::string name, double speed)
    : reader_(std::move(reader)), name_(std::move(name)), speed_(speed) {}

void LogSource::fill() {
  if (waiting_ || ended_) {
    return;
  }
  waiting_ = reader_->next();
  ended_ = !waiting_;
  if (!waiting_) {
    return;
  }
  if (!began_once_) {
    began_once_ = true;
    begin_ns_ = waiting_->time_ns;
    last_ns_ = begin_ns_;
    began_ = Clock::now();
  }
  waiting_->time_ns = std::max(waiting_->time_ns, last_ns_);
}

LogSource::Clock::time_point LogSource::due() const {
  // Held within a century, so that a log with a leap of time overflows nothing.
  constexpr double kMost_ns = 3e18;
  const double since_ns = static_cast<double>(waiting_->time_ns - begin_ns_) / speed_;
  return began_ +
         std::chrono::nanoseconds(static_cast<std::int64_t>(std::clamp(since_ns, 0.0, kMost_ns)));
}

std::optional<SeenFrame> LogSource::next(std::chrono::milliseconds most) {
  fill();
  if (!waiting_) {
    std::this_thread::sleep_for(most);
    return std::nullopt;
  }
  if (speed_ > 0) {
    const Clock::time_point at = due();
    const Clock::time_point latest = Clock::now() + most;
    std::this_thread::sleep_until(std::min(at, latest));
    if (at > latest) {
      return std::nullopt;
    }
  }
  std::optional<SeenFrame> given = std::exchange(waiting_, std::nullopt);
  last_ns_ = given->time_ns;
  fill();  // so that the end is known with the last frame
  return given;
}

FrameSource::State LogSource::state() const {
  return ended_ ? State::ended : State::running;
}

std::string LogSource::description() const {
  return ended_ ? name_ + ", at its end" : name_;
}

std::int64_t LogSource::now_ns() const {
  if (!waiting_ || speed_ <= 0) {
    return last_ns_;
  }
  const std::chrono::duration<double, std::nano> elapsed = Clock::now() - began_;
  const double now_ns = static_cast<double>(begin_ns_) + elapsed.count() * speed_;
  const auto most_ns = static_cast<double>(waiting_->time_ns);
  return std::max(last_ns_,
                  now_ns < most_ns ? static_cast<std::int64_t>(now_ns) : waiting_->time_ns);
}

}  // namespace host_sim::monitor
