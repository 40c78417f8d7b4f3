#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "firmware/protocol/messages.hpp"
#include "firmware/protocol/schema/plan.hpp"
#include "host_sim/monitor/fleet/wire_lives.hpp"

namespace host_sim::monitor {

/// The names of the schema.
std::string_view name_of(protocol::LifeState state);
std::string_view name_of(protocol::Quality quality);
std::string_view name_of(protocol::NmtState state);
std::string_view name_of(protocol::EmergencyCode code);
std::string_view name_of(protocol::AdviceState state);

/// What carries the damage of a node.
inline constexpr protocol::schema::Signal kDamageSignal =
    protocol::schema::signal_of(&protocol::LifeStatus::damage_ppb);

/// Damage or its rate, in ppb of a signal, as per cent with as many digits as a ppb needs and
/// no more: "12.1", "0.0000001"; ">=429.4967295" at the end of its range.
std::string percent_of(std::uint32_t ppb, const protocol::schema::Signal& signal = kDamageSignal);

/// A value with the time of the frame that brought it. Only frames that passed the integrity check
/// bring values.
template <class Value>
struct Timed {
  Value value{};
  std::int64_t time_ns = 0;
  bool stale = false;  ///< older than three of its frame's cycle times, or its node is gone
};

/// What became of the frames of one node and kind.
struct StreamView {
  std::string frame;  ///< name of the schema: "LifeStatus"
  std::uint64_t good = 0;
  std::uint64_t lost = 0;
  std::uint64_t repeated = 0;
  std::uint64_t wrong_sequence = 0;
  std::uint64_t damaged = 0;    ///< wrong CRC or length
  std::uint64_t malformed = 0;  ///< right CRC, and a value that the schema does not have
  /// How often it was silent for longer than its counter can show, and was begun anew. What was
  /// lost then is in no other count.
  std::uint64_t silences = 0;
  /// Times between two frames of the stream, counted in classes of interval_class_ms from 0 on, the
  /// last one open above. A class is a twentieth of the cycle, or 5 ms where there is none.
  static constexpr std::size_t kIntervalClasses = 40;
  std::uint32_t interval_class_ms = 5;
  std::array<std::uint64_t, kIntervalClasses> intervals{};
};

enum class EventKind : std::uint8_t {
  state,
  emergency,
  boot,
  vanished,
  back,
  epoch,
  integrity,
  two_controllers
};

/// One thing that happened to a node, for the timeline.
struct Event {
  EventKind kind = EventKind::state;
  std::int64_t time_ns = 0;
  std::string text;  ///< "inspect", "overload", "epoch opened: damage fell from 12.1 to 0 %"
  protocol::LifeState state = protocol::LifeState::unknown;  ///< after it
};

/// A point of the damage curve.
struct DamagePoint {
  std::int64_t time_ns = 0;
  std::uint32_t damage_ppb = 0;
  std::optional<std::uint32_t> rate_ppb_per_h;
};

/// All that is known of one node. Bounded: histories are thinned, never longer than their limits.
/// A node is known from its second heartbeat, or the first frame that passes the integrity check,
/// on: one damaged identifier makes no node.
struct NodeView {
  protocol::Node node = 0;
  bool vanished = false;  ///< nothing at all for three heartbeats
  std::int64_t last_seen_ns = 0;

  std::optional<Timed<protocol::NmtState>> heartbeat;
  std::optional<Timed<protocol::LifeStatus>> status;
  /// Highest damage and gravest state of this epoch that any genuine frame reported: what is shown
  /// never falls but for a proven new epoch (DamageWatch). So, too, for each tendon.
  std::uint32_t highest_damage_ppb = 0;
  protocol::LifeState gravest_state = protocol::LifeState::normal;
  /// Two controllers have reported as this node at once. It stays so: what is shown is of both.
  bool two_controllers = false;
  std::optional<Timed<protocol::detail::Identity>> identity;
  std::optional<Timed<protocol::detail::Cycles>> cycles;
  std::optional<Timed<protocol::detail::DamageRate>> rate;
  std::map<std::uint8_t, Timed<protocol::detail::TendonDamage>> tendons;  ///< by tendon
  /// Cycles by tendon, range class and mean class: index 64 tendon + 8 range + mean.
  std::map<std::uint16_t, Timed<protocol::detail::RainflowBin>> bins;
  std::optional<Timed<protocol::detail::RemainingLife>> remaining;  ///< of the whole life
  std::optional<Timed<protocol::detail::ConditionalLife>> conditional;
  std::optional<Timed<protocol::detail::BreakRisk>> break_risk;
  /// What happened to the wires, by tendon and what is counted: index 4 tendon + event.
  std::map<std::uint8_t, Timed<protocol::detail::WireHistory>> wires;
  std::map<std::uint8_t, Timed<protocol::detail::Advice>> advice;  ///< by tendon
  std::optional<Timed<protocol::detail::Storage>> storage;
  std::optional<Timed<protocol::detail::Timing>> timing;
  std::optional<Timed<protocol::detail::Bus>> bus;
  std::optional<Timed<protocol::Emergency>> emergency;  ///< the last; code none: all is over

