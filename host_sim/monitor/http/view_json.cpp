#include "host_sim/monitor/http/view_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "firmware/protocol/schema/plan.hpp"
#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {
namespace {

/// The name of a raw value; empty where it has none.
std::string_view value_name(const protocol::schema::Signal& signal, std::uint32_t raw) {
  for (const protocol::schema::ValueName& value : signal.values) {
    if (value.value == raw) {
      return value.name;
    }
  }
  return {};
}

/// The double nearest to raw times the factor of the signal.
double physical(const protocol::schema::Signal& signal, std::uint32_t raw) {
  double digits = 0;
  double divisor = 1;
  bool fraction = false;
  for (const char c : signal.factor) {
    if (c == '.') {
      fraction = true;
    } else {
      digits = 10 * digits + (c - '0');
      divisor *= fraction ? 10 : 1;
    }
  }
  return raw * digits / divisor;
}

/// A member as its signal names it: the name of its value, true or false, or the physical value.
template <class Member>
nlohmann::json field_json(const protocol::schema::Signal& signal, Member member) {
  if constexpr (std::is_same_v<Member, bool>) {
    return member;
  } else {
    const auto raw = static_cast<std::uint32_t>(member);
    const std::string_view name = value_name(signal, raw);
    if (!name.empty()) {
      return std::string(name);
    }
    if (signal.factor == "1") {
      return raw;
    }
    return physical(signal, raw);
  }
}

/// A message with the names of the frame plan, as in the DBC: {"Damage": 0.0123, ..}. The values
/// that stand for themselves or more are named once more: {.., "at_least": ["Damage"]}.
template <class Message>
nlohmann::json message_json(const Message& message) {
  nlohmann::json json = nlohmann::json::object();
  const auto put = [&](const auto& field) {
    json[std::string(field.signal.name)] = field_json(field.signal, message.*(field.member));
    if (is_at_least(field.signal, static_cast<std::uint32_t>(message.*(field.member)))) {
      json["at_least"].push_back(field.signal.name);
    }
  };
  std::apply([&](const auto&... fields) { (put(fields), ...); },
             protocol::schema::Layout<Message>::kFields);
  return json;
}

using nlohmann::json;

constexpr double kPpb = 1e9;

std::int64_t microseconds(std::int64_t time_ns) {
  return time_ns / 1000;
}

template <class Message>
json timed_json(const Timed<Message>& timed) {
  json result = message_json(timed.value);
  result["time_us"] = microseconds(timed.time_ns);
  result["stale"] = timed.stale;
  return result;
}

template <class Message>
void put(json& node, const char* name, const std::optional<Timed<Message>>& timed) {
  if (timed) {
    node[name] = timed_json(*timed);
  }
}

template <class Key, class Message>
void put(json& node, const char* name, const std::map<Key, Timed<Message>>& by_number) {
  json& messages = node[name] = json::object();
  for (const auto& [number, timed] : by_number) {
    messages[std::to_string(number)] = timed_json(timed);
  }
}

json stream_json(const StreamView& stream) {
  json intervals = json::object();
  for (std::size_t i = 0; i < stream.intervals.size(); ++i) {
    if (stream.intervals[i] > 0) {
      intervals[std::to_string(i)] = stream.intervals[i];
    }
  }
  return {{"good", stream.good},
          {"lost", stream.lost},
          {"repeated", stream.repeated},
          {"wrong_sequence", stream.wrong_sequence},
          {"damaged", stream.damaged},
          {"malformed", stream.malformed},
          {"silences", stream.silences},
          {"intervals", intervals},
          {"interval_class_ms", stream.interval_class_ms}};
}

const char* event_kind_name(EventKind kind) {
  switch (kind) {
    case EventKind::state:
      return "state";
    case EventKind::emergency:
      return "emergency";
    case EventKind::boot:
      return "boot";
    case EventKind::vanished:
      return "vanished";
    case EventKind::back:
      return "back";
    case EventKind::epoch:
      return "epoch";
    case EventKind::integrity:
      return "integrity";
    case EventKind::two_controllers:
      return "two_controllers";
  }
  return "";
}

json event_json(const Event& event) {
  return {{"kind", event_kind_name(event.kind)},
          {"time_us", microseconds(event.time_ns)},
          {"words", event.text},
          {"state", name_of(event.state)}};
}

json point_json(const DamagePoint& point) {
  json result = {microseconds(point.time_ns), point.damage_ppb / kPpb};
  if (point.rate_ppb_per_h) {
    result.push_back(*point.rate_ppb_per_h / kPpb);
  }
  return result;
}

/// What the history of a node has of a time: damage, rate and life state; empty where it has none.
json partial_json(const NodeView& node, std::int64_t time_ns) {
  const auto after = [time_ns](const auto& one) { return one.time_ns > time_ns; };
  const auto next_point = std::find_if(node.curve.begin(), node.curve.end(), after);
  if (next_point == node.curve.begin()) {
    return json::object();
  }
  const DamagePoint& point = *std::prev(next_point);
  json result = {{"node", node.node},
                 {"partial", true},
                 {"highest_damage", point.damage_ppb / kPpb},
                 {"status", {{"time_us", microseconds(point.time_ns)}, {"stale", false}}}};
  if (is_at_least(kDamageSignal, point.damage_ppb)) {
    result["at_least"] = {"highest_damage"};
  }
  if (point.rate_ppb_per_h) {
    result["rate"] = {{"DamageRate", *point.rate_ppb_per_h / kPpb},
                      {"time_us", microseconds(point.time_ns)},
                      {"stale", false}};
  }
  const auto next_event = std::find_if(node.events.begin(), node.events.end(), after);
  protocol::LifeState state = protocol::LifeState::unknown;
  if (next_event != node.events.begin()) {
    state = std::prev(next_event)->state;
    result["life_state"] = name_of(state);
  }
  result["severity"] = severity_of(state);
  for (const char* none : {"streams", "tendons", "bins", "wires", "advice"}) {
    result[none] = json::object();
  }
  return result;
}

bool same(const Event& one, const Event& other) {
  return one.time_ns == other.time_ns && one.kind == other.kind && one.state == other.state &&
         one.text == other.text;
}

/// Events join at the end and leave at the front, so the new ones follow the last old one.
nlohmann::json after_last(const std::deque<Event>* before, const std::deque<Event>& after) {
  auto first = after.begin();
  if (before != nullptr && !before->empty()) {
    first = std::find_if(after.rbegin(), after.rend(), [&](const Event& event) {
              return same(event, before->back());
            }).base();
  }
  nlohmann::json events = nlohmann::json::array();
  std::transform(first, after.end(), std::back_inserter(events), event_json);
  return events;
}

std::string ppb_text(std::uint32_t ppb) {
  constexpr std::uint32_t kOne = 1'000'000'000;
  return fmt::format("{}.{:09}", ppb / kOne, ppb % kOne);
}

}  // namespace

