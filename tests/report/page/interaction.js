'use strict';
// How a person with a keyboard uses a page. interaction.run takes the steps, once the page is ready,
// and writes what went wrong to data-interaction of the root element, or "ok".
const interaction = {
  press: (element, key) =>
    element.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true })),
  chart: (name) => document.querySelector(`[data-chart="${name}"]`),
  afterDrawing: () => new Promise((resolve) => { setTimeout(resolve, 50); }),
  reading: (holder) => holder.querySelector('.readout').textContent,
  inked(holder) {
    const canvas = holder.querySelector('canvas');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0;
    for (let at = 3; at < data.length; at += 4) {
      sum += data[at];
    }
    return sum;
  },
  // The name and address of the file that a button of a plot saves.
  async saved(plot, kind) {
    let file = null;
    const { click } = HTMLAnchorElement.prototype;
    HTMLAnchorElement.prototype.click = function keep() {
      file = { name: this.download, address: this.href };
    };
    [...plot.querySelectorAll('.save button')].find(
      (button) => button.textContent === kind).click();
    for (let turn = 0; file === null && turn < 20; turn += 1) {
      await interaction.afterDrawing();
    }
    HTMLAnchorElement.prototype.click = click;
    return file;
  },
  // The lines of a saved table.
  async savedRows(plot) {
    const { address } = await interaction.saved(plot, 'CSV');
    return decodeURIComponent(address.slice(address.indexOf(',') + 1)).split('\r\n');
  },
  // A line of a plot goes and comes by its name, and + draws another part.
  async hideAndZoom(plot, line, expect) {
    const { afterDrawing, inked, press } = interaction;
    const before = inked(plot);
    const name = [...plot.querySelectorAll('.key button')].find(
      (button) => button.textContent === line);
    name.click();
    await afterDrawing();
    expect('a line is hidden by its name', inked(plot) < before
      && name.getAttribute('aria-pressed') === 'false');
    name.click();
    await afterDrawing();
    expect('and shown again', inked(plot) === before);
    press(plot, '+');
    await afterDrawing();
    expect('+ draws another part', inked(plot) !== before);
  },
  async run(steps) {
    const root = document.documentElement;
    const problems = [];
    const expect = (what, holds) => {
      if (!holds) {
        problems.push(what);
      }
    };
    try {
      await interaction.afterDrawing();
      await steps(expect);
      expect('nothing hangs over the side', root.scrollWidth <= root.clientWidth);
      root.dataset.interaction = problems.join('; ') || 'ok';
    } catch (error) {
      root.dataset.interaction = String(error);
    }
  },
};