  std::vector<WireLife> wire_lives;  ///< of wires that ended, oldest first

  std::vector<StreamView> streams;  ///< in order of the schema
  std::deque<Event> events;         ///< oldest first, at most kMostEvents
  std::deque<DamagePoint> curve;    ///< oldest first, at most kMostPoints, thinned evenly

  static constexpr std::size_t kMostEvents = 1000;
  static constexpr std::size_t kMostPoints = 4000;

  [[nodiscard]] std::uint64_t integrity_failures() const;
  /// The state to show.
  [[nodiscard]] protocol::LifeState life_state() const;
};

/// The pages that a node sends, by their names in JSON: the last one, or the last one of each
/// tendon or bin. What is here is taken from frames, marked as stale and shown in JSON.
inline constexpr std::tuple kNodePages{std::pair{"identity", &NodeView::identity},
                                       std::pair{"cycles", &NodeView::cycles},
                                       std::pair{"rate", &NodeView::rate},
                                       std::pair{"tendons", &NodeView::tendons},
                                       std::pair{"bins", &NodeView::bins},
                                       std::pair{"remaining", &NodeView::remaining},
                                       std::pair{"wires", &NodeView::wires},
                                       std::pair{"storage", &NodeView::storage},
                                       std::pair{"timing", &NodeView::timing},
                                       std::pair{"bus", &NodeView::bus},
                                       std::pair{"conditional", &NodeView::conditional},
                                       std::pair{"break_risk", &NodeView::break_risk},
                                       std::pair{"advice", &NodeView::advice}};
static_assert(std::tuple_size_v<decltype(kNodePages)> == protocol::detail::kPages);

/// Hands each page of `node` to `take`, with its name.
template <class Node, class Take>
void each_page(Node& node, Take take) {
  std::apply([&](const auto&... page) { (take(page.first, node.*(page.second)), ...); },
             kNodePages);
}

/// The state of a node, of which two controllers are the gravest: "worn", "two_controllers".
std::string_view state_name(const NodeView& node);

/// How much a node needs somebody to look at it: what is graver is more. 0: it is normal, or
/// nothing has been heard of it.
unsigned severity_of(const NodeView& node);
/// The same where its life state alone is known.
unsigned severity_of(protocol::LifeState state);

/// Keeps the damage curve of a view within kMostPoints: points come a step apart, and when there is
/// no room every second one goes and the step doubles. The last point is always the newest.
class DamageCurve {
 public:
  /// Two points are at least so far apart at first: the cycle of the status.
  static constexpr std::int64_t kFirstStep_ns = 100'000'000;

  void add(NodeView& view, const DamagePoint& point);

 private:
  std::int64_t step_ns_ = kFirstStep_ns;
};

/// Puts an event behind the others; where there is no room the oldest goes.
void add_event(NodeView& view, Event event);

/// The whole fleet, and the bus that it is on.
struct FleetView {
  std::int64_t now_ns = 0;
  std::string source;  ///< FrameSource::description()
  bool source_lost = false;
  bool source_ended = false;
  double bit_rate_bit_s = 0;
  bool bus_off = false;
  std::uint64_t frames = 0;
  std::uint64_t foreign_frames = 0;  ///< of no kind of the schema, or of no node that is known
  std::uint64_t error_frames = 0;
  std::uint64_t receive_overflows = 0;
  double bus_load_percent = 0;  ///< of the last second, at the bit rate given
  double frames_per_s = 0;
  std::map<protocol::Node, NodeView> nodes;
};

/// The nodes by severity_of(), the gravest first, and equal ones by their numbers.
std::vector<const NodeView*> gravest_first(const FleetView& fleet);

}  // namespace host_sim::monitor
