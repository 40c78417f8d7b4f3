import { byId, Keyed, make, makeSvg, setAttribute, setText, Value } from './dom.js';
import { percentField, percentText, unitField, UNKNOWN, wholeField } from './prose.js';

/**
 * The damage at which the life states begin: the controller reports when B10 and B50 are reached at
 * the present rate, so they lie so far above the present damage. Inspection is due at half of B10.
 */
export function thresholdsOf({ status, rate, remaining, highest_damage: damage }) {
  if (!status || !rate || !remaining) {
    return null;
  }
  const { RemainingB10: b10, RemainingB50: b50 } = remaining;
  const isKnown = (left) => typeof left === 'number' && left > 0;
  const isBound = [rate, remaining].some((message) => message.at_least?.length > 0);
  if (!isKnown(b10) || !isKnown(b50) || !(rate.DamageRate > 0) || isBound) {
    return null;
  }
  const replace = damage + b10 * rate.DamageRate;
  return { inspect: replace / 2, replace, worn: damage + b50 * rate.DamageRate };
}

function makeRow(number) {
  const bar = makeSvg('svg', {
    class: 'bar',
    viewBox: '0 0 100 10',
    preserveAspectRatio: 'none',
    'aria-hidden': 'true',
  });
  const damage = make('td', { class: 'number' });
  const state = make('td');
  const element = make(
    'tr',
    { 'data-tendon': number },
    make('th', { scope: 'row' }, `Tendon ${number}`),
    make('td', { class: 'track' }, bar),
    damage,
    state,
  );
  return { element, bar, damage: new Value(damage), state };
}

function drawBar(bar, share, thresholds, most) {
  const key = JSON.stringify([share, thresholds, most]);
  if (bar.dataset.key === key) {
    return;
  }
  bar.dataset.key = key;
  const x = (value) => Math.min(100, (100 * value) / most);
  const marks = Object.entries(thresholds || {}).map(([name, value]) =>
    makeSvg('path', {
      class: `threshold life-${name}`,
      d: `M${x(value)} 0V10`,
    }),
  );
  bar.replaceChildren(
    makeSvg('rect', { class: 'track', width: 100, height: 10 }),
    makeSvg('rect', { class: 'strong', y: 2, width: x(share), height: 6 }),
    ...marks,
  );
}

/** The damage of every tendon as bars with the thresholds of the life states. */
export class Tendons {
  constructor() {
    const body = make('tbody');
    const heads = ['Tendon', 'Thresholds', 'Damage', 'State'].map((name) =>
      make('th', { scope: 'col' }, name),
    );
    byId('tendons').append(
      make(
        'table',
        { 'aria-labelledby': 'tendons-heading' },
        make('thead', {}, make('tr', {}, ...heads)),
        body,
      ),
    );
    this.rows = new Keyed(body, makeRow);
    this.known = new Map();
  }

  show({ node, isStale }) {
    const fresh = thresholdsOf(node);
    if (fresh) {
      this.known.set(node.node, fresh);
    }
    const thresholds = this.known.get(node.node);
    setText(
      byId('thresholds'),
      thresholds
        ? `At about ${Object.keys(thresholds)
            .map((name) => `${percentText(thresholds[name], 3)} ${name}`)
            .join(', ')}: from the remaining life that the controller reports.`
        : `Thresholds are ${UNKNOWN}: they follow from a rate and a remaining life that are reported and above 0. The bars are of ${percentText(1)}, the characteristic life.`,
    );
    const numbers = Object.keys(node.tendons);
    const damages = numbers.map((number) => node.tendons[number].TendonDamage);
    const most = Math.max(...damages, thresholds ? 1.05 * thresholds.worn : 1);
    const rows = this.rows.show(numbers);
    for (const number of numbers) {
      const tendon = node.tendons[number];
      const row = rows.get(number);
      drawBar(row.bar, tendon.TendonDamage, thresholds, most);
      row.damage.show(percentField(tendon, 'TendonDamage', 7), isStale(tendon));
      setText(row.state, tendon.TendonLifeState);
      setAttribute(row.state, 'class', `state life-${tendon.TendonLifeState}`);
    }
  }
}

