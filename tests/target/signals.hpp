#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

/// Signals in integer arithmetic alone, so that the host and the target compute the same ones.
/// Samples are raw values of lifemodel::Tension.
namespace target {

/// 1 N in steps of 2^-29 of the ultimate tension of 177.4 N.
inline constexpr std::int32_t kNewton = 3026330;

/// Marsaglia's xorshift, period 2^32 - 1.
class Random {
 public:
  explicit Random(std::uint32_t seed) : state_(seed) {}

  std::uint32_t next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  /// Uniform, 0 .. end - 1.
  std::int32_t below(std::int32_t end) {
    return static_cast<std::int32_t>((std::uint64_t{next()} * static_cast<std::uint32_t>(end)) >>
                                     32);
  }
  /// Normal in good approximation: the sum of twelve uniform numbers, less than six deviations out.
  std::int32_t normal(std::int32_t deviation) {
    std::int64_t sum = -6 * std::int64_t{0xffff};
    for (int i = 0; i < 12; ++i) {
      sum += next() >> 16;
    }
    return static_cast<std::int32_t>((sum * deviation) >> 16);
  }

 private:
  std::uint32_t state_;
};

inline void constant(std::span<std::int32_t> out) {
  std::ranges::fill(out, 77 * kNewton / 2);
}

/// 38.5 N +- 10 N, 1000 samples a cycle.
inline void sine(std::span<std::int32_t> out) {
  constexpr std::int64_t kCosine = 1073720629;  // of 2 pi / 1000, Q30
  constexpr std::int64_t kSine = 6746474;
  constexpr std::size_t kPeriod = 1000;
  std::int64_t x = std::int64_t{1} << 30;
  std::int64_t y = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i >= kPeriod) {
      out[i] = out[i - kPeriod];
      continue;
    }
    out[i] = 77 * kNewton / 2 + static_cast<std::int32_t>((y * 10 * kNewton) >> 30);
    const std::int64_t turned = (x * kCosine - y * kSine) >> 30;
    y = (x * kSine + y * kCosine) >> 30;
    x = turned;
  }
}

/// The same with noise of 1 % of the amplitude.
inline void noisy_sine(std::span<std::int32_t> out) {
  sine(out);
  Random random(1);
  for (std::int32_t& sample : out) {
    sample += random.normal(kNewton / 10);
  }
}

/// Uniform, 0 .. 100 N.
inline void white_noise(std::span<std::int32_t> out) {
  Random random(2);
  for (std::int32_t& sample : out) {
    sample = random.below(100 * kNewton);
  }
}

/// Steps of up to 1 N, reflected at 0 and 150 N.
inline void walk(std::span<std::int32_t> out) {
  Random random(3);
  std::int32_t tension = 50 * kNewton;
  for (std::int32_t& sample : out) {
    tension += random.below(2 * kNewton) - kNewton;
    tension = tension < 0 ? -tension : std::min(tension, 300 * kNewton - tension);
    sample = tension;
  }
}

/// In steps of 0.25 N, so that many samples are equal.
inline void quantised(std::span<std::int32_t> out) {
  walk(out);
  for (std::int32_t& sample : out) {
    sample -= sample % (kNewton / 4);
  }
}

/// Turning points about 50 N that close in by 0.28 N each for 320 points, deeper than the residue;
/// then one that closes them all.
inline void spiral_in(std::span<std::int32_t> out) {
  constexpr std::size_t kTurns = 320;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto turn = static_cast<std::int32_t>(i % (kTurns + 1));
    const std::int32_t swing = (i % 2 == 0 ? 1 : -1) * (45 * kNewton - turn * (kNewton / 7));
    out[i] = 50 * kNewton + swing;
  }
}

/// Turning points about 50 N that move away from it.
inline void spiral_out(std::span<std::int32_t> out) {
  constexpr std::size_t kTurns = 321;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto turn = static_cast<std::int32_t>(i % kTurns);
    out[i] = 50 * kNewton + (i % 2 == 0 ? 1 : -1) * (turn + 1) * (kNewton / 7);
  }
}

/// In until `kDepth` points nest, then out again: every closing range closes one cycle, and at the
/// end one point closes many.
inline void nest_and_close(std::span<std::int32_t> out) {
  constexpr std::int32_t kDepth = 120;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto place = static_cast<std::int32_t>(i % (kDepth + 2));
    const std::int32_t swing = place < kDepth ? 45 * kNewton - place * (kNewton / 3) : 60 * kNewton;
    out[i] = 50 * kNewton + (place % 2 == 0 ? 1 : -1) * swing;
  }
}

/// Noise beyond the ultimate tension and below zero.
inline void overload(std::span<std::int32_t> out) {
  Random random(4);
  for (std::int32_t& sample : out) {
    sample = random.below(500 * kNewton) - 250 * kNewton;
  }
}

/// Between the ends of the range, with smaller ranges in between.
inline void extremes(std::span<std::int32_t> out) {
  constexpr std::int32_t kEnd = std::numeric_limits<std::int32_t>::max();
  constexpr std::array<std::int32_t, 6> kPattern{kEnd, -kEnd, kEnd - 1, 0, 1, -kEnd};
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = kPattern[i % kPattern.size()];
  }
}

/// Ranges at the hysteresis.
inline void ripple(std::span<std::int32_t> out) {
  Random random(5);
  for (std::int32_t& sample : out) {
    sample = 30 * kNewton + random.below(kNewton / 4);
  }
}

struct Signal {
  const char* name;
  void (*fill)(std::span<std::int32_t>);
};

inline constexpr std::array kSignals{
    Signal{"constant", constant},
    Signal{"sine", sine},
    Signal{"noisy_sine", noisy_sine},
    Signal{"white_noise", white_noise},
    Signal{"walk", walk},
    Signal{"quantised", quantised},
    Signal{"spiral_in", spiral_in},
    Signal{"spiral_out", spiral_out},
    Signal{"nest_and_close", nest_and_close},
    Signal{"overload", overload},
    Signal{"extremes", extremes},
    Signal{"ripple", ripple},
};

}  // namespace target
