'use strict';
interaction.run(async (expect) => {
  const { press, chart, reading } = interaction;

  const width = chart('width');
  press(width, 'Home');
  expect('a plan can be read in the chart', /^[a-z +]+: \d+ specimens; \d\.\d+$/.test(reading(width)));
});
