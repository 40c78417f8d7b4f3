// decode_log.mjs LOG DBC [MASK]
//
// Decodes a log of candump -L with a DBC file, by a third-party reader (candied, see
// toolchains/fetch_dbc_decoder.sh), and writes one JSON object for each line of the log:
//   {"time", "interface", "id", "name", "signals": {name: value}, "labels": {name: text}}
// `name` is null where the DBC file has no such frame. Signals of other pages than the one in the frame
// are left out. MASK, such as 0x780, is laid over identifiers before they are looked up.
//
// Exit status 77 where the reader is not installed, but 1 in CI.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

function fail(status, text) {
  console.error(`decode_log.mjs: ${text}`);
  process.exit(status);
}

function loadReader() {
  const fetch = fileURLToPath(new URL('../../toolchains/fetch_dbc_decoder.sh', import.meta.url));
  const folder =
    process.env.TENDONLIFE_DBC_DECODER ??
    execFileSync(fetch, ['--folder'], { encoding: 'utf8' }).trim();
  const file = `${folder}/index.cjs.js`;
  if (!existsSync(file)) {
    const [status, word] = process.env.CI ? [1, 'FAILED'] : [77, 'SKIPPED'];
    fail(status, `${word}: no DBC reader in ${folder}; run ${fetch}`);
  }
  return createRequire(import.meta.url)(file);
}

const kLine = /^\((\d+\.\d{6})\) (\S+) ([0-9A-Fa-f]{3}|[0-9A-Fa-f]{8})#((?:[0-9A-Fa-f]{2}){0,8})(?: [RT])?$/;
const kOtherLine = /^(#|\(\d+\.\d{6}\) \S+ [0-9A-Fa-f]+#[#R])/;
const kExtended = 0x80000000;

function parse(line, place) {
  const match = kLine.exec(line);
  if (!match) {
    if (kOtherLine.test(line)) {
      return null;
    }
    fail(1, `${place}: not a line of candump -L: ${JSON.stringify(line)}`);
  }
  const [, time, interfaceName, id, hex] = match;
  const extended = id.length === 8;
  return {
    time: Number(time),
    interface: interfaceName,
    id: (parseInt(id, 16) + (extended ? kExtended : 0)) >>> 0,
    extended,
    payload: [...Buffer.from(hex, 'hex')],
  };
}

/** Only the signals of the page that the frame carries. */
function present(message) {
  const all = [...message.boundSignals];
  const multiplexor = all.find(([, bound]) => bound.boundData.signal.multiplexer);
  const page = multiplexor && `m${multiplexor[1].rawValue}`;
  return all.filter(([, bound]) => {
    const { multiplex, multiplexer } = bound.boundData.signal;
    return !multiplex || multiplexer || multiplex === page;
  });
}

function decode(can, frame, mask) {
  const { time, extended, payload } = frame;
  const id = extended ? frame.id : frame.id & mask;
  const message = can.decode({ id, dlc: payload.length, isExtended: extended, payload });
  const result = { time, interface: frame.interface, id: frame.id, name: message?.name ?? null };
  result.signals = {};
  result.labels = {};
  for (const [name, bound] of message ? present(message) : []) {
    result.signals[name] = bound.value;
    const label = bound.boundData.signal.valueTable?.get(bound.rawValue);
    if (label !== undefined) {
      result.labels[name] = label;
    }
  }
  return result;
}

const [log, dbcFile, mask = '0x7ff'] = process.argv.slice(2);
if (!dbcFile) {
  fail(2, 'usage: decode_log.mjs LOG DBC [MASK]');
}
const { Can, Dbc } = loadReader();
const dbc = new Dbc();
const can = new Can();
can.database = dbc.load(readFileSync(dbcFile, 'utf8'), true);
const lines = readFileSync(log, 'utf8').split(/\r?\n/);
lines.forEach((line, i) => {
  const frame = line === '' && i === lines.length - 1 ? null : parse(line, `${log}:${i + 1}`);
  if (frame) {
    console.log(JSON.stringify(decode(can, frame, Number(mask))));
  }
});
