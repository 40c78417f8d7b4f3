'use strict';

const NARROW_SPACE = '\u202f';
const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

function powerText(exponent) {
  const digits = [...String(Math.abs(exponent))].map((digit) => SUPERSCRIPTS[digit]).join('');
  return `10${exponent < 0 ? '⁻' : ''}${digits}`;
}

function trimZeros(text) {
  return text.includes('.') ? text.replace(/\.?0+$/, '') : text;
}

/** A number for people: rounded, grouped, with powers of ten outside 1e-3..1e6. */
function numberText(value, significant = 3) {
  if (value === 0) {
    return '0';
  }
  const sign = value < 0 ? '\u2212' : '';
  const [mantissa, power] = Math.abs(value).toExponential(significant - 1).split('e');
  const exponent = Number(power);
  if (exponent < -3 || exponent > 5) {
    return `${sign}${trimZeros(mantissa)}×${powerText(exponent)}`;
  }
  const fixed = trimZeros(Math.abs(value).toFixed(Math.max(0, significant - 1 - exponent)));
  const [whole, fraction] = fixed.split('.');
  const grouped = whole.length < 5 ? whole : whole.replace(/\B(?=(\d{3})+$)/g, NARROW_SPACE);
  return sign + grouped + (fraction ? `.${fraction}` : '');
}

/**
 * The power of ten, a multiple of 3, that brings axis numbers near 1, and how the axis says so.
 * Divided rather than multiplied, so that the largest numbers of the format stay finite.
 */
function axisScale(largest) {
  const magnitude = Math.abs(largest);
  if (magnitude === 0 || (magnitude >= 0.1 && magnitude < 1e5)) {
    return { divisor: 1, suffix: '' };
  }
  const exponent = 3 * Math.floor(Math.log10(magnitude) / 3);
  return { divisor: 10 ** exponent, suffix: ` (×${powerText(exponent)})` };
}

/** The unit of a time axis that is `duration_s` long. */
function timeScale(duration_s) {
  const units = [
    { unit: 'days', divisor: 86400 },
    { unit: 'h', divisor: 3600 },
    { unit: 'min', divisor: 60 },
  ];
  const shortest = 10;
  const fitting = units.find(({ divisor }) => duration_s >= shortest * divisor);
  const { unit, divisor } = fitting || { unit: 's', divisor: 1 };
  const scale = axisScale(duration_s / divisor);
  return { divisor: divisor * scale.divisor, label: `Time, ${unit}${scale.suffix}` };
}

function largestMagnitude(values) {
  return values.reduce((largest, value) => Math.max(largest, Math.abs(value || 0)), 0);
}

/** Values over a divisor; missing ones stay missing. */
function divided(values, divisor) {
  return values.map((value) => (value === null ? null : value / divisor));
}
