// Where the picture is taken from: around a target, near or far, and the views that have names.
import { PerspectiveCamera, Vector3 } from "three";

const RAD = Math.PI / 180;
const FIELD_OF_VIEW = 24; // degrees
const LOWEST = -20 * RAD, HIGHEST = 89.9 * RAD, NEAREST = 0.25, FURTHEST = 6;
/** Share of the picture's width that the plate may fill, and of its height from the side and, more, from above. */
const WIDE = 0.9, HIGH = 0.74, HIGH_FROM_ABOVE = 0.18;

/** Views by name: from which side and how high; `riding` is with the plate, which then stands still in the picture. */
export const VIEWS = {
  default: { azimuth: -24 * RAD, elevation: 27 * RAD },
  above: { azimuth: -90 * RAD, elevation: HIGHEST },
  bar: { azimuth: 0, elevation: 5 * RAD },
  plate: { azimuth: -24 * RAD, elevation: 27 * RAD, riding: true },
};

export class ViewCamera {
  constructor() {
    this.camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 10);
    this.camera.up.set(0, 0, 1);
    this.target = new Vector3();
    this.corners = [[0.06, 0.06]];
    this.reach = 0.06;
    this.zoom = 1;
    this.riding = false;
    this.named = "default";
    this.aspect = 1.5;
    this.panned = false;
    this.corner = new Vector3();
    this.look("default");
  }

  /** @param {number[][]} corners of what should be in the picture, on the plate, m */
  frame(corners) {
    this.corners = corners;
    this.reach = Math.max(...corners.map(([x, y]) => Math.hypot(x, y)));
    this.look(this.named);
  }

  setAspect(aspect) {
    this.aspect = Math.max(aspect, 0.05);
    this.place();
  }

  /** @param {string} name of `VIEWS`; whether there is such a view */
  look(name) {
    const view = VIEWS[name];
    if (!view) return false;
    Object.assign(this, { riding: false, ...view, named: name });
    this.zoom = 1;
    this.panned = false;
    this.target.set(0, 0, 0);
    this.place();
    return true;
  }

  orbit(byAzimuth, byElevation) {
    this.azimuth = (this.azimuth + byAzimuth) % (2 * Math.PI);
    this.elevation = Math.min(HIGHEST, Math.max(LOWEST, this.elevation + byElevation));
    this.place();
  }

  zoomBy(factor) {
    this.zoom = Math.min(FURTHEST, Math.max(NEAREST, this.zoom * factor));
    this.place();
  }

  /** Move what is looked at by shares of the picture's height: to the right and up. */
  pan(right, up) {
    const seen = this.seen(), { azimuth: a, elevation: e } = this;
    this.panned = true;
    this.target.x += seen * (-Math.sin(a) * right - Math.cos(a) * Math.sin(e) * up);
    this.target.y += seen * (Math.cos(a) * right - Math.sin(a) * Math.sin(e) * up);
    this.target.z += seen * Math.cos(e) * up;
    this.place();
  }

  /** Keep a place in the picture, as long as nobody has moved it by hand; whether the picture moved. */
  follow(x, y) {
    if (this.panned) return false;
    const room = 0.4 * this.reach * Math.max(this.zoom, 0.5);
    const dx = x - this.target.x, dy = y - this.target.y, off = Math.hypot(dx, dy);
    if (off <= room) return false;
    this.target.x += (dx * (off - room)) / off;
    this.target.y += (dy * (off - room)) / off;
    this.place();
    return true;
  }

  /** Height of the picture at the target, m. */
  seen() {
    return 2 * this.distance * Math.tan((FIELD_OF_VIEW * RAD) / 2);
  }

  place() {
    const { camera } = this;
    this.distance = this.zoom * this.fitting();
    const flat = Math.cos(this.elevation);
    camera.position.set(flat * Math.cos(this.azimuth), flat * Math.sin(this.azimuth), Math.sin(this.elevation));
    camera.position.multiplyScalar(this.distance).add(this.target);
    camera.near = this.distance / 20;
    camera.far = this.distance * 12;
    camera.aspect = this.aspect;
    camera.updateProjectionMatrix();
    camera.lookAt(this.target);
    camera.updateMatrixWorld();
  }

  /** How far off all of the plate is in the picture, m. */
  fitting() {
    const tall = Math.tan((FIELD_OF_VIEW * RAD) / 2), { azimuth: a, elevation: e } = this;
    const filled = HIGH + HIGH_FROM_ABOVE * Math.sin(e) ** 4;
    let distance = 0;
    for (const [x, y] of this.corners) {
      const right = -Math.sin(a) * x + Math.cos(a) * y, inward = Math.cos(a) * x + Math.sin(a) * y;
      const up = -Math.sin(e) * inward, near = Math.cos(e) * inward;
      const wide = Math.abs(right) / (this.aspect * WIDE), high = Math.abs(up) / filled;
      distance = Math.max(distance, near + Math.max(wide, high) / tall);
    }
    return Math.max(distance, 1e-3);
  }
}
