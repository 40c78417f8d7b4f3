#pragma once

#include <string_view>

/// Files that the program gives away, embedded when it is built.
namespace host_sim::verb_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view model_toml;
extern const std::string_view campaign_toml;
extern const std::string_view plan_toml;
extern const std::string_view controller_toml;
extern const std::string_view calibrate_schema;
extern const std::string_view compare_schema;
extern const std::string_view design_schema;
extern const std::string_view diagnose_schema;
extern const std::string_view fleet_schema;
extern const std::string_view fmeca_schema;
extern const std::string_view monitor_schema;
extern const std::string_view plan_schema;
extern const std::string_view replay_schema;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::verb_assets
