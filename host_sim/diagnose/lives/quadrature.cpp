#include "host_sim/diagnose/lives/quadrature.hpp"

#include <boost/math/special_functions/hermite.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace host_sim::diagnose::lives {
namespace {

std::vector<NormalNode> normalised(std::vector<NormalNode> nodes) {
  double sum = 0;
  for (const NormalNode& node : nodes) {
    sum += std::exp(node.ln_weight);
  }
  for (NormalNode& node : nodes) {
    node.ln_weight -= std::log(sum);
  }
  return nodes;
}

std::vector<NormalNode> make_even() {
  constexpr double kStep = 0.15;
  constexpr int kSteps = 23;
  std::vector<NormalNode> nodes;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double at = kStep * i;
    nodes.push_back({at, -at * at / 2});
  }
  return normalised(std::move(nodes));
}

/// Root of the Hermite polynomial of degree `n` between two points of opposite sign.
double root_between(unsigned n, double low, double high) {
  const bool rises = boost::math::hermite(n, high) > 0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    ((boost::math::hermite(n, middle) > 0) == rises ? high : low) = middle;
  }
  return (low + high) / 2;
}

/// Roots x of H_n with weights proportional to 1/H_(n-1)(x)^2, for exp(-x^2); z = sqrt(2) x.
std::vector<NormalNode> make_gauss_hermite() {
  constexpr unsigned kNodes = 9;
  constexpr double kWidest = 4;
  constexpr double kStep = 0.05;
  std::vector<NormalNode> nodes;
  // Off the symmetric grid, so that no root is at one of its points.
  for (double low = -kWidest - kStep / 3; low < kWidest; low += kStep) {
    const double high = low + kStep;
    if (boost::math::hermite(kNodes, low) * boost::math::hermite(kNodes, high) < 0) {
      const double root = root_between(kNodes, low, high);
      const double before = boost::math::hermite(kNodes - 1, root);
      nodes.push_back({std::numbers::sqrt2 * root, -2 * std::log(std::abs(before))});
    }
  }
  return normalised(std::move(nodes));
}

}  // namespace

std::span<const NormalNode> even_nodes() {
  static const std::vector<NormalNode> nodes = make_even();
  return nodes;
}

std::span<const NormalNode> gauss_hermite_nodes() {
  static const std::vector<NormalNode> nodes = make_gauss_hermite();
  return nodes;
}

}  // namespace host_sim::diagnose::lives
