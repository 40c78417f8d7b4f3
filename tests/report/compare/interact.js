'use strict';
interaction.run(async (expect) => {
  const { press, chart, hideAndZoom, reading, savedRows } = interaction;

  const classes = chart('classes');
  press(classes, 'End');
  expect('the damage of a class can be read', /^[AB], .*: 50 N; 0\.0\d+/.test(reading(classes)));

  const name = [...chart('trajectory').querySelectorAll('.key button')].map(
    (button) => button.textContent);
  expect('both sides have a name', name.length === 2 && name[0].startsWith('A, '));
  const rows = await savedRows(classes);
  expect('every value of a plot is saved',
    rows[0] === 'layer,"Range, N",Damage in a class,"Damage in a class, to",text'
    && rows.some((row) => row.startsWith('"B, ') && row.endsWith(',50,0.029,,')));
  await hideAndZoom(chart('trajectory'), name[1], expect);
});
