// What the sheet can be coloured by: every field of the results, each part of those that have two, and how it is shown.
import { Series } from './blocks.js';

const RANGE_TAILS = 0.002; // of the values at each end that the colour range leaves out: lone peaks hide the rest

class Field {
  constructor(series, entry, options) {
    this.series = series;
    this.units = entry.units;
    this.factor = entry.factor;
    this.shift = entry.shift;
    this.nodal = entry.nodal;
    Object.assign(this, { component: 0, magnitude: false, signed: false }, options);
  }

  /** Value of a row (an element, or a node when `nodal`) in the units shown. */
  value(frame, row) {
    const one = (c) => this.series.value(frame, row, c) * this.factor + this.shift;
    if (this.larger) {
      const [a, b] = [one(0), one(1)];
      return Math.abs(a) > Math.abs(b) ? Math.abs(a) : Math.abs(b);
    }
    const value = one(this.component);
    return this.magnitude ? Math.abs(value) : value;
  }

  /** Of an element: its own, or the mean of its nodes'. */
  ofElement(frame, element, triangles) {
    if (!this.nodal) return this.value(frame, element);
    let sum = 0;
    for (let k = 0; k < 3; k++) sum += this.value(frame, triangles[3 * element + k]);
    return sum / 3;
  }

  /** Lowest and highest value over frames, without the tails. */
  range(frames) {
    const values = [];
    const rows = this.series.rows;
    const stride = Math.max(1, Math.floor((rows * frames.length) / 200000)); // enough to know the tails
    for (const frame of frames)
      for (let row = frame % stride; row < rows; row += stride) {
        const value = this.value(frame, row);
        if (Number.isFinite(value)) values.push(value);
      }
    if (values.length === 0) return [0, 1];
    const sorted = Float64Array.from(values).sort();
    const at = (share) => sorted[Math.round(share * (sorted.length - 1))];
    let [low, high] = this.whole ? [sorted[0], sorted[sorted.length - 1]] : [at(RANGE_TAILS), at(1 - RANGE_TAILS)];
    if (this.magnitude || this.larger) low = 0;
    if (high - low <= 1e-9 * Math.max(Math.abs(high), 1)) return [low, low + 1]; // one value everywhere: no false patches
    if (this.signed && low < 0 && high > 0) {
      high = Math.max(high, -low);
      low = -high;
    }
    return [low, high];
  }
}

/** Fields in the order of the menu, by an id. */
export function makeFields(entries) {
  const fields = new Map();
  for (const entry of entries) {
    const series = new Series(entry);
    const add = (id, label, options) => fields.set(id, new Field(series, entry, { id, label, name: entry.name, ...options }));
    if (entry.parts) {
      add(entry.name, `${entry.label}, larger of both`, { larger: true });
      entry.parts.forEach((part, component) =>
        add(`${entry.name}.${component + 1}`, `${entry.label}, ${part}`, { component, signed: true }));
    } else if (entry.name === 'shear_angle' || entry.name === 'shear_force') {
      add(entry.name, `|${entry.label}|`, { magnitude: true, whole: true });
      add(`${entry.name}.signed`, `${entry.label}, with sign`, { signed: true, whole: true });
    } else if (entry.name === 'clearance') {
      add(entry.name, entry.label, { signed: false });
    } else {
      add(entry.name, entry.label, { whole: entry.name === 'curve_index' });
    }
  }
  return fields;
}
