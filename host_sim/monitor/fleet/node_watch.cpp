#include "host_sim/monitor/fleet/node_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "firmware/protocol/codec.hpp"

namespace host_sim::monitor {
namespace {

namespace detail = protocol::detail;
using protocol::schema::kFrames;

/// A value is stale when it is older than so many cycles of its frame, a node has vanished when
/// nothing was heard for so many heartbeats.
constexpr std::int64_t kCycles = 3;

/// Three cycle times of a frame.
constexpr std::int64_t limit_ns(const protocol::schema::Frame& frame) {
  return kCycles * frame.cycle_ms * 1'000'000;
}

constexpr std::int64_t kVanished_ns = limit_ns(protocol::schema::kHeartbeatFrame);
/// The pages share one frame and come in turn, so a page has as many cycles as there are pages; the
/// tendons and the bins share one page each, and come in turn there.
constexpr std::int64_t kPage_ns = limit_ns(protocol::schema::kLifeDetailFrame) * detail::kPages;

/// Marks what is older than its limit at a time, and all of a node that has vanished.
class StaleMarker {
 public:
  StaleMarker(std::int64_t now_ns, bool vanished) : now_ns_(now_ns), vanished_(vanished) {}

  template <class Value>
  void mark(Timed<Value>& timed, std::int64_t most_ns) const {
    timed.stale = vanished_ || now_ns_ - timed.time_ns > most_ns;
  }
  template <class Value>
  void mark(std::optional<Timed<Value>>& timed, std::int64_t most_ns) const {
    if (timed) {
      mark(*timed, most_ns);
    }
  }
  template <class Key, class Value>
  void mark(std::map<Key, Timed<Value>>& in_turn, std::int64_t most_ns) const {
    const std::int64_t most_of_all_ns = most_ns * static_cast<std::int64_t>(in_turn.size());
    for (auto& [key, value] : in_turn) {
      mark(value, most_of_all_ns);
    }
  }

