#include "host_sim/report/calibrate/charts.hpp"

namespace host_sim::calibrate_page {

std::vector<Chart> charts(const calibrate::CalibrateResult& result) {
  std::vector<Chart> all = {lives_chart(result),
                            density_chart(result),
                            scale_by_tension_chart(result),
                            scale_by_angle_chart(result),
                            stress_life_chart(result, StressLifeAxes::linear),
                            stress_life_chart(result, StressLifeAxes::logarithmic),
                            use_chart(result, StressLifeAxes::linear),
                            use_chart(result, StressLifeAxes::logarithmic),
                            common_shape_chart(result)};
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    all.push_back(probability_chart(result, i));
  }
  std::erase_if(all, [](const Chart& chart) { return chart.layers.empty(); });
  return all;
}

}  // namespace host_sim::calibrate_page
