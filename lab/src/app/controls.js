// The controls: every number of the scenario that a person would turn, with its unit, range and origin.
import { button, choice, identity, make } from "./elements.js";
import { valueOf, withValue } from "./change.js";
import { GROUPS, OUTLINES, SHORTHANDS, sizeOf } from "./listed.js";
import { fault, parsed, pretty, shown } from "./quantity.js";
import { WAVEFORMS, shapeOf, shaped } from "./waveform.js";

const STEPS = 400;

/**
 * Fill the panel. `desk` tells the scenario and takes changes.
 *
 * @returns {{update(): void}}
 */
export function controls(panel, desk) {
  const fields = Object.fromEntries([...desk.facts.fields, ...SHORTHANDS].map((field) => [field.name, field]));
  const rows = [];
  const narrow = matchMedia("(max-width: 900px)").matches;
  const groups = GROUPS.map((group) => {
    const own = group.controls.filter(([name]) => fields[name]).map((control) => row(desk, fields[control[0]], control));
    rows.push(...own);
    const body = make("div", { class: "group" });
    const extra = { "Object": objectPart, "Plate motion": motionPart, "Friction and contact": lawPart,
      "Place and measurement": platePart }[group.title];
    const part = extra?.(desk, fields);
    if (part) {
      rows.push(part);
      body.append(part.element);
    }
    body.append(...own.map((each) => each.element));
    return make("details", { open: Boolean(group.open) && (!narrow || group.title === GROUPS[0].title) }, make("summary", {}, group.title), body);
  });
  const origins = make("p", { class: "origins" },
    mark("published"), " printed in the source  ", mark("inferred"), " inferred  ", mark("yours"), " yours");
  panel.append(presets(desk), origins, ...groups);
  const update = () => rows.forEach((each) => each.update());
  update();
  return { update };
}

function presets(desk) {
  const names = Object.keys(desk.facts.presets);
  const options = [["", "Begin from…"], ...names.map((name) => [name, name])];
  const select = choice("Begin from a preset", options, "", (name) => {
    if (name) desk.set(structuredClone(desk.facts.presets[name].scenario));
    select.value = "";
  });
  return make("div", { class: "row wide" }, make("label", {}, make("span", {}, "Preset"), select));
}

const MARKS = { published: "●", inferred: "◐", yours: "○" };

function mark(origin) {
  return make("span", { class: `origin ${origin}`, "aria-hidden": "true" }, MARKS[origin]);
}

/** Where a number comes from: the preset that the scenario is named after, if it still has that preset's value. */
function originOf(desk, name) {
  const preset = desk.facts.presets[desk.scenario().name];
  if (!preset) return ["yours", "yours"];
  const [own, theirs] = [valueOf(desk.scenario(), name), valueOf(preset.scenario, name)];
  if (JSON.stringify(own) !== JSON.stringify(theirs)) return ["yours", "yours"];
  if (preset.published[name]) return ["published", `published: ${preset.published[name]}`];
  if (preset.inferred[name]) return ["inferred", `inferred: ${preset.inferred[name]}`];
  return ["yours", "the model's default"];
}

/** One number: what it is called, its value in text, a slider, where it comes from. */
function row(desk, field, [name, title, least, most, byFactor]) {
  const id = identity("field");
  const says = make("p", { class: "fault", id: `${id}-fault`, role: "alert" });
  const origin = mark("yours");
  const text = make("input", { type: "text", id, class: "number", autocomplete: "off", spellcheck: false,
    inputMode: "decimal", "aria-describedby": `${id}-fault` });
  const slider = make("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": `${title}, slider` });
  const toValue = (place) => scaled(place / STEPS, least, most, byFactor) * (field.factor ?? 1);
  const current = () => (name === "natural_frequency" ? desk.naturalFrequency() : valueOf(desk.scenario(), name));

  const put = (value) => {
    const wrong = fault(value, field);
    const refusal = wrong ?? desk.change(name, value);
    says.textContent = refusal ?? "";
    text.setAttribute("aria-invalid", String(Boolean(refusal)));
    if (!refusal) update();
  };
  text.addEventListener("change", () => {
    const read = parsed(text.value, field, desk.facts.units);
    if ("fault" in read) {
      says.textContent = read.fault;
      text.setAttribute("aria-invalid", "true");
    } else put(read.value);
  });
  text.addEventListener("keydown", (event) => {
    if (event.key === "Escape") update();
  });
  slider.addEventListener("input", () => put(Number(toValue(Number(slider.value)).toPrecision(3))));

  function update() {
    const value = current();
    if (document.activeElement !== text || text.getAttribute("aria-invalid") !== "true") {
      text.value = shown(value, field);
      text.setAttribute("aria-invalid", "false");
      says.textContent = "";
    }
    if (document.activeElement !== slider)
      slider.value = String(Math.round(STEPS * placed((value ?? 0) / (field.factor ?? 1), least, most, byFactor)));
    slider.setAttribute("aria-valuetext", `${shown(value, field)} ${pretty(field.display)}`);
    const [kind, where] = originOf(desk, name);
    origin.className = `origin ${kind}`;
    origin.textContent = MARKS[kind];
    element.title = `${field.description ?? title} (${where})`;
  }

  const element = make("div", { class: "row", "data-field": name },
    make("label", { for: id }, origin, title), text, make("span", { class: "unit" }, pretty(field.display)), slider, says);
  return { element, update };
}

