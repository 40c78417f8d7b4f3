import { byId, make, makeSvg, setText } from './dom.js';
import { clockText, momentText, plain, zoneText } from './prose.js';

const MOST_LISTED = 200;
const REDRAW_MS = 1000;
const HEIGHT = 74;
const STRIP = { y: 20, height: 22 };
const MARKS = {
  emergency: ['emergency', 'M0 -14L6 -2H-6Z'],
  epoch: ['epoch', 'M-5 -13H5V-3H-5Z'],
  boot: ['boot', 'M-5 -8A5 5 0 1 0 5 -8A5 5 0 1 0 -5 -8Z'],
  vanished: ['gone', 'M-5 -13L5 -3M5 -13L-5 -3'],
  back: ['back', 'M-5 -8L-1 -3L6 -13'],
  two_controllers: ['emergency', 'M0 -14L6 -2H-6Z'],
  integrity: ['bad', 'M0 -14L5 -8L0 -2L-5 -8Z'],
};

/**
 * Spans of one life state: [{ from_us, to_us, state }, ..]. Where a node has vanished there is none
 * until it is heard again.
 */
export function spansOf(events, end_us) {
  const spans = [];
  let open;
  for (const { time_us, kind, state } of events) {
    if (open && (kind === 'vanished' || open.state !== state)) {
      open.to_us = time_us;
      open = undefined;
    }
    if (!open && kind !== 'vanished') {
      open = { from_us: time_us, to_us: end_us, state };
      spans.push(open);
    }
  }
  return spans;
}

export function eventText({ kind, words }) {
  const prefix = { state: 'life state ', emergency: 'EMERGENCY: ' }[kind] || '';
  return prefix + plain(words);
}

function summaryOf(events, spans) {
  const states = spans.map(
    ({ from_us, to_us, state }) => `${state} from ${clockText(from_us)} to ${clockText(to_us)}`,
  );
  const emergencies = events.filter(({ kind }) => kind === 'emergency').length;
  return `${states.slice(-10).join(', ')}; emergencies: ${emergencies}`;
}

function addSpans(svg, spans, x) {
  const least_px = 60;
  for (const { from_us, to_us, state } of spans) {
    const left = x(from_us);
    const width = Math.max(1, x(to_us) - left);
    svg.append(makeSvg('rect', { class: `life-${state}`, x: left, width, ...STRIP }));
    if (width > least_px) {
      svg.append(makeSvg('text', { x: left + 5, y: STRIP.y + 15, class: 'on-state' }, state));
    }
  }
}

function addMarks(svg, events, x) {
  for (const { kind, time_us } of events.filter((event) => event.kind in MARKS)) {
    const [name, path] = MARKS[kind];
    const transform = `translate(${x(time_us)} ${STRIP.y})`;
    svg.append(makeSvg('path', { class: `event ${name}`, d: path, transform }));
  }
}

/** The states of a node as a strip with marks, and its events as a list. */
export class Timeline {
  constructor() {
    this.holder = byId('timeline');
    this.list = byId('events');
    this.drawn_ms = -Infinity;
    keepDrawn(this.holder, () => this.last && this.draw(this.last));
  }

  show({ history, view, selection }) {
    const key = [
      history.node,
      selection.at,
      history.events.length,
      history.events.at(-1)?.time_us,
    ].join();
    const now_ms = performance.now();
    if (key !== this.key || now_ms - this.drawn_ms >= REDRAW_MS) {
      this.last = {
        events: history.events.filter(({ time_us }) => time_us <= view.now_us),
        end_us: view.now_us,
      };
      this.draw(this.last);
      this.drawn_ms = now_ms;
    }
    if (key !== this.key) {
      this.fill(this.last.events);
      this.key = key;
    }
  }

  clear() {
    this.last = undefined;
    this.key = undefined;
    this.holder.replaceChildren();
    this.list.replaceChildren();
  }

  draw({ events, end_us }) {
    const width = this.holder.clientWidth;
    const spans = spansOf(events, end_us);
    if (events.length === 0 || width === 0) {
      this.holder.replaceChildren(make('p', { class: 'empty' }, 'Nothing has happened yet.'));
      return;
    }
    const start_us = events[0].time_us;
    const scale = (width - 16) / Math.max(1, end_us - start_us);
    const x = (time_us) => 8 + (time_us - start_us) * scale;
    const svg = makeSvg('svg', {
      width,
      height: HEIGHT,
      viewBox: `0 0 ${width} ${HEIGHT}`,
      role: 'img',
      'aria-label': summaryOf(events, spans),
    });
    addSpans(svg, spans, x);
    addMarks(svg, events, x);
    const y = STRIP.y + STRIP.height + 18;
    svg.append(
      makeSvg('text', { x: 8, y }, clockText(start_us)),
      makeSvg(
        'text',
        { x: width - 8, y, 'text-anchor': 'end' },
        `${clockText(end_us)} ${zoneText(end_us)}`.trim(),
      ),
    );
    this.holder.replaceChildren(svg);
  }

  fill(events) {
    const lines = events
      .slice(-MOST_LISTED)
      .reverse()
      .map((event) => {
        const line = make(
          'li',
          { class: event.kind },
          make('time', {}, momentText(event.time_us)),
          ' ',
        );
        line.append(eventText(event));
        return line;
      });
    this.list.replaceChildren(...lines);
    setText(
      this.list.previousElementSibling,
      `Events as a list, the last first (${events.length})`,
    );
  }
}
