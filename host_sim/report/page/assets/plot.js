'use strict';

/** The places of a layer's values along the axes; what cannot be drawn is not finite. */
function placesOf(layer, kinds) {
  const place = (kind, value) =>
    (value === null || value === undefined ? NaN : kind.place(value));
  return layer.x.map((x, index) => ({
    x: place(kinds.x, x),
    y: place(kinds.y, layer.y[index]),
    high: place(kinds.y, layer.high[index]),
    index,
  }));
}

/** The lowest and highest of finite numbers with some room beside them. */
function roomy(values, room) {
  const finite = values.filter(Number.isFinite);
  const low = finite.reduce((a, b) => Math.min(a, b), Infinity);
  const high = finite.reduce((a, b) => Math.max(a, b), -Infinity);
  if (low > high) {
    return [0, 1];
  }
  const margin = low < high ? room * (high - low) : Math.abs(low) / 10 || 1;
  return [low - margin, high + margin];
}

function fullView(spec, layers) {
  const all = layers.flatMap(({ places }) => places);
  const x = roomy(all.map((at) => at.x), 0.04);
  const y = roomy(all.flatMap((at) => [at.y, at.high]), 0.07);
  if (layers.some(({ kind }) => kind === 'labels')) {
    y[1] += 0.15 * (y[1] - y[0]);
  }
  if (spec.x.kind === 'category') {
    x.splice(0, 2, -0.6, spec.x.categories.length - 0.4);
  }
  const whole = 105;
  if (spec.y.from_zero && spec.y.unit === '%') {
    y[1] = Math.min(y[1], whole);
  }
  return { x: spec.x.from_zero ? [0, x[1]] : x, y: spec.y.from_zero ? [0, y[1]] : y };
}

/** Layers over two axes of any kind, with a legend, a reading line, and zoom. */
class Plot {
  constructor(holder, spec) {
    this.holder = holder;
    this.spec = spec;
    this.kinds = { x: AXIS_KINDS[spec.x.kind], y: AXIS_KINDS[spec.y.kind] };
    this.layers = spec.layers.map((layer) => ({
      ...layer, shown: true, places: placesOf(layer, this.kinds),
    }));
    this.full = fullView(spec, this.layers);
    this.view = { ...this.full };
    this.picked = null;
    this.drawn = 0;
    this.makeChart();
    this.addLegend();
    this.addReadout();
    addSave(holder, {
      title: spec.name,
      drawing: () => holder.querySelector('canvas'),
      names: this.layers.filter(({ name }) => name !== '')
        .map(({ name, colour: ink }) => ({ name, ink })),
      rows: () => this.rows(),
    });
    this.addKeys();
    keepDrawn(holder, (width) => {
      this.chart.setSize({ width, height: this.height(width) });
      this.chart.redraw(true, true);
      this.showPicked();
    });
  }

  height(width) {
    return Math.round(Math.min(Math.max(width * 0.5, 260), 400));
  }

  makeChart() {
    const width = this.holder.clientWidth;
    this.chart = new uPlot({
      width,
      height: this.height(width),
      pxAlign: false,
      series: [{}, { points: { show: false } }],
      scales: {
        x: { time: false, range: () => this.view.x },
        y: { range: () => this.view.y },
      },
      axes: [this.axis('x', { size: this.spec.x.kind === 'category' ? 50 : 34 }),
        this.axis('y', { size: 62 })],
      padding: [12, 14, 0, 0],
      cursor: {
        points: { show: false },
        drag: { x: true, y: true, uni: 20 },
        bind: { dblclick: () => () => this.show(this.full) },
      },
      legend: { show: false },
      hooks: {
        draw: [() => this.draw()],
        setCursor: [(chart) => this.pickNear(chart.cursor)],
        setScale: [(chart, key) => {
          this.view[key] = [chart.scales[key].min, chart.scales[key].max];
        }],
      },
    }, [this.full.x, [null, null]], this.holder);
    const canvas = this.holder.querySelector('canvas');
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', this.holder.dataset.summary);
  }

