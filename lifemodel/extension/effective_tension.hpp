#pragma once

#include <algorithm>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/quantity/units.hpp"

/// Effects on the effective tension of a cycle, T_eff of the life law.
namespace lifemodel::extension {

/// The laws of mean stress, with something added to the amplitude: `twice_more` is twice that, Q29.
/// log2 T_eff, Q26. None falls as the cycle widens, with one `twice_more`: near the ultimate
/// tension those of Gerber and Goodman would, as the mean that falls saves more than the amplitude
/// costs beside a large addition. There the addition alone, about the point that is furthest out,
/// does more, and counts.
/// @pre x != y, neither reaches the ultimate tension
namespace mean_law {

inline constexpr std::uint32_t kTwo = 2u << Tension::kFractionBits;
inline constexpr std::int32_t kScale = Tension::kFractionBits << numeric::kLogBits;
inline constexpr std::int32_t kHalf = 1 << numeric::kLogBits;

/// T_a/(1 - (T_m/T_u)^2)
constexpr std::int32_t gerber(Tension x, Tension y, std::uint32_t twice_more) {
  const std::int32_t sum = x.raw() + y.raw();
  std::uint32_t twice_amplitude = distance(x, y).raw() + twice_more;
  auto twice_mean = static_cast<std::uint32_t>(sum < 0 ? -sum : sum);
  // With T the furthest out, more (T + T_m) > 1 - T^2 is more/(1 - T^2) > (T_a + more)/(1 - T_m^2).
  const std::uint32_t twice_furthest =
      2 * static_cast<std::uint32_t>(sum < 0 ? -std::min(x, y).raw() : std::max(x, y).raw());
  if (std::uint64_t{twice_more} * (twice_furthest + twice_mean) >
      std::uint64_t{kTwo - twice_furthest} * (kTwo + twice_furthest)) {
    twice_amplitude = twice_more;
    twice_mean = twice_furthest;
  }
  numeric::Normal ratio =
      numeric::quotient(twice_amplitude, std::uint64_t{kTwo - twice_mean} * (kTwo + twice_mean));
  ratio.exponent += Tension::kFractionBits + 1;
  return numeric::log2(ratio);
}

/// T_a/(1 - T_m/T_u)
constexpr std::int32_t goodman(Tension x, Tension y, std::uint32_t twice_more) {
  const std::uint32_t left = kTwo - static_cast<std::uint32_t>(2 * std::max(x, y).raw());
  return numeric::log2(
      twice_more > left ? numeric::quotient(twice_more, left)
                        : numeric::quotient(distance(x, y).raw() + twice_more,
                                            kTwo - static_cast<std::uint32_t>(x.raw() + y.raw())));
}

/// (T_m + T_a)^(1-w) T_a^w; no damage where T_m + T_a is not above 0.
constexpr std::int32_t walker(Tension x, Tension y, std::uint32_t twice_more, std::int32_t w) {
  const std::int64_t twice_highest = 2 * std::int64_t{std::max(x, y).raw()} + twice_more;
  if (twice_highest <= 0) {
    return kNoDamage;
  }
  return weighted(w, log2_of(distance(x, y).raw() + twice_more) - kScale - kHalf,
                  log2_of(static_cast<std::uint32_t>(twice_highest)) - kScale - kHalf);
}

}  // namespace mean_law

/// Another mean-stress law in place of Gerber's, by a share:
/// T_eff = T_Gerber^(1 - share) T_law^share with Walker's law, or where w is 0 Goodman's.
struct MeanStress {
  std::int32_t share = 0;   ///< Q28, 0 .. 1
  std::int32_t walker = 0;  ///< w, Q28, 0 .. 1

  [[nodiscard]] constexpr bool plausible() const {
    return share >= 0 && share <= kOne && walker >= 0 && walker <= kOne;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(share);
    word(walker);
  }

  /// See mean_law. Without a share it is Gerber's.
  [[nodiscard]] constexpr std::int32_t log2_effective(Tension x, Tension y,
                                                      std::uint32_t twice_more) const {
    const std::int32_t gerber = mean_law::gerber(x, y, twice_more);
    if (share == 0) {
      return gerber;
    }
    return weighted(share,
                    walker != 0 ? mean_law::walker(x, y, twice_more, walker)
                                : mean_law::goodman(x, y, twice_more),
                    gerber);
  }
};

/// Bending stress of the wire over a small radius: T_a + c d_w/D in place of T_a in the law of mean
/// stress, by a share: T_eff(T_a)^(1 - share) T_eff(T_a + c d_w/D)^share.
struct BendingFatigue {
  std::int32_t share = 0;       ///< Q28, 0 .. 1
  std::int32_t twice_bend = 0;  ///< 2 c d_w/D relative to the ultimate tension, Q29

  static constexpr std::int32_t kMost = 3 << Tension::kFractionBits;
  [[nodiscard]] constexpr bool plausible() const {
    return share >= 0 && share <= kOne && twice_bend >= 0 && twice_bend <= kMost;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(share);
    word(twice_bend);
  }

  /// log2 T_eff with the bend, Q26. Each of the two laws that it lies between never falls as the
  /// cycle widens, so it does not either.
  /// @pre x != y, neither reaches the ultimate tension
  [[nodiscard]] constexpr std::int32_t log2_effective(const MeanStress& mean_stress, Tension x,
                                                      Tension y) const {
    if (share == 0) {
      return mean_stress.log2_effective(x, y, 0);
    }
    const std::int32_t bent =
        mean_stress.log2_effective(x, y, static_cast<std::uint32_t>(twice_bend));
    return share == kOne ? bent : weighted(share, bent, mean_stress.log2_effective(x, y, 0));
  }
};

/// Fatigue limit S_e: T_eff (1 - S_e/T_eff)^share, with share 1 the excess over the limit. The
/// scatter of the limit from wire to wire is no part of it.
struct EnduranceLimit {
  std::int32_t share = 0;       ///< Q28, 0 .. 1
  std::int32_t log2_limit = 0;  ///< of S_e relative to the ultimate tension, Q26

  [[nodiscard]] constexpr bool plausible() const {
    return share >= 0 && share <= kOne && log2_limit >= kNoDamage && log2_limit <= 0;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(share);
    word(log2_limit);
  }

  /// log2 T_eff over the limit, Q26; never falls as the one without limit grows. Below the limit a
  /// cycle does the smallest damage there is, in the share of 1.
  [[nodiscard]] constexpr std::int32_t log2_effective(std::int32_t nominal) const {
    constexpr int kDrop = numeric::kLogBits - kExponentBits;
    const std::int32_t part = exp2_factor((std::int64_t{log2_limit} - nominal) >> kDrop);
    const std::int32_t left = part < kOne ? kOne - part : 0;
    const std::int32_t log2_left =
        left > 0 ? log2_of(static_cast<std::uint32_t>(left)) - (kFactorBits << numeric::kLogBits)
                 : kNoDamage;
    const std::int64_t sum = nominal + ((std::int64_t{log2_left} * share) >> kFactorBits);
    return held(sum, kNoDamage, 1 << 30);
  }
};

}  // namespace lifemodel::extension
