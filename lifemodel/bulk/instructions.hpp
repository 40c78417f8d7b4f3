#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "lifemodel/bulk/damage_sum.hpp"
#include "lifemodel/bulk/lanes.hpp"
#include "lifemodel/damage/cycle_law.hpp"

namespace lifemodel::bulk {

inline constexpr Segments kLog2{numeric::kLog2Segments};
inline constexpr Segments kExp2{numeric::kExp2Segments};

/// Places beyond the end that may be overwritten.
inline constexpr std::size_t kSpare = 8;

struct Extremes {
  std::int32_t lowest;
  std::int32_t highest;
};

/// Full cycles by their points, with room for kSpare more than there can be.
struct CycleList {
  std::int32_t* from;
  std::int32_t* to;
  std::size_t count;
};

#define LIFEMODEL_TARGET
#define LIFEMODEL_LANES OneLane
namespace one_lane {
#include "lifemodel/bulk/kernels.hpp"
}
#undef LIFEMODEL_LANES
#if defined(__aarch64__)
#define LIFEMODEL_LANES NeonLanes
namespace neon {
#include "lifemodel/bulk/kernels.hpp"
}
#undef LIFEMODEL_LANES
#endif
#undef LIFEMODEL_TARGET

#if defined(__x86_64__)
#define LIFEMODEL_TARGET [[gnu::target("sse4.1,popcnt")]]
#define LIFEMODEL_LANES Sse4Lanes
namespace sse4 {
#include "lifemodel/bulk/kernels.hpp"
}
#undef LIFEMODEL_LANES
#undef LIFEMODEL_TARGET
#define LIFEMODEL_TARGET [[gnu::target("avx2,popcnt,bmi,bmi2")]]
#define LIFEMODEL_LANES Avx2Lanes
namespace avx2 {
#include "lifemodel/bulk/kernels.hpp"
}
#undef LIFEMODEL_LANES
#undef LIFEMODEL_TARGET
#endif

/// What is done with several numbers at once, by one set of instructions. All give the same bits.
struct Instructions {
  const char* name;
  decltype(&one_lane::find_extrema) find_extrema;
  decltype(&one_lane::take_out_ranges) take_out_ranges;
  decltype(&one_lane::add_damages) add_damages;
};

inline constexpr Instructions kOneLane{"one lane", one_lane::find_extrema,
                                       one_lane::take_out_ranges, one_lane::add_damages};
#if defined(__x86_64__)
inline constexpr Instructions kSse4{"SSE4.1", sse4::find_extrema, sse4::take_out_ranges,
                                    sse4::add_damages};
inline constexpr Instructions kAvx2{"AVX2", avx2::find_extrema, avx2::take_out_ranges,
                                    avx2::add_damages};
#elif defined(__aarch64__)
inline constexpr Instructions kNeon{"NEON", neon::find_extrema, neon::take_out_ranges,
                                    neon::add_damages};
#endif

/// Those that this machine has, the fastest first.
inline std::span<const Instructions* const> instructions() {
#if defined(__x86_64__)
  static constexpr std::array kAll{&kAvx2, &kSse4, &kOneLane};
  const bool has_avx2 = __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("bmi") != 0 &&
                        __builtin_cpu_supports("bmi2") != 0;
  const bool has_sse4 =
      __builtin_cpu_supports("sse4.1") != 0 && __builtin_cpu_supports("popcnt") != 0;
  return std::span(kAll).last(has_avx2 ? 3 : has_sse4 ? 2 : 1);
#elif defined(__aarch64__)
  static constexpr std::array kAll{&kNeon, &kOneLane};
  return kAll;
#else
  static constexpr std::array kAll{&kOneLane};
  return kAll;
#endif
}

}  // namespace lifemodel::bulk
