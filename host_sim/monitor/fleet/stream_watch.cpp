#include "host_sim/monitor/fleet/stream_watch.hpp"

#include <algorithm>

namespace host_sim::monitor {
namespace {

using protocol::e2e::Checker;
using protocol::e2e::Status;

constexpr std::int64_t kMillisecond_ns = 1'000'000;
/// Frames that are not cyclic leave at most ten a second: the counter has been through after this.
constexpr std::int64_t kUncyclicSilence_ns =
    std::int64_t{protocol::e2e::kCounters} * 100 * kMillisecond_ns;

bool is_genuine(Status status) {
  return status != Status::wrong_crc && status != Status::wrong_length &&
         status != Status::other_frame;
}

void add(const protocol::e2e::Counts& before, const protocol::e2e::Counts& after,
         StreamView& view) {
  view.good += after.good - before.good;
  view.lost += after.lost - before.lost;
  view.repeated += after.repeated - before.repeated;
  view.wrong_sequence += after.wrong_sequence - before.wrong_sequence;
  view.damaged += after.damaged - before.damaged;
}

}  // namespace

StreamWatch::StreamWatch(const protocol::schema::Frame& frame, protocol::Node node)
    : frame_(frame) {
  if (frame.integrity) {
    stream_ = protocol::e2e::stream_of(frame, node);
    checker_.emplace(*stream_);
  }
}

Status StreamWatch::take(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& view) {
  const Status status = check(frame, time_ns, view);
  if (is_genuine(status)) {
    if (status != Status::repeated) {
      count_interval(time_ns, view);
    }
    last_ns_ = time_ns;
  }
  return status;
}

void StreamWatch::begin_anew() {
  if (stream_) {
    checker_.emplace(*stream_);
    last_ns_.reset();
  }
}

Status StreamWatch::check(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& view) {
  if (!checker_) {
    const bool whole = frame.length == frame_.length;
    ++(whole ? view.good : view.damaged);
    return whole ? Status::ok : Status::wrong_length;
  }
  const std::int64_t silence_ns = last_ns_ ? time_ns - *last_ns_ : 0;
  const std::int64_t cycle_ns = frame_.cycle_ms * kMillisecond_ns;
  Checker next = *checker_;
  Status status = next.check(frame);
  const bool out_of_step =
      frame_.cycle_ms != 0 ? silence_ns > Checker::kMaxDelta * cycle_ns
                           : silence_ns > kUncyclicSilence_ns && !protocol::e2e::is_usable(status);
  if (out_of_step && is_genuine(status)) {
    next = Checker(*stream_);
    status = next.check(frame);
    ++view.silences;
    add({}, next.counts(), view);
  } else {
    add(checker_->counts(), next.counts(), view);
  }
  checker_ = next;
  return status;
}

void StreamWatch::count_interval(std::int64_t time_ns, StreamView& view) {
  if (!last_ns_ || time_ns < *last_ns_) {
    return;
  }
  const std::int64_t class_ns = view.interval_class_ms * kMillisecond_ns;
  const auto interval_class = static_cast<std::size_t>((time_ns - *last_ns_) / class_ns);
  ++view.intervals[std::min(interval_class, StreamView::kIntervalClasses - 1)];
}

StreamView empty_stream_view(const protocol::schema::Frame& frame) {
  StreamView view;
  view.frame = frame.name;
  if (frame.cycle_ms != 0) {
    view.interval_class_ms = std::max(1u, frame.cycle_ms / 20u);
  }
  return view;
}

}  // namespace host_sim::monitor
