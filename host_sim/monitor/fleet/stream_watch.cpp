#include "host_sim/monitor/fleet/stream_watch.hpp"

#include <algorithm>
#include <tuple>

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

// Where a frame is the next of both counts, it is of the one that is due: the one heard longer ago.
Speakers::Count& Speakers::count_of(std::uint8_t counter) {
  const auto ahead = [counter](const Count& count) {
    const int delta = (counter - count.counter) & 0x0f;
    return count.is_there && delta != 0 && delta <= Checker::kMaxDelta ? delta : 16;
  };
  auto& [one, other] = counts_;
  if (ahead(one) != ahead(other)) {
    return ahead(one) < ahead(other) ? one : other;
  }
  if (ahead(one) < 16) {
    return one.time_ns <= other.time_ns ? one : other;
  }
  const auto strength = [](const Count& count) {
    return std::tuple(count.is_there, count.in_a_row, count.time_ns);
  };
  Count& weaker = strength(one) <= strength(other) ? one : other;
  weaker = {};
  return weaker;
}

void Speakers::hear(std::uint8_t counter, const hal::CanFrame& frame, std::int64_t time_ns,
                    std::int64_t most_ns) {
  constexpr std::int64_t kDoubled_ns = 5 * kMillisecond_ns;  // sent again, its receipt not heard
  if (frame == last_ && time_ns - last_ns_ < kDoubled_ns) {
    return;
  }
  last_ = frame;
  last_ns_ = time_ns;
  for (Count& count : counts_) {
    if (time_ns - count.time_ns > most_ns || ++count.passed_over >= kInARow) {
      count = {};
    }
  }
  Count& count = count_of(counter);
  const bool next = count.is_there && ((count.counter + 1) & 0x0f) == counter;
  count = {counter, time_ns, next ? count.in_a_row + 1 : 0, 0, true};
  two_ = two_ || std::all_of(counts_.begin(), counts_.end(),
                             [](const Count& one) { return one.in_a_row >= kInARow; });
}

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
    if (stream_ && frame_.cycle_ms != 0) {
      speakers_.hear(protocol::e2e::counter_of(*stream_, frame), frame, time_ns,
                     kMillisecond_ns * frame_.cycle_ms * Checker::kMaxDelta);
    }
    if (status != Status::repeated) {
      count_interval(time_ns, view);
    }
    last_ns_ = time_ns;
    same_again_ = last_ == frame;
    last_ = frame;
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
