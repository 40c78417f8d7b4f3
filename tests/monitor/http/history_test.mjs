// What the live page keeps stays within its bounds for a day. LIVE_ASSETS: the folder of its scripts.
import assert from 'node:assert/strict';
import { test } from 'node:test';

const assets = process.env.LIVE_ASSETS;
const { kept, PastViews, NodeHistory } = await import(`${assets}/history.js`);
const { merged } = await import(`${assets}/stream.js`);

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

test('the slider can stand at what a history has of earlier times', () => {
  const curve = (count) => Array.from({ length: count }, (_, i) => [10 * i, 0.1]);
  const few = new NodeHistory({ node: 3, curve: curve(4), events: [] });
  assert.deepEqual(few.timesBefore(20), [0, 10]);
  assert.deepEqual(few.timesBefore(0), []);
  const many = new NodeHistory({ node: 3, curve: curve(4000), events: [] });
  const times = many.timesBefore(30_000);
  assert.equal(times.length, 300);
  times.forEach((time_us, i) => assert.equal(time_us, 100 * i));
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
  const history = new NodeHistory({ node: 5, curve: [[1e6, 0.25, 0.5], [2e6, 4.294967295]], events: [] });
  const before = history.at(1e6);
  assert.equal(percentField(before.rate, 'UnsavedDamage'), 'not known');
  assert.equal(percentField(before.storage, 'WorstUnsavedDamage'), 'not known');
  assert.equal(wholeField(before.cycles, 'Cycles'), 'not known');
  assert.equal(percentField(before, 'highest_damage', 7), '25 %');
  assert.equal(rateText(before.rate), '50 % per h');
  assert.equal(percentField(history.at(2e6), 'highest_damage', 7), '≥ 429.4967 %');
  assert.equal(wholeField({ Refused: 65535, at_least: ['Refused'] }, 'Refused'), '≥ 65\u202f535');
  const unknown = { RemainingB10: 'unknown', RemainingB90: 'unknown' };
  assert.equal(remainingText(unknown), 'unknown');
  const ending = { RemainingB10: 1.5, RemainingB90: 6553.4, at_least: ['RemainingB90'] };
  assert.equal(remainingText(ending), '1.5 to ≥ 6553.4 h');
});
