// What a session may be asked for, and what it refuses.
import { checkScenario } from "../model/scenario.js";
import { areCutAlike } from "../model/sheet.js";

const FASTEST = 100; // m/s or rad/s of a kick
const FURTHEST = 10; // m or rad
const RADIUS = 0.02; // m

/** A change that a sheet under way cannot be told of: it must be laid down anew. */
export class LaidDownAnew extends Error {
  constructor(what) {
    super(`${what} must be laid down anew`);
    this.anew = true;
  }
}

const numbers = (values, count, most) =>
  Array.isArray(values) &&
  values.length === count &&
  values.every((value) => typeof value === "number" && Math.abs(value) <= most);

/** x, y, angle added to a start. */
export const checkOffset = (offset) => {
  if (!numbers(offset, 3, FURTHEST))
    throw new Error("an offset of a start is x and y in m, and an angle in rad; try [0, 0, 0]");
  return offset;
};

export const checkKick = ({ velocity = [0, 0, 0], spin = 0, at = null, radius = RADIUS }) => {
  const along = Array.isArray(velocity) && velocity.length === 2 ? [...velocity, 0] : velocity;
  const fits =
    numbers(along, 3, FASTEST) &&
    numbers([spin], 1, FASTEST) &&
    (at === null || numbers(at, 2, FURTHEST)) &&
    typeof radius === "number" &&
    radius > 0 &&
    radius <= FURTHEST;
  if (!fits) throw new Error(`a kick is a velocity of at most ${FASTEST} m/s along x, y, z; try [0.2, 0, 0]`);
  return { velocity: along, spin, at, radius };
};

/** Where a session was: of the same sheet, and whole. */
export const checkSaved = (saved, session) => {
  const refusal = new Error("nothing that this sheet was saved as");
  const kept = saved?.state;
  if (
    !kept ||
    !["scenarios", "courses", "stride", "since", "wanted"].every(
      (name) => saved[name]?.length === session.scenarios.length,
    )
  )
    throw refusal;
  for (const [name, array] of Object.entries(session.state)) {
    if (kept[name]?.constructor !== array.constructor) throw refusal;
    if (name !== "edge" && kept[name].length !== array.length) throw refusal;
  }
  if (![0, session.state.x.length].includes(kept.edge.length)) throw refusal;
  saved.scenarios.forEach((s, j) => {
    checkScenario(s);
    if (!areCutAlike(s.sheet, session.scenarios[j].sheet)) throw refusal;
    if (s.plate && !kept.edge.length) throw refusal;
  });
};
