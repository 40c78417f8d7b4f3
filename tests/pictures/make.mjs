// make.mjs FOLDER REPORT DIAGNOSIS LIVE_FEED
//
// The pictures of the pages, into FOLDER: damage and life of a replay, and the tops of a diagnosis and
// of the live page of a made bus.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { LiveFeed } from '../monitor/http/live_feed.mjs';
import { Browser, sleep } from '../support/browser.mjs';

const SETTLE_MS = 1500;
const MARGIN = 12;
const [, , folder, report, diagnosis, program] = process.argv;
const scratch = mkdtempSync(join(tmpdir(), 'pictures-'));
const browser = await Browser.open();
if (!browser) {
  console.error('no Chromium found');
  process.exit(1);
}

/** Where the section of a heading begins and ends. */
const edges = (id) => {
  const box = document.getElementById(id).closest('section').getBoundingClientRect();
  return { top: box.top + window.scrollY, bottom: box.bottom + window.scrollY };
};

/** Of the top of a page, or of its sections from one to another. */
async function picture(name, address, { height, sections, until, width = 1000 }) {
  const page = await browser.page(address, { width, height: height ?? width });
  if (until) {
    await page.waitFor(until);
  }
  await sleep(SETTLE_MS);
  const file = join(folder, `${name}.png`);
  if (sections) {
    // As tall as the page, which has no scroll bar then, neither measured nor captured.
    await page.look({ width, height: await page.evaluate(() => document.documentElement.scrollHeight) });
    await sleep(SETTLE_MS);
    const { top } = await page.evaluate(edges, sections[0]);
    const { bottom } = await page.evaluate(edges, sections[1]);
    await page.screenshot(file, bottom - top + 2 * MARGIN, top - MARGIN);
  } else {
    await page.screenshot(file, height);
  }
  await page.close();
}

const fileAddress = (file) => pathToFileURL(resolve(file)).href;
let feed;
try {
  await picture('replay', fileAddress(report), { sections: ['trajectory-heading', 'life-heading'] });
  await picture('diagnosis', fileAddress(diagnosis), { height: 1000 });
  feed = await LiveFeed.start(program, join(scratch, 'feed.log'));
  for (const command of ['run 115', 'silent 5 1', 'corrupt 3 1', 'emergency 2 ff20', 'run 5']) {
    await feed.say(command);
  }
  await picture('live_page', `${feed.address}#node=2`, {
    height: 1000,
    until: () => document.querySelectorAll('#node canvas').length === 2,
  });
} finally {
  await feed?.stop();
  await browser.close();
  rmSync(scratch, { recursive: true, force: true });
}
