// Where the plate's work went: a table with bars, which is its own text for screen readers.
import { element, read } from "./plot.js";

const ROWS = [
  ["plateWork", "work of the plate", "given"],
  ["kinetic", "kinetic", "stored"],
  ["gravity", "potential", "stored"],
  ["bending", "bending", "stored"],
  ["axial", "stretching", "stored"],
  ["torsion", "torsion", "stored"],
  ["contactStored", "in the contact", "stored"],
  ["frictionLoss", "lost to friction", "lost"],
  ["contactLoss", "lost in the contact", "lost"],
  ["jointLoss", "lost in the joints", "lost"],
  ["residual", "unaccounted for", "residual"],
];

/**
 * @param {HTMLElement} el
 * @returns {{update(ledger: object | null), resize(), destroy()}} a ledger as `simulation/energy.js` makes it
 */
export const energyLedger = (el) => {
  const table = element("table", "ledger");
  const caption = table.createCaption();
  caption.textContent = "Energy: nothing yet";
  const body = table.createTBody();
  const rows = ROWS.map(([name, label, kind]) => {
    const row = body.insertRow();
    const head = element("th", "", label);
    head.scope = "row";
    const bar = element("i", `bar ${kind}`);
    const track = element("td", "track");
    track.append(bar);
    const value = element("td", "value", "–");
    row.append(head, track, value);
    return { name, row, bar, value };
  });
  el.append(table);
  return {
    update(ledger) {
      if (!ledger) return;
      const unit = unitFor(Math.max(...rows.map(({ name }) => Math.abs(ledger[name]) || 0)));
      const most = Math.max(...rows.map(({ name }) => Math.abs(ledger[name]) || 0), 1e-300);
      for (const { name, row, bar, value } of rows) {
        const energy = ledger[name];
        bar.style.width = `${(100 * Math.min(1, Math.abs(energy) / most || 0)).toFixed(1)}%`;
        bar.classList.toggle("negative", energy < 0);
        value.textContent = `${read(unit.scale * energy)} ${unit.name}`;
        // Joints that a sheet does not have are not worth a line.
        row.hidden = name === "torsion" && energy === 0;
      }
      const share = `${read(100 * ledger.imbalance, 2)} %`;
      caption.textContent = ledger.closes ? `Energy: closes to ${share}` : `Energy: does not balance, out by ${share}`;
      caption.classList.toggle("fault", !ledger.closes);
    },
    resize() {},
    destroy: () => table.remove(),
  };
};

const unitFor = (most) => (most < 1e-3 ? { name: "µJ", scale: 1e6 } : most < 1 ? { name: "mJ", scale: 1e3 } : { name: "J", scale: 1 });
