import { hashOf } from './address.js';
import { Curves } from './curves.js';
import { byId, setAttribute, setText, Tiles } from './dom.js';
import { Timeline } from './events.js';
import { NodeHistory } from './history.js';
import {
  adviceNote,
  adviceText,
  ageText,
  breakRiskText,
  cycleRateText,
  emergencyText,
  flagText,
  givenSurvivalText,
  hoursField,
  momentText,
  percentField,
  plain,
  rateText,
  recordText,
  remainingText,
  tightestAdvice,
  UNKNOWN,
  wholeField,
  withUnit,
} from './prose.js';
import { Bins, Tendons, Wires } from './tendons.js';
import { Trust } from './trust.js';

/** The key numbers of a node. */
class NodeTiles {
  constructor() {
    this.tiles = new Tiles(byId('tiles'));
  }

  show({ node, view, isStale }) {
    const { status, remaining, conditional, rate, cycles, heartbeat, emergency } = node;
    const risk = node.break_risk;
    const advice = tightestAdvice(node);
    const none = node.partial ? UNKNOWN : 'none';
    this.tiles.show([
      [
        'Damage',
        status ? percentField(node, 'highest_damage', 7) : UNKNOWN,
        isStale(status),
        status && status.WorstTendon !== undefined
          ? `of tendon ${status.WorstTendon}, the worst`
          : '',
      ],
      [
        'Life state',
        status && node.life_state ? node.life_state : UNKNOWN,
        isStale(status),
        node.two_controllers ? 'TWO CONTROLLERS have this node id; the graver state of both' : '',
      ],
      [
        'Remaining life, B10 to B90',
        remainingText(remaining),
        isStale(remaining),
        remaining
          ? `B50 ${
              remaining.RemainingB50 === 'unknown'
                ? 'unknown'
                : withUnit(hoursField(remaining, 'RemainingB50'), 'h')
            }`
          : '',
      ],
      [
        'Whole now: until 10 to 50 % have broken',
        givenSurvivalText(conditional),
        isStale(conditional),
        'given survival, at the present rate',
      ],
      ['Probability of a break', breakRiskText(risk), isStale(risk), 'given survival'],
      [
        'Advice to the drive',
        adviceText(advice),
        advice !== undefined && isStale(advice),
        adviceNote(advice),
      ],
      ['Damage rate', rateText(rate), isStale(rate), 'over the last minute'],
      [
        'Cycles',
        wholeField(cycles, 'Cycles'),
        isStale(cycles),
        cycles ? cycleRateText(cycles) : '',
      ],
      [
        'Reading',
        status && status.Quality ? status.Quality : UNKNOWN,
        isStale(status),
        status && status.Quality ? flagText(status) : '',
      ],
      [
        'Heartbeat',
        heartbeat ? plain(heartbeat.NmtState) : none,
        isStale(heartbeat),
        heartbeat ? ageText(view.now_us, heartbeat.time_us) : '',
      ],
      [
        'Last emergency',
        emergency ? emergencyText(emergency) : `${none} heard`,
        isStale({}),
        emergency
          ? `error register ${emergency.ErrorRegister}, ${ageText(view.now_us, emergency.time_us)}`
          : '',
      ],
    ]);
  }
}

/** All about one node. Its history comes from the monitor and continues with the views. */
export class NodeView {
  constructor(onHistory) {
    this.onHistory = onHistory;
    this.section = byId('node');
    this.panels = null;
  }

  /** Fetches the history of the node that is to be shown; again where `anew`. */
  async load(number, anew = false) {
    if (number === undefined || (!anew && this.wanted === number)) {
      return;
    }
    this.wanted = number;
    if (!anew) {
      this.history = undefined;
    }
    const heard = [];
    this.heard = heard;
    try {
      const answer = await fetch(`/api/node/${number}`);
      const json = answer.ok
        ? await answer.json()
        : { node: Number(number), events: [], curve: [] };
      if (this.wanted === number && this.heard === heard) {
        this.history = new NodeHistory(json);
        this.heard = undefined;
        heard.forEach(([view, events]) => this.add(view, events));
        this.onHistory();
      }
    } catch {
      if (this.heard === heard) {
        this.wanted = undefined;
        this.heard = undefined;
      }
    }
  }

  /** What comes while a history is on its way is added to it afterwards. */
  hear(view, events) {
    if (this.heard) {
      this.heard.push([view, events]);
    } else if (this.history) {
      this.add(view, events);
    }
  }

  add(view, events) {
    const { node } = this.history;
    if (view.nodes[node]) {
      this.history.add(view.nodes[node], events[node] || []);
    }
  }

  leave() {
    this.wanted = undefined;
    this.heard = undefined;
    this.history = undefined;
    this.section.hidden = true;
  }

  show(shown) {
    const { view, selection } = shown;
    const node = view.nodes[selection.node];
    this.section.hidden = false;
    setText(byId('node-heading'), `Node ${selection.node}`);
    setText(byId('node-note'), this.note(node, view));
    setAttribute(byId('export-csv'), 'href', `/export/${selection.node}.csv`);
    setAttribute(byId('export-candump'), 'href', `/export/${selection.node}.candump`);
    setAttribute(byId('close-node'), 'href', hashOf({ ...selection, node: undefined }));
    for (const input of document.querySelectorAll('#axes input')) {
      input.checked = input.value === selection.axes;
    }
    if (!node) {
      return;
    }
    this.panels ??= [new NodeTiles(), new Tendons(), new Bins(), new Wires(), new Trust()];
    const history = this.historyOf(view);
    const all = { ...shown, node, history };
    this.panels.forEach((panel) => panel.show(all));
    this.drawn ??= [new Curves(), new Timeline()];
    const known = history?.node === selection.node;
    this.drawn.forEach((panel) => (known ? panel.show(all) : panel.clear()));
  }

  /** That of all the time; of moments before it, that of the record. */
  historyOf({ now_us, history }) {
    const reaches = !history || this.history?.curve[0]?.[0] <= now_us;
    return reaches ? this.history : history;
  }

  note(node, view) {
    if (!node) {
      return 'This node has not been heard.';
    }
    if (view.asked || view.trouble) {
      return recordText(view);
    }
    if (node.absent) {
      return 'Of this node nothing is known at this moment.';
    }
    if (node.partial) {
      return 'Of this moment only damage, rate and state are known: its frames are not on record.';
    }
    const seen = `last frame ${momentText(node.last_seen_us)}`;
    const heard = node.vanished
      ? `VANISHED: nothing has come from it since; ${seen}.`
      : `Heard; ${seen}.`;
    return `${heard} ${recordText(view)}`.trim();
  }
}
