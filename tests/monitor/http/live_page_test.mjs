// live_page_test.mjs LIVE_FEED DECODER FOLDER
//
// The live page in headless Chromium, fed by a made log at full speed. Exit status 77 without
// Chromium. With SHOTS set to a folder, pictures of the page are kept there.
import { mkdirSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { Browser, sleep } from '../../support/browser.mjs';
import { faintTexts, nameless, smallTargets } from './access.mjs';
import { compareFleet, compareNode, Problems } from './compare.mjs';
import { decodedLog } from './decoded_log.mjs';
import { LiveFeed } from './live_feed.mjs';
import { shownFleet, shownNode, shownOrder, shownPage } from './shown.mjs';

const [, , program, decoderFile, folder] = process.argv;
const decoder = await import(pathToFileURL(decoderFile));
mkdirSync(folder, { recursive: true });
const browser = await Browser.open();
if (!browser) {
  console.error('SKIPPED: no Chromium found, the live page was NOT tried in a browser');
  process.exit(77);
}

const problems = new Problems();
const log = `${folder}/feed.log`;
let feed = await LiveFeed.start(program, log);
const page = await browser.page(`${feed.address}`);

const settle = (time_us = feed.time_us) =>
  page.waitFor((wanted) => Number(document.documentElement.dataset.shown) === wanted, time_us);
const openNode = async (number) => {
  await page.evaluate((wanted) => {
    window.location.hash = `#node=${wanted}`;
  }, number);
  await page.waitFor(
    (wanted) =>
      document.querySelector('#node-heading').innerText === `Node ${wanted}`
      && document.querySelectorAll('#node canvas').length === 2,
    number,
  );
};
const decoded = (until_us) => decodedLog(log, decoder, until_us);
const textOf = (id) => page.evaluate((wanted) => document.getElementById(wanted).innerText, id);
const press = (id) => page.evaluate((wanted) => document.getElementById(wanted).click(), id);

async function everyValueEqualsTheLog() {
  await feed.say('run 120');
  await settle();
  const wanted = decoded();
  compareFleet(await page.evaluate(shownFleet), wanted, problems);
  for (const number of Object.keys(wanted.nodes)) {
    await openNode(number);
    compareNode(await page.evaluate(shownNode), number, wanted, problems);
  }
  const { connection, title } = await page.evaluate(shownPage);
  problems.same('connection', connection, 'Live.');
  problems.same('title', title, 'Fleet on can0');
  const lost = Object.values(await page.evaluate(shownFleet)).map(({ Lost }) => Lost.text);
  problems.same('nothing was lost', lost.join(), '0,0,0,0,0,0,0,0');
}

async function troublesAreShown() {
  await feed.say('corrupt 3 1');
  await feed.say('silent 5 1');
  await feed.say('emergency 2 ff20');
  await feed.say('run 5');
  await settle();
  const wanted = decoded();
  const fleet = await page.evaluate(shownFleet);
  compareFleet(fleet, wanted, problems);
  problems.expect('damaged node is stale', fleet[3].Damage.stale && fleet[3].State.stale);
  problems.expect('its failures are counted', wanted.nodes[3].counts.LifeStatus.damaged === 50);
  problems.expect(
    'vanished node',
    fleet[5].State.text.includes('VANISHED') && fleet[5].Damage.stale && fleet[5].Heartbeat.stale,
  );
  problems.expect('emergency', fleet[2].State.text.includes('EMERGENCY: overload'));
  problems.expect(
    'others are fresh',
    !fleet[1].Damage.stale && !fleet[1].State.text.includes('VANISHED'),
  );
  await openNode(2);
  const events = (await page.evaluate(shownNode)).events.join('\n');
  problems.expect('emergency in the timeline', events.includes('EMERGENCY: overload'));
  await openNode(5);
  const gone = await page.evaluate(shownNode);
  problems.expect('vanished in words', gone.note.startsWith('VANISHED'));
  const { end, width } = await page.evaluate(() => {
    const { x, width: length } = [...document.querySelectorAll('#timeline rect')].at(-1);
    return {
      end: x.baseVal.value + length.baseVal.value,
      width: document.querySelector('#timeline svg').clientWidth,
    };
  });
  problems.expect(`its strip ends at ${end} of ${width}`, end < width - 12);
  problems.same('the gravest first', (await page.evaluate(shownOrder)).slice(0, 2).join(), '2,5');
  problems.expect(
    'tiles of a vanished node are stale',
    gone.tiles.Damage.stale && gone.tiles['Bus load'].stale === false,
  );
  await feed.say('bus-off 1');
  await settle();
  await page.waitFor(() => document.querySelector('#connection').innerText.includes('BUS-OFF'));
  await feed.say('bus-off 0');
  await page.waitFor(() => !document.querySelector('#connection').innerText.includes('BUS-OFF'));
  await feed.say('source lost');
  await page.waitFor(() =>
    document.querySelector('#connection').innerText.includes('BUS LOST: can0 is down'),
  );
  await feed.say('source running');
  await feed.say('silent 5 0');
  await feed.say('corrupt 3 0');
  await feed.say('emergency 2 0');
  await feed.say('run 2');
  await settle();
  await page.waitFor(() => document.querySelector('#connection').innerText === 'Live.');
  const back = await page.evaluate(shownFleet);
  problems.expect(
    'all are back',
    !back[5].State.text.includes('VANISHED')
      && !back[3].Damage.stale
      && !back[2].State.text.includes('EMERGENCY'),
  );
}

async function pauseAndScrub() {
  await openNode(1);
  await page.evaluate(() => document.getElementById('pause').focus());
  await page.press('Enter');
  await page.waitFor(() => document.querySelector('#moment').innerText.startsWith('PAUSED'));
  const { shown_us: paused_us, connection, title } = await page.evaluate(shownPage);
  problems.expect('paused is not live', connection.startsWith('PAUSED:'));
  problems.same('title while paused', title, 'PAUSED: Fleet on can0');
  problems.same('what the button does', await textOf('pause'), 'Go on');
  const before = JSON.stringify(await page.evaluate(shownNode));
  for (let i = 0; i < 4; i += 1) {
    await feed.say('run 3');
    await sleep(400);
  }
  problems.same(
    'nothing moves while paused',
    JSON.stringify(await page.evaluate(shownNode)),
    before,
  );
  compareNode(await page.evaluate(shownNode), '1', decoded(paused_us), problems);

  await page.evaluate(() => document.getElementById('scrub').focus());
  await page.press('End');
  await page.waitFor(() => !document.querySelector('#moment').innerText.startsWith('PAUSED'));
  await page.press('ArrowLeft');
  await page.press('ArrowLeft');
  await page.waitFor(
    (last_us) =>
      document.querySelector('#moment').innerText.startsWith('PAUSED')
      && Number(document.documentElement.dataset.shown) < last_us,
    feed.time_us,
  );
  const { shown_us } = await page.evaluate(shownPage);
  problems.expect('scrubbed to a moment between', shown_us > paused_us && shown_us < feed.time_us);
  await sleep(400);
  compareNode(await page.evaluate(shownNode), '1', decoded(shown_us), problems);
  compareFleet(await page.evaluate(shownFleet), decoded(shown_us), problems);
  return shown_us;
}

async function reloadKeepsThePlace(shown_us) {
  await page.evaluate(() => document.querySelector('#axes input[value=log]').click());
  await page.reload();
  await sleep(500);
  await page.waitFor(() => document.querySelectorAll('#node canvas').length === 2);
  const after = await page.evaluate(shownPage);
  problems.expect('still paused after a reload', after.moment.startsWith('PAUSED'));
  problems.same('the same moment', after.shown_us, shown_us);
  problems.expect(
    'the same axes',
    await page.evaluate(() => document.querySelector('#axes input[value=log]').checked),
  );
  await page.waitFor(() => document.querySelector('#node-note').innerText.includes('From the record'));
  compareNode(await page.evaluate(shownNode), '1', decoded(shown_us + 1), problems);
  await press('pause');
  await settle();
  problems.same('live again', (await page.evaluate(shownPage)).connection, 'Live.');
}

const steps = async (key, count) => {
  for (let i = 0; i < count; i += 1) {
    await page.press(key);
  }
  await page.waitFor(() => {
    const at = new URLSearchParams(window.location.hash.slice(1)).get('at');
    return at !== null && at === document.documentElement.dataset.shown;
  });
  await page.waitFor(() => !/being read/.test(document.querySelector('#fleet-note').innerText));
};
const noNumbers = ({ tiles }) =>
  Object.values(tiles)
    .flatMap((tile) => [tile.text, tile.note])
    .filter((text) => /NaN|undefined/.test(text))
    .join();

async function scrubsBackBeforeItWasOpened() {
  const opened_us = feed.time_us;
  await page.reload();
  await page.waitFor(() => document.querySelectorAll('#node canvas').length === 2);
  await page.evaluate(() => document.getElementById('scrub').focus());
  await steps('Home', 1);
  const first = await page.evaluate(shownNode);
  problems.same('before it nothing was sent', noNumbers(first), '');
  problems.same('and it is said', first.note, 'Of this node nothing is known at this moment.');
  problems.same('the fleet is whole', Object.keys(await page.evaluate(shownFleet)).length, 8);
  problems.same('no damage', first.tiles.Damage.text, 'not known');
  await steps('ArrowRight', 13);
  const { shown_us, moment } = await page.evaluate(shownPage);
  problems.expect('long before the page was opened', shown_us < opened_us - 20e6);
  problems.expect('with its time zone', / UTC([+−]\d+(:\d+)?)?$/.test(moment));
  const shown = await page.evaluate(shownNode);
  problems.expect('said in words', shown.note.includes('From the record: what was sent since'));
  problems.same('no NaN', noNumbers(shown), '');
  compareNode(shown, '1', decoded(shown_us + 1), problems);
  compareFleet(await page.evaluate(shownFleet), decoded(shown_us + 1), problems);
  await page.press('End');
  await page.waitFor(() => !document.querySelector('#moment').innerText.startsWith('PAUSED'));
}

const chartLabel = () =>
  page.evaluate(() => document.querySelector('#damage-chart canvas').getAttribute('aria-label'));
const isZoomed = (wanted) =>
  page.waitFor(
    (zoomed) =>
      /zoomed to/.test(document.querySelector('#damage-chart canvas').getAttribute('aria-label'))
      === zoomed,
    wanted,
  );

async function chartsZoomByDragging() {
  const box = await page.evaluate(() => {
    const over = document.querySelector('#damage-chart .u-over');
    over.scrollIntoView({ block: 'center' });
    const { left, top, width, height } = over.getBoundingClientRect();
    return { left, top, width, height };
  });
  const at = (share) => [box.left + share * box.width, box.top + box.height / 2];
  await page.drag(at(0.25), at(0.5));
  await feed.say('run 1');
  await isZoomed(true);
  const [zoomed] = /zoomed to.*/.exec(await chartLabel());
  for (let i = 0; i < 3; i += 1) {
    await feed.say('run 2');
    await sleep(700);
  }
  problems.same('the view stays while more comes', /zoomed to.*/.exec(await chartLabel())[0], zoomed);
  await page.evaluate(() => document.querySelector('#damage-chart .chart').focus());
  await page.press('0');
  await isZoomed(false);
}

async function theEndOfALogIsSaid() {
  await feed.say('source ended');
  await page.waitFor(() => document.querySelector('#connection').innerText.startsWith('END:'));
  problems.same('title', (await page.evaluate(shownPage)).title, 'END: Fleet on can0');
  await feed.say('source running');
  await page.waitFor(() => document.querySelector('#connection').innerText === 'Live.');
}

/** Tab until the element of a selector has the focus; where one with the focus is drawn anew, Tab begins at the top. */
async function tabTo(selector) {
  await page.waitFor((wanted) => document.querySelector(wanted)?.checkVisibility(), selector);
  for (let i = 0; i < 200; i += 1) {
    await page.press('Tab');
    const there = await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector);
    if (there) {
      return;
    }
  }
  problems.expect(`Tab reaches ${selector}`, false);
}

