// The 3-D view of a report: reads what the page carries, and lets the reader turn, colour, cut, play and ask.
import {
  AmbientLight, Box3, ColorManagement, DirectionalLight, LinearSRGBColorSpace, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { readCorners, Series } from './blocks.js';
import { Scale, shownTime } from './colours.js';
import { drawBar, makeControls } from './controls.js';
import { Cut } from './cut.js';
import { makeFields } from './fields.js';
import { showPicked } from './picked.js';
import { imagesOf, Sheet } from './sheet.js';
import { loadTools } from './tools.js';

ColorManagement.enabled = false; // colours as the bar has them

const VIEWS = { iso: [-0.62, -1, 0.75], below: [-0.62, -1, -0.75], top: [0, -1e-4, 1], front: [0, -1, 0], side: [1, 0, 0] };
const FRAMES_A_SECOND = 10;
const MARGIN = 0.16; // of the view, round the sheet: bar and buttons are there

class Viewer {
  constructor(root, scene, triangles, reference, position, tools) {
    this.scene = scene;
    this.tools = tools;
    this.fields = makeFields(scene.fields);
    this.parts = makeControls(root, scene, this.fields, tools);
    this.sheet = new Sheet(scene, triangles, reference, position);
    this.images = imagesOf(scene.mirror);
    this.cut = new Cut();
    this.frame = scene.times.length - 1;
    this.field = this.fields.get('shear_angle') ?? [...this.fields.values()][0];
    this.element = null;

    this.world = new Scene();
    this.world.add(this.sheet.group, ...tools.map((tool) => tool.group), ...this.cut.objects());
    this.camera = new PerspectiveCamera(28, 1, 0.001, 100);
    this.camera.up.set(0, 0, 1);
    const lamp = new DirectionalLight(0xffffff, 1.15);
    lamp.position.set(-0.5, 0.7, 1);
    this.camera.add(lamp);
    this.world.add(this.camera, new AmbientLight(0xffffff, 2.15));
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.localClippingEnabled = true;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.parts.stage.prepend(this.renderer.domElement);
    this.orbit = new OrbitControls(this.camera, this.renderer.domElement);
    this.orbit.addEventListener('change', () => this.draw());
    this.connect();
  }

  async start() {
    await this.sheet.position.load();
    this.showLines();
    this.setTheme();
    this.sheet.move(this.frame);
    this.resize();
    this.look('iso');
    await this.setField(this.field.id);
    this.setFrame(this.frame);
  }

  // --- what is seen

  bounds() {
    const box = new Box3().setFromObject(this.sheet.group);
    for (const tool of this.tools) if (tool.group.visible) box.expandByObject(tool.group);
    return box;
  }

  /** Looks at the middle of the sheet from where the whole of it is just seen. */
  look(view) {
    const { camera } = this;
    const centre = new Box3().setFromObject(this.sheet.group).getCenter(new Vector3());
    camera.position.copy(centre).add(new Vector3(...VIEWS[view]).normalize());
    camera.lookAt(centre);
    camera.updateMatrixWorld();
    const upright = (1 - MARGIN) * Math.tan((Math.PI / 360) * camera.fov);
    const distance = this.sheet.points().reduce((most, point) => {
      const seen = point.applyMatrix4(camera.matrixWorldInverse); // from one length unit away, along -z
      return Math.max(most, seen.z + 1 + Math.max(Math.abs(seen.x) / camera.aspect, Math.abs(seen.y)) / upright);
    }, 0);
    camera.near = 0.02 * distance;
    camera.far = 10 * distance;
    camera.position.sub(centre).multiplyScalar(distance).add(centre);
    camera.updateProjectionMatrix();
    this.orbit.target.copy(centre);
    this.orbit.update();
    this.draw();
  }

  setFrame(frame) {
    this.frame = frame;
    this.sheet.move(frame);
    for (const tool of this.tools) tool.move(frame);
    this.parts.frame.value = frame;
    const driven = this.tools.find((tool) => tool.displacement.some((d) => d !== 0));
    const stroke = driven ? `, ${driven.name} ${(1e3 * driven.displacement[frame]).toFixed(1)} mm` : '';
    this.parts.time.textContent = `${shownTime(this.scene.times[frame])}${stroke}`;
    this.paint();
    this.updateCut();
    this.showElement();
  }

  async setField(id) {
    const field = this.fields.get(id);
    await field.series.load();
    this.field = field;
    this.paint();
    this.showElement();
  }

  range() {
    const { range, low, high } = this.parts;
    if (range.value === 'own' && low.value !== '' && high.value !== '') return [Number(low.value), Number(high.value)];
    if (range.value === 'frame') return this.field.range([this.frame]);
    this.field.wholeRange ??= this.field.range(this.scene.times.map((_, i) => i));
    return this.field.wholeRange;
  }

  paint() {
    if (!this.field.series.numbers && this.field.series.block) return; // still on its way
    const [low, high] = this.range();
    const scale = new Scale(low, high, this.field.signed && low < 0);
    this.sheet.paint(this.field, this.frame, scale);
    drawBar(this.parts, this.field, scale);
    this.draw();
  }

  showLines() {
    const yarns = this.parts.yarns.checked;
    this.sheet.show({ warp: yarns, weft: yarns, edges: this.parts.edges.checked });
    this.sheet.moveLines();
    this.parts.legend3d.hidden = !yarns;
    this.draw();
  }

  shownImages() {
    return this.parts.whole && !this.parts.whole.checked ? this.images.slice(0, 1) : this.images;
  }

  showParts() {
    this.sheet.images.forEach((image, i) => { image.visible = i < this.shownImages().length; });
    this.tools.forEach((tool, i) => {
      tool.group.visible = this.parts[`tool-${i}`].checked;
      tool.material.opacity = Number(this.parts.opacity.value);
      tool.material.depthWrite = tool.material.opacity > 0.95;
    });
    this.updateCut();
  }

  updateCut() {
    const { cut } = this;
    cut.axis = Number(this.parts.cut.value);
    this.parts['cut-place'].disabled = cut.axis < 0;
    this.parts['cut-at'].textContent = '';
    if (cut.axis >= 0) {
      const box = this.bounds();
      const [low, high] = [box.min.getComponent(cut.axis), box.max.getComponent(cut.axis)];
      cut.at = low + (high - low) * (Number(this.parts['cut-place'].value) / 1000);
      this.parts['cut-at'].textContent = `${'xyz'[cut.axis]} = ${(1e3 * cut.at).toFixed(1)} mm`;
    }
    cut.update(this.sheet, this.shownImages(), this.tools);
    for (const material of [...Object.values(this.sheet.materials), ...this.tools.map((tool) => tool.material)])
      material.clippingPlanes = cut.planes();
    this.draw();
  }

  // --- what is asked

  pick(x, y) {
    const box = this.renderer.domElement.getBoundingClientRect();
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height), this.camera);
    const meshes = this.sheet.images.filter((image) => image.visible).map((image) => image.children[0]);
    const hit = ray.intersectObjects(meshes, false).find(({ point }) => this.cut.planes().every((plane) => plane.distanceToPoint(point) >= 0));
    if (!hit) return;
    this.element = { number: hit.faceIndex, mirrored: hit.object !== meshes[0] };
    this.showElement();
    this.parts.picked.parentElement.scrollIntoView({ block: 'nearest' });
  }

  showElement() {
    if (!this.element) return;
    showPicked(this.parts.picked, this.element.number, { ...this, mirrored: this.element.mirrored });
  }

  // --- the page round it

  connect() {
    const { parts } = this;
    parts.field.addEventListener('change', () => this.setField(parts.field.value));
    parts.frame.addEventListener('input', () => this.setFrame(Number(parts.frame.value)));
    parts.play.addEventListener('click', () => this.play());
    for (const part of [parts.range, parts.low, parts.high])
      part.addEventListener('input', () => {
        const own = parts.range.value === 'own';
        if (own && parts.low.value === '' && parts.high.value === '')
          [parts.low.value, parts.high.value] = (this.field.wholeRange ?? [0, 1]).map((v) => Number(v.toPrecision(4)));
        parts.low.hidden = parts.high.hidden = !own;
        this.paint();
      });
    for (const part of [parts.yarns, parts.edges]) part.addEventListener('change', () => this.showLines());
    for (const part of [parts.whole, parts.opacity, ...this.tools.map((_, i) => parts[`tool-${i}`])])
      part?.addEventListener('input', () => this.showParts());
    for (const part of [parts.cut, parts['cut-place']]) part.addEventListener('input', () => this.updateCut());
    for (const button of parts.views) button.addEventListener('click', () => this.look(button.dataset.view));
    const canvas = this.renderer.domElement;
    let pressed = null;
    canvas.addEventListener('pointerdown', (event) => { pressed = [event.clientX, event.clientY]; });
    canvas.addEventListener('pointerup', (event) => {
      const moved = pressed ? Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) : Infinity;
      if (moved < 5 && event.button === 0) this.pick(event.clientX, event.clientY);
    });
    new ResizeObserver(() => this.resize()).observe(parts.stage);
    addEventListener('themechange', () => this.setTheme());
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.setTheme());
  }

  play() {
    const { parts } = this;
    if (this.playing) {
      clearInterval(this.playing);
      this.playing = null;
    } else {
      if (this.frame === this.scene.times.length - 1) this.setFrame(0);
      this.playing = setInterval(() => {
        if (this.frame + 1 < this.scene.times.length) this.setFrame(this.frame + 1);
        else this.play();
      }, 1000 / FRAMES_A_SECOND);
    }
    parts.play.textContent = this.playing ? '❚❚' : '▶';
    parts.play.setAttribute('aria-label', this.playing ? 'Pause' : 'Play');
  }

  setTheme() {
    const style = getComputedStyle(document.documentElement);
    this.cut.colours(style.getPropertyValue('--s1').trim(), style.getPropertyValue('--soft').trim());
    this.draw();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.parts.stage;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Draws once, soon, however often it is asked. */
  draw() {
    this.due ??= requestAnimationFrame(() => {
      this.due = null;
      this.renderer.render(this.world, this.camera);
      this.renderer.domElement.dataset.drawn = Number(this.renderer.domElement.dataset.drawn ?? 0) + 1;
    });
  }
}

async function begin() {
  const root = document.getElementById('viewer');
  try {
    const scene = JSON.parse(document.getElementById('scene').textContent);
    const [triangles, reference, tools] = await Promise.all([
      readCorners(scene.triangles.block), new Series(scene.reference).load(), loadTools(scene),
    ]);
    const viewer = new Viewer(root, scene, triangles, reference.frame(0), new Series(scene.position), tools);
    await viewer.start();
    viewer.showParts();
    window.towformViewer = viewer; // for tests and the curious
    root.dataset.ready = 'yes';
  } catch (error) {
    root.innerHTML = '<p class="absent"></p>';
    root.firstChild.textContent = `The 3-D view cannot be shown: ${error.message}. Curves and verdict are below.`;
    root.dataset.ready = 'failed';
  }
}

begin();
