// A cut plane square to an axis: hides what lies on its near side, and draws where it cuts sheet and tools.
import { Plane, Vector3 } from 'three';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';

/** Segments in which the plane x[axis] = at cuts triangles; places are scaled, then shifted. */
function cutsOf(places, corners, [x, y], shift, axis, at, out) {
  const scale = [x, y, 1];
  const place = (n, k) => places[3 * n + k] * scale[k] + shift[k];
  for (let t = 0; t < corners.length; t += 3) {
    const ends = [];
    for (let e = 0; e < 3; e++) {
      const [a, b] = [corners[t + e], corners[t + ((e + 1) % 3)]];
      const [da, db] = [place(a, axis) - at, place(b, axis) - at];
      if (da >= 0 === db >= 0) continue;
      const share = da / (da - db);
      for (let k = 0; k < 3; k++) ends.push(place(a, k) + share * (place(b, k) - place(a, k)));
    }
    if (ends.length === 6) out.push(...ends);
  }
}

class Outline {
  constructor(width) {
    this.material = new LineMaterial({ linewidth: width });
    this.object = new LineSegments2(new LineSegmentsGeometry(), this.material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 3;
  }

  set(segments) {
    this.object.visible = segments.length > 0;
    if (!this.object.visible) return;
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry();
    this.object.geometry.setPositions(segments);
  }
}

export class Cut {
  constructor() {
    this.axis = -1; // none
    this.at = 0;
    this.plane = new Plane();
    this.sheet = new Outline(3.5);
    this.tools = new Outline(1.8);
    this.tools.material.transparent = true;
  }

  objects() {
    return [this.sheet.object, this.tools.object];
  }

  colours(sheet, tool) {
    this.sheet.material.color.set(sheet);
    this.tools.material.color.set(tool);
  }

  /** The planes that materials are to be clipped by. */
  planes() {
    return this.axis < 0 ? [] : [this.plane];
  }

  update(sheet, images, tools) {
    const [ofSheet, ofTools] = [[], []];
    if (this.axis >= 0) {
      // What is kept is away from the viewer of the standard views: above x, below y, below z.
      const sign = this.axis === 1 ? 1 : -1;
      const normal = new Vector3().setComponent(this.axis, sign);
      this.plane.set(normal, -sign * this.at);
      for (const image of images) cutsOf(sheet.nodes, sheet.triangles, image, [0, 0, 0], this.axis, this.at, ofSheet);
      for (const tool of tools)
        if (tool.group.visible)
          for (const image of tool.images) cutsOf(tool.points, tool.corners, image, tool.group.position.toArray(), this.axis, this.at, ofTools);
    }
    this.sheet.set(ofSheet);
    this.tools.set(ofTools);
  }
}
