#include "tests/blind/oracle/floor.hpp"

#include <cmath>

#include "host_sim/synth/campaign/sessions.hpp"
#include "host_sim/synth/plan/plan.hpp"
#include "tests/blind/oracle/traces.hpp"

namespace blind {
namespace {

using host_sim::synth::Channels;
using host_sim::synth::Setting;
using host_sim::synth::SynthPlan;

struct Samples {
  std::vector<double> log_ratio, signed_bend_rad, output_N;
};

void append(std::vector<double>& to, const std::vector<double>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

Samples samples_of(const SynthPlan& plan, const Scenario& scenario) {
  Samples samples;
  for (const Setting& setting : host_sim::synth::settings_of(*plan.recordings, scenario.seed)) {
    const Channels channels = session_channels(
        plan, setting, session_scatter(plan, scenario.seed, setting.number), scenario.seed);
    append(samples.log_ratio, log_ratio(channels, scenario.input));
    append(samples.signed_bend_rad, signed_bend_rad(channels));
    append(samples.output_N, channels[host_sim::kOutputTensionColumn]);
  }
  return samples;
}

/// log_ratio = gain - mu phi s by least squares; what is left of the output tension.
double rmse_N(const Samples& samples) {
  const auto count = static_cast<double>(samples.log_ratio.size());
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (std::size_t i = 0; i < samples.log_ratio.size(); ++i) {
    const double x = samples.signed_bend_rad[i];
    const double y = samples.log_ratio[i];
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  const double slope = (sum_xy - sum_x * sum_y / count) / (sum_xx - sum_x * sum_x / count);
  const double gain = (sum_y - slope * sum_x) / count;
  double squares = 0;
  for (std::size_t i = 0; i < samples.log_ratio.size(); ++i) {
    const double left = samples.log_ratio[i] - gain - slope * samples.signed_bend_rad[i];
    const double error_N = samples.output_N[i] * (1 - std::exp(-left));
    squares += error_N * error_N;
  }
  return std::sqrt(squares / count);
}

}  // namespace

double rmse_floor_N(const Scenario& scenario) {
  if (scenario.data == Data::lives) {
    return 0;
  }
  SynthPlan nothing = host_sim::synth::parse_synth_plan(scenario.plan, "blind plan");
  nothing.hidden.clear();
  return rmse_N(samples_of(nothing, scenario));
}

double relative_gain(double before, double after, double floor) {
  return (before - after) / (before - floor);
}

}  // namespace blind
