// What the sheets show now: numbers, and their course over the last seconds.
import { energyLedger } from "../charts/energy.js";
import { gaitDiagram } from "../charts/gait.js";
import { timeSeries } from "../charts/series.js";
import { make } from "./elements.js";
import { trimmed } from "./quantity.js";

const EVERY = 120; // ms
const DEG = Math.PI / 180;
