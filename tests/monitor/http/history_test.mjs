// What the live page keeps and makes of it: within its bounds for a day, in order, in words. LIVE_ASSETS:
// the folder of its scripts.
import assert from 'node:assert/strict';
import { test } from 'node:test';

const assets = process.env.LIVE_ASSETS;
const { kept, PastViews, NodeHistory } = await import(`${assets}/history.js`);
const { merged } = await import(`${assets}/stream.js`);
const { Moments, withAllNodes } = await import(`${assets}/moments.js`);
const { spansOf } = await import(`${assets}/events.js`);
const { ordered } = await import(`${assets}/fleet.js`);
const { zoneText } = await import(`${assets}/prose.js`);

const VIEW_US = 200e3;
const DAY_US = 86400e6;

function fleetOf(nodes, now_us) {
  return {
    now_us,
    nodes: Object.fromEntries(Array.from({ length: nodes }, (_, i) => [i + 1, { bins: {} }])),
  };
}

test('moments of a day are bounded, dense of late and reach back to the start', () => {
  const past = new PastViews();
  const view = fleetOf(20, 0);
  for (let now_us = 0; now_us <= DAY_US; now_us += VIEW_US) {
    past.add({ ...view, now_us });
  }
  const times = past.views.map(({ now_us }) => now_us);
  assert.equal(times.length, 400);
  assert.equal(times[0], 0);
  assert.equal(times.at(-1), DAY_US);
  times.slice(1).forEach((time_us, i) => {
    const gap_us = time_us - times[i];
    assert.ok(
      gap_us > 0 && gap_us <= 0.15 * (DAY_US - times[i]) + 3 * VIEW_US,
      `${gap_us} before ${time_us}`,
    );
  });
});

test('moments of many nodes are fewer', () => {
  const past = new PastViews();
  for (let i = 0; i < 1000; i += 1) {
    past.add(fleetOf(127, i));
  }
  assert.equal(past.views.length, 100);
});

test('a clock that stands still keeps one moment, one that is set back begins anew', () => {
  const past = new PastViews();
  [1, 2, 2, 2].forEach((now_us) => past.add(fleetOf(1, now_us)));
  assert.equal(past.views.length, 2);
  past.add(fleetOf(1, 1));
  assert.equal(past.views.length, 1);
});

test('the moment before a time', () => {
  const past = new PastViews();
  [10, 20, 30].forEach((now_us) => past.add(fleetOf(1, now_us)));
  assert.deepEqual(
    [9, 10, 25, 99].map((time_us) => past.before(time_us)),
    [-1, 0, 1, 2],
  );
});

test('the history of a node is bounded and keeps its ends', () => {
  const history = new NodeHistory({ node: 3, curve: [], events: [] });
  const last = 50_000;
  for (let i = 1; i <= last; i += 1) {
    history.add({ status: { time_us: i }, highest_damage: i / last }, [
      { time_us: i, words: String(i), kind: 'state', state: 'normal' },
    ]);
    assert.ok(history.curve.length <= 4000 && history.events.length <= 1000);
  }
  assert.equal(history.curve[0][0], 1);
  assert.deepEqual(history.curve.at(-1), [last, 1, undefined]);
  assert.equal(history.events.at(-1).words, String(last));
});

/** Answers of the monitor by path; each is asked for once. */
function monitorThatKnows(answers, asked) {
  globalThis.fetch = async (path) => {
    asked.push(path);
    const found = answers[path];
    return { ok: Boolean(found), json: async () => found, text: async () => 'not there\n' };
  };
}

const nextTurn = () => new Promise((resolve) => { setTimeout(resolve); });

