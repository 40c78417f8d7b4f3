/** The server-sent events of the monitor. The browser connects again by itself. */

const SILENCE_MS = 5000;
const AGAIN_MS = 3000;

/**
 * Calls whole(view), change({ patch, events }) and state(name) with "connecting", "live", "silent"
 * (connected, but the monitor gives no views) or "lost".
 */
export class Stream {
  constructor(handlers) {
    this.handlers = handlers;
    this.name = 'connecting';
    this.open();
  }

  open() {
    this.source = new EventSource('/events');
    this.source.addEventListener('whole', (event) => this.hear('whole', event));
    this.source.addEventListener('change', (event) => this.hear('change', event));
    this.source.addEventListener('error', () => this.fail());
  }

  hear(kind, event) {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.become('silent'), SILENCE_MS);
    this.handlers[kind](JSON.parse(event.data));
    this.become('live');
  }

  /** Where the server has refused, the browser gives up; so this tries again. */
  fail() {
    clearTimeout(this.timer);
    this.become('lost');
    if (this.source.readyState === EventSource.CLOSED) {
      setTimeout(() => this.open(), AGAIN_MS);
    }
  }

  become(name) {
    if (name !== this.name) {
      this.name = name;
      this.handlers.state(name);
    }
  }
}

/**
 * What a merge patch (RFC 7396) makes of a value. What does not change is shared with the old
 * value, which stays as it is.
 */
export function merged(target, patch) {
  if (patch === null || typeof patch !== 'object' || Array.isArray(patch)) {
    return patch;
  }
  const base =
    target !== null && typeof target === 'object' && !Array.isArray(target) ? target : {};
  const result = { ...base };
  for (const [key, value] of Object.entries(patch)) {
    if (value === null) {
      delete result[key];
    } else {
      result[key] = merged(base[key], value);
    }
  }
  return result;
}
