import { hashOf } from './address.js';
import { byId, Keyed, make, setAttribute, setText, Value } from './dom.js';
import {
  ageText,
  percentField,
  rateText,
  recordText,
  remainingText,
  stateTexts,
  UNKNOWN,
  wholeText,
} from './prose.js';

const COLUMNS = [
  'State',
  'Damage',
  'Remaining life',
  'Damage rate',
  'Heartbeat',
  'Lost',
  'Integrity failures',
];

function makeRow(number) {
  const link = make('a', {}, `Node ${number}`);
  const element = make(
    'tr',
    { role: 'row', 'data-node': number },
    make('th', { role: 'rowheader', scope: 'row' }, link),
  );
  const cells = COLUMNS.map((column) => {
    const cell = make('td', { role: 'cell', 'data-column': column });
    element.append(cell);
    return cell;
  });
  const holder = make('span', { class: 'states' });
  cells[0].append(holder);
  const states = new Keyed(holder, () => ({ element: make('span') }));
  const stateTag = make('span', { class: 'tag' });
  cells[0].append(' ', stateTag);
  return {
    element,
    link,
    cells,
    states,
    stateTag,
    values: cells.slice(1).map((c) => new Value(c)),
  };
}

/** States as coloured marks with their words. */
function showStates(row, node, stale) {
  const texts = stateTexts(node);
  const items = row.states.show(texts.map(([, kind], index) => `${index} ${kind}`));
  texts.forEach(([text, kind], index) => {
    const { element } = items.get(`${index} ${kind}`);
    setText(element, `${text}${index + 1 < texts.length ? ', ' : ''}`);
    setAttribute(element, 'class', `state ${kind}`);
  });
  setText(row.stateTag, stale ? 'STALE' : '');
  row.cells[0].classList.toggle('stale', stale);
}

/** Frames that did not come, of all kinds. */
function lostText(node) {
  const streams = Object.values(node.streams);
  return node.partial ? UNKNOWN : wholeText(streams.reduce((sum, { lost }) => sum + lost, 0));
}

/** The numbers of the nodes in the order in which they are shown. */
export function ordered(nodes, order) {
  const numbers = Object.keys(nodes);
  const severity = (number) => nodes[number].severity;
  return order === 'number'
    ? numbers
    : numbers.sort((a, b) => severity(b) - severity(a) || Number(a) - Number(b));
}

export class FleetTable {
  constructor() {
    this.table = byId('fleet');
    this.rows = new Keyed(this.table.tBodies[0], makeRow);
  }

  show({ view, isStale, selection }) {
    setText(byId('fleet-note'), recordText(view));
    const numbers = ordered(view.nodes, selection.order);
    byId('order').value = selection.order;
    this.table.hidden = numbers.length === 0;
    byId('no-nodes').hidden = numbers.length > 0;
    const rows = this.rows.show(numbers);
    for (const number of numbers) {
      const row = rows.get(number);
      const node = view.nodes[number];
      const selected = number === selection.node;
      setAttribute(row.link, 'href', hashOf({ ...selection, node: number }));
      row.element.classList.toggle('selected', selected);
      setAttribute(row.link, 'aria-current', String(selected));
      this.showNode(row, node, view.now_us, isStale);
    }
  }

  /** The link to a node, to return to. */
  linkOf(number) {
    return this.rows.items.get(number)?.link;
  }

  showNode(row, node, now_us, isStale) {
    const { status, remaining, rate, heartbeat } = node;
    showStates(row, node, isStale(status));
    const [damage, left, wear, beat, lost, integrity] = row.values;
    damage.show(status ? percentField(node, 'highest_damage') : UNKNOWN, isStale(status));
    left.show(remainingText(remaining), isStale(remaining));
    wear.show(rateText(rate), isStale(rate));
    const none = node.partial ? UNKNOWN : 'none';
    beat.show(heartbeat ? ageText(now_us, heartbeat.time_us) : none, isStale(heartbeat));
    lost.show(lostText(node), isStale({}));
    const failures = node.integrity_failures;
    integrity.show(wholeText(failures), isStale({}));
    integrity.holder.classList.toggle('bad', failures > 0);
  }
}
