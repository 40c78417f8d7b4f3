#include "host_sim/monitor/fleet/node_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "firmware/protocol/schema/frames.hpp"
#include "host_sim/monitor/fleet/damage_watch.hpp"

namespace host_sim::monitor {
namespace {

template <class Enum>
std::string_view name_in(std::span<const protocol::schema::ValueName> names, Enum value) {
  for (const protocol::schema::ValueName& name : names) {
    if (name.value == static_cast<std::uint32_t>(value)) {
      return name.name;
    }
  }
  return "unknown";
}

void drop_every_second(std::deque<DamagePoint>& curve) {
  std::deque<DamagePoint> kept;
  for (std::size_t i = 0; i < curve.size(); i += 2) {
    kept.push_back(curve[i]);
  }
  curve = std::move(kept);
}

}  // namespace

std::string_view name_of(protocol::LifeState state) {
  return name_in(protocol::schema::kLifeStates, state);
}
std::string_view name_of(protocol::Quality quality) {
  return name_in(protocol::schema::kQualities, quality);
}
std::string_view name_of(protocol::NmtState state) {
  return name_in(protocol::schema::kNmtStates, state);
}
std::string_view name_of(protocol::EmergencyCode code) {
  return name_in(protocol::schema::kEmergencyCodes, code);
}

std::string_view name_of(protocol::AdviceState state) {
  return name_in(protocol::schema::kAdviceStates, state);
}

std::string_view state_name(const NodeView& node) {
  return node.two_controllers ? "two_controllers" : name_of(node.life_state());
}

unsigned severity_of(protocol::LifeState state) {
  switch (state) {
    case protocol::LifeState::worn:
      return 60;
    case protocol::LifeState::replace:
      return 50;
    case protocol::LifeState::unknown:
      return 40;
    case protocol::LifeState::inspect:
      return 30;
    case protocol::LifeState::normal:
      return 0;
  }
  return 40;
}

unsigned severity_of(const NodeView& node) {
  if (!node.heartbeat && !node.status && !node.emergency && node.streams.empty()) {
    return 0;
  }
  const auto has = [&](auto flag) { return node.status && node.status->value.*flag; };
  const bool emergency =
      node.emergency && node.emergency->value.code != protocol::EmergencyCode::none;
  using protocol::LifeStatus;
  const std::pair<unsigned, bool> alarms[] = {
      {90, node.two_controllers},
      {80, emergency},
      {80, has(&LifeStatus::broken) || has(&LifeStatus::slack) || has(&LifeStatus::locked)},
      {70, node.vanished},
      {5, node.integrity_failures() > 0},
  };
  unsigned severity = severity_of(node.life_state());
  for (const auto& [weight, on] : alarms) {
    severity = std::max(severity, on ? weight : 0);
  }
  return severity;
}

std::vector<const NodeView*> gravest_first(const FleetView& fleet) {
  std::vector<const NodeView*> nodes;
  for (const auto& [number, node] : fleet.nodes) {
    nodes.push_back(&node);
  }
  std::stable_sort(nodes.begin(), nodes.end(), [](const NodeView* one, const NodeView* other) {
    return severity_of(*one) > severity_of(*other);
  });
  return nodes;
}

std::string percent_of(std::uint32_t ppb, const protocol::schema::Signal& signal) {
  constexpr std::uint32_t kPercent_ppb = 10'000'000;
  std::string text = fmt::format("{}{}.{:07}", is_at_least(signal, ppb) ? ">=" : "",
                                 ppb / kPercent_ppb, ppb % kPercent_ppb);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text;
}

protocol::LifeState NodeView::life_state() const {
  return status ? graver(gravest_state, status->value.state) : protocol::LifeState::unknown;
}

std::uint64_t NodeView::integrity_failures() const {
  std::uint64_t failures = 0;
  for (const StreamView& stream : streams) {
    failures += stream.damaged + stream.malformed;
  }
  return failures;
}

void DamageCurve::add(NodeView& view, const DamagePoint& point) {
  std::deque<DamagePoint>& curve = view.curve;
  const std::size_t count = curve.size();
  if (count >= 2 && curve[count - 1].time_ns - curve[count - 2].time_ns < step_ns_) {
    curve.back() = point;
    return;
  }
  if (count == NodeView::kMostPoints) {
    drop_every_second(curve);
    step_ns_ *= 2;
  }
  curve.push_back(point);
}

void add_event(NodeView& view, Event event) {
  if (view.events.size() == NodeView::kMostEvents) {
    view.events.pop_front();
  }
  view.events.push_back(std::move(event));
}

}  // namespace host_sim::monitor
