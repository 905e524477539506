// The tools: grey, half transparent, moving along their axis; images of those that are modelled in part like the sheet.
import { BufferAttribute, BufferGeometry, DoubleSide, Group, Mesh, MeshLambertMaterial } from 'three';
import { readCorners, Series } from './blocks.js';
import { imagesOf } from './sheet.js';

const TINTS = [0x7d8b99, 0x9a8f7f, 0x86927f, 0x927f8f];

class Tool {
  constructor(entry, number, points, corners, mirror) {
    this.name = entry.name;
    this.direction = entry.direction;
    this.displacement = entry.displacement;
    this.points = points;
    this.corners = corners;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(points, 3));
    geometry.setIndex(new BufferAttribute(corners, 1));
    const flat = geometry.toNonIndexed();
    flat.computeVertexNormals();
    this.material = new MeshLambertMaterial({ color: TINTS[number % TINTS.length], side: DoubleSide, transparent: true, opacity: 0.15,
      depthWrite: false });
    geometry.computeBoundingBox();
    const { min, max } = geometry.boundingBox;
    const part = (low, high) => low >= -1e-3 * (high - low);
    this.images = imagesOf([mirror[0] && part(min.x, max.x), mirror[1] && part(min.y, max.y)]);
    this.group = new Group();
    for (const [x, y] of this.images) {
      const mesh = new Mesh(flat, this.material);
      mesh.scale.set(x, y, 1);
      mesh.renderOrder = 2;
      this.group.add(mesh);
    }
  }

  move(frame) {
    const d = this.displacement[frame];
    this.group.position.set(...this.direction.map((component) => component * d));
  }
}

export async function loadTools(scene) {
  return Promise.all(scene.tools.map(async (entry, number) => {
    const points = (await new Series(entry.points).load()).frame(0);
    return new Tool(entry, number, points, await readCorners(entry.triangles.block), scene.mirror);
  }));
}
