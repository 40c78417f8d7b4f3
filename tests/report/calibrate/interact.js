'use strict';
interaction.run(async (expect) => {
  const { press, chart, afterDrawing, hideAndZoom, reading, inked } = interaction;

  const lives = chart('lives');
  expect('the lives wait to be read', reading(lives).startsWith('Point at a mark'));
  press(lives, 'Home');
  expect('Home reads a failure of the first level',
    /^Failed, wire \d+: 315°, 42.5\u00a0N; .* cycles$/.test(reading(lives)));
  press(lives, 'End');
  expect('End reads the last level', reading(lives).includes('270°, 35.2\u00a0N'));
  expect('what is read is marked', !lives.querySelector('.ring').hidden);

  const use = chart('use-log');
  press(use, 'Home');
  const first = reading(use);
  press(use, 'ArrowRight');
  expect('an arrow moves on', reading(use) !== first);
  expect('the lowest use level comes first', first.includes('SDM hand: 25 N; '));

  const law = chart('stress-life-log');
  const before = inked(law);
  await hideAndZoom(law, 'Mean life', expect);
  press(law, '0');
  await afterDrawing();
  expect('0 shows all again', inked(law) === before);

  const sign = law.querySelector('.key path');
  expect('signs of the legend take their colour from the style sheet',
    sign.outerHTML.includes('var(--line)'));
  document.documentElement.style.setProperty('--line', '#123456');
  expect('and follow it', [getComputedStyle(sign).fill, getComputedStyle(sign).stroke]
    .includes('rgb(18, 52, 86)'));
});
