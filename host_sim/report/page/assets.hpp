#pragma once

#include <string_view>

/// Files that are part of every page, embedded when the program is built.
namespace host_sim::assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view frame_html;
extern const std::string_view page_css;
extern const std::string_view guard_js;
extern const std::string_view charts_js;
extern const std::string_view uplot_js;
extern const std::string_view uplot_css;
extern const std::string_view uplot_licence;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::assets
