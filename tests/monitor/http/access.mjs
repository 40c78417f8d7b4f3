// Whether a page can be used by all: names, contrast, width. Contrast runs in the page.

const WITH_NAMES = ['button', 'link', 'slider', 'radio', 'combobox', 'table', 'image', 'textbox'];

/** Elements that a screen reader would meet without a name. */
export async function nameless(page) {
  await page.send('Accessibility.enable');
  const { nodes } = await page.send('Accessibility.getFullAXTree');
  return nodes
    .filter(
      ({ ignored, role, name }) => !ignored && WITH_NAMES.includes(role?.value) && !name?.value,
    )
    .map(({ role, nodeId }) => `${role.value} ${nodeId}`);
}

/** Texts whose contrast is below 4.5 (WCAG 2.2, 1.4.3). */
export function faintTexts() {
  const channels = (text) => text.match(/[\d.]+/g).map(Number);
  const light = (text) => {
    const [r, g, b] = channels(text)
      .map((value) => value / 255)
      .map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const groundOf = (element) => {
    for (let at = element; at; at = at.parentElement) {
      const ground = getComputedStyle(at).backgroundColor;
      if (channels(ground)[3] !== 0) {
        return ground;
      }
    }
    return 'rgb(255, 255, 255)';
  };
  const faint = new Set();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    if (
      !walker.currentNode.textContent.trim()
      || !element.checkVisibility()
      || ['SCRIPT', 'NOSCRIPT', 'OPTION'].includes(element.tagName)
    ) {
      continue;
    }
    const style = getComputedStyle(element);
    const [one, other] = [
      element instanceof SVGElement ? style.fill : style.color,
      groundOf(element),
    ].map(light);
    const contrast = (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05);
    if (contrast < 4.5 && !element.classList.contains('on-state')) {
      faint.add(
        `${element.tagName}.${element.className.baseVal ?? element.className} ${contrast.toFixed(2)}`,
      );
    }
  }
  return [...faint];
}

/** Boxes to press that are smaller than 24 pixels (WCAG 2.2, 2.5.8), links in a text left out. */
export function smallTargets() {
  return [...document.querySelectorAll('button, select, input[type=range], a')]
    .filter(
      (element) =>
        element.checkVisibility()
        && !element.closest('footer')
        && !element.classList.contains('skip'),
    )
    .map((element) => ({
      name: element.id || element.textContent,
      box: element.getBoundingClientRect(),
    }))
    .filter(({ box }) => box.height < 24)
    .map(({ name, box }) => `${name} ${box.height}`);
}
