#include "host_sim/report/html.hpp"

#include "host_sim/report/assets.hpp"
#include "host_sim/report/escape.hpp"
#include "host_sim/report/page_captions.hpp"
#include "host_sim/report/page_sections.hpp"
#include "host_sim/report/page_tables.hpp"
#include "host_sim/report/page_template.hpp"
#include "host_sim/report/report_json.hpp"
#include "host_sim/report/verdict.hpp"

namespace host_sim {

void write_replay_report(std::ostream& out, const ReplayReport& report) {
  const Slots slots = {
      {"title", html_escape("Tendon life: " + report.profile_name)},
      {"profile_name", html_escape(report.profile_name)},
      {"verdict", html_escape(verdict(report))},
      {"origin", html_escape(captions::origin(report))},
      {"tiles", sections::tiles(report)},
      {"key_table", tables::key_numbers(report)},
      {"flags", sections::flags(report)},
      {"tension_caption", html_escape(captions::tension(report))},
      {"tension_chart", sections::tension_chart(report)},
      {"matrix_caption", html_escape(captions::range_mean(report))},
      {"matrix_chart", sections::range_mean_chart(report)},
      {"trajectory_caption", html_escape(captions::trajectory(report))},
      {"trajectory_chart", sections::trajectory_chart(report)},
      {"life_caption", html_escape(captions::life(report))},
      {"life_chart", sections::life_chart(report)},
      {"reference_caption", html_escape(captions::reference(report))},
      {"reference_table", tables::reference(report)},
      {"constants_caption", html_escape(captions::constants(report))},
      {"constants_table", tables::constants(report)},
      {"footer", html_escape(captions::footer(report))},
      {"data_json", script_json(replay_page_json(report))},
      {"page_css", std::string(assets::page_css)},
      {"guard_js", std::string(assets::guard_js)},
      {"page_js", std::string(assets::page_js)},
      {"uplot_js", std::string(assets::uplot_js)},
      {"uplot_css", std::string(assets::uplot_css)},
      {"uplot_licence", std::string(assets::uplot_licence)},
  };
  fill_template(out, assets::page_html, slots);
}

}  // namespace host_sim
