// decode.mjs LOG DAMAGE_PPB_FILE PROTOCOL_GENERATE
//
// What the image has said, read by a third party with the DBC file of its node: every frame has a name, and
// the last status the damage that the host has counted. Exit status 77 where the reader is not installed.
import { execFileSync, spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const [log, damageFile, generate] = process.argv.slice(2);
const dbc = `${log}.dbc`;
writeFileSync(dbc, execFileSync(generate, ['dbc', '--nodes', '5']));
const decoder = fileURLToPath(new URL('../protocol/decode_log.mjs', import.meta.url));
const run = spawnSync(process.execPath, [decoder, log, dbc], { encoding: 'utf8', maxBuffer: 1 << 28 });
if (run.status !== 0) {
  process.stderr.write(run.stderr);
  process.exit(run.status);
}

const frames = run.stdout.trim().split('\n').map((line) => JSON.parse(line));
const nameless = frames.filter((frame) => frame.name === null && frame.id !== '18DAF105');
const statuses = frames.filter((frame) => frame.name?.startsWith('LifeStatus'));
const expected_ppb = Number(readFileSync(damageFile, 'utf8'));
const last = statuses.at(-1)?.signals ?? {};
const damage = Object.entries(last).find(([name]) => name.endsWith('Damage'))?.[1];
console.log(`${frames.length} frames, damage ${damage}, host ${expected_ppb} ppb`);
if (frames.length < 30 || nameless.length !== 0 || Math.round(damage * 1e9) !== expected_ppb) {
  console.error('differs', nameless.slice(0, 3), frames.slice(-2), last);
  process.exit(1);
}
