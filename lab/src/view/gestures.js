// Mouse, touch and keyboard on the picture: turn it, move it, come nearer, or push the sheet.

const TURN_PER_PIXEL = 0.008, KEY_TURN = Math.PI / 24, KEY_PAN = 0.06, KEY_ZOOM = 1.15;
/** What the keys do, in words for whoever asks. */
export const PICTURE_KEYS =
  "arrows: turn the picture \u00b7 shift and arrows: move it \u00b7 + and \u2212: nearer and further \u00b7 " +
  "0 to 3: from the side, from above, along the bar, with the plate";

const LOOKS = { 0: "default", 1: "above", 2: "bar", 3: "plate" };

/**
 * What the gestures act on.
 * @typedef {object} Hands
 * @property {(byAzimuth: number, byElevation: number) => void} orbit
 * @property {(right: number, up: number) => void} pan by shares of the picture's height
 * @property {(factor: number) => void} zoom
 * @property {(name: string) => void} look
 * @property {(x: number, y: number) => boolean} grasp whether the sheet is there; places in CSS px of the picture
 * @property {(x: number, y: number) => void} drag
 * @property {(letGo: boolean) => void} release whether it was let go, or the gesture broken off
 */
export class Gestures {
  /** @param {HTMLCanvasElement} canvas @param {Hands} hands */
  constructor(canvas, hands) {
    this.canvas = canvas;
    this.hands = hands;
    this.pointers = new Map();
    this.doing = "";
    this.listeners = [
      ["pointerdown", (event) => this.down(event)], ["pointermove", (event) => this.move(event)],
      ["pointerup", (event) => this.up(event, true)], ["pointercancel", (event) => this.up(event, false)],
      ["wheel", (event) => this.wheel(event)], ["keydown", (event) => this.key(event)],
      ["dblclick", () => hands.look("default")], ["contextmenu", (event) => event.preventDefault()],
    ];
    for (const [kind, hear] of this.listeners) canvas.addEventListener(kind, hear, { passive: false });
  }

  place({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    return [clientX - box.left, clientY - box.top];
  }

  down(event) {
    const at = this.place(event);
    this.canvas.focus({ preventScroll: true });
    this.pointers.set(event.pointerId, at);
    this.canvas.setPointerCapture?.(event.pointerId);
    if (this.pointers.size > 1) {
      if (this.doing === "push") this.hands.release(false);
      this.doing = "pinch";
    } else if (event.button === 2 || event.shiftKey) this.doing = "pan";
    else if (event.button === 0 && !event.ctrlKey && !event.metaKey && this.hands.grasp(...at)) this.doing = "push";
    else this.doing = "orbit";
    event.preventDefault();
  }

  move(event) {
    const before = this.pointers.get(event.pointerId), at = this.place(event);
    if (!before) {
      if (event.pointerType === "mouse") this.hands.hover?.(...at);
      return;
    }
    const dx = at[0] - before[0], dy = at[1] - before[1], tall = Math.max(this.canvas.clientHeight, 1);
    if (this.doing === "pinch") this.pinch(event.pointerId, before, at, tall);
    this.pointers.set(event.pointerId, at);
    if (this.doing === "orbit") this.hands.orbit(-dx * TURN_PER_PIXEL, dy * TURN_PER_PIXEL);
    else if (this.doing === "pan") this.hands.pan(-dx / tall, dy / tall);
    else if (this.doing === "push") this.hands.drag(...at);
  }

  /** Two fingers: nearer by how far apart they go, along by where their middle goes. */
  pinch(id, before, at, tall) {
    const other = [...this.pointers].find(([key]) => key !== id)?.[1];
    if (!other) return;
    const apart = (p) => Math.max(Math.hypot(p[0] - other[0], p[1] - other[1]), 1);
    this.hands.zoom(apart(before) / apart(at));
    this.hands.pan((before[0] - at[0]) / (2 * tall), (at[1] - before[1]) / (2 * tall));
  }

  up(event, letGo) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (this.doing === "push") this.hands.release(letGo);
    this.doing = this.pointers.size > 0 ? "wait" : "";
  }

  /** The page scrolls on, unless the picture was chosen. */
  wheel(event) {
    if (!event.ctrlKey && document.activeElement !== this.canvas) return;
    event.preventDefault();
    const lines = event.deltaMode === 1 ? 16 : 1;
    this.hands.zoom(Math.exp(Math.max(-80, Math.min(80, event.deltaY * lines)) * 0.0025));
  }

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const way = ways[event.key], { hands } = this;
    if (way && event.shiftKey) hands.pan(way[0] * KEY_PAN, way[1] * KEY_PAN);
    else if (way) hands.orbit(way[0] * KEY_TURN, way[1] * KEY_TURN);
    else if (event.key === "+" || event.key === "=") hands.zoom(1 / KEY_ZOOM);
    else if (event.key === "-" || event.key === "\u2212" || event.key === "_") hands.zoom(KEY_ZOOM);
    else if (Object.hasOwn(LOOKS, event.key)) hands.look(LOOKS[event.key]);
    else if (event.key === "Escape" && this.doing === "push") {
      hands.release(false);
      this.doing = "wait";
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  destroy() {
    for (const [kind, hear] of this.listeners) this.canvas.removeEventListener(kind, hear);
  }
}
