// The sheet: triangles with one colour each (or colours at the nodes), yarn lines on it, mesh edges, mirror images.
import {
  BufferAttribute, BufferGeometry, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, Vector3,
} from 'three';

/** Signs of the images that make a whole of a part that was modelled. */
export function imagesOf([x, y]) {
  const signs = [[1, 1]];
  if (x) signs.push(...signs.map(([a, b]) => [-a, b]));
  if (y) signs.push(...signs.map(([a, b]) => [a, -b]));
  return signs;
}

/** Lines along a yarn family on the flat sheet: ends on edges of triangles, as (node, node, share). */
function yarnLines(reference, triangles, way, spacing) {
  const ends = [];
  const across = (n) => (reference[3 * n] * -way[1] + reference[3 * n + 1] * way[0]) / spacing;
  for (let t = 0; t < triangles.length; t += 3) {
    const nodes = [triangles[t], triangles[t + 1], triangles[t + 2]];
    const s = nodes.map(across);
    const last = Math.floor(Math.max(...s) - 0.5);
    for (let k = Math.ceil(Math.min(...s) - 0.5); k <= last; k++) {
      const line = k + 0.5; // not on nodes of a mesh along the yarns
      const cuts = [];
      for (let e = 0; e < 3 && cuts.length < 2; e++) {
        const [a, b] = [e, (e + 1) % 3];
        if ((s[a] - line) * (s[b] - line) < 0) cuts.push([nodes[a], nodes[b], (line - s[a]) / (s[b] - s[a])]);
      }
      if (cuts.length === 2) ends.push(...cuts[0], ...cuts[1]);
    }
  }
  return ends;
}

export class Sheet {
  constructor(scene, triangles, reference, position) {
    this.triangles = triangles;
    this.position = position; // Series
    this.nodes = new Float32Array(3 * scene.nodes);
    this.geometry = new BufferGeometry();
    const corners = triangles.length;
    for (const name of ['position', 'normal', 'color'])
      this.geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * corners), 3));
    const faces = new MeshLambertMaterial({ vertexColors: true, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1,
      polygonOffsetUnits: 1 });
    // Black and white show on every colour of the maps and are told apart by everyone.
    const ink = (color, opacity) => new LineBasicMaterial({ color, transparent: true, opacity });
    this.materials = { faces, warp: ink(0x000000, 0.6), weft: ink(0xffffff, 0.75), edges: ink(0x000000, 0.3) };

    this.lines = [];
    let [low, high] = [Infinity, -Infinity];
    for (let i = 0; i < reference.length; i += 3) {
      low = Math.min(low, reference[i], reference[i + 1]);
      high = Math.max(high, reference[i], reference[i + 1]);
    }
    this.spacing = ((scene.mirror.some(Boolean) ? 2 : 1) * (high - low)) / 28;
    scene.yarns.forEach((way, family) => {
      if (way) this.addLines(family === 0 ? 'warp' : 'weft', yarnLines(reference, triangles, way, this.spacing));
    });
    this.addLines('edges', this.meshEdges());

    this.images = imagesOf(scene.mirror).map(([x, y]) => {
      const group = new Group();
      group.scale.set(x, y, 1);
      const mesh = new Mesh(this.geometry, faces);
      mesh.userData.sheet = true;
      group.add(mesh);
      for (const line of this.lines) {
        const segments = new LineSegments(line.geometry, this.materials[line.kind]);
        segments.userData.kind = line.kind;
        group.add(segments);
      }
      return group;
    });
    this.group = new Group();
    this.group.add(...this.images);
  }

  meshEdges() {
    const seen = new Set();
    const ends = [];
    const count = this.nodes.length / 3;
    for (let t = 0; t < this.triangles.length; t += 3)
      for (let e = 0; e < 3; e++) {
        const a = this.triangles[t + e];
        const b = this.triangles[t + ((e + 1) % 3)];
        const key = Math.min(a, b) * count + Math.max(a, b);
        if (seen.has(key)) continue;
        seen.add(key);
        ends.push(a, b, 0, b, a, 0);
      }
    return ends;
  }

  addLines(kind, ends) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(ends.length), 3));
    this.lines.push({ kind, ends, geometry });
  }

  show(kinds) {
    this.group.traverse((object) => {
      if (object.userData.kind) object.visible = kinds[object.userData.kind];
    });
    this.shown = kinds;
  }

  /** Where its nodes are, of every image that is shown. */
  points() {
    const points = [];
    for (const image of this.images.filter(({ visible }) => visible))
      for (let i = 0; i < this.nodes.length; i += 3)
        points.push(new Vector3(this.nodes[i] * image.scale.x, this.nodes[i + 1] * image.scale.y, this.nodes[i + 2]));
    return points;
  }

  /** Puts the sheet where it is in a frame. */
  move(frame) {
    this.position.frame(frame, this.nodes);
    const { triangles, nodes, geometry } = this;
    const place = geometry.attributes.position.array;
    const normal = geometry.attributes.normal.array;
    const ofNode = new Float32Array(nodes.length);
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
      const u = [nodes[b] - nodes[a], nodes[b + 1] - nodes[a + 1], nodes[b + 2] - nodes[a + 2]];
      const v = [nodes[c] - nodes[a], nodes[c + 1] - nodes[a + 1], nodes[c + 2] - nodes[a + 2]];
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      for (const at of [a, b, c]) for (let k = 0; k < 3; k++) ofNode[at + k] += n[k];
    }
    for (let i = 0; i < triangles.length; i++) {
      const at = 3 * triangles[i];
      const size = Math.hypot(ofNode[at], ofNode[at + 1], ofNode[at + 2]) || 1;
      for (let k = 0; k < 3; k++) {
        place[3 * i + k] = nodes[at + k];
        normal[3 * i + k] = ofNode[at + k] / size;
      }
    }
    geometry.attributes.position.needsUpdate = true;
    geometry.attributes.normal.needsUpdate = true;
    geometry.computeBoundingSphere();
    this.moveLines();
  }

  moveLines() {
    for (const { kind, ends, geometry } of this.lines) {
      if (this.shown && !this.shown[kind]) continue;
      const place = geometry.attributes.position.array;
      for (let i = 0; i < ends.length; i += 3)
        for (let k = 0; k < 3; k++) {
          const a = this.nodes[3 * ends[i] + k];
          place[i + k] = a + ends[i + 2] * (this.nodes[3 * ends[i + 1] + k] - a);
        }
      geometry.attributes.position.needsUpdate = true;
      geometry.computeBoundingSphere();
    }
  }

  /** Colours it by a field, on a scale. */
  paint(field, frame, scale) {
    const colour = this.geometry.attributes.color.array;
    const { triangles } = this;
    for (let i = 0; i < triangles.length; i++) {
      const row = field.nodal ? triangles[i] : i / 3;
      if (field.nodal || i % 3 === 0) scale.paint(field.value(frame, row), colour, 3 * i);
      else colour.copyWithin(3 * i, 3 * i - 3, 3 * i);
    }
    this.geometry.attributes.color.needsUpdate = true;
  }
}
