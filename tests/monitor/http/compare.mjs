// The page against the decoded log: what differs, in words.
import { shows } from './numbers.mjs';

const MISSING = { text: '', note: '', stale: undefined };

/** Collects what is not as it should be. */
export class Problems {
  constructor() {
    this.list = [];
    this.checks = 0;
  }

  expect(what, holds) {
    this.checks += 1;
    if (!holds) {
      this.list.push(what);
      console.error(`FAILED ${what}`);
    }
  }

  number(what, text, value, digits) {
    this.expect(`${what}: '${text}' shows ${value}`, shows(text, value, digits));
  }

  same(what, shown, wanted) {
    this.expect(`${what}: '${shown}' is '${wanted}'`, shown === wanted);
  }
}

function hoursText(text, value, problems, what) {
  if (value === 'unknown') {
    problems.expect(`${what} is unknown in '${text}'`, text.includes('unknown'));
  } else {
    problems.number(what, text, value, 5);
  }
}

export function compareFleet(shown, { nodes }, problems) {
  problems.same('nodes of the table', Object.keys(shown).join(), Object.keys(nodes).join());
  for (const [number, { messages, damage, counts }] of Object.entries(nodes)) {
    const row = shown[number];
    const at = `node ${number} of the table`;
    problems.expect(
      `${at}: state ${messages.LifeStatus.LifeState}`,
      row.State.text.includes(messages.LifeStatus.LifeState),
    );
    problems.number(`${at}: damage`, row.Damage.text, 100 * damage, 5);
    problems.number(
      `${at}: rate`,
      row['Damage rate'].text,
      100 * messages.DamageRate.DamageRate,
      4,
    );
    const [low, high] = row['Remaining life'].text.split(' to ');
    hoursText(low, messages.RemainingLife.RemainingB10, problems, `${at}: B10`);
    hoursText(high, messages.RemainingLife.RemainingB90, problems, `${at}: B90`);
    const failures = Object.values(counts).reduce((sum, one) => sum + one.damaged, 0);
    problems.number(`${at}: integrity failures`, row['Integrity failures'].text, failures);
  }
}

function compareTiles(tiles, { messages, damage, advice }, problems, at) {
  const number = (name, value, digits) =>
    problems.number(`${at}: ${name}`, (tiles[name] ?? MISSING).text, value, digits);
  const note = (name, value, digits) =>
    problems.number(
      `${at}: note of ${name}`,
      (tiles[name] ?? MISSING).note.replace(/^B50/, ''),
      value,
      digits,
    );
  const {
    LifeStatus: status,
    Cycles: cycles,
    DamageRate: rate,
    RemainingLife: remaining,
    ConditionalLife: conditional,
    BreakRisk: risk,
    Storage: storage,
    Timing: timing,
    Bus: bus,
    Identity: identity,
  } = messages;
  number('Damage', 100 * damage, 7);
  note('Damage', status.WorstTendon);
  problems.same(`${at}: life state`, tiles['Life state'].text, status.LifeState);
  problems.same(`${at}: quality`, tiles.Reading.text, status.Quality);
  problems.same(`${at}: gap`, tiles.Reading.note.includes('samples missing'), Boolean(status.Gap));
  const [low, high] = tiles['Remaining life, B10 to B90'].text.split(' to ');
  hoursText(low, remaining.RemainingB10, problems, `${at}: B10`);
  hoursText(high, remaining.RemainingB90, problems, `${at}: B90`);
  note('Remaining life, B10 to B90', remaining.RemainingB50, 5);
  const whole = tiles['Whole now: until 10 to 50 % have broken'].text.split(' to ');
  hoursText(whole[0], conditional.HoursToRisk10, problems, `${at}: 10 %`);
  hoursText(whole[1], conditional.HoursToRisk50, problems, `${at}: 50 %`);
  number('Probability of a break', 100 * risk.BreakRisk, 4);
  number('Damage rate', 100 * rate.DamageRate, 4);
  const told = Object.values(advice);
  if (told.every((page) => page.AdviceState === 'off')) {
    problems.same(`${at}: advice`, tiles['Advice to the drive'].text, 'off');
  } else {
    const [tightest] = told.sort((a, b) => a.AdvicePace - b.AdvicePace);
    number('Advice to the drive', 100 * tightest.AdviceTension, 4);
    const wanted = `tendon ${tightest.AdviceTendon}, limited`;
    const { note: shown } = tiles['Advice to the drive'];
    problems.same(`${at}: tendon of the advice`, shown.endsWith(wanted), true);
    problems.number(`${at}: pace`, shown.split(';')[0], 100 * tightest.AdvicePace, 4);
  }
  number('Cycles', cycles.Cycles);
  note('Cycles', cycles.CycleRate);
  number('Storage sequence', storage.StorageSequence);
  number('Worst unsaved damage', 100 * storage.WorstUnsavedDamage, 5);
  number('Unsaved damage', 100 * rate.UnsavedDamage, 5);
  problems.same(
    `${at}: digest`,
    tiles['Configuration digest'].text,
    `0x${identity.Configuration.toString(16).padStart(8, '0')}`,
  );
  number('Jitter, 99th percentile', timing.P99Jitter);
  note('Jitter, 99th percentile', timing.WorstJitter);
  number('Missed deadlines', timing.MissedDeadlines);
  problems.same(
    `${at}: error counters`,
    tiles['Error counters'].text,
    `${bus.TransmitErrors} sent, ${bus.ReceiveErrors} received`,
  );
  note('Error counters', bus.BusOffs);
  number('Dropped pages', bus.DroppedPages);
  number('Refused by the node', bus.Refused);
}

