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
  const classes = matrix.count.map((count, index) => [
    Math.floor(index / matrix.means) * range_step_N,
    mean_min_N + (index % matrix.means) * mean_step_N, count, matrix.damage[index]]);
  addSave(holder, {
    title: 'Rainflow range-mean matrix',
    drawing: () => drawingOf(map.svg),
    names: [],
    rows: () => [['range_from_N', 'mean_from_N', 'cycles', 'damage'],
      ...classes.filter(([, , count]) => count > 0)],
  });
  return () => map.svg.querySelectorAll('.cell').length > 0;
}
