// decode_log_test.mjs GENERATE FOLDER: what decode_log.mjs does with lines that are not plain frames.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const [generate, folder] = process.argv.slice(2);
const decodeLog = fileURLToPath(new URL('decode_log.mjs', import.meta.url));
const log = `${folder}/special.log`;
const dbc = `${folder}/special.dbc`;

function run(text, environment = {}) {
  writeFileSync(log, text);
  const env = { ...process.env, ...environment };
  return spawnSync(process.execPath, [decodeLog, log, dbc], { encoding: 'utf8', env });
}

mkdirSync(folder, { recursive: true });
execFileSync(generate, ['dbc', '--nodes', '1', '--out', dbc]);

const absent = { TENDONLIFE_DBC_DECODER: '/nowhere' };
assert.equal(run('', { ...absent, CI: '' }).status, 77);
assert.match(run('', { ...absent, CI: '' }).stderr, /SKIPPED: no DBC reader in \/nowhere/);
assert.equal(run('', { ...absent, CI: 'true' }).status, 1);

const good = run(
  [
    '# a comment',
    '(1700000000.000001) vcan0 701#05 R',
    '(1700000000.000002) vcan0 123#00',
    '(1700000000.000003) vcan0 18DA01F1#021001',
    '(1700000000.000004) vcan0 00000701#05',
    '(1700000000.000005) vcan0 701#R1',
    '(1700000000.000006) vcan0 701##005',
    '',
  ].join('\n'),
);
process.stderr.write(good.stderr);
if (good.status === 77) {
  process.exit(77);
}
assert.equal(good.status, 0);
const [heartbeat, ...others] = good.stdout.trim().split('\n').map((line) => JSON.parse(line));
assert.deepEqual(heartbeat, {
  time: 1700000000.000001,
  interface: 'vcan0',
  id: 0x701,
  name: 'Heartbeat_1',
  signals: { NmtState: 5 },
  labels: { NmtState: 'operational' },
});
assert.deepEqual(others.map((frame) => [frame.id, frame.name]), [
  [0x123, null],
  [0x98da01f1, null],
  [0x80000701, null],
]);

const bad = run('(1700000000.000001) vcan0 701#05\n(1700000000.000002) vcan0 701#5\n');
assert.equal(bad.status, 1);
assert.match(bad.stderr, /special\.log:2: not a line of candump -L: "\(1700000000\.000002\) vcan0 701#5"/);
