#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/synth/plan/plan.hpp"
#include "host_sim/synth/tension/rig.hpp"

namespace host_sim::synth {

/// What was hidden in a campaign and drawn for it.
struct Truth {
  std::vector<Setting> settings;
  std::vector<SessionScatter> scatter;  ///< for each setting
  std::vector<double> bend_errors_deg;  ///< for each setting, of the effect bend_angle
};

/// The truth as JSON.
std::string truth_json(const SynthPlan& plan, std::uint64_t seed, const Truth& truth);

/// SHA-256 of a text, as 64 hexadecimal digits.
std::string sha256(std::string_view text);

}  // namespace host_sim::synth
