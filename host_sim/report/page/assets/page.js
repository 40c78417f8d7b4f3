'use strict';

/**
 * Draws every plot that the page has a place for: with the function of `draw` that has its name, or
 * else from its layers in the data. Then says on the root element how many were drawn (data-charts)
 * and whether that is all of them (data-ready).
 */
function drawPage(draw) {
  const data = JSON.parse(document.getElementById('page-data').textContent);
  const holders = [...document.querySelectorAll('[data-chart]')];
  const checks = holders.map((holder) => {
    const name = holder.dataset.chart;
    return name in draw ? draw[name](holder, data) : layeredPlot(holder, data.charts[name]);
  });
  setTimeout(() => {
    const drawn = checks.filter((isDrawn) => isDrawn()).length;
    document.documentElement.dataset.charts = drawn;
    document.documentElement.dataset.ready = drawn === holders.length;
  });
}
