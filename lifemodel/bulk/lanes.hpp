#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "lifemodel/numeric/logarithm.hpp"
#include "lifemodel/numeric/tables.hpp"
#include "lifemodel/quantity/units.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

/// For hosts: several 32-bit numbers at once. Each of these types has the same members, so that
/// what is counted is written once, see kernels.hpp. A set of lanes is a word with a bit for each,
/// the first lane lowest.
namespace lifemodel::bulk {

/// The segments of a function, by segment and by coefficient.
struct Segments {
  std::array<numeric::Segment, 16> rows;
  alignas(32) std::array<std::array<std::int32_t, 16>, 4> columns;

  constexpr explicit Segments(const std::array<numeric::Segment, 16>& of) : rows(of), columns() {
    for (std::size_t i = 0; i < of.size(); ++i) {
      columns[0][i] = static_cast<std::int32_t>(of[i].c0);
      columns[1][i] = of[i].c1;
      columns[2][i] = of[i].c2;
      columns[3][i] = of[i].c3;
    }
  }
};

/// A quotient n / ((1 - s) (1 + s)) as numeric::quotient() would round it, by an approximation in
/// double: its rounded logarithm is that of the exact one unless the bits that are dropped are
/// within kDoubt of a carry. Three roundings make at most 2 units in the last place.
struct Rounding {
  static constexpr std::int64_t kDropped = 52 - numeric::kMantissaBits;
  static constexpr std::int32_t kDroppedMask = (1 << kDropped) - 1;
  static constexpr std::int32_t kDoubt = 4;
  static constexpr double kTwo = 2.0 * (1 << Tension::kFractionBits);
};

/// One number: for every machine, and for what is left of the lanes of others.
struct OneLane {
  static constexpr unsigned kCount = 1;
  using V = std::int32_t;
  struct Ratio {
    V log2;
    unsigned doubtful;
  };
  struct Coefficients {
    V c0, c1, c2, c3;
  };

  static V load(const std::int32_t* from) { return *from; }
  static void store(std::int32_t* to, V v) { *to = v; }
  static V all(std::int32_t value) { return value; }
  static V add(V a, V b) {
    return static_cast<V>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
  }
  static V sub(V a, V b) {
    return static_cast<V>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
  }
  static V both(V a, V b) { return a & b; }
  static V least(V a, V b) { return a < b ? a : b; }
  static V most(V a, V b) { return a > b ? a : b; }
  static V distance(V a, V b) { return a < b ? b - a : a - b; }
  template <int kBits>
  static V left(V v) {
    return static_cast<V>(static_cast<std::uint32_t>(v) << kBits);
  }
  template <int kBits>
  static V right(V v) {
    return v >> kBits;
  }
  template <int kBits>
  static V right_unsigned(V v) {
    return static_cast<V>(static_cast<std::uint32_t>(v) >> kBits);
  }
  static V multiply_high(V a, V b) { return numeric::multiply_high(a, b); }
  /// The lanes where a < b.
  static unsigned less(V a, V b) { return a < b ? 1 : 0; }
  /// Stores the lanes of the set one after the other; the rest of kCount places is overwritten.
  static void compress(std::int32_t* to, V v, unsigned /*set*/) { *to = v; }
  static Coefficients coefficients(const Segments& of, V segment) {
    const numeric::Segment& s = of.rows[static_cast<std::size_t>(segment)];
    return {static_cast<V>(s.c0), s.c1, s.c2, s.c3};
  }
  /// The exponent, modulo 64, and fraction of distance / ((2 - sum) (2 + sum)) in Q26, biased as
  /// that of a double.
  static Ratio ratio(V distance, V sum) {
    const double s = sum;
    const auto bits =
        std::bit_cast<std::int64_t>(distance / ((Rounding::kTwo - s) * (Rounding::kTwo + s)));
    const std::int32_t dropped =
        static_cast<std::int32_t>(bits + Rounding::kDoubt) & Rounding::kDroppedMask;
    return {static_cast<V>(bits >> Rounding::kDropped), dropped < 2 * Rounding::kDoubt ? 1u : 0u};
  }
};

/// Which of four lanes go where to come one after the other, as bytes.
inline constexpr auto kCompressFour = [] {
  std::array<std::array<std::uint8_t, 16>, 16> table{};
  for (unsigned set = 0; set < 16; ++set) {
    unsigned place = 0;
    for (unsigned lane = 0; lane < 4; ++lane) {
      if ((set >> lane & 1u) != 0) {
        for (unsigned byte = 0; byte < 4; ++byte) {
          table[set][4 * place + byte] = static_cast<std::uint8_t>(4 * lane + byte);
        }
        ++place;
      }
    }
  }
  return table;
}();

#if defined(__x86_64__)

/// The same of eight lanes, as lanes.
inline constexpr auto kCompressEight = [] {
  std::array<std::array<std::uint8_t, 8>, 256> table{};
  for (unsigned set = 0; set < 256; ++set) {
    unsigned place = 0;
    for (unsigned lane = 0; lane < 8; ++lane) {
      if ((set >> lane & 1u) != 0) {
        table[set][place++] = static_cast<std::uint8_t>(lane);
      }
    }
  }
  return table;
}();

#define LIFEMODEL_SSE4 [[gnu::target("sse4.1"), gnu::always_inline]] static inline

struct Sse4Lanes {
  static constexpr unsigned kCount = 4;
  using V = __m128i;
  struct Ratio {
    V log2;
    unsigned doubtful;
  };
  struct Coefficients {
    V c0, c1, c2, c3;
  };

