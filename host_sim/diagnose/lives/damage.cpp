#include "host_sim/diagnose/lives/damage.hpp"

#include <cmath>
#include <limits>

namespace host_sim::diagnose::lives {
namespace {

Damage miner(std::span<const LoadedBlock> blocks) {
  double sum = 0;
  for (const LoadedBlock& block : blocks) {
    sum += block.cycles * std::exp(-block.ln_life);
  }
  return {.ln = sum > 0 ? std::log(sum) : -std::numeric_limits<double>::infinity(),
          .ln_rate = -blocks.back().ln_life};
}

/// Share of life that is spent at a strength, with its slope in ln of the strength.
struct Spent {
  double share = 0;
  double slope = 0;
};

Spent spent(std::span<const LoadedBlock> blocks, double exponent, double ln_strength) {
  Spent result;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (i > 0 && result.share > 0) {
      const double power = std::exp(exponent * (blocks[i - 1].ln_life - blocks[i].ln_life));
      const double carried = std::pow(result.share, power);
      result.slope *= power * carried / result.share;
      result.share = carried;
    }
    const double used = blocks[i].cycles * std::exp(-blocks[i].ln_life - ln_strength);
    result.share += used;
    result.slope -= used;
  }
  return result;
}

}  // namespace

Damage damage_of(std::span<const LoadedBlock> blocks, double sequence_exponent) {
  if (blocks.size() == 1) {
    const LoadedBlock& block = blocks.front();
    return {.ln = std::log(block.cycles) - block.ln_life, .ln_rate = -block.ln_life};
  }
  const Damage damage = miner(blocks);
  bool finite = std::isfinite(damage.ln);
  for (const LoadedBlock& block : blocks) {
    finite = finite && std::isfinite(block.ln_life);
  }
  if (sequence_exponent == 0 || !finite) {
    return damage;
  }
  double low = damage.ln - 1;
  double high = damage.ln + 1;
  while (spent(blocks, sequence_exponent, low).share < 1) {
    low -= 2;
  }
  while (spent(blocks, sequence_exponent, high).share > 1) {
    high += 2;
  }
  double at = damage.ln;
  Spent now = spent(blocks, sequence_exponent, at);
  constexpr int kSteps = 100;
  constexpr double kClose = 1e-13;
  for (int step = 0; step < kSteps && std::abs(now.share - 1) > kClose; ++step) {
    (now.share > 1 ? low : high) = at;
    const double newton = at - std::log(now.share) * now.share / now.slope;
    at = newton > low && newton < high ? newton : (low + high) / 2;
    now = spent(blocks, sequence_exponent, at);
  }
  // A cycle more adds 1/(w alpha) to the share; the strength makes up for it.
  return {.ln = at, .ln_rate = -blocks.back().ln_life - std::log(-now.slope)};
}

}  // namespace host_sim::diagnose::lives
