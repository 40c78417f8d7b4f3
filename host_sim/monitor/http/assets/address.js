/** What is shown lives in the address, so that it can be kept and sent: #node=5&axes=log&at=.. */

export function placeOf(hash) {
  const words = new URLSearchParams(hash.replace(/^#/, ''));
  const node = words.get('node');
  const at = Number(words.get('at'));
  return {
    node: /^[0-9]{1,3}$/.test(node || '') ? String(Number(node)) : undefined,
    axes: words.get('axes') === 'log' ? 'log' : 'linear',
    at: words.has('at') && Number.isFinite(at) ? at : undefined,
  };
}

export function hashOf({ node, axes, at }) {
  const words = new URLSearchParams();
  if (node !== undefined) {
    words.set('node', node);
  }
  if (axes === 'log') {
    words.set('axes', axes);
  }
  if (at !== undefined) {
    words.set('at', String(at));
  }
  return `#${words}`;
}
