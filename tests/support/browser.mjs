// Drives a headless Chromium through its DevTools protocol, over a pipe, without any package.
//
//   const browser = await Browser.open();     // null where there is no Chromium
//   const page = await browser.page(address, { width: 1280 });
//   await page.waitFor(() => document.title !== '');
//   await page.close(); await browser.close();
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const NAMES = ['chromium', 'chromium-browser', 'google-chrome'];
const FLAGS = [
  '--headless',
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-dev-shm-usage',
  '--enable-precise-memory-info',
  '--remote-debugging-pipe',
];
const PATIENCE_MS = 20000;

export const sleep = (time_ms) =>
  new Promise((resolve) => {
    setTimeout(resolve, time_ms);
  });

export class Browser {
  static async open() {
    const name = NAMES.find((one) => spawnSync('which', [one]).status === 0);
    return name ? new Browser(name) : null;
  }

  constructor(name) {
    this.folder = mkdtempSync(join(tmpdir(), 'browser-'));
    this.process = spawn(name, [...FLAGS, `--user-data-dir=${this.folder}`, 'about:blank'], {
      stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'],
    });
    this.ended = new Promise((resolve) => {
      this.process.on('exit', resolve);
    });
    this.waiting = new Map();
    this.listeners = [];
    this.last = 0;
    let rest = '';
    this.process.stdio[4].setEncoding('utf8').on('data', (text) => {
      const messages = (rest + text).split('\0');
      rest = messages.pop();
      messages.forEach((message) => this.hear(JSON.parse(message)));
    });
  }

  hear(message) {
    const { id, error, result } = message;
    if (id === undefined) {
      this.listeners.forEach((listener) => listener(message));
      return;
    }
    const { resolve, reject } = this.waiting.get(id);
    this.waiting.delete(id);
    if (error) {
      reject(new Error(error.message));
    } else {
      resolve(result);
    }
  }

  send(method, params = {}, sessionId = undefined) {
    this.last += 1;
    const id = this.last;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
    });
  }

  async page(address, look = {}) {
    const { targetId } = await this.send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await this.send('Target.attachToTarget', { targetId, flatten: true });
    const page = new Page(this, targetId, sessionId);
    await page.send('Page.enable');
    await page.send('Runtime.enable');
    await page.look(look);
    await page.open(address);
    return page;
  }

  async close() {
    await this.send('Browser.close').catch(() => {});
    await Promise.race([this.ended, sleep(5000)]);
    rmSync(this.folder, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}

class Page {
  constructor(browser, targetId, sessionId) {
    Object.assign(this, { browser, targetId, sessionId });
  }

  send(method, params) {
    return this.browser.send(method, params, this.sessionId);
  }

  async open(address) {
    const loaded = new Promise((resolve) => {
      const listener = ({ method, sessionId }) => {
        if (method === 'Page.domContentEventFired' && sessionId === this.sessionId) {
          this.browser.listeners.splice(this.browser.listeners.indexOf(listener), 1);
          resolve();
        }
      };
      this.browser.listeners.push(listener);
    });
    await this.send('Page.navigate', { url: address });
    await loaded;
  }

  reload() {
    return this.send('Page.reload');
  }

  async look({ width = 1280, height = 900, dark = false }) {
    await this.send('Emulation.setDeviceMetricsOverride', {
      width,
      height,
      deviceScaleFactor: 1,
      mobile: width < 500,
    });
    await this.send('Emulation.setEmulatedMedia', {
      features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }],
    });
  }

  /** What a function makes of JSON arguments in the page. */
  async evaluate(run, ...values) {
    const expression = `(${run})(...${JSON.stringify(values)})`;
    const { result, exceptionDetails: trouble } = await this.send('Runtime.evaluate', {
      expression,
      awaitPromise: true,
      returnByValue: true,
    });
    if (trouble) {
      throw new Error(trouble.exception?.description ?? trouble.text);
    }
    return result.value;
  }

  async waitFor(run, ...values) {
    const end_ms = Date.now() + PATIENCE_MS;
    while (!(await this.evaluate(run, ...values).catch(() => false))) {
      if (Date.now() > end_ms) {
        throw new Error(`waited in vain for ${run} with ${JSON.stringify(values)}`);
      }
      await sleep(30);
    }
  }

  async press(key, code = key) {
    const text = { Enter: '\r', '+': '+', 0: '0' }[key];
    const keys = { Enter: 13, Tab: 9, ArrowLeft: 37, ArrowRight: 39, Home: 36, End: 35, ' ': 32 };
    const event = { key, code, windowsVirtualKeyCode: keys[key] };
    await this.send('Input.dispatchKeyEvent', { type: 'keyDown', text, ...event });
    await this.send('Input.dispatchKeyEvent', { type: 'keyUp', ...event });
  }

  /** With the left button, between two points of the window. */
  async drag(from, to) {
    const mouse = (type, [x, y], buttons) =>
      this.send('Input.dispatchMouseEvent', { type, x, y, buttons, button: 'left', clickCount: 1 });
    await mouse('mouseMoved', from, 0);
    await mouse('mousePressed', from, 1);
    await mouse('mouseMoved', [(from[0] + to[0]) / 2, to[1]], 1);
    await mouse('mouseMoved', to, 1);
    await mouse('mouseReleased', to, 0);
  }

  /** Of the whole page, or of `height` pixels from `top`. */
  async screenshot(file, height = undefined, top = 0) {
    const { data } = await this.send('Page.captureScreenshot', {
      captureBeyondViewport: true,
      clip: await this.evaluate(
        (y, tall) => ({
          x: 0,
          y,
          scale: 1,
          width: document.documentElement.clientWidth,
          height: tall ?? document.documentElement.scrollHeight,
        }),
        top,
        height ?? null,
      ),
    });
    writeFileSync(file, Buffer.from(data, 'base64'));
  }

  close() {
    return this.browser.send('Target.closeTarget', { targetId: this.targetId });
  }
}
