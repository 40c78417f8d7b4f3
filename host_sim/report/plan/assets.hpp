#pragma once

#include <string_view>

/// Files of the page of a plan, embedded when the program is built.
namespace host_sim::plan_page_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view draw_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::plan_page_assets
