'use strict';
interaction.run(async (expect) => {
  const { press, chart, hideAndZoom, reading } = interaction;

  const residual = chart('residual-0');
  press(residual, 'Home');
  expect('Home reads the first bin', /^(Nominal|Extended) model: 200 cycles; /.test(reading(residual)));
  press(residual, 'End');
  expect('End reads the last bin', reading(residual).includes('3800 cycles'));
  expect('what is read is marked', !residual.querySelector('.ring').hidden);

  const trace = document.querySelector('[data-chart^="trace-"]');
  await hideAndZoom(trace, 'Nominal model', expect);

  const bars = [...document.querySelectorAll('.ranking .bar rect:not(.track)')]
    .map((bar) => bar.getBoundingClientRect().width);
  expect('the bars of the candidates fall', bars.length === 5
    && bars.every((width, index) => index === 0 || width <= bars[index - 1]) && bars[0] > 50);
});
