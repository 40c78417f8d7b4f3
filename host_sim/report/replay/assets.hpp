#pragma once

#include <string_view>

/// Files of the page of a replay, embedded when the program is built.
namespace host_sim::replay_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view draw_js;
extern const std::string_view given_survival_html;
extern const std::string_view until_date_html;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::replay_assets
