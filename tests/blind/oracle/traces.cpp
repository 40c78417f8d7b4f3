#include "tests/blind/oracle/traces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blind {

using host_sim::synth::Channels;

std::vector<double> log_ratio(const Channels& channels, Input input) {
  const auto& at_drive = channels[input == Input::load_cell ? host_sim::kInputTensionColumn
                                                            : host_sim::kMotorCurrentColumn];
  const auto& output = channels[host_sim::kOutputTensionColumn];
  constexpr double kLeast = 1e-6;
  std::vector<double> result(output.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = std::log(std::max(kLeast, output[i]) / std::max(kLeast, at_drive[i]));
  }
  return result;
}

std::vector<double> signed_bend_rad(const Channels& channels) {
  const auto& velocity = channels[host_sim::kTendonVelocity];
  const auto& bend_deg = channels[host_sim::kBendAngle];
  std::vector<double> result(velocity.size());
  double direction = 1;
  for (std::size_t i = 0; i < result.size(); ++i) {
    direction = velocity[i] > 0 ? 1 : velocity[i] < 0 ? -1 : direction;
    result[i] = direction * bend_deg[i] * std::numbers::pi / 180;
  }
  return result;
}

}  // namespace blind
