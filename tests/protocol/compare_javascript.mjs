// compare_javascript.mjs FOLDER GENERATE
//
// The generated JavaScript module has to say of every frame of FOLDER/{clean,faulty}.log what the files
// beside them say: values, names, and whether the frame may be used.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [folder, generate] = process.argv.slice(2);
const module = `${folder}/tendonlife.mjs`;
execFileSync(generate, ['js', '--out', module]);
const { decode, plan, Receiver } = await import(pathToFileURL(module));

function linesOf(file) {
  return readFileSync(file, 'utf8').trim().split('\n');
}

function frameOf(line) {
  const [, id, hex] = /([0-9A-F]{3})#([0-9A-F]*)$/.exec(line);
  return [parseInt(id, 16), Uint8Array.from(Buffer.from(hex, 'hex'))];
}

function compare(name) {
  const receiver = new Receiver();
  const frames = linesOf(`${folder}/${name}.log`).map(frameOf);
  const expected = linesOf(`${folder}/${name}.jsonl`).map((line) => JSON.parse(line));
  assert.equal(frames.length, expected.length);
  const seen = new Set();
  frames.forEach(([id, data], i) => {
    const { status, ...content } = expected[i];
    seen.add(status);
    assert.deepEqual(decode(id, data), content, `${name}, line ${i + 1}`);
    assert.deepEqual(receiver.receive(id, data), { ...content, status }, `${name}, line ${i + 1}`);
  });
  console.log(`${name}: ${frames.length} frames, every value as sent: ${[...seen].sort()}`);
  return seen;
}

assert.ok(compare('clean').size === 3);
const kAll = 'initial ok ok_some_lost repeated unprotected wrong_crc wrong_sequence'.split(' ');
assert.deepEqual([...compare('faulty')].sort(), kAll);

// Frames that are none of the plan, and frames that must not be used.
for (const id of [0x000, 0x080, 0x180, 0x581, 0x801, 0x18da01f1]) {
  assert.equal(decode(id, new Uint8Array(8)), null);
}
assert.equal(decode(0x701, [5, 0]).error, 'wrong_length');
assert.equal(decode(0x701, [0x7f]).error, 'reserved_value');
assert.deepEqual(decode(0x701, [0x7f]).signals, {});
assert.deepEqual(decode(0x701, [5]).labels, { NmtState: 'operational' });
// Node 1, counter 0: the CRC of zeros with the data id 1 is 0x0e, as AUTOSAR publishes it.
assert.equal(decode(0x181, [0x0e, 0, 0, 0, 0, 0, 0, 0]).error, null);
assert.equal(decode(0x182, [0x0e, 0, 0, 0, 0, 0, 0, 0]).error, 'wrong_crc');
// Bit 63 of page TendonDamage has no meaning; its weight in the CRC over (0x30, 0 .. 0, 0x80, id) is
// known from trying all 256 values.
const errors = new Map();
for (let crc = 0; crc < 256; ++crc) {
  const { error } = decode(0x281, [crc, 0x30, 0, 0, 0, 0, 0, 0x80]);
  errors.set(error, (errors.get(error) ?? 0) + 1);
}
assert.deepEqual([...errors].sort(), [['reserved_bit', 1], ['wrong_crc', 255]]);
assert.equal(plan.length, 5);
assert.equal(plan.find((frame) => frame.name === 'LifeStatus').cycleMs, 100);
