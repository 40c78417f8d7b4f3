import { byId, Tiles } from './dom.js';
import { ageText } from './time.js';
import {
  cycleRateText,
  emergencyText,
  flagText,
  percentField,
  plain,
  rateText,
  remainingText,
  UNKNOWN,
  wholeField,
} from './words.js';

/** The key numbers of a node. */
export class NodeTiles {
  constructor() {
    this.tiles = new Tiles(byId('tiles'));
  }

  show({ node, view, isStale }) {
    const { status, remaining, rate, cycles, heartbeat, emergency } = node;
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
                : `${numberText(remaining.RemainingB50, 5)} h`
            }`
          : '',
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
        heartbeat ? plain(heartbeat.NmtState) : 'none',
        isStale(heartbeat),
        heartbeat ? ageText(view.now_us, heartbeat.time_us) : '',
      ],
      [
        'Last emergency',
        emergency ? emergencyText(emergency) : 'none heard',
        isStale({}),
        emergency
          ? `error register ${emergency.ErrorRegister}, ${ageText(view.now_us, emergency.time_us)}`
          : '',
      ],
    ]);
  }
}