test('before what the page has seen, the monitor is asked', async () => {
  const asked = [];
  const history = { curve: [[4, 0.1]], events: [] };
  monitorThatKnows(
    {
      '/api/times': { times_us: [3, 5, 10, 12], whole_from_us: 5, why_gone: 'few are kept' },
      '/api/moment/5': { now_us: 5, from_us: 1, nodes: { 2: { bins: {} } } },
      '/api/moment/5/2': { now_us: 5, from_us: 1, nodes: { 2: { bins: {} } }, history },
    },
    asked,
  );
  const moments = new Moments(() => {});
  moments.add(fleetOf(1, 10));
  moments.add(fleetOf(1, 20));
  await moments.look();
  assert.deepEqual(moments.steps(), [3, 5, 10, 20]);
  assert.deepEqual(moments.gone, { before_us: 5, why: 'few are kept' });
  assert.equal(moments.isOld(), false);
  assert.equal(moments.viewAt(15).now_us, 10);
  assert.deepEqual(moments.viewAt(5), { now_us: 5, nodes: {}, asked: true });
  moments.viewAt(5);
  await nextTurn();
  assert.equal(moments.viewAt(5).from_us, 1);
  moments.viewAt(5, '2');
  await nextTurn();
  assert.equal(moments.viewAt(5, '2').history.node, '2');
  moments.viewAt(3);
  await nextTurn();
  assert.equal(moments.viewAt(3).trouble, 'not there');
  assert.deepEqual(asked, ['/api/times', '/api/moment/5', '/api/moment/5/2', '/api/moment/3']);
});

test('of moments that are wanted while one is read, the last is read', async () => {
  const asked = [];
  const view = { now_us: 1, nodes: {} };
  monitorThatKnows({ '/api/moment/1': view, '/api/moment/4': { ...view, now_us: 4 } }, asked);
  const moments = new Moments(() => {});
  moments.add(fleetOf(1, 10));
  [1, 2, 3, 4].forEach((at) => moments.viewAt(at));
  await nextTurn();
  assert.equal(moments.viewAt(4).now_us, 4);
  assert.deepEqual(asked, ['/api/moment/1', '/api/moment/4']);
});

test('a fleet does not shrink where nothing is known of a node', () => {
  const all = withAllNodes({ now_us: 1, nodes: { 2: { node: 2 } } }, fleetOf(3, 9));
  assert.deepEqual(Object.keys(all.nodes), ['1', '2', '3']);
  assert.equal(all.nodes[2].absent, undefined);
  assert.equal(all.nodes[3].absent, true);
});

test('the strip of a node that has vanished ends until it is heard again', () => {
  const event = (time_us, kind, state) => ({ time_us, kind, state, words: '' });
  const events = [
    event(1, 'state', 'normal'),
    event(2, 'emergency', 'normal'),
    event(3, 'state', 'inspect'),
    event(5, 'vanished', 'inspect'),
    event(8, 'back', 'inspect'),
    event(9, 'state', 'replace'),
    event(11, 'vanished', 'replace'),
  ];
  assert.deepEqual(spansOf(events, 20), [
    { from_us: 1, to_us: 3, state: 'normal' },
    { from_us: 3, to_us: 5, state: 'inspect' },
    { from_us: 8, to_us: 9, state: 'inspect' },
    { from_us: 9, to_us: 11, state: 'replace' },
  ]);
  assert.equal(spansOf(events.slice(0, 5), 20).at(-1).to_us, 20);
});

test('the gravest nodes come first, and others by their numbers', () => {
  const severities = { 1: 0, 2: 30, 3: 70, 4: 60, 9: 30, 10: 90, 11: 0 };
  const nodes = Object.fromEntries(
    Object.entries(severities).map(([number, severity]) => [number, { severity }]),
  );
  assert.deepEqual(ordered(nodes, 'severity'), ['10', '3', '4', '2', '9', '1', '11']);
  assert.deepEqual(ordered(nodes, 'number'), Object.keys(nodes));
});

test('clock times have their zone, and times from the start of a log none', () => {
  const time_us = Date.UTC(2026, 5, 1) * 1000;
  const zoneIn = (zone) => {
    process.env.TZ = zone;
    return zoneText(time_us);
  };
  assert.equal(zoneIn('UTC'), 'UTC');
  assert.equal(zoneIn('Asia/Kolkata'), 'UTC+5:30');
  assert.equal(zoneIn('America/New_York'), 'UTC−4');
  assert.equal(zoneText(12e6), '');
  delete process.env.TZ;
});

test('from when on there are frames is said where there were some before', async () => {
  const { goneText } = await import(`${assets}/prose.js`);
  assert.equal(goneText({}), '');
  assert.equal(goneText({ before_us: 5e6 }), '');
  assert.equal(
    goneText({ before_us: 5e6, why: 'few are kept' }),
    'Frames before 5.0\u00a0s are gone: few are kept. Before then only damage, rate and state are known.',
  );
});

