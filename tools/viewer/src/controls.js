// The panel, the time slider and the colour bar: what is on the page round the picture.
import { roundTicks, shown } from './colours.js';

const escape = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** Fills the viewer's place; returns its parts by name. */
export function makeControls(root, scene, fields, tools) {
  const options = [...fields.values()].map((f) => `<option value="${f.id}">${escape(f.label)}</option>`).join('');
  const check = (id, label, on) => `<label><input type="checkbox" id="${id}"${on ? ' checked' : ''}>${escape(label)}</label>`;
  const toolChecks = tools.map((tool, i) => check(`tool-${i}`, tool.name, true)).join('');
  const mirrored = scene.mirror.some(Boolean);
  root.innerHTML = `
    <div class="stage" id="stage">
      <div class="scalebar"><strong id="bar-label"></strong><canvas id="bar"></canvas><div class="ticks" id="bar-ticks"></div></div>
      <div class="legend3d" id="legend3d" hidden><i class="warp"></i>warp<i class="weft"></i>weft</div>
      <div class="views" role="group" aria-label="Views">${['Iso', 'Below', 'Top', 'Front', 'Side'].map((v) => `<button type="button" data-view="${v.toLowerCase()}">${v}</button>`).join('')}</div>
    </div>
    <div class="panel">
      <label class="wide"><span>Colour by</span><select id="field">${options}</select></label>
      <div class="row"><select id="range" aria-label="Range of the colours"><option value="run">range of the run</option><option value="frame">of this frame</option><option value="own">from, to:</option></select>
        <input type="number" id="low" step="any" aria-label="from" hidden><input type="number" id="high" step="any" aria-label="to" hidden></div>
      <fieldset><legend>Show</legend><div class="checks">${check('yarns', 'yarn lines', true)}${check('edges', 'mesh', false)}${mirrored ? check('whole', 'whole part', true) : ''}</div></fieldset>
      ${tools.length ? `<fieldset><legend>Tools</legend><div class="checks">${toolChecks}</div>
        <label class="row">opacity <input type="range" id="opacity" min="0.05" max="1" step="0.05" value="0.15"></label></fieldset>` : ''}
      <fieldset><legend>Cut</legend><div class="row"><select id="cut" aria-label="Cut plane"><option value="-1">none</option><option value="0">at x</option><option value="1">at y</option><option value="2">at z</option></select>
        <input type="range" id="cut-place" min="0" max="1000" value="500" aria-label="Place of the cut" disabled></div><output id="cut-at" class="hint"></output></fieldset>
      <fieldset class="picked"><legend>Element</legend><div id="picked"><span class="hint">Click the sheet for an element's values and history.</span></div></fieldset>
    </div>
    <div class="playback"><button type="button" id="play" aria-label="Play">▶</button>
      <input type="range" id="frame" min="0" max="${scene.times.length - 1}" value="${scene.times.length - 1}" aria-label="Frame"><output id="time"></output></div>`;
  const parts = {};
  for (const element of root.querySelectorAll('[id]')) parts[element.id] = element;
  parts.views = [...root.querySelectorAll('[data-view]')];
  return parts;
}

/** Draws the colour bar; marks ends beyond which there are values. */
export function drawBar(parts, field, scale) {
  parts['bar-label'].textContent = `${field.label}${field.units ? ` [${field.units}]` : ''}`;
  scale.draw(parts.bar);
  const ticks = roundTicks(scale.low, scale.high, 5);
  const span = scale.high - scale.low;
  parts['bar-ticks'].innerHTML = ticks
    .map((v) => {
      const place = (100 * (v - scale.low)) / span;
      const end = place < 3 ? ' class="first"' : place > 97 ? ' class="last"' : '';
      return `<span${end} style="left:${place.toFixed(2)}%">${shown(v)}</span>`;
    })
    .join('');
}
