// Packed numbers of the page (src/report/quantised.cpp): base64, zlib, then undoing differences and byte planes.

async function inflated(id) {
  const text = document.getElementById(`block-${id}`).textContent;
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i++) bytes[i] = binary.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Numbers of 16 bits: differences back by a frame, in the first frame by a row. */
export async function readShorts(id, row, frame) {
  const bytes = await inflated(id);
  const count = bytes.length / 2;
  const numbers = new Uint16Array(count);
  for (let i = 0; i < count; i++) {
    const folded = bytes[i] | (bytes[count + i] << 8);
    const difference = (folded >>> 1) ^ -(folded & 1);
    const back = i >= frame ? frame : row;
    numbers[i] = (i >= back ? numbers[i - back] : 0) + difference;
  }
  return numbers;
}

/** Corner numbers: each less the one before it. */
export async function readCorners(id) {
  const differences = new Uint32Array((await inflated(id)).buffer);
  let before = 0;
  return differences.map((difference) => (before = (before + difference) >>> 0));
}

const MISSING = 65535;

/** A quantity over frames and rows; values are offset + step q, of each component its own. */
export class Series {
  /** `entry` of the scene's description. */
  constructor(entry) {
    this.rows = entry.rows;
    this.offset = entry.offset;
    this.step = entry.step;
    this.components = entry.offset.length;
    this.block = entry.constant ? null : entry.block;
    this.numbers = null;
  }

  async load() {
    if (this.block && !this.numbers)
      this.numbers = await readShorts(this.block, this.components, this.rows * this.components);
    return this;
  }

  value(frame, row, component = 0) {
    if (!this.block) return this.offset[component];
    const q = this.numbers[(frame * this.rows + row) * this.components + component];
    return q === MISSING ? NaN : this.offset[component] + this.step[component] * q;
  }

  /** A frame's values as floats, row by row; `out` is filled when given. */
  frame(frame, out = new Float32Array(this.rows * this.components)) {
    const { components, offset, step, numbers } = this;
    const start = frame * this.rows * components;
    for (let i = 0; i < out.length; i++) {
      const c = i % components;
      out[i] = numbers ? offset[c] + step[c] * numbers[start + i] : offset[c];
    }
    return out;
  }
}
