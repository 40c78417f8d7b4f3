#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"

namespace hal::qemu_mps2 {

/// Bytes that everybody who knows the seed can foretell: an emulator has no source of random
/// numbers, and a run has to be the same each time. Never for a controller that moves something.
///
/// SplitMix64: Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, 2014; the
/// words little-endian.
class SeededEntropy {
 public:
  explicit SeededEntropy(std::uint64_t seed) : state_(seed) {}

  Error fill(std::span<std::byte> out) {
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      word = i % 8 == 0 ? next() : word >> 8;
      out[i] = static_cast<std::byte>(word);
    }
    return Error::none;
  }

 private:
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t word = state_;
    word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
    word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
    return word ^ (word >> 31);
  }

  std::uint64_t state_;
};

}  // namespace hal::qemu_mps2
