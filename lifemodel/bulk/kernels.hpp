// Included by instructions.hpp for each set of instructions, inside of a namespace of its own:
// LIFEMODEL_LANES are the lanes that it has, LIFEMODEL_TARGET the attribute of its functions. No
// guard, for that reason.

/// Keeps the first and the last sample and those where the direction changes; one that stays counts
/// as rising, so that ranges alternate and only a rising one may be none.
/// `to` has room for as many and kSpare more. Returns how many there are.
LIFEMODEL_TARGET inline std::size_t find_extrema(const std::int32_t* samples, std::size_t count,
                                                 std::int32_t* to, Extremes& extremes) {
  using Lanes = LIFEMODEL_LANES;
  constexpr unsigned kAll = (1u << Lanes::kCount) - 1;
  std::int32_t* out = to;
  *out++ = samples[0];
  std::int32_t lowest = samples[0];
  std::int32_t highest = samples[0];
  unsigned falls = count > 1 && samples[1] < samples[0] ? 1 : 0;
  std::size_t i = 1;
  if (count > Lanes::kCount) {
    Lanes::V low = Lanes::all(lowest);
    Lanes::V high = low;
    for (; i + Lanes::kCount < count; i += Lanes::kCount) {
      const Lanes::V here = Lanes::load(samples + i);
      low = Lanes::least(low, here);
      high = Lanes::most(high, here);
      const unsigned falling = Lanes::less(Lanes::load(samples + i + 1), here);
      const unsigned turns = (falling ^ (falling << 1 | falls)) & kAll;
      falls = falling >> (Lanes::kCount - 1);
      Lanes::compress(out, here, turns);
      out += std::popcount(turns);
    }
    std::array<std::int32_t, Lanes::kCount> ends;
    Lanes::store(ends.data(), low);
    lowest = *std::min_element(ends.begin(), ends.end());
    Lanes::store(ends.data(), high);
    highest = *std::max_element(ends.begin(), ends.end());
  }
  for (; i < count; ++i) {
    const std::int32_t here = samples[i];
    lowest = std::min(lowest, here);
    highest = std::max(highest, here);
    const bool last = i + 1 == count;
    const unsigned falling = !last && samples[i + 1] < here ? 1 : 0;
    *out = here;
    out += last || falling != falls ? 1 : 0;
    falls = falling;
  }
  extremes = {lowest, highest};
  return static_cast<std::size_t>(out - to);
}

/// Takes out the ranges that are smaller than the one before and no larger than the one after, and
/// of them appends those of at least the hysteresis to `cycles`. Any such range closes whatever
/// comes before and after, and none has a point in common with another.
/// `to` has room for as many points and kSpare more. Returns how many points there are.
LIFEMODEL_TARGET inline std::size_t take_out_ranges(const std::int32_t* points, std::size_t count,
                                                    std::int32_t* to, std::int32_t hysteresis,
                                                    CycleList& cycles) {
  using Lanes = LIFEMODEL_LANES;
  constexpr unsigned kAll = (1u << Lanes::kCount) - 1;
  std::int32_t* out = to;
  std::int32_t* from_point = cycles.from + cycles.count;
  std::int32_t* to_point = cycles.to + cycles.count;
  *out++ = points[0];
  unsigned ends = 0;  // whether a range that ends with the next point is taken out
  std::size_t i = 1;
  const Lanes::V least = Lanes::all(hysteresis);
  for (; i + Lanes::kCount + 1 < count; i += Lanes::kCount) {
    const Lanes::V a = Lanes::load(points + i - 1);
    const Lanes::V b = Lanes::load(points + i);
    const Lanes::V c = Lanes::load(points + i + 1);
    const Lanes::V d = Lanes::load(points + i + 2);
    const Lanes::V range = Lanes::distance(b, c);
    const unsigned closes =
        Lanes::less(range, Lanes::distance(a, b)) & ~Lanes::less(Lanes::distance(c, d), range);
    const unsigned counts = closes & ~Lanes::less(range, least);
    const unsigned stays = ~(closes | closes << 1 | ends) & kAll;
    ends = closes >> (Lanes::kCount - 1);
    Lanes::compress(out, b, stays);
    out += std::popcount(stays);
    Lanes::compress(from_point, b, counts);
    Lanes::compress(to_point, c, counts);
    const int counted = std::popcount(counts);
    from_point += counted;
    to_point += counted;
  }
  for (; i < count; ++i) {
    bool closes = false;
    if (i + 2 < count) {
      const std::int32_t range = OneLane::distance(points[i], points[i + 1]);
      closes = range < OneLane::distance(points[i - 1], points[i]) &&
               range <= OneLane::distance(points[i + 1], points[i + 2]);
      *from_point = points[i];
      *to_point = points[i + 1];
      const int counted = closes && range >= hysteresis ? 1 : 0;
      from_point += counted;
      to_point += counted;
    }
    *out = points[i];
    out += closes || ends != 0 ? 0 : 1;
    ends = closes ? 1 : 0;
  }
  cycles.count = static_cast<std::size_t>(from_point - cycles.from);
  return static_cast<std::size_t>(out - to);
}

