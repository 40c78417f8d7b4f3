#pragma once

#include <cstdint>

#include "hal/error.hpp"
#include "hal/result.hpp"

/// Lines that lead nowhere: the board has none of these, so the programs that play a recording set
/// the inputs and look at the outputs.
namespace hal::qemu_mps2 {

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

}  // namespace hal::qemu_mps2
