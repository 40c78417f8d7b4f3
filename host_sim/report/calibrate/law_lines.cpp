#include "host_sim/report/calibrate/law_lines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/report/page/number_text.hpp"

namespace host_sim::calibrate_page {
namespace {

void widen(TensionRange& range, double tension_N) {
  range = {std::min(range.low_N, tension_N), std::max(range.high_N, tension_N)};
}

}  // namespace

TensionRange tested_tensions_N(const calibrate::CalibrateResult& result) {
  TensionRange range{std::numeric_limits<double>::infinity(), 0};
  for (const calibrate::LevelResult& level : result.levels) {
    widen(range, level.load.effective_tension_N);
  }
  if (result.stress_life) {
    for (const double tension_N : result.stress_life->band_tension_N) {
      widen(range, tension_N);
    }
  }
  return range;
}

TensionRange all_tensions_N(const calibrate::CalibrateResult& result) {
  TensionRange range = tested_tensions_N(result);
  for (const calibrate::UseLevel& use : result.use_levels) {
    widen(range, use.effective_tension_N);
  }
  return range;
}

Layer law_line(TensionRange range, const std::function<double(double tension_N)>& life_cycles) {
  constexpr std::size_t kPoints = 121;
  constexpr double kBeyond = 1.04;
  Layer layer;
  if (range.low_N > range.high_N) {
    return layer;
  }
  const double first = range.low_N / kBeyond;
  const double ratio = range.high_N * kBeyond / first;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kPoints - 1);
    const double tension_N = first * std::pow(ratio, share);
    layer.x.push_back(tension_N);
    layer.y.push_back(life_cycles(tension_N));
  }
  return layer;
}

std::string angle_text(double angle_deg) {
  return number_text(angle_deg, 4) + "\u00b0";
}

}  // namespace host_sim::calibrate_page
