// Poses that a film was read for, beside the sheet of the estimated object.
import { button, make } from "../elements.js";
import { timeSeries } from "../../charts/series.js";

export function posesBeside(element, desk, scenes) {
  const chart = make("figure", {}, make("figcaption", {}, "Angle of the tracked object and of the sheet, deg"));
  const canvas = make("div");
  chart.append(canvas);
  element.append(make("p", {}, "The outline that the film shows is drawn beside the sheet, at the same time after the start."),
    button("Begin both again", () => desk.restart()), make("div", { class: "charts" }, chart));
  const plot = timeSeries(canvas, { series: [{ label: "film" }, { label: "sheet" }], unit: "deg" });
  const show = (poses) => {
    desk.payload = { ...desk.payload, ...poses };
    desk.restart();
  };
  desk.on("poses", show);
  desk.on("drawn", () => {
    const { payload } = desk;
    const live = desk.seats[0].live;
    scenes[0]?.view.setGhost(poseAt(payload, live.clock % (payload.time.at(-1) || 1)));
  });
  return { shown: () => draw(plot, desk) };
}

const DEG = Math.PI / 180;

function draw(plot, desk) {
  const { time, angle } = desk.payload;
  plot.update({ time, values: [unwrapped(angle).map((value) => value / DEG)] });
}

/** Angles without their jumps of a whole turn. */
export function unwrapped(angles) {
  let turns = 0;
  return angles.map((angle, k) => {
    if (k > 0) turns -= Math.round((angle - angles[k - 1]) / (2 * Math.PI));
    return angle + 2 * Math.PI * turns;
  });
}

/** Pose at a time, between those that were tracked. */
export function poseAt({ time, x, y, angle }, now) {
  let after = time.findIndex((each) => each > now);
  if (after < 0) after = time.length - 1;
  const before = Math.max(0, after - 1);
  const share = after === before ? 0 : (now - time[before]) / (time[after] - time[before]);
  const turn = angle[after] - angle[before];
  const least = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
  const between = (values) => values[before] + share * (values[after] - values[before]);
  return { x: between(x), y: between(y), angle: angle[before] + share * least };
}
