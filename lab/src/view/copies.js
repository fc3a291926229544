// Many copies of a small flat shape in one geometry, written out vertex by vertex: where the processor draws, instanced
// copies are taken one after the other, each as dear as a mesh.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage } from "three";

export class Copies {
  /**
   * @param {number[][]} corners x and y of the shape's, which come as the attribute `position`
   * @param {number[]} index three corners a triangle
   * @param {number} most copies
   * @param {Record<string, number>} fields attributes that differ from copy to copy, and how many numbers each has
   */
  constructor(corners, index, most, fields) {
    Object.assign(this, { each: corners.length, perCopy: index.length, fields });
    this.geometry = new BufferGeometry();
    const n = corners.length, places = new Float32Array(3 * n * most), triangles = new Uint32Array(index.length * most);
    for (let copy = 0; copy < most; copy++) {
      corners.forEach(([x, y], k) => places.set([x, y], 3 * (copy * n + k)));
      index.forEach((corner, k) => (triangles[copy * index.length + k] = copy * n + corner));
    }
    this.geometry.setAttribute("position", new BufferAttribute(places, 3));
    this.geometry.setIndex(new BufferAttribute(triangles, 1));
    /** What is to be written before `upload`: the fields' numbers, copy by copy. */
    this.values = {};
    for (const [name, size] of Object.entries(fields)) {
      this.values[name] = new Float32Array(size * most);
      const attribute = new BufferAttribute(new Float32Array(size * n * most), size).setUsage(DynamicDrawUsage);
      this.geometry.setAttribute(name, attribute);
    }
    this.geometry.setDrawRange(0, 0);
  }

  /** Draw the first copies from now on, as their values are. */
  upload(count) {
    this.geometry.setDrawRange(0, this.perCopy * count);
    if (count === 0) return;
    for (const name in this.fields) {
      const size = this.fields[name], from = this.values[name], attribute = this.geometry.attributes[name];
      const to = attribute.array;
      for (let copy = 0, at = 0; copy < count; copy++)
        for (let k = 0; k < this.each; k++)
          for (let d = 0; d < size; d++) to[at++] = from[size * copy + d];
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, size * this.each * count);
      attribute.needsUpdate = true;
    }
  }

  dispose() {
    this.geometry.dispose();
  }
}

/** Two triangles. */
export const QUAD = [0, 1, 2, 0, 2, 3];
