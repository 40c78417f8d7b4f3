#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

namespace host_sim {

/// null for what is infinite or was not computed.
inline nlohmann::ordered_json json_number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

/// An array with what `to_json` makes of each item.
template <class T, class ToJson>
nlohmann::ordered_json json_list(const std::vector<T>& items, ToJson to_json) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const T& item : items) {
    json.push_back(to_json(item));
  }
  return json;
}

}  // namespace host_sim
