#include <string>

#include "host_sim/report/diagnose/charts.hpp"

namespace host_sim::diagnose_page {

Chart session_chart(const diagnose::TensionDiagnosis& tension, SessionParameter parameter) {
  const bool friction = parameter == SessionParameter::friction;
  Chart chart;
  chart.id = friction ? "session-friction" : "session-gain";
  chart.name = friction ? "Friction coefficient of each session alone"
                        : "Logarithm of the gain of each session alone";
  chart.x = {"Session", Axis::Kind::category, "", {}, false};
  chart.y = {friction ? "Friction coefficient" : "ln gain", Axis::Kind::linear, "", {}, false};
  Layer points;
  points.kind = Layer::Kind::points;
  points.name = "One session alone";
  points.colour = kBeforeColour;
  for (const diagnose::SessionRefit& refit : tension.session_refits) {
    points.x.push_back(static_cast<double>(points.x.size()));
    points.y.push_back(friction ? refit.friction_coefficient : refit.log_gain);
    chart.x.categories.push_back(refit.session);
  }
  if (!points.x.empty()) {
    chart.layers.push_back(points);
  }
  return chart;
}

}  // namespace host_sim::diagnose_page
