#include "host_sim/report/design/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

#include "host_sim/report/design/charts.hpp"
#include "host_sim/report/page/elements.hpp"
#include "host_sim/report/page/frame.hpp"
#include "host_sim/report/page/number_text.hpp"

/// Files of the page of a design, embedded when the program is built.
namespace host_sim::design_assets {

// NOLINTBEGIN(readability-identifier-naming): named after the files
extern const std::string_view body_html;
extern const std::string_view draw_js;
// NOLINTEND(readability-identifier-naming)

}  // namespace host_sim::design_assets

namespace host_sim {
namespace {

using design::Study;
using design::Tendon;
using elements::tile;

std::string factor_text(double factor) {
  return factor == 0 ? "torn at once" : number_text(factor, 4);
}

std::string tiles(const Study& study) {
  const design::Design& found = study.design;
  const Tendon& tendon = found.tendon;
  const reference::MeanAmplitude& input = study.stress.input;
  std::string risk = "risk " + percent_text(found.risk);
  if (study.interval) {
    risk += fmt::format("; {}: {} to {}", percent_text(study.interval->level),
                        number_text(study.interval->low_cycles),
                        number_text(study.interval->high_cycles));
  }
  return tile("Life", quantity_text(study.life_cycles, "cycles"), risk) +
         tile("Output tension", quantity_text(tendon.output_max_N, "N"),
              tendon.output_min_N == tendon.output_max_N
                  ? "constant"
                  : "down to " + quantity_text(tendon.output_min_N, "N")) +
         tile("Bend angle", number_text(tendon.bend_angle_deg, 4) + "\u00b0",
              "efficiency " + number_text(study.stress.efficiency)) +
         tile("Friction coefficient", number_text(tendon.friction_coefficient),
              "of wire and liner") +
         tile("Wire", quantity_text(tendon.diameter_mm, "mm"),
              "holds " + quantity_text(study.stress.ultimate_tension_N, "N")) +
         tile("Effective tension", quantity_text(study.stress.effective_tension_N, "N"),
              fmt::format("input {} to {} N", number_text(input.mean_N - input.amplitude_N),
                          number_text(input.mean_N + input.amplitude_N)));
}

std::string safety_table(const Study& study) {
  Table table("Safety factors", {"Until", "Of tension", "Of life"});
  const design::Safety& safety = study.safety;
  table.row("the wire is torn at once", {number_text(safety.strength, 4), ""});
  if (std::isfinite(study.design.life_cycles)) {
    const std::string life = quantity_text(study.design.life_cycles, "cycles");
    table.row(fmt::format("{} break within {}", percent_text(study.design.risk), life),
              {number_text(safety.at_risk.tension, 4), number_text(safety.at_risk.life, 4)});
    table.row("half break within " + life,
              {number_text(safety.at_half.tension, 4), number_text(safety.at_half.life, 4)});
  }
  return table.html();
}

std::string lives_table(const Study& study) {
  Table table("Lives", {"Share broken", "Life"});
  const reference::LifePoints& lives = study.lives_cycles;
  for (const auto& [name, cycles] : {std::pair("10 % (B10)", lives.b10),
                                     {"50 % (B50)", lives.b50},
                                     {"mean life", lives.mean},
                                     {"90 % (B90)", lives.b90}}) {
    table.row(name, {quantity_text(cycles, "cycles")});
  }
  return table.html();
}

/// A bar from the middle of its track: to the left where more of the input shortens the life.
std::string tornado_bar(double value, double largest) {
  const double length = 100 * std::abs(value) / largest;
  return fmt::format(
      "<svg class=\"bar\" viewBox=\"-100 0 200 10\" preserveAspectRatio=\"none\" "
      "aria-hidden=\"true\"><rect class=\"track\" x=\"-100\" width=\"200\" height=\"10\"/>"
      "<rect class=\"{}\" x=\"{:.2f}\" width=\"{:.2f}\" height=\"10\"/></svg>",
      value < 0 ? "strong" : "weak", value < 0 ? -length : 0.0, length);
}

/// In one line.
std::string unbroken(std::string text) {
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at)) {
    text.replace(at, 1, "\u00a0");
  }
  return text;
}

