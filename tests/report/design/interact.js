'use strict';
interaction.run(async (expect) => {
  const { press, chart, reading } = interaction;

  const life = chart('life');
  press(life, 'Home');
  expect('the design can be read in the chart', /^The design: 49 N; .* cycles$/.test(reading(life)));

  const bars = document.querySelectorAll('.ranking svg.bar rect.strong');
  expect('what shortens the life stands to the left',
    bars.length === 3 && [...bars].every((bar) => Number(bar.getAttribute('x')) < 0));
});
