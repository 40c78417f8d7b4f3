/** What was seen before, in bounded memory. */

const MOST_NODE_STATES = 8000;
const FEWEST_MOMENTS = 100;
const MOST_MOMENTS = 600;
const MOST_POINTS = 4000;
const MOST_EVENTS = 1000;

const CLASSES = 8;
const packedBins = new WeakMap();

/**
 * Of each tendon the closed cycles by range and mean, 64 numbers, and the open half cycles of all bins;
 * the same for the same bins.
 */
function packed(bins) {
  if (!packedBins.has(bins)) {
    const tendons = {};
    for (const {
      BinTendon: tendon,
      BinRange: range,
      BinMean: mean,
      BinCycles: cycles,
      BinHalfCycles: halfCycles,
      at_least: atLeast,
    } of Object.values(bins)) {
      tendons[tendon] ??= {
        cycles: new Uint32Array(CLASSES * CLASSES),
        halfCycles: 0,
        at_least: [],
      };
      const packedBin = tendons[tendon];
      packedBin.cycles[CLASSES * range + mean] = cycles;
      packedBin.halfCycles += halfCycles;
      if (atLeast?.includes('BinHalfCycles')) {
        packedBin.at_least = ['halfCycles'];
      }
    }
    packedBins.set(bins, tendons);
  }
  return packedBins.get(bins);
}

/** A view as it is kept and shown: with its bins packed, for they are most of it. */
export function kept(view) {
  const nodes = Object.entries(view.nodes).map(([number, node]) => [
    number,
    { ...node, bins: packed(node.bins) },
  ]);
  return { ...view, nodes: Object.fromEntries(nodes) };
}

/** Views of the fleet, close together of late and further apart the older they are. */
export class PastViews {
  constructor() {
    this.views = [];
  }

  add(view) {
    const last = this.views.at(-1);
    if (last && view.now_us < last.now_us) {
      this.views = [];
    } else if (last && view.now_us === last.now_us) {
      this.views.pop();
    }
    this.views.push(view);
    const nodes = Math.max(1, Object.keys(view.nodes).length);
    const most = Math.min(
      Math.max(Math.floor(MOST_NODE_STATES / nodes), FEWEST_MOMENTS),
      MOST_MOMENTS,
    );
    while (this.views.length > most) {
      this.thin(view.now_us);
    }
  }

  /** Takes the view out that leaves the smallest gap for its age. */
  thin(now_us) {
    let least = Infinity;
    let which = 1;
    for (let i = 1; i + 1 < this.views.length; i += 1) {
      const gap = this.views[i + 1].now_us - this.views[i - 1].now_us;
      const weight = gap / (now_us - this.views[i].now_us + 1e6);
      if (weight < least) {
        least = weight;
        which = i;
      }
    }
    this.views.splice(which, 1);
  }

  /** The number of the last view that is no later than this time; -1 where none is. */
  before(time_us) {
    return this.views.findLastIndex(({ now_us }) => now_us <= time_us);
  }
}

/** The damage curve and the events of one node, as the monitor had them and as they continued. */
export class NodeHistory {
  constructor({ node, curve, events }) {
    this.node = String(node);
    this.curve = curve;
    this.events = events;
  }

  /** Adds what a newer view of the node has. */
  add(state, newEvents) {
    const { status, rate } = state;
    const last = this.curve.at(-1);
    if (status && (!last || status.time_us > last[0])) {
      const known = rate && rate.DamageRate !== 'unknown' ? rate.DamageRate : undefined;
      this.curve.push([status.time_us, state.highest_damage, known]);
    }
    while (this.curve.length > MOST_POINTS) {
      this.curve = this.curve.filter((point, i) => i % 2 === 0 || i + 1 === this.curve.length);
    }
    const newest_us = this.events.at(-1)?.time_us ?? -Infinity;
    const known = this.events
      .filter(({ time_us }) => time_us === newest_us)
      .map(({ words }) => words);
    this.events.push(
      ...newEvents.filter(
        ({ time_us, words }) =>
          time_us > newest_us || (time_us === newest_us && !known.includes(words)),
      ),
    );
    this.events.splice(0, this.events.length - MOST_EVENTS);
  }
}