json node_json(const NodeView& node) {
  json result = {{"node", node.node},
                 {"vanished", node.vanished},
                 {"state", state_name(node)},
                 {"life_state", name_of(node.life_state())},
                 {"two_controllers", node.two_controllers},
                 {"severity", severity_of(node)},
                 {"last_seen_us", microseconds(node.last_seen_ns)},
                 {"highest_damage", node.highest_damage_ppb / kPpb},
                 {"integrity_failures", node.integrity_failures()}};
  if (is_at_least(kDamageSignal, node.highest_damage_ppb)) {
    result["at_least"] = {"highest_damage"};
  }
  if (node.heartbeat) {
    result["heartbeat"] = timed_json(Timed<protocol::Heartbeat>{
        {node.heartbeat->value}, node.heartbeat->time_ns, node.heartbeat->stale});
  }
  put(result, "status", node.status);
  each_page(node, [&](const char* name, const auto& page) { put(result, name, page); });
  put(result, "emergency", node.emergency);
  json& streams = result["streams"] = json::object();
  for (const StreamView& stream : node.streams) {
    streams[stream.frame] = stream_json(stream);
  }
  return result;
}

json history_json(const NodeView& node) {
  json events = json::array();
  for (const Event& event : node.events) {
    events.push_back(event_json(event));
  }
  json curve = json::array();
  for (const DamagePoint& point : node.curve) {
    curve.push_back(point_json(point));
  }
  return {{"events", std::move(events)}, {"curve", std::move(curve)}};
}