function scaled(share, least, most, byFactor) {
  return byFactor ? least * (most / least) ** share : least + share * (most - least);
}

function placed(value, least, most, byFactor) {
  const share = byFactor ? Math.log(Math.max(value, least) / least) / Math.log(most / least) : (value - least) / (most - least);
  return Math.min(1, Math.max(0, Number.isFinite(share) ? share : 0));
}

/** The outline: its kind, and what that kind is told by. */
function objectPart(desk, fields) {
  const element = make("div", { class: "part" });
  const kinds = [...Object.keys(OUTLINES).map((kind) => [kind, kind]), ["own", "its own polygon"], ["mask", "a picture's"]];
  const select = choice("Outline", kinds, "disk", (kind) => {
    const outline = desk.scenario().sheet.outline;
    if (OUTLINES[kind]) desk.change("sheet.outline", OUTLINES[kind](Math.max(...sizeOf(outline))));
    update();
  });
  const sizes = make("div");
  element.append(make("div", { class: "row wide" }, make("label", {}, make("span", {}, "Outline"), select)), sizes);
  const length = (name) => fields[name] ?? { ...fields["sheet.pitch"], name, description: "size of the outline" };
  let has = "";
  let own = [];
  function update() {
    const outline = desk.scenario().sheet.outline;
    const shape = outline.shape;
    const named = shape === "polygon"
      ? Object.keys(OUTLINES).find((kind) => isLike(OUTLINES[kind](Math.max(...sizeOf(outline))), outline)) ?? "own"
      : shape;
    select.value = named;
    if (has !== shape) {
      has = shape;
      const wanted = { disk: [["radius", "Radius"]], ellipse: [["length", "Length"], ["width", "Width"]],
        rectangle: [["length", "Length"], ["width", "Width"]], mask: [["width_of_picture", "Width of the picture"]] }[shape];
      own = (wanted ?? []).map(([key, title]) => {
        const name = `sheet.outline.${key}`;
        return row(desk, length(name), [name, title, 10, 200, true]);
      });
      if (shape === "polygon") own = [polygonSize(desk, length("sheet.outline.size"))];
      sizes.replaceChildren(...own.map((each) => each.element));
    }
    own.forEach((each) => each.update());
  }
  return { element, update };
}

function isLike(a, b) {
  if (a.shape !== b.shape || a.corners.length !== b.corners.length) return false;
  return a.corners.every(([x, y], k) => Math.hypot(x - b.corners[k][0], y - b.corners[k][1]) < 1e-6);
}

/** The size of a polygon: its longer side, all corners with it. */
function polygonSize(desk, field) {
  const within = { ...desk,
    scenario: () => ({ size: Math.max(...sizeOf(desk.scenario().sheet.outline)) }),
    change: (_, value) => {
      const outline = desk.scenario().sheet.outline;
      const by = value / Math.max(...sizeOf(outline));
      return desk.change("sheet.outline", { ...outline, corners: outline.corners.map(([x, y]) => [x * by, y * by]) });
    } };
  return row(within, field, ["size", "Size", 10, 200, true]);
}

