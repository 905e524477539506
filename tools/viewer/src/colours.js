// Colour maps that read the same to colour-blind eyes: viridis for sizes, blue over grey to orange for signs.

const VIRIDIS = ['440154', '482878', '3e4a89', '31688e', '26828e', '1f9e89', '35b779', '6ece58', 'b5de2b', 'fde725'];
const SIGNED = ['053a6b', '1f6aa5', '5fa0cf', 'a9cbe3', 'd9dcdf', 'f0c79b', 'dd8f45', 'b4570f', '6b2d04'];

function table(anchors) {
  const rgb = anchors.map((hex) => [0, 2, 4].map((at) => parseInt(hex.slice(at, at + 2), 16) / 255));
  const colours = new Float32Array(256 * 3);
  for (let i = 0; i < 256; i++) {
    const place = (i / 255) * (rgb.length - 1);
    const k = Math.min(Math.floor(place), rgb.length - 2);
    for (let c = 0; c < 3; c++) colours[3 * i + c] = rgb[k][c] + (place - k) * (rgb[k + 1][c] - rgb[k][c]);
  }
  return colours;
}

const MAPS = { size: table(VIRIDIS), signed: table(SIGNED) };
const NOTHING = [0.6, 0.6, 0.6];

/** Values from `low` to `high` in colours of a map; what lies outside has the end's colour. */
export class Scale {
  constructor(low, high, signed) {
    this.low = low;
    this.high = high > low ? high : low + (Math.abs(low) || 1) * 1e-6;
    this.map = signed ? MAPS.signed : MAPS.size;
  }

  /** Writes the colour of a value to out[at..at+2]. */
  paint(value, out, at) {
    if (Number.isNaN(value)) {
      for (let c = 0; c < 3; c++) out[at + c] = NOTHING[c];
      return;
    }
    const place = (value - this.low) / (this.high - this.low);
    const i = 3 * Math.max(0, Math.min(255, Math.floor(256 * place)));
    out[at] = this.map[i];
    out[at + 1] = this.map[i + 1];
    out[at + 2] = this.map[i + 2];
  }

  /** Paints the whole scale into a canvas, left to right. */
  draw(canvas) {
    canvas.width = 256;
    canvas.height = 1;
    const context = canvas.getContext('2d');
    const image = context.createImageData(256, 1);
    for (let i = 0; i < 256; i++)
      for (let c = 0; c < 4; c++) image.data[4 * i + c] = c < 3 ? Math.round(255 * this.map[3 * i + c]) : 255;
    context.putImageData(image, 0, 0);
  }
}

/** Round numbers that divide a range, some `count` of them. */
export function roundTicks(low, high, count) {
  const rough = (high - low) / Math.max(count - 1, 1);
  if (!(rough > 0)) return [low];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((f) => f * power).find((s) => s >= rough * (1 - 1e-9));
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) ticks.push(k * step);
  return ticks;
}

/** A time [s] with its unit. */
export function shownTime(time) {
  return time < 1 ? `${(1e3 * time).toFixed(2)} ms` : `${time.toFixed(2)} s`;
}

/** A number for people: four digits, no exponent where it can be helped. */
export function shown(value) {
  if (!Number.isFinite(value)) return '–';
  const rounded = Number(value.toPrecision(4));
  return rounded === 0 ? '0' : String(rounded);
}