json fleet_json(const FleetView& fleet) {
  json nodes = json::object();
  for (const auto& [number, node] : fleet.nodes) {
    nodes[std::to_string(number)] = node_json(node);
  }
  return {{"now_us", microseconds(fleet.now_ns)},
          {"source", fleet.source},
          {"source_lost", fleet.source_lost},
          {"source_ended", fleet.source_ended},
          {"bus_off", fleet.bus_off},
          {"bit_rate_bit_s", fleet.bit_rate_bit_s},
          {"frames", fleet.frames},
          {"foreign_frames", fleet.foreign_frames},
          {"error_frames", fleet.error_frames},
          {"receive_overflows", fleet.receive_overflows},
          {"bus_load_percent", fleet.bus_load_percent},
          {"frames_per_s", fleet.frames_per_s},
          {"nodes", std::move(nodes)}};
}

json moment_json(const Moment& moment, const FleetView& now) {
  json result = fleet_json(moment.view);
  result["from_us"] = moment.from_us;
  for (const auto& [number, node] : now.nodes) {
    if (!moment.view.nodes.contains(number)) {
      if (json partial = partial_json(node, moment.view.now_ns); !partial.empty()) {
        result["nodes"][std::to_string(number)] = std::move(partial);
      }
    }
  }
  return result;
}

json times_json(const std::vector<std::int64_t>& archived_us, const std::string& why_gone,
                const FleetView& now) {
  std::set<std::int64_t> before_us;
  for (const auto& [number, node] : now.nodes) {
    for (const DamagePoint& point : node.curve) {
      const std::int64_t time_us = microseconds(point.time_ns);
      if (archived_us.empty() || time_us < archived_us.front()) {
        before_us.insert(time_us);
      }
    }
  }
  const std::size_t apart = before_us.size() / FrameArchive::kMostTimes + 1;
  std::vector<std::int64_t> times;
  std::size_t number = 0;
  for (const std::int64_t time_us : before_us) {
    if (number++ % apart == 0) {
      times.push_back(time_us);
    }
  }
  times.insert(times.end(), archived_us.begin(), archived_us.end());
  json result = {{"times_us", std::move(times)}};
  if (!archived_us.empty()) {
    result["whole_from_us"] = archived_us.front();
  }
  if (!why_gone.empty()) {
    result["why_gone"] = why_gone;
  }
  return result;
}

nlohmann::json new_events(const FleetView& before, const FleetView& after) {
  nlohmann::json news = nlohmann::json::object();
  for (const auto& [number, node] : after.nodes) {
    const auto old = before.nodes.find(number);
    nlohmann::json events =
        after_last(old == before.nodes.end() ? nullptr : &old->second.events, node.events);
    if (!events.empty()) {
      news[std::to_string(number)] = std::move(events);
    }
  }
  return news;
}

nlohmann::json merge_patch(const nlohmann::json& before, const nlohmann::json& after) {
  nlohmann::json patch = nlohmann::json::object();
  for (const auto& [key, value] : after.items()) {
    const auto old = before.find(key);
    if (old != before.end() && *old == value) {
      continue;
    }
    const bool both_objects = old != before.end() && old->is_object() && value.is_object();
    patch[key] = both_objects ? merge_patch(*old, value) : value;
  }
  for (const auto& [key, value] : before.items()) {
    if (!after.contains(key)) {
      patch[key] = nullptr;
    }
  }
  return patch;
}

std::string json_text(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string history_csv(const NodeView& node) {
  std::string text = "time_s,damage,damage_rate_per_h\n";
  constexpr std::int64_t kSecond_us = 1'000'000;
  for (const DamagePoint& point : node.curve) {
    const std::int64_t time_us = point.time_ns / 1000;
    fmt::format_to(std::back_inserter(text), "{}.{:06},{},{}\n", time_us / kSecond_us,
                   time_us % kSecond_us, ppb_text(point.damage_ppb),
                   point.rate_ppb_per_h ? ppb_text(*point.rate_ppb_per_h) : "");
  }
  return text;
}

}  // namespace host_sim::monitor
