#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/digital.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/faults.hpp"

namespace hal::fake {

/// An input line with edges at scripted times.
class DigitalIn {
 public:
  explicit DigitalIn(const Clock& clock) : clock_(clock) {}

  /// From now on. Edges that were scripted are gone.
  void set(bool asserted) {
    level_ = asserted;
    edges_ = 0;
  }
  /// From that time on. Times of one script rise; at most kEdges of them.
  void edge_at(Time time, bool asserted) {
    if (edges_ == kEdges) {
      __builtin_trap();
    }
    all_[edges_++] = {time, asserted};
  }

  Result<bool> asserted() {
    if (const auto fault = faults.next(clock_.now())) {
      return *fault;
    }
    bool level = level_;
    for (std::size_t i = 0; i < edges_ && all_[i].time <= clock_.now(); ++i) {
      level = all_[i].asserted;
    }
    return level;
  }

  static constexpr std::size_t kEdges = 64;
  Faults<Error> faults;

 private:
  struct Edge {
    Time time;
    bool asserted;
  };

  const Clock& clock_;
  bool level_ = false;
  std::array<Edge, kEdges> all_{};
  std::size_t edges_ = 0;
};

/// An output line that remembers. With a fault it stays as it was.
class DigitalOut {
 public:
  explicit DigitalOut(const Clock& clock) : clock_(clock) {}

  Error set(bool asserted) {
    if (const auto fault = faults.next(clock_.now())) {
      return *fault;
    }
    if (asserted != asserted_) {
      asserted_ = asserted;
      changed_at_ = clock_.now();
      ++changes_;
    }
    return Error::none;
  }

  [[nodiscard]] bool asserted() const { return asserted_; }
  [[nodiscard]] Time changed_at() const { return changed_at_; }
  [[nodiscard]] std::uint32_t changes() const { return changes_; }

  Faults<Error> faults;

 private:
  const Clock& clock_;
  bool asserted_ = false;
  Time changed_at_{};
  std::uint32_t changes_ = 0;
};

static_assert(hal::DigitalIn<DigitalIn>);
static_assert(hal::DigitalOut<DigitalOut>);

}  // namespace hal::fake
