#pragma once

#include <iosfwd>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace host_sim {

/// The texts that go into the `{{name}}` slots of a template; they are inserted as they are.
using Slots = std::map<std::string_view, std::string, std::less<>>;

/// Writes the template with its slots filled, in one pass: braces inside inserted text stay.
/// Throws std::logic_error for a slot without text and for one that is not closed.
void fill_template(std::ostream& out, std::string_view page, const Slots& slots);

/// A body with what guides its reader: after its header links to its headings where there are more
/// than six, and before its first plot, once, how all plots are zoomed.
[[nodiscard]] std::string with_guides(std::string body);

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
