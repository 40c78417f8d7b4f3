'use strict';

/** The present value of a colour of the style sheet, for drawing on a canvas. */
function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

/** A colour between #rrggbb colours; `position` runs from 0, the first, to 1, the last. */
function between(stops, position) {
  const place = Math.min(Math.max(position, 0), 1) * (stops.length - 1);
  const index = Math.min(Math.floor(place), stops.length - 2);
  const channel = (hex, at) => parseInt(hex.slice(at, at + 2), 16);
  const mixed = [1, 3, 5].map((at) => {
    const from = channel(stops[index], at);
    const to = channel(stops[index + 1], at);
    return Math.round(from + (to - from) * (place - index));
  });
  return `rgb(${mixed.join(' ')})`;
}

/**
 * Calls `redraw(width)` when the holder changes its width, the colours change or the page is
 * printed. On paper the width is that of an A4 page within its margins. Returns what ends that.
 */
function keepDrawn(holder, redraw) {
  const printWidth = 680;
  const root = document.documentElement;
  const again = () => redraw(root.classList.contains('printing') ? printWidth : holder.clientWidth);
  let width = holder.clientWidth;
  const observer = new ResizeObserver(() => {
    if (holder.clientWidth !== width && !root.classList.contains('printing')) {
      width = holder.clientWidth;
      requestAnimationFrame(again);
    }
  });
  observer.observe(holder);
  const ending = new AbortController();
  const { signal } = ending;
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', again, { signal });
  const setPrinting = (printing) => () => {
    root.classList.toggle('printing', printing);
    again();
  };
  window.addEventListener('beforeprint', setPrinting(true), { signal });
  window.addEventListener('afterprint', setPrinting(false), { signal });
  return () => {
    observer.disconnect();
    ending.abort();
  };
}
