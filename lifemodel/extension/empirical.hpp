#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "lifemodel/extension/fixed.hpp"
#include "lifemodel/input/capstan.hpp"
#include "lifemodel/numeric/quotient.hpp"
#include "lifemodel/quantity/units.hpp"

namespace lifemodel::extension {

/// What a model leaves, without a cause: a force added to the input tension by a table over one
/// covariate for each direction, linear between its knots and constant beyond them.
struct Empirical {
  enum Covariate : std::int32_t {
    output_tension,  ///< its size without zero and lag, Q29
    position,        ///< of the rotor in turns, Q20
    speed,           ///< as Velocity, Q24
    travel,          ///< since the motion turned: a sum of speeds Q24 over samples, / 2^6
  };
  static constexpr std::int32_t kCovariates = 4;
  static constexpr int kPositionBits = 20;
  static constexpr int kTravelDrop = 6;
  static constexpr std::size_t kKnots = 16;
  struct Knot {
    std::int32_t at = 0;
    std::int32_t pulling = 0;  ///< relative to the ultimate tension, Q29
    std::int32_t letting_go = 0;
  };

  std::int32_t covariate = output_tension;
  std::int32_t knots = 1;
  std::array<Knot, kKnots> knot{};

  [[nodiscard]] constexpr bool plausible() const {
    if (covariate < 0 || covariate >= kCovariates || knots < 1 ||
        knots > static_cast<std::int32_t>(kKnots)) {
      return false;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(knots); ++i) {
      if ((i > 0 && knot[i].at <= knot[i - 1].at) || !is_force(knot[i].pulling) ||
          !is_force(knot[i].letting_go)) {
        return false;
      }
    }
    return true;
  }
  template <class Word>
  constexpr void words(Word&& word) {
    word(covariate);
    word(knots);
    for (Knot& each : knot) {
      word(each.at);
      word(each.pulling);
      word(each.letting_go);
    }
  }

  /// The force at a value of the covariate, Q29.
  [[nodiscard]] constexpr std::int64_t added(std::int32_t at, Direction direction) const {
    const auto count = static_cast<std::size_t>(knots);
    const std::size_t above = first_above(at, count);
    const std::int64_t from = force(above == 0 ? 0 : above - 1, direction);
    if (above == 0 || above == count || knot[above - 1].at == at) {
      return from;
    }
    const auto base = static_cast<std::uint32_t>(knot[above - 1].at);
    const numeric::Normal share = numeric::quotient(
        static_cast<std::uint32_t>(at) - base, static_cast<std::uint32_t>(knot[above].at) - base);
    // Below 1, so that the exponent is negative.
    constexpr int kMore = kFactorBits - numeric::kMantissaBits;
    const std::uint64_t along = (std::uint64_t{share.mantissa} << kMore) >> -share.exponent;
    return from + rounded((force(above, direction) - from) * static_cast<std::int64_t>(along),
                          kFactorBits);
  }

 private:
  /// By bisection.
  [[nodiscard]] constexpr std::size_t first_above(std::int32_t at, std::size_t count) const {
    std::size_t first = 0;
    while (count > 0) {
      const std::size_t half = count / 2;
      if (knot[first + half].at <= at) {
        first += half + 1;
        count -= half + 1;
      } else {
        count = half;
      }
    }
    return first;
  }

  static constexpr bool is_force(std::int32_t force) {
    return force >= -kUltimate.raw() && force <= kUltimate.raw();
  }
  [[nodiscard]] constexpr std::int64_t force(std::size_t i, Direction direction) const {
    return direction == Direction::pulling ? knot[i].pulling : knot[i].letting_go;
  }
};

}  // namespace lifemodel::extension
