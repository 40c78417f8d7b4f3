'use strict';
interaction.run(async (expect) => {
  const { press, chart, hideAndZoom, reading } = interaction;

  const classes = chart('classes');
  press(classes, 'End');
  expect('the damage of a class can be read', /^[AB], .*: 50 N; 0\.0\d+/.test(reading(classes)));

  const name = [...chart('trajectory').querySelectorAll('.key button')].map(
    (button) => button.textContent);
  expect('both sides have a name', name.length === 2 && name[0].startsWith('A, '));
  await hideAndZoom(chart('trajectory'), name[1], expect);
});
