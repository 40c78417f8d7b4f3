#pragma once

#include <cstdint>
#include <random>

namespace host_sim::statistics {

/// Random numbers of one replicate. What a replicate draws depends on seed, stream and number
/// alone, never on threads or ranks.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t number);

  /// Uniform in the open interval 0 .. 1, the same on every machine.
  double uniform();

 private:
  std::mt19937_64 engine_;
};

}  // namespace host_sim::statistics
