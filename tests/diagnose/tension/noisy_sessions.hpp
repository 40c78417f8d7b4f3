#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "host_sim/diagnose/tension/hypothesis.hpp"
#include "host_sim/reference/constants.hpp"
#include "host_sim/statistics/random.hpp"
#include "tests/diagnose/audit/sessions.hpp"

namespace host_sim::diagnose::testing {

inline constexpr reference::Constants kWire{177.4, 0.2, 1.53e5, 1.38, 5.94};
inline constexpr double kSample_sd = 0.02;

/// Standard normal, of two uniform numbers (Box and Muller).
double normal(statistics::Random& random);

/// What sessions hold beside the baseline.
struct Disturbances {
  double sample_sd = 0.01;  ///< of ln T_out
  double ar1 = 0;           ///< correlation from sample to sample; the sd stays
  double session_gain_sd = 0.01;
  double session_friction_sd = 0.006;
  /// Added to ln T_out of sample i.
  std::function<double(const recording::Covariates& covariates, std::size_t i)> effect = nullptr;
};

/// What a preload adds to ln T_out of a sample.
std::function<double(const recording::Covariates& covariates, std::size_t i)> preload(
    double force_N);

/// Sessions of these runs with noise and scatter of this seed. Effects that read T_out see what
/// was there before.
std::vector<Session> noisy_sessions(const std::vector<Run>& runs, const Disturbances& disturbances,
                                    std::uint64_t seed);

/// Twelve runs of 4 s: two poses, three loads, two speeds.
std::vector<Run> small_design();

/// What hypotheses are compared on where the noise is white.
Evidence evidence_of(const std::vector<Session>& sessions, double sample_sd);

/// An effect of the catalogue in this shape. @throws std::out_of_range
Component component(std::string_view id, std::vector<double> shape = {});

}  // namespace host_sim::diagnose::testing
