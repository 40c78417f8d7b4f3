'use strict';

function heatMap(holder, data) {
  const { range_step_N, mean_min_N, mean_step_N, ...matrix } = data.range_mean;
  const map = new HeatMap(holder, {
    ...matrix,
    range_step: range_step_N,
    mean_min: mean_min_N,
    mean_step: mean_step_N,
    unit: 'N',
  });
  return () => map.svg.querySelectorAll('.cell').length > 0;
}
