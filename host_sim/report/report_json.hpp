#pragma once

#include <nlohmann/json.hpp>

#include "host_sim/report/report_data.hpp"

namespace host_sim {

/// The results of a replay without the plots; these are the fields of `replay --json`.
[[nodiscard]] nlohmann::json replay_summary_json(const ReplayReport& report);

/// What the page draws from: the results under `summary`, and the data of every plot.
[[nodiscard]] nlohmann::json replay_page_json(const ReplayReport& report);

}  // namespace host_sim