async function worksByKeyboardAlone() {
  await page.evaluate(() => {
    window.location.hash = '';
    document.activeElement.blur();
    window.scrollTo(0, 0);
  });
  await page.waitFor(() => document.getElementById('node').hidden);
  for (const selector of ['#skip', '#pause', '#scrub', '#export-all', '#order']) {
    await tabTo(selector);
  }
  await page.press('ArrowDown');
  await page.waitFor(() => document.querySelector('#fleet tbody tr').dataset.node === '1');
  problems.same('by node', (await page.evaluate(shownOrder)).join(), '1,2,3,4,5,6,7,8');
  await tabTo('[data-node="3"] a');
  await page.press('Enter');
  await page.waitFor(() => document.activeElement.id === 'node-heading');
  problems.same('opened', (await page.evaluate(shownNode)).heading, 'Node 3');
  await page.waitFor(() => document.querySelectorAll('#node canvas').length === 2);
  await tabTo('#damage-chart .chart');
  await page.press('+');
  await feed.say('run 2');
  await isZoomed(true);
  await page.press('0');
  await isZoomed(false);
  await page.evaluate(() => document.getElementById('close-node').focus());
  await page.press('Enter');
  await page.waitFor(() => document.activeElement.matches('[data-node="3"] a'));
}

async function theDetailComesIntoViewOnAPhone() {
  await page.look({ width: 390, height: 800 });
  await page.evaluate(() => window.scrollTo(0, 0));
  for (const number of ['3', '3', '7']) {
    await page.evaluate((wanted) => document.querySelector(`[data-node="${wanted}"] a`).click(), number);
    await page.waitFor((wanted) => {
      const bar = document.querySelector('.moments').getBoundingClientRect();
      const { top, bottom } = document.getElementById('node-heading').getBoundingClientRect();
      const shown = document.getElementById('node-heading').innerText === `Node ${wanted}`;
      return shown && top >= bar.bottom && bottom < window.innerHeight / 2;
    }, number);
    await page.evaluate(() => window.scrollTo(0, 0));
  }
  await page.look({});
}

