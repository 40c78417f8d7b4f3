#include "host_sim/report/diagnose/charts.hpp"

namespace host_sim::diagnose_page {

std::vector<Chart> charts(const diagnose::Diagnosis& diagnosis) {
  std::vector<Chart> all;
  if (diagnosis.tension) {
    for (const std::size_t trace : worst_traces(*diagnosis.tension, kMostTraces)) {
      all.push_back(trace_chart(*diagnosis.tension, trace));
      all.push_back(loop_chart(*diagnosis.tension, trace));
    }
    for (std::size_t i = 0; i < diagnosis.tension->causes.size(); ++i) {
      all.push_back(cause_chart(*diagnosis.tension, i));
    }
    for (std::size_t i = 0; i < diagnosis.tension->remainders.size(); ++i) {
      all.push_back(remainder_chart(*diagnosis.tension, i));
    }
    all.push_back(session_chart(*diagnosis.tension, SessionParameter::friction));
    all.push_back(session_chart(*diagnosis.tension, SessionParameter::gain));
    all.push_back(gain_chart(diagnosis.tension->findings.gain));
    all.push_back(steps_chart(diagnosis.tension->findings));
  }
  if (diagnosis.lives) {
    all.push_back(weibull_chart(*diagnosis.lives));
    all.push_back(ratio_chart(*diagnosis.lives, Model::nominal));
    all.push_back(ratio_chart(*diagnosis.lives, Model::extended));
  }
  std::erase_if(all, [](const Chart& chart) { return chart.layers.empty(); });
  return all;
}

}  // namespace host_sim::diagnose_page
