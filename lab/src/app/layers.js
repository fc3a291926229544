// What is drawn on the sheet besides itself, and from where it is seen.
import { button, choice, make } from "./elements.js";

const LAYERS = [
  ["contact", "nodes in contact", true], ["forces", "friction", true], ["legs", "legs", true], ["trail", "way and limit", true],
  ["bending", "bending", false],
];
const VIEWS = [["default", "from the side"], ["above", "from above"], ["bar", "along the bar"], ["plate", "with the plate"]];

export function layers(stage, scenes, desk) {
  const on = Object.fromEntries(LAYERS.map(([key, , first]) => [key, first]));
  let factor = 1;
  const apply = () => {
    for (const scene of scenes) {
      scene.view.setLayers(on);
      scene.view.setExaggeration(factor);
    }
    desk.tell("theme");
    for (const scene of scenes) scene.repaint();
  };
  const boxes = LAYERS.map(([key, text, first]) => {
    const box = make("input", { type: "checkbox", checked: first, onchange: () => {
      on[key] = box.checked;
      apply();
    } });
    return make("label", {}, box, text);
  });
  const height = choice("Heights are drawn", [["1", "heights as they are"], ["3", "heights × 3"], ["10", "heights × 10"]], "1",
    (value) => {
      factor = Number(value);
      apply();
    });
  const from = choice("Seen", VIEWS, "default", (name) => {
    for (const scene of scenes) scene.view.look(name);
    for (const scene of scenes) scene.repaint();
  });
  const kick = button("Kick", () => desk.push(desk.selected, { velocity: [0, 0.15, 0], spin: 0 }),
    { title: "A push across the bar (k); or drag on the sheet" });
  const all = make("details", { class: "drawn", open: !matchMedia("(max-width: 900px)").matches }, make("summary", {}, "What is drawn"),
    make("div", { class: "layers", role: "group", "aria-label": "What is drawn" }, ...boxes, height, from, kick));
  stage.append(all);
  apply();
  return { apply };
}
