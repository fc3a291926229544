// What of the libraries the page uses, for all of its modules: named one by one, so that the rest is left out.
import * as THREE from "./view/three.js";
import uPlot from "uplot";

globalThis.plategaitLibraries = { THREE, uPlot };
