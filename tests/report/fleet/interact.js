'use strict';
interaction.run(async (expect) => {
  const { press, chart, reading } = interaction;

  const risk = chart('risk');
  press(risk, 'Home');
  expect('a tendon can be read in the chart', /young: damage 0\.1000, risk /.test(reading(risk)));

  const due = document.querySelectorAll('[aria-label="Tendons to replace"] tbody tr');
  expect('the tendon that is due is in the table', due.length === 1 && /old/.test(due[0].textContent));
});
