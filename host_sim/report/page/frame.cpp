#include "host_sim/report/page/frame.hpp"

#include <fmt/format.h>

#include <ostream>
#include <stdexcept>

#include "host_sim/report/page/assets.hpp"
#include "host_sim/report/page/elements.hpp"

namespace host_sim {

void fill_template(std::ostream& out, std::string_view page, const Slots& slots) {
  constexpr std::string_view kOpen = "{{";
  constexpr std::string_view kClose = "}}";
  for (;;) {
    const std::size_t open = page.find(kOpen);
    out << page.substr(0, open);
    if (open == std::string_view::npos) {
      return;
    }
    page.remove_prefix(open + kOpen.size());
    const std::size_t close = page.find(kClose);
    if (close == std::string_view::npos) {
      throw std::logic_error("page template: a slot is not closed");
    }
    const auto slot = slots.find(page.substr(0, close));
    if (slot == slots.end()) {
      throw std::logic_error("page template: no text for slot " +
                             std::string(page.substr(0, close)));
    }
    out << slot->second;
    page.remove_prefix(close + kClose.size());
  }
}

namespace {

/// Links to the headings of a page that has so many that it needs them; empty for others.
std::string contents_of(std::string_view body) {
  constexpr std::string_view kHeading = "<h2 id=\"";
  constexpr std::size_t kFewHeadings = 6;
  std::string links;
  std::size_t count = 0;
  for (std::size_t at = body.find(kHeading); at != std::string_view::npos;
       at = body.find(kHeading, at)) {
    at += kHeading.size();
    const std::size_t id_end = body.find("\">", at);
    const std::size_t text = id_end + 2;
    links += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", body.substr(at, id_end - at),
                         body.substr(text, body.find("</h2>", text) - text));
    ++count;
  }
  return count > kFewHeadings ? fmt::format(
                                    "<nav class=\"contents\" aria-label=\"Contents\">\n"
                                    "<ul>\n{}</ul>\n</nav>\n",
                                    links)
                              : std::string();
}

/// `insertion` before or after the first `place`; nowhere without one.
void insert_at(std::string& text, std::string_view place, bool after, std::string_view insertion) {
  const std::size_t at = text.find(place);
  if (at != std::string::npos) {
    text.insert(after ? at + place.size() : at, insertion);
  }
}

}  // namespace

std::string with_guides(std::string body) {
  const std::string contents = contents_of(body);
  insert_at(body, "<div class=\"chart\" ", false,
            "<p class=\"hint\" id=\"chart-hint\">In every plot: drag to zoom, double-click to see "
            "all. By keyboard: arrows move, + and \u2212 zoom, 0 shows all.</p>\n");
  insert_at(body, "</header>\n", true, contents);
  return body;
}

void write_page(std::ostream& out, const PageParts& parts) {
  const Slots slots = {
      {"title", html_escape(parts.title)},
      {"body", with_guides(parts.body)},
      {"footer", html_escape(parts.footer)},
      {"data_json", script_json(parts.data)},
      {"draw_js", std::string(parts.draw_js)},
      {"page_css", std::string(assets::page_css)},
      {"guard_js", std::string(assets::guard_js)},
      {"charts_js", std::string(assets::charts_js)},
      {"uplot_js", std::string(assets::uplot_js)},
      {"uplot_css", std::string(assets::uplot_css)},
      {"uplot_licence", std::string(assets::uplot_licence)},
  };
  fill_template(out, assets::frame_html, slots);
}

}  // namespace host_sim
