#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host_sim/diagnose/tension/hypothesis.hpp"

namespace host_sim::diagnose {

/// All that the hypotheses of one campaign are compared on.
struct Evidence {
  std::span<const Session> sessions;
  GramOptions options;  ///< without effects and probes: baseline, whitening, threads
  double sample_sd = 0;
};

/// ln evidence of each shape of `moved`, beside companions whose shapes are held.
std::vector<double> evidences_at(const Evidence& evidence, std::span<const Component> companions,
                                 const Wanted& moved);

/// An effect over its shapes, beside others whose shapes are held.
struct ShapeSearch {
  Component best;
  double log_evidence = 0;       ///< averaged over the shapes
  double best_log_evidence = 0;  ///< of the best shape
};

/// From evidences at the effect's own shapes goes on between the neighbours of the best, where the
/// effect has one parameter of shape that is not a whole number.
/// @param at_shapes ln evidence at each of TensionEffect::shapes(), with the companions
ShapeSearch search_shape(const Evidence& evidence, const effects::TensionEffect& effect,
                         std::span<const double> at_shapes, std::span<const Component> companions);

/// ln of the mean over the shapes.
double mean_over_shapes(std::span<const double> log_evidences);

}  // namespace host_sim::diagnose
