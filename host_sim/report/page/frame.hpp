#pragma once

#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace host_sim {

/// What differs from one page to the next. Title and footer are plain text, the body is HTML with
/// all texts escaped.
struct PageParts {
  std::string title;
  std::string body;
  std::string footer;
  nlohmann::json data;       ///< what the scripts draw from
  std::string_view draw_js;  ///< calls drawPage() with the page's kinds of plots
};

/// Writes one self-contained HTML page: no network, no other file. Numbers of the data that are not
/// finite become null.
void write_page(std::ostream& out, const PageParts& parts);

}  // namespace host_sim
