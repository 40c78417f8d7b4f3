'use strict';
// Runs before everything else, so that no error of the page goes unseen: the first one is kept in
// the data-error attribute of the root element.
(function guard() {
  const root = document.documentElement;
  const keep = (message) => {
    if (!('error' in root.dataset)) {
      root.dataset.error = String(message);
    }
  };
  window.addEventListener('error', (event) => keep(event.message));
  window.addEventListener('unhandledrejection', (event) => keep(event.reason));
  document.addEventListener('securitypolicyviolation', (event) => keep(event.violatedDirective));
  const report = console.error.bind(console);
  console.error = (...values) => {
    keep(values.join(' '));
    report(...values);
  };
})();