std::string tornado(const Study& study) {
  if (study.elasticities.empty()) {
    return elements::empty("Nothing varies the tension: there is no life to change.");
  }
  double largest = 0;
  for (const design::Elasticity& one : study.elasticities) {
    largest = std::isfinite(one.value) ? std::max(largest, std::abs(one.value)) : largest;
  }
  std::string html =
      "<div class=\"table ranking\" tabindex=\"0\" role=\"region\" aria-label=\"Elasticities\">\n"
      "<table>\n<thead><tr><th scope=\"col\">1\u00a0% more of</th><th scope=\"col\" "
      "class=\"track\"><span class=\"quiet\">as a bar</span></th><th scope=\"col\" "
      "class=\"number\">changes life by</th><th scope=\"col\" class=\"number\">life with "
      "10\u00a0% less</th><th scope=\"col\" class=\"number\">10\u00a0% more</th></tr></thead>\n"
      "<tbody>\n";
  for (const design::Elasticity& one : study.elasticities) {
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"track\">{}</td><td "
        "class=\"number\">{:+.2f}\u00a0%"
        "</td><td class=\"number\">\u00d7\u00a0{}</td><td "
        "class=\"number\">\u00d7\u00a0{}</td></tr>\n",
        html_escape(unbroken(one.input)),
        largest > 0 && std::isfinite(one.value) ? tornado_bar(one.value, largest) : "", one.value,
        factor_text(one.life_tenth_less), factor_text(one.life_tenth_more));
  }
  return html + "</tbody>\n</table>\n</div>\n";
}

std::string test_sentence(const Study& study) {
  if (!study.test) {
    return "The life of the design is this many times the life in a test at a higher tension, as "
           "long as the wire fails in the same way.";
  }
  const design::AcceleratedTest& test = *study.test;
  return fmt::format(
      "A test at {} and {}\u00b0 lasts {} at the risk of the design, whose life is {} times as "
      "long, as long as the wire fails in the same way.",
      quantity_text(test.tendon.output_max_N, "N"), number_text(test.tendon.bend_angle_deg, 4),
      quantity_text(test.life_cycles, "cycles"), number_text(test.factor, 4));
}

std::string curves_table(const Study& study) {
  Table table("Life over output tension", {"Bend angle", "Output tension", "Life"});
  constexpr std::size_t kStep = 8;
  for (const design::Curve& curve : study.curves) {
    for (std::size_t i = 0; i < curve.output_max_N.size(); i += kStep) {
      table.row(number_text(curve.bend_angle_deg, 4) + "\u00b0",
                {quantity_text(curve.output_max_N[i], "N"),
                 quantity_text(curve.life_cycles[i], "cycles")});
    }
  }
  return table.html();
}

}  // namespace

void write_design_report(std::ostream& out, const Model& model, const Study& study,
                         const design::Telling& telling, std::string_view program_version) {
  constexpr std::string_view kEndless = "Nothing varies the tension: life has no end.";
  Slots slots;
  slots["verdict"] = html_escape(design::sentence_of(study));
  slots["origin"] = html_escape(
      fmt::format("Model {}: scale A {}, exponent gamma {}, Weibull shape {}.",
                  telling.model_digest, number_text(model.life.ipl_scale),
                  number_text(model.life.ipl_exponent), number_text(model.life.weibull_shape)));
  slots["tiles"] = tiles(study);
  slots["life"] = elements::chart(
      design_page::life_chart(study),
      "Which tension has which life, at the bend angle of the design and right angles more and "
      "less. A line ends where the input tension would tear the wire at once.",
      kEndless);
  slots["curves_table"] = curves_table(study);
  slots["safety_table"] = safety_table(study);
  slots["lives_table"] = lives_table(study);
  slots["tornado"] = tornado(study);
  slots["stress"] = elements::chart(
      design_page::stress_chart(model, study),
      "What friction along the bend makes of the load where the wire breaks, at the input. A load "
      "that is constant varies there too, as soon as the sheath is bent.",
      kEndless);
  slots["acceleration"] = elements::chart(design_page::acceleration_chart(model, study),
                                          test_sentence(study), kEndless);
  std::ostringstream body;
  fill_template(body, design_assets::body_html, slots);
  nlohmann::json charts = nlohmann::json::object();
  for (const Chart& chart : design_page::charts(model, study)) {
    charts[chart.id] = chart_json(chart);
  }
  write_page(out, {"Tendon life: design",
                   body.str(),
                   fmt::format("Made by host_sim {}.", program_version),
                   {{"charts", charts}},
                   design_assets::draw_js});
}

}  // namespace host_sim
