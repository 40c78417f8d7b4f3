'use strict';
interaction.run(async (expect) => {
  const { press, chart, hideAndZoom, reading } = interaction;

  const remainder = chart('remainder-0');
  press(remainder, 'Home');
  expect('Home reads the first bin', reading(remainder).includes(': 178.4 cycles; '));
  press(remainder, 'End');
  expect('End reads the last bin', reading(remainder).includes('3822 cycles'));
  expect('what is read is marked', !remainder.querySelector('.ring').hidden);

  const trace = document.querySelector('[data-chart^="trace-"]');
  await hideAndZoom(trace, 'Nominal model', expect);

  const bars = [...document.querySelectorAll('.ranking .bar rect:not(.track)')]
    .map((bar) => bar.getBoundingClientRect().width);
  expect('the bars of the candidates fall', bars.length === 5
    && bars.every((width, index) => index === 0 || width <= bars[index - 1]) && bars[0] > 50);
});
