#include "host_sim/monitor/http/view_json.hpp"

#include <optional>
#include <string>

#include "host_sim/monitor/fleet/words.hpp"
#include "host_sim/monitor/http/message_json.hpp"

namespace host_sim::monitor {
namespace {

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

template <class Messages>
json by_number(const Messages& messages) {
  json result = json::object();
  for (const auto& [number, timed] : messages) {
    result[std::to_string(number)] = timed_json(timed);
  }
  return result;
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

const char* kind_name(Event::Kind kind) {
  switch (kind) {
    case Event::Kind::state:
      return "state";
    case Event::Kind::emergency:
      return "emergency";
    case Event::Kind::boot:
      return "boot";
    case Event::Kind::vanished:
      return "vanished";
    case Event::Kind::back:
      return "back";
    case Event::Kind::epoch:
      return "epoch";
    case Event::Kind::integrity:
      return "integrity";
    case Event::Kind::two_controllers:
      return "two_controllers";
  }
  return "";
}

json point_json(const DamagePoint& point) {
  json result = {microseconds(point.time_ns), point.damage_ppb / kPpb};
  if (point.rate_ppb_per_h) {
    result.push_back(*point.rate_ppb_per_h / kPpb);
  }
  return result;
}

}  // namespace

json event_json(const Event& event) {
  return {{"kind", kind_name(event.kind)},
          {"time_us", microseconds(event.time_ns)},
          {"words", event.words},
          {"state", name_of(event.state)}};
}

json node_json(const NodeView& node) {
  json result = {{"node", node.node},
                 {"vanished", node.vanished},
                 {"state", state_name(node)},
                 {"life_state", name_of(node.life_state())},
                 {"two_controllers", node.two_controllers},
                 {"last_seen_us", microseconds(node.last_seen_ns)},
                 {"highest_damage", node.highest_damage_ppb / kPpb},
                 {"integrity_failures", node.integrity_failures()},
                 {"tendons", by_number(node.tendons)},
                 {"bins", by_number(node.bins)}};
  if (is_at_least(kDamageSignal, node.highest_damage_ppb)) {
    result["at_least"] = {"highest_damage"};
  }
  if (node.heartbeat) {
    result["heartbeat"] = timed_json(Timed<protocol::Heartbeat>{
        {node.heartbeat->value}, node.heartbeat->time_ns, node.heartbeat->stale});
  }
  put(result, "status", node.status);
  put(result, "identity", node.identity);
  put(result, "cycles", node.cycles);
  put(result, "rate", node.rate);
  put(result, "remaining", node.remaining);
  put(result, "storage", node.storage);
  put(result, "timing", node.timing);
  put(result, "bus", node.bus);
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

}  // namespace host_sim::monitor
