#pragma once

#include <string_view>

/// Files of the live page, embedded when the program is built.
namespace host_sim::monitor::assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view index_html;
extern const std::string_view live_css;
extern const std::string_view address_js;
extern const std::string_view curves_js;
extern const std::string_view dom_js;
extern const std::string_view events_js;
extern const std::string_view fleet_js;
extern const std::string_view history_js;
extern const std::string_view main_js;
extern const std::string_view node_js;
extern const std::string_view prose_js;
extern const std::string_view stream_js;
extern const std::string_view tendons_js;
extern const std::string_view trust_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::monitor::assets
