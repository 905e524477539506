// The element that was clicked: its values in this frame, and its history as a small curve.
import { roundTicks, shown, shownTime } from './colours.js';

function curve(times, values, at, label) {
  const [width, height, left, bottom] = [260, 120, 40, 18];
  const finite = values.filter(Number.isFinite);
  let [low, high] = [Math.min(0, ...finite), Math.max(0, ...finite)];
  if (!(high > low)) high = low + 1;
  const x = (t) => left + ((width - left - 8) * (t - times[0])) / (times[times.length - 1] - times[0] || 1);
  const y = (v) => height - bottom - ((height - bottom - 8) * (v - low)) / (high - low);
  const ticks = roundTicks(low, high, 4)
    .map((v) => `<path class="grid" d="M${left} ${y(v).toFixed(1)}H${width - 8}"/><text class="tick end" x="${left - 4}" y="${(y(v) + 4).toFixed(1)}">${shown(v)}</text>`)
    .join('');
  const line = values.map((v, i) => (Number.isFinite(v) ? `${i ? 'L' : 'M'}${x(times[i]).toFixed(1)} ${y(v).toFixed(1)}` : '')).join('');
  const end = shownTime(times[times.length - 1]);
  return `<svg viewBox="0 0 ${width} ${height}" role="img" aria-label="${label} over time">${ticks}<path class="curve series-0" d="${line.replace(/^L/, 'M')}"/>` +
    `<circle class="mark series-1" cx="${x(times[at]).toFixed(1)}" cy="${y(values[at]).toFixed(1)}" r="3.5"/>` +
    `<text class="tick" x="${left}" y="${height - 4}">${label}</text><text class="tick end" x="${width - 8}" y="${height - 4}">${end}</text></svg>`;
}

/** Fills the panel's place for it. `field` is what the sheet is coloured by. */
export async function showPicked(place, element, { scene, sheet, fields, field, frame, mirrored }) {
  const all = [...fields.values()].filter((f) => !f.larger && !f.id.endsWith('.signed'));
  await Promise.all([...all, field].map((f) => f.series.load()));
  const corners = [0, 1, 2].map((k) => sheet.triangles[3 * element + k]);
  const centre = [0, 1, 2].map((k) => corners.reduce((sum, n) => sum + sheet.nodes[3 * n + k], 0) / 3);
  const rows = all.map((f) => {
    const number = f.magnitude // coloured without its sign, told with it
      ? f.series.value(frame, element, f.component) * f.factor + f.shift
      : f.ofElement(frame, element, sheet.triangles);
    const chosen = f.name === field.name && (f.component === field.component || f.magnitude);
    return `<tr${chosen ? ' class="chosen"' : ''}><th>${f.label.replaceAll('|', '')}${f.nodal ? ', mean of nodes' : ''}</th>` +
      `<td data-field="${f.id}" data-value="${number}">${shown(number)} ${f.units}</td></tr>`;
  });
  const history = scene.times.map((_, i) => field.ofElement(i, element, sheet.triangles));
  place.dataset.element = element;
  place.innerHTML = `<strong>Element ${element}${mirrored ? ', mirror image' : ''}</strong>` +
    `<div class="hint">x ${shown(1e3 * centre[0])}, y ${shown(1e3 * centre[1])}, z ${shown(1e3 * centre[2])} mm; nodes ${corners.join(', ')}</div>` +
    `<table>${rows.join('')}</table>${curve(scene.times, history, frame, `${field.label}${field.units ? ` [${field.units}]` : ''}`)}`;
}
