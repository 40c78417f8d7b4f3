#include "host_sim/diagnose/tension/gain.hpp"

#include "host_sim/diagnose/tension/held_out.hpp"

namespace host_sim::diagnose {

Gain measure_gain(const Evidence& evidence, std::span<const Component> model,
                  const reference::Constants& constants) {
  const HeldOut before = held_out(evidence, {}, constants);
  const HeldOut after = held_out(evidence, model, constants);
  const auto mean_damage_error = [](const HeldOut& scores) {
    return scores.sum(&SessionScore::damage_error) / static_cast<double>(scores.sessions.size());
  };
  Gain gain{.held_out_by = "session", .metrics = {}};
  gain.metrics.push_back({"rmse_N", before.output_rmse_N(), after.output_rmse_N()});
  gain.metrics.push_back({"log_predictive_density", before.log_density(), after.log_density()});
  gain.metrics.push_back(
      {"damage_error_percent", 100 * mean_damage_error(before), 100 * mean_damage_error(after)});
  return gain;
}

}  // namespace host_sim::diagnose
