/** What is shown lives in the address, so that it can be kept and sent: #node=5&order=number&axes=log&at=.. */

export function selectionOf(hash) {
  const parameters = new URLSearchParams(hash.replace(/^#/, ''));
  const node = parameters.get('node');
  const at = Number(parameters.get('at'));
  return {
    node: /^[0-9]{1,3}$/.test(node || '') ? String(Number(node)) : undefined,
    order: parameters.get('order') === 'number' ? 'number' : 'severity',
    axes: parameters.get('axes') === 'log' ? 'log' : 'linear',
    at: parameters.has('at') && Number.isFinite(at) ? at : undefined,
  };
}

export function hashOf({ node, order, axes, at }) {
  const parameters = new URLSearchParams();
  if (node !== undefined) {
    parameters.set('node', node);
  }
  if (order === 'number') {
    parameters.set('order', order);
  }
  if (axes === 'log') {
    parameters.set('axes', axes);
  }
  if (at !== undefined) {
    parameters.set('at', String(at));
  }
  return `#${parameters}`;
}
