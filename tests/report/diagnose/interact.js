'use strict';
// Uses the page as a person with a keyboard would, once it is ready, and writes what went wrong to
// data-interaction of the root element, or "ok".
(function interact() {
  const problems = [];
  const expect = (what, holds) => {
    if (!holds) {
      problems.push(what);
    }
  };
  const press = (element, key) =>
    element.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
  const chart = (name) => document.querySelector(`[data-chart="${name}"]`);
  const afterDrawing = () => new Promise((resolve) => { setTimeout(resolve, 50); });
  const reading = (holder) => holder.querySelector('.readout').textContent;
  const inked = (holder) => {
    const canvas = holder.querySelector('canvas');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let sum = 0;
    for (let at = 3; at < data.length; at += 4) {
      sum += data[at];
    }
    return sum;
  };

  async function tryAll() {
    await afterDrawing();

    const residual = chart('residual-0');
    press(residual, 'Home');
    expect('Home reads the first bin', /^(Nominal|Extended) model: 200 cycles; /.test(reading(residual)));
    press(residual, 'End');
    expect('End reads the last bin', reading(residual).includes('3800 cycles'));
    expect('what is read is marked', !residual.querySelector('.ring').hidden);

    const trace = document.querySelector('[data-chart^="trace-"]');
    const before = inked(trace);
    const nominal = [...trace.querySelectorAll('.key button')].find(
      (button) => button.textContent === 'Nominal model');
    nominal.click();
    await afterDrawing();
    expect('a line is hidden by its name', inked(trace) < before
      && nominal.getAttribute('aria-pressed') === 'false');
    nominal.click();
    await afterDrawing();
    expect('and shown again', inked(trace) === before);
    press(trace, '+');
    await afterDrawing();
    expect('+ draws another part', inked(trace) !== before);

    const bars = [...document.querySelectorAll('.ranking .bar rect:not(.track)')]
      .map((bar) => bar.getBoundingClientRect().width);
    expect('the bars of the candidates fall', bars.length === 5
      && bars.every((width, index) => index === 0 || width <= bars[index - 1]) && bars[0] > 50);

    expect('nothing hangs over the side',
      document.documentElement.scrollWidth <= document.documentElement.clientWidth);
    document.documentElement.dataset.interaction = problems.join('; ') || 'ok';
  }
  tryAll().catch((error) => { document.documentElement.dataset.interaction = String(error); });
})();
