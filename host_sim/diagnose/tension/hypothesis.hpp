#pragma once

#include <Eigen/Core>
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

}  // namespace host_sim::diagnose