/** The swing's shape, and further sines on any axis. */
function motionPart(desk, fields) {
  const kinds = [...WAVEFORMS.map((kind) => [kind, kind]), ["own", "its own"]];
  const select = choice("Shape of the swing", kinds, "sine", (kind) => {
    if (kind !== "own") desk.change("motion", shaped(desk.scenario().motion, kind));
    update();
  });
  const list = make("ul", { class: "waves" });
  const add = button("Add a sine", () => {
    const { motion } = desk.scenario();
    desk.change("motion.waves", [...motion.waves, { axis: "z", amplitude: 0.0005, ratio: 1, phase: 0 }]);
    update();
  });
  const note = make("p", { class: "note" });
  const element = make("div", { class: "part" },
    make("div", { class: "row wide" }, make("label", {}, make("span", {}, "Waveform"), select)), note, list, add);
  const angle = fields["motion.angle"];
  const stroke = fields["motion.stroke"];
  function update() {
    const { motion } = desk.scenario();
    select.value = shapeOf(motion);
    note.textContent = motion.samples ? `and a sampled trajectory of ${motion.samples.time.length} points` : "";
    add.disabled = motion.waves.length >= 8;
    if (list.contains(document.activeElement) && list.children.length === motion.waves.length) return;
    list.replaceChildren(...motion.waves.map((wave, i) => {
      const put = (key) => (value) => {
        desk.change(`motion.waves.${i}.${key}`, value);
        update();
      };
      const measure = wave.axis.startsWith("r") ? angle : stroke;
      const amplitude = { ...measure, above: null, at_least: null, description: "amplitude" };
      const ratio = { ...angle, unit: "", display: "", factor: 1, above: 0, at_least: null, at_most: 12, example: "2" };
      const phase = { ...angle, above: null, at_least: null, at_most: null, example: "90 deg" };
      return make("li", {},
        choice("Axis", ["x", "y", "z", "rx", "ry", "rz"].map((axis) => [axis, axis]), wave.axis, (axis) => put("axis")(axis)),
        small(desk, amplitude, "amplitude", wave.amplitude, put("amplitude")),
        small(desk, ratio, "times f", wave.ratio, put("ratio")),
        small(desk, phase, "phase", wave.phase, put("phase")),
        button("×", () => {
          desk.change("motion.waves", motion.waves.filter((_, j) => j !== i));
          update();
        }, { "aria-label": `Remove the sine on ${wave.axis}` }));
    }));
  }
  return { element, update };
}

/** A number without a slider. */
function small(desk, field, title, value, put) {
  const input = make("input", { type: "text", class: "number", value: shown(value, field), inputMode: "decimal",
    "aria-label": `${title}${field.display ? ` in ${field.display}` : ""}`, autocomplete: "off" });
  input.addEventListener("change", () => {
    const read = parsed(input.value, field, desk.facts.units);
    input.setAttribute("aria-invalid", String("fault" in read));
    input.title = "fault" in read ? read.fault : "";
    if ("value" in read) put(read.value);
  });
  return make("label", { class: "small" }, input, make("span", { class: "unit" }, pretty(field.display) || title));
}

function lawPart(desk) {
  const options = [["thesis", "step at V (3.2)"], ["adams", "smooth"]];
  const select = choice("Law of friction", options, "thesis", (law) => desk.change("friction.law", law));
  const element = make("div", { class: "row wide" }, make("label", {}, make("span", {}, "Law of friction"), select));
  return { element, update: () => (select.value = desk.scenario().friction.law) };
}

/** Whether the plate ends, and where. */
function platePart(desk, fields) {
  const box = make("input", { type: "checkbox", id: identity("plate"), onchange: () => {
    desk.change("plate", box.checked ? { length: 0.2, width: 0.2 } : null);
    update();
  } });
  const field = fields["plate.length"] ?? { ...fields["sheet.pitch"], description: "size of the plate" };
  const rows = [["plate.length", "Plate along the bar"], ["plate.width", "Plate across it"]].map(([name, title]) =>
    row(desk, { ...field, name }, [name, title, 40, 500, true]));
  const sizes = make("div", {}, ...rows.map((each) => each.element));
  const element = make("div", { class: "part" },
    make("div", { class: "row wide" }, make("label", { for: box.id }, box, " The plate ends")), sizes);
  function update() {
    const { plate } = desk.scenario();
    box.checked = Boolean(plate);
    sizes.hidden = !plate;
    if (plate) rows.forEach((each) => each.update());
  }
  return { element, update };
}
