import { hashOf, selectionOf } from './address.js';
import { byId, setAttribute, setText } from './dom.js';
import { FleetTable } from './fleet.js';
import { Moments, withAllNodes } from './moments.js';
import { NodeView } from './node.js';
import { goneText, momentText, percentText, wholeText, zoneText } from './prose.js';
import { merged, Stream } from './stream.js';

const DRAW_MS = 150;

/** The page: what comes from the monitor, what the person at it has chosen, and what is shown. */
class Page {
  constructor() {
    this.moments = new Moments(() => this.draw());
    this.connection = 'connecting';
    this.selection = selectionOf(location.hash);
    this.fleet = new FleetTable();
    this.node = new NodeView(() => this.draw());
    this.addControls();
    this.keepTheBarClear();
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
    this.moments.add(view);
    if (isWhole || (this.selection.at === undefined && this.moments.isOld())) {
      this.moments.look();
    }
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
      const steps = this.moments.steps();
      const index = Number(event.target.value);
      this.go({ at: index < steps.length - 1 ? steps[index] : undefined });
    });
    byId('order').addEventListener('change', (event) => this.go({ order: event.target.value }));
    byId('fleet').addEventListener('click', (event) => {
      if (event.target.closest('a')) {
        this.goal = byId('node-heading');
        this.draw();
      }
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
      const { node } = this.selection;
      if (node !== before) {
        this.goal = node === undefined ? this.fleet.linkOf(before) : byId('node-heading');
      }
      this.draw();
    });
  }

  /** What is scrolled to, or gets the focus, stands below the bar that stays at the top. */
  keepTheBarClear() {
    const bar = document.querySelector('.moments');
    new ResizeObserver(() => {
      document.documentElement.style.scrollPaddingTop = `${bar.offsetHeight + 8}px`;
    }).observe(bar);
  }

  /** Focus and view go to what was chosen, once it is shown. */
  reachGoal() {
    this.goal?.focus({ preventScroll: true });
    this.goal?.scrollIntoView({ block: this.goal.id === 'node-heading' ? 'start' : 'nearest' });
    this.goal = undefined;
  }

  /** Another selection instead of this one, without a step in the browser's history. */
  go(change) {
    this.selection = { ...this.selection, ...change };
    history.replaceState(null, '', hashOf(this.selection));
    this.draw();
  }

  /** The view to show: live, or that of the moment at which the page is paused. */
  shownView() {
    const { at, node } = this.selection;
    const view = at === undefined ? this.moments.newest() : this.moments.viewAt(at, node);
    return withAllNodes(view, this.live);
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
    const { selection } = this;
    const paused = selection.at !== undefined;
    this.showConnection(paused);
    if (!this.live) {
      return;
    }
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
    this.reachGoal();
    this.drawnOnce = true;
    document.documentElement.dataset.shown = String(view.now_us);
  }

  showMoment(view, paused) {
    const scrub = byId('scrub');
    const steps = this.moments.steps();
    const last = Math.max(0, steps.length - 1);
    const { at } = this.selection;
    const index = paused ? Math.max(0, steps.findLastIndex((time_us) => time_us <= at)) : last;
    setAttribute(scrub, 'max', String(last));
    if (scrub.value !== String(index)) {
      scrub.value = String(index);
    }
    const moment = `${momentText(view.now_us)} ${zoneText(view.now_us)}`.trim();
    const text = `${paused ? 'PAUSED at ' : ''}${moment}`;
    setText(byId('moment'), text);
    setAttribute(scrub, 'aria-valuetext', text);
    const goOn = this.live.source_ended ? 'To the end' : 'Go on';
    setText(byId('pause'), paused ? goOn : 'Pause');
    setText(byId('gone'), paused ? goneText(this.moments.gone) : '');
    document.documentElement.classList.toggle('paused', paused);
  }

  /** What is shown in a word, and in words. */
  connectionTexts(paused) {
    if (this.connection === 'live' && paused) {
      return ['PAUSED', 'a moment of the past is shown, while the monitor goes on.'];
    }
    if (this.connection === 'live' && this.live?.source_ended) {
      return ['END', 'the log is at its end, and its last moment is shown.'];
    }
    return {
      connecting: ['Connecting', 'to the monitor.'],
      live: ['Live', ''],
      silent: ['STALE', 'the monitor gives no news. All values are the last ones, not live.'],
      lost: ['LOST', 'no connection to the monitor. All values are the last ones, not live.'],
    }[this.connection];
  }

  /** Only where the words change, so that screen readers are not kept talking. */
  showConnection(paused) {
    const { live } = this;
    const troubles = [];
    if (live?.source_lost) {
      troubles.push(`BUS LOST: ${live.source}.`);
    }
    if (live?.bus_off) {
      troubles.push('BUS-OFF: the controller of the monitor is off the bus; no frames come.');
    }
    if (live?.source_ended && paused) {
      troubles.push('The log is at its end.');
    }
    const element = byId('connection');
    const [word, words] = this.connectionTexts(paused);
    const first = words ? `${word}${this.connection === 'connecting' ? '' : ':'} ${words}` : `${word}.`;
    setText(element, [first, ...troubles].join(' '));
    const bad =
      !['live', 'connecting'].includes(this.connection) || live?.source_lost || live?.bus_off;
    element.classList.toggle('bad', Boolean(bad));
    element.classList.toggle('still', ['PAUSED', 'END'].includes(word));
    if (live) {
      const title = `Fleet on ${live.source}`;
      setText(byId('title'), title);
      document.title = word === 'Live' ? title : `${word}: ${title}`;
      setText(
        byId('bus'),
        `${wholeText(live.frames)} frames, ${numberText(live.frames_per_s, 4)} per s, bus load ${percentText(live.bus_load_percent / 100, 4)}${this.connection === 'live' ? '' : ' (STALE)'}`,
      );
    }
  }
}

new Page();
