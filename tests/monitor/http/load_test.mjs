// load_test.mjs LIVE_FEED FOLDER [SECONDS [FRAMES_A_SECOND [NODES]]]
// load_test.mjs LIVE_FEED FOLDER day [NODES]
//
// How much a flood of frames costs: the processor and memory of the server, which makes the frames as
// well, and the heap of a page that shows a node. Writes a line every five seconds. With `day`, the clock
// of the bus advances by a day within the 500 views that the page is sent, so that they share little.
import { mkdirSync, readFileSync } from 'node:fs';
import { Browser, sleep } from '../../support/browser.mjs';
import { LiveFeed } from './live_feed.mjs';

const [, , program, folder, kind = '60', ...rest] = process.argv;
const [seconds, rate, nodes] =
  kind === 'day' ? [100, 0, rest[0] ?? '20'] : [Number(kind), rest[0] ?? '10000', rest[1] ?? '20'];
const TICKS_A_SECOND = 100;
const STEP_S = 5;
const DAY_S = 86400;
const VIEWS = 500;

function processOf(pid) {
  const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ')[1].split(' ');
  const resident = /VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, 'utf8'))[1];
  return {
    processor_s: (Number(fields[11]) + Number(fields[12])) / TICKS_A_SECOND,
    memory_MiB: resident / 1024,
  };
}

mkdirSync(folder, { recursive: true });
const browser = await Browser.open();
const feed = await LiveFeed.start(program, `${folder}/load.log`, 0, nodes);
const page = await browser.page(`${feed.address}#node=1`);
await page.send('HeapProfiler.enable');

async function passDay() {
  for (let i = 0; i < VIEWS; i += 1) {
    const started_ms = Date.now();
    await feed.say(`pass ${DAY_S / VIEWS}`);
    await sleep(Math.max(0, 210 - (Date.now() - started_ms)));
  }
}

let running = true;
const answered = (kind === 'day' ? passDay() : feed.say(`flood ${seconds} ${rate}`)).then(() => {
  running = false;
});
const start_ms = Date.now();
let before = processOf(feed.process.pid);
console.log('time_s server_processor_percent server_memory_MiB page_heap_MiB shown');
for (let past_s = STEP_S; running; past_s += STEP_S) {
  await sleep(start_ms + 1000 * past_s - Date.now());
  const now = processOf(feed.process.pid);
  await page.send('HeapProfiler.collectGarbage');
  const { usedSize } = await page.send('Runtime.getHeapUsage');
  const shown = await page.evaluate(() => document.querySelector('#bus').textContent);
  console.log(
    past_s,
    ((100 * (now.processor_s - before.processor_s)) / STEP_S).toFixed(1),
    now.memory_MiB.toFixed(1),
    (usedSize / 2 ** 20).toFixed(1),
    shown,
  );
  before = now;
}
await answered;
const { error } = await page.evaluate(() => ({ error: document.documentElement.dataset.error }));
console.log(error ? `error of the page: ${error}` : 'no error in the page');
await feed.stop();
await browser.close();
process.exit(error ? 1 : 0);
