// compare_dbc.mjs LOG EXPECTED GENERATE FOLDER
//
// A third-party reader with the generated DBC files has to say of every frame of LOG what EXPECTED
// says: exactly, values and names, with exact identifiers and with the template.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const [log, expectedFile, generate, folder] = process.argv.slice(2);
const decodeLog = fileURLToPath(new URL('decode_log.mjs', import.meta.url));
const kOfTheFrame = new Set(['Crc', 'Counter', 'Page']);

function linesOf(text) {
  return text.trim().split('\n').map((line) => JSON.parse(line));
}

function decoded(dbc, ...mask) {
  const run = spawnSync(process.execPath, [decodeLog, log, dbc, ...mask], {
    encoding: 'utf8',
    maxBuffer: 2 ** 28,
  });
  process.stderr.write(run.stderr);
  if (run.status !== 0) {
    process.exit(run.status ?? 1);
  }
  return linesOf(run.stdout);
}

function withoutFrame(values) {
  return Object.fromEntries(Object.entries(values).filter(([name]) => !kOfTheFrame.has(name)));
}

function compare(found, expected, nameOf) {
  assert.equal(found.length, expected.length);
  found.forEach((frame, i) => {
    const wanted = expected[i];
    assert.equal(frame.name, nameOf(wanted), `line ${i + 1}`);
    assert.deepEqual(withoutFrame(frame.signals), wanted.signals, `line ${i + 1}`);
    assert.deepEqual(withoutFrame(frame.labels), wanted.labels, `line ${i + 1}`);
    assert.equal(frame.labels.Page ?? null, wanted.page, `line ${i + 1}`);
  });
}

mkdirSync(folder, { recursive: true });
const expected = linesOf(readFileSync(expectedFile, 'utf8'));
assert.ok(expected.length > 1000);

const exact = `${folder}/nodes.dbc`;
execFileSync(generate, ['dbc', '--nodes', '1,7,127', '--out', exact]);
compare(decoded(exact), expected, (wanted) => `${wanted.name}_${wanted.node}`);

const template = `${folder}/template.dbc`;
execFileSync(generate, ['dbc', '--template', '--out', template]);
compare(decoded(template, '0x780'), expected, (wanted) => wanted.name);
console.log(`${expected.length} frames, twice: every value as sent`);
