/**
 * Values in words. Numbers come decoded, with the names of the frame plan; times are those of the
 * clock that stamped the frames, in microseconds.
 */

export const UNKNOWN = 'not known';
const FIXED_SPACE = '\u00a0';

/** A number with its unit, which no line end parts. */
export function withUnit(number, unit) {
  return `${number}${FIXED_SPACE}${unit}`;
}

/** A whole number in full. */
export function wholeText(value) {
  return Number.isFinite(value) ? String(value).replace(/\B(?=(\d{3})+$)/g, NARROW_SPACE) : UNKNOWN;
}

export function percentText(share, significant = 5) {
  return Number.isFinite(share) ? withUnit(numberText(100 * share, significant), '%') : UNKNOWN;
}

/** A field at the end of its range stands for itself or more. */
function orMore(message, name, text) {
  return message.at_least?.includes(name) ? `≥${FIXED_SPACE}${text}` : text;
}

/** A field of a message, or of none. */
export function wholeField(message, name) {
  return message ? orMore(message, name, wholeText(message[name])) : UNKNOWN;
}

export function percentField(message, name, significant = 5) {
  return message ? orMore(message, name, percentText(message[name], significant)) : UNKNOWN;
}

/** Until the controller has seen a minute there is no rate. */
export function rateText(rate) {
  if (!rate) {
    return UNKNOWN;
  }
  return rate.DamageRate === 'unknown'
    ? 'unknown'
    : withUnit(percentField(rate, 'DamageRate', 4), 'per\u00a0h');
}

export function cycleRateText(cycles) {
  return cycles.CycleRate === 'unknown'
    ? 'rate unknown'
    : withUnit(wholeField(cycles, 'CycleRate'), 'per\u00a0min');
}

/** Until the controller has seen a minute there is no remaining life. */
export function hoursField(remaining, name) {
  const value = remaining[name];
  return value === 'unknown' ? value : orMore(remaining, name, numberText(value, 5));
}

/** A whole number of a unit. */
export function unitField(message, name, unit) {
  return orMore(message, name, withUnit(wholeText(message[name]), unit));
}

/** Until it has broken with 10 and 50 % probability, given that it is whole now. */
export function givenSurvivalText(conditional) {
  if (!conditional) {
    return UNKNOWN;
  }
  return conditional.HoursToRisk10 === 'unknown'
    ? UNKNOWN
    : withUnit(`${hoursField(conditional, 'HoursToRisk10')} to ${hoursField(conditional, 'HoursToRisk50')}`, 'h');
}

/** Probability of a break within the horizon. */
export function breakRiskText(risk) {
  return !risk || risk.BreakRisk === 'unknown'
    ? UNKNOWN
    : `${percentText(risk.BreakRisk, 4)} within ${withUnit(risk.BreakHorizon, 'h')}`;
}

const ADVICE_RANKS = ['off', 'unknown', 'over', 'no_limit', 'limited', 'unreachable'];

/** The advice that asks most of the drive. */
export function tightestAdvice(node) {
  const rank = (page) => ADVICE_RANKS.indexOf(page.AdviceState);
  return Object.values(node.advice).reduce(
    (tightest, page) =>
      tightest === undefined ||
      rank(page) > rank(tightest) ||
      (rank(page) === rank(tightest) && page.AdvicePace < tightest.AdvicePace)
        ? page
        : tightest,
    undefined,
  );
}

/** The highest tension that is advised, or why there is none. */
export function adviceText(page) {
  if (!page || page.AdviceState === 'unknown') {
    return UNKNOWN;
  }
  return {
    off: 'off',
    over: 'no limit, the hours are over',
    unreachable: 'no tension lasts',
  }[page.AdviceState] ?? `at most ${percentText(page.AdviceTension, 4)} tension`;
}

/** What would do instead, and of which tendon. */
export function adviceNote(page) {
  if (!page || page.AdvicePace === 'unknown') {
    return '';
  }
  const pace = `or ${percentText(page.AdvicePace, 4)} of the heaviest pace`;
  return `${pace}; tendon ${page.AdviceTendon}, ${plain(page.AdviceState)}`;
}

/** The band of the remaining life. */
export function remainingText(remaining) {
  if (!remaining) {
    return UNKNOWN;
  }
  const { RemainingB10: low, RemainingB90: high } = remaining;
  return low === 'unknown' && high === 'unknown'
    ? 'unknown'
    : withUnit(`${hoursField(remaining, 'RemainingB10')} to ${hoursField(remaining, 'RemainingB90')}`, 'h');
}

export function plain(name) {
  return name.replaceAll('_', ' ');
}

