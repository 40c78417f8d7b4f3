// What the page shows, as texts. These functions run in the page.

export function shownFleet() {
  const rows = [...document.querySelectorAll('#fleet tbody tr')];
  return Object.fromEntries(
    rows.map((row) => [
      row.dataset.node,
      Object.fromEntries(
        [...row.cells].slice(1).map((cell) => [
          cell.dataset.column,
          {
            text: cell.innerText
              .replace(/\s+/g, ' ')
              .replace(/ ?STALE$/, '')
              .trim(),
            stale: /STALE/.test(cell.innerText),
          },
        ]),
      ),
    ]),
  );
}

export function shownNode() {
  const tilesOf = (id) =>
    Object.fromEntries(
      [...document.querySelectorAll(`#${id} > div`)].map((tile) => [
        tile.querySelector('dt').innerText,
        {
          text: tile.querySelector('.text').innerText,
          note: tile.querySelector('.note').innerText,
          stale: tile.querySelector('.tag').innerText === 'STALE',
        },
      ]),
    );
  const rowsOf = (id) =>
    [...document.querySelectorAll(`#${id} tbody tr`)].map((row) =>
      [...row.cells].map((cell) => cell.innerText.trim()),
    );
  return {
    heading: document.querySelector('#node-heading').innerText,
    note: document.querySelector('#node-note').innerText,
    tiles: { ...tilesOf('tiles'), ...tilesOf('trust') },
    thresholds: document.querySelector('#thresholds').innerText,
    tendons: rowsOf('tendons'),
    wires: rowsOf('wires'),
    streams: rowsOf('streams'),
    events: [...document.querySelectorAll('#events li')].map((line) => line.textContent),
    cells: document.querySelectorAll('#bins .cell').length,
    binsOpen: document.querySelector('#bins-open').innerText,
    canvases: document.querySelectorAll('#node canvas').length,
    bins: [...document.querySelectorAll('#bins-tendon option')].map((option) => option.value),
  };
}

/** The numbers of the nodes from top to bottom. */
export function shownOrder() {
  return [...document.querySelectorAll('#fleet tbody tr')].map((row) => row.dataset.node);
}

export function shownPage() {
  const root = document.documentElement;
  return {
    connection: document.querySelector('#connection').innerText,
    moment: document.querySelector('#moment').innerText,
    shown_us: Number(root.dataset.shown),
    title: document.title,
    error: root.dataset.error,
    overhang: root.scrollWidth - root.clientWidth,
  };
}