/// The cubic segment at `t`, see numeric::evaluate().
LIFEMODEL_TARGET inline LIFEMODEL_LANES::V evaluate(LIFEMODEL_LANES::Coefficients of,
                                                    LIFEMODEL_LANES::V t) {
  using Lanes = LIFEMODEL_LANES;
  const Lanes::V curve = Lanes::add(of.c2, Lanes::multiply_high(t, of.c3));
  const Lanes::V slope = Lanes::add(of.c1, Lanes::multiply_high(t, curve));
  return Lanes::add(of.c0, Lanes::multiply_high(t, slope));
}

/// CycleLaw of as many cycles as there are lanes, but for those that are doubtful.
/// @pre no point reaches the ultimate tension
LIFEMODEL_TARGET inline unsigned damages(const std::int32_t* from, const std::int32_t* to,
                                         const CycleLaw& law, std::int32_t* mantissas,
                                         std::int32_t* positions) {
  using Lanes = LIFEMODEL_LANES;
  constexpr int kLogStep = numeric::kLogBits - numeric::kSegmentBits;
  constexpr int kExpStep = numeric::kExpBits - numeric::kSegmentBits;
  constexpr std::int32_t kLogFraction = (1 << numeric::kLogBits) - 1;
  constexpr std::int32_t kExpFraction = (1 << numeric::kExpBits) - 1;
  constexpr std::int32_t kLowest = (1 - Damage::kFractionBits) * (1 << numeric::kExpBits);
  // That of a double, and of what log2_effective() takes in.
  constexpr std::uint32_t kBias = (1023u - (Tension::kFractionBits + 1)) << numeric::kLogBits;

  const Lanes::V x = Lanes::load(from);
  const Lanes::V y = Lanes::load(to);
  const Lanes::Ratio ratio = Lanes::ratio(Lanes::distance(x, y), Lanes::add(x, y));
  const Lanes::V log2 = Lanes::sub(ratio.log2, Lanes::all(static_cast<std::int32_t>(kBias)));
  const Lanes::V fraction = Lanes::both(log2, Lanes::all(kLogFraction));
  const Lanes::V t =
      Lanes::template left<31 - kLogStep>(Lanes::both(fraction, Lanes::all((1 << kLogStep) - 1)));
  const Lanes::V log2_fraction = Lanes::template right_unsigned<31 - numeric::kLogBits>(
      evaluate(Lanes::coefficients(kLog2, Lanes::template right<kLogStep>(fraction)), t));
  const Lanes::V log2_effective = Lanes::add(Lanes::sub(log2, fraction), log2_fraction);

  // The ends of the range are the whole life and the smallest damage.
  const Lanes::V log2_damage = Lanes::most(
      Lanes::least(
          Lanes::add(Lanes::multiply_high(
                         log2_effective, Lanes::all(static_cast<std::int32_t>(law.exponent.raw()))),
                     Lanes::all(law.log2_damage_at_ultimate)),
          Lanes::all(0)),
      Lanes::all(kLowest));
  const Lanes::V exp_fraction = Lanes::both(log2_damage, Lanes::all(kExpFraction));
  const Lanes::V exp_t = Lanes::template left<31 - kExpStep>(
      Lanes::both(exp_fraction, Lanes::all((1 << kExpStep) - 1)));
  Lanes::store(
      mantissas,
      evaluate(Lanes::coefficients(kExp2, Lanes::template right<kExpStep>(exp_fraction)), exp_t));
  Lanes::store(positions, Lanes::add(Lanes::template right<numeric::kExpBits>(log2_damage),
                                     Lanes::all(Damage::kFractionBits - 31)));
  return ratio.doubtful;
}

/// Adds the damage of the cycles, and forgets them; `cycles` has kSpare places to spare.
LIFEMODEL_TARGET inline void add_damages(const CycleList& cycles, const CycleLaw& law,
                                         DamageSum& sum) {
  using Lanes = LIFEMODEL_LANES;
  constexpr unsigned kCount = Lanes::kCount;
  std::array<std::int32_t, kCount> mantissas;
  std::array<std::int32_t, kCount> positions;
  // Two points that are a cycle, whatever stands there.
  std::fill_n(cycles.from + cycles.count, kCount, 0);
  std::fill_n(cycles.to + cycles.count, kCount, 1);
  for (std::size_t i = 0; i < cycles.count; i += kCount) {
    const unsigned doubtful =
        damages(cycles.from + i, cycles.to + i, law, mantissas.data(), positions.data());
    if (doubtful != 0) [[unlikely]] {
      for (unsigned lane = 0; lane < kCount; ++lane) {
        if ((doubtful >> lane & 1u) != 0) {
          const CycleDamage exact = law.below_ultimate(Tension::from_raw(cycles.from[i + lane]),
                                                       Tension::from_raw(cycles.to[i + lane]));
          mantissas[lane] = static_cast<std::int32_t>(exact.mantissa);
          positions[lane] = exact.position;
        }
      }
    }
    const std::size_t here = std::min<std::size_t>(kCount, cycles.count - i);
    if (here == kCount) [[likely]] {
      for (unsigned lane = 0; lane < kCount; ++lane) {
        sum.add(lane, {static_cast<std::uint32_t>(mantissas[lane]), positions[lane]});
      }
    } else {
      for (unsigned lane = 0; lane < here; ++lane) {
        sum.add(lane, {static_cast<std::uint32_t>(mantissas[lane]), positions[lane]});
      }
    }
  }
}
