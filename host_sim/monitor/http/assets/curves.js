import { byId, make, setAttribute } from './dom.js';
import { clockText, isCalendar, momentText, zoneText } from './prose.js';

const REDRAW_MS = 1000;

/** Strokes at epochs, and at the moment that is shown while the page is paused. */
function drawMarks(marks) {
  return (chart) => {
    const { ctx, bbox } = chart;
    for (const { time_s, ink, dashed } of marks()) {
      const x = chart.valToPos(time_s, 'x', true);
      if (x < bbox.left || x > bbox.left + bbox.width) {
        continue;
      }
      ctx.save();
      ctx.strokeStyle = colour(ink);
      ctx.lineWidth = 2 * uPlot.pxRatio;
      ctx.setLineDash(dashed ? [5 * uPlot.pxRatio, 4 * uPlot.pxRatio] : []);
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      ctx.restore();
    }
  };
}

function xAxis(times_s) {
  const calendar = isCalendar((times_s[0] || 0) * 1e6);
  return {
    xAxis: calendar ? `Time of day, ${zoneText(times_s[0] * 1e6)}` : 'Time, s',
    x: { time: calendar },
    xTicks: {
      space: calendar ? 80 : 60,
      values: (chart, ticks) =>
        ticks.map((tick) => (calendar ? clockText(tick * 1e6, 0) : numberText(tick, 6))),
    },
  };
}

const RANGES = {
  linear: (chart, low, high) => [0, (high || 1e-6) * 1.08],
  log: (chart, low, high) => uPlot.rangeLog(low || 1e-7, high || 1, 10, true),
};

const MOST_DAMAGE_PERCENT = 429.4967295; // it stops there

function damageText(chart, value) {
  return `${value >= MOST_DAMAGE_PERCENT ? '≥\u00a0' : ''}${valueText(chart, value)}`;
}

function isZoomed({ data: [times_s], scales: { x } }) {
  return times_s.length > 1 && (x.min > times_s[0] || x.max < times_s.at(-1));
}

/** New data, under the view that somebody has zoomed to; not while it is being chosen. */
function renew(chart, data) {
  if (chart.select.width > 0) {
    return;
  }
  const { min, max } = chart.scales.x;
  const zoomed = isZoomed(chart);
  chart.setData(data, !zoomed);
  if (zoomed) {
    chart.setScale('x', { min, max });
  }
}

function spanText(from_s, to_s) {
  return `${clockText(from_s * 1e6)} and ${clockText(to_s * 1e6)}`;
}

/** The damage of a node and its rate over time, on a linear or logarithmic axis. */
export class Curves {
  constructor() {
    this.drawn_ms = -Infinity;
    this.marks = [];
  }

  makeChart(id, label, axes, data, value) {
    const holder = make('div', {
      class: 'chart',
      tabindex: 0,
      role: 'group',
      'aria-label': `${label}, over time`,
      'aria-describedby': 'charts-hint',
      'data-summary': `${label}, over time`,
    });
    byId(id).replaceChildren(holder);
    return makeLineChart(holder, {
      data,
      series: [
        { label: 'Time', value: (chart, at) => (at === null ? '–' : momentText(at * 1e6)) },
        { label, ink: 'line', width: 2, value, points: { show: false } },
      ],
      yAxis: label,
      y: { distr: axes === 'log' ? 3 : 1, log: 10, range: RANGES[axes] },
      onDraw: drawMarks(() => this.marks),
      ...xAxis(data[0]),
    });
  }

  dataOf(history, axes) {
    const points = history.curve;
    const shown = (value) =>
      value === undefined || (axes === 'log' && value <= 0) ? null : 100 * value;
    const times = points.map(([time_us]) => time_us / 1e6);
    return {
      damage: [times, points.map(([, damage]) => shown(damage))],
      rate: [times, points.map(([, , rate]) => shown(rate))],
    };
  }

  clear() {
    this.damage?.destroy();
    this.rate?.destroy();
    byId('damage-chart').replaceChildren();
    byId('rate-chart').replaceChildren();
    Object.assign(this, { damage: undefined, rate: undefined, key: undefined, built: undefined });
  }

  describe(chart, [times, values]) {
    const known = values.filter((value) => value !== null && value !== undefined);
    const summary =
      known.length === 0
        ? 'nothing known yet'
        : `from ${numberText(known[0], 4)} to ${numberText(known.at(-1), 4)} between `
          + spanText(times[0], times.at(-1));
    const { min, max } = chart.scales.x;
    const zoomed = isZoomed(chart) ? `; zoomed to between ${spanText(min, max)}` : '';
    const label = `${chart.series[1].label}, over time: ${summary}${zoomed}`;
    setAttribute(chart.ctx.canvas, 'aria-label', label);
  }

  /** Draws anew at most once a second, but at once where the selection changes. */
  show({ history, selection, view }) {
    const key = [history.node, selection.axes, selection.at].join();
    const now_ms = performance.now();
    if (key === this.key && now_ms - this.drawn_ms < REDRAW_MS) {
      return;
    }
    const { damage, rate } = this.dataOf(history, selection.axes);
    const calendar = isCalendar((damage[0][0] || 0) * 1e6);
    const rebuilt = [history.node, selection.axes, calendar].join();
    this.marks = history.events
      .filter(({ kind }) => kind === 'epoch')
      .map(({ time_us }) => ({ time_s: time_us / 1e6, ink: 'level-3', dashed: true }));
    if (selection.at !== undefined) {
      this.marks.push({ time_s: view.now_us / 1e6, ink: 'mark' });
    }
    if (this.built !== rebuilt) {
      this.clear();
      this.damage = this.makeChart('damage-chart', 'Damage, %', selection.axes, damage, damageText);
      this.rate = this.makeChart('rate-chart', 'Damage rate, % per h', 'linear', rate, valueText);
    } else {
      renew(this.damage, damage);
      renew(this.rate, rate);
    }
    this.describe(this.damage, damage);
    this.describe(this.rate, rate);
    Object.assign(this, { key, built: rebuilt, drawn_ms: now_ms });
  }
}
