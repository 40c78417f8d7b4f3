'use strict';

/** Round numbers that cut low..high into about `wanted` parts. */
function roundTicks(low, high, wanted) {
  const rough = (high - low) / wanted;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((digit) => digit * power).find((size) => size >= rough);
  const first = Math.ceil(low / step);
  const last = Math.floor(high / step);
  return Array.from({ length: last - first + 1 }, (_, index) => (first + index) * step);
}

/** The numbers with one of the leading digits between low and high, in every `step`-th decade. */
function logTicksWith(digits, step, low, high) {
  const first = step * Math.floor(Math.log10(low) / step);
  const ticks = [];
  for (let decade = first; decade <= Math.log10(high); decade += step) {
    ticks.push(...digits.map((digit) => digit * 10 ** decade));
  }
  return ticks.filter((tick) => tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9));
}

/** The most round numbers of a logarithmic axis that stay `closest` (a share of it) apart. */
function logTicks(low, high, closest) {
  const length = Math.log(high / low);
  const fits = (ticks) => ticks.length > 1 && ticks.every(
    (tick, at) => at === 0 || Math.log(tick / ticks[at - 1]) / length >= closest,
  );
  const digits = [[1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9], [1, 1.5, 2, 3, 4, 5, 7],
    [1, 2, 3, 5, 7], [1, 2, 5], [1, 3], [1]];
  const choices = digits.map((set) => logTicksWith(set, 1, low, high));
  const steps = [2, 3, 5, 10, 20, 50, 100];
  choices.push(...steps.map((step) => logTicksWith([1], step, low, high)));
  if (high / low < 3) {
    const counts = [10, 8, 6, 5, 4, 3, 2, 1];
    choices.unshift(...counts.map((count) => roundTicks(low, high, count)));
  }
  return choices.find(fits) || [low, high];
}

const PERCENT_TICKS = [0.01, 0.1, 0.5, 1, 2, 5, 10, 20, 30, 50, 70, 80, 90, 95, 99, 99.9, 99.99];

function weibullPlace(share) {
  return Math.log(-Math.log1p(-share));
}

/** Round percentages that stay apart, taken in the order in which they matter. */
function weibullTicks(low, high, closest) {
  const places = PERCENT_TICKS.map((percent) => weibullPlace(percent / 100));
  const order = [10, 50, 1, 90, 99, 0.1, 99.9, 5, 20, 2, 80, 30, 70, 95, 0.5, 0.01, 99.99];
  const taken = [];
  for (const percent of order) {
    const place = places[PERCENT_TICKS.indexOf(percent)];
    const apart = taken.every((other) => Math.abs(other - place) >= closest * (high - low));
    if (place >= low && place <= high && apart) {
      taken.push(place);
    }
  }
  return taken.sort((a, b) => a - b);
}

/**
 * Kinds of axes: where a value is drawn, which value stands there, the ticks as places between
 * low and high that are at least `closest` (a share of the axis) apart, and their texts.
 */
const AXIS_KINDS = {
  linear: {
    place: (value) => value,
    ticks: (low, high, closest) => roundTicks(low, high, Math.max(1, Math.floor(1 / closest))),
    text: (place) => numberText(place, 6),
  },
  log: {
    place: (value) => (value > 0 ? Math.log10(value) : NaN),
    ticks: (low, high, closest) => logTicks(10 ** low, 10 ** high, closest).map(Math.log10),
    text: (place) => numberText(10 ** place, 4),
  },
  weibull: {
    place: (share) => (share > 0 && share < 1 ? weibullPlace(share) : NaN),
    ticks: weibullTicks,
    text: (place) => `${numberText(-100 * Math.expm1(-Math.exp(place)), 4)}`,
  },
  category: {
    place: (index) => index,
    ticks: (low, high, closest) => {
      const step = Math.max(1, Math.ceil(closest * (high - low)));
      const first = Math.max(0, Math.ceil(low));
      const count = Math.max(0, Math.floor((high - first) / step) + 1);
      return Array.from({ length: count }, (_, index) => first + step * index);
    },
    text: (place, axis) => axis.categories[place] || '',
  },
};
