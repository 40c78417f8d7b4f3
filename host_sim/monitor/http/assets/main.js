import { hashOf, selectionOf } from './address.js';
import { byId, setAttribute, setText } from './dom.js';
import { FleetTable } from './fleet.js';
import { kept, PastViews } from './history.js';
import { NodeView } from './node.js';
import { momentText, wholeText } from './prose.js';
import { merged, Stream } from './stream.js';

const DRAW_MS = 150;

/** The page: what comes from the monitor, what the person at it has chosen, and what is shown. */
class Page {
  constructor() {
    this.past = new PastViews();
    this.connection = 'connecting';
    this.selection = selectionOf(location.hash);
    this.fleet = new FleetTable();
    this.node = new NodeView(() => this.draw());
    this.addControls();
    this.stream = new Stream({
      whole: (view) => this.hear(view, {}, true),
      change: ({ patch, events }) => this.hear(merged(this.live, patch), events, false),
      state: (name) => {
        this.connection = name;
        this.draw();
      },
    });
    this.draw();
  }

  hear(view, events, isWhole) {
    this.live = view;
    this.past.add(kept(view));
    if (isWhole) {
      this.node.load(this.selection.node, true);
    } else {
      this.node.hear(view, events);
    }
    this.draw();
  }

  addControls() {
    byId('pause').addEventListener('click', () => {
      this.go({ at: this.selection.at === undefined && this.live ? this.live.now_us : undefined });
    });
    byId('scrub').addEventListener('input', (event) => {
      const steps = this.steps();
      const index = Number(event.target.value);
      this.go({ at: index < steps.length - 1 ? steps[index] : undefined });
    });
    for (const input of document.querySelectorAll('#axes input')) {
      input.addEventListener('change', () => this.go({ axes: input.value }));
    }
    byId('skip').addEventListener('click', (event) => {
      event.preventDefault();
      byId('fleet-heading').focus();
    });
    window.addEventListener('hashchange', () => {
      const before = this.selection.node;
      this.selection = selectionOf(location.hash);
      this.draw();
      if (this.selection.node !== undefined && this.selection.node !== before) {
        byId('node-heading').focus();
      }
    });
  }

  /** Another selection instead of this one, without a step in the browser's history. */
  go(change) {
    this.selection = { ...this.selection, ...change };
    history.replaceState(null, '', hashOf(this.selection));
    this.draw();
  }

  /** The view to show: live, or that of the moment at which the page is paused. */
  shownView() {
    const { at } = this.selection;
    if (at === undefined) {
      return this.past.views.at(-1);
    }
    if (this.paused?.at !== at) {
      const index = this.past.before(at);
      this.paused = index >= 0 ? { at, view: this.past.views[index] } : undefined;
    }
    return this.paused ? this.paused.view : this.viewFromHistory(at);
  }

  /** The times the slider stands at: of what this page has seen, before it what the node has sent. */
  steps() {
    const seen = this.past.views.map(({ now_us }) => now_us);
    const earlier = this.node.history?.timesBefore(seen[0] ?? 0) ?? [];
    return [...earlier, ...seen];
  }

  viewFromHistory(at) {
    const { history } = this.node;
    return { now_us: at, partial: true, nodes: history ? { [history.node]: history.at(at) } : {} };
  }

  draw() {
    if (!this.timer) {
      this.timer = setTimeout(
        () => {
          this.timer = undefined;
          this.drawNow();
        },
        this.drawnOnce ? DRAW_MS : 0,
      );
    }
  }

  drawNow() {
    this.showConnection();
    if (!this.live) {
      return;
    }
    const { selection } = this;
    const paused = selection.at !== undefined;
    const cutOff = this.connection !== 'live' && !paused;
    document.documentElement.classList.toggle('cut-off', cutOff);
    const view = this.shownView();
    const isStale = (value) => Boolean(value) && (value.stale || cutOff);
    const shown = { view, isStale, selection };
    this.showMoment(view, paused);
    this.fleet.show(shown);
    if (selection.node === undefined) {
      this.node.leave();
    } else {
      this.node.load(selection.node);
      this.node.show(shown);
    }
    this.drawnOnce = true;
    document.documentElement.dataset.shown = String(view.now_us);
  }

  showMoment(view, paused) {
    const scrub = byId('scrub');
    const steps = this.steps();
    const last = Math.max(0, steps.length - 1);
    const { at } = this.selection;
    const index = paused ? Math.max(0, steps.findLastIndex((time_us) => time_us <= at)) : last;
    setAttribute(scrub, 'max', String(last));
    if (scrub.value !== String(index)) {
      scrub.value = String(index);
    }
    const text = `${paused ? 'PAUSED at ' : ''}${momentText(view.now_us)}`;
    setText(byId('moment'), text);
    setAttribute(scrub, 'aria-valuetext', text);
    setAttribute(byId('pause'), 'aria-pressed', String(paused));
    document.documentElement.classList.toggle('paused', paused);
  }

  /** In words, and only where they change, so that screen readers are not kept talking. */
  showConnection() {
    const { live } = this;
    const texts = {
      connecting: 'Connecting to the monitor.',
      live: 'Live.',
      silent: 'STALE: the monitor gives no news. All values are the last ones, not live.',
      lost: 'LOST: no connection to the monitor. All values are the last ones, not live.',
    };
    const troubles = [];
    if (live?.source_lost) {
      troubles.push(`BUS LOST: ${live.source}.`);
    }
    if (live?.bus_off) {
      troubles.push('BUS-OFF: the controller of the monitor is off the bus; no frames come.');
    }
    if (live?.source_ended) {
      troubles.push('The log is at its end.');
    }
    const element = byId('connection');
    setText(element, [texts[this.connection], ...troubles].join(' '));
    const bad =
      !['live', 'connecting'].includes(this.connection) || live?.source_lost || live?.bus_off;
    element.classList.toggle('bad', Boolean(bad));
    if (live) {
      setText(byId('title'), `Fleet on ${live.source}`);
      setText(
        byId('bus'),
        `${wholeText(live.frames)} frames, ${numberText(live.frames_per_s, 4)} per s, bus load ${numberText(live.bus_load_percent, 4)} %${this.connection === 'live' ? '' : ' (STALE)'}`,
      );
    }
  }
}

new Page();
