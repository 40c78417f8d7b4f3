// Runs monitor_live_feed and speaks with it.
import { spawn } from 'node:child_process';
import { createInterface } from 'node:readline';

export class LiveFeed {
  /** `kept_MiB`: of frames, where it is not as many as a monitor keeps. */
  static async start(program, log, port = 0, nodes = 8, kept_MiB = undefined) {
    const feed = new LiveFeed();
    const kept = kept_MiB === undefined ? [] : [kept_MiB];
    feed.process = spawn(program, [log, port, nodes, ...kept], { stdio: ['pipe', 'pipe', 'inherit'] });
    feed.lines = createInterface({ input: feed.process.stdout })[Symbol.asyncIterator]();
    feed.address = (await feed.lines.next()).value;
    feed.port = Number(new URL(feed.address).port);
    feed.log = log;
    return feed;
  }

  /** Gives a command and returns the time of the bus after it, in microseconds. */
  async say(command) {
    this.process.stdin.write(`${command}\n`);
    this.time_us = Number((await this.lines.next()).value);
    return this.time_us;
  }

  stop() {
    const ended = new Promise((resolve) => {
      this.process.on('exit', resolve);
    });
    this.process.kill('SIGKILL');
    return ended;
  }
}
