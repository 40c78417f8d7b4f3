/** Times of the clock that stamped the frames, in microseconds. */

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
    return `${(time_us / 1e6).toFixed(digits)} s`;
  }
  const unit = 10 ** (6 - digits);
  const rounded_us = Math.floor(time_us / unit) * unit;
  const date = new Date(rounded_us / 1000);
  const seconds = ((rounded_us % 60e6) / 1e6).toFixed(digits);
  return `${two(date.getHours())}:${two(date.getMinutes())}:${seconds.padStart(digits ? digits + 3 : 2, '0')}`;
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

/** How long ago, in seconds. */
export function ageText(now_us, time_us) {
  const age_s = Math.max(0, (now_us - time_us) / 1e6);
  return age_s < 100 ? `${age_s.toFixed(1)} s ago` : `${numberText(age_s, 3)} s ago`;
}
