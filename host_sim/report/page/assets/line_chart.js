'use strict';

const CHART_FONT = '12px system-ui, sans-serif';

function chartHeight(width) {
  return Math.round(Math.min(Math.max(width * 0.38, 240), 360));
}

function axis(label, extra) {
  return {
    label,
    labelFont: CHART_FONT,
    font: CHART_FONT,
    labelSize: 22,
    stroke: () => colour('ink-soft'),
    grid: { stroke: () => colour('grid'), width: 1 },
    ticks: { stroke: () => colour('rule'), width: 1, size: 5 },
    values: (chart, splits) => splits.map((split) => numberText(split, 6)),
    ...extra,
  };
}

function valueText(chart, value) {
  return value === null || value === undefined ? '–' : numberText(value, 4);
}

/** Cursor and zoom by keyboard: arrows move, + and - zoom about the cursor, 0 shows all. */
function addKeys(holder, chart) {
  const xs = chart.data[0];
  const move = (fraction) => {
    const width = chart.over.clientWidth;
    const start = chart.cursor.left >= 0 ? chart.cursor.left : 0;
    const left = Math.min(Math.max(start + fraction * width, 0), width);
    chart.setCursor({ left, top: chart.over.clientHeight / 2 });
  };
  const zoom = (factor) => {
    if (xs.length < 2) {
      return;
    }
    const { min, max } = chart.scales.x;
    const centre = chart.cursor.left >= 0 ? chart.posToVal(chart.cursor.left, 'x') : (min + max) / 2;
    chart.setScale('x', {
      min: Math.max(xs[0], centre - (centre - min) * factor),
      max: Math.min(xs[xs.length - 1], centre + (max - centre) * factor),
    });
  };
  const actions = {
    ArrowLeft: () => move(-0.01),
    ArrowRight: () => move(0.01),
    Home: () => move(-1),
    End: () => move(1),
    '+': () => zoom(0.5),
    '-': () => zoom(2),
    0: () => chart.setData(chart.data),
  };
  holder.addEventListener('keydown', (event) => {
    const action = actions[event.key];
    if (action && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      action();
    }
  });
}

/** Series draw with the colours of their `ink` and `wash` on the canvas. */
function inked(series) {
  return series.map(({ ink, wash, ...rest }) => ({
    ...rest,
    ...(ink && { stroke: () => colour(ink) }),
    ...(wash && { fill: () => colour(wash) }),
  }));
}

/** Signs of a legend that take their colours from the style sheet, so that they follow it. */
function legendMarkers(series) {
  const from = (name) => (name ? `var(--${name})` : 'transparent');
  return {
    width: 2,
    stroke: (chart, index) => from(series[index].ink),
    fill: (chart, index) => from(series[index].wash),
  };
}

/**
 * Draws a line chart into its holder. `x` and `y` add to the scales, `xTicks` to the axis of x.
 */
function makeLineChart(holder, {
  data, series, bands, xAxis, yAxis, yRange, onDraw, onSeries, x, y, xTicks,
}) {
  const width = holder.clientWidth;
  const chart = new uPlot(
    {
      width,
      height: chartHeight(width),
      pxAlign: false,
      series: inked(series),
      bands,
      scales: {
        x: { time: false, ...x },
        y: { ...(yRange && { range: yRange }), ...y },
      },
      axes: [axis(xAxis, { size: 34, ...xTicks }), axis(yAxis, { size: 58 })],
      padding: [12, 14, 0, 0],
      cursor: { y: false, hover: { skip: [null, undefined] } },
      legend: { show: true, markers: legendMarkers(series) },
      hooks: {
        drawSeries: onSeries ? [onSeries] : [],
        draw: onDraw ? [onDraw] : [],
      },
    },
    data,
    holder,
  );
  const canvas = holder.querySelector('canvas');
  canvas.setAttribute('role', 'img');
  canvas.setAttribute('aria-label', holder.dataset.summary);
  const legend = holder.querySelector('.u-legend');
  legend.setAttribute('aria-live', 'polite');
  legend.setAttribute('aria-label', 'Values at the cursor');
  addKeys(holder, chart);
  const end = keepDrawn(holder, (newWidth) => {
    chart.setSize({ width: newWidth, height: chartHeight(newWidth) });
    chart.redraw(true, true);
  });
  chart.hooks.destroy = [end];
  return chart;
}

/** Draws a line chart into its holder and returns a function that tells whether it was drawn. */
function lineChart(holder, spec) {
  let drawn = 0;
  const chart = makeLineChart(holder, { ...spec, onSeries: () => { drawn += 1; } });
  addSave(holder, {
    title: holder.getAttribute('aria-label'),
    drawing: () => holder.querySelector('canvas'),
    names: spec.series.slice(1).map(({ label, ink }) => ({ name: label, ink })),
    rows: () => [spec.series.map(({ label }) => label),
      ...spec.data[0].map((ignored, row) => spec.data.map((column) => column[row]))],
  });
  return () => drawn > 0 && chart.bbox.width > 0;
}