function compareThresholds(text, { messages, damage }, problems, at) {
  const {
    DamageRate: rate,
    RemainingLife: { RemainingB10: b10, RemainingB50: b50 },
  } = messages;
  if (!(b10 > 0)) {
    return;
  }
  const replace = damage + b10 * rate.DamageRate;
  const wanted = [replace / 2, replace, damage + b50 * rate.DamageRate];
  text
    .split(',')
    .forEach((part, i) => problems.number(`${at}: threshold ${i}`, part, 100 * wanted[i], 3));
}

export function compareNode(shown, number, decoded, problems) {
  const node = decoded.nodes[number];
  const at = `node ${number}`;
  problems.same(`${at}: heading`, shown.heading, `Node ${number}`);
  compareTiles(shown.tiles, node, problems, at);
  compareThresholds(shown.thresholds, node, problems, at);
  problems.same(`${at}: tendons`, shown.tendons.length, Object.keys(node.tendons).length);
  for (const [tendon, , damage, state] of shown.tendons) {
    const { TendonDamage: share, TendonLifeState: wanted } =
      node.tendons[tendon.replace('Tendon ', '')];
    problems.number(`${at}: ${tendon}`, damage, 100 * share, 7);
    problems.same(`${at}: state of ${tendon}`, state, wanted);
  }
  problems.same(`${at}: wires`, shown.wires.length, Object.keys(node.wires).length);
  for (const [tendon, state, peak, ...rest] of shown.wires) {
    const { newest, counts } = node.wires[tendon.replace('Tendon ', '')];
    const wanted = [newest.WireBroken && 'broken', newest.WireSlack && 'slack', 'whole'];
    problems.same(`${at}: wire of ${tendon}`, state, wanted.find(Boolean));
    problems.number(`${at}: peak of ${tendon}`, peak, newest.WirePeak);
    ['above_50', 'above_70', 'above_90', 'slack'].forEach((event, i) =>
      problems.number(`${at}: ${event} of ${tendon}`, rest[i], counts[event]),
    );
    problems.number(`${at}: below the minimum of ${tendon}`, rest[4], newest.BelowMinimum);
  }
  for (const [frame, good, , repeated, wrongSequence, damaged] of shown.streams) {
    const counts = node.counts[frame] ?? { good: 0, repeated: 0, wrong_sequence: 0, damaged: 0 };
    problems.number(`${at}: good ${frame}`, good, counts.good);
    problems.number(`${at}: repeated ${frame}`, repeated, counts.repeated);
    problems.number(`${at}: wrong sequence ${frame}`, wrongSequence, counts.wrong_sequence);
    problems.number(`${at}: damaged ${frame}`, damaged, counts.damaged);
  }
  const first = Object.keys(node.bins).filter((key) => key.startsWith(`${shown.bins[0]} `));
  problems.same(`${at}: classes of the heat map`, shown.cells, first.length);
  const open = first.reduce((sum, key) => sum + node.bins[key].BinHalfCycles, 0);
  problems.number(`${at}: open half cycles`, shown.binsOpen, open);
  problems.same(`${at}: line charts`, shown.canvases, 2);
}
