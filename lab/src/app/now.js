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

const EVERY = [40, 250]; // ms between one part's turn and the next's: at best, and where pictures come too slowly
const PICTURES = 32; // a second that charts leave room for
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
  const inSight = new Set();
  const sight = new IntersectionObserver((entries) => entries.forEach(({ target, isIntersecting }) =>
    (isIntersecting ? inSight.add(target) : inSight.delete(target))));
  const all = [];
  /** Parts that are shown in turn: where each is, and what shows it of a live sheet. @type {[Element, (live) => void][]} */
  const parts = [];
  const values = NUMBERS.map(([name]) => [name, make("dd", {}, "–")]);
  const numbers = make("dl", { class: "readings" }, ...values.map(([name, dd]) => make("div", {}, make("dt", {}, name), dd)));
  const charts = make("div", { class: "charts" });
  element.append(numbers, charts);
  sight.observe(numbers);
  const figure = (title, chartIn, show) => {
    const hold = make("div");
    charts.append(make("figure", {}, make("figcaption", {}, title), hold));
    sight.observe(hold);
    const chart = chartIn(hold);
    all.push(chart);
    parts.push([hold, (live) => show(chart, live)]);
  };

  // Of two sheets both numbers, each after its letter.
  parts.push([numbers, () => {
    const both = desk.seats.map(({ live }, k) => [scenes[k]?.read, live.samples.length < 4 ? null : nowOf(live)]);
    NUMBERS.forEach(([, say], k) => {
      const words = both.map(([own, its]) => (own && its ? say(own, its) : "–"));
      const text = words.length > 1 ? words.map((word, j) => `${"AB"[j]} ${word}`).join("\n") : words[0];
      if (values[k][1].textContent !== text) values[k][1].textContent = text;
    });
  }]);
  figure("Gait: when each leg touches", gaitDiagram, (chart, live) => {
    const { time, left_contact: left, right_contact: right, flight } = courseOf(live);
    chart.update({ time, left, right, flight, period: periodOf(live.scenario.motion), gait: scenes[desk.selected]?.read?.gait });
  });
  figure("Spin rate over each period, deg/s",
    (hold) => timeSeries(hold, { series: [{ label: "spin rate", colour: "--accent" }], unit: "deg/s" }), (chart, live) => {
      const [time, rate] = ratesOf(live);
      chart.update({ time, values: [rate] });
    });
  figure("Drift of the centre, mm", (hold) => timeSeries(hold, { series: [{ label: "drift", colour: "--walking" }], unit: "mm" }),
    (chart, live) => {
      const [time, drift] = driftOf(live);
      chart.update({ time, values: [drift], limit: { value: live.scenario.slip_limit * 1000, label: "fails" } });
    });
  figure("Force on the plate, N, and torque, mN m", (hold) => timeSeries(hold, {
    series: [{ label: "along", colour: "--left" }, { label: "across", colour: "--right" }, { label: "down", colour: "--running" },
      { label: "torque about the bar", colour: "--failed" }], unit: "" }), (chart, live) => chart.update(forcesOf(live)));
  figure("Bending, r.m.s., deg", (hold) => timeSeries(hold, { series: [{ label: "bending", colour: "--running" }], unit: "deg" }),
    (chart, live) => {
      const { time, bend_rms: bending } = courseOf(live);
      chart.update({ time, values: [Float64Array.from(bending, (each) => each / DEG)] });
    });
  figure("Where the plate's work went, since it was laid down", ledgerChart, (chart, live) => chart.update(ledgerOf(live)));

  let shown = false;
  let turn = 0;
  let last = performance.now();
  let before = last;
  let between = 1000 / PICTURES; // ms from picture to picture, of late

  /** One part after the other, those in sight: the picture above comes first. */
  const update = () => {
    const now = performance.now();
    between += 0.1 * (Math.min(now - before, 500) - between);
    before = now;
    if (!shown || now - last < (between > 1000 / PICTURES ? EVERY[1] : EVERY[0])) return;
    const { live } = desk.seats[desk.selected];
    if (live.samples.length < 4) return;
    last = now;
    for (let tried = 0; tried < parts.length; tried++) {
      const [place, show] = parts[turn++ % parts.length];
      if (!inSight.has(place)) continue;
      show(live);
      return;
    }
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

/** Samples of the last seconds of a live sheet. */
function courseOf({ samples }) {
  const end = samples.channels.time[samples.length - 1];
  return samples.from(samples.indexAfter(end - COURSE));
}

/** Spin rate over each whole period of the last seconds, deg/s, and when. */
function ratesOf(live) {
  const { time, spin_cross: cross, spin_dot: dot } = courseOf(live);
  return perPeriod(time, rotation(cross, dot), periodOf(live.scenario.motion));
}

/** Drift over the last seconds, mm, as far as whole periods are averaged. */
function driftOf(live) {
  const all = live.samples.all();
  const period = periodOf(live.scenario.motion);
  const drifts = slip(all.time, all.centre_x, all.centre_y, period);
  const { time } = courseOf(live);
  const begin = live.samples.length - time.length;
  const end = time[time.length - 1] - period / 2;
  return [time, Float64Array.from(time, (each, k) => (each <= end ? drifts[begin + k] * 1000 : NaN))];
}

const ledgerOf = (live) => energyLedger(live.samples.all(), least(live.scenario));

/** What a live sheet does now, as the numbers want it. */
function nowOf(live) {
  const { samples, frame } = live;
  const ledger = ledgerOf(live);
  const recent = samples.from(Math.max(0, samples.length - 25));
  const mean = (values) => values.reduce((sum, each) => sum + each, 0) / values.length;
  const whole = rotation(samples.all().spin_cross, samples.all().spin_dot);
  return {
    turned: whole[whole.length - 1] - whole[0], contact: mean(recent.contact), bending: mean(recent.bend_rms),
    force: frame?.plate ? -frame.plate[2] : NaN,
    books: `close to ${trimmed(ledger.imbalance * 100, 2)} %`,
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
