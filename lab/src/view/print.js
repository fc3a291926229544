// What is printed on the plate: rulers along two edges, in mm, and which leg is which.
import { Group } from "three";
import { css, mix } from "./colours.js";
import { Decal } from "./decal.js";

/** Width of a ruler over the plate's shorter half; px of its picture along the longest ruler, and of a leg's name. */
const WIDE = 0.137, LENGTH = 1024, NAME = [256, 64];

/** Marks along a ruler that reaches `half` both ways: places, m, how long they are, what is written there, in mm. */
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
  /** @param {number[]} half of the plate's length and width, as measured, m @param {number} pitch of its grid */
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
    const low = a - 1.25 * wide, high = low - 1.1 * wide, reach = (0.55 * wide * NAME[0]) / NAME[1];
    const word = (y) => new Decal(...NAME, [low, y - reach, low, y + reach, high, y + reach, high, y - reach]);
    const places = { left: 0.54 * b, right: -0.54 * b };
    /** Each leg's name as it is while it touches and while it is lifted, and what is said when both are. */
    this.words = ["left", "right"].flatMap((side) =>
      [true, false].map((touches) => ({ side, touches, text: `${side} leg`, decal: word(places[side]) })));
    this.words.push({ side: "", touches: false, text: "in flight", decal: word(0) });
    this.names = new Group();
    this.names.add(...this.words.map(({ decal }) => decal.mesh));
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
    for (const { side, touches, text, decal } of this.words)
      decal.paint((pen, width, height) => {
        pen.fillStyle = pen.strokeStyle = css(side ? mix(colours[side], ink, 0.25) : ink);
        write(pen, Math.round(0.62 * height), font);
        if (side) drawFoot(pen, width / 2 - pen.measureText(text).width / 2 - 0.16 * height, 0.48 * height, touches);
        pen.fillText(text, width / 2 + (side ? 0.16 * height : 0), 0.7 * height);
      });
  }

  /** Which leg touches. @param {{left: boolean, right: boolean}} touching */
  showLegs({ left, right }) {
    for (const { side, touches, decal } of this.words)
      decal.mesh.visible = side === "" ? !left && !right : touches === (side === "left" ? left : right);
  }

  dispose() {
    for (const { decal } of this.rulers) decal.dispose();
    for (const { decal } of this.words) decal.dispose();
  }
}

/** Full where it touches, hollow where it is lifted. */
const drawFoot = (pen, x, y, touches) => {
  pen.lineWidth = 4;
  pen.beginPath();
  pen.arc(x, y, 9, 0, 2 * Math.PI);
  pen.stroke();
  if (touches) pen.fill();
};

const write = (pen, size, font) => {
  pen.font = `${size}px ${font}`;
  pen.textAlign = "center";
  pen.textBaseline = "alphabetic";
};
