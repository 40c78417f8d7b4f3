#pragma once

#include <span>

namespace host_sim::diagnose::lives {

/// A point of a standard normal variable, and the ln of its weight; the weights sum to 1.
struct NormalNode {
  double at = 0;
  double ln_weight = 0;
};

/// For limits: even steps, which hold integrands that break off.
std::span<const NormalNode> even_nodes();

/// Nine points of Gauss and Hermite: for integrands near a normal density.
std::span<const NormalNode> gauss_hermite_nodes();

}  // namespace host_sim::diagnose::lives
