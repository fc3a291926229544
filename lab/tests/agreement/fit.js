// What the lab's fit makes of curves that the package sends it as JSON on standard input, and its file of one.
import { readFileSync } from "node:fs";
import { curveCsv } from "../../src/curve/file.js";
import { fitLorentzian } from "../../src/curve/lorentz.js";
import { endsInFailure, fittedPoints } from "../../src/curve/points.js";

const numbers = (values) => values.map((value) => value ?? NaN);
const { curves, failures, file } = JSON.parse(readFileSync(0, "utf8"));
const points = file.points.map((point) => ({ ...point, rate: point.rate ?? NaN, spread: point.spread ?? NaN }));
const fits = curves.map(({ frequency, rate, sd, ends }) => fitLorentzian(frequency, numbers(rate), { sd, endsInFailure: ends }));
const used = failures.map((points) => ({ fitted: fittedPoints(points), ends: endsInFailure(points) }));
process.stdout.write(JSON.stringify({ fits, used, csv: curveCsv(points, file.protocol) }));
