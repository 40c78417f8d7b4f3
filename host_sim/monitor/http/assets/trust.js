import { byId, Keyed, make, makeSvg, setText, Tiles } from './dom.js';
import {
  percentField,
  percentText,
  unitField,
  UNKNOWN,
  wholeField,
  wholeText as whole,
  withUnit,
} from './prose.js';

const COUNTS = [
  ['good', 'Good'],
  ['lost', 'Lost'],
  ['repeated', 'Repeated'],
  ['wrong_sequence', 'Wrong sequence'],
  ['damaged', 'Damaged'],
  ['malformed', 'Malformed'],
  ['silences', 'Silences'],
];
const FRAMES = ['Heartbeat', 'LifeStatus', 'LifeDetail', 'Emergency', 'Command'];
const CLASSES = 40;
const SIZE = { width: 400, height: 96 };

function hex(value) {
  return `0x${value.toString(16).padStart(8, '0')}`;
}

function nodeTiles(
  { identity, storage, rate, timing, bus, integrity_failures: failures },
  isStale,
) {
  const when = (message, text) => (message ? text(message) : UNKNOWN);
  return [
    ['Integrity failures', whole(failures), isStale({}), 'frames of this node that were refused'],
    ['Storage sequence', wholeField(storage, 'StorageSequence'), isStale(storage)],
    [
      'Worst unsaved damage',
      percentField(storage, 'WorstUnsavedDamage'),
      isStale(storage),
      'what a power cut could have lost',
    ],
    ['Unsaved damage', percentField(rate, 'UnsavedDamage'), isStale(rate)],
    [
      'Configuration digest',
      when(identity, (i) => hex(i.Configuration)),
      isStale(identity),
      when(
        identity,
        (i) =>
          `frame plan ${i.SchemaVersion}, firmware ${i.FirmwareVersion >> 4}.${i.FirmwareVersion & 15}`,
      ),
    ],
    [
      'Jitter, 99th percentile',
      when(timing, (t) => unitField(t, 'P99Jitter', 'µs')),
      isStale(timing),
      when(timing, (t) => `worst ${unitField(t, 'WorstJitter', 'µs')}`),
    ],
    ['Missed deadlines', wholeField(timing, 'MissedDeadlines'), isStale(timing)],
    [
      'Error counters',
      when(bus, (b) => `${b.TransmitErrors} sent, ${b.ReceiveErrors} received`),
      isStale(bus),
      when(bus, (b) => `times off the bus: ${wholeField(b, 'BusOffs')}`),
    ],
    ['Dropped pages', wholeField(bus, 'DroppedPages'), isStale(bus)],
    [
      'Refused by the node',
      wholeField(bus, 'Refused'),
      isStale(bus),
      'frames and commands',
    ],
  ];
}

function busTiles(view, old) {
  const load = view.bus_load_percent;
  return [
    [
      'Bus load',
      load === undefined ? UNKNOWN : percentText(load / 100, 4),
      old,
      view.bit_rate_bit_s ? `of ${withUnit(numberText(view.bit_rate_bit_s / 1000, 6), 'kbit/s')}` : '',
    ],
    [
      'Frames',
      whole(view.frames),
      old,
      view.frames_per_s === undefined ? '' : `${numberText(view.frames_per_s, 4)} per s`,
    ],
    ['Foreign frames', whole(view.foreign_frames), old],
    ['Error frames', whole(view.error_frames), old],
    [
      'Lost before the monitor',
      whole(view.receive_overflows),
      old,
      'reports of a full receive queue',
    ],
  ];
}

function makeStreamRow(name) {
  const cells = COUNTS.map(([key]) => make('td', { class: 'number', 'data-count': key }));
  const element = make('tr', { 'data-frame': name }, make('th', { scope: 'row' }, name), ...cells);
  return { element, cells };
}

function makeHistogram(name) {
  const svg = makeSvg('svg', {
    viewBox: `0 0 ${SIZE.width} ${SIZE.height}`,
    role: 'img',
    class: 'histogram',
  });
  const note = make('figcaption', { class: 'caption' });
  const element = make('figure', { 'data-frame': name }, make('h4', {}, name), svg, note);
  return { element, svg, note };
}

function drawHistogram({ svg, note }, { intervals, interval_class_ms: class_ms }) {
  const counts = Array.from({ length: CLASSES }, (_, i) => intervals[i] || 0);
  const key = counts.join();
  if (svg.dataset.key === key) {
    return;
  }
  svg.dataset.key = key;
  const most = Math.max(1, ...counts);
  const total = counts.reduce((a, b) => a + b, 0);
  const step = SIZE.width / CLASSES;
  const foot = SIZE.height - 18;
  const bars = counts.map((count, i) =>
    makeSvg('rect', {
      class: 'strong',
      x: i * step + 1,
      width: step - 2,
      y: foot - (count / most) * (foot - 4),
      height: (count / most) * (foot - 4),
    }),
  );
  const ticks = [0, 1, 2, 3].map((quarter) => {
    const first = (quarter * CLASSES) / 4;
    return makeSvg('text', { x: first * step, y: SIZE.height - 4 }, withUnit(first * class_ms, 'ms'));
  });
  svg.replaceChildren(
    makeSvg('path', { class: 'axis', d: `M0 ${foot}H${SIZE.width}` }),
    ...bars,
    ...ticks,
  );
  const top = counts.indexOf(most);
  const end = top === CLASSES - 1 ? 'ms or longer' : `to ${(top + 1) * class_ms} ms`;
  const summary =
    `${whole(total)} intervals; most often ${top * class_ms} ${end}; `
    + `${whole(counts[CLASSES - 1])} of ${(CLASSES - 1) * class_ms} ms or longer`;
  svg.setAttribute('aria-label', `Time between frames: ${summary}`);
  setText(note, summary);
}

/** How far the values can be trusted. */
export class Trust {
  constructor() {
    this.tiles = new Tiles(byId('trust'));
    const body = make('tbody');
    const heads = ['Frame', ...COUNTS.map(([, name]) => name)].map((name) =>
      make('th', { scope: 'col' }, name),
    );
    byId('streams').append(
      make(
        'table',
        { 'aria-label': 'Frames of this node' },
        make('thead', {}, make('tr', {}, ...heads)),
        body,
      ),
    );
    this.rows = new Keyed(body, makeStreamRow);
    this.histograms = new Keyed(byId('intervals'), makeHistogram);
  }

  show({ node, view, isStale }) {
    this.tiles.show([...nodeTiles(node, isStale), ...busTiles(view, isStale({}))]);
    const names = FRAMES.filter((name) => name in node.streams);
    const rows = this.rows.show(names);
    for (const name of names) {
      const stream = node.streams[name];
      rows.get(name).cells.forEach((cell, i) => setText(cell, whole(stream[COUNTS[i][0]])));
    }
    const repeated = names.filter((name) => Object.keys(node.streams[name].intervals).length > 0);
    const histograms = this.histograms.show(repeated);
    for (const name of repeated) {
      drawHistogram(histograms.get(name), node.streams[name]);
    }
  }
}
