#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "hal/clock.hpp"
#include "hal/error.hpp"
#include "lifemodel/quantity/units.hpp"

/// What a run in virtual time has in place of devices.
namespace hal::qemu_mps2 {

/// Time that only advance() moves.
class VirtualClock {
 public:
  void advance(Time by) { now_ = now_ + by; }
  [[nodiscard]] Time now() const { return now_; }

 private:
  Time now_{};
};

/// In place of a raw sample: there is none.
inline constexpr std::int32_t kNoSample = std::numeric_limits<std::int32_t>::min();

/// Gives the motor currents that the player has put there, raw values of lifemodel::MotorCurrent.
template <std::size_t kTendons>
class PlayedSensor {
 public:
  using Sample = lifemodel::MotorCurrent;

  void put(std::span<const std::int32_t, kTendons> raw) {
    for (std::size_t tendon = 0; tendon < kTendons; ++tendon) {
      raw_[tendon] = raw[tendon];
    }
  }
  void set_failed(bool failed) { failed_ = failed; }

  Result<Sample> isr_read(std::size_t tendon) {
    if (failed_) {
      return Error::failed;
    }
    if (raw_[tendon] == kNoSample) {
      return Error::missing;
    }
    return Sample::from_raw(raw_[tendon]);
  }

 private:
  std::array<std::int32_t, kTendons> raw_{};
  bool failed_ = false;
};

// Lines that lead nowhere: the board has none of these, so the programs that play a recording set
// the inputs and look at the outputs.

class InputLine {
 public:
  void drive(bool asserted) { asserted_ = asserted; }
  Result<bool> asserted() { return asserted_; }

 private:
  bool asserted_ = false;
};

class OutputLine {
 public:
  Error set(bool asserted) {
    changes_ += asserted != asserted_ ? 1u : 0u;
    asserted_ = asserted;
    return Error::none;
  }
  [[nodiscard]] bool asserted() const { return asserted_; }
  /// Since the start, modulo 2^32.
  [[nodiscard]] std::uint32_t changes() const { return changes_; }

 private:
  bool asserted_ = false;
  std::uint32_t changes_ = 0;
};

/// Counts its feeds, modulo 2^32, and never bites.
class CountingWatchdog {
 public:
  void feed() { ++feeds_; }
  [[nodiscard]] std::uint32_t feeds() const { return feeds_; }

 private:
  std::uint32_t feeds_ = 0;
};

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
