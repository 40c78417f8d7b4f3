'use strict';
interaction.run(async (expect) => {
  const { press, chart, afterDrawing, saved, savedRows } = interaction;
  const valueOf = (holder, row) =>
    Number(holder.querySelectorAll('.u-legend .u-value')[row].textContent);

  const tension = chart('tension');
  expect('no reading before the cursor is placed', Number.isNaN(valueOf(tension, 0)));
  press(tension, 'End');
  await afterDrawing();
  expect('End reads the last moment', valueOf(tension, 0) > 59);
  press(tension, 'Home');
  press(tension, 'ArrowRight');
  await afterDrawing();
  const step_s = valueOf(tension, 0);
  expect('an arrow moves by a hundredth', step_s > 0.4 && step_s < 0.8);
  expect('the cursor reads a tension', valueOf(tension, 1) > 10);
  press(tension, '+');
  press(tension, 'End');
  await afterDrawing();
  expect('+ shows half of the time', valueOf(tension, 0) > 29 && valueOf(tension, 0) < 32);
  press(tension, '0');
  press(tension, 'End');
  await afterDrawing();
  expect('0 shows all again', valueOf(tension, 0) > 59);

  const table = await saved(tension, 'CSV');
  expect('values are saved by the name of the plot',
    table.name === 'tendon-life-upper-arm-csv-input-tension-over-time-with-turning-points.csv');
  const rows = await savedRows(tension);
  expect('the first line names the columns',
    rows[0] === '"Time, s",Highest,Lowest,Turning point' || rows[0].startsWith('"Time, s",Tension'));
  expect('each row has as many values', rows.length > 100
    && rows.slice(1, -1).every((row) => row.split(',').length === rows[0].split(',').length - 1));
  const hints = document.querySelectorAll('#chart-hint');
  expect('how to zoom is told once', hints.length === 1
    && tension.getAttribute('aria-describedby') === 'chart-hint');

  const matrix = chart('matrix');
  for (const plot of [tension, matrix]) {
    const picture = await saved(plot, 'PNG');
    expect('a plot is saved as a picture', picture.name.endsWith('.png')
      && picture.address.startsWith('data:image/png;base64,') && picture.address.length > 5000);
  }
  const svg = matrix.querySelector('svg');
  press(svg, 'ArrowUp');
  expect('an arrow reads a class', /^Range .* cycles, damage /.test(
    matrix.querySelector('.readout').textContent));
  expect('the class read is outlined', svg.querySelectorAll('.picked').length === 1);
  expect('coloured by cycles', svg.textContent.includes('Cycles in a class'));
  matrix.querySelector('input[value="damage"]').click();
  expect('coloured by damage', svg.textContent.includes('Damage in a class'));
  expect('the outline stays', svg.querySelectorAll('.picked').length === 1);

  const sign = chart('trajectory').querySelectorAll('.u-legend .u-marker')[1]
    || chart('trajectory').querySelector('.u-legend .u-marker');
  document.documentElement.style.setProperty('--line', '#123456');
  expect('signs of the legend follow the colours of the page',
    getComputedStyle(sign).borderTopColor === 'rgb(18, 52, 86)');
});