const WIRE_EVENTS = ['above_50', 'above_70', 'above_90', 'slack'];

/** What is known of each wire: its newest page, and the page of each event. */
function wiresOf(node) {
  const wires = {};
  for (const page of Object.values(node.wires)) {
    const wire = (wires[page.WireTendon] ??= { newest: page, events: {} });
    wire.events[page.WireEvent] = page;
    if (page.time_us > wire.newest.time_us) {
      wire.newest = page;
    }
  }
  return wires;
}

function wireState({ WireBroken: broken, WireSlack: slack }) {
  if (broken) {
    return 'broken';
  }
  return slack ? 'slack' : 'whole';
}

function makeWireRow(number) {
  const state = make('td');
  const peak = make('td', { class: 'number' });
  const counts = WIRE_EVENTS.map(() => make('td', { class: 'number' }));
  const below = make('td', { class: 'number' });
  return {
    element: make(
      'tr',
      { 'data-tendon': number },
      make('th', { scope: 'row' }, `Tendon ${number}`),
      state,
      peak,
      ...counts,
      below,
    ),
    state,
    peak: new Value(peak),
    counts: counts.map((cell) => new Value(cell)),
    below: new Value(below),
  };
}

/** What happened to the wire of every tendon. */
export class Wires {
  constructor() {
    const body = make('tbody');
    const heads = ['Tendon', 'Wire', 'Peak', '> 50 %', '> 70 %', '> 90 %', 'Loose', 'Below minimum'];
    const columns = heads.map((name, i) =>
      make('th', { scope: 'col', ...(i > 1 && { class: 'number' }) }, name),
    );
    byId('wires').append(
      make(
        'table',
        { 'aria-labelledby': 'wires-heading' },
        make('thead', {}, make('tr', {}, ...columns)),
        body,
      ),
    );
    this.rows = new Keyed(body, makeWireRow);
  }

  show({ node, isStale }) {
    const wires = wiresOf(node);
    const numbers = Object.keys(wires);
    setText(
      byId('wires-none'),
      numbers.length === 0 ? 'The controller has not told of its wires yet.' : '',
    );
    byId('wires').hidden = numbers.length === 0;
    const rows = this.rows.show(numbers);
    for (const number of numbers) {
      const { newest, events } = wires[number];
      const row = rows.get(number);
      const state = wireState(newest);
      setText(row.state, state);
      setAttribute(row.state, 'class', state === 'whole' ? 'state life-normal' : 'state emergency');
      row.peak.show(unitField(newest, 'WirePeak', '%'), isStale(newest));
      WIRE_EVENTS.forEach((event, i) =>
        row.counts[i].show(
          wholeField(events[event], 'WireCount'),
          events[event] !== undefined && isStale(events[event]),
        ),
      );
      row.below.show(unitField(newest, 'BelowMinimum', 'min'), isStale(newest));
    }
  }
}

const CLASSES = 8;
const CLASS_PERCENT = 12.5;

function matrixOf(node, tendon) {
  const count = Array.from(
    node.bins[tendon]?.cycles || { length: CLASSES * CLASSES },
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

function openText(bins) {
  return bins ? `Open half cycles besides: ${wholeField(bins, 'halfCycles')}.` : '';
}

/** Cycles of a tendon by their range and mean, as far as the controller has sent them. */
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
    setText(byId('bins-open'), openText(node.bins[this.select.value]));
    const key = matrix.count.join();
    if (!this.map) {
      this.map = new HeatMap(byId('bins'), matrix);
    } else if (key !== this.key) {
      this.map.show(matrix);
    }
    this.key = key;
  }
}