  axis(side, extra) {
    const kind = this.kinds[side];
    const spec = this.spec[side];
    const letters = Math.max(...spec.categories.flatMap((name) => name.split('\n'))
      .map(({ length }) => length));
    const closest = (chart) => {
      const [length, room] = side === 'x'
        ? [chart.width - 90, spec.kind === 'category' ? Math.max(38, 6.5 * letters) : 52]
        : [chart.height - 80, 26];
      return room / Math.max(length, room);
    };
    return axis(spec.label, {
      splits: (chart, index, low, high) => kind.ticks(low, high, closest(chart)),
      values: (chart, ticks) => ticks.map((tick) => kind.text(tick, spec)),
      filter: (chart, ticks) => ticks,
      ...extra,
    });
  }

  draw() {
    const surface = new Surface(this.chart);
    for (const layer of this.layers.filter(({ shown }) => shown)) {
      surface.within(() => {
        surface.setColours(layer);
        DRAW_LAYER[layer.kind](surface, layer, layer.places);
      });
    }
    this.drawn += 1;
  }

  addLegend() {
    const list = document.createElement('ul');
    list.className = 'key';
    for (const layer of this.layers.filter(({ name }) => name !== '')) {
      const button = document.createElement('button');
      button.type = 'button';
      button.setAttribute('aria-pressed', 'true');
      button.append(legendMark(layer), layer.name);
      button.addEventListener('click', () => {
        layer.shown = !layer.shown;
        button.setAttribute('aria-pressed', String(layer.shown));
        this.chart.redraw(false, false);
      });
      const item = document.createElement('li');
      item.append(button);
      list.append(item);
    }
    this.holder.append(list);
  }

  addReadout() {
    this.ring = document.createElement('div');
    this.ring.className = 'ring';
    this.ring.hidden = true;
    this.chart.over.append(this.ring);
    this.readout = document.createElement('p');
    this.readout.className = 'readout';
    this.readout.setAttribute('aria-live', 'polite');
    this.readout.textContent = this.targets().length > 0
      ? 'Point at a mark to read it; by keyboard, the arrows move from mark to mark.' : '';
    this.holder.append(this.readout);
  }

  /** The marks that can be read and are in view, from left to right. */
  targets() {
    const { x: [left, right], y: [low, high] } = this.view;
    return this.layers
      .filter(({ kind, shown }) => shown && (kind === 'points' || kind === 'bars'))
      .flatMap((layer) => layer.places.map((at) => ({ layer, ...at })))
      .filter(({ x, y }) => x >= left && x <= right && y >= low && y <= high)
      .sort((a, b) => a.x - b.x || a.y - b.y);
  }

  position({ x, y }) {
    return { left: this.chart.valToPos(x, 'x'), top: this.chart.valToPos(y, 'y') };
  }

  pickNear({ left, top }) {
    const reach = 24;
    let nearest = reach;
    let found = null;
    for (const target of left >= 0 ? this.targets() : []) {
      const at = this.position(target);
      const distance = Math.hypot(at.left - left, at.top - top);
      if (distance < nearest) {
        nearest = distance;
        found = target;
      }
    }
    if (found) {
      this.pick(found);
    }
  }

  pick(target) {
    this.picked = target;
    this.showPicked();
    this.readout.textContent = this.reading(target);
  }

  showPicked() {
    if (this.picked) {
      const { left, top } = this.position(this.picked);
      this.ring.hidden = false;
      this.ring.style.transform = `translate(${left}px, ${top}px)`;
    }
  }

  reading({ layer, index }) {
    const value = (side, number) => {
      const spec = this.spec[side];
      if (spec.kind === 'category') {
        return spec.categories[Math.round(number)].replace('\n', ', ');
      }
      const [factor, unit] = spec.kind === 'weibull' ? [100, '%'] : [1, spec.unit];
      return `${numberText(factor * number, 4)} ${unit}`.trim();
    };
    const name = [layer.name, layer.texts[index]].filter(Boolean).join(', ');
    const y = layer.kind === 'bars'
      ? [layer.y[index], layer.high[index]]
        .map((end) => (end === null ? 'no limit' : value('y', end))).join(' to ')
      : value('y', layer.y[index]);
    return `${name}: ${value('x', layer.x[index])}; ${y}`;
  }

