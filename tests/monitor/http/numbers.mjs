// Numbers as the page writes them.

const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';
const NUMBER = /(−?)(\d[\d\u202f]*(?:\.\d+)?)(?:×10(⁻?)([⁰¹²³⁴⁵⁶⁷⁸⁹]+))?/;

/** The first number of a text. */
export function numberOf(text) {
  const match = NUMBER.exec(text);
  if (!match) {
    return NaN;
  }
  const [, sign, digits, powerSign, power] = match;
  const exponent = power ? [...power].map((digit) => SUPERSCRIPTS.indexOf(digit)).join('') : '0';
  return Number(
    `${sign ? '-' : ''}${digits.replaceAll('\u202f', '')}e${powerSign ? '-' : ''}${exponent}`,
  );
}

/** Whether the text shows this value, rounded to so many digits. */
export function shows(text, value, digits = 16) {
  const shown = numberOf(text);
  const step = value === 0 ? 0 : 10 ** (Math.floor(Math.log10(Math.abs(value))) - digits + 1);
  return Math.abs(shown - value) <= step * 0.5001 + Math.abs(value) * 1e-12;
}
