#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "host_sim/diagnose/evidence.hpp"

namespace host_sim::diagnose {

/// An effect in one shape.
struct Component {
  const effects::TensionEffect* effect = nullptr;
  std::vector<double> shape;
};

/// A cause, or two at once, that is compared with others by its evidence.
struct Hypothesis {
  std::vector<Component> parts;  ///< in order of their ids; none: the nominal model
  /// ln, averaged over the shapes of its parts, the sizes and the scatter of sessions.
  double log_evidence = 0;

  /// "none", "slack" or "compliance+slack".
  [[nodiscard]] std::string id() const;
  [[nodiscard]] bool holds(std::string_view id) const;
};

/// Whether two of the parts act at reversals: their signatures do not add up as the others' do.
bool entangled(std::span<const Component> parts);

/// Whether two of the parts are each other's confounders, by their separations: together they
/// imitate much that the catalogue does not have.
bool confounded(std::span<const Component> parts);

/// The parts as effects wanted, with one shape each.
std::vector<Wanted> wanted_of(std::span<const Component> parts);

/// All columns of the effects of a layout, of those with one shape.
Terms terms_of(const GramLayout& layout);

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

/// From evidences at the effect's own shapes continues between the neighbours of the best, where
/// the effect has one parameter of shape that is not a whole number.
/// @param at_shapes ln evidence at each of TensionEffect::shapes(), with the companions
ShapeSearch search_shape(const Evidence& evidence, const effects::TensionEffect& effect,
                         std::span<const double> at_shapes, std::span<const Component> companions);

/// ln of the mean over the shapes.
double mean_over_shapes(std::span<const double> log_evidences);

}  // namespace host_sim::diagnose
