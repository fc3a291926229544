// What the sheets show now: numbers, and their course over the last seconds.
import { energyLedger as ledgerChart } from "../charts/energy.js";
import { gaitDiagram } from "../charts/gait.js";
import { timeSeries } from "../charts/series.js";
import { energyLedger } from "../simulation/energy.js";
import { least } from "../simulation/observe.js";
import { rotation, slip } from "../simulation/observables.js";
import { periodOf } from "../model/motion.js";
import { make } from "./elements.js";
import { trimmed } from "./quantity.js";

const EVERY = 150; // ms
const COURSE = 4; // s of the course that charts show
const DEG = Math.PI / 180;

const NUMBERS = [
  ["gait", (read) => read.failure ? `${read.failure.kind}` : read.gait || "–"],
  ["spin rate", (read) => `${trimmed(read.rate / DEG, 3)} °/s`],
  ["along the bar", (read) => `${trimmed(read.twist[0] * 1000, 2)} mm/s`],
  ["across the bar", (read) => `${trimmed(read.twist[1] * 1000, 2)} mm/s`],
  ["drift", (read) => `${trimmed(read.drift * 1000, 3)} mm`],
  ["turned", (_, now) => `${trimmed(now.turned / DEG, 4)}°`],
  ["nodes touching", (_, now) => `${Math.round(100 * now.contact)} %`],
  ["bending, r.m.s.", (_, now) => `${trimmed(now.bending / DEG, 2)}°`],
  ["plate force, upright", (_, now) => `${trimmed(now.force, 3)} N`],
  ["energy books", (_, now) => now.books],
];

export function nowTab(element, desk, scenes) {
  const values = NUMBERS.map(([name]) => [name, make("dd", {}, "–")]);
  element.append(make("dl", { class: "readings" }, ...values.map(([name, dd]) => make("div", {}, make("dt", {}, name), dd))));
  const figure = (title, ...more) => {
    const hold = make("div");
    charts.append(make("figure", {}, make("figcaption", {}, title, ...more), hold));
    return hold;
  };
  const charts = make("div", { class: "charts" });
  element.append(charts);
  const gait = gaitDiagram(figure("Gait: when each leg touches"));
  const spin = timeSeries(figure("Spin rate over each period, deg/s"), { series: [{ label: "spin rate", colour: "--accent" }], unit: "deg/s" });
  const drift = timeSeries(figure("Drift of the centre, mm"), { series: [{ label: "drift", colour: "--walking" }], unit: "mm" });
  const plate = timeSeries(figure("Force on the plate, N, and torque, mN m"), {
    series: [{ label: "along", colour: "--left" }, { label: "across", colour: "--right" }, { label: "down", colour: "--running" },
      { label: "torque about the bar", colour: "--failed" }], unit: "" });
  const bend = timeSeries(figure("Bending, r.m.s., deg"), { series: [{ label: "bending", colour: "--running" }], unit: "deg" });
  const energy = ledgerChart(figure("Where the plate's work went, since it was laid down"));
  const all = [gait, spin, drift, plate, bend, energy];
  let last = 0;
  let shown = false;

  const update = () => {
    if (!shown || performance.now() - last < EVERY) return;
    last = performance.now();
    const { live } = desk.seats[desk.selected];
    const read = scenes[desk.selected]?.read;
    if (!read || live.samples.length < 4) return;
    const course = courseOf(live);
    // Of two sheets both numbers, each after its letter.
    const both = desk.seats.map((seat, k) => [scenes[k]?.read, k === desk.selected ? course : seat.live.samples.length < 4 ? null : courseOf(seat.live)]);
    NUMBERS.forEach(([, say], k) => {
      const words = both.map(([own, its]) => (own && its ? say(own, its.now) : "–"));
      const text = words.length > 1 ? words.map((word, j) => `${"AB"[j]} ${word}`).join("\n") : words[0];
      if (values[k][1].textContent !== text) values[k][1].textContent = text;
    });
    const { channels, period } = course;
    gait.update({ time: channels.time, left: channels.left_contact, right: channels.right_contact, flight: channels.flight, period, gait: read.gait });
    spin.update({ time: course.rateTime, values: [course.rate] });
    drift.update({ time: channels.time, values: [course.drift], limit: { value: live.scenario.slip_limit * 1000, label: "fails" } });
    bend.update({ time: channels.time, values: [Float64Array.from(channels.bend_rms, (each) => each / DEG)] });
    plate.update(forcesOf(live));
    energy.update(course.ledger);
  };
  desk.on("drawn", update);
  desk.on("theme", () => all.forEach((chart) => chart.resize()));
  new ResizeObserver(() => shown && all.forEach((chart) => chart.resize())).observe(charts);
  return {
    shown: () => {
      shown = true;
      all.forEach((chart) => chart.resize());
    },
    hidden: () => {
      shown = false;
    },
  };
}

/** The last seconds of a live sheet, as charts take them. */
function courseOf(live) {
  const { samples, scenario } = live;
  const period = periodOf(scenario.motion);
  const end = samples.channels.time[samples.length - 1];
  const channels = samples.from(samples.indexAfter(end - COURSE));
  const all = samples.all();
  const angle = rotation(channels.spin_cross, channels.spin_dot);
  const [rateTime, rate] = perPeriod(channels.time, angle, period);
  const drifts = slip(all.time, all.centre_x, all.centre_y, period);
  const begin = samples.length - channels.time.length;
  const ledger = energyLedger(all, least(scenario));
  const n = channels.time.length - 1;
  const mean = (values) => values.subarray(Math.max(0, n - 24)).reduce((sum, each) => sum + each, 0) / Math.min(n + 1, 25);
  const whole = rotation(all.spin_cross, all.spin_dot);
  const frame = live.frame;
  return {
    channels, period, rateTime, rate, ledger,
    drift: Float64Array.from(channels.time, (time, k) => (time <= end - period / 2 ? drifts[begin + k] * 1000 : NaN)),
    now: {
      turned: whole[whole.length - 1] - whole[0], contact: mean(channels.contact), bending: mean(channels.bend_rms),
      force: frame?.plate ? -frame.plate[2] : NaN,
      books: !ledger ? "–" : `close to ${trimmed(ledger.imbalance * 100, 2)} %`,
    },
  };
}

/** Turn over each whole period, deg/s, and when. */
function perPeriod(time, angle, period) {
  const times = [];
  const rates = [];
  let from = 0;
  for (let k = 1; k < time.length; k++) {
    if (time[k] - time[from] < period - 1e-9) continue;
    times.push(time[k]);
    rates.push((angle[k] - angle[from]) / (time[k] - time[from]) / DEG);
    from = k;
  }
  return [times, rates];
}

/** Force and torque on the plate at the frames of the last period or two. */
function forcesOf(live) {
  const frames = live.frames.list.slice(-160).filter((frame) => frame.plate);
  const pick = (k, by) => frames.map((frame) => frame.plate[k] * by);
  return { time: frames.map((frame) => frame.time), values: [pick(0, 1), pick(1, 1), pick(2, -1), pick(3, 1000)] };
}
