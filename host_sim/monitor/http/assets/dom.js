/** Small tools that touch the document only where something changes. */

export function byId(id) {
  return document.getElementById(id);
}

export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    element.setAttribute(key, value);
  }
  element.append(...children);
  return element;
}

const SVG_NAMESPACE = 'http://www.w3.org/2000/svg';

export function makeSvg(name, attributes = {}, text = undefined) {
  const element = document.createElementNS(SVG_NAMESPACE, name);
  for (const [key, value] of Object.entries(attributes)) {
    element.setAttribute(key, value);
  }
  if (text !== undefined) {
    element.textContent = text;
  }
  return element;
}

export function setText(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

export function setAttribute(element, name, value) {
  if (element.getAttribute(name) !== value) {
    element.setAttribute(name, value);
  }
}

/** A place for a value: its text, and the word STALE beside it where it is old. */
export class Value {
  constructor(holder) {
    this.holder = holder;
    this.text = make('span', { class: 'text' });
    this.tag = make('span', { class: 'tag' });
    holder.append(this.text, ' ', this.tag);
  }

  show(text, stale = false) {
    setText(this.text, text);
    setText(this.tag, stale ? 'STALE' : '');
    this.holder.classList.toggle('stale', stale);
  }
}

/** Keeps one element a key, in the order of the keys. */
export class Keyed {
  constructor(holder, create) {
    this.holder = holder;
    this.create = create;
    this.items = new Map();
  }

  /** What has the focus keeps it, also where its element is moved. */
  show(keys) {
    const focused = document.activeElement;
    for (const [key, item] of this.items) {
      if (!keys.includes(key)) {
        item.element.remove();
        this.items.delete(key);
      }
    }
    keys.forEach((key, index) => {
      if (!this.items.has(key)) {
        this.items.set(key, this.create(key));
      }
      const { element } = this.items.get(key);
      if (this.holder.children[index] !== element) {
        this.holder.insertBefore(element, this.holder.children[index] || null);
      }
    });
    if (focused !== document.activeElement && this.holder.contains(focused)) {
      focused.focus({ preventScroll: true });
    }
    return this.items;
  }
}

/** Tiles of a description list by name; those that are not shown again disappear. */
export class Tiles {
  constructor(list) {
    this.keyed = new Keyed(list, (name) => {
      const dd = make('dd', { class: 'value' });
      const note = make('dd', { class: 'note' });
      const element = make('div', {}, make('dt', {}, name), dd, note);
      return { element, value: new Value(dd), note };
    });
  }

  /** @param tiles [[name, text, stale, note], ..] */
  show(tiles) {
    const items = this.keyed.show(tiles.map(([name]) => name));
    for (const [name, text, stale, note = ''] of tiles) {
      const item = items.get(name);
      item.value.show(text, stale);
      setText(item.note, note);
    }
  }
}
