import { byId, make } from './dom.js';

const CLASSES = 8;
const CLASS_PERCENT = 12.5;

function matrixOf(node, tendon) {
  const count = Array.from(
    node.bins[tendon] || { length: CLASSES * CLASSES },
    (cycles) => cycles || 0,
  );
  return {
    ranges: CLASSES,
    means: CLASSES,
    range_step: CLASS_PERCENT,
    mean_step: CLASS_PERCENT,
    mean_min: 0,
    unit: '%',
    count,
  };
}

/** Cycles of a tendon by their range and mean, as far as the controller has told them. */
export class Bins {
  constructor() {
    this.select = byId('bins-tendon');
    this.tendons = [];
    this.select.addEventListener('change', () => this.onChange?.());
  }

  offer(node) {
    const tendons = Object.keys(node.bins);
    if (tendons.join() !== this.tendons.join()) {
      const chosen = this.select.value;
      this.select.replaceChildren(
        ...tendons.map((tendon) => make('option', { value: tendon }, tendon)),
      );
      this.select.value = tendons.includes(chosen) ? chosen : tendons[0];
      this.tendons = tendons;
    }
    this.select.disabled = tendons.length === 0;
  }

  show({ node }) {
    this.offer(node);
    this.onChange = () => this.show({ node });
    const matrix = matrixOf(node, this.select.value);
    const key = matrix.count.join();
    if (!this.map) {
      this.map = new HeatMap(byId('bins'), matrix);
    } else if (key !== this.key) {
      this.map.show(matrix);
    }
    this.key = key;
  }
}
