'use strict';

/** A line of CSV (RFC 4180); what is missing is empty. */
function csvLine(cells) {
  const quoted = cells.map((cell) => {
    const text = cell === null || cell === undefined ? '' : String(cell);
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  });
  return `${quoted.join(',')}\r\n`;
}

/** The lines that the names of layers take on a canvas of this width, each name with its place. */
function legendLines(context, names, width, pixel) {
  const gap = 18 * pixel;
  const lines = [[]];
  let x = 0;
  for (const { name, ink } of names) {
    const length = gap + context.measureText(name).width + gap;
    if (x > 0 && x + length > width) {
      lines.push([]);
      x = 0;
    }
    lines[lines.length - 1].push({ name, ink, x });
    x += length;
  }
  return lines;
}

/** A drawing with its name above it and the names of what it shows below, on the paper of the page. */
function pictureOf(drawing, title, names) {
  const pixel = drawing.clientWidth > 0 ? drawing.width / drawing.clientWidth : 1;
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  const font = `${12 * pixel}px system-ui, sans-serif`;
  const [edge, head, line] = [12 * pixel, 32 * pixel, 20 * pixel];
  context.font = font;
  const lines = legendLines(context, names, drawing.width - 2 * edge, pixel);
  canvas.width = drawing.width;
  canvas.height = head + drawing.height + lines.length * line + edge;
  context.fillStyle = colour('paper');
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(drawing, 0, head);
  context.fillStyle = colour('ink');
  context.textBaseline = 'middle';
  context.font = `600 ${13 * pixel}px system-ui, sans-serif`;
  context.fillText(title, edge, head / 2, canvas.width - 2 * edge);
  context.font = font;
  lines.forEach((inLine, index) => {
    const y = head + drawing.height + (index + 0.5) * line;
    for (const { name, ink, x } of inLine) {
      context.fillStyle = colour(ink);
      context.fillRect(edge + x, y - 4 * pixel, 12 * pixel, 8 * pixel);
      context.fillStyle = colour('ink');
      context.fillText(name, edge + x + 18 * pixel, y);
    }
  });
  return canvas;
}

/** An SVG of the page as a canvas: what the style sheet says of its parts goes with them. */
async function drawingOf(svg) {
  const copy = svg.cloneNode(true);
  const parts = copy.querySelectorAll('*');
  svg.querySelectorAll('*').forEach((part, index) => {
    const style = getComputedStyle(part);
    for (const name of ['fill', 'stroke', 'stroke-width', 'font-family', 'font-size']) {
      parts[index].style.setProperty(name, style.getPropertyValue(name));
    }
  });
  copy.setAttribute('xmlns', svg.namespaceURI);
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${
    encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
  await image.decode();
  const canvas = document.createElement('canvas');
  canvas.width = svg.clientWidth;
  canvas.height = svg.clientHeight;
  canvas.getContext('2d').drawImage(image, 0, 0);
  return canvas;
}

/**
 * Adds buttons that save a chart: `drawing()` gives what is drawn as a canvas, `names` what it shows,
 * each with its ink, and `rows()` its values, the names of the columns first.
 */
function addSave(holder, { title, drawing, names, rows }) {
  const offer = (address, suffix) => {
    const link = document.createElement('a');
    link.download = `${`${document.title} ${title}`.toLowerCase().replace(/[^a-z0-9]+/g, '-')
      .replace(/^-|-$/g, '')}.${suffix}`;
    link.href = address;
    link.click();
  };
  const kinds = {
    PNG: async () =>
      offer(pictureOf(await drawing(), title, names).toDataURL('image/png'), 'png'),
    CSV: () => offer(
      `data:text/csv;charset=utf-8,${encodeURIComponent(rows().map(csvLine).join(''))}`, 'csv'),
  };
  const line = document.createElement('p');
  line.className = 'save';
  line.append('Save as ');
  for (const [kind, save] of Object.entries(kinds)) {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = kind;
    button.setAttribute('aria-label', `Save ${title} as ${kind}`);
    button.addEventListener('click', save);
    line.append(button, ' ');
  }
  holder.append(line);
}