  LIFEMODEL_SSE4 V load(const std::int32_t* from) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
  }
  LIFEMODEL_SSE4 void store(std::int32_t* to, V v) {
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), v);
  }
  LIFEMODEL_SSE4 V all(std::int32_t value) { return _mm_set1_epi32(value); }
  LIFEMODEL_SSE4 V add(V a, V b) { return _mm_add_epi32(a, b); }
  LIFEMODEL_SSE4 V sub(V a, V b) { return _mm_sub_epi32(a, b); }
  LIFEMODEL_SSE4 V both(V a, V b) { return _mm_and_si128(a, b); }
  LIFEMODEL_SSE4 V least(V a, V b) { return _mm_min_epi32(a, b); }
  LIFEMODEL_SSE4 V most(V a, V b) { return _mm_max_epi32(a, b); }
  LIFEMODEL_SSE4 V distance(V a, V b) { return _mm_abs_epi32(_mm_sub_epi32(a, b)); }
  template <int kBits>
  LIFEMODEL_SSE4 V left(V v) {
    return _mm_slli_epi32(v, kBits);
  }
  template <int kBits>
  LIFEMODEL_SSE4 V right(V v) {
    return _mm_srai_epi32(v, kBits);
  }
  template <int kBits>
  LIFEMODEL_SSE4 V right_unsigned(V v) {
    return _mm_srli_epi32(v, kBits);
  }
  LIFEMODEL_SSE4 V multiply_high(V a, V b) {
    const V even = _mm_srli_epi64(_mm_mul_epi32(a, b), 32);
    const V odd = _mm_mul_epi32(_mm_srli_epi64(a, 32), _mm_srli_epi64(b, 32));
    return _mm_blend_epi16(even, odd, 0xcc);
  }
  LIFEMODEL_SSE4 unsigned less(V a, V b) {
    return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(_mm_cmpgt_epi32(b, a))));
  }
  LIFEMODEL_SSE4 void compress(std::int32_t* to, V v, unsigned set) {
    const V places = _mm_loadu_si128(reinterpret_cast<const __m128i*>(kCompressFour[set].data()));
    store(to, _mm_shuffle_epi8(v, places));
  }
  LIFEMODEL_SSE4 Coefficients coefficients(const Segments& of, V segment) {
    const V r0 = row(of, _mm_extract_epi32(segment, 0));
    const V r1 = row(of, _mm_extract_epi32(segment, 1));
    const V r2 = row(of, _mm_extract_epi32(segment, 2));
    const V r3 = row(of, _mm_extract_epi32(segment, 3));
    const V low01 = _mm_unpacklo_epi32(r0, r1);
    const V low23 = _mm_unpacklo_epi32(r2, r3);
    const V high01 = _mm_unpackhi_epi32(r0, r1);
    const V high23 = _mm_unpackhi_epi32(r2, r3);
    return {_mm_unpacklo_epi64(low01, low23), _mm_unpackhi_epi64(low01, low23),
            _mm_unpacklo_epi64(high01, high23), _mm_unpackhi_epi64(high01, high23)};
  }
  LIFEMODEL_SSE4 Ratio ratio(V distance, V sum) {
    const V first = quotients(distance, sum);
    const V second =
        quotients(_mm_unpackhi_epi64(distance, distance), _mm_unpackhi_epi64(sum, sum));
    const V dropped = _mm_and_si128(_mm_add_epi32(low_words(first, second), all(Rounding::kDoubt)),
                                    all(Rounding::kDroppedMask));
    return {low_words(_mm_srli_epi64(first, Rounding::kDropped),
                      _mm_srli_epi64(second, Rounding::kDropped)),
            less(dropped, all(2 * Rounding::kDoubt))};
  }

 private:
  LIFEMODEL_SSE4 V row(const Segments& of, std::int32_t segment) {
    return _mm_loadu_si128(
        reinterpret_cast<const __m128i*>(&of.rows[static_cast<std::size_t>(segment)]));
  }
  LIFEMODEL_SSE4 V quotients(V distance, V sum) {
    const __m128d s = _mm_cvtepi32_pd(sum);
    const __m128d two = _mm_set1_pd(Rounding::kTwo);
    return _mm_castpd_si128(
        _mm_div_pd(_mm_cvtepi32_pd(distance), _mm_mul_pd(_mm_sub_pd(two, s), _mm_add_pd(two, s))));
  }
  LIFEMODEL_SSE4 V low_words(V a, V b) {
    return _mm_castps_si128(_mm_shuffle_ps(_mm_castsi128_ps(a), _mm_castsi128_ps(b), 0x88));
  }
};

