#include "host_sim/report/page/frame.hpp"

#include "host_sim/report/page/assets.hpp"
#include "host_sim/report/page/escape.hpp"
#include "host_sim/report/page/template.hpp"

namespace host_sim {

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
