#pragma once

#include <cstdint>

#include "hal/fake/clock.hpp"
#include "hal/watchdog.hpp"

namespace hal::fake {

/// A watchdog that runs from its construction on and remembers whether it has bitten. It bites
/// where more than its period passes without a feed; feeding it afterwards undoes nothing.
class Watchdog {
 public:
  Watchdog(const Clock& clock, Time period) : clock_(clock), period_(period), fed_(clock.now()) {}

  void feed() {
    bitten_ = bitten();
    fed_ = clock_.now();
    ++feeds_;
  }

  [[nodiscard]] bool bitten() const { return bitten_ || clock_.now() - fed_ > period_; }
  [[nodiscard]] std::uint32_t feeds() const { return feeds_; }

 private:
  const Clock& clock_;
  Time period_;
  Time fed_;
  bool bitten_ = false;
  std::uint32_t feeds_ = 0;
};

static_assert(hal::Watchdog<Watchdog>);

}  // namespace hal::fake
