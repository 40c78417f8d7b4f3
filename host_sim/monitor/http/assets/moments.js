import { kept, NodeHistory, PastViews } from './history.js';

const LOOK_MS = 60000;

/** What the page shows of a node of which a view says nothing. */
const NOTHING = {
  severity: 0,
  streams: {},
  tendons: {},
  bins: {},
  wires: {},
  advice: {},
  partial: true,
  absent: true,
};

/** A view in which each node that is known now has a place. */
export function withAllNodes(view, now) {
  const absent = Object.keys(now.nodes).filter((number) => !(number in view.nodes));
  if (absent.length === 0) {
    return view;
  }
  const places = absent.map((number) => [number, { node: Number(number), ...NOTHING }]);
  return { ...view, nodes: { ...view.nodes, ...Object.fromEntries(places) } };
}

/**
 * The moments that can be shown: those that this page has seen, and before them those that the monitor
 * has on record, which it is asked for.
 */
export class Moments {
  /** `onNews` is called when what was asked for is there. */
  constructor(onNews) {
    this.onNews = onNews;
    this.past = new PastViews();
    this.earlier = [];
    this.gone = {};
    this.looked_ms = -Infinity;
  }

  add(view) {
    this.past.add(kept(view));
  }

  newest() {
    return this.past.views.at(-1);
  }

  /** Whether what look() found may have changed: the oldest frames go while the monitor runs. */
  isOld() {
    return performance.now() - this.looked_ms > LOOK_MS;
  }

  /** Asks from when on there is something on record. */
  async look() {
    this.looked_ms = performance.now();
    const answer = await fetch('/api/times').catch(() => undefined);
    if (answer?.ok) {
      const { times_us, whole_from_us, why_gone } = await answer.json();
      this.earlier = times_us;
      this.gone = { before_us: whole_from_us, why: why_gone };
      this.answer = undefined;
      this.onNews();
    }
  }

  /** The times the slider stands at. */
  steps() {
    const seen = this.past.views.map(({ now_us }) => now_us);
    return [...this.earlier.filter((time_us) => time_us < seen[0]), ...seen];
  }

  /** The view of a moment, or until it is there the last one of those that were asked for. */
  viewAt(at, node) {
    const index = this.past.before(at);
    if (index >= 0) {
      return this.past.views[index];
    }
    const path = node === undefined ? `/api/moment/${at}` : `/api/moment/${at}/${node}`;
    if (this.answer?.path !== path) {
      this.ask(path, at);
    }
    return this.answer?.view ?? { now_us: at, nodes: {}, asked: true };
  }

  /** One after the other; of what is wanted meanwhile only the last. */
  async ask(path, at) {
    this.wanted = { path, at };
    if (this.asking) {
      return;
    }
    this.asking = true;
    while (this.answer?.path !== this.wanted.path) {
      const { wanted } = this;
      const view = await this.viewOf(wanted);
      this.answer = { path: wanted.path, view };
      this.onNews();
    }
    this.asking = false;
  }

  async viewOf({ path, at }) {
    const none = { now_us: at, nodes: {} };
    try {
      const answer = await fetch(path);
      if (!answer.ok) {
        return { ...none, trouble: (await answer.text()).trim() || `status ${answer.status}` };
      }
      const view = kept(await answer.json());
      const number = path.split('/')[4];
      const history = view.history && new NodeHistory({ node: number, ...view.history });
      return { ...view, history };
    } catch (error) {
      return { ...none, trouble: String(error) };
    }
  }
}
