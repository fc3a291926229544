// The page begins here: what the command laid into it, the sheets, the controls, what they show.
import { about } from "./app/about.js";
import { controls } from "./app/controls.js";
import { readFacts, readPayload, workerMaker } from "./app/data.js";
import { Desk } from "./app/desk.js";
import { files } from "./app/drop.js";
import { button, make } from "./app/elements.js";
import { exhibit } from "./app/exhibit.js";
import { keys } from "./app/keys.js";
import { layers } from "./app/layers.js";
import { nowTab } from "./app/now.js";
import { copyText, saveText } from "./app/save.js";
import { Scene } from "./app/scene.js";
import { fragmentOf, scenarioOf } from "./app/share.js";
import { tabs } from "./app/tabs.js";
import { theme } from "./app/theme.js";
import { fileName, tomlOf } from "./app/toml.js";
import { transport } from "./app/transport.js";
import { Pool } from "./engine/pool.js";
import { checkScenario } from "./model/scenario.js";
import { curveTab } from "./science/curve.js";
import { mapTab } from "./science/map.js";

const at = (id) => document.getElementById(id);
const SLOW_PICTURE = 14; // ms: where drawing takes more, every other picture is left out

function begin() {
  const facts = readFacts();
  if (!facts) {
    at("notice").textContent = "This file is spoilt: the model's facts are missing. Write it anew: plategait lab";
    return;
  }
  const payload = readPayload();
  const makeWorker = workerMaker();
  const workers = Math.max(1, Math.min(8, navigator.hardwareConcurrency || 2));
  const desk = new Desk({ facts, payload, pool: new Pool(makeWorker, workers), makeWorker });
  desk.on("notice", notice);
  page(desk, firstScenario(facts, payload));
}

/** What is on the plate first: the link's scenario, the command's, or the cheese. */
function firstScenario(facts, payload) {
  const usual = structuredClone(facts.presets[Object.keys(facts.presets)[0]].scenario);
  for (const find of [() => scenarioOf(location.hash, facts), () => payload.scenario]) {
    try {
      const scenario = find();
      if (!scenario) continue;
      checkScenario(scenario);
      return scenario;
    } catch (error) {
      notice(`${error.field ? `${error.field}: ` : ""}${error.message}. The ${usual.name} lies there instead.`);
    }
  }
  if (payload.kind === "spoilt") notice(`The data in this file are spoilt. The ${usual.name} lies there instead.`);
  return usual;
}

function page(desk, scenario) {
  const scenes = [];
  const stage = at("scenes");
  desk.on("seats", () => {
    while (scenes.length > desk.seats.length) scenes.pop().close();
    while (scenes.length < desk.seats.length) scenes.push(new Scene(stage, desk, scenes.length));
    for (const scene of scenes) scene.view.resize();
  });
  const bar = transport(at("transport"), desk);
  desk.add(scenario);
  const shown = layers(at("stage"), scenes, desk);
  desk.on("seats", shown.apply);
  const panel = controls(at("controls"), desk);
  const subject = actions(desk, scenes);
  const findings = tabs(at("tabs"), at("panels"), [
    { title: "Now", build: (element) => nowTab(element, desk, scenes) },
    ...(desk.payload.kind !== "none" && desk.payload.kind !== "scenario" && desk.payload.kind !== "spoilt"
      ? [{ title: "From the file", build: (element) => exhibit(element, desk, scenes) }]
      : []),
    { title: "Spin curve", build: (element) => curveTab(element, desk) },
    { title: "Map", build: (element) => mapTab(element, desk) },
  ]);
  findings.show(0);
  const changed = () => {
    for (const scene of scenes) scene.changed();
    panel.update();
    subject();
  };
  desk.on("change", changed);
  desk.on("watch", () => at("stage").scrollIntoView({ block: "nearest" }));
  changed();
  keys(desk, scenes);
  about(at("about"), desk.facts);
  new ResizeObserver(() => {
    for (const scene of scenes) scene.view.resize();
  }).observe(stage);
  window.addEventListener("hashchange", () => {
    try {
      const linked = scenarioOf(location.hash, desk.facts);
      if (linked) desk.set(linked);
    } catch (error) {
      notice(error.message);
    }
  });
  loop(desk, scenes, bar);
}

/** What can be done with the scenario as a whole; a function that says whose it is. */
function actions(desk, scenes) {
  const bar = at("actions");
  const open = files(desk, (poses) => {
    desk.payload = { ...desk.payload, kind: "poses", ...poses };
    desk.tell("poses", poses);
    notice(`${poses.time.length} poses: shown beside the sheet`);
  });
  const compare = button("Compare", () => {
    if (desk.seats.length > 1) desk.drop();
    else desk.add(structuredClone(desk.scenario()));
    compare.textContent = desk.seats.length > 1 ? "Only one" : "Compare";
    desk.select(desk.seats.length - 1);
  }, { title: "Two objects or motions side by side" });
  const appearance = button("Theme", () => {});
  bar.append(
    button("Open…", open, { title: "A scenario's TOML, or poses in CSV" }),
    button("Save TOML", () => saveText(fileName(desk.scenario()), tomlOf(desk.scenario(), desk.facts.version)),
      { title: "A file that plategait simulate takes" }),
    button("Copy link", async () => {
      const link = location.href.replace(/#.*$/, "") + fragmentOf(desk.scenario(), desk.facts);
      history.replaceState(null, "", link);
      notice((await copyText(link)) ? "The link is copied: it holds this scenario" : "The address above is the link: copy it from there");
    }),
    compare,
    button("Undo", () => desk.undo(), { title: "The change before (Ctrl+Z)" }),
    appearance,
  );
  theme(appearance, () => {
    desk.tell("theme");
    for (const scene of scenes) scene.repaint();
  });
  return () => {
    const { name, sheet, motion } = desk.scenario();
    at("subject").textContent = `${name}: ${(sheet.mass * 1000).toPrecision(3)} g on a plate at ${motion.frequency.toPrecision(3)} Hz`;
    document.title = `${name} – plategait lab`;
  };
}

let quiet = 0;

/** A word to the person, for a while. */
function notice(text) {
  at("notice").textContent = String(text).slice(0, 300);
  clearTimeout(quiet);
  quiet = setTimeout(() => (at("notice").textContent = ""), 9000);
}

/** The page's clock: as often as the screen, less often where drawing takes long. */
function loop(desk, scenes, bar) {
  let before = performance.now();
  let cost = 0;
  let odd = false;
  const turn = (now) => {
    requestAnimationFrame(turn);
    odd = !odd;
    if (cost > SLOW_PICTURE && odd) return;
    const wall = Math.max(0, (now - before) / 1000);
    before = now;
    const began = performance.now();
    let drawn = false;
    for (const scene of scenes) drawn = scene.tick(wall) || drawn;
    if (drawn) cost = 0.8 * cost + 0.2 * (performance.now() - began);
    const { live } = desk.seats[desk.selected];
    const { first, last } = live.frames;
    const slowed = live.capacity < Infinity && 0.85 * live.capacity < live.speed;
    bar.update({ clock: live.clock, first: first?.time ?? 0, last: last?.time ?? 0,
      pace: live.pace.speed || live.possible, slowed: slowed && desk.playing });
    if (drawn) desk.tell("drawn");
  };
  requestAnimationFrame(turn);
}

begin();
