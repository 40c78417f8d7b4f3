#include "host_sim/monitor/http/merge_patch.hpp"

namespace host_sim::monitor {

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

}  // namespace host_sim::monitor
