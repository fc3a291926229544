// Poses that a film was read for, beside the sheet of the estimated object.
import { button, make } from "../elements.js";
import { timeSeries } from "../../charts/series.js";
import { unwrap } from "../../simulation/samples.js";
import { wholeRows } from "./series.js";

export function posesBeside(element, desk, scenes) {
  let poses = checked(desk.payload);
  const chart = make("figure", {}, make("figcaption", {}, "Angle of the tracked object and of the sheet, deg"));
  const canvas = make("div");
  chart.append(canvas);
  element.append(make("p", {}, "The outline that the film shows is drawn beside the sheet, at the same time after the start."),
    button("Begin both again", () => desk.restart()), make("div", { class: "charts" }, chart));
  const plot = timeSeries(canvas, { series: [{ label: "film" }, { label: "sheet" }], unit: "deg" });
  const show = (others) => {
    poses = checked(others);
    desk.restart();
    draw();
  };
  const draw = () => plot.update({ time: poses.time, values: [unwrap(poses.angle).map((value) => value / DEG)] });
  desk.on("poses", show);
  desk.on("drawn", () => {
    const { live } = desk.seats[0];
    scenes[0]?.view.setGhost(poseAt(poses, poses.time[0] + (live.clock % (poses.time.at(-1) - poses.time[0]))));
  });
  return { shown: () => {
    plot.resize();
    draw();
  } };
}

function checked(given) {
  const poses = wholeRows(given, ["time", "x", "y", "angle"]);
  if (poses.time.length < 2 || !(poses.time.at(-1) > poses.time[0])) throw new Error("fewer than two poses in it");
  return poses;
}

const DEG = Math.PI / 180;

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