  /** Every value of every layer. */
  rows() {
    const { x, y } = this.spec;
    const across = (value) =>
      (x.kind === 'category' && Number.isInteger(value) ? x.categories[value] : value);
    return [['layer', x.label, y.label, `${y.label}, to`, 'text'],
      ...this.layers.flatMap((layer) => layer.x.map((value, index) =>
        [layer.name, across(value), layer.y[index], layer.high[index], layer.texts[index]]))];
  }

  show(view) {
    this.chart.batch(() => {
      for (const side of ['x', 'y']) {
        this.view[side] = view[side];
        this.chart.setScale(side, { min: view[side][0], max: view[side][1] });
      }
    });
    this.showPicked();
  }

  zoom(factor) {
    const zoomed = (side) => {
      const [low, high] = this.view[side];
      const centre = this.picked ? this.picked[side] : (low + high) / 2;
      return [Math.max(this.full[side][0], centre - (centre - low) * factor),
        Math.min(this.full[side][1], centre + (high - centre) * factor)];
    };
    this.show({ x: zoomed('x'), y: zoomed('y') });
  }

  /** Picks the mark that `next` chooses by the number of the present one (-1: none) and the last. */
  step(next) {
    const targets = this.targets();
    const present = this.picked ? targets.findIndex(
      ({ layer, index }) => layer === this.picked.layer && index === this.picked.index) : -1;
    const last = targets.length - 1;
    if (last >= 0) {
      this.pick(targets[Math.min(Math.max(next(present, last), 0), last)]);
    }
  }

  addKeys() {
    const back = () => this.step((present, last) => (present < 0 ? last : present - 1));
    const on = () => this.step((present) => present + 1);
    const actions = {
      ArrowLeft: back,
      ArrowDown: back,
      ArrowRight: on,
      ArrowUp: on,
      Home: () => this.step(() => 0),
      End: () => this.step((present, last) => last),
      '+': () => this.zoom(0.5),
      '-': () => this.zoom(2),
      0: () => this.show(this.full),
    };
    this.holder.addEventListener('keydown', (event) => {
      const action = actions[event.key];
      if (action && !event.ctrlKey && !event.metaKey && !event.altKey) {
        event.preventDefault();
        action();
      }
    });
  }
}

const SVG_NAMESPACE =
  new DOMParser().parseFromString('<svg></svg>', 'text/html').body.firstChild.namespaceURI;

/** The sign of a layer in the legend; it takes its colour from the style sheet. */
function legendMark(layer) {
  const make = (name, attributes) => {
    const element = document.createElementNS(SVG_NAMESPACE, name);
    Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
    return element;
  };
  const svg = make('svg', { viewBox: '-12 -8 24 16', width: 24, height: 16, 'aria-hidden': true });
  const tint = `var(--${layer.colour})`;
  const stroke = { stroke: tint, fill: 'none', 'stroke-width': Math.min(layer.width, 3) };
  const paths = {
    line: () => make('path',
      { ...stroke, d: 'M-11 0H11', 'stroke-dasharray': layer.dashed ? '6 4' : 'none' }),
    area: () => make('path', { fill: tint, 'fill-opacity': 0.25, d: 'M-11 -6H11V6H-11Z' }),
    bars: () => make('path', { ...stroke, d: 'M0 -6V6M-4 -6H4M-4 6H4' }),
    rug: () => make('path', { ...stroke, d: 'M-6 -4V5M-1 -4V5M5 -4V5' }),
    points: () => make('path', {
      d: SHAPES[layer.shape] + (ARROWS[layer.arrow] || ''),
      transform: layer.arrow === 'up' ? 'translate(0 3) scale(3.2)' : 'scale(4)',
      stroke: tint,
      'stroke-width': 0.4,
      fill: layer.filled ? tint : 'none',
    }),
  };
  svg.append(paths[layer.kind]());
  return svg;
}

/** Draws a chart into its holder and returns a function that tells whether it was drawn. */
function layeredPlot(holder, spec) {
  const plot = new Plot(holder, spec);
  return () => plot.drawn > 0 && plot.chart.bbox.width > 0;
}
