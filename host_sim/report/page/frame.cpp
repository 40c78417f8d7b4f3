#include "host_sim/report/page/frame.hpp"

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

void write_page(std::ostream& out, const PageParts& parts) {
  const Slots slots = {
      {"title", html_escape(parts.title)},
      {"body", parts.body},
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