async function exportsWork() {
  const links = await page.evaluate(async () => {
    const read = async (id) => (await fetch(document.getElementById(id).href)).text();
    return {
      csv: await read('export-csv'),
      candump: await read('export-candump'),
      all: await read('export-all'),
    };
  });
  const { lines, nodes } = decoded();
  const ofNode = lines.filter(
    (line) => (parseInt(line.split(' ')[2].split('#')[0], 16) & 0x7f) === 1,
  );
  problems.expect('candump of a node', links.candump === `${ofNode.join('\n')}\n`);
  problems.expect('candump of all', links.all === `${lines.join('\n')}\n`);
  const rows = links.csv.trim().split('\n');
  problems.same('columns of the CSV', rows[0], 'time_s,damage,damage_rate_per_h');
  const [time_s, damage] = rows.at(-1).split(',').map(Number);
  problems.same('last time of the CSV', time_s, nodes[1].messages.LifeStatus.time_us / 1e6);
  problems.expect('last damage of the CSV', Math.abs(damage - nodes[1].damage) < 1e-12);
  problems.expect('rows of the CSV', rows.length > 1000);
}

async function lostServerIsShown() {
  const { port } = feed;
  await feed.stop();
  await page.waitFor(() => document.querySelector('#connection').innerText.startsWith('LOST'));
  await page.waitFor(() => document.querySelectorAll('#fleet .stale').length > 0);
  const fleet = await page.evaluate(shownFleet);
  problems.expect(
    'all is stale without a server',
    Object.values(fleet).every((row) => Object.values(row).every(({ stale }) => stale)),
  );
  const { tiles } = await page.evaluate(shownNode);
  problems.expect(
    'and so is each tile',
    Object.values(tiles).every(({ stale }) => stale),
  );
  feed = await LiveFeed.start(program, log, port);
  await feed.say('run 30');
  await settle();
  const again = decoded();
  compareFleet(await page.evaluate(shownFleet), again, problems);
  await page.waitFor(() => document.querySelector('#connection').innerText === 'Live.');
  problems.expect('live after a restart', !(await page.evaluate(shownFleet))[1].Damage.stale);
}

