#include "host_sim/report/replay/html.hpp"

#include <sstream>

#include "host_sim/report/page/escape.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/template.hpp"
#include "host_sim/report/replay/assets.hpp"
#include "host_sim/report/replay/captions.hpp"
#include "host_sim/report/replay/page_json.hpp"
#include "host_sim/report/replay/sections.hpp"
#include "host_sim/report/replay/tables.hpp"
#include "host_sim/report/replay/verdict.hpp"

namespace host_sim {

void write_replay_report(std::ostream& out, const ReplayReport& report) {
  const Slots slots = {
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
  };
  std::ostringstream body;
  fill_template(body, replay_assets::body_html, slots);
  write_page(out, {"Tendon life: " + report.profile_name, body.str(), captions::footer(report),
                   replay_page_json(report), replay_assets::draw_js});
}

}  // namespace host_sim
