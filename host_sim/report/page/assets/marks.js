'use strict';

/** Outlines of the shapes of points, in a square from -1 to 1. */
const SHAPES = {
  circle: 'M-0.9 0A0.9 0.9 0 1 0 0.9 0A0.9 0.9 0 1 0 -0.9 0Z',
  square: 'M-0.8 -0.8H0.8V0.8H-0.8Z',
  triangle: 'M0 -1L1 0.8H-1Z',
  diamond: 'M0 -1.15L1.05 0L0 1.15L-1.05 0Z',
  star: 'M0 -1.6L0.38 -0.52L1.52 -0.49L0.62 0.2L0.94 1.29L0 0.65L-0.94 1.29L-0.62 0.2L-1.52 -0.49'
    + 'L-0.38 -0.52Z',
  cross: 'M-0.8 -0.8L0.8 0.8M0.8 -0.8L-0.8 0.8',
};

/** Strokes that say that a value lies beyond its point, in the same square. */
const ARROWS = {
  up: 'M0 -1V-3.2M-0.7 -2.3L0 -3.3L0.7 -2.3',
  right: 'M1 0H3.2M2.3 -0.7L3.3 0L2.3 0.7',
};

const POINT_RADIUS = 4;

/** A drawing surface of a chart: its canvas with positions from the places of the axes. */
class Surface {
  constructor(chart) {
    this.chart = chart;
    this.context = chart.ctx;
    this.pixel = uPlot.pxRatio;
  }

  x(place) {
    return this.chart.valToPos(place, 'x', true);
  }

  y(place) {
    return this.chart.valToPos(place, 'y', true);
  }

  /** Runs `draw` with the canvas limited to the area of the plot and its settings kept. */
  within(draw) {
    const { left, top, width, height } = this.chart.bbox;
    this.context.save();
    this.context.beginPath();
    this.context.rect(left, top, width, height);
    this.context.clip();
    draw();
    this.context.restore();
  }

  setColours(layer) {
    this.context.strokeStyle = colour(layer.colour);
    this.context.fillStyle = colour(layer.colour);
    this.context.lineWidth = layer.width * this.pixel;
    this.context.setLineDash(layer.dashed ? [7 * this.pixel, 5 * this.pixel] : []);
  }

  path(places) {
    this.context.beginPath();
    let broken = true;
    for (const [x, y] of places) {
      if (Number.isFinite(x) && Number.isFinite(y)) {
        this.context[broken ? 'moveTo' : 'lineTo'](this.x(x), this.y(y));
      }
      broken = !Number.isFinite(x) || !Number.isFinite(y);
    }
  }

  /** Heads of arrows at equal distances along a line, as many as the layer has. */
  heads(layer, places) {
    const { context, pixel } = this;
    const points = places.filter((at) => at.every(Number.isFinite))
      .map(([x, y]) => [this.x(x), this.y(y)]);
    const along = [0];
    for (let i = 1; i < points.length; i += 1) {
      const [[x, y], [beforeX, beforeY]] = [points[i], points[i - 1]];
      along.push(along[i - 1] + Math.hypot(x - beforeX, y - beforeY));
    }
    const length = along[along.length - 1];
    const size = (3 + layer.width) * pixel;
    const at = (distance) => {
      const next = Math.max(1, along.findIndex((reached) => reached >= distance));
      const share = (distance - along[next - 1]) / (along[next] - along[next - 1]);
      return [0, 1].map((side) =>
        points[next - 1][side] + share * (points[next][side] - points[next - 1][side]));
    };
    context.setLineDash([]);
    for (let head = 0; head < layer.heads && length > 2 * size * layer.heads; head += 1) {
      const middle = ((head + 0.5) / layer.heads) * length;
      const [fromX, fromY] = at(middle - size);
      const [x, y] = at(middle + size);
      context.save();
      context.translate((x + fromX) / 2, (y + fromY) / 2);
      context.rotate(Math.atan2(y - fromY, x - fromX));
      context.fill(new Path2D(`M${size} 0L${-size} ${-0.8 * size}V${0.8 * size}Z`));
      context.restore();
    }
  }