#undef LIFEMODEL_SSE4
#define LIFEMODEL_AVX2 [[gnu::target("avx2"), gnu::always_inline]] static inline

struct Avx2Lanes {
  static constexpr unsigned kCount = 8;
  using V = __m256i;
  struct Ratio {
    V log2;
    unsigned doubtful;
  };
  struct Coefficients {
    V c0, c1, c2, c3;
  };

  LIFEMODEL_AVX2 V load(const std::int32_t* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  }
  LIFEMODEL_AVX2 void store(std::int32_t* to, V v) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), v);
  }
  LIFEMODEL_AVX2 V all(std::int32_t value) { return _mm256_set1_epi32(value); }
  LIFEMODEL_AVX2 V add(V a, V b) { return _mm256_add_epi32(a, b); }
  LIFEMODEL_AVX2 V sub(V a, V b) { return _mm256_sub_epi32(a, b); }
  LIFEMODEL_AVX2 V both(V a, V b) { return _mm256_and_si256(a, b); }
  LIFEMODEL_AVX2 V least(V a, V b) { return _mm256_min_epi32(a, b); }
  LIFEMODEL_AVX2 V most(V a, V b) { return _mm256_max_epi32(a, b); }
  LIFEMODEL_AVX2 V distance(V a, V b) { return _mm256_abs_epi32(_mm256_sub_epi32(a, b)); }
  template <int kBits>
  LIFEMODEL_AVX2 V left(V v) {
    return _mm256_slli_epi32(v, kBits);
  }
  template <int kBits>
  LIFEMODEL_AVX2 V right(V v) {
    return _mm256_srai_epi32(v, kBits);
  }
  template <int kBits>
  LIFEMODEL_AVX2 V right_unsigned(V v) {
    return _mm256_srli_epi32(v, kBits);
  }
  LIFEMODEL_AVX2 V multiply_high(V a, V b) {
    const V even = _mm256_srli_epi64(_mm256_mul_epi32(a, b), 32);
    const V odd = _mm256_mul_epi32(_mm256_srli_epi64(a, 32), _mm256_srli_epi64(b, 32));
    return _mm256_blend_epi32(even, odd, 0xaa);
  }
  LIFEMODEL_AVX2 unsigned less(V a, V b) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpgt_epi32(b, a))));
  }
  LIFEMODEL_AVX2 void compress(std::int32_t* to, V v, unsigned set) {
    const __m128i places =
        _mm_loadl_epi64(reinterpret_cast<const __m128i*>(kCompressEight[set].data()));
    store(to, _mm256_permutevar8x32_epi32(v, _mm256_cvtepu8_epi32(places)));
  }
  LIFEMODEL_AVX2 Coefficients coefficients(const Segments& of, V segment) {
    return {column(of.columns[0], segment), column(of.columns[1], segment),
            column(of.columns[2], segment), column(of.columns[3], segment)};
  }
  LIFEMODEL_AVX2 Ratio ratio(V distance, V sum) {
    const V first = quotients(_mm256_castsi256_si128(distance), _mm256_castsi256_si128(sum));
    const V second =
        quotients(_mm256_extracti128_si256(distance, 1), _mm256_extracti128_si256(sum, 1));
    const V dropped =
        _mm256_and_si256(_mm256_add_epi32(low_words(first, second), all(Rounding::kDoubt)),
                         all(Rounding::kDroppedMask));
    return {low_words(_mm256_srli_epi64(first, Rounding::kDropped),
                      _mm256_srli_epi64(second, Rounding::kDropped)),
            less(dropped, all(2 * Rounding::kDoubt))};
  }

 private:
  LIFEMODEL_AVX2 V column(const std::array<std::int32_t, 16>& of, V segment) {
    const V low = _mm256_permutevar8x32_epi32(load(of.data()), segment);
    const V high = _mm256_permutevar8x32_epi32(load(of.data() + 8), segment);
    return _mm256_castps_si256(_mm256_blendv_ps(_mm256_castsi256_ps(low), _mm256_castsi256_ps(high),
                                                _mm256_castsi256_ps(left<28>(segment))));
  }
  LIFEMODEL_AVX2 V quotients(__m128i distance, __m128i sum) {
    const __m256d s = _mm256_cvtepi32_pd(sum);
    const __m256d two = _mm256_set1_pd(Rounding::kTwo);
    return _mm256_castpd_si256(_mm256_div_pd(
        _mm256_cvtepi32_pd(distance), _mm256_mul_pd(_mm256_sub_pd(two, s), _mm256_add_pd(two, s))));
  }
  LIFEMODEL_AVX2 V low_words(V a, V b) {
    const __m256 words = _mm256_shuffle_ps(_mm256_castsi256_ps(a), _mm256_castsi256_ps(b), 0x88);
    return _mm256_permute4x64_epi64(_mm256_castps_si256(words), 0xd8);
  }
};

