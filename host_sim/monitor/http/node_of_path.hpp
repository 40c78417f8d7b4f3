#pragma once

#include <string>

#include "host_sim/monitor/fleet/node_view.hpp"

namespace host_sim::monitor {

/// The node of this number, of 1 to 3 digits; null where there is none, or no view yet.
inline const NodeView* node_of_path(const FleetView* view, const std::string& number) {
  constexpr int kHighest = 127;
  const int value = std::stoi(number);
  if (view == nullptr || value > kHighest) {
    return nullptr;
  }
  const auto found = view->nodes.find(static_cast<protocol::Node>(value));
  return found == view->nodes.end() ? nullptr : &found->second;
}

}  // namespace host_sim::monitor