async function saysWhatIsGone() {
  problems.same('nothing is gone yet', await textOf('gone'), '');
  const { port } = feed;
  await feed.stop();
  feed = await LiveFeed.start(program, log, port, 8, 1);
  await feed.say('run 400');
  await page.reload();
  await settle();
  problems.same('not while it is live', await textOf('gone'), '');
  await page.waitFor(() => document.getElementById('scrub').max > 100);
  await press('pause');
  await page.waitFor(() => document.getElementById('gone').innerText !== '');
  problems.expect(
    `'${await textOf('gone')}' says why`,
    /^Frames before .* are gone: without --record the newest 1 MiB are kept\./.test(await textOf('gone')),
  );
  problems.same('it fits', (await page.evaluate(shownPage)).overhang, 0);
  if (process.env.SHOTS) {
    await page.screenshot(`${process.env.SHOTS}/gone.png`, 500);
    await page.look({ width: 360 });
    await page.screenshot(`${process.env.SHOTS}/gone-360.png`, 700);
    await page.look({});
  }
  await press('pause');
  await settle();
}

async function canBeUsedByAll() {
  await feed.say('emergency 2 ff20');
  await feed.say('silent 5 1');
  await feed.say('corrupt 3 1');
  await feed.say('run 6');
  await openNode(2);
  await settle();
  const { events } = await page.evaluate(shownNode);
  problems.expect('what came while the history did', events.join().includes('EMERGENCY: overload'));
  for (const width of [1280, 360]) {
    for (const dark of [false, true]) {
      await page.look({ width, dark });
      await sleep(1300);
      const name = `${width}-${dark ? 'dark' : 'light'}`;
      problems.same(`faint texts, ${name}`, (await page.evaluate(faintTexts)).join(), '');
      problems.same(`small targets, ${name}`, (await page.evaluate(smallTargets)).join(), '');
      problems.same(`overhang, ${name}`, (await page.evaluate(shownPage)).overhang, 0);
      if (process.env.SHOTS) {
        await page.screenshot(`${process.env.SHOTS}/live-${name}.png`);
      }
    }
  }
  problems.same('nameless elements', (await nameless(page)).join(), '');
}

try {
  await everyValueEqualsTheLog();
  await troublesAreShown();
  await reloadKeepsThePlace(await pauseAndScrub());
  await scrubsBackBeforeItWasOpened();
  await chartsZoomByDragging();
  await theEndOfALogIsSaid();
  await exportsWork();
  await worksByKeyboardAlone();
  await theDetailComesIntoViewOnAPhone();
  await lostServerIsShown();
  await saysWhatIsGone();
  await canBeUsedByAll();
  problems.same('errors of the page', (await page.evaluate(shownPage)).error, undefined);
} catch (error) {
  problems.expect(error.stack, false);
} finally {
  await feed.stop();
  await browser.close();
}
console.log(`${problems.checks} checks, ${problems.list.length} failed`);
process.exit(problems.list.length > 0 ? 1 : 0);
