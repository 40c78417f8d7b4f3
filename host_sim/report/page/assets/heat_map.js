'use strict';

const HEAT_MARGIN = { top: 8, right: 16, bottom: 44, left: 62 };
const LEGEND_HEIGHT = 46;

/** How values become colours: by logarithm where they span two decades or more. */
function colourScale(values) {
  const shown = values.filter((value) => value > 0);
  const low = shown.reduce((a, b) => Math.min(a, b), Infinity);
  const high = shown.reduce((a, b) => Math.max(a, b), 0);
  const logarithmic = high / low >= 100;
  const position = (value) => {
    if (!logarithmic) {
      return value / high;
    }
    return Math.log(value / low) / Math.log(high / low);
  };
  return { low: logarithmic ? low : 0, high, logarithmic, position, any: shown.length > 0 };
}

/**
 * A rainflow matrix as a picture with a reading line, and a switch between cycles and damage where
 * the holder has one. The matrix has ranges x means classes, range by range: `count`, and `damage`
 * or nothing; the classes are range_step and mean_step wide, in `unit`, from 0 and mean_min on.
 */
class HeatMap {
  constructor(holder, matrix) {
    this.matrix = matrix;
    this.holder = holder;
    this.svg = holder.querySelector('svg');
    this.readout = holder.querySelector('.readout');
    this.quantity = 'count';
    this.picked = null;
    this.scaled = axisScale(
      Math.max(
        matrix.ranges * matrix.range_step,
        Math.abs(matrix.mean_min),
        Math.abs(matrix.mean_min + matrix.means * matrix.mean_step),
      ),
    );
    for (const input of holder.querySelectorAll('input')) {
      input.addEventListener('change', () => {
        this.quantity = input.value;
        this.draw(this.width);
      });
    }
    this.svg.addEventListener('pointermove', (event) => this.pickAt(event));
    this.svg.addEventListener('keydown', (event) => this.pickByKey(event));
    this.draw(holder.clientWidth);
    keepDrawn(holder, (width) => this.draw(width));
  }

  add(name, attributes, text) {
    const element = document.createElementNS(this.svg.namespaceURI, name);
    for (const [key, value] of Object.entries(attributes)) {
      element.setAttribute(key, value);
    }
    if (text !== undefined) {
      element.textContent = text;
    }
    this.svg.append(element);
    return element;
  }

  draw(width) {
    this.width = width;
    const plotHeight = Math.round(Math.min(Math.max(width * 0.4, 220), 380));
    const height = plotHeight + HEAT_MARGIN.top + HEAT_MARGIN.bottom + LEGEND_HEIGHT;
    this.plot = {
      left: HEAT_MARGIN.left,
      top: HEAT_MARGIN.top,
      width: width - HEAT_MARGIN.left - HEAT_MARGIN.right,
      height: plotHeight,
    };
    // Empty room, in classes, so that those at the rim do not lie on the frame.
    const margin = (classes) => Math.max(0.5, 0.04 * classes);
    this.meanMargin = margin(this.matrix.means);
    this.columns = this.matrix.means + 2 * this.meanMargin;
    this.rows = this.matrix.ranges + margin(this.matrix.ranges);
    this.svg.replaceChildren();
    this.svg.setAttribute('width', width);
    this.svg.setAttribute('height', height);
    this.svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
    this.stops = ['heat-low', 'heat-mid', 'heat-high'].map(colour);
    this.scale = colourScale(this.matrix[this.quantity]);
    this.drawCells();
    this.drawAxes();
    this.drawLegend(height - LEGEND_HEIGHT + 8);
    this.drawPicked();
  }

  cellBox(range, mean) {
    const { plot } = this;
    const width = plot.width / this.columns;
    const height = plot.height / this.rows;
    return {
      x: plot.left + (mean + this.meanMargin) * width,
      y: plot.top + plot.height - (range + 1) * height,
      width,
      height,
    };
  }

  drawCells() {
    const { plot, matrix, scale, stops } = this;
    matrix[this.quantity].forEach((value, index) => {
      if (value > 0) {
        const box = this.cellBox(Math.floor(index / matrix.means), index % matrix.means);
        this.add('rect', { ...box, class: 'cell', fill: between(stops, scale.position(value)) });
      }
    });
    const { left: x, top: y, width, height } = plot;
    this.add('rect', { x, y, width, height, class: 'frame' });
  }

