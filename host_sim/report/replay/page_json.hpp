#pragma once

#include <nlohmann/json.hpp>

#include "host_sim/report/replay/report_data.hpp"

namespace host_sim {

/// What the page draws from and a reader of the page may take from it: the results under `summary`,
/// named as in `replay --json`, and the data of every plot.
[[nodiscard]] nlohmann::json replay_page_json(const ReplayReport& report);

}  // namespace host_sim
