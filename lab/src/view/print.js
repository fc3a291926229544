// What is printed on the plate: rulers along two edges, in mm, and which leg is which.
import { Group } from "three";
import { css, mix } from "./colours.js";
import { Decal } from "./decal.js";

/** Width of a ruler over the plate's shorter half; px of its picture along the longest ruler, and of a leg's name. */
const WIDE = 0.137, LENGTH = 1024, NAME = [256, 64];

/** Marks along a ruler that reaches `half` both ways: places, m, how long they are, and what is written there, in mm. */
export const marksAlong = (half, pitch) => {
  const marks = [], n = Math.floor(half / pitch + 1e-6), every = n > 8 ? 5 : 2;
  for (let k = -2 * n; k <= 2 * n; k++) {
    const numbered = k % (2 * every) === 0, length = numbered ? 1 : k % 2 === 0 ? 0.66 : 0.4;
    const text = numbered ? String(Number((500 * k * pitch).toPrecision(6))).replace("-", "\u2212") : "";
    marks.push({ at: (k * pitch) / 2, length, text });
  }
  return marks;
};

export class Print {
  /** @param {number[]} half length and width of the plate as far as it is measured, m @param {number} pitch of its grid, m */
  constructor([a, b], pitch) {
    this.pitch = pitch;
    const wide = WIDE * Math.min(a, b);
    const ruler = (reach, corners, free) =>
      ({ reach, free, decal: new Decal(LENGTH, Math.round((LENGTH * wide) / (2 * reach)), corners) });
    // Along the edge at low y and at high x, to be read from outside; the second has their corner.
    this.rulers = [
      ruler(a, [-a, -b, a, -b, a, wide - b, -a, wide - b], a - 1.3 * wide),
      ruler(b, [a, -b, a, b, a - wide, b, a - wide, -b], b),
    ];
    const name = (y) => {
      const x = a - 1.25 * wide, long = (1.1 * wide * NAME[0]) / NAME[1];
      return new Decal(...NAME, [x, y - long / 2, x, y + long / 2, x - 1.1 * wide, y + long / 2, x - 1.1 * wide, y - long / 2]);
    };
    this.legs = { left: name(0.62 * b), right: name(-0.62 * b) };
    this.names = new Group();
    this.names.add(this.legs.left.mesh, this.legs.right.mesh);
    this.group = new Group();
    this.group.add(...this.rulers.map(({ decal }) => decal.mesh), this.names);
  }

  recolour(colours) {
    const { plate, ink, font, dark } = colours;
    for (const { decal, reach, free } of this.rulers)
      decal.paint((pen, width, height) => {
        pen.fillStyle = pen.strokeStyle = css(mix(plate, ink, dark ? 0.72 : 0.62));
        pen.lineWidth = 2;
        write(pen, Math.round(0.52 * height), font);
        for (const { at, length, text } of marksAlong(0.985 * reach, this.pitch)) {
          const x = ((at / reach + 1) * width) / 2, half = pen.measureText(text).width / 2 + 2;
          pen.beginPath();
          pen.moveTo(x, height);
          pen.lineTo(x, height * (1 - 0.3 * length));
          pen.stroke();
          const fits = x > half && x < width - half && at < free;
          if (text && fits) pen.fillText(text === "0" ? "0 mm" : text, x, 0.6 * height);
        }
      });
    for (const [side, decal] of Object.entries(this.legs))
      decal.paint((pen, width, height) => {
        pen.fillStyle = css(mix(colours[side], ink, 0.25));
        write(pen, Math.round(0.62 * height), font);
        pen.fillText(`${side} leg`, width / 2, 0.7 * height);
      });
  }

  dispose() {
    for (const { decal } of this.rulers) decal.dispose();
    for (const decal of Object.values(this.legs)) decal.dispose();
  }
}

const write = (pen, size, font) => {
  pen.font = `${size}px ${font}`;
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
};