 private:
  std::int64_t now_ns_;
  bool vanished_;
};

std::uint8_t key_of(const detail::TendonDamage& page) {
  return page.tendon;
}

std::uint16_t key_of(const detail::RainflowBin& bin) {
  return static_cast<std::uint16_t>(64 * bin.tendon + 8 * bin.range_class + bin.mean_class);
}

std::uint8_t key_of(const detail::WireHistory& wire) {
  return static_cast<std::uint8_t>(4 * wire.tendon + static_cast<std::uint8_t>(wire.event));
}

std::uint8_t key_of(const detail::Advice& page) {
  return page.tendon;
}

template <class Page>
bool take_into(std::optional<Timed<Page>>& last, const hal::CanFrame& frame, std::int64_t time_ns) {
  const auto page = protocol::decode<Page>(frame);
  if (page) {
    last = {*page, time_ns};
  }
  return static_cast<bool>(page);
}

template <class Key, class Page>
bool take_into(std::map<Key, Timed<Page>>& in_turn, const hal::CanFrame& frame,
               std::int64_t time_ns) {
  const auto page = protocol::decode<Page>(frame);
  if (page) {
    in_turn[key_of(*page)] = {*page, time_ns};
  }
  return static_cast<bool>(page);
}

/// Puts the page that a LifeDetail frame carries where the view has it; false, and nothing has
/// happened, where it is no page of the schema. @pre the frame passed the integrity check
bool take_page(const hal::CanFrame& frame, std::int64_t time_ns, NodeView& view) {
  bool taken = false;
  each_page(view,
            [&](const char*, auto& page) { taken = taken || take_into(page, frame, time_ns); });
  return taken;
}

/// Failures that follow each other within this are one event.
constexpr std::int64_t kFailuresApart_ns = 10'000'000'000;

std::uint32_t ppb_of(std::uint32_t damage_ppm) {
  constexpr std::uint32_t kLargest = std::numeric_limits<std::uint32_t>::max();
  return damage_ppm > kLargest / 1000 ? kLargest : damage_ppm * 1000;
}

}  // namespace

NodeWatch::NodeWatch(NodeView& view) : view_(view) {
  for (const protocol::schema::Frame* frame : kFrames) {
    streams_.emplace_back(*frame, view.node);
    view_.streams.push_back(empty_stream_view(*frame));
  }
}

void NodeWatch::take(std::size_t kind, const hal::CanFrame& frame, std::int64_t time_ns) {
  using protocol::e2e::Status;
  StreamView& stream = view_.streams[kind];
  const Status status = streams_[kind].take(frame, time_ns, stream);
  if (status == Status::wrong_crc || status == Status::wrong_length) {
    was_damaged(time_ns, stream);
    return;
  }
  if (kFrames[kind]->sender != protocol::schema::Sender::node) {
    return;
  }
  look_for_a_second_speaker(time_ns);
  const bool of_another_count = status == Status::wrong_sequence ||
                                (status == Status::repeated && !streams_[kind].is_the_same_again());
  if (status == Status::initial || of_another_count) {
    break_runs(kind);
  }
  if (of_another_count && kFrames[kind] == &protocol::schema::kLifeDetailFrame) {
    damage_.records_of_another();
  }
  if (!protocol::e2e::is_usable(status)) {
    is_alive(time_ns);
    take_of_two(kind, frame, time_ns);
    return;
  }
  known_ = known_ || kFrames[kind]->integrity.has_value();
  if (kFrames[kind] == &protocol::schema::kHeartbeatFrame) {
    take_heartbeat(frame, time_ns, stream);
  } else if (kFrames[kind] == &protocol::schema::kLifeStatusFrame) {
    take_status(frame, time_ns, stream);
  } else if (kFrames[kind] == &protocol::schema::kLifeDetailFrame) {
    take_detail(frame, time_ns, stream);
  } else {
    take_emergency(frame, time_ns, stream);
  }
}

void NodeWatch::take_heartbeat(const hal::CanFrame& frame, std::int64_t time_ns,
                               StreamView& stream) {
  const auto heartbeat = protocol::decode<protocol::Heartbeat>(frame);
  if (!heartbeat) {
    ++stream.malformed;
    return;
  }
  is_alive(time_ns);
  known_ = ++heartbeats_ >= 2 || known_;
  view_.heartbeat = {heartbeat->state, time_ns};
  if (heartbeat->state == protocol::NmtState::boot_up) {
    for (std::size_t kind = 0; kind < streams_.size(); ++kind) {
      streams_[kind].begin_anew();
      break_runs(kind);
    }
    note(EventKind::boot, time_ns, "started");
  }
}

void NodeWatch::take_status(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& stream) {
  is_alive(time_ns);
  const auto status = protocol::decode<protocol::LifeStatus>(frame);
  if (!status) {
    ++stream.malformed;
    return;
  }
  const bool first = !view_.status;
  const protocol::LifeState before = view_.life_state();
  const bool of_the_graver =
      !view_.two_controllers || !view_.status ||
      status->damage_ppb >= view_.status->value.damage_ppb ||
      time_ns - view_.status->time_ns > limit_ns(protocol::schema::kLifeStatusFrame);
  if (of_the_graver) {
    view_.status = {*status, time_ns};
  }
  const bool trusted = status->quality != protocol::Quality::untrusted &&
                       status->state != protocol::LifeState::unknown;
  if (view_.two_controllers) {
    damage_.raise(status->damage_ppb);
    damage_.raise(status->state);
  } else if (const auto before_ppb = damage_.report(status->damage_ppb, status->state, trusted)) {
    note(EventKind::epoch, time_ns,
         fmt::format("epoch opened: damage fell from {} to {} %", percent_of(*before_ppb),
                     percent_of(damage_.highest_ppb())));
  }
  show_damage(time_ns);
  if (first || before != view_.life_state()) {
    note(EventKind::state, time_ns, std::string(name_of(view_.life_state())));
  }
}

/// What another speaker reported does not go with the counters of the first.
void NodeWatch::take_of_two(std::size_t kind, const hal::CanFrame& frame, std::int64_t time_ns) {
  if (view_.two_controllers && kFrames[kind] == &protocol::schema::kLifeStatusFrame) {
    take_status(frame, time_ns, view_.streams[kind]);
  }
}

void NodeWatch::look_for_a_second_speaker(std::int64_t time_ns) {
  const auto hears_two = [](const StreamWatch& stream) { return stream.two_speakers(); };
  if (!view_.two_controllers && std::any_of(streams_.begin(), streams_.end(), hears_two)) {
    view_.two_controllers = true;
    note(EventKind::two_controllers, time_ns, "two controllers have this node id");
  }
}

void NodeWatch::break_runs(std::size_t kind) {
  if (kFrames[kind] == &protocol::schema::kLifeStatusFrame) {
    damage_.broken();
  } else if (kFrames[kind] == &protocol::schema::kLifeDetailFrame) {
    wires_.restarted();
    for (auto& [tendon, damage] : tendons_) {
      damage.broken();
    }
  }
}

void NodeWatch::take_storage(const detail::Storage& storage) {
  const bool may_be_more = is_at_least(
      protocol::schema::signal_of(&detail::Storage::worst_unsaved_ppb), storage.worst_unsaved_ppb);
  const auto unsaved_ppb = may_be_more ? std::nullopt : std::optional(storage.worst_unsaved_ppb);
  damage_.record(storage.sequence, unsaved_ppb);
  for (auto& [tendon, damage] : tendons_) {
    damage.record(storage.sequence, unsaved_ppb);
  }
}

void NodeWatch::take_tendon(const detail::TendonDamage& tendon, std::int64_t time_ns) {
  DamageWatch& damage = tendons_[tendon.tendon];
  const bool trusted = tendon.state != protocol::LifeState::unknown && view_.status &&
                       view_.status->value.quality != protocol::Quality::untrusted;
  if (view_.two_controllers) {
    damage.raise(tendon.damage_ppb);
    damage.raise(tendon.state);
  } else if (const auto before_ppb = damage.report(tendon.damage_ppb, tendon.state, trusted)) {
    wires_.epoch_opened(tendon.tendon, *before_ppb, time_ns);
  }
  detail::TendonDamage& shown = view_.tendons.at(tendon.tendon).value;
  shown.damage_ppb = damage.highest_ppb();
  shown.state = graver(damage.gravest(), tendon.state);
  damage_.raise(tendon.damage_ppb);
  view_.highest_damage_ppb = damage_.highest_ppb();
}

void NodeWatch::take_detail(const hal::CanFrame& frame, std::int64_t time_ns, StreamView& stream) {
  is_alive(time_ns);
  if (!take_page(frame, time_ns, view_)) {
    ++stream.malformed;
    return;
  }
  if (const auto storage = protocol::decode<detail::Storage>(frame)) {
    take_storage(*storage);
  } else if (const auto tendon = protocol::decode<detail::TendonDamage>(frame)) {
    take_tendon(*tendon, time_ns);
  }
  if (!view_.two_controllers) {
    follow_wires(frame, time_ns);
  }
}

void NodeWatch::follow_wires(const hal::CanFrame& frame, std::int64_t time_ns) {
  if (const auto tendon = protocol::decode<detail::TendonDamage>(frame)) {
    wires_.take(*tendon);
  } else if (const auto cycles = protocol::decode<detail::Cycles>(frame)) {
    wires_.take(*cycles);
  } else if (const auto bin = protocol::decode<detail::RainflowBin>(frame)) {
    wires_.take(*bin);
  } else if (const auto wire = protocol::decode<detail::WireHistory>(frame)) {
    const auto damage = view_.tendons.find(wire->tendon);
    wires_.take(*wire, damage == view_.tendons.end() ? 0 : damage->second.value.damage_ppb,
                time_ns);
  }
  view_.wire_lives = wires_.ended();
}

void NodeWatch::take_emergency(const hal::CanFrame& frame, std::int64_t time_ns,
                               StreamView& stream) {
  is_alive(time_ns);
  const auto emergency = protocol::decode<protocol::Emergency>(frame);
  if (!emergency) {
    ++stream.malformed;
    return;
  }
  view_.emergency = {*emergency, time_ns};
  damage_.raise(ppb_of(emergency->damage_ppm));
  view_.highest_damage_ppb = damage_.highest_ppb();
  note(EventKind::emergency, time_ns, std::string(name_of(emergency->code)));
}

void NodeWatch::show_damage(std::int64_t time_ns) {
  view_.highest_damage_ppb = damage_.highest_ppb();
  view_.gravest_state = damage_.gravest();
  DamagePoint point{.time_ns = time_ns, .damage_ppb = damage_.highest_ppb(), .rate_ppb_per_h = {}};
  if (view_.rate && !view_.rate->stale &&
      view_.rate->value.ppb_per_h != detail::DamageRate::kUnknownRate) {
    point.rate_ppb_per_h = view_.rate->value.ppb_per_h;
  }
  curve_.add(view_, point);
}

void NodeWatch::is_alive(std::int64_t time_ns) {
  view_.last_seen_ns = time_ns;
  if (std::exchange(view_.vanished, false)) {
    note(EventKind::back, time_ns, "heard again");
  }
}

void NodeWatch::was_damaged(std::int64_t time_ns, const StreamView& stream) {
  if (!last_damaged_ns_ || time_ns - *last_damaged_ns_ > kFailuresApart_ns) {
    note(EventKind::integrity, time_ns, "damaged frames: " + stream.frame);
  }
  last_damaged_ns_ = time_ns;
}

void NodeWatch::note(EventKind kind, std::int64_t time_ns, std::string text) {
  add_event(
      view_,
      {.kind = kind, .time_ns = time_ns, .text = std::move(text), .state = view_.life_state()});
}

void NodeWatch::look_for_silence(std::int64_t now_ns, std::int64_t heard_from_ns) {
  const std::int64_t silent_from_ns = std::max(view_.last_seen_ns, heard_from_ns);
  if (!view_.vanished && now_ns - silent_from_ns > kVanished_ns) {
    view_.vanished = true;
    note(EventKind::vanished, silent_from_ns + kVanished_ns, "not heard for three heartbeats");
  }
}

void NodeWatch::mark_stale(std::int64_t now_ns) {
  const StaleMarker marker(now_ns, view_.vanished);
  marker.mark(view_.heartbeat, limit_ns(protocol::schema::kHeartbeatFrame));
  marker.mark(view_.status, limit_ns(protocol::schema::kLifeStatusFrame));
  each_page(view_, [&](const char*, auto& page) { marker.mark(page, kPage_ns); });
  if (view_.emergency) {
    view_.emergency->stale = view_.vanished;
  }
}

}  // namespace host_sim::monitor