  drawAxes() {
    const { plot, matrix, scaled } = this;
    const meanStep = matrix.mean_step / scaled.divisor;
    const low = matrix.mean_min / scaled.divisor - this.meanMargin * meanStep;
    const high = low + this.columns * meanStep;
    const top = (this.rows * matrix.range_step) / scaled.divisor;
    const bottom = plot.top + plot.height;
    for (const tick of roundTicks(low, high, Math.min(8, plot.width / 60))) {
      const x = plot.left + ((tick - low) / (high - low)) * plot.width;
      this.add('path', { d: `M${x} ${bottom}v5`, class: 'axis' });
      this.add('text', { x, y: bottom + 18, 'text-anchor': 'middle' }, numberText(tick, 6));
    }
    for (const tick of roundTicks(0, top, 6)) {
      const y = bottom - (tick / top) * plot.height;
      this.add('path', { d: `M${plot.left} ${y}h-5`, class: 'axis' });
      const at = { x: plot.left - 9, y: y + 4, 'text-anchor': 'end' };
      this.add('text', at, numberText(tick, 6));
    }
    const centre = plot.left + plot.width / 2;
    const xTitle = `Mean of the cycle, ${matrix.unit}${scaled.suffix}`;
    this.add('text', { x: centre, y: bottom + 37, 'text-anchor': 'middle' }, xTitle);
    const middle = plot.top + plot.height / 2;
    const turned = { 'text-anchor': 'middle', transform: `translate(13 ${middle}) rotate(-90)` };
    this.add('text', turned, `Range of the cycle, ${matrix.unit}${scaled.suffix}`);
  }

  drawLegend(top) {
    const { plot, scale, stops } = this;
    const names = { count: 'Cycles in a class', damage: 'Damage in a class' };
    if (!scale.any) {
      this.add('text', { x: plot.left, y: top + 12 }, `${names[this.quantity]}: none above 0`);
      return;
    }
    const width = Math.min(260, plot.width);
    const steps = 40;
    for (let step = 0; step < steps; step += 1) {
      this.add('rect', {
        x: plot.left + (step * width) / steps,
        y: top,
        width: width / steps + 0.5,
        height: 10,
        fill: between(stops, step / (steps - 1)),
      });
    }
    const note = scale.logarithmic ? ' (logarithmic)' : '';
    const y = top + 25;
    this.add('text', { x: plot.left, y }, numberText(scale.low, 2));
    const end = { x: plot.left + width, y, 'text-anchor': 'end' };
    this.add('text', end, numberText(scale.high));
    const title = { x: plot.left + width / 2, y, 'text-anchor': 'middle' };
    this.add('text', title, names[this.quantity] + note);
  }

  drawPicked() {
    if (this.picked) {
      const box = this.cellBox(this.picked.range, this.picked.mean);
      this.outline = this.add('rect', { ...box, class: 'picked' });
    }
  }

  pick(range, mean) {
    const { matrix } = this;
    this.picked = {
      range: Math.min(Math.max(range, 0), matrix.ranges - 1),
      mean: Math.min(Math.max(mean, 0), matrix.means - 1),
    };
    this.outline?.remove();
    this.drawPicked();
    this.read();
  }

  read() {
    const { matrix } = this;
    const index = this.picked.range * matrix.means + this.picked.mean;
    const span = (start, step) => `${numberText(start, 4)} to ${numberText(start + step, 4)}`;
    const ranges = span(this.picked.range * matrix.range_step, matrix.range_step);
    const meanStart = matrix.mean_min + this.picked.mean * matrix.mean_step;
    const means = span(meanStart, matrix.mean_step);
    const damage = matrix.damage ? `, damage ${numberText(matrix.damage[index])}` : '';
    this.readout.textContent = `Range ${ranges} ${matrix.unit}, mean ${means} ${matrix.unit}: `
      + `${numberText(matrix.count[index])} cycles${damage}`;
  }

  /** Another matrix of the same classes. */
  show(matrix) {
    this.matrix = matrix;
    this.draw(this.width);
    if (this.picked) {
      this.read();
    }
  }

  pickAt(event) {
    const { plot } = this;
    const corner = this.svg.getBoundingClientRect();
    const across = (event.clientX - corner.left - plot.left) / plot.width;
    const up = 1 - (event.clientY - corner.top - plot.top) / plot.height;
    if (across >= 0 && across < 1 && up >= 0 && up < 1) {
      this.pick(Math.floor(up * this.rows), Math.floor(across * this.columns - this.meanMargin));
    }
  }

  pickByKey(event) {
    const steps = { ArrowUp: [1, 0], ArrowDown: [-1, 0], ArrowRight: [0, 1], ArrowLeft: [0, -1] };
    const step = steps[event.key];
    if (step && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      const { range, mean } = this.picked || { range: 0, mean: 0 };
      this.pick(range + step[0], mean + step[1]);
    }
  }
}
