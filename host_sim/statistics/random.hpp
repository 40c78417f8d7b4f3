#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace host_sim::statistics {

/// Random numbers of one replicate. What a replicate draws depends on seed, stream and number
/// alone, never on threads or ranks: Philox 4x64-10, a generator by counter (Salmon, Moraes, Dror,
/// Shaw: Parallel random numbers: as easy as 1, 2, 3, 2011), keyed by seed and stream, which counts
/// blocks of four numbers and replicates.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t stream, std::uint64_t number)
      : seed_(seed), stream_(stream), number_(number) {}

  /// Uniform in the open interval 0 .. 1, the same on every machine.
  double uniform() {
    if (next_ == block_.size()) {
      fill();
    }
    constexpr double kStep = 0x1p-53;
    return (static_cast<double>(block_[next_++] >> 11U) + 0.5) * kStep;
  }

 private:
  void fill();

  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t number_;
  std::uint64_t blocks_ = 0;  ///< filled so far
  std::array<std::uint64_t, 4> block_{};
  std::size_t next_ = block_.size();
};

}  // namespace host_sim::statistics
