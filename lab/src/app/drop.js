// Files that are opened or dropped: scenarios in TOML, and tracked poses in CSV. Nothing leaves the page.
import { make } from "./elements.js";
import { scenarioFrom } from "./toml.js";

const LARGEST = 4e6; // bytes

/**
 * @param {object} desk
 * @param {(poses: object) => void} showPoses what to do with poses
 * @returns {() => void} opens the system's file dialogue
 */
export function files(desk, showPoses) {
  const input = make("input", { type: "file", accept: ".toml,.csv", hidden: true, "aria-label": "A scenario or poses",
    onchange: () => {
      if (input.files[0]) take(input.files[0]);
      input.value = "";
    } });
  document.body.append(input);
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  document.addEventListener("dragleave", () => document.body.classList.remove("dropping"));
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    if (event.dataTransfer?.files[0]) take(event.dataTransfer.files[0]);
  });

  async function take(file) {
    try {
      if (file.size > LARGEST) throw new Error(`${(file.size / 1e6).toFixed(0)} MB: at most 4 MB here`);
      const text = await file.text();
      if (text.includes("\0")) throw new Error("no text: a scenario's TOML or poses in CSV belong here. For runs and stores type plategait lab FILE");
      if (/\.csv$/i.test(file.name)) showPoses(posesFrom(text));
      else if (desk.set(scenarioFrom(text, desk.facts.presets[Object.keys(desk.facts.presets)[0]].scenario, desk.facts)))
        desk.tell("notice", `${file.name} is on the plate`);
    } catch (error) {
      desk.tell("notice", `${file.name}: ${error.message}`);
    }
  }
  return () => input.click();
}

/** Poses as `plategait track` writes them: time, place and angle by their headings. */
export function posesFrom(text) {
  const lines = text.split(/\r?\n/).filter((line) => line.trim() && !line.startsWith("#"));
  const names = (lines[0] ?? "").split(",").map((name) => name.trim());
  const column = (name) => names.indexOf(name);
  const wanted = ["time_s", "x_mm", "y_mm", "angle_deg"];
  const missing = wanted.filter((name) => column(name) < 0);
  if (missing.length) throw new Error(`no column ${missing.join(", ")}: poses have ${wanted.join(",")}`);
  if (lines.length > 100_000) throw new Error(`${lines.length} rows: at most 100,000`);
  const poses = { time: [], x: [], y: [], angle: [] };
  for (const line of lines.slice(1)) {
    const cells = line.split(",");
    const [time, x, y, angle] = wanted.map((name) => (cells[column(name)]?.trim() ? Number(cells[column(name)]) : NaN));
    if (!Number.isFinite(time) || !Number.isFinite(x) || !Number.isFinite(y) || !Number.isFinite(angle)) continue;
    poses.time.push(time);
    poses.x.push(x / 1000);
    poses.y.push(y / 1000);
    poses.angle.push((angle * Math.PI) / 180);
  }
  if (poses.time.length < 2) throw new Error("fewer than two poses in it");
  return poses;
}