/** The states of a node that are worth a word: [[text, class], ..]. */
export function stateTexts(node) {
  const texts = [];
  if (node.two_controllers) {
    texts.push(['TWO CONTROLLERS HAVE THIS NODE ID', 'emergency']);
  }
  if (node.vanished) {
    texts.push(['VANISHED', 'gone']);
  }
  const state = node.status && node.life_state;
  texts.push([state || UNKNOWN, `life-${state || 'unknown'}`]);
  if (node.emergency && node.emergency.EmergencyCode !== 'none') {
    texts.push([`EMERGENCY: ${emergencyText(node.emergency)}`, 'emergency']);
  }
  if (node.status && node.status.Broken) {
    texts.push(['TENDON BROKEN', 'emergency']);
  }
  if (node.status && node.status.Slack) {
    texts.push(['TENDON SLACK', 'emergency']);
  }
  if (node.status && node.status.Locked) {
    texts.push(['LOCKED', 'emergency']);
  }
  if (node.heartbeat && node.heartbeat.NmtState !== 'operational') {
    texts.push([plain(node.heartbeat.NmtState), 'gone']);
  }
  return texts;
}

export function emergencyText({ EmergencyCode: code }) {
  return typeof code === 'number' ? `code ${code}` : plain(code);
}

/** What reduces the trust in a reading. */
export function flagText(status) {
  const flags = [
    [!status.StorageOk, 'record cannot be written'],
    [!status.SensorOk, 'sensor at fault'],
    [status.Gap, 'samples missing'],
    [status.Saturated, 'a value at the end of its range'],
    [status.Overrun, 'cycles counted larger'],
    [status.Locked, 'held by the emergency stop'],
    [status.Broken, 'a tendon has broken'],
    [status.Slack, 'a tendon hangs loose'],
  ];
  return (
    flags
      .filter(([on]) => on)
      .map(([, text]) => text)
      .join('; ') || 'no flags'
  );
}

const YEAR_2001_US = 978307200e6;

/** Whether the times are of the calendar, rather than from the start of a log. */
export function isCalendar(time_us) {
  return time_us > YEAR_2001_US;
}

function two(number) {
  return String(number).padStart(2, '0');
}

/** "14:03:05.2" in the time of this place, or "12.3 s" from the start. */
export function clockText(time_us, digits = 1) {
  if (!isCalendar(time_us)) {
    return withUnit((time_us / 1e6).toFixed(digits), 's');
  }
  const unit = 10 ** (6 - digits);
  const rounded_us = Math.floor(time_us / unit) * unit;
  const date = new Date(rounded_us / 1000);
  const seconds = ((rounded_us % 60e6) / 1e6).toFixed(digits);
  return `${two(date.getHours())}:${two(date.getMinutes())}:${seconds.padStart(digits ? digits + 3 : 2, '0')}`;
}

/** The zone of clock times at a time: "UTC+5:30"; empty where the time is of no calendar. */
export function zoneText(time_us) {
  const east_min = -new Date(time_us / 1000).getTimezoneOffset();
  const [hours, minutes] = [Math.floor(Math.abs(east_min) / 60), Math.abs(east_min) % 60];
  const offset = `${east_min < 0 ? '−' : '+'}${hours}${minutes ? `:${two(minutes)}` : ''}`;
  return isCalendar(time_us) ? `UTC${east_min ? offset : ''}` : '';
}

/** With the date, where the time is of the calendar. */
export function momentText(time_us) {
  if (!isCalendar(time_us)) {
    return clockText(time_us);
  }
  const date = new Date(time_us / 1000);
  const day = `${date.getFullYear()}-${two(date.getMonth() + 1)}-${two(date.getDate())}`;
  return `${day} ${clockText(time_us)}`;
}

/** From when on frames can be gone back to, where there were frames before. */
export function goneText({ before_us: before, why }) {
  return why && before !== undefined
    ? `Frames before ${momentText(before)} are gone: ${why}. Before then only damage, rate and state are known.`
    : '';
}

/** What there is of a moment that this page has not seen; empty for one that it has. */
export function recordText({ from_us: from, asked, trouble }) {
  if (asked) {
    return 'This moment is being read from the record.';
  }
  if (trouble) {
    return `This moment cannot be read from the record: ${trouble}`;
  }
  return from === undefined
    ? ''
    : `From the record: what was sent since ${momentText(from)}. Counts begin there.`;
}

/** How long ago, in seconds. */
export function ageText(now_us, time_us) {
  const age_s = Math.max(0, (now_us - time_us) / 1e6);
  return `${withUnit(age_s < 100 ? age_s.toFixed(1) : numberText(age_s, 3), 's')} ago`;
}