#undef LIFEMODEL_AVX2

#elif defined(__aarch64__)

struct NeonLanes {
  static constexpr unsigned kCount = 4;
  using V = int32x4_t;
  struct Ratio {
    V log2;
    unsigned doubtful;
  };
  struct Coefficients {
    V c0, c1, c2, c3;
  };

  static V load(const std::int32_t* from) { return vld1q_s32(from); }
  static void store(std::int32_t* to, V v) { vst1q_s32(to, v); }
  static V all(std::int32_t value) { return vdupq_n_s32(value); }
  static V add(V a, V b) { return vaddq_s32(a, b); }
  static V sub(V a, V b) { return vsubq_s32(a, b); }
  static V both(V a, V b) { return vandq_s32(a, b); }
  static V least(V a, V b) { return vminq_s32(a, b); }
  static V most(V a, V b) { return vmaxq_s32(a, b); }
  static V distance(V a, V b) { return vabdq_s32(a, b); }
  template <int kBits>
  static V left(V v) {
    return vshlq_n_s32(v, kBits);
  }
  template <int kBits>
  static V right(V v) {
    return vshrq_n_s32(v, kBits);
  }
  template <int kBits>
  static V right_unsigned(V v) {
    return vreinterpretq_s32_u32(vshrq_n_u32(vreinterpretq_u32_s32(v), kBits));
  }
  static V multiply_high(V a, V b) {
    return vuzp2q_s32(vreinterpretq_s32_s64(vmull_s32(vget_low_s32(a), vget_low_s32(b))),
                      vreinterpretq_s32_s64(vmull_high_s32(a, b)));
  }
  static unsigned less(V a, V b) {
    constexpr std::array<std::uint32_t, 4> kBits{1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(vcltq_s32(a, b), vld1q_u32(kBits.data())));
  }
  static void compress(std::int32_t* to, V v, unsigned set) {
    const uint8x16_t places = vld1q_u8(kCompressFour[set].data());
    store(to, vreinterpretq_s32_u8(vqtbl1q_u8(vreinterpretq_u8_s32(v), places)));
  }
  static Coefficients coefficients(const Segments& of, V segment) {
    const V r0 = row(of, vgetq_lane_s32(segment, 0));
    const V r1 = row(of, vgetq_lane_s32(segment, 1));
    const V r2 = row(of, vgetq_lane_s32(segment, 2));
    const V r3 = row(of, vgetq_lane_s32(segment, 3));
    const int64x2_t even01 = vreinterpretq_s64_s32(vtrn1q_s32(r0, r1));
    const int64x2_t odd01 = vreinterpretq_s64_s32(vtrn2q_s32(r0, r1));
    const int64x2_t even23 = vreinterpretq_s64_s32(vtrn1q_s32(r2, r3));
    const int64x2_t odd23 = vreinterpretq_s64_s32(vtrn2q_s32(r2, r3));
    return {vreinterpretq_s32_s64(vtrn1q_s64(even01, even23)),
            vreinterpretq_s32_s64(vtrn1q_s64(odd01, odd23)),
            vreinterpretq_s32_s64(vtrn2q_s64(even01, even23)),
            vreinterpretq_s32_s64(vtrn2q_s64(odd01, odd23))};
  }
  static Ratio ratio(V distance, V sum) {
    const int64x2_t first = quotients(vget_low_s32(distance), vget_low_s32(sum));
    const int64x2_t second = quotients(vget_high_s32(distance), vget_high_s32(sum));
    const V dropped = vandq_s32(vaddq_s32(low_words(first, second), all(Rounding::kDoubt)),
                                all(Rounding::kDroppedMask));
    return {
        low_words(vshrq_n_s64(first, Rounding::kDropped), vshrq_n_s64(second, Rounding::kDropped)),
        less(dropped, all(2 * Rounding::kDoubt))};
  }

 private:
  static V row(const Segments& of, std::int32_t segment) {
    const numeric::Segment& s = of.rows[static_cast<std::size_t>(segment)];
    return vld1q_s32(reinterpret_cast<const std::int32_t*>(&s));
  }
  static int64x2_t quotients(int32x2_t distance, int32x2_t sum) {
    const float64x2_t s = vcvtq_f64_s64(vmovl_s32(sum));
    const float64x2_t two = vdupq_n_f64(Rounding::kTwo);
    return vreinterpretq_s64_f64(vdivq_f64(vcvtq_f64_s64(vmovl_s32(distance)),
                                           vmulq_f64(vsubq_f64(two, s), vaddq_f64(two, s))));
  }
  static V low_words(int64x2_t a, int64x2_t b) {
    return vuzp1q_s32(vreinterpretq_s32_s64(a), vreinterpretq_s32_s64(b));
  }
};

#endif

}  // namespace lifemodel::bulk
