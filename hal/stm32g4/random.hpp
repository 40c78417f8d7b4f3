#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/error.hpp"
#include "hal/stm32g4/register.hpp"

namespace hal::stm32g4 {

/// Random number generator, RM0440 26.7.
template <Word W>
struct RngRegisters {
  W cr, sr, dr;
};
static_assert(offsetof(RngRegisters<Register>, dr) == 0x08);

namespace rng {
// CR, 26.7.1
inline constexpr std::uint32_t kEnable = bit(2);
// SR, 26.7.2
inline constexpr std::uint32_t kReady = bit(0), kClockNow = bit(1), kSeedNow = bit(2);
inline constexpr std::uint32_t kClockError = bit(5), kSeedError = bit(6);
}  // namespace rng

/// hal::Entropy: the random number generator (RM0440 26.3).
template <Word W>
class RandomGenerator {
 public:
  explicit RandomGenerator(RngRegisters<W>& registers) : registers_(registers) {}

  void start() { registers_.cr.write(rng::kEnable); }

  /// failed, with `out` all zero, where the noise source or its clock is broken.
  Error fill(std::span<std::byte> out) {
    for (std::size_t i = 0; i < out.size(); i += 4) {
      std::uint32_t word = 0;
      if (take(word) != Error::none) {
        std::fill(out.begin(), out.end(), std::byte{0});
        return Error::failed;
      }
      for (std::size_t j = i; j < std::min(i + 4, out.size()); ++j) {
        out[j] = static_cast<std::byte>(word);
        word >>= 8;
      }
    }
    return Error::none;
  }

 private:
  /// A word takes 412 cycles of the bus at most.
  static constexpr std::uint32_t kPolls = 2'000;

  Error take(std::uint32_t& word) {
    const std::uint32_t before = registers_.sr.read();
    if ((before & rng::kSeedError) != 0 && recover() != Error::none) {
      return Error::failed;
    }
    if ((before & rng::kClockError) != 0) {
      registers_.sr.write(~rng::kClockError & (rng::kClockError | rng::kSeedError));
    }
    if (wait_until(registers_.sr, rng::kReady, rng::kReady, kPolls) != Error::none) {
      return Error::failed;
    }
    word = registers_.dr.read();
    const std::uint32_t after = registers_.sr.read();
    constexpr std::uint32_t kErrors = rng::kSeedError | rng::kSeedNow | rng::kClockNow;
    // A word of zero comes out when an error struck between the flag and the read (26.7.3).
    return (after & kErrors) == 0 && word != 0 ? Error::none : Error::failed;
  }

  /// RM0440 26.3.7: clears the seed error, throws twelve words away, and it must not be back.
  Error recover() {
    registers_.sr.write(~rng::kSeedError & (rng::kClockError | rng::kSeedError));
    for (int i = 0; i < 12; ++i) {
      static_cast<void>(registers_.dr.read());
    }
    return (registers_.sr.read() & rng::kSeedError) == 0 ? Error::none : Error::failed;
  }

  RngRegisters<W>& registers_;
};

}  // namespace hal::stm32g4
