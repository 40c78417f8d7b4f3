#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace host_sim::monitor {

/// One line. Bytes that are not UTF-8 become U+FFFD, numbers that are not finite null.
inline std::string json_text(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace host_sim::monitor
