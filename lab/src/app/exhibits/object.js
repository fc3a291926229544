// An estimated object as a cloud of sheets: draws of what is uncertain of it, all under the motion that is set.
import { button, make } from "../elements.js";
import { withValues } from "../change.js";
import { trimmed } from "../quantity.js";
import { isTable } from "./series.js";

const DURATION = 2; // s of each sheet
const PICTURES = 30; // a second
const MOST_SHEETS = 24;
const DEG = Math.PI / 180;

export function cloudOf(element, desk, scenes) {
  const { payload } = desk;
  const samples = (Array.isArray(payload.samples) ? payload.samples : []).filter((sample) => isTable(sample?.set)).slice(0, MOST_SHEETS);
  const table = make("table", {}, make("caption", {}, `From ${String(payload.source ?? "the file").slice(0, 80)}`), numbers(payload));
  const says = make("p", { role: "status" });
  const go = button("Show the cloud under this motion", () => begin(), { disabled: samples.length === 0 });
  const away = button("Only the sheet", () => {
    cloud = null;
    scenes[0]?.view.setCloud([]);
  });
  element.append(table, make("p", {}, go, " ", away), says);
  let cloud = null;

  async function begin() {
    go.disabled = true;
    says.textContent = "computing…";
    try {
      const scenarios = samples.map(({ set }) => ({
        ...withValues(desk.seats[0].scenario, Object.fromEntries(Object.entries(set).filter(([name]) => !name.startsWith("motion.")))),
        duration: DURATION, transient: 0.3 * DURATION,
      }));
      const { recordings } = await desk.pool.ask({ ask: "run", scenarios, snapshotInterval: 1 / PICTURES });
      const { observations } = await desk.pool.ask({ ask: "observe", scenarios, repeats: 1, seed: 0 });
      cloud = recordings;
      says.textContent = spreadOf(observations.map(([first]) => first));
      desk.restart();
    } catch (error) {
      says.textContent = `The cloud cannot be computed: ${error.message}`;
    }
    go.disabled = false;
  }

  desk.on("drawn", () => {
    if (!cloud) return;
    const now = desk.seats[0].live.clock % DURATION;
    scenes[0]?.view.setCloud(cloud.map((recording) => frameAt(recording, now)).filter(Boolean));
  });
  desk.on("change", () => {
    if (cloud) says.textContent = "The sheet is under another motion now: show the cloud again.";
  });
}

function numbers(payload) {
  const known = (Array.isArray(payload.parameters) ? payload.parameters : []).filter((p) => isTable(p) && Number.isFinite(p.value));
  const rows = known.map(({ name, display, value, low, high, unit }) => {
    const factor = { "pi rad/s": Math.PI, deg: DEG, mm: 1e-3, g: 1e-3 }[display] ?? 1;
    const cell = (number) => (Number.isFinite(number) ? trimmed(number / factor, 3) : "–");
    return make("tr", {}, make("th", { scope: "row" }, String(name)), make("td", {}, cell(value)),
      make("td", {}, `[${cell(low)}, ${cell(high)}]`), make("td", {}, String((factor === 1 ? unit : display) ?? "")));
  });
  const head = make("tr", {}, ...["number", "value", "interval", "unit"].map((word) => make("th", { scope: "col" }, word)));
  return make("tbody", {}, head, ...rows);
}

function spreadOf(observations) {
  const rates = observations.filter((o) => !o.failure && Number.isFinite(o.spin.rate)).map((o) => o.spin.rate / DEG);
  const failed = observations.filter((o) => o.failure).length;
  if (rates.length < 2) return `${failed} of ${observations.length} sheets fail under this motion.`;
  const mean = rates.reduce((sum, rate) => sum + rate, 0) / rates.length;
  const sd = Math.sqrt(rates.reduce((sum, rate) => sum + (rate - mean) ** 2, 0) / (rates.length - 1));
  return `${observations.length} sheets: ${mean.toFixed(0)} ± ${sd.toFixed(0)} °/s${failed ? `, ${failed} fail` : ""}.`;
}

function frameAt(recording, now) {
  const { snapshotTime, snapshots, platePose } = recording;
  const each = snapshots.length / snapshotTime.length;
  const k = Math.min(snapshotTime.length - 1, Math.round(now * PICTURES));
  if (!(each > 0) || k < 0) return null;
  const pose = Array.isArray(platePose[k]) ? platePose[k] : Array.from(platePose.subarray(6 * k, 6 * k + 6));
  return { time: snapshotTime[k], nodes: snapshots.subarray(k * each, (k + 1) * each), pose };
}
