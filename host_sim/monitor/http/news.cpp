#include "host_sim/monitor/http/news.hpp"

#include <algorithm>
#include <string>

#include "host_sim/monitor/http/view_json.hpp"

namespace host_sim::monitor {
namespace {

bool same(const Event& one, const Event& other) {
  return one.time_ns == other.time_ns && one.kind == other.kind && one.state == other.state &&
         one.words == other.words;
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

}  // namespace

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

}  // namespace host_sim::monitor
