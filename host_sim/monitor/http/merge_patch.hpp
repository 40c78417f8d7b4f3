#pragma once

#include <nlohmann/json.hpp>

namespace host_sim::monitor {

/// What turns `before` into `after` (RFC 7396). Precondition: no null in `after`.
nlohmann::json merge_patch(const nlohmann::json& before, const nlohmann::json& after);

}  // namespace host_sim::monitor
