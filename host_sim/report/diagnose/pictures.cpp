#include "host_sim/report/diagnose/pictures.hpp"

#include <fmt/format.h>

#include <sstream>

#include "host_sim/report/diagnose/assets.hpp"
#include "host_sim/report/diagnose/captions.hpp"
#include "host_sim/report/diagnose/charts.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"

namespace host_sim::diagnose_page {
namespace {

std::string caption(const std::string& text) {
  return fmt::format("<p class=\"caption\">{}</p>\n", html_escape(text));
}

std::string in_pair(const std::string& html) {
  return fmt::format("<div>\n{}</div>\n", html);
}

std::string traces(const diagnose::TensionDiagnosis& tension) {
  constexpr std::string_view kNothing = "There is no recording of this session to draw.";
  if (tension.traces.empty()) {
    return elements::empty("There is no recording to draw.");
  }
  std::string html = caption(captions::traces(tension)) + "<div class=\"pair\">\n";
  for (const std::size_t trace : worst_traces(tension, kMostTraces)) {
    html += in_pair(
        elements::chart(trace_chart(tension, trace), captions::trace(tension, trace), kNothing));
    html += in_pair(elements::chart(loop_chart(tension, trace), captions::loop(), kNothing));
  }
  return html + "</div>\n";
}

std::string residuals(const diagnose::TensionDiagnosis& tension) {
  if (tension.residuals.empty()) {
    return elements::empty("There is no residual to draw.");
  }
  std::string html = caption(captions::residuals(tension)) + "<div class=\"pair\">\n";
  for (const std::size_t i : residual_order(tension)) {
    html += in_pair(elements::chart(residual_chart(tension, i), captions::residual(tension, i),
                                    "There is no residual in this direction."));
  }
  return html + "</div>\n";
}

std::string filled(std::string_view page, const Slots& slots) {
  std::ostringstream out;
  fill_template(out, page, slots);
  return out.str();
}

}  // namespace

std::string pictures(const diagnose::TensionDiagnosis& tension) {
  return filled(diagnose_assets::recordings_html,
                {{"traces", traces(tension)}, {"residuals", residuals(tension)}});
}

std::string pictures(const diagnose::LifeDiagnosis& lives) {
  constexpr std::string_view kNothing = "There is no life to draw.";
  const Chart after = ratio_chart(lives, Model::extended);
  return filled(
      diagnose_assets::lives_html,
      {{"weibull", elements::chart(weibull_chart(lives), captions::weibull(lives), kNothing)},
       {"ratio_before",
        elements::chart(ratio_chart(lives, Model::nominal), captions::ratio_before(), kNothing)},
       {"ratio_after", after.layers.empty()
                           ? std::string()
                           : in_pair(elements::chart(after, captions::ratio_after(), kNothing))}});
}

}  // namespace host_sim::diagnose_page
