#pragma once

#include <cstdint>

#include "hal/entropy.hpp"
#include "hal/fake/clock.hpp"
#include "hal/fake/faults.hpp"
#include "hal/fake/random.hpp"

namespace hal::fake {

/// The same bytes for the same seed: for tests, and for runs that have to be repeatable.
class Entropy {
 public:
  Entropy(const Clock& clock, std::uint64_t seed) : clock_(clock), random_(seed) {}

  Error fill(std::span<std::byte> out) {
    const auto fault = faults.next(clock_.now());
    for (std::byte& byte : out) {
      byte = fault ? std::byte{} : static_cast<std::byte>(random_.next() >> 56);
    }
    return fault.value_or(Error::none);
  }

  Faults<Error> faults;

 private:
  const Clock& clock_;
  Random random_;
};

static_assert(hal::Entropy<Entropy>);

}  // namespace hal::fake
