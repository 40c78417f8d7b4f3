#include "host_sim/report/replay/html.hpp"

#include <sstream>

#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/replay/assets.hpp"
#include "host_sim/report/replay/captions.hpp"
#include "host_sim/report/replay/given_survival.hpp"
#include "host_sim/report/replay/loop.hpp"
#include "host_sim/report/replay/plot_builders.hpp"
#include "host_sim/report/replay/sections.hpp"

namespace host_sim {
namespace {

using nlohmann::json;

json damage_json(const DamageSplit& damage) {
  return {{"closed", damage.closed}, {"open", damage.open}, {"total", damage.total}};
}

json turning_points_json(const TurningPoints& turning_points) {
  json time_s = json::array();
  json tension_N = json::array();
  for (const TurningPoint& point : turning_points.points) {
    time_s.push_back(point.time_s);
    tension_N.push_back(point.tension_N);
  }
  return {{"time_s", time_s}, {"tension_N", tension_N}, {"total", turning_points.total}};
}

json range_mean_json(const RangeMeanMatrix& matrix) {
  return {{"range_step_N", matrix.range_step_N},
          {"mean_min_N", matrix.mean_min_N},
          {"mean_step_N", matrix.mean_step_N},
          {"ranges", matrix.ranges},
          {"means", matrix.means},
          {"count", matrix.count},
          {"damage", matrix.damage}};
}

json summary_json(const ReplayReport& report) {
  const RepeatsTo& to = report.repeats_to;
  return {{"samples", report.samples},
          {"duration_s", report.duration_s},
          {"cycles", {{"closed", report.cycles.closed}, {"open_half", report.cycles.open_half}}},
          {"damage", damage_json(report.damage)},
          {"reference_damage", damage_json(report.reference_damage)},
          {"relative_error", report.relative_error},
          {"equivalent_effective_tension_N", report.equivalent_effective_tension_N},
          {"survival_probability", report.survival_probability},
          {"repeats_to", {{"B10", to.B10}, {"B50", to.B50}, {"mean", to.mean}, {"B90", to.B90}}},
          {"flags", report.flags},
          {"warnings", report.warnings},
          {"model_digest", report.model_digest}};
}

/// What the page draws from and a reader of the page may take from it: the results under `summary`,
/// named as in `replay --json`, and the data of every plot.
json replay_page_json(const ReplayReport& report) {
  const LifeCurve life = life_curve(report.damage.total, report.weibull_shape);
  return {
      {"summary", summary_json(report)},
      {"profile_name", report.profile_name},
      {"model_name", report.model_name},
      {"program_version", report.program_version},
      {"tension",
       {{"time_s", report.tension.time_s},
        {"low_N", report.tension.low_N},
        {"high_N", report.tension.high_N},
        {"samples_per_bucket", report.tension.samples_per_bucket},
        {"gaps", report.tension.gaps}}},
      {"turning_points", turning_points_json(report.turning_points)},
      {"range_mean", range_mean_json(report.range_mean)},
      {"trajectory", {{"time_s", report.trajectory.time_s}, {"damage", report.trajectory.damage}}},
      {"life", {{"repeats", life.repeats}, {"broken", life.broken}}},
      {"charts",
       {{"survivor", chart_json(break_chart(report))}, {"loop", chart_json(loop_chart(report))}}}};
}

}  // namespace

void write_replay_report(std::ostream& out, const ReplayReport& report) {
  const Slots slots = {
      {"profile_name", html_escape(report.profile_name)},
      {"verdict", html_escape(verdict(report))},
      {"origin", html_escape(captions::origin(report))},
      {"tiles", sections::tiles(report)},
      {"key_table", tables::key_numbers(report)},
      {"flags", sections::flags(report)},
      {"wire_tiles", sections::wire_tiles(report)},
      {"wire_found", elements::words(report.found)},
      {"until_date", sections::until_date(report)},
      {"tension_caption", html_escape(captions::tension(report))},
      {"tension_chart", sections::tension_chart(report)},
      {"loop", sections::loop(report)},
      {"matrix_caption", html_escape(captions::range_mean(report))},
      {"matrix_chart", sections::range_mean_chart(report)},
      {"trajectory_caption", html_escape(captions::trajectory(report))},
      {"trajectory_chart", sections::trajectory_chart(report)},
      {"life_caption", html_escape(captions::life(report))},
      {"life_chart", sections::life_chart(report)},
      {"given_survival", sections::given_survival(report)},
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