  mark(layer, x, y) {
    const { context, pixel } = this;
    const scale = POINT_RADIUS * pixel;
    context.save();
    context.translate(this.x(x), this.y(y));
    context.scale(scale, scale);
    context.lineWidth = 1.5 * pixel / scale;
    const outline = new Path2D(SHAPES[layer.shape]);
    if (layer.filled) {
      context.globalAlpha = 0.75;
      context.fill(outline);
      context.globalAlpha = 1;
    } else {
      context.fillStyle = colour('paper');
      context.fill(outline);
    }
    context.stroke(outline);
    if (layer.arrow !== 'none') {
      context.stroke(new Path2D(ARROWS[layer.arrow]));
    }
    context.restore();
  }
}

/** How each kind of layer is drawn; `places` are those of x, y and high along the axes. */
const DRAW_LAYER = {
  line(surface, layer, places) {
    const line = places.map(({ x, y }) => [x, y]);
    surface.path(line);
    surface.context.stroke();
    surface.heads(layer, line);
  },

  area(surface, layer, places) {
    surface.path(places.filter((at) => Number.isFinite(at.x) && Number.isFinite(at.y))
      .map(({ x, y }) => [x, y]));
    surface.context.globalAlpha = 0.2;
    surface.context.fill();
  },

  points(surface, layer, places) {
    for (const { x, y } of places) {
      if (Number.isFinite(x) && Number.isFinite(y)) {
        surface.mark(layer, x, y);
      }
    }
  },

  bars(surface, layer, places) {
    const { context, pixel, chart } = surface;
    const { top, height } = chart.bbox;
    context.beginPath();
    for (const { x, y, high } of places) {
      if (!Number.isFinite(x)) {
        continue;
      }
      const at = surface.x(x);
      const cap = (end, rim) => {
        const to = Number.isFinite(end) ? surface.y(end) : rim;
        const half = Number.isFinite(end) ? 5 * pixel : 0;
        context.moveTo(at - half, to);
        context.lineTo(at + half, to);
        return to;
      };
      const foot = cap(y, top + height);
      const head = cap(high, top);
      context.moveTo(at, foot);
      context.lineTo(at, head);
    }
    context.stroke();
  },

  rug(surface, layer, places) {
    const { context, pixel, chart } = surface;
    const bottom = chart.bbox.top + chart.bbox.height;
    context.beginPath();
    for (const { x } of places) {
      if (Number.isFinite(x)) {
        context.moveTo(surface.x(x), bottom);
        context.lineTo(surface.x(x), bottom - 10 * pixel);
      }
    }
    context.stroke();
  },

  labels(surface, layer, places) {
    const { context, pixel, chart } = surface;
    const { left, top, width, height } = chart.bbox;
    context.font = `600 ${12 * pixel}px system-ui, sans-serif`;
    context.textBaseline = 'bottom';
    context.textAlign = 'center';
    context.lineWidth = 4 * pixel;
    context.lineJoin = 'round';
    context.strokeStyle = colour('paper');
    const line = 16 * pixel;
    const taken = [];
    places.forEach(({ x, y }, index) => {
      const half = context.measureText(layer.texts[index]).width / 2 + 3 * pixel;
      const at = Math.min(Math.max(surface.x(x), left + half), left + width - half);
      const free = (foot) => foot - line >= top && foot <= top + height
        && taken.every((other) => Math.abs(other.at - at) >= other.half + half
          || Math.abs(other.foot - foot) >= line);
      const feet = [0, 1, 2, 3, 4, -2, -3, -4].map((up) => surface.y(y) - 8 * pixel - up * line);
      const foot = feet.find(free);
      if (foot !== undefined && surface.x(x) >= left && surface.x(x) <= left + width) {
        taken.push({ at, half, foot });
        context.strokeText(layer.texts[index], at, foot);
        context.fillText(layer.texts[index], at, foot);
      }
    });
  },
};
