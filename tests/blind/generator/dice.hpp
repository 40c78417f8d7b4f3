#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_sim/synth/draws.hpp"

namespace blind {

/// What is drawn for one purpose does not depend on what is drawn for another. The numbers lie
/// apart from those of the streams of the simulation, which has the same seeds.
enum class Purpose : std::uint64_t { kind = 1001, effects, sizes, design, noise, nominal, ends };

/// Draws of a scenario.
class Dice {
 public:
  /// @param attempt of several at the same purpose
  Dice(std::uint64_t seed, Purpose purpose, std::uint64_t attempt = 0)
      : random_(seed, static_cast<std::uint64_t>(purpose), attempt) {}

  double between(double low, double high);
  /// Uniform in the logarithm. @pre 0 < low
  double log_between(double low, double high);
  /// 1 or -1.
  double sign();
  bool chance(double probability);
  /// 0 .. count - 1.
  std::size_t below(std::size_t count);

  template <class T>
  const T& one_of(const std::vector<T>& values) {
    return values[below(values.size())];
  }

 private:
  host_sim::synth::Random random_;
};

}  // namespace blind