test('events that are known are not added twice', () => {
  const event = { time_us: 5, words: 'inspect', kind: 'state', state: 'inspect' };
  const history = new NodeHistory({ node: 3, curve: [], events: [event] });
  history.add({}, [event, { ...event, time_us: 6 }]);
  assert.equal(history.events.length, 2);
});

test('bins are packed once for each change', () => {
  const bins = {
    156: { BinTendon: 2, BinRange: 3, BinMean: 4, BinHalfCycles: 2, BinCycles: 77 },
    157: { BinTendon: 2, BinRange: 3, BinMean: 5, BinHalfCycles: 31, BinCycles: 0 },
  };
  const view = { now_us: 1, nodes: { 5: { bins } } };
  const one = kept(view).nodes[5].bins;
  assert.equal(one[2].cycles[8 * 3 + 4], 77);
  assert.equal(one[2].halfCycles, 33);
  assert.deepEqual(one[2].at_least, []);
  const full = { 157: { ...bins[157], at_least: ['BinHalfCycles'] } };
  const other = kept({ now_us: 1, nodes: { 5: { bins: full } } }).nodes[5].bins;
  assert.deepEqual(other[2].at_least, ['halfCycles']);
  assert.equal(kept({ ...view, now_us: 2 }).nodes[5].bins, one);
});

test('a merge patch changes what it names and shares the rest (examples of RFC 7396, appendix A)', () => {
  const examples = [
    [{ a: 'b' }, { a: 'c' }, { a: 'c' }],
    [{ a: 'b' }, { b: 'c' }, { a: 'b', b: 'c' }],
    [{ a: 'b' }, { a: null }, {}],
    [{ a: ['b'] }, { a: 'c' }, { a: 'c' }],
    [{ a: { b: 'c' } }, { a: { b: 'd', c: null } }, { a: { b: 'd' } }],
    [{ a: 'foo' }, 'bar', 'bar'],
    [[1, 2], { a: 'b', c: null }, { a: 'b' }],
    [{}, { a: { bb: { ccc: null } } }, { a: { bb: {} } }],
  ];
  examples.forEach(([target, patch, wanted]) => assert.deepEqual(merged(target, patch), wanted));
  const before = { a: { x: 1 }, b: { y: 1 } };
  const after = merged(before, { b: { y: 2 } });
  assert.equal(after.a, before.a);
  assert.deepEqual(before.b, { y: 1 });
});

test('what is not known is no number, and the end of a range no exact one', async () => {
  const { readFileSync } = await import('node:fs');
  const { runInThisContext } = await import('node:vm');
  runInThisContext(readFileSync(`${assets}/../../../report/page/assets/format.js`, 'utf8'));
  const { percentField, rateText, remainingText, wholeField } = await import(`${assets}/prose.js`);
  const before = { highest_damage: 0.25, status: { time_us: 1e6 }, rate: { DamageRate: 0.5 } };
  assert.equal(percentField(before.rate, 'UnsavedDamage'), 'not known');
  assert.equal(percentField(before.storage, 'WorstUnsavedDamage'), 'not known');
  assert.equal(wholeField(before.cycles, 'Cycles'), 'not known');
  assert.equal(percentField(before, 'highest_damage', 7), '25\u00a0%');
  assert.equal(rateText(before.rate), '50\u00a0%\u00a0per\u00a0h');
  const ended = { highest_damage: 4.294967295, at_least: ['highest_damage'] };
  assert.equal(percentField(ended, 'highest_damage', 7), '≥\u00a0429.4967\u00a0%');
  assert.equal(wholeField({ Refused: 65535, at_least: ['Refused'] }, 'Refused'), '≥\u00a065\u202f535');
  const unknown = { RemainingB10: 'unknown', RemainingB90: 'unknown' };
  assert.equal(remainingText(unknown), 'unknown');
  const ending = { RemainingB10: 1.5, RemainingB90: 6553.4, at_least: ['RemainingB90'] };
  assert.equal(remainingText(ending), '1.5 to ≥\u00a06553.4\u00a0h');
});
