#include "host_sim/monitor/http/page_files.hpp"

#include <algorithm>
#include <array>

#include "host_sim/monitor/http/assets.hpp"
#include "host_sim/report/page/assets.hpp"

namespace host_sim::monitor {

const PageFile* find_page_file(std::string_view name) {
  constexpr std::string_view kHtml = "text/html; charset=utf-8";
  constexpr std::string_view kStyle = "text/css; charset=utf-8";
  constexpr std::string_view kScript = "text/javascript; charset=utf-8";
  constexpr std::string_view kPlain = "text/plain; charset=utf-8";
  namespace report = host_sim::assets;
  static const std::array files = {
      PageFile{"/", kHtml, assets::index_html},
      PageFile{"/assets/page.css", kStyle, report::page_css},
      PageFile{"/assets/live.css", kStyle, assets::live_css},
      PageFile{"/assets/uplot.css", kStyle, report::uplot_css},
      PageFile{"/assets/uplot.js", kScript, report::uplot_js},
      PageFile{"/assets/uplot.licence", kPlain, report::uplot_licence},
      PageFile{"/assets/guard.js", kScript, report::guard_js},
      PageFile{"/assets/charts.js", kScript, report::charts_js},
      PageFile{"/assets/bins.js", kScript, assets::bins_js},
      PageFile{"/assets/curves.js", kScript, assets::curves_js},
      PageFile{"/assets/dom.js", kScript, assets::dom_js},
      PageFile{"/assets/events.js", kScript, assets::events_js},
      PageFile{"/assets/fleet.js", kScript, assets::fleet_js},
      PageFile{"/assets/history.js", kScript, assets::history_js},
      PageFile{"/assets/main.js", kScript, assets::main_js},
      PageFile{"/assets/node.js", kScript, assets::node_js},
      PageFile{"/assets/patch.js", kScript, assets::patch_js},
      PageFile{"/assets/place.js", kScript, assets::place_js},
      PageFile{"/assets/stream.js", kScript, assets::stream_js},
      PageFile{"/assets/tendons.js", kScript, assets::tendons_js},
      PageFile{"/assets/tiles.js", kScript, assets::tiles_js},
      PageFile{"/assets/time.js", kScript, assets::time_js},
      PageFile{"/assets/trust.js", kScript, assets::trust_js},
      PageFile{"/assets/words.js", kScript, assets::words_js},
  };
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const PageFile& file) { return file.name == name; });
  return found == files.end() ? nullptr : &*found;
}

}  // namespace host_sim::monitor
