(() => {
  var __create = Object.create;
  var __defProp = Object.defineProperty;
  var __getOwnPropDesc = Object.getOwnPropertyDescriptor;
  var __getOwnPropNames = Object.getOwnPropertyNames;
  var __getProtoOf = Object.getPrototypeOf;
  var __hasOwnProp = Object.prototype.hasOwnProperty;
  var __commonJS = (cb, mod) => function __require() {
    return mod || (0, cb[__getOwnPropNames(cb)[0]])((mod = { exports: {} }).exports, mod), mod.exports;
  };
  var __copyProps = (to, from, except, desc) => {
    if (from && typeof from === "object" || typeof from === "function") {
      for (let key of __getOwnPropNames(from))
        if (!__hasOwnProp.call(to, key) && key !== except)
          __defProp(to, key, { get: () => from[key], enumerable: !(desc = __getOwnPropDesc(from, key)) || desc.enumerable });
    }
    return to;
  };
  var __toESM = (mod, isNodeMode, target) => (target = mod != null ? __create(__getProtoOf(mod)) : {}, __copyProps(
    // If the importer is in node compatibility mode or this is not an ESM
    // file that has been converted to a CommonJS file using a Babel-
    // compatible transform (i.e. "__esModule" has not been set), then set
    // "default" to the CommonJS "module.exports" for node compatibility.
    isNodeMode || !mod || !mod.__esModule ? __defProp(target, "default", { value: mod, enumerable: true }) : target,
    mod
  ));

  // library:uplot
  var require_uplot = __commonJS({
    "library:uplot"(exports, module) {
      module.exports = globalThis.plategaitLibraries.uPlot;
    }
  });

  // library:three
  var require_three = __commonJS({
    "library:three"(exports, module) {
      module.exports = globalThis.plategaitLibraries.THREE;
    }
  });

  // src/app/data.js
  function jsonOf(id) {
    const text = document.getElementById(id)?.textContent;
    if (!text) return null;
    try {
      return JSON.parse(text);
    } catch {
      return null;
    }
  }
  var readFacts = () => jsonOf("facts");
  function readPayload() {
    const element2 = document.getElementById("payload");
    const payload = jsonOf("payload");
    if (payload && typeof payload === "object" && typeof payload.kind === "string") return payload;
    return element2?.textContent ? { kind: "spoilt" } : { kind: "none" };
  }
  function floatsOf(base64) {
    const text = atob(base64);
    const bytes = Uint8Array.from(text, (letter) => letter.charCodeAt(0));
    return new Float32Array(bytes.buffer, 0, Math.floor(bytes.length / 4));
  }
  function engineBytes() {
    const text = atob(document.getElementById("engine").textContent.trim());
    return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  }
  function workerMaker() {
    const source = document.getElementById("worker").textContent;
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    const bytes = engineBytes();
    return () => {
      const worker = new Worker(address);
      worker.postMessage({ engine: bytes.buffer.slice(0) });
      return worker;
    };
  }

  // src/app/elements.js
  function make(tag, given2 = {}, ...children) {
    const element2 = document.createElement(tag);
    for (const [name, value] of Object.entries(given2)) {
      if (value === null || value === void 0) continue;
      if (name.startsWith("on")) element2.addEventListener(name.slice(2), value);
      else if (/^(class|for|role|list|form|aria-.*|data-.*)$/.test(name)) element2.setAttribute(name, value);
      else element2[name] = value;
    }
    element2.append(...children.filter((child) => child !== null && child !== void 0));
    return element2;
  }
  function button(text, act, given2 = {}) {
    return make("button", { type: "button", onclick: act, ...given2 }, text);
  }
  function choice(label, options, value, choose, given2 = {}) {
    const select = make("select", { "aria-label": label, onchange: () => choose(select.value), ...given2 });
    for (const [key, text] of options) select.append(make("option", { value: key, selected: key === value }, text));
    return select;
  }
  var last = 0;
  var identity = (stem) => `${stem}-${++last}`;

  // src/app/about.js
  function about(footer, facts) {
    const licences = jsonOf("licences") ?? "";
    footer.append(
      make("p", {}, `plategait ${facts.version}. Everything is computed here, by the package's own core compiled for the browser, in single precision. Nothing is sent or fetched: the page forbids itself any network.`),
      make("p", {}, "Rates are over the last periods as the sheet lives; a spin curve's points are measured over whole runs. Keys: space, comma, full stop, r, s, f, k; ? names them."),
      make("details", {}, make("summary", {}, "Licences of what is bundled"), make("pre", { tabIndex: 0 }, licences))
    );
  }

  // src/model/vectors.js
  var dot = (a, b) => {
    let sum2 = 0;
    for (let k = 0; k < a.length; k++) sum2 += a[k] * b[k];
    return sum2;
  };
  var scaled = (a, factor) => a.map((each) => factor * each);
  var add = (a, b, factor) => {
    for (let k = 0; k < a.length; k++) a[k] += factor * b[k];
  };
  var without = (vector, others) => {
    const rest = vector.slice();
    for (let pass = 0; pass < 2; pass++) for (const other of others) add(rest, other, -dot(rest, other));
    const size = Math.sqrt(dot(rest, rest));
    return { unit: size > 0 ? scaled(rest, 1 / size) : rest, size };
  };

  // src/model/lanczos.js
  var STEPS = 40;
  var MOST_TURNS = 60;
  var EXHAUSTED = 1e-11;
  var BandedMatrix = class {
    /** @param {number} n @param {{nodes: number[], weights: number[], factor: number}[]} elements */
    constructor(n, elements) {
      this.n = n;
      this.half = elements.reduce((most, { nodes }) => Math.max(most, Math.max(...nodes) - Math.min(...nodes)), 0);
      this.rows = new Float64Array(n * (this.half + 1));
      for (const { nodes, weights, factor } of elements)
        nodes.forEach(
          (a, p) => nodes.forEach((b, q) => {
            if (b <= a) this.rows[this.#at(a, b)] += factor * weights[p] * weights[q];
          })
        );
      this.largest = this.#bound();
    }
    #at(row2, column) {
      return row2 * (this.half + 1) + this.half - (row2 - column);
    }
    #bound() {
      const sums = new Float64Array(this.n);
      this.#each((i, j, value) => {
        sums[i] += Math.abs(value);
        if (j !== i) sums[j] += Math.abs(value);
      });
      return sums.reduce((most, sum2) => Math.max(most, sum2), 0);
    }
    #each(visit) {
      for (let i = 0; i < this.n; i++)
        for (let j = Math.max(0, i - this.half); j <= i; j++) visit(i, j, this.rows[this.#at(i, j)]);
    }
    /** Rayleigh's quotient of a unit vector. */
    quotient(unit) {
      let sum2 = 0;
      this.#each((i, j, value) => sum2 += (j === i ? 1 : 2) * value * unit[i] * unit[j]);
      return sum2;
    }
    /** Solver of the matrix with a shift along its diagonal. @param {number} about an eigenvalue */
    inverse(about2) {
      const shift = about2 > 1e-12 * this.largest ? about2 : 1e-6 * this.largest || 1;
      const { n, half } = this;
      const width = half + 1;
      const lower = this.rows.slice();
      for (let i = 0; i < n; i++) {
        const own = i * width + half - i;
        lower[own + i] += shift;
        for (let j = Math.max(0, i - half); j <= i; j++) {
          const other = j * width + half - j;
          let sum2 = lower[own + j];
          for (let k = Math.max(0, i - half); k < j; k++) sum2 -= lower[own + k] * lower[other + k];
          lower[own + j] = i === j ? Math.sqrt(sum2) : sum2 / lower[other + j];
        }
      }
      const solve2 = (right) => {
        const y = Float64Array.from(right);
        for (let i = 0; i < n; i++) {
          const own = i * width + half - i;
          let sum2 = y[i];
          for (let k = Math.max(0, i - half); k < i; k++) sum2 -= lower[own + k] * y[k];
          y[i] = sum2 / lower[own + i];
        }
        for (let i = n - 1; i >= 0; i--) {
          const own = i * width + half - i;
          const value = y[i] /= lower[own + i];
          for (let k = Math.max(0, i - half); k < i; k++) y[k] -= lower[own + k] * value;
        }
        return y;
      };
      return { solve: solve2, shift };
    }
  };
  var heldModes = ({ solve: solve2, shift }, start, along) => {
    const [basis, diagonal, beside] = [[start], [], []];
    for (let step = 0; step < Math.min(STEPS, start.length); step++) {
      const next = solve2(basis[step]);
      diagonal.push(dot(next, basis[step]));
      const fresh = without(next, [...along, ...basis]);
      if (!(fresh.size > EXHAUSTED * Math.sqrt(dot(next, next)))) break;
      beside.push(fresh.size);
      basis.push(fresh.unit);
    }
    const { values, vectors } = tridiagonalModes(diagonal, beside);
    return values.map((value, k) => {
      const direction = new Float64Array(start.length);
      vectors[k].forEach((weight, j) => add(direction, basis[j], weight));
      const share2 = vectors[k][0];
      return { squared: 1 / value - shift, share: Math.abs(share2), direction: scaled(direction, share2 < 0 ? -1 : 1) };
    }).sort((a, b) => a.squared - b.squared);
  };
  var tridiagonalModes = (diagonal, beside) => {
    const m = diagonal.length;
    const d = Float64Array.from(diagonal);
    const e = Float64Array.from({ length: m }, (_, k) => k < m - 1 ? beside[k] : 0);
    const vectors = Array.from({ length: m }, (_, i) => Float64Array.from({ length: m }, (__, j) => i === j ? 1 : 0));
    for (let low = 0; low < m; low++)
      for (let turn = 0; turn < MOST_TURNS; turn++) {
        let high = low;
        while (high < m - 1 && Math.abs(e[high]) > Number.EPSILON * (Math.abs(d[high]) + Math.abs(d[high + 1]))) high++;
        if (high === low) break;
        chase(d, e, vectors, low, high);
      }
    return { values: [...d], vectors };
  };
  var chase = (d, e, vectors, low, high) => {
    const theta = (d[low + 1] - d[low]) / (2 * e[low]);
    let [sine, cosine, lost] = [1, 1, 0];
    let g = d[high] - d[low] + e[low] / (theta + (theta < 0 ? -1 : 1) * Math.hypot(theta, 1));
    for (let i = high - 1; i >= low; i--) {
      const [f, b] = [sine * e[i], cosine * e[i]];
      const size = Math.hypot(f, g);
      e[i + 1] = size;
      if (size === 0) {
        d[i + 1] -= lost;
        e[high] = 0;
        return;
      }
      sine = f / size;
      cosine = g / size;
      g = d[i + 1] - lost;
      const moved = (d[i] - g) * sine + 2 * cosine * b;
      lost = sine * moved;
      d[i + 1] = g + lost;
      g = cosine * moved - b;
      const [below, above] = [vectors[i], vectors[i + 1]];
      for (let k = 0; k < below.length; k++) {
        const [left, right] = [below[k], above[k]];
        above[k] = sine * left + cosine * right;
        below[k] = cosine * left - sine * right;
      }
    }
    d[low] -= lost;
    e[low] = g;
    e[high] = 0;
  };

  // src/model/lattice.js
  var AXIAL = [
    [1, 0],
    [0, 1]
  ];
  var DIAGONAL = [
    [1, 1],
    [1, -1]
  ];
  function lattice({ columns, rows, inside }) {
    const number = new Int32Array(columns * rows).fill(-1);
    const squares2 = [];
    for (let j = 0; j < rows; j++)
      for (let i = 0; i < columns; i++)
        if (inside[i * rows + j]) {
          number[i * rows + j] = squares2.length;
          squares2.push([i, j]);
        }
    const at2 = (i, j) => i >= 0 && i < columns && j >= 0 && j < rows ? number[i * rows + j] : -1;
    const chains = ([di, dj]) => {
      const found = [];
      for (let [i, j] of squares2) {
        if (at2(i - di, j - dj) >= 0) continue;
        const chain = [];
        for (let node = at2(i, j); node >= 0; node = at2(i, j)) {
          chain.push(node);
          i += di;
          j += dj;
        }
        if (chain.length > 1) found.push(chain);
      }
      return found;
    };
    const axial = AXIAL.flatMap(chains);
    const lines = [...axial, ...DIAGONAL.flatMap(chains)];
    const lineStart = new Int32Array(lines.length + 1);
    lines.forEach((line, k) => lineStart[k + 1] = lineStart[k] + line.length);
    const cells = [];
    for (let i = 0; i + 1 < columns; i++)
      for (let j = 0; j + 1 < rows; j++) {
        const corners2 = [at2(i, j), at2(i + 1, j), at2(i, j + 1), at2(i + 1, j + 1)];
        if (corners2.every((node) => node >= 0)) cells.push(...corners2);
      }
    return {
      nNodes: squares2.length,
      rest: restOf(squares2),
      axial: axial.length,
      lineStart,
      lineNodes: Int32Array.from(lines.flat()),
      cells: Int32Array.from(cells),
      nCells: cells.length / 4,
      columns,
      rows,
      squares: Int32Array.from(squares2.flat())
    };
  }
  function restOf(squares2) {
    const n = squares2.length;
    const mean2 = [0, 1].map((k) => squares2.reduce((sum2, square2) => sum2 + square2[k], 0) / n);
    const rest = new Float64Array(2 * n);
    squares2.forEach(([i, j], node) => {
      rest[2 * node] = i - mean2[0];
      rest[2 * node + 1] = j - mean2[1];
    });
    return rest;
  }

  // src/model/refusal.js
  var MOST_LETTERS = 80;
  var Refusal = class extends Error {
    /**
     * @param {string} field dotted name
     * @param {string} got
     * @param {string} allowed as the end of "must be …"
     * @param {string} hint what to type
     */
    constructor(field, got, allowed, hint) {
      super(`got ${got}, must be ${allowed}; try ${hint}`);
      this.name = "Refusal";
      this.field = field;
    }
  };
  var told = (value) => {
    if (value === void 0 || value === null) return "nothing";
    if (Array.isArray(value)) return `a list of ${value.length}`;
    if (typeof value === "object") return "a table";
    const text = typeof value === "string" ? JSON.stringify(value) : String(value);
    return text.length <= MOST_LETTERS ? text : `${text.slice(0, MOST_LETTERS)}…`;
  };
  var checkTable = (value, field) => {
    if (typeof value !== "object" || value === null || Array.isArray(value))
      throw new Refusal(field, told(value), "a table of its fields", "a preset's");
    return value;
  };

  // src/model/quantity.js
  var DEG = Math.PI / 180;
  var SMALLEST = 1e-30;
  var LARGEST = 1e30;
  var quantity = (display, factor, example, { above = -Infinity, atLeast = -Infinity, atMost = Infinity, smallest = SMALLEST } = {}) => ({ display, factor, example, above, atLeast, atMost, smallest: above === 0 ? smallest : 0 });
  var LENGTH = quantity("mm", 1e-3, "10 mm", { above: 0, atMost: 10 });
  var OFFSET = quantity("mm", 1e-3, "0 mm", { atLeast: -10, atMost: 10 });
  var DEPTH = quantity("mm", 1e-3, "0.1 mm", { atLeast: 0 });
  var AREA = quantity("mm^2", 1e-6, "100 mm^2", { above: 0 });
  var MASS = quantity("g", 1e-3, "13.6 g", { above: 0, atMost: 10 });
  var ANGLE = quantity("deg", DEG, "12 deg");
  var STROKE = quantity("mm", 1e-3, "3 mm");
  var PLATE_ANGLE = quantity("deg", DEG, "3 deg", { atLeast: -Math.PI / 2, atMost: Math.PI / 2 });
  var PLATE_STROKE = quantity("mm", 1e-3, "3 mm", { atLeast: -1, atMost: 1 });
  var DURATION = quantity("s", 1, "4 s", { above: 0 });
  var DELAY = quantity("s", 1, "0.1 s", { atLeast: 0 });
  var TIME_STEP = quantity("s", 1, "1e-4 s", { above: 0 });
  var FREQUENCY = quantity("Hz", 1, "24 Hz", { above: 0, smallest: 0 });
  var SPEED = quantity("mm/s", 1e-3, "100 mm/s", { above: 0 });
  var ACCELERATION = quantity("m/s^2", 1, "9.81 m/s^2", { atLeast: 0 });
  var AXIAL_STIFFNESS = quantity("N/mm", 1e3, "0.79 N/mm", { above: 0 });
  var AXIAL_DAMPING = quantity("N/(mm/s)", 1e3, "4.9e-4 N/(mm/s)", { atLeast: 0 });
  var BENDING_STIFFNESS = quantity("N*mm/deg", 1e-3 / DEG, "2.72e-3 N*mm/deg", { atLeast: 0 });
  var BENDING_DAMPING = quantity("N*mm/(deg/s)", 1e-3 / DEG, "4.23e-6 N*mm/(deg/s)", { atLeast: 0 });
  var COEFFICIENT = quantity("", 1, "0.75", { atLeast: 0 });
  var RATIO = quantity("", 1, "1", { above: 0 });
  var SPEED_RATIO = quantity("", 1, "10", { above: 1 });
  var shown = (value, { display, factor }) => `${Number((value / factor).toPrecision(6))} ${display}`.trim();
  var checkNumber = (value, field, measured) => {
    const { above, atLeast, atMost, smallest, example } = measured;
    const within = typeof value === "number" && value > above && value >= atLeast && value <= atMost;
    if (within && Math.abs(value) <= LARGEST && Math.abs(value) >= smallest) return value;
    const bounds = [
      above > -Infinity && `above ${shown(above, measured)}`,
      atLeast > -Infinity && `at least ${shown(atLeast, measured)}`,
      atMost < Infinity && `at most ${shown(atMost, measured)}`
    ].filter(Boolean);
    if (within) bounds.push(`from ${smallest} to ${LARGEST} in size, in SI`);
    const got = Number.isFinite(value) ? shown(value, measured) : told(value);
    throw new Refusal(field, got, ["a number", bounds.join(" and ")].join(" ").trim(), example);
  };
  var checkNumbers = (part, field, quantities) => {
    for (const [name, measured] of Object.entries(quantities)) checkNumber(part[name], `${field}.${name}`, measured);
  };

  // src/model/rounding.js
  var roundHalfEven = (x) => {
    const below = Math.floor(x);
    if (x - below !== 0.5) return Math.round(x);
    return below % 2 === 0 ? below : below + 1;
  };

  // src/model/outline.js
  var MOST_SQUARES = 25e4;
  var MOST_CORNERS = 1e3;
  var MOST_PIXELS = 1e6;
  var EDGE = 1e-9;
  var TRIANGLE = '[["0 mm", "0 mm"], ["60 mm", "0 mm"], ["0 mm", "60 mm"]]';
  var ROWS = '[".##.", "####", ".##."]';
  var FIELD = "sheet.outline";
  var SHAPES = {
    disk: {
      check: (o) => checkNumbers(o, FIELD, { radius: LENGTH }),
      size: (o) => [2 * o.radius, 2 * o.radius],
      contains: (o) => (x, y) => Math.hypot(x, y) <= o.radius
    },
    ellipse: {
      check: (o) => checkNumbers(o, FIELD, { length: LENGTH, width: LENGTH }),
      size: (o) => [o.length, o.width],
      contains: (o) => (x, y) => Math.hypot(2 * x / o.length, 2 * y / o.width) <= 1
    },
    rectangle: {
      check: (o) => checkNumbers(o, FIELD, { length: LENGTH, width: LENGTH }),
      size: (o) => [o.length, o.width],
      contains: (o) => (x, y) => Math.abs(x) <= o.length / 2 && Math.abs(y) <= o.width / 2
    },
    polygon: { check: checkCorners, size: polygonSize, contains: insidePolygon },
    mask: { check: checkRows, size: maskSize, contains: insideMask }
  };
  var kindOf = (outline) => {
    checkTable(outline, FIELD);
    if (typeof outline.shape !== "string" || !Object.hasOwn(SHAPES, outline.shape))
      throw new Refusal(`${FIELD}.shape`, told(outline.shape), `one of ${Object.keys(SHAPES).join(", ")}`, '"disk"');
    return SHAPES[outline.shape];
  };
  var checkOutline = (outline) => kindOf(outline).check(outline);
  var outlineSize = (outline) => kindOf(outline).size(outline);
  var insideOf = (outline) => kindOf(outline).contains(outline);
  function checkCorners({ corners: corners2 }) {
    const field = `${FIELD}.corners`;
    if (!Array.isArray(corners2)) throw new Refusal(field, told(corners2), "a list", TRIANGLE);
    if (corners2.length > MOST_CORNERS)
      throw new Refusal(
        field,
        `${corners2.length} corners`,
        `at most ${MOST_CORNERS}`,
        "leaving out some that are near to others"
      );
    corners2.forEach((corner, i) => {
      if (!Array.isArray(corner) || corner.length !== 2)
        throw new Refusal(`${field}.${i}`, told(corner), "x and y", TRIANGLE);
      corner.forEach((value, k) => checkNumber(value, `${field}.${i}.${k}`, OFFSET));
    });
    if (corners2.length < 3 || !spanAnArea(corners2)) {
      const got = `${corners2.length} corners${corners2.length > 1 ? " on one line" : ""}`;
      throw new Refusal(field, got, "3 or more corners that span an area", TRIANGLE);
    }
  }
  function spanAnArea(corners2) {
    const across = (k) => corners2.map((corner) => corner[k] - corners2[0][k]);
    const dot3 = (a, b) => a.reduce((sum2, each, i) => sum2 + each * b[i], 0);
    const [x, y] = [across(0), across(1)];
    const most = Math.max(...[...x, ...y].map(Math.abs));
    const [longer, other] = dot3(x, x) >= dot3(y, y) ? [x, y] : [y, x];
    const size = Math.sqrt(dot3(longer, longer));
    if (size === 0) return false;
    const unit = longer.map((each) => each / size);
    const part = dot3(other, unit);
    const once = other.map((each, i) => each - part * unit[i]);
    const rest = dot3(once, unit);
    const off = Math.hypot(...once.map((each, i) => each - rest * unit[i]));
    const larger = Math.sqrt(
      (size ** 2 + part ** 2 + off ** 2 + Math.sqrt((size ** 2 + part ** 2 + off ** 2) ** 2 - 4 * (size * off) ** 2)) / 2
    );
    return size * off / larger > EDGE * most;
  }
  function extent(corners2, k) {
    let [low, high] = [Infinity, -Infinity];
    for (const corner of corners2) {
      low = Math.min(low, corner[k]);
      high = Math.max(high, corner[k]);
    }
    return [low, high];
  }
  function polygonSize({ corners: corners2 }) {
    return [0, 1].map((k) => {
      const [low, high] = extent(corners2, k);
      return high - low;
    });
  }
  function insidePolygon(outline) {
    const middle = [0, 1].map((k) => {
      const [low, high] = extent(outline.corners, k);
      return (low + high) / 2;
    });
    const corners2 = outline.corners.map(([x, y]) => [x - middle[0], y - middle[1]]);
    const hair = EDGE * Math.max(...polygonSize(outline));
    const around2 = Array.from({ length: 8 }, (_, k) => (k + 0.5) * Math.PI / 4).map((d) => [
      hair * Math.cos(d),
      hair * Math.sin(d)
    ]);
    const odd = (x, y) => {
      let inside = false;
      for (let k = 0; k < corners2.length; k++) {
        const [x0, y0] = corners2[k];
        const [x1, y1] = corners2[(k + 1) % corners2.length];
        if (y0 !== y1 && y0 > y !== y1 > y && x < x0 + (y - y0) * (x1 - x0) / (y1 - y0)) inside = !inside;
      }
      return inside;
    };
    return (x, y) => around2.every(([dx, dy]) => odd(x + dx, y + dy));
  }
  function checkRows(o) {
    checkNumbers(o, FIELD, { width_of_picture: LENGTH });
    const field = `${FIELD}.rows`;
    const { rows } = o;
    if (!Array.isArray(rows) || !rows.length || rows.some((row2) => typeof row2 !== "string" || row2.length !== rows[0].length))
      throw new Refusal(field, told(rows), "rows of equal length", ROWS);
    if (rows.length * rows[0].length > MOST_PIXELS)
      throw new Refusal(
        field,
        `${rows[0].length} × ${rows.length} pixels`,
        `at most ${MOST_PIXELS} of them`,
        "a smaller copy"
      );
    if (!rows.some((row2) => row2.includes("#")))
      throw new Refusal(field, "nothing dark in the picture", "a dark object on a light ground", ROWS);
  }
  function cropped({ rows }) {
    const dark = rows.map((row2, i) => row2.includes("#") ? i : -1).filter((i) => i >= 0);
    const left = Math.min(...dark.map((i) => rows[i].indexOf("#")));
    const right = Math.max(...dark.map((i) => rows[i].lastIndexOf("#")));
    return [dark[0], dark.at(-1), left, right];
  }
  function maskSize(outline) {
    const [top, bottom, left, right] = cropped(outline);
    const pixel = outline.width_of_picture / outline.rows[0].length;
    return [(right - left + 1) * pixel, (bottom - top + 1) * pixel];
  }
  function insideMask(outline) {
    const [top, bottom, left, right] = cropped(outline);
    const [length, width] = maskSize(outline);
    const [columns, rows] = [right - left + 1, bottom - top + 1];
    return (x, y) => {
      const i = Math.floor((x / length + 0.5) * columns);
      const j = Math.floor((y / width + 0.5) * rows);
      return i >= 0 && i < columns && j >= 0 && j < rows && outline.rows[bottom - j][left + i] === "#";
    };
  }
  function occupiedSquares(outline, pitch) {
    const kind = kindOf(outline);
    const size = kind.size(outline);
    const [columns, rows] = size.map((extent3) => Math.max(1, roundHalfEven(Math.min(extent3 / pitch, 1e9))));
    const wide = shown(pitch, LENGTH);
    if (columns * rows > MOST_SQUARES)
      throw new Refusal(
        "sheet.pitch",
        wide,
        `coarse enough for at most ${MOST_SQUARES} squares`,
        shown(Math.max(...size) / 100, LENGTH)
      );
    const contains = kind.contains(outline);
    const inside = new Uint8Array(columns * rows);
    const middle = (k, count) => (k - (count - 1) / 2) * pitch * (1 - 1e-12);
    for (let i = 0; i < columns; i++)
      for (let j = 0; j < rows; j++) inside[i * rows + j] = contains(middle(i, columns), middle(j, rows)) ? 1 : 0;
    const finer = shown(Number(Math.min(Math.min(...size) / 8, pitch / 2).toPrecision(3)), LENGTH);
    if (!inside.includes(1))
      throw new Refusal("sheet.pitch", wide, "fine enough for at least one grid square inside the outline", finer);
    const pieces = countPieces(inside, columns, rows);
    if (pieces > 1)
      throw new Refusal(
        FIELD,
        `${pieces} separate pieces at a pitch of ${wide}`,
        "one connected piece",
        `a mask without gaps, or a finer pitch such as ${finer}`
      );
    return { columns, rows, inside };
  }
  function countPieces(inside, columns, rows) {
    const left = inside.slice();
    let pieces = 0;
    for (let start = 0; start < left.length; start++) {
      if (!left[start]) continue;
      pieces++;
      const front = [start];
      left[start] = 0;
      while (front.length) {
        const at2 = front.pop();
        const [i, j] = [Math.floor(at2 / rows), at2 % rows];
        for (const [a, b] of [
          [i - 1, j],
          [i + 1, j],
          [i, j - 1],
          [i, j + 1]
        ]) {
          if (a < 0 || b < 0 || a >= columns || b >= rows || !left[a * rows + b]) continue;
          left[a * rows + b] = 0;
          front.push(a * rows + b);
        }
      }
    }
    return pieces;
  }

  // src/model/sheet.js
  var MOST_NODES = 2e4;
  var MOST_KEPT = 12;
  var byOutline = /* @__PURE__ */ new WeakMap();
  var byText = /* @__PURE__ */ new Map();
  var cutOf = ({ outline, pitch }) => JSON.stringify([outline, pitch]);
  var latticeOf = ({ outline, pitch }) => {
    const known = byOutline.get(outline);
    if (known?.pitch === pitch) return known.lattice;
    const text = cutOf({ outline, pitch });
    const found = byText.get(text) ?? lattice(occupiedSquares(outline, pitch));
    byText.delete(text);
    byText.set(text, found);
    if (byText.size > MOST_KEPT) byText.delete(byText.keys().next().value);
    byOutline.set(outline, { pitch, lattice: found });
    return found;
  };
  var nodeMass = (sheet) => sheet.mass / latticeOf(sheet).nNodes;
  var NUMBERS = {
    mass: MASS,
    pitch: LENGTH,
    thickness: LENGTH,
    bending_stiffness: BENDING_STIFFNESS,
    bending_damping: BENDING_DAMPING,
    axial_stiffness: AXIAL_STIFFNESS,
    axial_damping: AXIAL_DAMPING,
    shear_ratio: RATIO,
    torsion_stiffness: BENDING_STIFFNESS,
    torsion_damping: BENDING_DAMPING
  };
  var checkSheet = (sheet) => {
    checkTable(sheet, "sheet");
    checkOutline(sheet.outline);
    checkNumbers(sheet, "sheet", NUMBERS);
    const { nNodes } = latticeOf(sheet);
    if (nNodes > MOST_NODES) {
      const coarser = Number((1e3 * sheet.pitch * Math.sqrt(nNodes / MOST_NODES) * 1.05).toPrecision(3));
      throw new Refusal(
        "sheet.pitch",
        `${nNodes} nodes`,
        `coarse enough for at most ${MOST_NODES} in a page`,
        `${coarser} mm`
      );
    }
  };
  var stableTimeStep = (sheet) => {
    const mass = nodeMass(sheet);
    const perPitch = 32 / sheet.pitch ** 2;
    const wholeAxial = 8 * sheet.axial_damping / mass;
    const wholeBending = perPitch * (sheet.bending_damping + sheet.torsion_damping) / mass;
    const inPlane = 4 * (1 + sheet.shear_ratio) * sheet.axial_stiffness;
    const wholeSquared = (inPlane + perPitch * (sheet.bending_stiffness + sheet.torsion_stiffness)) / mass;
    const unit = 4 / (wholeAxial + wholeBending + Math.sqrt((wholeAxial + wholeBending) ** 2 + 4 * wholeSquared));
    const [axial, bending, squared] = [wholeAxial * unit, wholeBending * unit, wholeSquared * unit ** 2];
    const cubic2 = [axial * squared / 4, squared + axial * bending / 2, axial + 2 * bending, -4];
    let x = 2;
    for (let k = 0; k < 8; k++) {
      const value = ((cubic2[0] * x + cubic2[1]) * x + cubic2[2]) * x + cubic2[3];
      x -= value / ((3 * cubic2[0] * x + 2 * cubic2[1]) * x + cubic2[2]);
    }
    return unit * x;
  };

  // src/model/modes.js
  var MOST_NODES2 = 3e3;
  var MOSTLY = 0.6;
  var PARTLY = 0.3;
  var ALIKE = 1e-6;
  var FLAT = 1e-9;
  var ROUNDING = 1e-11;
  var MOST_KEPT2 = 200;
  var kept = /* @__PURE__ */ new WeakMap();
  var naturalFrequency = (sheet) => {
    const lattice2 = latticeOf(sheet);
    const { bending_stiffness: bending, torsion_stiffness: torsion } = sheet;
    if (lattice2.nNodes > MOST_NODES2) return NaN;
    const unit = Math.max(bending, torsion);
    const ratios = unit > 0 ? [bending / unit, torsion / unit] : [0, 0];
    return unitFrequency(lattice2, ratios) * Math.sqrt(unit / nodeMass(sheet)) / sheet.pitch;
  };
  var unitFrequency = (lattice2, ratios) => {
    if (!kept.has(lattice2)) kept.set(lattice2, /* @__PURE__ */ new Map());
    const found = kept.get(lattice2);
    const key = String(ratios);
    if (found.size > MOST_KEPT2) found.clear();
    if (!found.has(key)) found.set(key, Math.sqrt(naturalSquared(lattice2, ratios)));
    return found.get(key);
  };
  var naturalSquared = (lattice2, [bending, torsion]) => {
    const matrix = stiffness(lattice2, bending, torsion);
    const rigid = rigidMotion(lattice2);
    const named = namedModes(matrix, rigid, lattice2);
    if (named.dish) return named.dish.squared;
    return lowestSquared(matrix, named.twist ? [...rigid, named.twist.direction] : rigid);
  };
  var stiffness = ({ nNodes, lineStart, lineNodes, axial, cells }, bending, torsion) => {
    const elements = [];
    for (let i = 0; i < axial; i++)
      for (let k = lineStart[i]; k + 2 < lineStart[i + 1]; k++)
        elements.push({
          nodes: [lineNodes[k], lineNodes[k + 1], lineNodes[k + 2]],
          weights: [1, -2, 1],
          factor: bending
        });
    for (let c = 0; c < cells.length; c += 4)
      elements.push({ nodes: [...cells.subarray(c, c + 4)], weights: [1, -1, -1, 1], factor: 2 * torsion });
    return new BandedMatrix(
      nNodes,
      elements.filter(({ factor }) => factor > 0)
    );
  };
  var columnsOf = ({ nNodes, rest }) => [0, 1].map((axis2) => Float64Array.from({ length: nNodes }, (_, k) => rest[2 * k + axis2]));
  var rigidMotion = (lattice2) => {
    const basis = [];
    for (const motion of [new Float64Array(lattice2.nNodes).fill(1), ...columnsOf(lattice2)]) {
      const own = without(motion, basis);
      if (own.size > FLAT * Math.sqrt(dot(motion, motion))) basis.push(own.unit);
    }
    return basis;
  };
  var namedModes = (matrix, rigid, lattice2) => {
    const [x, y] = columnsOf(lattice2);
    const shapes = { dish: (a, b) => a * a + b * b, saddle: (a, b) => a * a - b * b, twist: (a, b) => a * b };
    const held = [];
    let inverse = null;
    for (const [name, of] of Object.entries(shapes)) {
      const shape = x.map((a, k) => of(a, y[k]));
      const bent = without(shape, rigid);
      if (rigid.length < 3 || !(bent.size > FLAT * Math.sqrt(dot(shape, shape)))) continue;
      inverse ??= matrix.inverse(0.1 * matrix.quotient(bent.unit));
      const modes = spacesOf(heldModes(inverse, bent.unit, rigid), ROUNDING * matrix.largest);
      held.push({ name, modes, surest: Math.max(...modes.map(({ share: share2 }) => share2)) });
    }
    const rounded = (share2) => Math.round(share2 / ALIKE);
    held.sort((a, b) => rounded(b.surest) - rounded(a.surest));
    const named = {};
    for (const { name, modes, surest } of held) {
      const taken = Object.values(named).map(({ direction }) => direction);
      const left = modes.map(({ share: share2, direction }) => without(scaled(direction, share2), taken));
      const mostly = left.findIndex(({ size }) => size > MOSTLY);
      const which = mostly >= 0 ? mostly : modes.findIndex(({ share: share2 }) => share2 > (1 - ALIKE) * surest);
      if (left[which].size > PARTLY) named[name] = { squared: modes[which].squared, direction: left[which].unit };
    }
    return named;
  };
  var spacesOf = (modes, rounding) => {
    const spaces = [];
    for (const { squared, share: share2, direction } of modes) {
      const last2 = spaces.at(-1);
      if (!last2 || squared - last2.upTo > rounding)
        spaces.push({ squared, upTo: squared, held: scaled(direction, share2) });
      else {
        last2.upTo = squared;
        add(last2.held, direction, share2);
      }
    }
    return spaces.map(({ squared, held }) => {
      const { unit, size } = without(held, []);
      return { squared: squared > rounding ? squared : 0, share: size, direction: unit };
    });
  };
  var lowestSquared = (matrix, along) => {
    const { unit, size } = without(
      Float64Array.from({ length: matrix.n }, (_, k) => Math.sin(1.3 * k * k + 0.7)),
      along
    );
    let squared = 1e-6 * matrix.largest;
    for (let pass = 0; pass < 2 && size > FLAT; pass++) {
      const modes = heldModes(matrix.inverse(squared), unit, along);
      squared = modes.find((mode) => mode.squared > ROUNDING * matrix.largest)?.squared ?? NaN;
      if (Number.isNaN(squared)) break;
    }
    return size > FLAT && matrix.largest > 0 ? squared : NaN;
  };

  // src/app/change.js
  function valueOf(scenario, name) {
    if (name === "friction_angle") return Math.atan(scenario.friction.static);
    if (name === "natural_frequency") return naturalFrequency(scenario.sheet);
    if (name === "motion.phase") return strokeOf(scenario.motion).phase;
    if (name === "motion.stroke") return strokeOf(scenario.motion).amplitude;
    return name.split(".").reduce((part, key) => part === null || part === void 0 ? void 0 : part[key], scenario);
  }
  function withValue(scenario, name, value) {
    if (name === "friction_angle") return withFriction(scenario, Math.tan(value));
    if (name === "natural_frequency") return withNaturalFrequency(scenario, value);
    if (name === "friction.static") return withFriction(scenario, value);
    if (name === "motion.phase") return withStroke(scenario, strokeOf(scenario.motion).amplitude, value);
    if (name === "motion.stroke") return withStroke(scenario, value, strokeOf(scenario.motion).phase);
    return put(scenario, name.split("."), value);
  }
  var withValues = (scenario, values) => Object.entries(values).reduce((changed2, [name, value]) => withValue(changed2, name, value), scenario);
  function put(part, [key, ...rest], value) {
    const copy = Array.isArray(part) ? [...part] : { ...part };
    copy[key] = rest.length ? put(part?.[key] ?? {}, rest, value) : value;
    return copy;
  }
  function withNaturalFrequency(scenario, value) {
    const own = naturalFrequency(scenario.sheet);
    if (!(own > 0)) throw new Error("the sheet has no bending stiffness to scale: give it one first");
    const by = (value / own) ** 2;
    const { bending_stiffness: kb, torsion_stiffness: kt } = scenario.sheet;
    return { ...scenario, sheet: { ...scenario.sheet, bending_stiffness: kb * by, torsion_stiffness: kt * by } };
  }
  function withFriction(scenario, mu) {
    const { static: before, kinetic } = scenario.friction;
    const ratio = before > 0 ? kinetic / before : 1;
    return { ...scenario, friction: { ...scenario.friction, static: mu, kinetic: Math.min(mu, ratio * mu) } };
  }
  var isStroke = (wave2) => wave2.axis === "x" && wave2.ratio === 1;
  function strokeOf(motion) {
    const wave2 = motion.stroke === 0 ? motion.waves.find(isStroke) : void 0;
    return wave2 ? { amplitude: wave2.amplitude, phase: wave2.phase } : { amplitude: motion.stroke, phase: 0 };
  }
  function withStroke(scenario, amplitude, phase) {
    const { motion } = scenario;
    const which = motion.stroke === 0 ? motion.waves.findIndex(isStroke) : -1;
    const others = motion.waves.filter((_, i) => i !== which);
    const own = phase === 0 ? [] : [{ axis: "x", amplitude, ratio: 1, phase }];
    return { ...scenario, motion: { ...motion, stroke: phase === 0 ? amplitude : 0, waves: [...own, ...others] } };
  }
  function differences(a, b, prefix = "") {
    if (a === b) return [];
    const whole2 = a === null || b === null || typeof a !== "object" || typeof b !== "object";
    if (whole2 || Array.isArray(a) || Array.isArray(b)) return JSON.stringify(a) === JSON.stringify(b) ? [] : [prefix];
    const keys2 = /* @__PURE__ */ new Set([...Object.keys(a), ...Object.keys(b)]);
    return [...keys2].flatMap((key) => differences(a[key], b[key], prefix ? `${prefix}.${key}` : key));
  }
  function wayTo(before, after) {
    const changed2 = differences(before, after).filter((name) => !["name", "sheet.name"].includes(name));
    if (changed2.length === 0) return "same";
    const anew = /^(sheet\.outline|sheet\.pitch|start|time_step)/;
    if (changed2.some((name) => anew.test(name))) return "anew";
    if (changed2.every((name) => name.startsWith("motion.") && name !== "motion.height")) return "motion";
    if (changed2.every((name) => ["duration", "transient", "slip_limit"].includes(name))) return "measure";
    return "become";
  }

  // src/app/listed.js
  var DEG2 = Math.PI / 180;
  var GROUPS = [
    {
      title: "Plate motion",
      open: true,
      controls: [
        ["motion.frequency", "Frequency f", 2, 60, false],
        ["motion.angle", "Swing Aₚ about the bar", 0, 16, false],
        ["motion.stroke", "Stroke Bₚ along the bar", 0, 8, false],
        ["motion.phase", "Phase of the stroke", -180, 180, false],
        ["motion.offset.rx", "Tilt about the bar", -10, 10, false],
        ["motion.offset.ry", "Tilt across the bar", -10, 10, false],
        ["motion.height", "Plate above its axis", -20, 40, false],
        ["motion.ramp", "Smooth start", 0, 1, false]
      ]
    },
    {
      title: "Object",
      open: true,
      controls: [
        ["sheet.mass", "Mass", 1, 100, true],
        ["natural_frequency", "Natural frequency ωₙ", 1, 60, true],
        ["sheet.bending_stiffness", "Bending stiffness k_b", 1e-5, 1, true],
        ["sheet.bending_damping", "Bending damping c_b", 1e-8, 1e-3, true],
        ["sheet.torsion_stiffness", "Torsion stiffness k_t", 0, 0.02, false],
        ["sheet.torsion_damping", "Torsion damping c_t", 0, 1e-4, false],
        ["sheet.axial_stiffness", "In-plane stiffness k_c", 0.05, 20, true],
        ["sheet.axial_damping", "In-plane damping c_c", 0, 5e-3, false],
        ["sheet.shear_ratio", "Shear over in-plane", 0.1, 10, true],
        ["sheet.thickness", "Thickness (drawn)", 0.2, 20, true],
        ["sheet.pitch", "Distance between nodes", 2, 20, true]
      ]
    },
    {
      title: "Friction and contact",
      controls: [
        ["friction.static", "Static friction μ_s", 0, 2, false],
        ["friction.kinetic", "Kinetic friction μ_k", 0, 2, false],
        ["friction.transition_speed", "Transition speed V", 1, 1e3, true],
        ["friction.kinetic_speed_ratio", "Full μ_k at … times V", 1.1, 100, true],
        ["contact.stiffness", "Contact stiffness", 0.5, 200, true],
        ["contact.damping", "Contact damping", 0, 0.1, false],
        ["contact.damping_ramp", "Depth of full damping", 0, 1, false]
      ]
    },
    {
      title: "Place and measurement",
      controls: [
        ["start.x", "Starts at x", -80, 80, false],
        ["start.y", "Starts at y", -80, 80, false],
        ["start.angle", "Starts at angle", -180, 180, false],
        ["gravity", "Gravity", 0, 25, false],
        ["slip_limit", "Failed after slipping", 1, 50, true],
        ["duration", "Duration of a saved run", 0.5, 20, true]
      ]
    }
  ];
  var SHORTHANDS = [
    {
      name: "natural_frequency",
      unit: "rad/s",
      display: "pi rad/s",
      factor: Math.PI,
      example: "10 pi rad/s",
      above: 0,
      at_least: null,
      at_most: null,
      description: "of the dish mode: bending stiffness follows by its square",
      choices: null
    },
    {
      name: "motion.phase",
      unit: "rad",
      display: "deg",
      factor: DEG2,
      example: "90 deg",
      above: null,
      at_least: null,
      at_most: null,
      description: "of the stroke along the bar against the swing about it",
      choices: null
    }
  ];
  var OUTLINES = {
    disk: (size) => ({ shape: "disk", radius: size / 2 }),
    ellipse: (size) => ({ shape: "ellipse", length: size, width: 0.6 * size }),
    rectangle: (size) => ({ shape: "rectangle", length: size, width: 0.6 * size }),
    leaf: (size) => ({ shape: "polygon", corners: leaf(size) }),
    fish: (size) => ({ shape: "polygon", corners: fish(size) }),
    triangle: (size) => ({ shape: "polygon", corners: regular(3, size) }),
    hexagon: (size) => ({ shape: "polygon", corners: regular(6, size) })
  };
  function regular(n, size) {
    const corners2 = Array.from({ length: n }, (_, k) => 2 * Math.PI * (k + 0.25) / n).map((angle) => [Math.cos(angle), Math.sin(angle)]);
    const by = size / Math.max(...sizeOf({ shape: "polygon", corners: corners2 }));
    return corners2.map(([x, y]) => [by * x, by * y]);
  }
  function leaf(size) {
    const edge = Array.from({ length: 13 }, (_, k) => {
      const u = k / 12;
      return [size * (u - 0.5), 0.33 * size * Math.sin(Math.PI * u ** 0.8)];
    });
    return [...edge, ...edge.slice(1, -1).reverse().map(([x, y]) => [x, -y])];
  }
  function fish(size) {
    const half = [
      [-0.5, 0.22],
      [-0.38, 0.07],
      [-0.27, 0.08],
      [-0.1, 0.19],
      [0.12, 0.22],
      [0.32, 0.15],
      [0.45, 0.06],
      [0.5, 0]
    ].map(([x, y]) => [size * x, size * y]);
    return [...half, ...half.slice(0, -1).reverse().map(([x, y]) => [x, -y]), [-0.43 * size, 0]];
  }
  function sizeOf(outline) {
    if (outline.shape === "disk") return [2 * outline.radius, 2 * outline.radius];
    if (outline.shape === "polygon") {
      return [0, 1].map((k) => {
        const values = outline.corners.map((corner) => corner[k]);
        return Math.max(...values) - Math.min(...values);
      });
    }
    if (outline.shape === "mask") {
      const width = outline.width_of_picture;
      const rows = outline.rows ?? [];
      return [width, rows.length ? width * rows.length / rows[0].length : width];
    }
    return [outline.length, outline.width];
  }

  // src/app/quantity.js
  var NUMBER = /^\s*([-+−]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[-+]?\d+)?)\s*(.*?)\s*$/i;
  function shown2(value, field, digits3 = 4) {
    if (value === null || value === void 0 || !Number.isFinite(value)) return "–";
    const number = value / (field.factor ?? 1);
    return trimmed(number, digits3);
  }
  function trimmed(number, digits3 = 4) {
    if (!Number.isFinite(number)) return "–";
    const size = Math.abs(number);
    const text = size !== 0 && (size < 1e-4 || size >= 1e6) ? number.toExponential(digits3 - 1) : number.toPrecision(digits3);
    return text.includes("e") ? text.replace(/\.?0+e/, "e") : text.includes(".") ? text.replace(/\.?0+$/, "") : text;
  }
  var withUnit = (value, field, digits3 = 4) => `${shown2(value, field, digits3)} ${pretty(field.display)}`.trim();
  var pretty = (unit) => unit.replaceAll("*", " ").replace("pi rad", "π rad").replace("^2", "²").replace("^3", "³").replace(/\bdeg\b/g, "°").replace("mm/deg", "mm/°");
  function fault(value, field) {
    const allowed = [];
    if (field.above !== null && field.above !== void 0) allowed.push(["above", field.above, value > field.above]);
    if (field.at_least !== null && field.at_least !== void 0)
      allowed.push(["at least", field.at_least, value >= field.at_least]);
    if (field.at_most !== null && field.at_most !== void 0)
      allowed.push(["at most", field.at_most, value <= field.at_most]);
    if (Number.isFinite(value) && allowed.every(([, , holds]) => holds)) return null;
    const bounds = allowed.map(([word, bound]) => `${word} ${withUnit(bound, field)}`).join(" and ");
    const got = Number.isFinite(value) ? withUnit(value, field) : "no number";
    return `${got} is not allowed: ${bounds || "a finite number"}. Type ${field.example}.`;
  }
  function parsed(text, field, units) {
    const match = NUMBER.exec(text.replace(/^(\s*[-+]?\d+),(\d+)/, "$1.$2"));
    if (!match) return { fault: `“${text.slice(0, 40)}” does not begin with a number. Type ${field.example}.` };
    const number = Number(match[1].replace("−", "-"));
    const factor = match[2] === "" ? field.factor ?? 1 : factorOf(match[2], field, units);
    if (factor === null) {
      const known = Object.entries(units).filter(([, [, si2]]) => si2 === field.unit).map(([name]) => name);
      return { fault: `“${match[2].slice(0, 20)}” is no unit here: ${known.slice(0, 6).join(", ") || "a plain number"}.` };
    }
    const value = number * factor;
    const wrong = fault(value, field);
    return wrong ? { fault: wrong } : { value };
  }
  function factorOf(unit, field, units) {
    let name = unit.replaceAll("·", "*").replaceAll("°", "deg").replaceAll("µ", "u").replaceAll("μ", "u");
    let turns2 = 1;
    const times = /^(?:pi|π)\s*\*?\s*(.*)$/.exec(name);
    if (field.unit === "rad/s" && times) {
      turns2 = Math.PI;
      name = times[1] || "rad/s";
    }
    if (!Object.hasOwn(units, name)) return null;
    const [factor, si2] = units[name];
    if (si2 === field.unit) return factor * turns2;
    return si2 === "Hz" && field.unit === "rad/s" ? 2 * Math.PI * factor : null;
  }

  // src/app/waveform.js
  var SERIES = {
    sine: [[1, 1]],
    triangle: [1, 3, 5, 7].map((n, i) => [n, 8 / Math.PI ** 2 * (i % 2 ? -1 : 1) / n ** 2]),
    trapezoid: [1, 3, 5].map((n) => [n, 4 / Math.PI * (Math.sin(n * Math.PI / 6) / (n * Math.PI / 6)) * (1 / n)]),
    sawtooth: [1, 2, 3, 4].map((n) => [n, 2 / Math.PI * (n % 2 ? 1 : -1) / n])
  };
  var WAVEFORMS = Object.keys(SERIES);
  function shaped(motion, kind) {
    const others = motion.waves.filter((wave2) => !isHarmonic(wave2));
    const further = SERIES[kind].slice(1).flatMap(([ratio, share2]) => {
      const first = SERIES[kind][0][1];
      return [
        { axis: "rx", amplitude: -motion.angle * share2 / first, ratio, phase: 0 },
        { axis: "x", amplitude: motion.stroke * share2 / first, ratio, phase: 0 }
      ].filter((wave2) => wave2.amplitude !== 0);
    });
    return { ...motion, waves: [...others, ...further] };
  }
  function shapeOf(motion) {
    const harmonics = motion.waves.filter(isHarmonic).length;
    if (harmonics === 0) return "sine";
    const same = (kind) => {
      const wanted = shaped(motion, kind).waves.filter(isHarmonic);
      const own = motion.waves.filter(isHarmonic);
      const key = (wave2) => `${wave2.axis} ${wave2.ratio} ${wave2.amplitude.toPrecision(6)}`;
      return wanted.length === own.length && wanted.map(key).sort().join() === own.map(key).sort().join();
    };
    return WAVEFORMS.find((kind) => kind !== "sine" && same(kind)) ?? "own";
  }
  var isHarmonic = (wave2) => ["rx", "x"].includes(wave2.axis) && wave2.ratio > 1 && Number.isInteger(wave2.ratio) && wave2.phase === 0;

  // src/app/controls.js
  var STEPS2 = 400;
  function controls(panel, desk) {
    const fields = Object.fromEntries([...desk.facts.fields, ...SHORTHANDS].map((field) => [field.name, field]));
    const rows = [];
    const narrow = matchMedia("(max-width: 900px)").matches;
    const groups = GROUPS.map((group) => {
      const own = group.controls.filter(([name]) => fields[name]).map((control) => row(desk, fields[control[0]], control));
      rows.push(...own);
      const body = make("div", { class: "group" });
      const extra = {
        "Object": objectPart,
        "Plate motion": motionPart,
        "Friction and contact": lawPart,
        "Place and measurement": platePart
      }[group.title];
      const part = extra?.(desk, fields);
      if (part) {
        rows.push(part);
        body.append(part.element);
      }
      body.append(...own.map((each) => each.element));
      return make("details", { open: Boolean(group.open) && (!narrow || group.title === GROUPS[0].title) }, make("summary", {}, group.title), body);
    });
    const origins = make(
      "p",
      { class: "origins" },
      mark("published"),
      " printed in the source  ",
      mark("inferred"),
      " inferred  ",
      mark("yours"),
      " yours"
    );
    panel.append(presets(desk), origins, ...groups);
    const update = () => rows.forEach((each) => each.update());
    update();
    return { update };
  }
  function presets(desk) {
    const names = Object.keys(desk.facts.presets);
    const options = [["", "Begin from…"], ...names.map((name) => [name, name])];
    const select = choice("Begin from a preset", options, "", (name) => {
      if (name) desk.set(structuredClone(desk.facts.presets[name].scenario));
      select.value = "";
    });
    return make("div", { class: "row wide" }, make("label", {}, make("span", {}, "Preset"), select));
  }
  var MARKS = { published: "●", inferred: "◐", yours: "○" };
  function mark(origin) {
    return make("span", { class: `origin ${origin}`, "aria-hidden": "true" }, MARKS[origin]);
  }
  function originOf(desk, name) {
    const preset = desk.facts.presets[desk.scenario().name];
    if (!preset) return ["yours", "yours"];
    const [own, theirs] = [valueOf(desk.scenario(), name), valueOf(preset.scenario, name)];
    if (JSON.stringify(own) !== JSON.stringify(theirs)) return ["yours", "yours"];
    if (preset.published[name]) return ["published", `published: ${preset.published[name]}`];
    if (preset.inferred[name]) return ["inferred", `inferred: ${preset.inferred[name]}`];
    return ["yours", "the model's default"];
  }
  function row(desk, field, [name, title, least2, most, byFactor]) {
    const id = identity("field");
    const says = make("p", { class: "fault", id: `${id}-fault`, role: "alert" });
    const origin = mark("yours");
    const text = make("input", {
      type: "text",
      id,
      class: "number",
      autocomplete: "off",
      spellcheck: false,
      inputMode: "decimal",
      "aria-describedby": `${id}-fault`
    });
    const slider = make("input", { type: "range", min: 0, max: STEPS2, step: 1, "aria-label": `${title}, slider` });
    const toValue = (place) => scaled2(place / STEPS2, least2, most, byFactor) * (field.factor ?? 1);
    const current = () => name === "natural_frequency" ? desk.naturalFrequency() : valueOf(desk.scenario(), name);
    const put2 = (value) => {
      const wrong = fault(value, field);
      const refusal = wrong ?? desk.change(name, value);
      says.textContent = refusal ?? "";
      text.setAttribute("aria-invalid", String(Boolean(refusal)));
      if (!refusal) update();
    };
    text.addEventListener("change", () => {
      const read3 = parsed(text.value, field, desk.facts.units);
      if ("fault" in read3) {
        says.textContent = read3.fault;
        text.setAttribute("aria-invalid", "true");
      } else put2(read3.value);
    });
    text.addEventListener("keydown", (event) => {
      if (event.key === "Escape") update();
    });
    slider.addEventListener("input", () => put2(Number(toValue(Number(slider.value)).toPrecision(3))));
    function update() {
      const value = current();
      if (document.activeElement !== text || text.getAttribute("aria-invalid") !== "true") {
        text.value = shown2(value, field);
        text.setAttribute("aria-invalid", "false");
        says.textContent = "";
      }
      if (document.activeElement !== slider)
        slider.value = String(Math.round(STEPS2 * placed((value ?? 0) / (field.factor ?? 1), least2, most, byFactor)));
      slider.setAttribute("aria-valuetext", `${shown2(value, field)} ${pretty(field.display)}`);
      const [kind, where] = originOf(desk, name);
      origin.className = `origin ${kind}`;
      origin.textContent = MARKS[kind];
      element2.title = `${field.description ?? title} (${where})`;
    }
    const element2 = make(
      "div",
      { class: "row", "data-field": name },
      make("label", { for: id }, origin, title),
      text,
      make("span", { class: "unit" }, pretty(field.display)),
      slider,
      says
    );
    return { element: element2, update };
  }
  function scaled2(share2, least2, most, byFactor) {
    return byFactor ? least2 * (most / least2) ** share2 : least2 + share2 * (most - least2);
  }
  function placed(value, least2, most, byFactor) {
    const share2 = byFactor ? Math.log(Math.max(value, least2) / least2) / Math.log(most / least2) : (value - least2) / (most - least2);
    return Math.min(1, Math.max(0, Number.isFinite(share2) ? share2 : 0));
  }
  function objectPart(desk, fields) {
    const element2 = make("div", { class: "part" });
    const kinds = [...Object.keys(OUTLINES).map((kind) => [kind, kind]), ["own", "its own polygon"], ["mask", "a picture's"]];
    const select = choice("Outline", kinds, "disk", (kind) => {
      const outline = desk.scenario().sheet.outline;
      if (OUTLINES[kind]) desk.change("sheet.outline", OUTLINES[kind](Math.max(...sizeOf(outline))));
      update();
    });
    const sizes = make("div");
    element2.append(make("div", { class: "row wide" }, make("label", {}, make("span", {}, "Outline"), select)), sizes);
    const length = (name) => fields[name] ?? { ...fields["sheet.pitch"], name, description: "size of the outline" };
    let has = "";
    let own = [];
    function update() {
      const outline = desk.scenario().sheet.outline;
      const shape = outline.shape;
      const named = shape === "polygon" ? Object.keys(OUTLINES).find((kind) => isLike(OUTLINES[kind](Math.max(...sizeOf(outline))), outline)) ?? "own" : shape;
      select.value = named;
      if (has !== shape) {
        has = shape;
        const wanted = {
          disk: [["radius", "Radius"]],
          ellipse: [["length", "Length"], ["width", "Width"]],
          rectangle: [["length", "Length"], ["width", "Width"]],
          mask: [["width_of_picture", "Width of the picture"]]
        }[shape];
        own = (wanted ?? []).map(([key, title]) => {
          const name = `sheet.outline.${key}`;
          return row(desk, length(name), [name, title, 10, 200, true]);
        });
        if (shape === "polygon") own = [polygonSize2(desk, length("sheet.outline.size"))];
        sizes.replaceChildren(...own.map((each) => each.element));
      }
      own.forEach((each) => each.update());
    }
    return { element: element2, update };
  }
  function isLike(a, b) {
    if (a.shape !== b.shape || a.corners.length !== b.corners.length) return false;
    return a.corners.every(([x, y], k) => Math.hypot(x - b.corners[k][0], y - b.corners[k][1]) < 1e-6);
  }
  function polygonSize2(desk, field) {
    const within = {
      ...desk,
      scenario: () => ({ size: Math.max(...sizeOf(desk.scenario().sheet.outline)) }),
      change: (_, value) => {
        const outline = desk.scenario().sheet.outline;
        const by = value / Math.max(...sizeOf(outline));
        return desk.change("sheet.outline", { ...outline, corners: outline.corners.map(([x, y]) => [x * by, y * by]) });
      }
    };
    return row(within, field, ["size", "Size", 10, 200, true]);
  }
  function motionPart(desk, fields) {
    const kinds = [...WAVEFORMS.map((kind) => [kind, kind]), ["own", "its own"]];
    const select = choice("Shape of the swing", kinds, "sine", (kind) => {
      if (kind !== "own") desk.change("motion", shaped(desk.scenario().motion, kind));
      update();
    });
    const list = make("ul", { class: "waves" });
    const add2 = button("Add a sine", () => {
      const { motion } = desk.scenario();
      desk.change("motion.waves", [...motion.waves, { axis: "z", amplitude: 5e-4, ratio: 1, phase: 0 }]);
      update();
    });
    const note = make("p", { class: "note" });
    const element2 = make(
      "div",
      { class: "part" },
      make("div", { class: "row wide" }, make("label", {}, make("span", {}, "Waveform"), select)),
      note,
      list,
      add2
    );
    const angle = fields["motion.angle"];
    const stroke = fields["motion.stroke"];
    function update() {
      const { motion } = desk.scenario();
      select.value = shapeOf(motion);
      note.textContent = motion.samples ? `and a sampled trajectory of ${motion.samples.time.length} points` : "";
      add2.disabled = motion.waves.length >= 8;
      if (list.contains(document.activeElement) && list.children.length === motion.waves.length) return;
      list.replaceChildren(...motion.waves.map((wave2, i) => {
        const put2 = (key) => (value) => {
          desk.change(`motion.waves.${i}.${key}`, value);
          update();
        };
        const measure = wave2.axis.startsWith("r") ? angle : stroke;
        const amplitude = { ...measure, above: null, at_least: null, description: "amplitude" };
        const ratio = { ...angle, unit: "", display: "", factor: 1, above: 0, at_least: null, at_most: 12, example: "2" };
        const phase = { ...angle, above: null, at_least: null, at_most: null, example: "90 deg" };
        return make(
          "li",
          {},
          choice("Axis", ["x", "y", "z", "rx", "ry", "rz"].map((axis2) => [axis2, axis2]), wave2.axis, (axis2) => put2("axis")(axis2)),
          small(desk, amplitude, "amplitude", wave2.amplitude, put2("amplitude")),
          small(desk, ratio, "times f", wave2.ratio, put2("ratio")),
          small(desk, phase, "phase", wave2.phase, put2("phase")),
          button("×", () => {
            desk.change("motion.waves", motion.waves.filter((_, j) => j !== i));
            update();
          }, { "aria-label": `Remove the sine on ${wave2.axis}` })
        );
      }));
    }
    return { element: element2, update };
  }
  function small(desk, field, title, value, put2) {
    const input = make("input", {
      type: "text",
      class: "number",
      value: shown2(value, field),
      inputMode: "decimal",
      "aria-label": `${title}${field.display ? ` in ${field.display}` : ""}`,
      autocomplete: "off"
    });
    input.addEventListener("change", () => {
      const read3 = parsed(input.value, field, desk.facts.units);
      input.setAttribute("aria-invalid", String("fault" in read3));
      input.title = "fault" in read3 ? read3.fault : "";
      if ("value" in read3) put2(read3.value);
    });
    return make("label", { class: "small" }, input, make("span", { class: "unit" }, pretty(field.display) || title));
  }
  function lawPart(desk) {
    const options = [["thesis", "step at V (3.2)"], ["adams", "smooth"]];
    const select = choice("Law of friction", options, "thesis", (law) => desk.change("friction.law", law));
    const element2 = make("div", { class: "row wide" }, make("label", {}, make("span", {}, "Law of friction"), select));
    return { element: element2, update: () => select.value = desk.scenario().friction.law };
  }
  function platePart(desk, fields) {
    const box = make("input", { type: "checkbox", id: identity("plate"), onchange: () => {
      desk.change("plate", box.checked ? { length: 0.2, width: 0.2 } : null);
      update();
    } });
    const field = fields["plate.length"] ?? { ...fields["sheet.pitch"], description: "size of the plate" };
    const rows = [["plate.length", "Plate along the bar"], ["plate.width", "Plate across it"]].map(([name, title]) => row(desk, { ...field, name }, [name, title, 40, 500, true]));
    const sizes = make("div", {}, ...rows.map((each) => each.element));
    const element2 = make(
      "div",
      { class: "part" },
      make("div", { class: "row wide" }, make("label", { for: box.id }, box, " The plate ends")),
      sizes
    );
    function update() {
      const { plate } = desk.scenario();
      box.checked = Boolean(plate);
      sizes.hidden = !plate;
      if (plate) rows.forEach((each) => each.update());
    }
    return { element: element2, update };
  }

  // src/model/motion.js
  var AXES = ["x", "y", "z", "rx", "ry", "rz"];
  var SHORTEST_SAMPLE = 1e-9;
  var LARGEST_SAMPLE = 1e9;
  var MOST_SAMPLES = 2e5;
  var MOST_WAVES = 100;
  var TIMES = "[0, 0.01, 0.02]";
  var turns = (axis2) => axis2.startsWith("r");
  var termsOf = ({ stroke, angle, frequency, waves }) => [
    [0, stroke, frequency, 0],
    [3, -angle, frequency, 0],
    ...waves.map((wave2) => [
      AXES.indexOf(wave2.axis),
      wave2.amplitude,
      wave2.ratio * frequency,
      wave2.phase / (2 * Math.PI)
    ])
  ].filter(([, amplitude]) => amplitude !== 0);
  var shortestPeriod = (motion) => {
    const fastest = Math.max(0, ...termsOf(motion).map(([, , frequency]) => frequency));
    return fastest > 0 ? 1 / fastest : Infinity;
  };
  var periodOf = ({ frequency, waves }) => {
    const denominators = waves.filter(({ ratio }) => ratio !== 1).map(({ ratio }) => denominatorOf(ratio));
    return Math.min(denominators.reduce(leastCommonMultiple, 1) / frequency, 1e300);
  };
  var denominatorOf = (number) => {
    let [nearest, least2] = [1, Infinity];
    for (let q = 1; q <= 12; q++) {
      const off = Math.abs(number - roundHalfEven(number * q) / q);
      if (off < least2) [nearest, least2] = [q, off];
    }
    return nearest;
  };
  var leastCommonMultiple = (a, b) => a / greatestCommonDivisor(a, b) * b;
  var greatestCommonDivisor = (a, b) => b === 0 ? a : greatestCommonDivisor(b, a % b);
  var NUMBERS2 = { frequency: FREQUENCY, angle: PLATE_ANGLE, stroke: PLATE_STROKE, height: OFFSET, ramp: DELAY };
  var checkMotion = (motion) => {
    checkTable(motion, "motion");
    checkNumbers(motion, "motion", NUMBERS2);
    if (motion.offset !== void 0) checkTable(motion.offset, "motion.offset");
    for (const [axis2, value] of Object.entries(motion.offset ?? {}))
      if (AXES.includes(axis2)) checkNumber(value, `motion.offset.${axis2}`, turns(axis2) ? PLATE_ANGLE : OFFSET);
    checkWaves(motion.waves);
    if (motion.samples !== null && motion.samples !== void 0)
      checkSamples(checkTable(motion.samples, "motion.samples"));
  };
  var checkWaves = (waves) => {
    const example = '[{ axis = "z", amplitude = "1 mm" }]';
    if (!Array.isArray(waves) || waves.length > MOST_WAVES)
      throw new Refusal("motion.waves", told(waves), `a list of at most ${MOST_WAVES} sines`, example);
    waves.forEach((wave2, i) => {
      const field = `motion.waves.${i}`;
      checkTable(wave2, field);
      if (!AXES.includes(wave2.axis))
        throw new Refusal(`${field}.axis`, told(wave2.axis), `one of ${AXES.join(", ")}`, '"z"');
      checkNumbers(wave2, field, { amplitude: turns(wave2.axis) ? ANGLE : STROKE, ratio: RATIO, phase: ANGLE });
    });
  };
  var checkSamples = (samples) => {
    const { time } = samples;
    const field = "motion.samples.time";
    if (!Array.isArray(time) || time.length < 2 || time.length > MOST_SAMPLES)
      throw new Refusal(field, told(time), `2 to ${MOST_SAMPLES} finite times that rise from 0 s`, TIMES);
    const rises = time[0] === 0 && time.every((t, k) => Number.isFinite(t) && (k === 0 || t - time[k - 1] >= SHORTEST_SAMPLE));
    if (!rises)
      throw new Refusal(field, told(time), `finite times that rise from 0 s by at least ${SHORTEST_SAMPLE} s`, TIMES);
    for (const axis2 of AXES) {
      const values = samples[axis2];
      if (values === void 0 || values === null || values.length === 0) continue;
      const fits = Array.isArray(values) && values.length === time.length && values.every((value) => typeof value === "number" && Math.abs(value) <= LARGEST_SAMPLE);
      if (!fits)
        throw new Refusal(
          `motion.samples.${axis2}`,
          told(values),
          `${time.length} values, one for each time, of at most ${LARGEST_SAMPLE} in size`,
          TIMES
        );
    }
  };

  // src/model/scenario.js
  var LARGEST_TIME_STEP = 1e-4;
  var SHARE_OF_STABLE_STEP = 0.85;
  var STEPS_PER_SINE = 20;
  var MOST_STEPS = 2e9;
  var FRICTION_RATIO = 0.53;
  var LAWS = ["thesis", "adams"];
  var CONTACT = { stiffness: AXIAL_STIFFNESS, damping: AXIAL_DAMPING, damping_ramp: DEPTH, tile_area: AREA };
  var FRICTION = {
    static: COEFFICIENT,
    kinetic: COEFFICIENT,
    transition_speed: SPEED,
    kinetic_speed_ratio: SPEED_RATIO
  };
  var START = { x: OFFSET, y: OFFSET, angle: ANGLE };
  var PLATE = { length: LENGTH, width: LENGTH };
  var given = (value) => value !== null && value !== void 0;
  var checkScenario = (s) => {
    checkTable(s, "scenario");
    checkName(s.name, "name");
    checkSheet(s.sheet);
    checkName(s.sheet.name, "sheet.name");
    checkMotion(s.motion);
    checkNumbers(checkTable(s.contact, "contact"), "contact", CONTACT);
    checkFriction(checkTable(s.friction, "friction"));
    checkNumbers(checkTable(s.start, "start"), "start", START);
    if (given(s.plate)) checkNumbers(checkTable(s.plate, "plate"), "plate", PLATE);
    checkNumber(s.gravity, "gravity", ACCELERATION);
    checkNumber(s.duration, "duration", DURATION);
    if (given(s.transient)) checkNumber(s.transient, "transient", DELAY);
    checkNumber(s.slip_limit, "slip_limit", LENGTH);
    if (given(s.time_step)) checkNumber(s.time_step, "time_step", TIME_STEP);
    checkTimes(s);
  };
  var checkName = (name, field) => {
    if (given(name) && typeof name !== "string") throw new Refusal(field, told(name), "a word", '"cheese"');
  };
  var checkFriction = (friction) => {
    checkNumbers(friction, "friction", FRICTION);
    if (!LAWS.includes(friction.law))
      throw new Refusal("friction.law", told(friction.law), `one of ${LAWS.join(", ")}`, '"thesis"');
    if (friction.kinetic > friction.static)
      throw new Refusal(
        "friction.kinetic",
        told(friction.kinetic),
        `at most the static coefficient ${friction.static}`,
        digits(FRICTION_RATIO * friction.static)
      );
  };
  var checkTimes = (s) => {
    if (measuredFrom(s) >= s.duration)
      throw new Refusal(
        "transient",
        `${digits(measuredFrom(s))} s`,
        `below the duration ${digits(s.duration)} s`,
        `${digits(0.3 * s.duration)} s`
      );
    const [joints, sine, usual] = [stableTimeStep(s.sheet), stepOfFastestSine(s.motion), usualStep(s)];
    if (s.duration / usual > MOST_STEPS && usual === sine) {
      const fastest = s.motion.frequency * sine * MOST_STEPS / s.duration;
      throw new Refusal(
        "motion.frequency",
        `${digits(s.motion.frequency)} Hz`,
        `at most ${digits(fastest)} Hz where ${digits(s.duration)} s are simulated`,
        `${digits(Math.min(24, 0.5 * fastest))} Hz`
      );
    }
    if (s.duration / usual > MOST_STEPS)
      throw new Refusal(
        "duration",
        `${digits(s.duration)} s`,
        `at most ${digits(MOST_STEPS * usual)} s at a time step of ${digits(usual)} s`,
        `${digits(Math.min(4, 0.5 * MOST_STEPS * usual))} s`
      );
    const [least2, largest] = [s.duration / MOST_STEPS, Math.min(joints, sine)];
    if (!given(s.time_step) || s.time_step >= least2 && s.time_step <= largest) return;
    const reason = joints < sine ? "the joints stay stable" : `the fastest sine gets ${STEPS_PER_SINE} steps`;
    throw new Refusal(
      "time_step",
      `${digits(s.time_step)} s`,
      `at least ${digits(least2)} s and at most ${digits(largest)} s, where ${reason}`,
      `${digits(SHARE_OF_STABLE_STEP * usual)} s, or leave it out`
    );
  };
  var digits = (value) => String(Number(value.toPrecision(3)));
  var stepOfFastestSine = (motion) => Math.min(shortestPeriod(motion), periodOf(motion)) / STEPS_PER_SINE;
  var usualStep = ({ sheet, motion }) => Math.min(LARGEST_TIME_STEP, SHARE_OF_STABLE_STEP * stableTimeStep(sheet), stepOfFastestSine(motion));
  var measuredFrom = (s) => s.transient ?? 0.3 * s.duration;

  // src/app/history.js
  var MOST_BYTES = 64e6;
  var MOST_FRAMES = 6e3;
  var MOST_SAMPLES2 = 6e4;
  var Frames = class {
    constructor() {
      this.list = [];
    }
    get first() {
      return this.list[0] ?? null;
    }
    get last() {
      return this.list.at(-1) ?? null;
    }
    add(frames) {
      this.list.push(...frames);
      const each = (this.last?.nodes.byteLength ?? 0) * 2 + 200;
      const most = Math.max(120, Math.min(MOST_FRAMES, Math.floor(MOST_BYTES / each)));
      if (this.list.length > 1.25 * most) this.list.splice(0, this.list.length - most);
    }
    /** Number of the last frame that is not after a time. */
    indexAt(time) {
      let [low, high] = [0, this.list.length - 1];
      while (low < high) {
        const middle = low + high + 1 >> 1;
        if (this.list[middle].time <= time + 1e-9) low = middle;
        else high = middle - 1;
      }
      return low;
    }
    /** Forget what comes after a time: the sheet goes on from there. */
    cutAfter(time) {
      this.list.length = Math.min(this.list.length, this.indexAt(time) + 1);
    }
  };
  var AMOUNTS = /* @__PURE__ */ new Set(["joint_loss", "contact_work", "friction_loss", "plate_work"]);
  var Samples = class {
    constructor() {
      this.length = 0;
      this.channels = {};
    }
    add(samples) {
      const more = samples.time?.length ?? 0;
      for (const [name, values] of Object.entries(samples)) {
        const held = this.channels[name];
        if (!held || held.length < this.length + more) {
          const grown = new Float32Array(Math.max(4096, 2 * (this.length + more)));
          if (held) grown.set(held.subarray(0, this.length));
          this.channels[name] = grown;
        }
        this.channels[name].set(values, this.length);
      }
      this.length += more;
      if (this.length > MOST_SAMPLES2) {
        const gone = this.length - MOST_SAMPLES2 / 2;
        for (const [name, values] of Object.entries(this.channels)) {
          if (AMOUNTS.has(name)) values[1 + gone] += values.subarray(1, 1 + gone).reduce((sum2, value) => sum2 + value, 0);
          values.copyWithin(1, 1 + gone, this.length);
        }
        this.length -= gone;
      }
    }
    /** All channels, as far as there are samples: views, not copies. */
    all() {
      return this.from(0);
    }
    /** All channels from a sample on. */
    from(begin2) {
      const views = {};
      for (const [name, values] of Object.entries(this.channels)) views[name] = values.subarray(begin2, this.length);
      return views;
    }
    /** Number of the first sample after a time. */
    indexAfter(time) {
      const times = this.channels.time;
      let begin2 = this.length;
      while (begin2 > 0 && times[begin2 - 1] > time) begin2--;
      return begin2;
    }
  };

  // src/app/live.js
  var PICTURES = 60;
  var MANY_NODES_PICTURES = 16;
  var AHEAD = 0.15;
  var A_PERIOD = 8;
  var FEW_NODES = 200;
  var LEAST_CHUNK = 1e-3;
  var LONGEST_CHUNK = 0.06;
  var Live = class {
    /**
     * @param {{ask: (message: object) => Promise<any>, close: () => void}} worker
     * @param {string} key by which the worker knows the sheet
     * @param {{changed: () => void, refused: (message: string) => void}} told what happens is told to
     */
    constructor(worker, key, told3) {
      Object.assign(this, { worker, key, told: told3 });
      this.speed = 1;
      this.playing = true;
      this.clock = 0;
      this.capacity = Infinity;
      this.pace = { wall: 0, from: 0, speed: 0 };
      this.run = 0;
      this.ended = "";
      this.plan = [];
      this.script = [];
      this.frames = new Frames();
      this.samples = new Samples();
      this.queue = Promise.resolve();
      this.pending = false;
    }
    /**
     * Lay a sheet down, at rest, at time 0.
     *
     * @param {object} scenario
     * @param {{time: number, motion: object, within: number}[]} [told] what its plate will be told, in the order of times
     */
    start(scenario, told3 = []) {
      const run = ++this.run;
      this.scenario = scenario;
      this.plan = told3;
      this.script = [...told3];
      this.order(async () => {
        if (run !== this.run) return;
        this.frames = new Frames();
        this.samples = new Samples();
        this.clock = 0;
        this.ended = "";
        this.pending = false;
        await this.worker.ask({ ask: "open", key: this.key, scenario });
        if (run === this.run) await this.advance(1e-9, 1);
      });
    }
    /** Let the sheet be told of a change where it is; laid down anew only where it cannot be. */
    become(scenario) {
      const way = wayTo(this.scenario, scenario);
      if (way === "anew" || this.ended) return this.start(scenario);
      this.scenario = scenario;
      this.plan = [];
      this.script = [];
      if (way === "motion")
        this.order(() => this.worker.ask({ ask: "change", key: this.key, motion: scenario.motion, ramp: scenario.motion.ramp }));
      if (way === "become") this.order(() => this.worker.ask({ ask: "become", key: this.key, scenario }));
      return void 0;
    }
    /** A kick: node velocities added to, m/s. */
    push(kick) {
      this.toTheEnd();
      this.order(() => this.worker.ask({ ask: "push", key: this.key, ...kick }));
    }
    /** One thing after the other; what the worker refuses is said and loses nothing. */
    order(work) {
      this.queue = this.queue.then(work).catch((error) => {
        this.pending = false;
        if (error.anew) this.start(this.scenario);
        else this.told.refused(error.message ?? String(error));
      });
      return this.queue;
    }
    /** Tell the plate what it is to be told by now; how long it is until it is told more, s. */
    async prompted() {
      const now = this.frames.last?.time ?? 0;
      while (this.script.length && this.script[0].time <= now + 1e-6) {
        const { motion, within } = this.script.shift();
        await this.worker.ask({ ask: "change", key: this.key, motion, ramp: within });
      }
      return this.script.length ? this.script[0].time - now : Infinity;
    }
    async advance(wanted, frames) {
      const run = this.run;
      this.pending = true;
      const seconds = Math.min(wanted, await this.prompted());
      const began = performance.now();
      const reply = await this.worker.ask({ ask: "advance", key: this.key, seconds, frames });
      this.pending = false;
      if (run !== this.run) return;
      const wall = (reply.wall ?? performance.now() - began) / 1e3;
      const gone = reply.seconds ?? seconds;
      if (gone > 1e-6 && wall > 0) this.capacity = smoothed(this.capacity, gone / wall);
      this.samples.add(reply.samples);
      this.frames.add(reply.frames.filter((frame) => finite(frame.nodes)));
      if (reply.diverged || reply.frames.some((frame) => !finite(frame.nodes))) this.ended = "diverged";
      this.told.changed();
    }
    /** The pace that is possible, simulated seconds per second. */
    get possible() {
      return Math.min(this.speed, 0.85 * this.capacity);
    }
    /** Go on by what a picture takes; the frame to show. */
    tick(wall) {
      if (!this.frames.last) return null;
      if (this.playing) {
        this.clock = Math.min(this.clock + this.possible * Math.min(wall, 0.1), this.frames.last.time);
        const ready = this.frames.last.time - this.clock;
        if (!this.pending && !this.ended && ready < this.possible * AHEAD) {
          const chunk = Math.max(LEAST_CHUNK, LONGEST_CHUNK * this.capacity);
          const seconds = Math.max(1e-5, Math.min(this.speed * AHEAD, chunk));
          this.pending = true;
          this.order(() => this.advance(seconds, Math.max(1, Math.round(seconds * this.framesPerSecond))));
        }
      }
      this.measurePace();
      return this.frame;
    }
    /** Frames of a simulated second: those that are shown, and for few nodes more, to scrub through. */
    get framesPerSecond() {
      const few = (this.frames.last?.nodes.length ?? 0) <= 3 * FEW_NODES;
      if (!few) return MANY_NODES_PICTURES / this.possible;
      return Math.max(PICTURES / this.possible, A_PERIOD * this.scenario.motion.frequency);
    }
    get frame() {
      return this.frames.list[this.frames.indexAt(this.clock)] ?? null;
    }
    /** What pace was reached, over a second. */
    measurePace() {
      const now = performance.now();
      if (now - this.pace.wall > 1e3) {
        this.pace = { wall: now, from: this.clock, speed: Math.max(0, this.clock - this.pace.from) / ((now - this.pace.wall) / 1e3) };
      }
    }
    /** A picture forward or back; at the end the sheet goes on by one sample of its plate's period. */
    step(by) {
      this.playing = false;
      const index = this.frames.indexAt(this.clock) + by;
      if (index < 0) return;
      if (index < this.frames.list.length) {
        this.clock = this.frames.list[index].time;
        this.told.changed();
      } else if (!this.pending && !this.ended) {
        this.order(async () => {
          await this.advance(1 / (24 * this.scenario.motion.frequency), 1);
          this.clock = this.frames.last?.time ?? 0;
          this.told.changed();
        });
      }
    }
    seek(time) {
      this.playing = false;
      this.clock = Math.min(Math.max(time, this.frames.first?.time ?? 0), this.frames.last?.time ?? 0);
      this.told.changed();
    }
    toTheEnd() {
      this.clock = this.frames.last?.time ?? 0;
    }
    close() {
      this.run++;
      this.order(() => this.worker.ask({ ask: "close", key: this.key }));
      this.worker.close();
    }
  };
  var smoothed = (before, now) => Number.isFinite(before) ? 0.7 * before + 0.3 * now : now;
  function finite(values) {
    for (let k = 0; k < values.length; k += 3) if (!Number.isFinite(values[k])) return false;
    return true;
  }

  // src/engine/pool.js
  var PATIENCE = 300;
  var failed = (message, name = "Error") => Object.assign(new Error(message), { name });
  var Asked = class {
    /** @param {() => Worker} makeWorker */
    constructor(makeWorker) {
      this.waiting = /* @__PURE__ */ new Map();
      this.last = 0;
      this.ended = null;
      this.worker = makeWorker();
      this.worker.onmessage = ({ data }) => this.#hear(data);
      this.worker.onerror = (event) => {
        event.preventDefault?.();
        this.#end(failed("the engine's worker stopped"));
      };
      this.worker.onmessageerror = () => this.#end(failed("what the engine's worker said cannot be read"));
    }
    get busy() {
      return this.waiting.size > 0;
    }
    /**
     * @param {object} message
     * @param {(fraction: number) => void} [onProgress]
     * @returns {Promise<any>}
     */
    ask(message, onProgress) {
      if (this.ended) return Promise.reject(this.ended);
      const id = ++this.last;
      return new Promise((resolve, reject) => {
        this.waiting.set(id, { resolve, reject, onProgress });
        try {
          this.worker.postMessage({ id, ...message });
        } catch (error) {
          this.waiting.delete(id);
          reject(error);
        }
      });
    }
    #hear(data) {
      const { id, told: told3, fraction, refused } = data;
      if (id === null) return this.#end(Object.assign(failed(refused.message), refused));
      const asked = this.waiting.get(id);
      if (!asked) return void 0;
      if (told3 === "progress") return asked.onProgress?.(fraction);
      this.waiting.delete(id);
      return refused ? asked.reject(Object.assign(failed(refused.message), refused)) : asked.resolve(data);
    }
    #end(error) {
      this.ended ??= error;
      for (const { reject } of this.waiting.values()) reject(error);
      this.waiting.clear();
      this.worker.terminate();
    }
    close() {
      this.#end(failed("closed"));
    }
  };
  var openLive = (makeWorker) => new Asked(makeWorker);
  var Pool = class {
    /** @param {() => Worker} makeWorker @param {number} size workers at most; each is made when it is first needed */
    constructor(makeWorker, size) {
      Object.assign(this, { makeWorker, size, workers: [], queue: [] });
    }
    /**
     * Ask whichever worker is free; first asked, first begun.
     *
     * @param {object} message
     * @param {{signal?: AbortSignal, onProgress?: (fraction: number) => void}} [how]
     * @returns {Promise<any>}
     */
    ask(message, { signal, onProgress } = {}) {
      return new Promise((resolve, reject) => {
        if (signal?.aborted) return reject(failed("stopped", "AbortError"));
        const job = { message, onProgress, resolve, reject, worker: null };
        job.stop = () => this.#stop(job);
        job.forget = () => signal?.removeEventListener("abort", job.stop);
        signal?.addEventListener("abort", job.stop);
        this.queue.push(job);
        return this.#next();
      });
    }
    #stop(job) {
      job.forget();
      this.queue = this.queue.filter((other) => other !== job);
      job.reject(failed("stopped", "AbortError"));
      const { worker } = job;
      if (!worker) return;
      const patience = setTimeout(() => worker.close(), PATIENCE);
      worker.doing.finally(() => clearTimeout(patience));
    }
    #next() {
      this.workers = this.workers.filter(({ ended }) => !ended);
      while (this.queue.length) {
        let free = this.workers.find((worker) => !worker.busy);
        if (!free && this.workers.length < this.size) this.workers.push(free = new Asked(this.makeWorker));
        if (!free) return;
        this.#begin(this.queue.shift(), free);
      }
    }
    #begin(job, worker) {
      job.worker = worker;
      worker.doing = worker.ask(job.message, job.onProgress).then(job.resolve, job.reject).finally(() => {
        job.forget();
        this.#next();
      });
    }
    close() {
      const left = this.queue;
      this.queue = [];
      for (const { reject } of left) reject(failed("closed"));
      for (const worker of this.workers) worker.close();
      this.workers = [];
    }
  };

  // src/app/desk.js
  var MOST_SHEETS = 2;
  var Desk = class {
    /**
     * @param {{facts: object, payload: object, pool: object, makeWorker: () => Worker}} given
     */
    constructor({ facts, payload, pool, makeWorker }) {
      Object.assign(this, { facts, payload, pool, makeWorker });
      this.seats = [];
      this.selected = 0;
      this.speed = 1;
      this.playing = true;
      this.listeners = {};
      this.before = [];
    }
    on(event, listener) {
      (this.listeners[event] ??= []).push(listener);
    }
    tell(event, ...what) {
      for (const listener of this.listeners[event] ?? []) listener(...what);
    }
    /** Scenario that the controls are about. */
    scenario() {
      return this.seats[this.selected].scenario;
    }
    lives() {
      return this.seats.map((seat) => seat.live);
    }
    /** One sheet more, beside those there are. */
    add(scenario) {
      if (this.seats.length >= MOST_SHEETS) return;
      const key = `sheet ${this.seats.length}`;
      const live = new Live(openLive(this.makeWorker), key, {
        changed: () => this.tell("frame"),
        refused: (message) => this.tell("notice", message)
      });
      live.start(scenario);
      this.sit(live, scenario);
    }
    /** A sheet that moves by itself, on the last seat: in the place of the second where there are two. */
    sit(live, scenario) {
      if (this.seats.length >= MOST_SHEETS) this.drop();
      live.speed = this.speed;
      live.playing = this.playing;
      this.seats.push({ live, scenario });
      this.tell("seats");
      this.tell("change");
    }
    /** Take the second sheet away. */
    drop() {
      if (this.seats.length < 2) return;
      this.seats.pop().live.close();
      this.selected = 0;
      this.tell("seats");
      this.tell("change");
    }
    select(index) {
      if (index === this.selected || index >= this.seats.length) return;
      this.selected = index;
      this.tell("select");
      this.tell("change");
    }
    /** Change one value; why it cannot be in one line, or null. */
    change(name, value) {
      try {
        this.put(withValue(this.scenario(), name, value));
        return null;
      } catch (error) {
        return `${error.field ? `${error.field}: ` : ""}${error.message}`;
      }
    }
    naturalFrequency() {
      try {
        return naturalFrequency(this.scenario().sheet);
      } catch {
        return NaN;
      }
    }
    /** Another scenario for the selected sheet, kept to be undone. Throws where it cannot be. */
    put(scenario) {
      checkScenario(scenario);
      const seat = this.seats[this.selected];
      if (this.before.at(-1)?.[1] !== seat.scenario) this.before.push([this.selected, seat.scenario]);
      if (this.before.length > 100) this.before.shift();
      seat.scenario = scenario;
      seat.live.become(scenario);
      this.tell("change");
    }
    /** Another scenario, laid down anew, and what its plate will be told; what is wrong with it is said. */
    set(scenario, told3 = []) {
      try {
        checkScenario(scenario);
      } catch (error) {
        this.tell("notice", `${error.field ? `${error.field}: ` : ""}${error.message}`);
        return false;
      }
      const seat = this.seats[this.selected];
      this.before.push([this.selected, seat.scenario]);
      seat.scenario = scenario;
      seat.live.start(scenario, told3);
      this.play(true);
      this.tell("change");
      return true;
    }
    /** Show a motion that somebody pointed at. */
    watch(scenario) {
      if (this.set(scenario)) this.tell("watch");
    }
    undo() {
      const [index, scenario] = this.before.pop() ?? [];
      if (scenario === void 0 || index >= this.seats.length) return;
      this.seats[index].scenario = scenario;
      this.seats[index].live.become(scenario);
      this.tell("change");
    }
    play(playing) {
      this.playing = playing;
      for (const live of this.lives()) live.playing = playing;
      this.tell("frame");
    }
    setSpeed(speed) {
      this.speed = speed;
      for (const live of this.lives()) live.speed = speed;
      this.tell("frame");
    }
    step(by) {
      this.playing = false;
      for (const live of this.lives()) live.step(by);
      this.tell("frame");
    }
    /** To a share of what is kept of the sheets' time. */
    seek(share2) {
      this.playing = false;
      for (const live of this.lives()) {
        const { first, last: last2 } = live.frames;
        if (first && last2) live.seek(first.time + share2 * (last2.time - first.time));
      }
      this.tell("frame");
    }
    restart() {
      for (const { live, scenario } of this.seats) live.start(scenario, live.plan);
      this.play(true);
    }
    push(index, kick) {
      this.seats[index].live.push(kick);
      this.play(true);
    }
  };

  // node_modules/smol-toml/dist/error.js
  function getLineColFromPtr(string, ptr) {
    let lines = string.slice(0, ptr).split(/\r\n|\n|\r/g);
    return [lines.length, lines.pop().length + 1];
  }
  function makeCodeBlock(string, line, column) {
    let lines = string.split(/\r\n|\n|\r/g);
    let codeblock = "";
    let numberLen = (Math.log10(line + 1) | 0) + 1;
    for (let i = line - 1; i <= line + 1; i++) {
      let l = lines[i - 1];
      if (!l)
        continue;
      codeblock += i.toString().padEnd(numberLen, " ");
      codeblock += ":  ";
      codeblock += l;
      codeblock += "\n";
      if (i === line) {
        codeblock += " ".repeat(numberLen + column + 2);
        codeblock += "^\n";
      }
    }
    return codeblock;
  }
  var TomlError = class extends Error {
    line;
    column;
    codeblock;
    constructor(message, options) {
      const [line, column] = getLineColFromPtr(options.toml, options.ptr);
      const codeblock = makeCodeBlock(options.toml, line, column);
      super(`Invalid TOML document: ${message}

${codeblock}`, options);
      this.line = line;
      this.column = column;
      this.codeblock = codeblock;
    }
  };

  // node_modules/smol-toml/dist/util.js
  function isEscaped(str, ptr) {
    let i = 0;
    while (str[ptr - ++i] === "\\")
      ;
    return --i && i % 2;
  }
  function indexOfNewline(str, start = 0, end = str.length) {
    let idx = str.indexOf("\n", start);
    if (str[idx - 1] === "\r")
      idx--;
    return idx <= end ? idx : -1;
  }
  function skipComment(str, ptr) {
    for (let i = ptr; i < str.length; i++) {
      let c = str[i];
      if (c === "\n")
        return i;
      if (c === "\r" && str[i + 1] === "\n")
        return i + 1;
      if (c < " " && c !== "	" || c === "") {
        throw new TomlError("control characters are not allowed in comments", {
          toml: str,
          ptr
        });
      }
    }
    return str.length;
  }
  function skipVoid(str, ptr, banNewLines, banComments) {
    let c;
    while ((c = str[ptr]) === " " || c === "	" || !banNewLines && (c === "\n" || c === "\r" && str[ptr + 1] === "\n"))
      ptr++;
    return banComments || c !== "#" ? ptr : skipVoid(str, skipComment(str, ptr), banNewLines);
  }
  function skipUntil(str, ptr, sep, end, banNewLines = false) {
    if (!end) {
      ptr = indexOfNewline(str, ptr);
      return ptr < 0 ? str.length : ptr;
    }
    for (let i = ptr; i < str.length; i++) {
      let c = str[i];
      if (c === "#") {
        i = indexOfNewline(str, i);
      } else if (c === sep) {
        return i + 1;
      } else if (c === end || banNewLines && (c === "\n" || c === "\r" && str[i + 1] === "\n")) {
        return i;
      }
    }
    throw new TomlError("cannot find end of structure", {
      toml: str,
      ptr
    });
  }
  function getStringEnd(str, seek) {
    let first = str[seek];
    let target = first === str[seek + 1] && str[seek + 1] === str[seek + 2] ? str.slice(seek, seek + 3) : first;
    seek += target.length - 1;
    do
      seek = str.indexOf(target, ++seek);
    while (seek > -1 && first !== "'" && isEscaped(str, seek));
    if (seek > -1) {
      seek += target.length;
      if (target.length > 1) {
        if (str[seek] === first)
          seek++;
        if (str[seek] === first)
          seek++;
      }
    }
    return seek;
  }

  // node_modules/smol-toml/dist/date.js
  var DATE_TIME_RE = /^(\d{4}-\d{2}-\d{2})?[T ]?(?:(\d{2}):\d{2}:\d{2}(?:\.\d+)?)?(Z|[-+]\d{2}:\d{2})?$/i;
  var TomlDate = class _TomlDate extends Date {
    #hasDate = false;
    #hasTime = false;
    #offset = null;
    constructor(date) {
      let hasDate = true;
      let hasTime = true;
      let offset = "Z";
      if (typeof date === "string") {
        let match = date.match(DATE_TIME_RE);
        if (match) {
          if (!match[1]) {
            hasDate = false;
            date = `0000-01-01T${date}`;
          }
          hasTime = !!match[2];
          hasTime && date[10] === " " && (date = date.replace(" ", "T"));
          if (match[2] && +match[2] > 23) {
            date = "";
          } else {
            offset = match[3] || null;
            date = date.toUpperCase();
            if (!offset && hasTime)
              date += "Z";
          }
        } else {
          date = "";
        }
      }
      super(date);
      if (!isNaN(this.getTime())) {
        this.#hasDate = hasDate;
        this.#hasTime = hasTime;
        this.#offset = offset;
      }
    }
    isDateTime() {
      return this.#hasDate && this.#hasTime;
    }
    isLocal() {
      return !this.#hasDate || !this.#hasTime || !this.#offset;
    }
    isDate() {
      return this.#hasDate && !this.#hasTime;
    }
    isTime() {
      return this.#hasTime && !this.#hasDate;
    }
    isValid() {
      return this.#hasDate || this.#hasTime;
    }
    toISOString() {
      let iso = super.toISOString();
      if (this.isDate())
        return iso.slice(0, 10);
      if (this.isTime())
        return iso.slice(11, 23);
      if (this.#offset === null)
        return iso.slice(0, -1);
      if (this.#offset === "Z")
        return iso;
      let offset = +this.#offset.slice(1, 3) * 60 + +this.#offset.slice(4, 6);
      offset = this.#offset[0] === "-" ? offset : -offset;
      let offsetDate = new Date(this.getTime() - offset * 6e4);
      return offsetDate.toISOString().slice(0, -1) + this.#offset;
    }
    static wrapAsOffsetDateTime(jsDate, offset = "Z") {
      let date = new _TomlDate(jsDate);
      date.#offset = offset;
      return date;
    }
    static wrapAsLocalDateTime(jsDate) {
      let date = new _TomlDate(jsDate);
      date.#offset = null;
      return date;
    }
    static wrapAsLocalDate(jsDate) {
      let date = new _TomlDate(jsDate);
      date.#hasTime = false;
      date.#offset = null;
      return date;
    }
    static wrapAsLocalTime(jsDate) {
      let date = new _TomlDate(jsDate);
      date.#hasDate = false;
      date.#offset = null;
      return date;
    }
  };

  // node_modules/smol-toml/dist/primitive.js
  var INT_REGEX = /^((0x[0-9a-fA-F](_?[0-9a-fA-F])*)|(([+-]|0[ob])?\d(_?\d)*))$/;
  var FLOAT_REGEX = /^[+-]?\d(_?\d)*(\.\d(_?\d)*)?([eE][+-]?\d(_?\d)*)?$/;
  var LEADING_ZERO = /^[+-]?0[0-9_]/;
  var ESCAPE_REGEX = /^[0-9a-f]{4,8}$/i;
  var ESC_MAP = {
    b: "\b",
    t: "	",
    n: "\n",
    f: "\f",
    r: "\r",
    '"': '"',
    "\\": "\\"
  };
  function parseString(str, ptr = 0, endPtr = str.length) {
    let isLiteral = str[ptr] === "'";
    let isMultiline = str[ptr++] === str[ptr] && str[ptr] === str[ptr + 1];
    if (isMultiline) {
      endPtr -= 2;
      if (str[ptr += 2] === "\r")
        ptr++;
      if (str[ptr] === "\n")
        ptr++;
    }
    let tmp = 0;
    let isEscape;
    let parsed2 = "";
    let sliceStart = ptr;
    while (ptr < endPtr - 1) {
      let c = str[ptr++];
      if (c === "\n" || c === "\r" && str[ptr] === "\n") {
        if (!isMultiline) {
          throw new TomlError("newlines are not allowed in strings", {
            toml: str,
            ptr: ptr - 1
          });
        }
      } else if (c < " " && c !== "	" || c === "") {
        throw new TomlError("control characters are not allowed in strings", {
          toml: str,
          ptr: ptr - 1
        });
      }
      if (isEscape) {
        isEscape = false;
        if (c === "u" || c === "U") {
          let code = str.slice(ptr, ptr += c === "u" ? 4 : 8);
          if (!ESCAPE_REGEX.test(code)) {
            throw new TomlError("invalid unicode escape", {
              toml: str,
              ptr: tmp
            });
          }
          try {
            parsed2 += String.fromCodePoint(parseInt(code, 16));
          } catch {
            throw new TomlError("invalid unicode escape", {
              toml: str,
              ptr: tmp
            });
          }
        } else if (isMultiline && (c === "\n" || c === " " || c === "	" || c === "\r")) {
          ptr = skipVoid(str, ptr - 1, true);
          if (str[ptr] !== "\n" && str[ptr] !== "\r") {
            throw new TomlError("invalid escape: only line-ending whitespace may be escaped", {
              toml: str,
              ptr: tmp
            });
          }
          ptr = skipVoid(str, ptr);
        } else if (c in ESC_MAP) {
          parsed2 += ESC_MAP[c];
        } else {
          throw new TomlError("unrecognized escape sequence", {
            toml: str,
            ptr: tmp
          });
        }
        sliceStart = ptr;
      } else if (!isLiteral && c === "\\") {
        tmp = ptr - 1;
        isEscape = true;
        parsed2 += str.slice(sliceStart, tmp);
      }
    }
    return parsed2 + str.slice(sliceStart, endPtr - 1);
  }
  function parseValue(value, toml, ptr, integersAsBigInt) {
    if (value === "true")
      return true;
    if (value === "false")
      return false;
    if (value === "-inf")
      return -Infinity;
    if (value === "inf" || value === "+inf")
      return Infinity;
    if (value === "nan" || value === "+nan" || value === "-nan")
      return NaN;
    if (value === "-0")
      return integersAsBigInt ? 0n : 0;
    let isInt = INT_REGEX.test(value);
    if (isInt || FLOAT_REGEX.test(value)) {
      if (LEADING_ZERO.test(value)) {
        throw new TomlError("leading zeroes are not allowed", {
          toml,
          ptr
        });
      }
      value = value.replace(/_/g, "");
      let numeric = +value;
      if (isNaN(numeric)) {
        throw new TomlError("invalid number", {
          toml,
          ptr
        });
      }
      if (isInt) {
        if ((isInt = !Number.isSafeInteger(numeric)) && !integersAsBigInt) {
          throw new TomlError("integer value cannot be represented losslessly", {
            toml,
            ptr
          });
        }
        if (isInt || integersAsBigInt === true)
          numeric = BigInt(value);
      }
      return numeric;
    }
    const date = new TomlDate(value);
    if (!date.isValid()) {
      throw new TomlError("invalid value", {
        toml,
        ptr
      });
    }
    return date;
  }

  // node_modules/smol-toml/dist/extract.js
  function sliceAndTrimEndOf(str, startPtr, endPtr, allowNewLines) {
    let value = str.slice(startPtr, endPtr);
    let commentIdx = value.indexOf("#");
    if (commentIdx > -1) {
      skipComment(str, commentIdx);
      value = value.slice(0, commentIdx);
    }
    let trimmed2 = value.trimEnd();
    if (!allowNewLines) {
      let newlineIdx = value.indexOf("\n", trimmed2.length);
      if (newlineIdx > -1) {
        throw new TomlError("newlines are not allowed in inline tables", {
          toml: str,
          ptr: startPtr + newlineIdx
        });
      }
    }
    return [trimmed2, commentIdx];
  }
  function extractValue(str, ptr, end, depth, integersAsBigInt) {
    if (depth === 0) {
      throw new TomlError("document contains excessively nested structures. aborting.", {
        toml: str,
        ptr
      });
    }
    let c = str[ptr];
    if (c === "[" || c === "{") {
      let [value, endPtr2] = c === "[" ? parseArray(str, ptr, depth, integersAsBigInt) : parseInlineTable(str, ptr, depth, integersAsBigInt);
      let newPtr = end ? skipUntil(str, endPtr2, ",", end) : endPtr2;
      if (endPtr2 - newPtr && end === "}") {
        let nextNewLine = indexOfNewline(str, endPtr2, newPtr);
        if (nextNewLine > -1) {
          throw new TomlError("newlines are not allowed in inline tables", {
            toml: str,
            ptr: nextNewLine
          });
        }
      }
      return [value, newPtr];
    }
    let endPtr;
    if (c === '"' || c === "'") {
      endPtr = getStringEnd(str, ptr);
      let parsed2 = parseString(str, ptr, endPtr);
      if (end) {
        endPtr = skipVoid(str, endPtr, end !== "]");
        if (str[endPtr] && str[endPtr] !== "," && str[endPtr] !== end && str[endPtr] !== "\n" && str[endPtr] !== "\r") {
          throw new TomlError("unexpected character encountered", {
            toml: str,
            ptr: endPtr
          });
        }
        endPtr += +(str[endPtr] === ",");
      }
      return [parsed2, endPtr];
    }
    endPtr = skipUntil(str, ptr, ",", end);
    let slice = sliceAndTrimEndOf(str, ptr, endPtr - +(str[endPtr - 1] === ","), end === "]");
    if (!slice[0]) {
      throw new TomlError("incomplete key-value declaration: no value specified", {
        toml: str,
        ptr
      });
    }
    if (end && slice[1] > -1) {
      endPtr = skipVoid(str, ptr + slice[1]);
      endPtr += +(str[endPtr] === ",");
    }
    return [
      parseValue(slice[0], str, ptr, integersAsBigInt),
      endPtr
    ];
  }

  // node_modules/smol-toml/dist/struct.js
  var KEY_PART_RE = /^[a-zA-Z0-9-_]+[ \t]*$/;
  function parseKey(str, ptr, end = "=") {
    let dot3 = ptr - 1;
    let parsed2 = [];
    let endPtr = str.indexOf(end, ptr);
    if (endPtr < 0) {
      throw new TomlError("incomplete key-value: cannot find end of key", {
        toml: str,
        ptr
      });
    }
    do {
      let c = str[ptr = ++dot3];
      if (c !== " " && c !== "	") {
        if (c === '"' || c === "'") {
          if (c === str[ptr + 1] && c === str[ptr + 2]) {
            throw new TomlError("multiline strings are not allowed in keys", {
              toml: str,
              ptr
            });
          }
          let eos = getStringEnd(str, ptr);
          if (eos < 0) {
            throw new TomlError("unfinished string encountered", {
              toml: str,
              ptr
            });
          }
          dot3 = str.indexOf(".", eos);
          let strEnd = str.slice(eos, dot3 < 0 || dot3 > endPtr ? endPtr : dot3);
          let newLine = indexOfNewline(strEnd);
          if (newLine > -1) {
            throw new TomlError("newlines are not allowed in keys", {
              toml: str,
              ptr: ptr + dot3 + newLine
            });
          }
          if (strEnd.trimStart()) {
            throw new TomlError("found extra tokens after the string part", {
              toml: str,
              ptr: eos
            });
          }
          if (endPtr < eos) {
            endPtr = str.indexOf(end, eos);
            if (endPtr < 0) {
              throw new TomlError("incomplete key-value: cannot find end of key", {
                toml: str,
                ptr
              });
            }
          }
          parsed2.push(parseString(str, ptr, eos));
        } else {
          dot3 = str.indexOf(".", ptr);
          let part = str.slice(ptr, dot3 < 0 || dot3 > endPtr ? endPtr : dot3);
          if (!KEY_PART_RE.test(part)) {
            throw new TomlError("only letter, numbers, dashes and underscores are allowed in keys", {
              toml: str,
              ptr
            });
          }
          parsed2.push(part.trimEnd());
        }
      }
    } while (dot3 + 1 && dot3 < endPtr);
    return [parsed2, skipVoid(str, endPtr + 1, true, true)];
  }
  function parseInlineTable(str, ptr, depth, integersAsBigInt) {
    let res = {};
    let seen = /* @__PURE__ */ new Set();
    let c;
    let comma = 0;
    ptr++;
    while ((c = str[ptr++]) !== "}" && c) {
      let err = { toml: str, ptr: ptr - 1 };
      if (c === "\n") {
        throw new TomlError("newlines are not allowed in inline tables", err);
      } else if (c === "#") {
        throw new TomlError("inline tables cannot contain comments", err);
      } else if (c === ",") {
        throw new TomlError("expected key-value, found comma", err);
      } else if (c !== " " && c !== "	") {
        let k;
        let t = res;
        let hasOwn = false;
        let [key, keyEndPtr] = parseKey(str, ptr - 1);
        for (let i = 0; i < key.length; i++) {
          if (i)
            t = hasOwn ? t[k] : t[k] = {};
          k = key[i];
          if ((hasOwn = Object.hasOwn(t, k)) && (typeof t[k] !== "object" || seen.has(t[k]))) {
            throw new TomlError("trying to redefine an already defined value", {
              toml: str,
              ptr
            });
          }
          if (!hasOwn && k === "__proto__") {
            Object.defineProperty(t, k, { enumerable: true, configurable: true, writable: true });
          }
        }
        if (hasOwn) {
          throw new TomlError("trying to redefine an already defined value", {
            toml: str,
            ptr
          });
        }
        let [value, valueEndPtr] = extractValue(str, keyEndPtr, "}", depth - 1, integersAsBigInt);
        seen.add(value);
        t[k] = value;
        ptr = valueEndPtr;
        comma = str[ptr - 1] === "," ? ptr - 1 : 0;
      }
    }
    if (comma) {
      throw new TomlError("trailing commas are not allowed in inline tables", {
        toml: str,
        ptr: comma
      });
    }
    if (!c) {
      throw new TomlError("unfinished table encountered", {
        toml: str,
        ptr
      });
    }
    return [res, ptr];
  }
  function parseArray(str, ptr, depth, integersAsBigInt) {
    let res = [];
    let c;
    ptr++;
    while ((c = str[ptr++]) !== "]" && c) {
      if (c === ",") {
        throw new TomlError("expected value, found comma", {
          toml: str,
          ptr: ptr - 1
        });
      } else if (c === "#")
        ptr = skipComment(str, ptr);
      else if (c !== " " && c !== "	" && c !== "\n" && c !== "\r") {
        let e = extractValue(str, ptr - 1, "]", depth - 1, integersAsBigInt);
        res.push(e[0]);
        ptr = e[1];
      }
    }
    if (!c) {
      throw new TomlError("unfinished array encountered", {
        toml: str,
        ptr
      });
    }
    return [res, ptr];
  }

  // node_modules/smol-toml/dist/parse.js
  function peekTable(key, table2, meta, type) {
    let t = table2;
    let m = meta;
    let k;
    let hasOwn = false;
    let state;
    for (let i = 0; i < key.length; i++) {
      if (i) {
        t = hasOwn ? t[k] : t[k] = {};
        m = (state = m[k]).c;
        if (type === 0 && (state.t === 1 || state.t === 2)) {
          return null;
        }
        if (state.t === 2) {
          let l = t.length - 1;
          t = t[l];
          m = m[l].c;
        }
      }
      k = key[i];
      if ((hasOwn = Object.hasOwn(t, k)) && m[k]?.t === 0 && m[k]?.d) {
        return null;
      }
      if (!hasOwn) {
        if (k === "__proto__") {
          Object.defineProperty(t, k, { enumerable: true, configurable: true, writable: true });
          Object.defineProperty(m, k, { enumerable: true, configurable: true, writable: true });
        }
        m[k] = {
          t: i < key.length - 1 && type === 2 ? 3 : type,
          d: false,
          i: 0,
          c: {}
        };
      }
    }
    state = m[k];
    if (state.t !== type && !(type === 1 && state.t === 3)) {
      return null;
    }
    if (type === 2) {
      if (!state.d) {
        state.d = true;
        t[k] = [];
      }
      t[k].push(t = {});
      state.c[state.i++] = state = { t: 1, d: false, i: 0, c: {} };
    }
    if (state.d) {
      return null;
    }
    state.d = true;
    if (type === 1) {
      t = hasOwn ? t[k] : t[k] = {};
    } else if (type === 0 && hasOwn) {
      return null;
    }
    return [k, t, state.c];
  }
  function parse(toml, { maxDepth = 1e3, integersAsBigInt } = {}) {
    let res = {};
    let meta = {};
    let tbl = res;
    let m = meta;
    for (let ptr = skipVoid(toml, 0); ptr < toml.length; ) {
      if (toml[ptr] === "[") {
        let isTableArray = toml[++ptr] === "[";
        let k = parseKey(toml, ptr += +isTableArray, "]");
        if (isTableArray) {
          if (toml[k[1] - 1] !== "]") {
            throw new TomlError("expected end of table declaration", {
              toml,
              ptr: k[1] - 1
            });
          }
          k[1]++;
        }
        let p = peekTable(
          k[0],
          res,
          meta,
          isTableArray ? 2 : 1
          /* Type.EXPLICIT */
        );
        if (!p) {
          throw new TomlError("trying to redefine an already defined table or value", {
            toml,
            ptr
          });
        }
        m = p[2];
        tbl = p[1];
        ptr = k[1];
      } else {
        let k = parseKey(toml, ptr);
        let p = peekTable(
          k[0],
          tbl,
          m,
          0
          /* Type.DOTTED */
        );
        if (!p) {
          throw new TomlError("trying to redefine an already defined table or value", {
            toml,
            ptr
          });
        }
        let v = extractValue(toml, k[1], void 0, maxDepth, integersAsBigInt);
        p[1][p[0]] = v[0];
        ptr = v[1];
      }
      ptr = skipVoid(toml, ptr, true);
      if (toml[ptr] && toml[ptr] !== "\n" && toml[ptr] !== "\r") {
        throw new TomlError("each key-value declaration must be followed by an end-of-line", {
          toml,
          ptr
        });
      }
      ptr = skipVoid(toml, ptr);
    }
    return res;
  }

  // src/app/toml.js
  function tomlOf(scenario, version) {
    const lines = [
      `# From the plategait lab ${version}. Bare numbers are SI; text with units works too.`,
      `# Run it: plategait simulate ${fileName(scenario)}`
    ];
    table(scenario, "", lines);
    return `${lines.join("\n").trim()}
`;
  }
  var fileName = (scenario) => `${(scenario.name || "scenario").replace(/[^\w.-]+/g, "-").slice(0, 60)}.toml`;
  function table(part, prefix, lines) {
    const nested = [];
    for (const [key, value] of Object.entries(part)) {
      if (value === null || value === void 0 || Array.isArray(value) && value.length === 0) continue;
      if (typeof value === "object" && !Array.isArray(value) && key !== "samples") nested.push([key, value]);
      else lines.push(`${key} = ${literal(value)}`);
    }
    for (const [key, value] of nested) {
      lines.push("", `[${prefix}${key}]`);
      table(value, `${prefix}${key}.`, lines);
    }
  }
  function literal(value) {
    if (typeof value === "number") return Number.isInteger(value) && Math.abs(value) < 1e15 ? `${value}.0` : String(value);
    if (typeof value === "boolean") return String(value);
    if (typeof value === "string") return JSON.stringify(value).replaceAll("", "\\u007F");
    if (Array.isArray(value)) return `[${value.map(literal).join(", ")}]`;
    const items = Object.entries(value).filter(([, item]) => item !== null && !(Array.isArray(item) && item.length === 0));
    return `{ ${items.map(([key, item]) => `${key} = ${literal(item)}`).join(", ")} }`;
  }
  function scenarioFrom(text, base, facts) {
    let data;
    try {
      data = parse(text);
    } catch (error) {
      throw new Error(`no TOML: ${String(error.message).split("\n")[0]}`);
    }
    if (!data.sheet || typeof data.sheet !== "object") throw new Error("no [sheet] in the file: it is no scenario");
    const fresh = {
      ...base,
      name: "scenario",
      start: { x: 0, y: 0, angle: 0 },
      plate: null,
      transient: null,
      time_step: null,
      motion: { ...base.motion, waves: [], samples: null, offset: { x: 0, y: 0, z: 0, rx: 0, ry: 0, rz: 0 }, height: 0 },
      sheet: { ...base.sheet, outline: {} }
    };
    return merged(fresh, data, "", facts);
  }
  function merged(base, data, prefix, facts) {
    const copy = { ...base };
    for (const [key, value] of Object.entries(data)) {
      const name = prefix + key;
      if (key === "image") throw new Error(`${name}: pictures stay outside the page: type plategait lab FILE.toml instead`);
      if (name === "motion.samples" && typeof value === "string")
        throw new Error(`${name}: a file beside the file; type plategait lab FILE.toml instead`);
      if (prefix !== "sheet.outline." && prefix !== "motion.samples." && !/waves/.test(prefix) && !Object.hasOwn(base ?? {}, key))
        throw new Error(`${name}: nothing known by that name`);
      const inner = value && typeof value === "object" && !Array.isArray(value);
      if (inner) copy[key] = merged(base?.[key] ?? (key === "plate" ? { length: 0.1, width: 0.1 } : {}), value, `${name}.`, facts);
      else copy[key] = key === "waves" && Array.isArray(value) ? value.map(wave(facts)) : si(value, name, facts);
    }
    return copy;
  }
  var wave = (facts) => (given2, i) => {
    if (typeof given2 !== "object" || given2 === null || Array.isArray(given2)) throw new Error(`motion.waves.${i}: no table of its fields`);
    const known = { axis: "z", amplitude: 0, ratio: 1, phase: 0 };
    return { ...known, ...Object.fromEntries(Object.entries(given2).map(([key, value]) => [key, si(value, key, facts)])) };
  };
  var WORDS = /* @__PURE__ */ new Set(["name", "shape", "law", "axis", "rows"]);
  function si(value, name, facts) {
    if (Array.isArray(value)) return value.map((item) => si(item, name, facts));
    if (typeof value === "bigint") return Number(value);
    if (typeof value !== "string" || WORDS.has(name.split(".").pop())) return value;
    const match = /^\s*([-+]?[\d.]+(?:e[-+]?\d+)?)\s*(.*?)\s*$/i.exec(value);
    const unit = match?.[2] ?? "";
    if (!match || unit && !Object.hasOwn(facts.units, unit)) throw new Error(`${name}: “${value.slice(0, 40)}” is no number with a unit known here`);
    return Number(match[1]) * (unit ? facts.units[unit][0] : 1);
  }

  // src/app/drop.js
  var LARGEST2 = 4e6;
  function files(desk, showPoses) {
    const input = make("input", {
      type: "file",
      accept: ".toml,.csv",
      hidden: true,
      "aria-label": "A scenario or poses",
      onchange: () => {
        if (input.files[0]) take(input.files[0]);
        input.value = "";
      }
    });
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
        if (file.size > LARGEST2) throw new Error(`${(file.size / 1e6).toFixed(0)} MB: at most 4 MB here`);
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
  function posesFrom(text) {
    const lines = text.split(/\r?\n/).filter((line) => line.trim() && !line.startsWith("#"));
    const names = (lines[0] ?? "").split(",").map((name) => name.trim());
    const column = (name) => names.indexOf(name);
    const wanted = ["time_s", "x_mm", "y_mm", "angle_deg"];
    const missing = wanted.filter((name) => column(name) < 0);
    if (missing.length) throw new Error(`no column ${missing.join(", ")}: poses have ${wanted.join(",")}`);
    if (lines.length > 1e5) throw new Error(`${lines.length} rows: at most 100,000`);
    const poses = { time: [], x: [], y: [], angle: [] };
    for (const line of lines.slice(1)) {
      const cells = line.split(",");
      const [time, x, y, angle] = wanted.map((name) => cells[column(name)]?.trim() ? Number(cells[column(name)]) : NaN);
      if (!Number.isFinite(time) || !Number.isFinite(x) || !Number.isFinite(y) || !Number.isFinite(angle)) continue;
      poses.time.push(time);
      poses.x.push(x / 1e3);
      poses.y.push(y / 1e3);
      poses.angle.push(angle * Math.PI / 180);
    }
    if (poses.time.length < 2) throw new Error("fewer than two poses in it");
    return poses;
  }

  // src/app/exhibits/series.js
  function wholeRows(given2, names) {
    const lists = names.map((name) => given2?.[name]);
    lists.forEach((list, k) => {
      if (!Array.isArray(list)) throw new Error(`no ${names[k]} in it`);
      if (list.length !== lists[0].length) throw new Error(`${names[k]} is not as long as ${names[0]}`);
    });
    const rows = [];
    let before = -Infinity;
    for (let k = 0; k < lists[0].length; k++) {
      const row2 = lists.map((list) => list[k]);
      if (!row2.every(Number.isFinite)) continue;
      if (names[0] === "time" && row2[0] < before) throw new Error("times that fall");
      before = row2[0];
      rows.push(row2);
    }
    return Object.fromEntries(names.map((name, column) => [name, rows.map((row2) => row2[column])]));
  }
  var isTable = (value) => value !== null && typeof value === "object" && !Array.isArray(value);

  // src/app/exhibits/object.js
  var DURATION2 = 2;
  var PICTURES2 = 30;
  var MOST_SHEETS2 = 24;
  var DEG3 = Math.PI / 180;
  function cloudOf(element2, desk, scenes) {
    const { payload } = desk;
    const samples = (Array.isArray(payload.samples) ? payload.samples : []).filter((sample) => isTable(sample?.set)).slice(0, MOST_SHEETS2);
    const table2 = make("table", {}, make("caption", {}, `From ${String(payload.source ?? "the file").slice(0, 80)}`), numbers(payload));
    const says = make("p", { role: "status" });
    const go = button("Show the cloud under this motion", () => begin2(), { disabled: samples.length === 0 });
    const away2 = button("Only the sheet", () => {
      cloud = null;
      scenes[0]?.view.setCloud([]);
    });
    element2.append(table2, make("p", {}, go, " ", away2), says);
    let cloud = null;
    async function begin2() {
      go.disabled = true;
      says.textContent = "computing…";
      try {
        const scenarios = samples.map(({ set }) => ({
          ...withValues(desk.seats[0].scenario, Object.fromEntries(Object.entries(set).filter(([name]) => !name.startsWith("motion.")))),
          duration: DURATION2,
          transient: 0.3 * DURATION2
        }));
        const { recordings } = await desk.pool.ask({ ask: "run", scenarios, snapshotInterval: 1 / PICTURES2 });
        const { observations } = await desk.pool.ask({ ask: "observe", scenarios, repeats: 1, seed: 0 });
        cloud = recordings;
        says.textContent = spreadOf(observations.map(([first]) => first));
        desk.restart();
      } catch (error) {
        says.textContent = `The cloud cannot be computed: ${error.message}`;
      }
      go.disabled = false;
    }
    desk.on("drawn", () => {
      if (!cloud) return;
      const now = desk.seats[0].live.clock % DURATION2;
      scenes[0]?.view.setCloud(cloud.map((recording) => frameAt(recording, now)).filter(Boolean));
    });
    desk.on("change", () => {
      if (cloud) says.textContent = "The sheet is under another motion now: show the cloud again.";
    });
  }
  function numbers(payload) {
    const known = (Array.isArray(payload.parameters) ? payload.parameters : []).filter((p) => isTable(p) && Number.isFinite(p.value));
    const rows = known.map(({ name, display, value, low, high, unit }) => {
      const factor = { "pi rad/s": Math.PI, deg: DEG3, mm: 1e-3, g: 1e-3 }[display] ?? 1;
      const cell3 = (number) => Number.isFinite(number) ? trimmed(number / factor, 3) : "–";
      return make(
        "tr",
        {},
        make("th", { scope: "row" }, String(name)),
        make("td", {}, cell3(value)),
        make("td", {}, `[${cell3(low)}, ${cell3(high)}]`),
        make("td", {}, String((factor === 1 ? unit : display) ?? ""))
      );
    });
    const head = make("tr", {}, ...["number", "value", "interval", "unit"].map((word) => make("th", { scope: "col" }, word)));
    return make("tbody", {}, head, ...rows);
  }
  function spreadOf(observations) {
    const rates = observations.filter((o) => !o.failure && Number.isFinite(o.spin.rate)).map((o) => o.spin.rate / DEG3);
    const failed2 = observations.filter((o) => o.failure).length;
    if (rates.length < 2) return `${failed2} of ${observations.length} sheets fail under this motion.`;
    const mean2 = rates.reduce((sum2, rate) => sum2 + rate, 0) / rates.length;
    const sd = Math.sqrt(rates.reduce((sum2, rate) => sum2 + (rate - mean2) ** 2, 0) / (rates.length - 1));
    return `${observations.length} sheets: ${mean2.toFixed(0)} ± ${sd.toFixed(0)} °/s${failed2 ? `, ${failed2} fail` : ""}.`;
  }
  function frameAt(recording, now) {
    const { snapshotTime, snapshots, platePose } = recording;
    const each = snapshots.length / snapshotTime.length;
    const k = Math.min(snapshotTime.length - 1, Math.round(now * PICTURES2));
    if (!(each > 0) || k < 0) return null;
    const pose = Array.isArray(platePose[k]) ? platePose[k] : Array.from(platePose.subarray(6 * k, 6 * k + 6));
    return { time: snapshotTime[k], nodes: snapshots.subarray(k * each, (k + 1) * each), pose };
  }

  // src/charts/colours.js
  var NAMES = ["paper", "panel", "ink", "muted", "line", "accent", "sliding", "walking", "running", "failed", "left", "right"];
  var colours = {};
  var listeners = /* @__PURE__ */ new Set();
  var watching = false;
  var read = () => {
    const style = getComputedStyle(document.documentElement);
    for (const name of NAMES) colours[name] = style.getPropertyValue(`--${name}`).trim() || "#777777";
  };
  var changed = () => {
    read();
    for (const listener of listeners) listener();
  };
  var onColours = (listener) => {
    if (!watching) {
      watching = true;
      read();
      matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
      new MutationObserver(changed).observe(document.documentElement, { attributeFilter: ["data-theme", "class"] });
    }
    listeners.add(listener);
    return () => listeners.delete(listener);
  };
  var CIVIDIS = [
    [0, 32, 76],
    [0, 48, 111],
    [42, 63, 109],
    [71, 79, 109],
    [93, 95, 111],
    [114, 111, 114],
    [135, 128, 120],
    [158, 146, 119],
    [181, 164, 111],
    [206, 183, 101],
    [231, 204, 84],
    [255, 234, 70]
  ];
  var scaleColour = (share2) => {
    const at2 = Math.min(Math.max(share2, 0), 1) * (CIVIDIS.length - 1);
    const below = Math.min(Math.floor(at2), CIVIDIS.length - 2);
    const part = CIVIDIS[below].map((low, i) => Math.round(low + (at2 - below) * (CIVIDIS[below + 1][i] - low)));
    return `rgb(${part.join(" ")})`;
  };
  var inkOn = (share2) => share2 > 0.55 ? "#10131a" : "#ffffff";

  // src/charts/plot.js
  var import_uplot = __toESM(require_uplot(), 1);
  var FONT = "12px system-ui, sans-serif";
  var axis = (label, given2 = {}) => ({
    label,
    font: FONT,
    labelFont: FONT,
    labelSize: label ? 18 : 0,
    size: 34,
    stroke: () => colours.muted,
    grid: { stroke: () => colours.line, width: 1 },
    ticks: { stroke: () => colours.line, width: 1, size: 5 },
    // Six digits: what is left of a step's rounding is not read, and large numbers stay short.
    values: (_, splits) => splits.map((value) => read2(value, 6)),
    ...given2
  });
  var leftAxis = (label, given2 = {}) => axis(label, { size: (_, values) => 16 + 7 * Math.max(2, ...(values ?? []).map((value) => String(value).length)), ...given2 });
  var roomy = (low, high, share2 = 0.06) => {
    if (!(low <= high)) return [0, 1];
    const room = share2 * (high - low) || 0.1 * Math.abs(high) || 1;
    return [low - room, high + room];
  };
  var plotIn = (el, options, data) => {
    el.classList.add("chart");
    const frame = el.appendChild(document.createElement("div"));
    frame.className = "chart-frame";
    frame.setAttribute("role", "img");
    frame.setAttribute("aria-label", "chart, empty so far");
    const size = () => ({ width: Math.max(el.clientWidth, 120), height: Math.max(el.clientHeight, 80) });
    let drawn = null;
    let waiting = data;
    let stale = false;
    const show = () => {
      stale = !el.clientWidth;
      if (stale) return;
      if (drawn) drawn.setData(waiting);
      else drawn = new import_uplot.default({ ...size(), legend: { show: false }, cursor: { show: false }, ...options }, waiting, frame);
    };
    const resize = () => {
      if (!el.clientWidth) return;
      if (!drawn || stale) show();
      const now = size();
      if (drawn.width !== now.width || drawn.height !== now.height) drawn.setSize(now);
    };
    const away2 = onColours(() => drawn?.redraw(false));
    const observer = new ResizeObserver(resize);
    observer.observe(el);
    show();
    return {
      frame,
      get plot() {
        return drawn;
      },
      update(next) {
        waiting = next;
        show();
      },
      describe(words) {
        if (frame.getAttribute("aria-label") !== words) frame.setAttribute("aria-label", words);
      },
      resize,
      destroy() {
        away2();
        observer.disconnect();
        drawn?.destroy();
        frame.remove();
      }
    };
  };
  var element = (tag, name = "", text = "") => {
    const made = document.createElement(tag);
    if (name) made.className = name;
    made.textContent = text;
    return made;
  };
  var read2 = (value, count = 3) => {
    if (!Number.isFinite(value)) return "–";
    const size = Math.abs(value);
    if (size !== 0 && (size < 1e-3 || size >= 1e6)) return value.toExponential(count - 1).replace(/\.?0+e/, "e");
    return String(Number(value.toPrecision(Math.max(count, Math.ceil(Math.log10(size + 1))))));
  };

  // src/charts/series.js
  var COLUMNS = 500;
  var USUAL = ["accent", "walking", "running", "failed", "muted"];
  var DASHES = [[], [6, 4], [2, 3], [8, 3, 2, 3], [1, 2]];
  var thinned = (time, values, columns = COLUMNS) => {
    const n = time.length;
    if (n <= 2 * columns) return Array.from({ length: n }, (_, i) => i);
    const kept2 = /* @__PURE__ */ new Set([0, n - 1]);
    for (let c = 0; c < columns; c++) {
      const [begin2, end] = [Math.floor(c * n / columns), Math.floor((c + 1) * n / columns)];
      for (const series of values) {
        let [least2, largest] = [begin2, begin2];
        for (let i = begin2; i < end; i++) {
          if (series[i] < series[least2]) least2 = i;
          if (series[i] > series[largest]) largest = i;
        }
        kept2.add(least2).add(largest);
      }
    }
    return [...kept2].sort((a, b) => a - b);
  };
  var nameOf = ({ colour }, i) => colour?.replace(/^--/, "") ?? USUAL[i % USUAL.length];
  var shown3 = (value) => Number.isFinite(value) ? value : null;
  var timeSeries = (el, { series, unit = "", label = "", zero = true, limit = null }) => {
    let bound = limit;
    const legend = series.length > 1 ? legendOf(el, series) : null;
    const colourOf = (i) => () => colours[nameOf(series[i], i)];
    const range = (_, low, high) => {
      const all = [low, high, ...zero ? [0] : [], ...bound ? [bound.value] : []].filter(Number.isFinite);
      return roomy(Math.min(...all), Math.max(...all));
    };
    const chart = plotIn(legend ? legend.below : el, {
      scales: { x: { time: false, range: (_, low, high) => low < high ? [low, high] : [low ?? 0, (low ?? 0) + 1] }, y: { range } },
      series: [{}, ...series.map((each, i) => ({
        label: each.label,
        stroke: colourOf(i),
        width: 1.5,
        dash: DASHES[i % DASHES.length],
        points: { show: false }
      }))],
      axes: [axis("time (s)"), leftAxis(unit ? `${label} (${unit})`.trim() : label)],
      hooks: { draw: [(u) => bound && drawLimit(u, bound)] }
    }, [[], ...series.map(() => [])]);
    const title = label || series.map((each) => each.label).join(", ");
    chart.describe(`${title} over time: nothing yet`);
    return {
      update({ time, values, limit: next }) {
        if (next !== void 0) bound = next;
        const kept2 = thinned(time, values);
        const lengths = series.map((_, s) => values[s]?.length ?? 0);
        chart.update([kept2.map((i) => time[i]), ...series.map((_, s) => kept2.map((i) => i < lengths[s] ? shown3(values[s][i]) : null))]);
        const last2 = values.map((each, s) => `${series[s].label} ${read2(each[each.length - 1])} ${unit}`.trim());
        const bounded = bound ? `; ${bound.label} ${read2(bound.value)} ${unit}` : "";
        chart.describe(`${title} over time, now at ${read2(time[time.length - 1] ?? NaN)} s: ${last2.join(", ")}${bounded}`);
      },
      resize: chart.resize,
      destroy() {
        chart.destroy();
        legend?.destroy();
      }
    };
  };
  var drawLimit = (u, { value, label }) => {
    const { ctx } = u;
    const y = u.valToPos(value, "y", true);
    const scale = devicePixelRatio || 1;
    ctx.save();
    ctx.strokeStyle = ctx.fillStyle = colours.failed;
    ctx.lineWidth = 1.2 * scale;
    ctx.setLineDash([4 * scale, 4 * scale]);
    ctx.beginPath();
    ctx.moveTo(u.bbox.left, y);
    ctx.lineTo(u.bbox.left + u.bbox.width, y);
    ctx.stroke();
    ctx.font = `${11 * scale}px system-ui, sans-serif`;
    ctx.textAlign = "left";
    ctx.textBaseline = "bottom";
    ctx.fillText(label, u.bbox.left + 4 * scale, y - 2 * scale);
    ctx.restore();
  };
  var legendOf = (el, series) => {
    const list = element("p", "chart-legend");
    series.forEach((each, i) => {
      const line = element("i", `line line-${i % DASHES.length}`);
      line.style.color = `var(--${nameOf(each, i)})`;
      const item = element("span");
      item.append(line, each.label);
      list.append(item);
    });
    const below = element("div", "chart-below");
    el.classList.add("chart-with-legend");
    el.append(list, below);
    return {
      below,
      destroy() {
        list.remove();
        below.remove();
      }
    };
  };

  // src/simulation/samples.js
  var interpolate = (x, time, values) => {
    const n = time.length;
    if (x <= time[0]) return values[0];
    if (x >= time[n - 1]) return values[n - 1];
    let low = 0;
    let high = n - 1;
    while (high - low > 1) {
      const middle = low + high >> 1;
      if (time[middle] <= x) low = middle;
      else high = middle;
    }
    if (x === time[low]) return values[low];
    return values[low] + (values[high] - values[low]) / (time[high] - time[low]) * (x - time[low]);
  };
  var unwrap = (angles) => {
    const out = Float64Array.from(angles);
    const turn = 2 * Math.PI;
    let added = 0;
    for (let i = 1; i < out.length; i++) {
      const step = angles[i] - angles[i - 1];
      if (!(Math.abs(step) < Math.PI)) {
        let wrapped = ((step + Math.PI) % turn + turn) % turn - Math.PI;
        if (wrapped === -Math.PI && step > 0) wrapped = Math.PI;
        added += wrapped - step;
      }
      out[i] = angles[i] + added;
    }
    return out;
  };
  var mean = (values) => values.reduce((sum2, value) => sum2 + value, 0) / values.length;
  var median = (values) => {
    if (!values.length) return NaN;
    const sorted2 = Float64Array.from(values).sort();
    const half = sorted2.length >> 1;
    return sorted2.length % 2 ? sorted2[half] : (sorted2[half - 1] + sorted2[half]) / 2;
  };
  var placeOfLargest = (values) => values.reduce((best, value, i) => value > values[best] ? i : best, 0);
  var student95 = (freedom) => freedom < STUDENT_95.length ? STUDENT_95[freedom] : 1.95996 + 2.37227 / freedom + 2.8225 / freedom ** 2;
  var STUDENT_95 = [Infinity, 12.7062, 4.30265, 3.18245, 2.77645, 2.57058, 2.44691, 2.36462];

  // src/app/exhibits/poses.js
  function posesBeside(element2, desk, scenes) {
    let poses = checked(desk.payload);
    const chart = make("figure", {}, make("figcaption", {}, "Angle of the tracked object and of the sheet, deg"));
    const canvas = make("div");
    chart.append(canvas);
    element2.append(
      make("p", {}, "The outline that the film shows is drawn beside the sheet, at the same time after the start."),
      button("Begin both again", () => desk.restart()),
      make("div", { class: "charts" }, chart)
    );
    const plot = timeSeries(canvas, { series: [{ label: "film" }, { label: "sheet" }], unit: "deg" });
    const show = (others) => {
      poses = checked(others);
      desk.restart();
      draw();
    };
    const draw = () => plot.update({ time: poses.time, values: [unwrap(poses.angle).map((value) => value / DEG4)] });
    desk.on("poses", show);
    desk.on("drawn", () => {
      const { live } = desk.seats[0];
      scenes[0]?.view.setGhost(poseAt(poses, poses.time[0] + live.clock % (poses.time.at(-1) - poses.time[0])));
    });
    return { shown: () => {
      plot.resize();
      draw();
    } };
  }
  function checked(given2) {
    const poses = wholeRows(given2, ["time", "x", "y", "angle"]);
    if (poses.time.length < 2 || !(poses.time.at(-1) > poses.time[0])) throw new Error("fewer than two poses in it");
    return poses;
  }
  var DEG4 = Math.PI / 180;
  function poseAt({ time, x, y, angle }, now) {
    let after = time.findIndex((each) => each > now);
    if (after < 0) after = time.length - 1;
    const before = Math.max(0, after - 1);
    const share2 = after === before ? 0 : (now - time[before]) / (time[after] - time[before]);
    const turn = angle[after] - angle[before];
    const least2 = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
    const between = (values) => values[before] + share2 * (values[after] - values[before]);
    return { x: between(x), y: between(y), angle: angle[before] + share2 * least2 };
  }

  // src/app/replay.js
  var NOBODY = { ask: async () => ({}), close: () => {
  } };
  var Replay = class extends Live {
    /**
     * @param {object} scenario that it was a run of
     * @param {import("./live.js").Frame[]} frames in the order of their times
     * @param {Record<string, ArrayLike<number>>} channels
     * @param {{changed: () => void, refused: (message: string) => void}} told
     */
    constructor(scenario, frames, channels, told3) {
      super(NOBODY, "replay", told3);
      this.scenario = scenario;
      this.frames = new Frames();
      this.frames.list = frames;
      this.samples = new Samples();
      this.samples.add(channels);
      this.ended = "recorded";
      this.clock = frames[0]?.time ?? 0;
      this.recorded = true;
    }
    start() {
      this.clock = this.frames.first?.time ?? 0;
      this.told.changed();
    }
    become() {
      this.told.refused("A recorded run cannot be changed: change the sheet beside it");
    }
    push() {
      this.told.refused("A recorded run cannot be kicked: kick the sheet beside it");
    }
    tick(wall) {
      const frame = super.tick(wall);
      if (this.playing && frame && frame === this.frames.last) this.clock = this.frames.first.time;
      return frame;
    }
  };

  // src/simulation/observables.js
  var GAITS = ["sliding", "walking", "running"];
  var FAILURES = ["slipped", "turned over", "folded", "left the plate", "diverged"];
  var SHORTEST_STRIDE = 0.01;
  var FOLDED_AREA = 0.5;
  var HANGING_DEPTH = 1e-3;
  var BLOCKS = 8;
  var SETTLED_SHARE = 0.05;
  var SETTLED_RATE = 2 * Math.PI / 180;
  var wholePeriods = (period, start, end) => Math.floor((end - start) / period + 1e-6);
  var rotation = (cross2, dot3) => unwrap(Float64Array.from(cross2, (value, i) => Math.atan2(value, dot3[i])));
  var spinRate = (time, angle, period, start, end) => {
    const periods = wholePeriods(period, start, end);
    if (!(periods >= 2) || time.length < 4) return { rate: NaN, low: NaN, high: NaN, settled: false, sd: NaN };
    const from = end - periods * period;
    const blocks = Math.min(BLOCKS, periods);
    const edges = Array.from({ length: blocks + 1 }, (_, i) => from + period * roundHalfEven(i * periods / blocks));
    const at2 = edges.map((edge) => interpolate(edge, time, angle));
    const weights = edges.slice(1).map((edge, i) => edge - edges[i]);
    const slopes = weights.map((weight, i) => (at2[i + 1] - at2[i]) / weight);
    const total = weights.reduce((sum2, weight) => sum2 + weight, 0);
    const average = (values) => values.reduce((sum2, value, i) => sum2 + weights[i] * value, 0) / total;
    const rate = average(slopes);
    const spread2 = Math.sqrt(average(slopes.map((slope) => (slope - rate) ** 2)) * blocks / (blocks - 1));
    const half = student95(blocks - 1) * spread2 / Math.sqrt(blocks);
    const span = Math.floor(periods / 2) * period;
    const rateFrom = (a) => (interpolate(a + span, time, angle) - interpolate(a, time, angle)) / span;
    const settled = Math.abs(rateFrom(end - span) - rateFrom(from)) <= Math.max(SETTLED_SHARE * Math.abs(rate), SETTLED_RATE);
    return { rate, low: rate - half, high: rate + half, settled, sd: spread2 };
  };
  var twist = (time, moves, period, start, end) => {
    const periods = wholePeriods(period, start, end);
    if (!(periods >= 2) || time.length < 4) {
      return { mean: [NaN, NaN, NaN], covariance: [0, 1, 2].map(() => [NaN, NaN, NaN]) };
    }
    const edges = Array.from({ length: periods + 1 }, (_, i) => end - period * (periods - i));
    const strides = moves.map((move) => {
      const at2 = edges.map((edge) => interpolate(edge, time, move));
      return Float64Array.from({ length: periods }, (_, i) => (at2[i + 1] - at2[i]) / (edges[i + 1] - edges[i]));
    });
    const means = strides.map(mean);
    const covariance = strides.map(
      (one, a) => strides.map((other, b) => {
        let sum2 = 0;
        for (let i = 0; i < periods; i++) sum2 += (one[i] - means[a]) * (other[i] - means[b]);
        return sum2 / (periods - 1);
      })
    );
    return { mean: means, covariance };
  };
  var inPeriods = (time, values, period, start, end, take) => {
    const count = Math.max(0, wholePeriods(period, start, end)) || 0;
    for (let i = 0; i < time.length; i++) {
      const index = Math.floor((time[i] - start) / period - 1e-9);
      if (time[i] > start && index >= 0 && index < count) take(index, values[i]);
    }
    return count;
  };
  var periodMeans = (time, values, period, start, end) => {
    const sums = [];
    const numbers2 = [];
    const count = inPeriods(time, values, period, start, end, (index, value) => {
      sums[index] = (sums[index] ?? 0) + value;
      numbers2[index] = (numbers2[index] ?? 0) + 1;
    });
    return Float64Array.from({ length: count }, (_, i) => (sums[i] ?? 0) / Math.max(numbers2[i] ?? 0, 1));
  };
  var gait = (left, right, flight) => {
    if (!flight.length) return "";
    const counts = [0, 0, 0];
    for (let i = 0; i < flight.length; i++) counts[gaitOf(left[i], right[i], flight[i])]++;
    return GAITS[placeOfLargest(counts)];
  };
  var gaitOf = (left, right, flight) => {
    if (flight > SHORTEST_STRIDE) return 2;
    return Math.min(left, right) < 1 - SHORTEST_STRIDE ? 1 : 0;
  };
  var halfPeriod = (time, period) => roundHalfEven(Math.min(period / (time[1] - time[0]) / 2, time.length));
  var slip = (time, x, y, period) => {
    const n = time.length;
    if (n < 2) return Float64Array.from(x, (value, i) => Math.hypot(value - x[0], y[i] - y[0]));
    const half = halfPeriod(time, period);
    const sums = [x, y].map((values) => {
      const sum2 = new Float64Array(n + 1);
      for (let i = 0; i < n; i++) sum2[i + 1] = sum2[i] + values[i];
      return sum2;
    });
    return Float64Array.from({ length: n }, (_, i) => {
      const reach = Math.min(half, i, n - 1 - i);
      const [dx, dy] = sums.map((sum2) => (sum2[i + reach + 1] - sum2[i - reach]) / (2 * reach + 1));
      return Math.hypot(dx - x[0], dy - y[0]);
    });
  };
  var isAveraged = (time, i, last2, period) => time[i] <= time[last2] - period / 2 || time[last2] < period;
  var finiteSamples = (channels) => {
    const all = Object.values(channels);
    const n = channels.time.length;
    return all.reduce((finite2, values) => {
      for (let i = 0; i < finite2; i++) if (!Number.isFinite(values[i])) return i;
      return finite2;
    }, n);
  };
  var firstFailure = (channels, period, slipLimit, plateSize = null, diverged = false) => {
    const { time } = channels;
    const last2 = finiteSamples(channels);
    const failures = [];
    const sign = (kind, at2) => at2 >= 0 && failures.push({ kind, time: time[at2], first_sign: Infinity });
    if (last2 > 0) {
      const [t, x, y] = [time, channels.centre_x, channels.centre_y].map((values) => values.subarray(0, last2));
      const slipped = slip(t, x, y, period);
      sign("slipped", slipped.findIndex((way, i) => way > slipLimit && isAveraged(t, i, last2 - 1, period)));
    }
    const state = stateOf(channels, plateSize);
    const first = (holds) => {
      for (let i = 0; i < last2; i++) if (holds(i)) return i;
      return -1;
    };
    sign("folded", first((i) => state.folded(i) && !state.hanging(i)));
    sign("turned over", first((i) => state.over(i) && !state.hanging(i)));
    sign("left the plate", first((i) => state.beyond(i) || state.hanging(i) && (state.folded(i) || state.over(i))));
    if (diverged || last2 < time.length) sign("diverged", Math.max(last2 - 1, 0));
    if (!failures.length) return null;
    const earliest = failures.reduce((best, failure) => failure.time < best.time ? failure : best);
    const left = earliest.kind === "slipped" && failures.find(({ kind }) => kind === "left the plate");
    return left ? { ...left, first_sign: earliest.time } : earliest;
  };
  var stateOf = (channels, plateSize) => {
    const { centre_x: x, centre_y: y, centre_z: z, area_x: ax, area_y: ay, area_z: az } = channels;
    const never = () => false;
    const told3 = az && az[0] > 0;
    const size = (i) => Math.hypot(ax[i], ay[i], az[i]);
    return {
      folded: told3 ? (i) => size(i) < FOLDED_AREA : never,
      over: told3 ? (i) => size(i) >= FOLDED_AREA && az[i] < 0 : never,
      beyond: plateSize ? (i) => Math.abs(x[i]) > plateSize[0] / 2 || Math.abs(y[i]) > plateSize[1] / 2 : never,
      hanging: plateSize && z ? (i) => z[i] < -HANGING_DEPTH : never
    };
  };

  // src/app/reading.js
  var PERIODS = 12;
  var LEAST = 0.4;
  function reading(scenario, samples, diverged) {
    const period = periodOf(scenario.motion);
    const all = samples.all();
    const n = samples.length;
    const empty = { rate: NaN, low: NaN, high: NaN, gait: "", drift: NaN, failure: null, twist: [NaN, NaN, NaN], time: 0 };
    if (n < 4) return empty;
    const end = all.time[n - 1];
    const size = scenario.plate ? [scenario.plate.length, scenario.plate.width] : null;
    const failure = firstFailure(all, period, scenario.slip_limit, size, diverged);
    const span = Math.max(LEAST, PERIODS * period);
    const start = Math.max(0, end - span);
    const recent = samples.from(samples.indexAfter(start - period));
    const angle = rotation(recent.spin_cross, recent.spin_dot);
    const spin = spinRate(recent.time, angle, period, start, end);
    const legs = ["left_contact", "right_contact", "flight"].map((name) => periodMeans(recent.time, recent[name], period, start, end));
    const drifts = slip(all.time, all.centre_x, all.centre_y, period);
    let whole2 = n - 1;
    while (whole2 > 0 && all.time[whole2] > end - period / 2) whole2--;
    const moves = [recent.centre_x, recent.centre_y, angle];
    return {
      rate: spin.rate,
      low: spin.low,
      high: spin.high,
      time: end,
      gait: gait(...legs),
      drift: drifts[whole2],
      failure,
      twist: Array.from(twist(recent.time, moves, period, start, end).mean)
    };
  }
  var DEG5 = Math.PI / 180;
  function inWords(read3) {
    if (!(read3.time > 0)) return "starting";
    const parts = [];
    if (read3.failure) parts.push(`${read3.failure.kind} at ${read3.failure.time.toFixed(2)} s`);
    if (read3.gait) parts.push(read3.gait);
    parts.push(Number.isFinite(read3.rate) ? `${(read3.rate / DEG5).toFixed(0)} °/s` : "no rate yet");
    return parts.join(" · ");
  }

  // src/app/exhibits/run.js
  function recorded(element2, desk) {
    const { payload } = desk;
    const frames = framesOf(payload);
    const channels = Object.fromEntries(Object.entries(seriesOf(payload)).map(([name, values]) => [name, Float32Array.from(values, real)]));
    const replay = () => new Replay(payload.scenario, frames, channels, { changed: () => desk.tell("frame"), refused: (m) => desk.tell("notice", m) });
    const read3 = reading(payload.scenario, replay().samples, false);
    element2.append(
      make("p", {}, `The file's run: ${inWords(read3)}, ${frames.length} shapes of ${(frames.at(-1)?.time ?? 0).toFixed(2)} s.`),
      button("Play it beside the live sheet", () => {
        desk.sit(replay(), payload.scenario);
      }, { disabled: frames.length === 0 })
    );
  }
  function seriesOf({ time, channels }) {
    const all = { ...isTable(channels) ? channels : {}, time };
    if (!Array.isArray(time) || !Object.values(all).every((values) => Array.isArray(values) && values.length === time.length))
      throw new Error("series of different lengths");
    return all;
  }
  var real = (value) => value === null ? NaN : Number(value);
  function framesOf(payload) {
    const { snapshot_time: times = [], plate_pose: poses = [], snapshots = "" } = payload;
    const isPose = (pose) => Array.isArray(pose) && pose.length === 6 && pose.every(Number.isFinite);
    if (!Array.isArray(times) || !Array.isArray(poses) || poses.length !== times.length || !poses.every(isPose) || typeof snapshots !== "string")
      throw new Error("no shapes with the plate's poses in it");
    const numbers2 = floatsOf(snapshots);
    const each = times.length ? Math.floor(numbers2.length / times.length) : 0;
    if (each % 3) throw new Error("shapes that are no nodes");
    return times.map((time, k) => ({ time: Number(time), nodes: numbers2.subarray(k * each, (k + 1) * each), pose: poses[k] }));
  }

  // src/app/exhibits/steering.js
  var DEG6 = Math.PI / 180;
  function steered(element2, desk, scenes) {
    const { payload } = desk;
    const ticks = wholeRows(payload.ticks, ["time", "x", "y", "angle"]);
    const goals = (Array.isArray(payload.goals) ? payload.goals : []).filter((goal2) => [goal2?.x, goal2?.y, goal2?.from].every(Number.isFinite));
    if (!goals.length) throw new Error("no goal in it");
    const told3 = toldOf(payload);
    const frames = flatFrames(payload.scenario, ticks);
    if (!frames.length) throw new Error("no poses in it");
    const end = frames.at(-1).at;
    const goal = goals.at(-1);
    const off = Math.hypot(end.x - goal.x, end.y - goal.y) * 1e3;
    const turn = !Number.isFinite(goal.angle) ? null : Math.abs(Math.atan2(Math.sin(end.angle - goal.angle), Math.cos(end.angle - goal.angle))) / DEG6;
    element2.append(
      make("p", {}, `${frames.length} ticks, ${goals.length === 1 ? "one goal" : `${goals.length} goals`}; at the end ${off.toFixed(1)} mm${turn === null ? "" : ` and ${turn.toFixed(1)} deg`} from the last.`),
      button("Play it beside the live sheet", () => {
        const told4 = { changed: () => desk.tell("frame"), refused: (message) => desk.tell("notice", message) };
        desk.sit(new Replay(payload.scenario, frames, {}, told4), { ...payload.scenario, name: "as steered" });
        mark2();
      }),
      told3.length ? button("Steer it again here", () => {
        if (desk.set({ ...payload.scenario, duration: Math.max(payload.scenario.duration, frames.at(-1).time) }, told3))
          desk.tell("notice", "The plate is told what it was told then: the sheet goes its own way there");
      }) : null,
      make("p", { class: "note" }, "The file holds where the object was, not how it bent: it is drawn flat.")
    );
    const mark2 = () => desk.seats.forEach(({ live }, k) => {
      const now = [...goals].reverse().find((each) => each.from <= live.clock) ?? goals[0];
      scenes[k]?.view.setGoal(live.recorded || live.plan.length ? { x: now.x, y: now.y, angle: now.angle ?? 0 } : null);
    });
    desk.on("drawn", mark2);
  }
  function toldOf({ told: told3, motions }) {
    if (!Array.isArray(told3) || !Array.isArray(motions)) return [];
    const all = told3.map((each) => ({ time: each?.time, within: each?.within, motion: motions[each?.motion] }));
    if (!all.every(({ time, within, motion }) => Number.isFinite(time) && Number.isFinite(within) && isTable(motion))) return [];
    return all.sort((a, b) => a.time - b.time);
  }
  function flatFrames(scenario, ticks) {
    const { rest } = latticeOf(scenario.sheet);
    const { pitch } = scenario.sheet;
    const frames = [];
    ticks.time.forEach((time, k) => {
      const [x, y, angle] = [ticks.x[k], ticks.y[k], ticks.angle[k]];
      const [c, s] = [Math.cos(angle) * pitch, Math.sin(angle) * pitch];
      const nodes = new Float32Array(rest.length / 2 * 3);
      for (let j = 0; 2 * j < rest.length; j++) {
        nodes[3 * j] = x + c * rest[2 * j] - s * rest[2 * j + 1];
        nodes[3 * j + 1] = y + s * rest[2 * j] + c * rest[2 * j + 1];
      }
      frames.push({ time, nodes, pose: [0, 0, 0, 0, 0, 0], at: { x, y, angle } });
    });
    return frames;
  }

  // src/charts/marks.js
  var square = (path, x, y, r) => path.rect(x - 0.9 * r, y - 0.9 * r, 1.8 * r, 1.8 * r);
  var circle = (path, x, y, r) => {
    path.moveTo(x + r, y);
    path.arc(x, y, r, 0, 2 * Math.PI);
  };
  var corners = (points) => (path, x, y, r) => {
    points.forEach(([dx, dy], i) => i ? path.lineTo(x + r * dx, y + r * dy) : path.moveTo(x + r * dx, y + r * dy));
    path.closePath();
  };
  var cross = (path, x, y, r) => {
    for (const side of [-1, 1]) {
      path.moveTo(x - r, y - side * r);
      path.lineTo(x + r, y + side * r);
    }
  };
  var MARKS2 = {
    sliding: { shape: square, colour: "sliding", letter: "s" },
    walking: { shape: corners([[0, -1.15], [1.05, 0.8], [-1.05, 0.8]]), colour: "walking", letter: "w" },
    running: { shape: circle, colour: "running", letter: "r" },
    "": { shape: corners([[0, -1.1], [1.1, 0], [0, 1.1], [-1.1, 0]]), colour: "muted", letter: "?" },
    failed: { shape: cross, colour: "failed", letter: "×" }
  };
  var drawMark = (ctx, kind, x, y, r, partly = false) => {
    const { shape, colour } = MARKS2[kind] ?? MARKS2[""];
    const path = new Path2D();
    shape(path, x, y, r);
    ctx.save();
    ctx.lineWidth = Math.max(1.5, r / 3);
    ctx.strokeStyle = colours[colour];
    if (kind !== "failed") {
      ctx.fillStyle = colours.paper;
      ctx.fill(path);
      if (partly) {
        ctx.save();
        ctx.clip(path);
        ctx.fillStyle = colours[colour];
        ctx.fillRect(x - 2 * r, y - 2 * r, 2 * r, 4 * r);
        ctx.restore();
      }
    }
    ctx.stroke(path);
    ctx.restore();
  };
  var markInLegend = (kind, text, partly = false) => {
    const item = document.createElement("span");
    item.className = "mark";
    const canvas = document.createElement("canvas");
    const scale = Math.max(1, Math.round(devicePixelRatio || 1));
    canvas.width = canvas.height = 16 * scale;
    canvas.setAttribute("aria-hidden", "true");
    item.append(canvas, text);
    const draw = () => {
      const ctx = canvas.getContext("2d");
      ctx.clearRect(0, 0, canvas.width, canvas.height);
      drawMark(ctx, kind, 8 * scale, 8 * scale, 5 * scale, partly);
    };
    draw();
    return { item, draw };
  };

  // src/charts/map.js
  var heatMap = (el, { onPick } = {}) => {
    el.classList.add("chart-parts");
    const legend = legendOf2(el);
    const below = el.appendChild(element("div", "chart-below"));
    const readout = el.appendChild(element("p", "chart-readout"));
    readout.setAttribute("aria-live", "polite");
    let data = { x: { label: "", values: [0, 1] }, y: { label: "", values: [0, 1] }, cells: /* @__PURE__ */ new Map(), label: "", unit: "" };
    let chosen = null;
    const chart = plotIn(below, {
      scales: { x: { time: false, range: () => [0, data.x.values.length] }, y: { range: () => [0, data.y.values.length] } },
      series: [{}, { show: false }],
      axes: [
        axis(() => data.x.label, { ...ticksOf(() => data.x.values, 60), grid: { show: false } }),
        leftAxis(() => data.y.label, { ...ticksOf(() => data.y.values, 28), grid: { show: false } })
      ],
      hooks: { draw: [(u) => drawCells(u, data, chosen)] }
    }, [[0, 1], [null, null]]);
    const choose = (cell3) => {
      chosen = cell3;
      readout.textContent = cell3 ? cellInWords(data, cell3) : "";
      chart.plot?.redraw(false);
    };
    if (onPick) pickable(below, chart, () => data, () => chosen, choose, onPick);
    return {
      update(next) {
        const moved = JSON.stringify([data.x, data.y]) !== JSON.stringify([next.x, next.y]);
        data = next;
        const [nx, ny] = [data.x.values.length, data.y.values.length];
        if (chosen && (chosen.i >= nx || chosen.j >= ny)) choose(null);
        legend.update(data);
        chart.update([[0, 1], [null, null]]);
        if (moved) chart.plot?.redraw(true, true);
        const done = [...data.cells.values()];
        const [low, high] = extent2(data);
        const failed2 = done.filter((cell3) => cell3.failed).length;
        chart.describe(`Map of ${data.label} over ${data.x.label} and ${data.y.label}: ${done.length} of ${nx * ny} cells, from ${read2(low)} to ${read2(high)} ${data.unit}, ${failed2} failed`);
      },
      resize: chart.resize,
      destroy() {
        chart.destroy();
        legend.remove();
        below.remove();
        readout.remove();
      }
    };
  };
  var extent2 = ({ cells, categories }) => {
    if (categories) return [0, categories.length - 1];
    const values = [...cells.values()].filter((cell3) => !cell3.failed).map(({ value }) => value).filter(Number.isFinite);
    return values.length ? [Math.min(...values), Math.max(...values)] : [NaN, NaN];
  };
  var shareOf = (value, [low, high]) => high > low ? (value - low) / (high - low) : 0.5;
  var told2 = (value, count) => typeof value === "string" ? value : read2(value, count);
  var ticksOf = (valuesOf2, space) => ({
    splits: (u, index) => {
      const n = valuesOf2().length;
      const pixels = (index === 0 ? u.bbox.width : u.bbox.height) / (devicePixelRatio || 1);
      const every = Math.max(1, Math.ceil(n * space / Math.max(pixels, 1)));
      return Array.from({ length: Math.ceil(n / every) }, (_, k) => k * every + 0.5);
    },
    values: (_, splits) => splits.map((at2) => told2(valuesOf2()[Math.floor(at2)] ?? NaN))
  });
  var drawCells = (u, data, chosen) => {
    const { ctx } = u;
    const scale = devicePixelRatio || 1;
    const [nx, ny] = [data.x.values.length, data.y.values.length];
    const [w, h] = [u.bbox.width / nx, u.bbox.height / ny];
    const ends = extent2(data);
    const letters = Math.min(w, h) > 13 * scale;
    ctx.save();
    ctx.font = `${11 * scale}px system-ui, sans-serif`;
    ctx.textAlign = "center";
    ctx.textBaseline = "middle";
    for (let i = 0; i < nx; i++) {
      for (let j = 0; j < ny; j++) {
        const own = data.cells.get(`${i},${j}`);
        const cell3 = own ?? data.step?.(i, j);
        if (!cell3) continue;
        const [left, top] = [Math.round(u.bbox.left + i * w), Math.round(u.bbox.top + (ny - 1 - j) * h)];
        const [right, bottom] = [Math.round(u.bbox.left + (i + 1) * w), Math.round(u.bbox.top + (ny - j) * h)];
        ctx.globalAlpha = own ? 1 : 0.45;
        drawCell(ctx, [left, top, right - left, bottom - top], cell3, lookOf(data, cell3, ends), letters && own, scale);
        ctx.globalAlpha = 1;
      }
    }
    for (const [colour, width] of chosen ? [[colours.ink, 5], [colours.paper, 2]] : []) {
      ctx.strokeStyle = colour;
      ctx.lineWidth = width * scale;
      ctx.strokeRect(u.bbox.left + chosen.i * w, u.bbox.top + (ny - 1 - chosen.j) * h, w, h);
    }
    ctx.restore();
  };
  var wordColour = (categories, i) => {
    if (MARKS2[categories[i]]) return colours[MARKS2[categories[i]].colour];
    return i === 0 ? colours.panel : scaleColour(i / (categories.length - 1));
  };
  var lookOf = ({ categories }, { value, gait: gait2, failed: failed2 }, ends) => {
    if (!Number.isFinite(value) || failed2) return { fill: colours.panel, letter: "", ink: colours.ink };
    if (!categories) return { fill: scaleColour(shareOf(value, ends)), letter: MARKS2[gait2]?.letter ?? "", ink: inkOn(shareOf(value, ends)) };
    const word = categories[value];
    if (MARKS2[word]) return { fill: wordColour(categories, value), letter: MARKS2[word].letter, ink: colours.paper };
    return { fill: wordColour(categories, value), letter: value > 0 ? word[0] : "", ink: inkOn(value / (categories.length - 1)) };
  };
  var drawCell = (ctx, [x, y, w, h], cell3, { fill, letter, ink }, letters, scale) => {
    ctx.fillStyle = fill;
    ctx.fillRect(x, y, w, h);
    if (cell3.failed || cell3.refused) hatch(ctx, x, y, w, h, cell3.refused ? colours.muted : colours.failed, scale);
    if (letters && letter) {
      ctx.fillStyle = ink;
      ctx.fillText(letter, x + w / 2, y + h / 2);
    }
  };
  var hatch = (ctx, x, y, w, h, colour, scale) => {
    ctx.save();
    ctx.beginPath();
    ctx.rect(x, y, w, h);
    ctx.clip();
    ctx.strokeStyle = colour;
    ctx.lineWidth = scale;
    ctx.beginPath();
    const gap = 6 * scale;
    for (let c = Math.floor((x + y) / gap) * gap; c < x + y + w + h; c += gap) {
      ctx.moveTo(c - y, y);
      ctx.lineTo(c - y - h, y + h);
    }
    ctx.stroke();
    ctx.restore();
  };
  var cellInWords = (data, { i, j }) => {
    const cell3 = data.cells.get(`${i},${j}`);
    const place = `${data.x.label} ${told2(data.x.values[i], 4)}, ${data.y.label} ${told2(data.y.values[j], 4)}`;
    if (!cell3) return `${place}: not computed yet`;
    if (cell3.refused) return `${place}: ${cell3.refused}`;
    const value = Number.isFinite(cell3.value) && !data.categories ? `${data.label} ${read2(cell3.value)} ${data.unit}`.trim() : "";
    return `${place}: ${[value, cell3.gait, cell3.failure].filter(Boolean).join(", ") || "nothing to measure"}`;
  };
  var pickable = (below, chart, dataOf, chosen, choose, onPick) => {
    below.tabIndex = 0;
    below.setAttribute("role", "application");
    below.setAttribute("aria-label", "Cells of the map: arrows choose one, Enter watches it");
    const cellAt = (event) => {
      if (!chart.plot) return null;
      const box = chart.plot.over.getBoundingClientRect();
      const { x, y } = dataOf();
      const i = Math.floor((event.clientX - box.left) / box.width * x.values.length);
      const j = y.values.length - 1 - Math.floor((event.clientY - box.top) / box.height * y.values.length);
      return i >= 0 && j >= 0 && i < x.values.length && j < y.values.length ? { i, j } : null;
    };
    below.addEventListener("pointermove", (event) => {
      const cell3 = cellAt(event);
      if (cell3 && (cell3.i !== chosen()?.i || cell3.j !== chosen()?.j)) choose(cell3);
    });
    below.addEventListener("click", (event) => {
      const cell3 = cellAt(event);
      if (!cell3) return;
      choose(cell3);
      onPick(cell3);
    });
    below.addEventListener("keydown", (event) => {
      const by = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      const { x, y } = dataOf();
      const now = chosen() ?? { i: 0, j: 0 };
      const inside = (value, count) => Math.min(Math.max(value, 0), count - 1);
      if (by) choose({ i: inside(now.i + by[0], x.values.length), j: inside(now.j + by[1], y.values.length) });
      else if ((event.key === "Enter" || event.key === " ") && chosen()) onPick(chosen());
      else return;
      event.preventDefault();
    });
  };
  var legendOf2 = (el) => {
    const list = el.appendChild(element("p", "chart-legend"));
    const what = element("span");
    const scale = element("span");
    const letters = element("span");
    list.append(what, scale, letters);
    const [low, high] = [element("span"), element("span")];
    const ramp = swatch(64, (share2) => scaleColour(share2), "ramp");
    let words = "";
    let shown4 = null;
    const away2 = onColours(() => {
      words = "";
      if (shown4) update(shown4);
    });
    const update = (data) => {
      shown4 = data;
      what.textContent = data.label + (data.unit ? ` (${data.unit})` : "");
      const now = JSON.stringify(data.categories);
      if (now !== words) {
        words = now;
        scale.replaceChildren(...data.categories ? data.categories.flatMap((word, i) => [swatch(1, () => wordColour(data.categories, i), "patch"), word]) : [low, ramp, high]);
        const gaits = data.categories ? "" : "s sliding · w walking · r running · ";
        letters.textContent = data.label === "failure" ? "letters: how it failed" : `${gaits}hatched: failed`;
      }
      if (!data.categories) [low.textContent, high.textContent] = extent2(data).map((end) => read2(end));
    };
    return {
      update,
      remove() {
        away2();
        list.remove();
      }
    };
  };
  var swatch = (width, colour, name) => {
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { className: name, width, height: 1 });
    canvas.setAttribute("aria-hidden", "true");
    const ctx = canvas.getContext("2d");
    for (let x = 0; x < width; x++) {
      ctx.fillStyle = colour(x / Math.max(width - 1, 1));
      ctx.fillRect(x, 0, 1, 1);
    }
    return canvas;
  };

  // src/curve/distributions.js
  var logGamma = (x) => {
    const [first, ...others] = LANCZOS;
    const sum2 = others.reduce((total, c, i) => total + c / (x + i), first);
    const t = x + 6.5;
    return 0.5 * Math.log(2 * Math.PI) + (x - 0.5) * Math.log(t) - t + Math.log(sum2);
  };
  var LANCZOS = [
    0.9999999999998099,
    676.5203681218851,
    -1259.1392167224028,
    771.3234287776531,
    -176.6150291621406,
    12.507343278686905,
    -0.13857109526572012,
    9984369578019572e-21,
    15056327351493116e-23
  ];
  var TINY = 1e-300;
  var away = (x) => Math.abs(x) < TINY ? TINY : x;
  var continuedFraction = (b0, term) => {
    let [value, c, d] = [away(b0), away(b0), 0];
    for (let i = 1; i < 1e3; i++) {
      const [a, b] = term(i);
      d = 1 / away(b + a * d);
      c = away(b + a / c);
      value *= c * d;
      if (Math.abs(c * d - 1) < 1e-15) break;
    }
    return value;
  };
  var incompleteBeta = (a, b, x) => {
    if (x <= 0 || x >= 1) return x <= 0 ? 0 : 1;
    if (x > (a + 1) / (a + b + 2)) return 1 - incompleteBeta(b, a, 1 - x);
    const front = Math.exp(logGamma(a + b) - logGamma(a) - logGamma(b) + a * Math.log(x) + b * Math.log(1 - x)) / a;
    const fraction = continuedFraction(1, (i) => {
      const m = i >> 1;
      const numerator = i % 2 ? -(a + m) * (a + b + m) * x : m * (b - m) * x;
      return [numerator / ((a + i - 1) * (a + i)), 1];
    });
    return front / fraction;
  };
  var upperGamma = (a, x) => {
    if (x <= 0) return 1;
    const front = Math.exp(a * Math.log(x) - x - logGamma(a));
    if (x < a + 1) {
      let [term, sum2] = [1 / a, 1 / a];
      for (let n = 1; Math.abs(term) > 1e-17 * sum2 && n < 1e3; n++) {
        term *= x / (a + n);
        sum2 += term;
      }
      return 1 - front * sum2;
    }
    return front / continuedFraction(x + 1 - a, (i) => [-i * (i - a), x + 2 * i + 1 - a]);
  };
  var crossing = (rising) => {
    let [low, high] = [0, 1];
    while (rising(high) < 0) [low, high] = [high, 2 * high];
    for (let i = 0; i < 200 && high - low > 1e-13 * high; i++) {
      const middle = (low + high) / 2;
      if (rising(middle) < 0) low = middle;
      else high = middle;
    }
    return (low + high) / 2;
  };
  var studentQuantile = (freedom, share2) => crossing((t) => 2 * (1 - share2) - incompleteBeta(freedom / 2, 0.5, freedom / (freedom + t * t)));
  var fisherQuantile = (above, below, share2) => crossing((f) => incompleteBeta(above / 2, below / 2, above * f / (above * f + below)) - share2);
  var chiSquareUpper = (freedom, share2) => crossing((x) => share2 - upperGamma(freedom / 2, x / 2));

  // src/curve/minimise.js
  var TOLERANCE = 1e-10;
  var FLAT2 = 1e-15;
  var dot2 = (a, b) => {
    let sum2 = 0;
    for (let k = 0; k < a.length; k++) sum2 += a[k] * b[k];
    return sum2;
  };
  var normalMatrix = (columns) => columns.map((one) => columns.map((other) => dot2(one, other)));
  var pseudoInverse = (matrix, least2 = 1e-15) => {
    const n = matrix.length;
    const a = matrix.map((row2) => [...row2]);
    const vectors = a.map((_, i) => a.map((_2, j) => i === j ? 1 : 0));
    for (let sweep = 0; sweep < 8; sweep++) {
      for (let p = 0; p < n; p++) for (let q = p + 1; q < n; q++) rotate(a, vectors, p, q);
    }
    const largest = Math.max(...a.map((row2, i) => Math.abs(row2[i])));
    return matrix.map((_, i) => matrix.map((_2, j) => {
      const parts = a.map((row2, k) => Math.abs(row2[k]) > least2 * largest ? vectors[i][k] * vectors[j][k] / row2[k] : 0);
      return parts.reduce((sum2, part) => sum2 + part, 0);
    }));
  };
  var rotate = (a, vectors, p, q) => {
    if (a[p][q] === 0) return;
    const theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const t = (theta >= 0 ? 1 : -1) / (Math.abs(theta) + Math.hypot(theta, 1));
    const c = 1 / Math.hypot(t, 1);
    const s = t * c;
    const turned = (x, y) => [c * x - s * y, s * x + c * y];
    for (const row2 of a) [row2[p], row2[q]] = turned(row2[p], row2[q]);
    for (let j = 0; j < a.length; j++) [a[p][j], a[q][j]] = turned(a[p][j], a[q][j]);
    for (const row2 of vectors) [row2[p], row2[q]] = turned(row2[p], row2[q]);
  };
  var leastSquares = (columns, values) => {
    const inverse = pseudoInverse(normalMatrix(columns));
    const right = columns.map((column) => dot2(column, values));
    return inverse.map((row2) => dot2(row2, right));
  };
  var solve = (matrix, right) => {
    const n = right.length;
    const lower = matrix.map(() => new Float64Array(n));
    const x = Float64Array.from(right);
    for (let i = 0; i < n; i++) {
      for (let j = 0; j <= i; j++) {
        let left = matrix[i][j];
        for (let k = 0; k < j; k++) left -= lower[i][k] * lower[j][k];
        if (i === j && !(left > 0)) return null;
        lower[i][j] = i === j ? Math.sqrt(left) : left / lower[j][j];
        if (j < i) x[i] -= lower[i][j] * x[j];
      }
      x[i] /= lower[i][i];
    }
    for (let i = n - 1; i >= 0; i--) {
      for (let k = i + 1; k < n; k++) x[i] -= lower[k][i] * x[k];
      x[i] /= lower[i][i];
    }
    return x;
  };
  var minimise = (residual, jacobian, start, evaluations) => {
    let [p, r, damping, used] = [start, residual(start), 1e-3, 1];
    let cost = dot2(r, r);
    const scale = start.map(() => 0);
    while (used < evaluations) {
      const columns = jacobian(p);
      const matrix = normalMatrix(columns);
      const slope = columns.map((column) => -dot2(column, r));
      matrix.forEach((row2, i) => scale[i] = Math.max(scale[i], row2[i]));
      if (slope.every((value, i) => Math.abs(value) <= TOLERANCE * Math.sqrt(matrix[i][i] * cost))) break;
      let [length, gain] = [Infinity, -1];
      while (gain < 0 && length > TOLERANCE && used < evaluations) {
        const step = solve(matrix.map((row2, i) => row2.map((value, j) => value + (i === j ? damping * (scale[i] || 1) : 0))), slope);
        const tried = step && p.map((value, i) => value + step[i]);
        const reached = step ? residual(tried) : r;
        const next = step ? dot2(reached, reached) : Infinity;
        length = step ? Math.max(...step.map(Math.abs)) : Infinity;
        used++;
        if (next <= cost) [gain, p, r, cost, damping] = [cost - next, tried, reached, next, Math.max(damping / 10, 1e-15)];
        else damping *= 5;
      }
      if (length <= TOLERANCE || gain <= FLAT2 * cost) break;
    }
    return { p, cost };
  };
  var rootBetween = (f, low, high, tolerance) => {
    let [a, b, fa, fb] = [low, high, f(low), f(high)];
    let side = 0;
    for (let i = 0; i < 100 && Math.abs(b - a) > tolerance; i++) {
      const middle = i % 3 === 2 ? (a + b) / 2 : (a * fb - b * fa) / (fb - fa);
      const fm = f(middle);
      if (fm === 0) return middle;
      if (fm < 0 === fb < 0) {
        [b, fb] = [middle, fm];
        if (side === -1) fa /= 2;
        side = -1;
      } else {
        [a, fa] = [middle, fm];
        if (side === 1) fb /= 2;
        side = 1;
      }
    }
    return Math.abs(fa) < Math.abs(fb) ? a : b;
  };

  // src/curve/peak.js
  var LEAST_SAMPLES = 3;
  var digits2 = (value, count = 6) => Number.isFinite(value) ? String(Number(value.toPrecision(count))) : String(value).replace("Infinity", "inf");
  var anywhere = (low, high, count) => {
    const [start, end] = [low, high].map((value) => digits2(value, count));
    if (!Number.isFinite(low)) return Number.isFinite(high) ? `anywhere up to ${end} Hz` : "at any frequency";
    return Number.isFinite(high) ? `anywhere from ${start} to ${end} Hz` : `anywhere from ${start} Hz on`;
  };
  var distinct = (frequency) => [...new Set(frequency)].sort((a, b) => a - b);
  var heightsOf = (frequency, rate) => {
    const f = distinct(frequency);
    const largest = rate.reduce((best, value) => Math.abs(value) > Math.abs(best) ? value : best, rate[0]);
    const heights = f.map((each) => {
      const own = rate.filter((_, i) => frequency[i] === each);
      return Math.sign(largest) * own.reduce((sum2, value) => sum2 + value, 0) / own.length;
    });
    return { f, heights };
  };
  var unseenTop = (frequency, rate, endsInFailure2 = false) => {
    const { f, heights } = heightsOf(frequency, rate);
    const highest = Math.max(...heights);
    if (heights[0] === highest) return `rates that are highest at the first frequency, ${digits2(f[0])} Hz`;
    if (heights.at(-1) === highest && !endsInFailure2) {
      return `rates that are highest at the last frequency, ${digits2(f.at(-1))} Hz`;
    }
    return null;
  };
  var unseenPeak = (frequency, rate, f0, halfWidth, endsInFailure2 = false) => {
    const fault2 = unseenTop(frequency, rate, endsInFailure2);
    if (fault2) return fault2;
    const f = distinct(frequency);
    const beyond2 = endsInFailure2 ? (f.at(-1) - f.at(-2)) / 2 : 0;
    if (!(f[0] <= f0 && f0 <= f.at(-1) + beyond2)) return `a line that peaks at ${digits2(f0, 4)} Hz, where nothing was measured`;
    const within = f.filter((each) => Math.abs(each - f0) <= halfWidth).length;
    if (within >= LEAST_SAMPLES) return null;
    const samples = within === 0 ? "none" : `only ${within}`;
    return `a peak of half width ${digits2(halfWidth, 2)} Hz at ${digits2(f0, 4)} Hz with ${samples} of the frequencies within it`;
  };

  // src/curve/lorentz.js
  var REACH = [Math.log(100), 1.5, Math.log(100)];
  var LIMIT = 40;
  var EVALUATIONS = 100;
  var CONFIDENCE = 0.95;
  var NORMAL = 1.959963984540054;
  var SIGNIFICANCE = 0.01;
  var ROUNDING2 = 1e-24;
  var sum = (values) => values.reduce((total, value) => total + value, 0);
  var squares = (values) => values.reduce((total, value) => total + value * value, 0);
  var clipped = (value) => Math.min(Math.max(value, -LIMIT), LIMIT);
  var lorentzian = (frequency, peak, f0, halfWidth) => peak / (1 + ((frequency - f0) / halfWidth) ** 2);
  var fitLorentzian = (frequency, rate, { sd = null, endsInFailure: endsInFailure2 = false } = {}) => {
    const points = pointsOf(frequency, rate, sd);
    if (points.refused) return points;
    const { f, y, sds } = points;
    const top = unseenTop(f, y, endsInFailure2);
    if (top) return noPeak(f, y, top);
    const curve = curveOf(f, y, sds);
    const { p: best, cost } = bestOf(curve, startsOf(curve));
    const [peak, f0, halfWidth] = inUnits(curve, best);
    const unseen = unseenPeak(f, y, f0, halfWidth, endsInFailure2);
    if (unseen) return noPeak(f, y, unseen, f0);
    if (hasRival(curve, cost, endsInFailure2)) return noPeak(f, y, "a curve that a straight line or an exponential fits better");
    const { threshold, sdHolds } = thresholdOf(cost, f.length - 3, sd !== null);
    const { ends, method } = intervalsOf(curve, best, cost, threshold);
    const units = [inUnits(curve, ends.map(([low]) => low)), inUnits(curve, ends.map(([, high]) => high))];
    const [peakInterval, f0Interval, halfWidthInterval] = [0, 1, 2].map((i) => units.map((each) => each[i]).sort((a, b) => a - b));
    const open = unbounded(f, peakInterval, f0Interval, halfWidthInterval, endsInFailure2);
    if (open) return noPeak(f, y, open, f0);
    return {
      peak,
      f0,
      halfWidth,
      r2: 1 - cost / spreadOf2(curve),
      nPoints: f.length,
      peakInterval,
      f0Interval,
      halfWidthInterval,
      method,
      scatter: sdHolds ? "given" : "residual"
    };
  };
  var pointsOf = (frequency, rate, sd) => {
    const has = Array.from(rate, (value) => value !== null && !Number.isNaN(value));
    const kept2 = (values) => Array.from(values).filter((_, i) => has[i]);
    const [f, y] = [kept2(frequency), kept2(rate)];
    const largest = Math.max(0, ...y.map(Math.abs));
    const sds = sd ? kept2(sd) : y.map(() => largest || 1);
    if (f.some((value) => !(value > 0 && value < Infinity))) {
      return { refused: "a frequency that is not above 0 Hz", advice: "frequencies above 0 Hz" };
    }
    if (y.some((value) => !Number.isFinite(value))) return { refused: "an infinite rate", advice: "leaving it out" };
    if (sds.some((value) => !(value > 0 && value < Infinity))) {
      return { refused: "a standard deviation that is not above 0", advice: "leaving it out" };
    }
    const count = distinct(f).length;
    if (count < 4) {
      return { refused: `${f.length} rates at ${count} frequencies, where four are needed`, advice: "more frequencies" };
    }
    if (Math.max(...y) - Math.min(...y) <= 1e-12 * largest) {
      return { refused: "rates that are all alike", advice: "frequencies where the object spins" };
    }
    return { f, y, sds };
  };
  var noPeak = (f, y, refused, f0 = null) => {
    const [low, high] = [Math.min(...f), Math.max(...f)];
    const highest = f[y.reduce((best, value, i) => Math.abs(value) > Math.abs(y[best]) ? i : best, 0)];
    const near = f0 === null ? highest : Math.min(Math.max(f0, low), high);
    const side = near === high ? "beyond" : near === low ? "below" : "around";
    return { refused, advice: `adding frequencies ${side} ${digits2(near, 4)} Hz` };
  };
  var curveOf = (f, y, sds) => {
    const largest = y.reduce((best, value) => Math.abs(value) > Math.abs(best) ? value : best, y[0]);
    const [low, high] = [Math.min(...f), Math.max(...f)];
    const [centre, span] = [(low + high) / 2, high - low];
    return {
      largest,
      centre,
      span,
      x: f.map((value) => (value - centre) / span),
      v: y.map((value) => value / largest),
      w: sds.map((value) => Math.abs(largest) / value)
    };
  };
  var inUnits = ({ largest, centre, span }, p) => [largest * Math.exp(p[0]), centre + span * p[1], span * Math.exp(p[2])];
  var startsOf = ({ x, v }) => {
    const top = v.reduce((best, value, i) => Math.abs(value) > Math.abs(v[best]) ? i : best, 0);
    const about2 = x.map((value) => value - x[top]);
    const plain3 = [0, x[v.indexOf(Math.max(...v))], Math.log(0.25)];
    const [c0, c1, c2] = leastSquares([0, 1, 2].map((power) => about2.map((value, i) => v[i] ** 2 * value ** power)), v);
    const base = c2 > 0 ? c0 - c1 ** 2 / (4 * c2) : 0;
    if (!(base > 0)) return [[0, x[top], Math.log(0.25)], plain3];
    return [[-Math.log(base), x[top] - c1 / (2 * c2), Math.log(base / c2) / 2], plain3];
  };
  var residualOf = ({ x, v, w }, p) => {
    const [peak, halfWidth] = [Math.exp(clipped(p[0])), Math.exp(clipped(p[2]))];
    return Float64Array.from(x, (value, i) => w[i] * (peak / (1 + ((value - p[1]) / halfWidth) ** 2) - v[i]));
  };
  var jacobianOf = ({ x, w }, p) => {
    const [peak, halfWidth] = [Math.exp(clipped(p[0])), Math.exp(clipped(p[2]))];
    const columns = [0, 1, 2].map(() => new Float64Array(x.length));
    for (let i = 0; i < x.length; i++) {
      const u = (x[i] - p[1]) / halfWidth;
      const line = w[i] * peak / (1 + u * u);
      const common = line * 2 * u / (1 + u * u);
      columns[0][i] = line;
      columns[1][i] = common / halfWidth;
      columns[2][i] = common * u;
    }
    return columns;
  };
  var bestOf = (curve, starts, held = -1) => {
    const minima = starts.map((start) => {
      const free = [0, 1, 2].filter((i) => i !== held);
      const whole2 = (part) => start.map((value, i) => i === held ? value : part[free.indexOf(i)]);
      const { p, cost } = minimise(
        (part) => residualOf(curve, whole2(part)),
        (part) => jacobianOf(curve, whole2(part)).filter((_, i) => i !== held),
        free.map((i) => start[i]),
        EVALUATIONS
      );
      return { p: whole2(p).map(clipped), cost };
    });
    return minima.reduce((best, minimum) => minimum.cost < best.cost ? minimum : best);
  };
  var spreadOf2 = ({ v, w }) => {
    const weights = w.map((value) => value ** 2);
    const mean2 = sum(v.map((value, i) => weights[i] * value)) / sum(weights);
    return squares(v.map((value, i) => w[i] * (value - mean2)));
  };
  var hasRival = (curve, cost, endsInFailure2) => {
    const [freedom, rivals] = [curve.x.length - 3, curve.x.length - 2];
    const least2 = monotoneCost(curve, endsInFailure2) / rivals;
    return cost / freedom > fisherQuantile(freedom, rivals, 1 - SIGNIFICANCE) * least2;
  };
  var monotoneCost = (curve, fallingOnly) => {
    const { x, v, w } = curve;
    const line = (weights, values) => leastSquares([weights, x.map((value, i) => weights[i] * value)], values.map((value, i) => weights[i] * value));
    const positive = v.map((value) => Math.max(value, 0));
    const straight = line(w, v);
    const power = line(w.map((value, i) => value * positive[i]), positive.map((value) => value > 0 ? Math.log(value) : 0));
    const rivals = [
      [straight, (value) => straight[0] + straight[1] * value],
      [power, (value) => Math.exp(power[0] + power[1] * value)]
    ].filter(([[, slope]]) => slope <= 0 || !fallingOnly);
    return Math.min(spreadOf2(curve), ...rivals.map(([, of]) => squares(x.map((value, i) => w[i] * (of(value) - v[i])))));
  };
  var thresholdOf = (cost, freedom, sdIsKnown) => {
    if (sdIsKnown && cost <= chiSquareUpper(freedom, SIGNIFICANCE)) return { threshold: NORMAL ** 2, sdHolds: true };
    return { threshold: cost / freedom * studentQuantile(freedom, (1 + CONFIDENCE) / 2) ** 2, sdHolds: false };
  };
  var intervalsOf = (curve, best, cost, threshold) => {
    const covariance = pseudoInverse(normalMatrix(jacobianOf(curve, best)));
    const wald = best.map((_, i) => Math.sqrt(Math.max(covariance[i][i], 0) * threshold));
    if (threshold <= ROUNDING2 * squares(curve.v.map((value, i) => curve.w[i] * value))) {
      return { ends: best.map((value, i) => [value - wald[i], value + wald[i]]), method: "covariance" };
    }
    const ends = best.map((_, i) => [-1, 1].map((side) => profileEnd(curve, best, cost, threshold, i, side, wald[i])));
    return { ends, method: "profile likelihood" };
  };
  var profileEnd = (curve, best, cost, threshold, i, side, wald) => {
    let nearest = best;
    const known = /* @__PURE__ */ new Map();
    const rise = (step) => {
      if (known.has(step)) return known.get(step);
      const starts = [best, nearest].map((start) => start.with(i, best[i] + side * step));
      const minimum = bestOf(curve, starts, i);
      nearest = minimum.p;
      known.set(step, Math.sqrt(Math.max(minimum.cost - cost, 0)) - Math.sqrt(threshold));
      return known.get(step);
    };
    let [inside, outside] = [0, Math.min(Math.max(wald, 1e-9), REACH[i])];
    while (rise(outside) < 0) {
      if (outside === REACH[i]) return side * Infinity;
      [inside, outside] = [outside, Math.min(2 * outside, REACH[i])];
    }
    return best[i] + side * rootBetween(rise, inside, outside, 1e-5 * outside);
  };
  var unbounded = (f, peaks, centres, widths, endsInFailure2) => {
    const each = distinct(f);
    const low = each[0] - (each[1] - each[0]) / 2;
    const high = each.at(-1) + (each.at(-1) - each.at(-2)) / 2;
    const inside = low <= centres[0] && (endsInFailure2 || centres[1] <= high);
    if (!(inside && centres[1] - centres[0] <= each.at(-1) - each[0])) {
      return `a peak ${anywhere(...centres, 4)}`;
    }
    if (![...peaks, ...widths].every(Number.isFinite) || widths[0] === 0) {
      return `a half width ${anywhere(...widths, 2)}`;
    }
    return null;
  };

  // src/charts/curve.js
  var DEGREE = Math.PI / 180;
  var LINE = 240;
  var RADIUS = 5;
  var FADED = 0.4;
  var OVERLAYS = ["running", "walking", "failed", "sliding"];
  var fitInParts = (fit) => {
    if (!fit) return [];
    if (fit.refused) return [`No Lorentz fit: got ${fit.refused}. Try ${fit.advice}.`];
    const line = (name, value, interval, unit) => `${name} ${read2(value, 4)} ${unit} [${read2(interval[0], 4)}, ${read2(interval[1], 4)}]`;
    const degrees = fit.peakInterval.map((rate) => rate / DEGREE);
    return [
      line("f0", fit.f0, fit.f0Interval, "Hz"),
      line("b", fit.halfWidth, fit.halfWidthInterval, "Hz"),
      line("peak", fit.peak / DEGREE, degrees, "°/s"),
      `R² ${fit.r2.toFixed(3)}`
    ];
  };
  var fitInWords = (fit) => fitInParts(fit).join(" · ");
  var pointInWords = (point, unit = "Hz") => {
    const sides = [`${read2(point.frequency, 4)} ${unit}`.trim()];
    if (Number.isFinite(point.rate)) {
      const spread2 = Number.isFinite(point.spread) ? ` ± ${read2(point.spread / DEGREE, 2)}` : "";
      sides.push(`${read2(point.rate / DEGREE)}${spread2} °/s`);
    }
    if (point.gait) sides.push(point.gait);
    if (point.failure) {
      const how = point.runs > 1 ? `${point.failedRuns} of ${point.runs} failed: ` : "";
      const when = Number.isFinite(point.failureTime) ? ` at ${read2(point.failureTime, 2)} s` : "";
      sides.push(`${how}${point.failure}${when}`);
    }
    return sides.join(", ");
  };
  var spinCurve = (el, { onPick } = {}) => {
    el.classList.add("chart-parts");
    const legend = legendOf3(el);
    const below = el.appendChild(element("div", "chart-below"));
    const readout = el.appendChild(element("p", "chart-readout"));
    let data = { points: [], overlays: [] };
    let chosen = -1;
    const draw = (u) => drawCurve(u, data, chosen);
    const words = (point) => pointInWords(point, data.unit);
    const chart = plotIn(below, {
      scales: {
        x: { time: false, range: () => xRange(data) },
        y: { range: () => yRange(data) }
      },
      series: [{}, { show: false }],
      axes: [axis(() => data.label ?? "plate frequency (Hz)"), leftAxis("spin rate (°/s)")],
      hooks: { draw: [draw] }
    }, [[0, 1], [null, null]]);
    const choose = (index) => {
      chosen = index;
      readout.textContent = index < 0 ? "" : words(data.points[index]) + (onPick ? "; click or Enter watches it" : "");
      chart.plot?.redraw(false);
      if (index >= 0) {
        below.setAttribute("aria-valuenow", String(data.points[index].frequency));
        below.setAttribute("aria-valuetext", words(data.points[index]));
      }
    };
    if (onPick) pickable2(below, chart, () => data.points, () => chosen, choose, onPick);
    const describe = () => {
      const measured = data.points.filter(({ rate }) => Number.isFinite(rate)).length;
      const failed2 = data.points.filter((point) => point.failed).length;
      chart.describe(`Spin rate over ${data.label ?? "plate frequency"}, ${data.points.length} points: ${measured} measured, ${failed2} failed. ${fitInWords(data.fit)}`);
    };
    describe();
    return {
      update(next) {
        data = { overlays: [], ...next, points: [...next.points].sort((a, b) => a.frequency - b.frequency) };
        if (chosen >= data.points.length) choose(-1);
        legend.update(data);
        chart.update([[0, 1], [null, null]]);
        if (onPick && data.points.length) {
          below.setAttribute("aria-valuemin", String(data.points[0].frequency));
          below.setAttribute("aria-valuemax", String(data.points.at(-1).frequency));
          if (chosen < 0) below.setAttribute("aria-valuenow", String(data.points[0].frequency));
        }
        describe();
      },
      resize: chart.resize,
      destroy() {
        legend.destroy();
        chart.destroy();
        below.remove();
        readout.remove();
      }
    };
  };
  var xRange = ({ points, overlays, from, to }) => {
    const all = [...points, ...overlays.flatMap((each) => each.points)].map(({ frequency }) => frequency);
    return roomy(Math.min(...all, from ?? Infinity), Math.max(...all, to ?? -Infinity), 0.04);
  };
  var yRange = ({ points, overlays, fit }) => {
    const all = [...points, ...overlays.flatMap((each) => each.points)].flatMap(({ rate, spread: spread2 }) => [rate - (spread2 || 0), rate + (spread2 || 0)]).map((rate) => rate / DEGREE).filter(Number.isFinite);
    const peak = fit && !fit.refused ? [fit.peak / DEGREE] : [];
    return roomy(Math.min(0, ...all, ...peak), Math.max(all.length ? 0 : 10, ...all, ...peak), 0.08);
  };
  var drawCurve = (u, { points, overlays, fit, from }, chosen) => {
    const { ctx } = u;
    const scale = devicePixelRatio || 1;
    const x = (frequency) => u.valToPos(frequency, "x", true);
    const y = (rate) => u.valToPos(rate / DEGREE, "y", true);
    const line = (at2, colour, dash, width) => {
      ctx.beginPath();
      at2.forEach(([f, rate], i) => i ? ctx.lineTo(x(f), y(rate)) : ctx.moveTo(x(f), y(rate)));
      ctx.strokeStyle = colour;
      ctx.lineWidth = width * scale;
      ctx.setLineDash(dash.map((each) => each * scale));
      ctx.stroke();
      ctx.setLineDash([]);
    };
    ctx.save();
    ctx.beginPath();
    ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
    ctx.clip();
    overlays.forEach((each, i) => {
      const known = each.points.filter(({ rate }) => Number.isFinite(rate));
      line(known.map(({ frequency, rate }) => [frequency, rate]), colours[OVERLAYS[i % OVERLAYS.length]], [3, 3], 1.2);
      ctx.fillStyle = colours[OVERLAYS[i % OVERLAYS.length]];
      for (const { frequency, rate } of known) {
        ctx.beginPath();
        ctx.arc(x(frequency), y(rate), 2.2 * scale, 0, 2 * Math.PI);
        ctx.fill();
      }
    });
    if (fit && !fit.refused) {
      const used = points.filter((point) => isUsed(point)).map(({ frequency }) => frequency);
      const [low, high] = [Math.min(...used, from ?? Infinity), Math.max(...used)];
      const at2 = Array.from({ length: LINE }, (_, i) => low + i * (high - low) / (LINE - 1));
      line(at2.map((f) => [f, lorentzian(f, fit.peak, fit.f0, fit.halfWidth)]), colours.ink, [], 1.4);
    }
    points.forEach((point, i) => drawPoint(u, point, x(point.frequency), y, scale, i === chosen));
    ctx.restore();
  };
  var isUsed = (point) => Number.isFinite(point.rate) && !point.failed && point.fitted !== false;
  var isBeyond = (point) => Number.isFinite(point.rate) && !point.failed && point.fitted === false;
  var drawPoint = (u, point, x, y, scale, isChosen) => {
    const { ctx } = u;
    const bottom = u.bbox.top + u.bbox.height - 9 * scale;
    const known = Number.isFinite(point.rate);
    if (known && point.spread > 0) {
      ctx.strokeStyle = colours[MARKS2[point.gait]?.colour ?? "muted"];
      ctx.lineWidth = 1.2 * scale;
      ctx.beginPath();
      ctx.moveTo(x, y(point.rate - point.spread));
      ctx.lineTo(x, y(point.rate + point.spread));
      ctx.stroke();
    }
    if (isChosen) {
      ctx.strokeStyle = colours.accent;
      ctx.lineWidth = 2 * scale;
      ctx.beginPath();
      ctx.arc(x, known && !point.failed ? y(point.rate) : bottom, 10 * scale, 0, 2 * Math.PI);
      ctx.stroke();
    }
    if (known && (!point.failed || point.partlyFailed)) {
      ctx.globalAlpha = isBeyond(point) ? FADED : 1;
      drawMark(ctx, point.gait, x, y(point.rate), RADIUS * scale, point.partlyFailed);
      ctx.globalAlpha = 1;
    }
    if (point.failed) drawMark(ctx, "failed", x, bottom, RADIUS * scale);
  };
  var pickable2 = (below, chart, points, chosen, choose, onPick) => {
    below.tabIndex = 0;
    below.setAttribute("role", "slider");
    below.setAttribute("aria-label", "Points of the spin curve; Enter watches the one that is chosen");
    below.setAttribute("aria-valuenow", "0");
    const nearest = (event) => {
      if (!chart.plot) return -1;
      const f = chart.plot.posToVal(event.clientX - chart.plot.over.getBoundingClientRect().left, "x");
      return points().reduce((best, point, i, all) => best < 0 || Math.abs(point.frequency - f) < Math.abs(all[best].frequency - f) ? i : best, -1);
    };
    below.addEventListener("pointermove", (event) => {
      const index = nearest(event);
      if (index !== chosen()) choose(index);
    });
    below.addEventListener("click", (event) => {
      const index = nearest(event);
      choose(index);
      if (index >= 0) onPick(points()[index]);
    });
    below.addEventListener("keydown", (event) => {
      const last2 = points().length - 1;
      if (last2 < 0) return;
      const at2 = { ArrowRight: chosen() + 1, ArrowUp: chosen() + 1, ArrowLeft: chosen() - 1, ArrowDown: chosen() - 1, Home: 0, End: last2 }[event.key];
      if (at2 !== void 0) choose(Math.min(Math.max(at2, 0), last2));
      else if ((event.key === "Enter" || event.key === " ") && chosen() >= 0) onPick(points()[chosen()]);
      else return;
      event.preventDefault();
    });
  };
  var legendOf3 = (el) => {
    const list = el.appendChild(element("p", "chart-legend"));
    let shown4 = "";
    let marks = [];
    const away2 = onColours(() => marks.forEach(({ draw }) => draw()));
    return {
      update({ points, overlays, fit }) {
        const kinds = Object.keys(MARKS2).filter((kind) => kind === "failed" ? points.some(({ failed: failed2 }) => failed2) : points.some((point) => point.gait === kind && Number.isFinite(point.rate)));
        const partly = points.some(({ partlyFailed }) => partlyFailed);
        const beyond2 = points.some(isBeyond);
        const key = JSON.stringify([kinds, partly, beyond2, overlays.map(({ name }) => name), Boolean(fit && !fit.refused)]);
        if (key === shown4) return;
        shown4 = key;
        marks = kinds.map((kind) => markInLegend(kind, kind || "gait unknown"));
        if (partly) marks.push(markInLegend("", "half-filled: some of the runs failed", true));
        const items = marks.map(({ item }) => item);
        if (beyond2) items.push(element("span", "", "faded: beyond the run-off, left out of the fit"));
        if (fit && !fit.refused) items.push(lineInLegend("ink", 0, "Lorentz fit"));
        overlays.forEach(({ name }, i) => items.push(lineInLegend(OVERLAYS[i % OVERLAYS.length], 2, name)));
        list.replaceChildren(...items);
      },
      destroy() {
        away2();
        list.remove();
      }
    };
  };
  var lineInLegend = (colour, dash, text) => {
    const item = element("span");
    const line = element("i", `line line-${dash}`);
    line.style.color = `var(--${colour})`;
    item.append(line, text);
    return item;
  };

  // src/curve/points.js
  var RUN_OFF = 3;
  var fittedPoints = (points) => {
    const order = points.map((_, i) => i).sort((a, b) => points[a].frequency - points[b].frequency);
    const runsOff = (_, at2) => at2 + RUN_OFF <= order.length && order.slice(at2, at2 + RUN_OFF).every((i) => points[i].failed);
    const end = order.findIndex(runsOff);
    const usable = new Set(end < 0 ? order : order.slice(0, end));
    return points.map(({ rate, failed: failed2 }, i) => usable.has(i) && !failed2 && Number.isFinite(rate));
  };
  var endsInFailure = (points) => {
    const fitted = fittedPoints(points);
    const highest = Math.max(0, ...points.filter((_, i) => fitted[i]).map(({ frequency }) => frequency));
    return points.some(({ frequency, failed: failed2 }) => failed2 && frequency > highest);
  };
  var fitPoints = (points) => {
    const fitted = fittedPoints(points);
    const used = points.filter((_, i) => fitted[i]);
    return fitLorentzian(
      used.map(({ frequency }) => frequency),
      used.map(({ rate }) => rate),
      { endsInFailure: endsInFailure(points) }
    );
  };

  // src/app/exhibits/store.js
  var DEG7 = Math.PI / 180;
  var MOST_ROWS = 300;
  var FREQUENCY2 = "motion.frequency";
  function stored(element2, desk) {
    const { payload, facts } = desk;
    const { parameters, points } = payload;
    if (!parameters?.length || !points?.length) throw new Error("no points in it");
    const store = { ...payload, factors: parameters.map(({ display }) => Object.hasOwn(facts.units, display) ? facts.units[display][0] : 1) };
    const watch = (point) => desk.watch(withValues(structuredClone(payload.scenario), point.set));
    const chart = make("div");
    const rest = make("div", { class: "row wide" });
    element2.append(
      make("p", {}, `${points.length} points over ${parameters.map(wordsOf).join(", ")}. Choose a point and that motion is shown above.`),
      ...(payload.notes ?? []).map((note) => make("p", { class: "note" }, note)),
      rest,
      chart,
      listOf(store, watch)
    );
    const plot = (parameters.length > 1 && payload.grid ? mapOf : curveOf2)(chart, rest, store, watch);
    return { shown: () => plot.resize() };
  }
  var wordsOf = ({ name }) => name.replaceAll(/[._]/g, " ");
  var labelOf = (parameter) => `${wordsOf(parameter)}${parameter.display ? ` (${pretty(parameter.display)})` : ""}`;
  var readable = ({ factors }, k, value) => typeof value === "number" ? value / factors[k] : value;
  function curveOf2(chart, rest, store, watch) {
    const { parameters, points, repeats } = store;
    const plot = spinCurve(chart, { onPick: (picked) => watch(picked.point) });
    const words = make("p", { class: "study-words" });
    chart.append(words);
    const draw = (k) => {
      const over = points.filter((point) => typeof point.at[k] === "number").map((point) => ({
        point,
        frequency: readable(store, k, point.at[k]),
        rate: point.spin_rate ?? NaN,
        spread: point.spread ?? NaN,
        gait: point.gait,
        failure: point.failure ?? "",
        failureTime: point.failure_time ?? NaN,
        failed: point.failed,
        runs: repeats,
        failedRuns: point.failed_runs,
        partlyFailed: point.failed_runs > 0 && point.failed_runs < repeats
      }));
      const isCurve = parameters.length === 1 && parameters[k].name === FREQUENCY2;
      const fit = isCurve ? fitPoints(over) : null;
      const used = isCurve ? fittedPoints(over) : over.map(() => true);
      words.textContent = fitInWords(fit);
      plot.update({ points: over.map((point, i) => ({ ...point, fitted: used[i] })), fit, label: labelOf(parameters[k]), unit: pretty(parameters[k].display) });
    };
    const numbers2 = parameters.map((_, k) => k).filter((k) => points.some((point) => typeof point.at[k] === "number"));
    if (numbers2.length > 1) {
      rest.append(choice("Parameter across", numbers2.map((k) => [String(k), labelOf(parameters[k])]), String(numbers2[0]), (k) => draw(Number(k))));
    }
    draw(numbers2[0] ?? 0);
    return plot;
  }
  function mapOf(chart, rest, store, watch) {
    const { parameters, points, observables } = store;
    const others = parameters.slice(2).map((_, k) => k + 2);
    const fixed = Object.fromEntries(others.map((k) => [k, parameters[k].values[0]]));
    const shown4 = [
      { name: "spin_rate", label: "spin rate", unit: "°/s", of: (point) => (point.spin_rate ?? NaN) / DEG7 },
      ...observables.map(({ name, label, display, scale }) => ({
        name,
        label: label || name,
        unit: pretty(display),
        of: ({ values }) => (values[name] ?? NaN) * (display === "%" ? 100 : scale)
      }))
    ];
    let which = shown4[0];
    let here = /* @__PURE__ */ new Map();
    const plot = heatMap(chart, { onPick: ({ i, j }) => here.has(`${i},${j}`) && watch(here.get(`${i},${j}`)) });
    const [x, y] = parameters;
    const draw = () => {
      const kept2 = points.filter((point) => others.every((k) => point.at[k] === fixed[k]));
      here = new Map(kept2.map((point) => [`${x.values.indexOf(point.at[0])},${y.values.indexOf(point.at[1])}`, point]));
      const cells = new Map([...here].map(([key, point]) => [
        key,
        { value: which.of(point), gait: point.gait, failed: point.failed, failure: point.failure ?? "" }
      ]));
      const axis2 = (k) => ({ label: labelOf(parameters[k]), values: parameters[k].values.map((value) => readable(store, k, value)) });
      plot.update({ x: axis2(0), y: axis2(1), cells, label: which.label, unit: which.unit });
    };
    rest.append(choice("What the map shows", shown4.map(({ name, label }) => [name, label]), which.name, (name) => {
      which = shown4.find((each) => each.name === name);
      draw();
    }), ...others.map((k) => choice(
      wordsOf(parameters[k]),
      parameters[k].values.map((value, i) => [String(i), `${wordsOf(parameters[k])} ${toldOf2(store, k, value)}`]),
      "0",
      (i) => {
        fixed[k] = parameters[k].values[Number(i)];
        draw();
      }
    )));
    draw();
    return plot;
  }
  var toldOf2 = (store, k, value) => {
    const read3 = readable(store, k, value);
    return typeof read3 === "number" ? `${trimmed(read3)} ${pretty(store.parameters[k].display)}`.trim() : String(read3);
  };
  function listOf(store, watch) {
    const { parameters, points } = store;
    const rows = points.slice(0, MOST_ROWS).map((point) => make(
      "tr",
      {},
      ...point.at.map((value, k) => make("td", {}, toldOf2(store, k, value))),
      make("td", {}, point.failed ? point.failure ?? "failed" : `${trimmed((point.spin_rate ?? NaN) / DEG7, 3)} °/s`),
      make("td", {}, point.gait || "–"),
      make("td", {}, button("Watch", () => watch(point)))
    ));
    const head = make(
      "tr",
      {},
      ...parameters.map((parameter) => make("th", { scope: "col" }, wordsOf(parameter))),
      make("th", { scope: "col" }, "spin rate"),
      make("th", { scope: "col" }, "gait"),
      make("th", { scope: "col" }, "the run")
    );
    const body = make("div", { class: "scroll" }, make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows)));
    return make("details", {}, make("summary", {}, `The points as a table${points.length > MOST_ROWS ? ` (the first ${MOST_ROWS})` : ""}`), body);
  }

  // src/app/exhibit.js
  var KINDS = { run: recorded, store: stored, poses: posesBeside, object: cloudOf, steering: steered };
  function exhibit(element2, desk, scenes) {
    const { payload } = desk;
    const build = Object.hasOwn(KINDS, payload.kind) ? KINDS[payload.kind] : null;
    if (!build) {
      element2.append(make("p", { class: "note" }, `This page knows no ${String(payload.kind).slice(0, 40)}.`));
      return {};
    }
    element2.append(make("h2", {}, String(payload.name ?? payload.kind)));
    for (const note of Array.isArray(payload.notes) ? payload.notes : []) element2.append(make("p", { class: "note" }, String(note)));
    try {
      return build(element2, desk, scenes) ?? {};
    } catch (error) {
      element2.append(make("p", { class: "fault", role: "alert" }, `The data in this file are spoilt: ${error.message}`));
      return {};
    }
  }

  // src/app/keys.js
  var KICK = 0.15;
  var HELP = "space: play or pause · , and . : one picture back or on · r: lay down anew · s: slower · f: faster · k: kick";
  function keys(desk) {
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey && event.key === "z" && !typing(event.target)) {
        event.preventDefault();
        desk.undo();
        return;
      }
      if (typing(event.target) || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === " " && event.target.matches("button, summary, select, input")) return;
      const act = {
        " ": () => desk.play(!desk.playing),
        ",": () => desk.step(-1),
        ".": () => desk.step(1),
        r: () => desk.restart(),
        s: () => desk.setSpeed(Math.max(1 / 200, desk.speed / 2)),
        f: () => desk.setSpeed(Math.min(1, desk.speed * 2)),
        k: () => desk.push(desk.selected, { velocity: [0, KICK, 0], spin: 0 }),
        "?": () => desk.tell("notice", HELP)
      }[event.key];
      if (!act) return;
      event.preventDefault();
      act();
    });
  }
  var typing = (element2) => element2.matches?.("input[type='text'], input[type='number'], textarea, select");

  // src/app/layers.js
  var LAYERS = [
    ["contact", "nodes in contact", true],
    ["forces", "friction", true],
    ["legs", "legs", true],
    ["trail", "way and limit", true],
    ["bending", "bending", false]
  ];
  var VIEWS = [["default", "from the side"], ["above", "from above"], ["bar", "along the bar"], ["plate", "with the plate"]];
  function layers(stage, scenes, desk) {
    const on = Object.fromEntries(LAYERS.map(([key, , first]) => [key, first]));
    let factor = 1;
    const apply = () => {
      for (const scene of scenes) {
        scene.view.setLayers(on);
        scene.view.setExaggeration(factor);
      }
      desk.tell("theme");
      for (const scene of scenes) scene.repaint();
    };
    const boxes = LAYERS.map(([key, text, first]) => {
      const box = make("input", { type: "checkbox", checked: first, onchange: () => {
        on[key] = box.checked;
        apply();
      } });
      return make("label", {}, box, text);
    });
    const height = choice(
      "Heights are drawn",
      [["1", "heights as they are"], ["3", "heights × 3"], ["10", "heights × 10"]],
      "1",
      (value) => {
        factor = Number(value);
        apply();
      }
    );
    const from = choice("Seen", VIEWS, "default", (name) => {
      for (const scene of scenes) scene.view.look(name);
      for (const scene of scenes) scene.repaint();
    });
    const kick = button(
      "Kick",
      () => desk.push(desk.selected, { velocity: [0, 0.15, 0], spin: 0 }),
      { title: "A push across the bar (k); or drag on the sheet" }
    );
    const all = make(
      "details",
      { class: "drawn", open: !matchMedia("(max-width: 900px)").matches },
      make("summary", {}, "What is drawn"),
      make("div", { class: "layers", role: "group", "aria-label": "What is drawn" }, ...boxes, height, from, kick)
    );
    stage.append(all);
    apply();
    return { apply };
  }

  // src/charts/energy.js
  var ROWS2 = [
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
    ["residual", "unaccounted for", "residual"]
  ];
  var energyLedger = (el) => {
    const table2 = element("table", "ledger");
    const caption = table2.createCaption();
    caption.textContent = "Energy: nothing yet";
    const body = table2.createTBody();
    const rows = ROWS2.map(([name, label, kind]) => {
      const row2 = body.insertRow();
      const head = element("th", "", label);
      head.scope = "row";
      const bar = element("i", `bar ${kind}`);
      const track = element("td", "track");
      track.append(bar);
      const value = element("td", "value", "–");
      row2.append(head, track, value);
      return { name, row: row2, bar, value };
    });
    el.append(table2);
    return {
      update(ledger) {
        if (!ledger) return;
        const unit = unitFor(Math.max(...rows.map(({ name }) => Math.abs(ledger[name]) || 0)));
        const most = Math.max(...rows.map(({ name }) => Math.abs(ledger[name]) || 0), 1e-300);
        for (const { name, row: row2, bar, value } of rows) {
          const energy = ledger[name];
          bar.style.width = `${(100 * Math.min(1, Math.abs(energy) / most || 0)).toFixed(1)}%`;
          bar.classList.toggle("negative", energy < 0);
          value.textContent = `${read2(unit.scale * energy)} ${unit.name}`;
          row2.hidden = name === "torsion" && energy === 0;
        }
        const share2 = `${read2(100 * ledger.imbalance, 2)} %`;
        caption.textContent = ledger.closes ? `Energy: closes to ${share2}` : `Energy: does not balance, out by ${share2}`;
        caption.classList.toggle("fault", !ledger.closes);
      },
      resize() {
      },
      destroy: () => table2.remove()
    };
  };
  var unitFor = (most) => most < 1e-3 ? { name: "µJ", scale: 1e6 } : most < 1 ? { name: "mJ", scale: 1e3 } : { name: "J", scale: 1 };

  // src/charts/gait.js
  var STRIDES = 6;
  var ROWS3 = [["left", "left leg"], ["right", "right leg"], ["flight", "flight"]];
  var COLOUR = { left: "left", right: "right", flight: "failed" };
  var timesOf = (time, share2, first) => {
    const bars = [];
    for (let i = Math.max(first, 1); i < time.length; i++) {
      if (!(share2[i] >= 0.5)) continue;
      const last2 = bars.at(-1);
      if (last2 && last2[1] === time[i - 1]) last2[1] = time[i];
      else bars.push([time[i - 1], time[i]]);
    }
    return bars;
  };
  var gaitDiagram = (el) => {
    let state = { bars: {}, from: 0, period: 1, shown: 0 };
    const draw = (u) => {
      const { ctx } = u;
      const height = u.bbox.height / ROWS3.length;
      ctx.save();
      ctx.beginPath();
      ctx.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
      ctx.clip();
      ROWS3.forEach(([name], row2) => {
        ctx.fillStyle = colours[COLOUR[name]];
        for (const [from, to] of state.bars[name] ?? []) {
          const [left, right] = [from, to].map((t) => u.valToPos((t - state.from) / state.period, "x", true));
          if (name === "flight") {
            ctx.globalAlpha = 0.16;
            ctx.fillRect(left, u.bbox.top, right - left, u.bbox.height);
            ctx.globalAlpha = 1;
          }
          ctx.fillRect(left, u.bbox.top + (row2 + 0.2) * height, Math.max(right - left, 1), 0.6 * height);
        }
      });
      ctx.restore();
    };
    const chart = plotIn(el, {
      scales: { x: { time: false, range: () => [0, STRIDES] }, y: { range: () => [0, ROWS3.length] } },
      series: [{}, { show: false }],
      axes: [
        axis("plate periods", { splits: () => Array.from({ length: STRIDES + 1 }, (_, i) => i) }),
        axis("", {
          size: 66,
          grid: { show: false },
          ticks: { show: false },
          splits: () => ROWS3.map((_, i) => ROWS3.length - i - 0.5),
          values: () => ROWS3.map(([, label]) => label)
        })
      ],
      hooks: { draw: [draw] }
    }, [[0, STRIDES], [null, null]]);
    chart.describe("Gait diagram: nothing yet");
    return {
      update({ time, left, right, flight, period, gait: gait2 = "" }) {
        const end = time.length ? time[time.length - 1] : 0;
        const from = Math.max(0, Math.floor(end / period + 1e-6) - STRIDES) * period;
        let first = time.length;
        while (first > 0 && time[first - 1] > from) first--;
        const shares = { left, right, flight };
        const bars = Object.fromEntries(ROWS3.map(([name]) => [name, timesOf(time, shares[name], first)]));
        state = { bars, from, period };
        chart.update([[0, STRIDES], [null, null]]);
        const shown4 = Math.min(end - from, STRIDES * period) || 1;
        const told3 = (name) => `${Math.round(100 * bars[name].reduce((sum2, [a, b]) => sum2 + b - a, 0) / shown4)} %`;
        chart.describe(`Gait diagram of the last ${STRIDES} plate periods${gait2 ? `, ${gait2}` : ""}: the left leg touches ${told3("left")} of the time, the right leg ${told3("right")}; in flight ${told3("flight")}`);
      },
      resize: chart.resize,
      destroy: chart.destroy
    };
  };

  // src/simulation/energy.js
  var LEDGER_TOLERANCE = 0.05;
  var LEAST_LIFT = 1e-3;
  var BEGUN = ["kinetic", "axial", "bending", "torsion", "contact"];
  var leastEnergy = (weight, size) => weight * LEAST_LIFT * size;
  var energyLedger2 = (channels, least2 = 0) => {
    const [contactEnergy, gravity] = [channels.contact_energy, channels.gravity_energy];
    const sums = { work: 0, contactWork: 0, joint: 0, friction: 0, exchanged: 0 };
    let [largestGap, lowest, at2] = [-Infinity, Infinity, null];
    for (let i = 0; i < channels.time.length; i++) {
      sums.work += channels.plate_work[i];
      sums.exchanged += Math.abs(channels.plate_work[i]);
      sums.contactWork += channels.contact_work[i];
      sums.joint += channels.joint_loss[i];
      sums.friction += channels.friction_loss[i];
      at2 = {
        kinetic: channels.kinetic_energy[i] - channels.kinetic_energy[0],
        gravity: gravity[i] - gravity[0],
        axial: channels.axial_energy[i] - channels.axial_energy[0],
        bending: channels.bending_energy[i] - channels.bending_energy[0],
        torsion: channels.torsion_energy[i] - channels.torsion_energy[0],
        contactStored: contactEnergy[i] - contactEnergy[0]
      };
      at2.elastic = at2.axial + at2.bending + at2.torsion;
      const stored2 = at2.kinetic + at2.gravity + at2.elastic + at2.contactStored;
      const contactLoss = sums.contactWork - at2.contactStored;
      const lost = sums.joint + contactLoss + sums.friction;
      largestGap = Math.max(
        largestGap,
        Math.abs(sums.work - stored2 - lost),
        stored2 - sums.work,
        -sums.joint,
        -contactLoss,
        -sums.friction
      );
      lowest = Math.min(lowest, at2.gravity);
    }
    const begun = BEGUN.reduce((sum2, name) => sum2 + Math.abs(channels[`${name}_energy`][0]), 0);
    const ledger = {
      plateWork: sums.work,
      ...at2,
      jointLoss: sums.joint,
      contactLoss: sums.contactWork - at2.contactStored,
      frictionLoss: sums.friction,
      given: sums.exchanged + begun - lowest + least2,
      largestGap: largestGap + 0
    };
    return balanced(ledger);
  };
  var balanced = (ledger) => {
    const { kinetic, gravity, elastic, contactStored, jointLoss, contactLoss, frictionLoss } = ledger;
    const accounted = kinetic + gravity + elastic + contactStored + jointLoss + contactLoss + frictionLoss;
    const residual = ledger.plateWork - accounted;
    const imbalance = share(ledger.largestGap, ledger.given);
    return {
      ...ledger,
      residual,
      relativeResidual: share(residual, ledger.given),
      imbalance,
      closes: imbalance <= LEDGER_TOLERANCE
    };
  };
  var share = (energy, given2) => given2 !== 0 ? energy / given2 : energy === 0 ? 0 : NaN;

  // src/simulation/registry.js
  var finiteMean = (values) => values.length ? mean(values) : NaN;
  var drift = ({ channels, period }) => {
    const { time } = channels;
    let furthest2 = NaN;
    slip(time, channels.centre_x, channels.centre_y, period).forEach((way, i) => {
      if (Number.isFinite(way) && isAveraged(time, i, time.length - 1, period) && !(way <= furthest2)) furthest2 = way;
    });
    return furthest2;
  };
  var bendingAmplitude = ({ channels, start, end }) => {
    let largest = -Infinity;
    channels.bend_rms.forEach((angle, i) => {
      if (channels.time[i] > start && channels.time[i] <= end) largest = Math.max(largest, angle);
    });
    return largest === -Infinity ? NaN : largest;
  };
  var platePower = ({ channels, start, end }) => {
    if (end <= start) return NaN;
    let work = 0;
    channels.plate_work.forEach((given2, i) => {
      if (channels.time[i] > start && channels.time[i] <= end) work += given2;
    });
    return work / (end - start);
  };
  var velocity = (which) => (window2) => window2.twist.mean[which];
  var strideCovariance = (one, other) => (window2) => window2.twist.covariance[one][other];
  var TWIST = ["velocity along the bar", "velocity across the bar", "spin rate"];
  var covariances = [
    [0, 0, "m^2/s^2", "mm^2/s^2"],
    [0, 1, "m^2/s^2", "mm^2/s^2"],
    [1, 1, "m^2/s^2", "mm^2/s^2"],
    [0, 2, "m*rad/s^2", "mm*deg/s^2"],
    [1, 2, "m*rad/s^2", "mm*deg/s^2"],
    [2, 2, "rad^2/s^2", "deg^2/s^2"]
  ].map(([one, other, unit, display]) => ({
    name: `twist_${"xyw"[one]}${"xyw"[other]}`,
    unit,
    display,
    longName: `covariance over strides of the ${TWIST[one]} and the ${TWIST[other]}`,
    measure: strideCovariance(one, other)
  }));
  var OBSERVABLES = [
    {
      name: "drift",
      unit: "m",
      display: "mm",
      longName: "furthest slip of the centre",
      label: "drift of the centre",
      measure: drift
    },
    {
      name: "velocity_x",
      unit: "m/s",
      display: "mm/s",
      longName: "mean velocity of the centre along the bar, plate frame",
      label: "velocity along the bar",
      measure: velocity(0)
    },
    {
      name: "velocity_y",
      unit: "m/s",
      display: "mm/s",
      longName: "mean velocity of the centre across the bar, plate frame",
      label: "velocity across the bar",
      measure: velocity(1)
    },
    ...covariances,
    {
      name: "contact_fraction",
      unit: "1",
      display: "%",
      longName: "mean share of the nodes that touch",
      label: "nodes in contact",
      measure: (window2) => finiteMean(window2.means("contact"))
    },
    {
      name: "flight_fraction",
      unit: "1",
      display: "%",
      longName: "share of the time in which nothing touches",
      label: "time in flight",
      measure: (window2) => finiteMean(window2.means("flight"))
    },
    {
      name: "bending_amplitude",
      unit: "rad",
      display: "deg",
      longName: "largest rms angle of the bending joints",
      label: "bending amplitude",
      measure: bendingAmplitude
    },
    {
      name: "rim_lift",
      unit: "m",
      display: "mm",
      longName: "greatest height of the object above the plate in each plate period, in the mean",
      label: "lift of the rim",
      measure: (window2) => finiteMean(window2.maxima("height_high"))
    },
    {
      name: "plate_power",
      unit: "W",
      display: "mW",
      longName: "mean power of the plate",
      label: "plate power",
      measure: platePower
    },
    {
      name: "energy_residual",
      unit: "1",
      longName: "energy unaccounted for at the end over the energy given",
      overRuns: "worst",
      measure: (window2) => window2.energy.relativeResidual
    },
    {
      name: "energy_imbalance",
      unit: "1",
      longName: "furthest that the energy was out of balance, over the energy given",
      overRuns: "worst",
      measure: (window2) => window2.energy.imbalance
    }
  ];
  var SCALES = {
    mm: 1e3,
    "mm/s": 1e3,
    "mm^2/s^2": 1e6,
    "mm*deg/s^2": 1e3 * (180 / Math.PI),
    "deg^2/s^2": (180 / Math.PI) ** 2,
    deg: 180 / Math.PI,
    "deg/s": 180 / Math.PI,
    mW: 1e3,
    "%": 100
  };
  var scaleOf = ({ display }) => SCALES[display] ?? 1;

  // src/simulation/observe.js
  var least = ({ sheet, gravity }) => {
    const { rest } = latticeOf(sheet);
    const sides = [0, 1].map((axis2) => {
      const along = rest.filter((_, i) => i % 2 === axis2);
      return along.reduce((most, place) => Math.max(most, place), -Infinity) - along.reduce((low, place) => Math.min(low, place), Infinity);
    });
    return leastEnergy(sheet.mass * gravity, (Math.max(...sides) + 1) * sheet.pitch);
  };

  // src/app/now.js
  var EVERY = [40, 250];
  var PICTURES3 = 32;
  var COURSE = 4;
  var DEG8 = Math.PI / 180;
  var NUMBERS3 = [
    ["gait", (read3) => read3.failure ? `${read3.failure.kind}` : read3.gait || "–"],
    ["spin rate", (read3) => `${trimmed(read3.rate / DEG8, 3)} °/s`],
    ["along the bar", (read3) => `${trimmed(read3.twist[0] * 1e3, 2)} mm/s`],
    ["across the bar", (read3) => `${trimmed(read3.twist[1] * 1e3, 2)} mm/s`],
    ["drift", (read3) => `${trimmed(read3.drift * 1e3, 3)} mm`],
    ["turned", (_, now) => `${trimmed(now.turned / DEG8, 4)}°`],
    ["nodes touching", (_, now) => `${Math.round(100 * now.contact)} %`],
    ["bending, r.m.s.", (_, now) => `${trimmed(now.bending / DEG8, 2)}°`],
    ["plate force, upright", (_, now) => `${trimmed(now.force, 3)} N`],
    ["energy books", (_, now) => now.books]
  ];
  function nowTab(element2, desk, scenes) {
    const inSight = /* @__PURE__ */ new Set();
    const sight = new IntersectionObserver((entries) => entries.forEach(({ target, isIntersecting }) => isIntersecting ? inSight.add(target) : inSight.delete(target)));
    const all = [];
    const parts = [];
    const values = NUMBERS3.map(([name]) => [name, make("dd", {}, "–")]);
    const numbers2 = make("dl", { class: "readings" }, ...values.map(([name, dd]) => make("div", {}, make("dt", {}, name), dd)));
    const charts = make("div", { class: "charts" });
    element2.append(numbers2, charts);
    sight.observe(numbers2);
    const figure = (title, chartIn, show) => {
      const hold = make("div");
      charts.append(make("figure", {}, make("figcaption", {}, title), hold));
      sight.observe(hold);
      const chart = chartIn(hold);
      all.push(chart);
      parts.push([hold, (live) => show(chart, live)]);
    };
    parts.push([numbers2, () => {
      const both = desk.seats.map(({ live }, k) => [scenes[k]?.read, live.samples.length < 4 ? null : nowOf(live)]);
      NUMBERS3.forEach(([, say], k) => {
        const words = both.map(([own, its]) => own && its ? say(own, its) : "–");
        const text = words.length > 1 ? words.map((word, j) => `${"AB"[j]} ${word}`).join("\n") : words[0];
        if (values[k][1].textContent !== text) values[k][1].textContent = text;
      });
    }]);
    figure("Gait: when each leg touches", gaitDiagram, (chart, live) => {
      const { time, left_contact: left, right_contact: right, flight } = courseOf(live);
      chart.update({ time, left, right, flight, period: periodOf(live.scenario.motion), gait: scenes[desk.selected]?.read?.gait });
    });
    figure(
      "Spin rate over each period, deg/s",
      (hold) => timeSeries(hold, { series: [{ label: "spin rate", colour: "--accent" }], unit: "deg/s" }),
      (chart, live) => {
        const [time, rate] = ratesOf(live);
        chart.update({ time, values: [rate] });
      }
    );
    figure(
      "Drift of the centre, mm",
      (hold) => timeSeries(hold, { series: [{ label: "drift", colour: "--walking" }], unit: "mm" }),
      (chart, live) => {
        const [time, drift2] = driftOf(live);
        chart.update({ time, values: [drift2], limit: { value: live.scenario.slip_limit * 1e3, label: "fails" } });
      }
    );
    figure("Force on the plate, N, and torque, mN m", (hold) => timeSeries(hold, {
      series: [
        { label: "along", colour: "--left" },
        { label: "across", colour: "--right" },
        { label: "down", colour: "--running" },
        { label: "torque about the bar", colour: "--failed" }
      ],
      unit: ""
    }), (chart, live) => chart.update(forcesOf(live)));
    figure(
      "Bending, r.m.s., deg",
      (hold) => timeSeries(hold, { series: [{ label: "bending", colour: "--running" }], unit: "deg" }),
      (chart, live) => {
        const { time, bend_rms: bending } = courseOf(live);
        chart.update({ time, values: [Float64Array.from(bending, (each) => each / DEG8)] });
      }
    );
    figure("Where the plate's work went, since it was laid down", energyLedger, (chart, live) => chart.update(ledgerOf(live)));
    let shown4 = false;
    let turn = 0;
    let last2 = performance.now();
    let before = last2;
    let between = 1e3 / PICTURES3;
    const update = () => {
      const now = performance.now();
      between += 0.1 * (Math.min(now - before, 500) - between);
      before = now;
      if (!shown4 || now - last2 < (between > 1e3 / PICTURES3 ? EVERY[1] : EVERY[0])) return;
      const { live } = desk.seats[desk.selected];
      if (live.samples.length < 4) return;
      last2 = now;
      for (let tried = 0; tried < parts.length; tried++) {
        const [place, show] = parts[turn++ % parts.length];
        if (!inSight.has(place)) continue;
        show(live);
        return;
      }
    };
    desk.on("drawn", update);
    desk.on("theme", () => all.forEach((chart) => chart.resize()));
    new ResizeObserver(() => shown4 && all.forEach((chart) => chart.resize())).observe(charts);
    return {
      shown: () => {
        shown4 = true;
        all.forEach((chart) => chart.resize());
      },
      hidden: () => {
        shown4 = false;
      }
    };
  }
  function courseOf({ samples }) {
    const end = samples.channels.time[samples.length - 1];
    return samples.from(samples.indexAfter(end - COURSE));
  }
  function ratesOf(live) {
    const { time, spin_cross: cross2, spin_dot: dot3 } = courseOf(live);
    return perPeriod(time, rotation(cross2, dot3), periodOf(live.scenario.motion));
  }
  function driftOf(live) {
    const all = live.samples.all();
    const period = periodOf(live.scenario.motion);
    const drifts = slip(all.time, all.centre_x, all.centre_y, period);
    const { time } = courseOf(live);
    const begin2 = live.samples.length - time.length;
    const end = time[time.length - 1] - period / 2;
    return [time, Float64Array.from(time, (each, k) => each <= end ? drifts[begin2 + k] * 1e3 : NaN)];
  }
  var ledgerOf = (live) => energyLedger2(live.samples.all(), least(live.scenario));
  function nowOf(live) {
    const { samples, frame } = live;
    const ledger = ledgerOf(live);
    const recent = samples.from(Math.max(0, samples.length - 25));
    const mean2 = (values) => values.reduce((sum2, each) => sum2 + each, 0) / values.length;
    const whole2 = rotation(samples.all().spin_cross, samples.all().spin_dot);
    return {
      turned: whole2[whole2.length - 1] - whole2[0],
      contact: mean2(recent.contact),
      bending: mean2(recent.bend_rms),
      force: frame?.plate ? -frame.plate[2] : NaN,
      books: `close to ${trimmed(ledger.imbalance * 100, 2)} %`
    };
  }
  function perPeriod(time, angle, period) {
    const times = [];
    const rates = [];
    let from = 0;
    for (let k = 1; k < time.length; k++) {
      if (time[k] - time[from] < period - 1e-9) continue;
      times.push(time[k]);
      rates.push((angle[k] - angle[from]) / (time[k] - time[from]) / DEG8);
      from = k;
    }
    return [times, rates];
  }
  function forcesOf(live) {
    const frames = live.frames.list.slice(-160).filter((frame) => frame.plate);
    const pick = (k, by) => frames.map((frame) => frame.plate[k] * by);
    return { time: frames.map((frame) => frame.time), values: [pick(0, 1), pick(1, 1), pick(2, -1), pick(3, 1e3)] };
  }

  // src/app/save.js
  function saveText(name, text, type = "text/plain") {
    const address = URL.createObjectURL(new Blob([text], { type }));
    const link = document.createElement("a");
    link.href = address;
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(address), 1e3);
  }
  async function copyText(text) {
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      return false;
    }
  }

  // src/view/camera.js
  var import_three = __toESM(require_three(), 1);
  var RAD = Math.PI / 180;
  var FIELD_OF_VIEW = 24;
  var LOWEST = -20 * RAD;
  var HIGHEST = 89.9 * RAD;
  var NEAREST = 0.25;
  var FURTHEST = 6;
  var WIDE = 0.9;
  var HIGH = 0.74;
  var HIGH_FROM_ABOVE = 0.18;
  var VIEWS2 = {
    default: { azimuth: -24 * RAD, elevation: 27 * RAD },
    above: { azimuth: -90 * RAD, elevation: HIGHEST },
    bar: { azimuth: 0, elevation: 5 * RAD },
    plate: { azimuth: -24 * RAD, elevation: 27 * RAD, riding: true }
  };
  var ViewCamera = class {
    constructor() {
      this.camera = new import_three.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 10);
      this.camera.up.set(0, 0, 1);
      this.target = new import_three.Vector3();
      this.corners = [[0.06, 0.06]];
      this.reach = 0.06;
      this.zoom = 1;
      this.riding = false;
      this.named = "default";
      this.aspect = 1.5;
      this.panned = false;
      this.corner = new import_three.Vector3();
      this.look("default");
    }
    /** @param {number[][]} corners of what should be in the picture, on the plate, m */
    frame(corners2) {
      this.corners = corners2;
      this.reach = Math.max(...corners2.map(([x, y]) => Math.hypot(x, y)));
      this.look(this.named);
    }
    setAspect(aspect) {
      this.aspect = Math.max(aspect, 0.05);
      this.place();
    }
    /** @param {string} name of `VIEWS`; whether there is such a view */
    look(name) {
      const view = VIEWS2[name];
      if (!view) return false;
      Object.assign(this, { riding: false, ...view, named: name });
      this.zoom = 1;
      this.panned = false;
      this.target.set(0, 0, 0);
      this.place();
      return true;
    }
    orbit(byAzimuth, byElevation) {
      this.azimuth = (this.azimuth + byAzimuth) % (2 * Math.PI);
      this.elevation = Math.min(HIGHEST, Math.max(LOWEST, this.elevation + byElevation));
      this.place();
    }
    zoomBy(factor) {
      this.zoom = Math.min(FURTHEST, Math.max(NEAREST, this.zoom * factor));
      this.place();
    }
    /** Move what is looked at by shares of the picture's height: to the right and up. */
    pan(right, up) {
      const seen = this.seen(), { azimuth: a, elevation: e } = this;
      this.panned = true;
      this.target.x += seen * (-Math.sin(a) * right - Math.cos(a) * Math.sin(e) * up);
      this.target.y += seen * (Math.cos(a) * right - Math.sin(a) * Math.sin(e) * up);
      this.target.z += seen * Math.cos(e) * up;
      this.place();
    }
    /** Keep a place in the picture, as long as nobody has moved it by hand; whether the picture moved. */
    follow(x, y) {
      if (this.panned) return false;
      const room = 0.4 * this.reach * Math.max(this.zoom, 0.5);
      const dx = x - this.target.x, dy = y - this.target.y, off = Math.hypot(dx, dy);
      if (off <= room) return false;
      this.target.x += dx * (off - room) / off;
      this.target.y += dy * (off - room) / off;
      this.place();
      return true;
    }
    /** Height of the picture at the target, m. */
    seen() {
      return 2 * this.distance * Math.tan(FIELD_OF_VIEW * RAD / 2);
    }
    place() {
      const { camera } = this;
      this.distance = this.zoom * this.fitting();
      const flat = Math.cos(this.elevation);
      camera.position.set(flat * Math.cos(this.azimuth), flat * Math.sin(this.azimuth), Math.sin(this.elevation));
      camera.position.multiplyScalar(this.distance).add(this.target);
      camera.near = this.distance / 20;
      camera.far = this.distance * 12;
      camera.aspect = this.aspect;
      camera.updateProjectionMatrix();
      camera.lookAt(this.target);
      camera.updateMatrixWorld();
    }
    /** How far off all of the plate is in the picture, m. */
    fitting() {
      const tall = Math.tan(FIELD_OF_VIEW * RAD / 2), { azimuth: a, elevation: e } = this;
      const filled = HIGH + HIGH_FROM_ABOVE * Math.sin(e) ** 4;
      let distance = 0;
      for (const [x, y] of this.corners) {
        const right = -Math.sin(a) * x + Math.cos(a) * y, inward = Math.cos(a) * x + Math.sin(a) * y;
        const up = -Math.sin(e) * inward, near = Math.cos(e) * inward;
        const wide = Math.abs(right) / (this.aspect * WIDE), high = Math.abs(up) / filled;
        distance = Math.max(distance, near + Math.max(wide, high) / tall);
      }
      return Math.max(distance, 1e-3);
    }
  };

  // src/view/colours.js
  var NAMES2 = {
    paper: "#fdfdfb",
    panel: "#f3f3ef",
    ink: "#1b1d22",
    muted: "#575c66",
    line: "#d5d5cf",
    accent: "#0b5cad",
    failed: "#c2410c",
    left: "#0072b2",
    right: "#b06f00",
    sheet: "#e8b04a",
    plate: "#c9ced6"
  };
  var BENT = [[0, 114, 178], [247, 247, 247], [213, 94, 0]].map((c) => c.map((v) => v / 255));
  var HIGH2 = [[0, 32, 77], [124, 123, 120], [255, 234, 70]].map((c) => c.map((v) => v / 255));
  var interpreter = null;
  var components = (text, otherwise) => {
    interpreter ??= document.createElement("canvas").getContext("2d");
    interpreter.fillStyle = otherwise;
    interpreter.fillStyle = text || otherwise;
    const plain3 = interpreter.fillStyle;
    const numbers2 = plain3.startsWith("#") ? [1, 3, 5].map((k) => parseInt(plain3.slice(k, k + 2), 16)) : plain3.match(/[\d.]+/g).slice(0, 3).map(Number);
    return numbers2.map((value) => value / 255);
  };
  var coloursAt = (element2) => {
    const style = getComputedStyle(element2);
    const colours2 = {};
    for (const [name, otherwise] of Object.entries(NAMES2))
      colours2[name] = components(style.getPropertyValue(`--${name}`).trim(), otherwise);
    return { ...colours2, dark: brightness(colours2.paper) < 0.4, font: style.fontFamily || "sans-serif" };
  };
  var brightness = ([red, green, blue]) => 0.3 * red + 0.6 * green + 0.1 * blue;
  var css = ([red, green, blue], alpha = 1) => `rgba(${Math.round(255 * red)}, ${Math.round(255 * green)}, ${Math.round(255 * blue)}, ${alpha})`;
  var mix = (a, b, share2) => a.map((value, k) => value + share2 * (b[k] - value));

  // src/view/frame.js
  var FRAME_SIZE = 12;
  var plateFrame = (pose, height, frame) => {
    const cx = Math.cos(pose[3]), cy = Math.cos(pose[4]), cz = Math.cos(pose[5]);
    const sx = Math.sin(pose[3]), sy = Math.sin(pose[4]), sz = Math.sin(pose[5]);
    frame[0] = cy * cz;
    frame[1] = -cy * sz;
    frame[2] = sy;
    frame[3] = cx * sz + sx * sy * cz;
    frame[4] = cx * cz - sx * sy * sz;
    frame[5] = -sx * cy;
    frame[6] = sx * sz - cx * sy * cz;
    frame[7] = sx * cz + cx * sy * sz;
    frame[8] = cx * cy;
    frame[9] = pose[0] + height * frame[2];
    frame[10] = pose[1] + height * frame[5];
    frame[11] = pose[2] + height * (frame[8] - 1);
    return frame;
  };
  var ontoPlate = (frame, points, into, count = points.length / 3) => {
    const ax = frame[0], bx = frame[1], nx = frame[2], ay = frame[3], by = frame[4], ny = frame[5];
    const az = frame[6], bz = frame[7], nz = frame[8], ox = frame[9], oy = frame[10], oz = frame[11];
    for (let k = 0; k < 3 * count; k += 3) {
      const x = points[k] - ox, y = points[k + 1] - oy, z = points[k + 2] - oz;
      into[k] = ax * x + ay * y + az * z;
      into[k + 1] = bx * x + by * y + bz * z;
      into[k + 2] = nx * x + ny * y + nz * z;
    }
    return into;
  };
  var intoWorld = (frame, x, y, z, into) => {
    for (let d = 0; d < 3; d++) into[d] = frame[3 * d] * x + frame[3 * d + 1] * y + frame[3 * d + 2] * z + frame[9 + d];
    return into;
  };
  var allFinite = (values) => {
    for (let k = 0; k < values.length; k++) if (!(Math.abs(values[k]) < 1e6)) return false;
    return true;
  };

  // src/view/loads.js
  var RADIUS2 = 0.15;
  var LEAST_RADIUS = 0.07;
  var MOST_RADIUS = 0.42;
  var LENGTH2 = 0.8;
  var MOST_LENGTH = 2.4;
  var LEAST_LENGTH = 0.16;
  var nodeShare = ({ sheet, gravity }, nNodes) => Math.max(sheet.mass * Math.max(gravity, 0.1) / nNodes, 1e-12);
  var discRadius = (normal, share2) => Math.min(Math.max(RADIUS2 * Math.sqrt(normal / share2), LEAST_RADIUS), MOST_RADIUS);
  var arrowLength = (fx, fy, share2) => {
    const length = Math.min(LENGTH2 * Math.hypot(fx, fy) / share2, MOST_LENGTH);
    return length > LEAST_LENGTH ? length : 0;
  };

  // src/view/notes.js
  var import_three2 = __toESM(require_three(), 1);
  var WIDTH = 220;
  var LINE2 = 22;
  var BAR = 46;
  var MARGIN = 8;
  var VERTEX = (
    /* glsl */
    `
  uniform vec2 uViewport, uSize;
  uniform float uMargin;
  varying vec2 vUv;
  void main() {
    vUv = position.xy;
    vec2 px = vec2(uViewport.x - uMargin - uSize.x, uMargin) + position.xy * uSize;
    gl_Position = vec4(px / uViewport * 2.0 - 1.0, 0.0, 1.0);
  }
`
  );
  var FRAGMENT = (
    /* glsl */
    `
  uniform sampler2D uPicture;
  varying vec2 vUv;
  void main() {
    gl_FragColor = texture2D(uPicture, vUv);
  }
`
  );
  var scaleInWords = (bent, most) => bent === "height" ? ["0", `${plain(1e3 * most)} mm high`] : [`−${plain(most)}`, `curvature ${plain(most)} /m`];
  var plain = (value) => String(Number(value.toPrecision(3)));
  var Notes = class {
    constructor(shared) {
      this.canvas = document.createElement("canvas");
      this.texture = null;
      this.uniforms = {
        uViewport: shared.uViewport,
        uSize: { value: new import_three2.Vector2() },
        uMargin: { value: 0 },
        uPicture: { value: null }
      };
      const material = new import_three2.ShaderMaterial({
        vertexShader: VERTEX,
        fragmentShader: FRAGMENT,
        uniforms: this.uniforms,
        transparent: true,
        depthTest: false,
        depthWrite: false
      });
      const geometry = new import_three2.BufferGeometry();
      geometry.setAttribute("position", new import_three2.BufferAttribute(Float32Array.from([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]), 3));
      geometry.setIndex([0, 1, 2, 0, 2, 3]);
      this.mesh = new import_three2.Mesh(geometry, material);
      this.mesh.frustumCulled = false;
      this.mesh.renderOrder = 20;
      this.mesh.visible = false;
      this.said = {};
    }
    /** @param {Said} what @param {object} colours of the page @param {number} ratio pixels of the picture over CSS px */
    say(what, colours2, ratio) {
      const { said: said2 } = this, same = Object.keys(what).every((key) => said2[key] === what[key]);
      if (same && said2.colours === colours2 && said2.ratio === ratio) return;
      Object.assign(said2, what, { colours: colours2, ratio });
      const lines = (what.exaggerated !== 1 ? 1 : 0) + (what.bent ? 1 : 0);
      this.mesh.visible = lines > 0;
      if (lines === 0) return;
      const tall = (what.exaggerated !== 1 ? LINE2 : 0) + (what.bent ? BAR : 0);
      this.canvas.width = Math.round(WIDTH * ratio);
      this.canvas.height = Math.round(tall * ratio);
      const pen = this.canvas.getContext("2d");
      pen.scale(ratio, ratio);
      drawNotes(pen, what, colours2, WIDTH);
      this.upload(ratio);
    }
    /** A texture keeps the size it was made with. */
    upload(ratio) {
      this.texture?.dispose();
      this.texture = new import_three2.CanvasTexture(this.canvas);
      this.texture.minFilter = this.texture.magFilter = import_three2.LinearFilter;
      this.texture.generateMipmaps = false;
      this.uniforms.uPicture.value = this.texture;
      this.uniforms.uSize.value.set(this.canvas.width, this.canvas.height);
      this.uniforms.uMargin.value = Math.round(MARGIN * ratio);
    }
    dispose() {
      this.texture?.dispose();
      this.mesh.geometry.dispose();
      this.mesh.material.dispose();
    }
  };
  var drawNotes = (pen, { exaggerated, bent, most }, { ink, font }, width) => {
    let y = 0;
    pen.font = `13px ${font}`;
    pen.fillStyle = css(ink);
    pen.textBaseline = "middle";
    if (exaggerated !== 1) {
      pen.textAlign = "right";
      pen.fillText(`heights drawn × ${exaggerated}`, width - 2, y + LINE2 / 2);
      y += LINE2;
    }
    if (!bent) return;
    const colours2 = bent === "height" ? HIGH2 : BENT;
    const fall = pen.createLinearGradient(20, 0, width - 2, 0);
    colours2.forEach((colour, k) => fall.addColorStop(k / 2, css(colour)));
    pen.fillStyle = fall;
    pen.fillRect(20, y + 6, width - 22, 10);
    pen.strokeStyle = css(ink, 0.5);
    pen.strokeRect(20.5, y + 6.5, width - 23, 9);
    pen.fillStyle = css(ink);
    const [low, high] = scaleInWords(bent, most);
    pen.textAlign = "left";
    pen.fillText(low, 18, y + 30);
    pen.textAlign = "right";
    pen.fillText(high, width - 2, y + 30);
  };

  // src/view/lines.js
  var import_three4 = __toESM(require_three(), 1);

  // src/view/copies.js
  var import_three3 = __toESM(require_three(), 1);
  var Copies = class {
    /**
     * @param {number[][]} corners x and y of the shape's, which come as the attribute `position`
     * @param {number[]} index three corners a triangle
     * @param {number} most copies
     * @param {Record<string, number>} fields attributes that differ from copy to copy, and how many numbers each has
     */
    constructor(corners2, index, most, fields) {
      Object.assign(this, { each: corners2.length, perCopy: index.length, fields });
      this.geometry = new import_three3.BufferGeometry();
      const n = corners2.length, places = new Float32Array(3 * n * most), triangles = new Uint32Array(index.length * most);
      for (let copy = 0; copy < most; copy++) {
        corners2.forEach(([x, y], k) => places.set([x, y], 3 * (copy * n + k)));
        index.forEach((corner, k) => triangles[copy * index.length + k] = copy * n + corner);
      }
      this.geometry.setAttribute("position", new import_three3.BufferAttribute(places, 3));
      this.geometry.setIndex(new import_three3.BufferAttribute(triangles, 1));
      this.values = {};
      for (const [name, size] of Object.entries(fields)) {
        this.values[name] = new Float32Array(size * most);
        const attribute = new import_three3.BufferAttribute(new Float32Array(size * n * most), size).setUsage(import_three3.DynamicDrawUsage);
        this.geometry.setAttribute(name, attribute);
      }
      this.geometry.setDrawRange(0, 0);
    }
    /** Draw the first copies from now on, as their values are. */
    upload(count) {
      this.geometry.setDrawRange(0, this.perCopy * count);
      if (count === 0) return;
      for (const name in this.fields) {
        const size = this.fields[name], from = this.values[name], attribute = this.geometry.attributes[name];
        const to = attribute.array;
        for (let copy = 0, at2 = 0; copy < count; copy++)
          for (let k = 0; k < this.each; k++)
            for (let d = 0; d < size; d++) to[at2++] = from[size * copy + d];
        attribute.clearUpdateRanges();
        attribute.addUpdateRange(0, size * this.each * count);
        attribute.needsUpdate = true;
      }
    }
    dispose() {
      this.geometry.dispose();
    }
  };
  var QUAD = [0, 1, 2, 0, 2, 3];

  // src/view/lines.js
  var VERTEX2 = (
    /* glsl */
    `
  uniform vec2 uViewport;
  uniform float uWidth, uRatio;
  attribute vec3 start, end;
  attribute vec2 along;
  varying float vAlong;
  varying float vAcross;
  void main() {
    vec4 a = projectionMatrix * (modelViewMatrix * vec4(start, 1.0));
    vec4 b = projectionMatrix * (modelViewMatrix * vec4(end, 1.0));
    vec2 way = (b.xy / b.w - a.xy / a.w) * uViewport;
    float far = length(way);
    way = far > 1e-6 ? way / far : vec2(1.0, 0.0);
    vec4 at = position.x > 0.5 ? b : a;
    // A pixel more all around, over which the edge softens; and the ends overlap, so that corners are closed.
    float wide = uWidth * uRatio, half_ = 0.5 * wide + 0.75;
    vec2 shift = vec2(-way.y, way.x) * position.y * half_ + way * (2.0 * position.x - 1.0) * 0.4 * wide;
    at.xy += shift / uViewport * 2.0 * at.w;
    vAlong = mix(along.x, along.y, position.x);
    vAcross = position.y * half_;
    gl_Position = at;
  }
`
  );
  var FRAGMENT2 = (
    /* glsl */
    `
  uniform vec3 uColour, uHalo;
  uniform float uWidth, uRatio, uDash, uClear;
  varying float vAlong, vAcross;
  void main() {
    float inwards = 0.5 * uWidth * uRatio + 0.5 - abs(vAcross), alpha = clamp(inwards, 0.0, 1.0);
    float core = clamp(inwards - uRatio, 0.0, 1.0);
    if (uDash > 0.0) {
      float px = fwidth(vAlong) / uDash + 1e-6;
      alpha *= clamp((0.28 - abs(fract(vAlong / uDash) - 0.5)) / px + 0.5, 0.0, 1.0);
    }
    gl_FragColor = vec4(mix(uHalo, uColour, core), alpha * uClear * mix(0.7, 1.0, core));
  }
`
  );
  var Lines = class {
    /**
     * @param {number} most pieces
     * @param {object} shared uniforms
     * @param {{width?: number, dash?: number}} [look] width, CSS px; dash, m, or 0 for none
     */
    constructor(most, shared, { width = 4, dash = 0 } = {}) {
      this.most = most;
      this.count = 0;
      this.copies = new Copies([[0, -1], [1, -1], [1, 1], [0, 1]], QUAD, most, { start: 3, end: 3, along: 2 });
      Object.assign(this, this.copies.values);
      this.uniforms = {
        ...shared,
        uColour: { value: new import_three4.Vector3() },
        uHalo: { value: new import_three4.Vector3() },
        uWidth: { value: width },
        uDash: { value: dash }
      };
      const material = new import_three4.ShaderMaterial({
        vertexShader: VERTEX2,
        fragmentShader: FRAGMENT2,
        uniforms: this.uniforms,
        transparent: true,
        depthWrite: false,
        depthTest: false
      });
      this.mesh = new import_three4.Mesh(this.copies.geometry, material);
      this.mesh.frustumCulled = false;
      this.mesh.renderOrder = 5;
    }
    /** Its colour, and that of a thin edge that sets it off against whatever it lies on. */
    colour(colour, edge) {
      this.uniforms.uColour.value.fromArray(colour);
      this.uniforms.uHalo.value.fromArray(edge);
    }
    clear() {
      this.count = 0;
      this.upload();
    }
    /** Add a piece between two places on the plate, m, and how far along the line they are. */
    add(x0, y0, x1, y1, from, to) {
      if (this.count >= this.most) return;
      const k = this.count++;
      this.put(k, x0, y0, x1, y1, from, to);
    }
    put(k, x0, y0, x1, y1, from, to) {
      this.start[3 * k] = x0;
      this.start[3 * k + 1] = y0;
      this.end[3 * k] = x1;
      this.end[3 * k + 1] = y1;
      this.along[2 * k] = from;
      this.along[2 * k + 1] = to;
    }
    /** Add a line through places, x and y one after the other; a closed one ends where it began. */
    path(places, closed2) {
      const n = places.length / 2;
      let along = 0;
      for (let k = 0; k < (closed2 ? n : n - 1); k++) {
        const a = 2 * k, b = 2 * ((k + 1) % n);
        const length = Math.hypot(places[b] - places[a], places[b + 1] - places[a + 1]);
        this.add(places[a], places[a + 1], places[b], places[b + 1], along, along + length);
        along += length;
      }
      this.upload();
    }
    upload() {
      this.copies.upload(this.count);
    }
    dispose() {
      this.copies.dispose();
      this.mesh.material.dispose();
    }
  };

  // src/view/trail.js
  var CORNERS = 96;
  var limitCircle = ({ start, slip_limit: limit }) => {
    const circle2 = new Float64Array(limit > 0 ? 2 * CORNERS : 0);
    for (let k = 0; k < circle2.length / 2; k++) {
      circle2[2 * k] = start.x + limit * Math.cos(2 * Math.PI * k / CORNERS);
      circle2[2 * k + 1] = start.y + limit * Math.sin(2 * Math.PI * k / CORNERS);
    }
    return circle2;
  };
  var Trail = class {
    /** @param {import("./shown.js").Shown} shown @param {object} shared uniforms */
    constructor(shown4, shared) {
      this.shown = shown4;
      this.line = new Lines(shown4.way.most, shared, { width: 4 });
      this.limit = new Lines(CORNERS, shared, { width: 4, dash: 2 * Math.PI * shown4.scenario.slip_limit / 24 || 0 });
      this.limit.path(limitCircle(shown4.scenario), true);
      this.meshes = [this.limit.mesh, this.line.mesh];
      this.drawn = -1;
    }
    recolour({ ink, paper, failed: failed2 }) {
      this.line.colour(ink, paper);
      this.limit.colour(failed2, paper);
    }
    update() {
      if (this.drawn === this.shown.ways) return;
      this.drawn = this.shown.ways;
      const { places, count } = this.shown.way, { line } = this;
      line.count = 0;
      for (let k = 2; k < 2 * count; k += 2) line.add(places[k - 2], places[k - 1], places[k], places[k + 1], 0, 0);
      line.upload();
    }
    dispose() {
      this.line.dispose();
      this.limit.dispose();
    }
  };

  // src/view/flat_picture.js
  var MARGIN2 = 14;
  var GAP = 10;
  var TOP_SHARE = 0.66;
  var REACH2 = 0.82;
  var FlatPicture = class {
    /** @param {HTMLCanvasElement} canvas @param {import("./camera.js").ViewCamera} view */
    constructor(canvas, view) {
      this.canvas = canvas;
      this.view = view;
      this.pen = canvas.getContext("2d");
    }
    build(shown4) {
      this.shown = shown4;
      this.bent = new Float32Array(shown4.surface.nVertices);
      const { plate } = shown4.scenario, far = REACH2 * Math.max(...shown4.surface.size);
      this.half = plate ? [plate.length / 2, plate.width / 2] : [far, far];
      this.limit = limitCircle(shown4.scenario);
      return [[this.half[0], this.half[1]]];
    }
    recolour(colours2) {
      this.colours = colours2;
    }
    resize(width, height, pixels) {
      this.ratio = Math.min(pixels, 2);
      this.canvas.width = Math.max(1, Math.round(width * this.ratio));
      this.canvas.height = Math.max(1, Math.round(height * this.ratio));
      this.size = [width, height];
    }
    /** Where both views are: middle, px, and px per m. */
    layOut() {
      const [width, height] = this.size, wide = width > 1.2 * height, [a, b] = this.half;
      const top = wide ? [TOP_SHARE * width, height] : [width, TOP_SHARE * height];
      const fits = Math.max(1, Math.min((top[0] - 2 * MARGIN2) / (2 * a), (top[1] - 2 * MARGIN2) / (2 * b)));
      const scale = fits / this.view.zoom;
      const rest = wide ? width - top[0] - GAP : width;
      this.above = { x: top[0] / 2, y: top[1] / 2, scale };
      this.beside = {
        x: wide ? top[0] + rest / 2 : width / 2,
        y: wide ? height / 2 : top[1] + (height - top[1]) / 2,
        scale: Math.max(1, (rest - 2 * MARGIN2) / (2 * b)) / this.view.zoom
      };
    }
    draw(asked) {
      const { pen, colours: colours2, shown: shown4 } = this, [width, height] = this.size;
      this.layOut();
      pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
      pen.fillStyle = css(colours2.panel);
      pen.fillRect(0, 0, width, height);
      const { layers: layers2, said: said2 } = asked;
      if (layers2.bending && shown4.there) said2.most = shown4.bent(layers2.bending, this.bent);
      this.drawAbove(asked);
      this.drawBeside(asked);
      this.writeWords(asked);
    }
    writeWords({ layers: layers2, said: said2 }) {
      const { pen, colours: colours2, shown: shown4, above, beside, half } = this, [width, height] = this.size;
      const { left, right } = shown4.touching;
      pen.fillStyle = css(colours2.muted);
      pen.font = `12px ${colours2.font}`;
      pen.textAlign = "center";
      pen.textBaseline = "bottom";
      const low = above.y + half[1] * above.scale - 4, flight = shown4.there && !left && !right ? ": in flight" : "";
      const off = Math.min(0.5 * half[1] * beside.scale, height / 2 - 60);
      pen.fillText(`from above${flight}`, above.x, low);
      pen.fillText("along the bar", beside.x, beside.y - off);
      pen.fillText("drawn flat: there is no WebGL", beside.x, beside.y + off + 12);
      if (layers2.legs) {
        pen.textAlign = "left";
        const far = above.x - half[0] * above.scale + 6;
        for (const [name, touches, y] of [["left", left, -0.6], ["right", right, 0.6]]) {
          pen.fillStyle = css(mix(colours2[name], colours2.ink, 0.25));
          pen.fillText(`${touches ? "●" : "○"} ${name} leg`, far, above.y + y * half[1] * above.scale);
        }
      }
      const tall = (said2.exaggerated !== 1 ? LINE2 : 0) + (said2.bent ? BAR : 0);
      pen.save();
      pen.translate(width - WIDTH - 8, height - tall - 8);
      drawNotes(pen, said2, colours2, WIDTH);
      pen.restore();
    }
    drawAbove({ layers: layers2, goal, ghost, cloud, push }) {
      const { pen, colours: colours2, above, shown: shown4 } = this, { x, y, scale } = above, [a, b] = this.half;
      const line = (places, closed2) => {
        pen.beginPath();
        for (let k = 0; k < places.length; k += 2) pen.lineTo(x + scale * places[k], y - scale * places[k + 1]);
        if (closed2) pen.closePath();
      };
      pen.fillStyle = css(colours2.plate);
      pen.fillRect(x - a * scale, y - b * scale, 2 * a * scale, 2 * b * scale);
      pen.strokeStyle = css(mix(colours2.plate, colours2.ink, 0.5));
      pen.lineWidth = 1;
      line([-a, 0, a, 0], false);
      pen.stroke();
      if (shown4.there) this.drawSheet(line, layers2);
      if (layers2.trail) this.drawTrail(line);
      for (const { nodes } of cloud) this.drawDots(nodes, css(colours2.accent, 0.3));
      if (goal) this.drawContour(line, goal, colours2.failed);
      if (ghost) this.drawContour(line, ghost, colours2.accent);
      if (!push) return;
      pen.strokeStyle = css(colours2.accent);
      pen.lineWidth = 4;
      line([push.from[0], push.from[1], push.to[0], push.to[1]], false);
      pen.stroke();
    }
    drawSheet(line, layers2) {
      const { pen, colours: colours2, shown: shown4 } = this, { surface, onPlate, nNodes, forces, hasForces } = shown4;
      pen.beginPath();
      this.traceEdge();
      pen.fillStyle = css(colours2.sheet);
      pen.fill("evenodd");
      pen.strokeStyle = css(mix(colours2.sheet, colours2.ink, 0.6));
      pen.stroke();
      const { x, y, scale } = this.above;
      for (let k = 0; k < nNodes; k++) {
        const touches = hasForces ? forces[3 * k] > 0 : onPlate[3 * k + 2] <= 0;
        const left = onPlate[3 * k + 1] > surface.centre[1];
        if (layers2.bending) {
          this.drawBent(k, layers2.bending);
          continue;
        }
        pen.fillStyle = css(layers2.legs ? left ? colours2.left : colours2.right : colours2.ink, touches ? 1 : 0.25);
        pen.beginPath();
        pen.arc(x + scale * onPlate[3 * k], y - scale * onPlate[3 * k + 1], 0.2 * surface.pitch * scale, 0, 2 * Math.PI);
        if (touches && layers2.contact) pen.fill();
        else pen.fillRect(x + scale * onPlate[3 * k] - 1, y - scale * onPlate[3 * k + 1] - 1, 2, 2);
      }
      if (layers2.forces && hasForces) this.drawFriction(line);
      const cos = Math.cos(surface.angle), sin = Math.sin(surface.angle), far = 0.4 * surface.size[0];
      pen.lineWidth = 3;
      pen.strokeStyle = css(mix(colours2.ink, colours2.accent, 0.4));
      const [cx, cy] = surface.centre;
      line([cx + 0.5 * far * cos, cy + 0.5 * far * sin, cx + far * cos, cy + far * sin], false);
      pen.stroke();
      pen.lineWidth = 1;
    }
    /** A square of a node's own, in the colour of how bent or high it is. */
    drawBent(node, kind) {
      const { pen, shown: shown4 } = this, { x, y, scale } = this.above, { onPlate, surface } = shown4;
      const [low, middle, high] = kind === "height" ? HIGH2 : BENT;
      const value = Math.max(-1, Math.min(1, shown4.bentAt(kind, node)));
      pen.fillStyle = css(value < 0 ? mix(middle, low, -value) : mix(middle, high, value));
      const wide = 0.86 * surface.pitch * scale;
      pen.fillRect(x + scale * onPlate[3 * node] - wide / 2, y - scale * onPlate[3 * node + 1] - wide / 2, wide, wide);
    }
    /** A line from each node along its friction, as long as in the other picture. */
    drawFriction(line) {
      const { pen, colours: colours2, shown: shown4 } = this, { onPlate, forces, nNodes, surface, scenario } = shown4;
      const share2 = nodeShare(scenario, nNodes);
      pen.strokeStyle = css(colours2.accent);
      pen.lineWidth = 2;
      for (let k = 0; k < nNodes; k++) {
        const x = onPlate[3 * k], y = onPlate[3 * k + 1];
        const long = arrowLength(forces[3 * k + 1], forces[3 * k + 2], share2) * surface.pitch;
        if (!(forces[3 * k] > 0 && long > 0)) continue;
        const size = Math.hypot(forces[3 * k + 1], forces[3 * k + 2]);
        line([x, y, x + long * forces[3 * k + 1] / size, y + long * forces[3 * k + 2] / size], false);
        pen.stroke();
      }
    }
    /** The sheet's edge as the plate sees it. */
    traceEdge() {
      const { pen, shown: shown4, above } = this, { surface, frame: f } = shown4, p = surface.points;
      for (const loop2 of surface.cut.loops) {
        loop2.forEach((vertex, k) => {
          const x = p[3 * vertex] - f[9], y = p[3 * vertex + 1] - f[10], z = p[3 * vertex + 2] - f[11];
          const at2 = [f[0] * x + f[3] * y + f[6] * z, f[1] * x + f[4] * y + f[7] * z];
          pen[k ? "lineTo" : "moveTo"](above.x + above.scale * at2[0], above.y - above.scale * at2[1]);
        });
        pen.closePath();
      }
    }
    drawTrail(line) {
      const { pen, colours: colours2, shown: shown4 } = this, { places, count } = shown4.way;
      pen.lineWidth = 1.75;
      pen.strokeStyle = css(colours2.failed);
      pen.setLineDash([6, 5]);
      line(this.limit, true);
      pen.stroke();
      pen.setLineDash([]);
      pen.strokeStyle = css(colours2.dark ? colours2.paper : colours2.ink);
      line(places.subarray(0, 2 * count), false);
      pen.stroke();
    }
    drawContour(line, { x, y, angle }, colour) {
      const { pen, shown: shown4 } = this, { cut, centroid } = shown4.surface, cos = Math.cos(angle), sin = Math.sin(angle);
      pen.strokeStyle = css(colour);
      pen.lineWidth = 2;
      const placed2 = (k) => {
        const u = cut.x[k] - centroid[0], v = cut.y[k] - centroid[1];
        return [x + cos * u - sin * v, y + sin * u + cos * v];
      };
      for (const loop2 of cut.loops) {
        line(loop2.flatMap(placed2), true);
        pen.stroke();
      }
      const far = shown4.surface.size[0] / 2;
      line([x, y, x + far * cos, y + far * sin], false);
      pen.stroke();
    }
    drawDots(nodes, colour) {
      const { pen, above: { x, y, scale } } = this;
      pen.fillStyle = colour;
      for (let k = 0; k < nodes.length; k += 3)
        pen.fillRect(x + scale * nodes[k] - 1, y - scale * nodes[k + 1] - 1, 2, 2);
    }
    /** From the bar's free end: y to the right, heights exaggerated as asked. */
    drawBeside({ exaggerated }) {
      const { pen, colours: colours2, beside, shown: shown4 } = this, { frame, nodes, nNodes, surface } = shown4, b = this.half[1];
      const to = (y, z) => [beside.x + beside.scale * y, beside.y - beside.scale * exaggerated * z];
      const end = [0, 0, 0];
      pen.strokeStyle = css(colours2.plate);
      pen.lineWidth = 5;
      pen.beginPath();
      for (const y of [-b, b]) {
        intoWorld(frame, 0, y, 0, end);
        const [px, py] = to(end[1], end[2]);
        pen.lineTo(px, py + 3);
      }
      pen.stroke();
      pen.lineWidth = 1;
      if (!shown4.there) return;
      for (let k = 0; k < nNodes; k++) {
        const [px, py] = to(nodes[3 * k + 1], nodes[3 * k + 2]);
        pen.fillStyle = css(shown4.onPlate[3 * k + 1] > surface.centre[1] ? colours2.left : colours2.right);
        pen.fillRect(px - 1.5, py - 3, 3, 3);
      }
    }
    /** Straight down. */
    rayAt(x, y) {
      const { above } = this;
      return { from: [(x - above.x) / above.scale, (above.y - y) / above.scale, 10], way: [0, 0, -1] };
    }
    dispose() {
    }
  };

  // src/view/gestures.js
  var TURN_PER_PIXEL = 8e-3;
  var KEY_TURN = Math.PI / 24;
  var KEY_PAN = 0.06;
  var KEY_ZOOM = 1.15;
  var LOOKS = { 0: "default", 1: "above", 2: "bar", 3: "plate" };
  var Gestures = class {
    /** @param {HTMLCanvasElement} canvas @param {Hands} hands */
    constructor(canvas, hands) {
      this.canvas = canvas;
      this.hands = hands;
      this.pointers = /* @__PURE__ */ new Map();
      this.doing = "";
      this.listeners = [
        ["pointerdown", (event) => this.down(event)],
        ["pointermove", (event) => this.move(event)],
        ["pointerup", (event) => this.up(event, true)],
        ["pointercancel", (event) => this.up(event, false)],
        ["wheel", (event) => this.wheel(event)],
        ["keydown", (event) => this.key(event)],
        ["dblclick", () => hands.look("default")],
        ["contextmenu", (event) => event.preventDefault()]
      ];
      for (const [kind, hear] of this.listeners) canvas.addEventListener(kind, hear, { passive: false });
    }
    place({ clientX, clientY }) {
      const box = this.canvas.getBoundingClientRect();
      return [clientX - box.left, clientY - box.top];
    }
    down(event) {
      const at2 = this.place(event);
      this.canvas.focus({ preventScroll: true });
      this.pointers.set(event.pointerId, at2);
      this.canvas.setPointerCapture?.(event.pointerId);
      if (this.pointers.size > 1) {
        if (this.doing === "push") this.hands.release(false);
        this.doing = "pinch";
      } else if (event.button === 2 || event.shiftKey) this.doing = "pan";
      else if (event.button === 0 && !event.ctrlKey && !event.metaKey && this.hands.grasp(...at2)) this.doing = "push";
      else this.doing = "orbit";
      event.preventDefault();
    }
    move(event) {
      const before = this.pointers.get(event.pointerId), at2 = this.place(event);
      if (!before) {
        if (event.pointerType === "mouse") this.hands.hover?.(...at2);
        return;
      }
      const dx = at2[0] - before[0], dy = at2[1] - before[1], tall = Math.max(this.canvas.clientHeight, 1);
      if (this.doing === "pinch") this.pinch(event.pointerId, before, at2, tall);
      this.pointers.set(event.pointerId, at2);
      if (this.doing === "orbit") this.hands.orbit(-dx * TURN_PER_PIXEL, dy * TURN_PER_PIXEL);
      else if (this.doing === "pan") this.hands.pan(-dx / tall, dy / tall);
      else if (this.doing === "push") this.hands.drag(...at2);
    }
    /** Two fingers: nearer by how far apart they go, along by where their middle goes. */
    pinch(id, before, at2, tall) {
      const other = [...this.pointers].find(([key]) => key !== id)?.[1];
      if (!other) return;
      const apart = (p) => Math.max(Math.hypot(p[0] - other[0], p[1] - other[1]), 1);
      this.hands.zoom(apart(before) / apart(at2));
      this.hands.pan((before[0] - at2[0]) / (2 * tall), (at2[1] - before[1]) / (2 * tall));
    }
    up(event, letGo) {
      if (!this.pointers.delete(event.pointerId)) return;
      if (this.doing === "push") this.hands.release(letGo);
      this.doing = this.pointers.size > 0 ? "wait" : "";
    }
    /** The page scrolls on, unless the picture was chosen. */
    wheel(event) {
      if (!event.ctrlKey && document.activeElement !== this.canvas) return;
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      this.hands.zoom(Math.exp(Math.max(-80, Math.min(80, event.deltaY * lines)) * 25e-4));
    }
    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      const way = ways[event.key], { hands } = this;
      if (way && event.shiftKey) hands.pan(way[0] * KEY_PAN, way[1] * KEY_PAN);
      else if (way) hands.orbit(way[0] * KEY_TURN, way[1] * KEY_TURN);
      else if (event.key === "+" || event.key === "=") hands.zoom(1 / KEY_ZOOM);
      else if (event.key === "-" || event.key === "−" || event.key === "_") hands.zoom(KEY_ZOOM);
      else if (Object.hasOwn(LOOKS, event.key)) hands.look(LOOKS[event.key]);
      else if (event.key === "Escape" && this.doing === "push") {
        hands.release(false);
        this.doing = "wait";
      } else return;
      event.preventDefault();
      event.stopPropagation();
    }
    destroy() {
      for (const [kind, hear] of this.listeners) this.canvas.removeEventListener(kind, hear);
    }
  };

  // src/view/gl_picture.js
  var import_three12 = __toESM(require_three(), 1);

  // src/view/goal.js
  var import_three7 = __toESM(require_three(), 1);

  // src/view/light.js
  var import_three5 = __toESM(require_three(), 1);
  var LIGHT = new import_three5.Vector3(0.5, -0.42, 0.85).normalize();
  var sharedUniforms = () => ({
    uLight: { value: LIGHT },
    uTurn: { value: new import_three5.Matrix3() },
    uViewport: { value: new import_three5.Vector2(1, 1) },
    uRatio: { value: 1 },
    uClear: { value: 1 },
    uEye: { value: new import_three5.Vector3() }
  });
  var HALFWAY = (
    /* glsl */
    `
  uniform vec3 uLight, uEye;
  varying vec3 vNormal, vHalfway;
  void face(vec3 normal, vec3 at) {
    vNormal = normal;
    vHalfway = normalize(uLight + normalize(uEye - at));
  }
`
  );
  var MATT = (normal) => `(0.56 + 0.06 * ${normal}.z + 0.46 * max(dot(${normal}, uLight), 0.0))`;
  var LIT = (
    /* glsl */
    `
  uniform vec3 uLight;
  varying vec3 vNormal, vHalfway;
  float matt(vec3 normal) {
    return ${MATT("normal")};
  }
  float shine(vec3 normal) {
    float s = max(dot(normal, vHalfway), 0.0);
    s *= s; s *= s; s *= s; s *= s;
    return s * s;
  }
`
  );

  // src/view/sheet_mesh.js
  var import_three6 = __toESM(require_three(), 1);
  var LIFTED = 0.42;
  var VERTEX3 = (
    /* glsl */
    `
  ${HALFWAY}
  uniform mat3 uTurn;
  uniform float uThickness;
  uniform vec3 uCentre, uAcross;
  attribute vec2 rest;
  attribute float bent;
  #ifdef RIM
    attribute vec3 outward;
    attribute float lift;
  #else
    uniform float uLift;
  #endif
  varying vec2 vRest;
  varying float vSide, vBent;
  void main() {
    vec3 up = normalize(uTurn * normal);
    vec4 at = modelMatrix * vec4(position, 1.0);
    #ifdef RIM
      at.xyz += up * (uThickness * lift);
      face(normalize(uTurn * outward), at.xyz);
    #else
      at.xyz += up * (uThickness * uLift);
      face(up * (2.0 * uLift - 1.0), at.xyz);
    #endif
    vRest = rest;
    vSide = dot(position - uCentre, uAcross);
    vBent = bent;
    gl_Position = projectionMatrix * viewMatrix * at;
  }
`
  );
  var FRAGMENT3 = (
    /* glsl */
    `
  ${LIT}
  uniform vec3 uSheet, uMarker, uLeft, uRight, uColours[3];
  uniform vec2 uHalf, uTouch, uPlace;
  uniform float uLegs, uBent, uSquare;
  varying vec2 vRest;
  varying float vSide, vBent;
  float box(vec2 p, vec2 size, vec2 px) {
    vec2 edge = clamp(0.5 - (abs(p) - size) / px, 0.0, 1.0);
    return edge.x * edge.y;
  }
  void main() {
    vec2 px = fwidth(vRest) + 1e-9;
    #ifdef RIM
      vec2 check = vec2(0.0);
    #else
      vec2 square = abs(fract(vRest / (2.0 * uSquare)) * 2.0 - 1.0) * 2.0 - 1.0;
      vec2 check = clamp(square * uSquare / (2.0 * px), -1.0, 1.0);
    #endif
    float side = clamp(vSide / (fwidth(vSide) + 1e-9) + 0.5, 0.0, 1.0);
    vec3 leg = mix(uRight, uLeft, side);
    leg = mix(vec3(0.96), leg, mix(uTouch.y, uTouch.x, side)); // a lifted leg is paler
    vec3 colour = mix(uSheet, leg, uLegs);
    float t = clamp(vBent, -1.0, 1.0);
    vec3 scale = t < 0.0 ? mix(uColours[1], uColours[0], -t) : mix(uColours[1], uColours[2], t);
    colour = mix(colour, scale, uBent);
    colour *= 1.0 + 0.045 * check.x * check.y * (1.0 - 0.6 * uBent);
    float marker = box(vRest, uHalf, px) + box(vRest - uPlace, uHalf, px);
    colour = mix(colour, uMarker, min(marker, 1.0) * (1.0 - 0.75 * uBent));
    vec3 normal = normalize(vNormal);
    gl_FragColor = vec4(colour * matt(normal) + 0.1 * shine(normal), 1.0);
  }
`
  );
  var SheetMesh = class {
    /**
     * @param {import("./surface.js").SheetSurface} surface
     * @param {object} shared uniforms
     */
    constructor(surface, shared) {
      this.surface = surface;
      this.group = new import_three6.Group();
      this.own = uniformsOf(surface);
      this.bent = new Float32Array(surface.nVertices);
      this.faces = attributesOf(surface, this.bent);
      const uniforms = { ...shared, ...this.own };
      const { triangles } = surface.cut;
      this.add(faceOf(this.faces, triangles), { ...uniforms, uLift: { value: 1 } });
      this.low = this.add(faceOf(this.faces, turnedOver(triangles)), { ...uniforms, uLift: { value: 0 } });
      this.rim = new Rim(surface);
      this.add(this.rim.geometry, uniforms, { RIM: "" });
    }
    add(geometry, uniforms, defines = {}) {
      const material = new import_three6.ShaderMaterial({ vertexShader: VERTEX3, fragmentShader: FRAGMENT3, uniforms, defines });
      const mesh = new import_three6.Mesh(geometry, material);
      mesh.frustumCulled = false;
      mesh.matrixAutoUpdate = false;
      this.group.add(mesh);
      return mesh;
    }
    recolour(colours2) {
      this.own.uSheet.value.fromArray(colours2.sheet);
      this.own.uLeft.value.fromArray(colours2.left);
      this.own.uRight.value.fromArray(colours2.right);
      this.own.uMarker.value.fromArray(colours2.dark ? [0.1, 0.16, 0.26] : [0.094, 0.259, 0.455]);
    }
    /** Colour each half as a leg. @param {boolean} on @param {{left: boolean, right: boolean}} touching */
    showLegs(on, { left, right }) {
      this.own.uLegs.value = on ? 0.9 : 0;
      this.own.uTouch.value.set(left ? 1 : LIFTED, right ? 1 : LIFTED);
    }
    /** Colour by how bent or high the sheet is; `values` of the vertices, -1 to 1, are in `bent`. */
    showBent(kind) {
      this.own.uBent.value = kind ? 0.9 : 0;
      (kind === "height" ? HIGH2 : BENT).forEach((colour, k) => this.own.uColours.value[k].fromArray(colour));
    }
    /**
     * What the surface has is drawn next.
     * @param {Float64Array} frame of the plate @param {number} least cosine of a slope at which the lower face is seen
     */
    update(frame, least2) {
      this.low.visible = this.surface.steepest < least2;
      const { centre } = this.surface, { uCentre, uAcross } = this.own;
      uAcross.value.set(frame[1], frame[4], frame[7]);
      uCentre.value.set(frame[9], frame[10], frame[11]).addScaledVector(uAcross.value, centre[1]);
      this.faces.position.needsUpdate = true;
      this.faces.normal.needsUpdate = true;
      if (this.own.uBent.value > 0) this.faces.bent.needsUpdate = true;
      this.rim.update(this.bent);
    }
    dispose() {
      for (const mesh of this.group.children) {
        mesh.geometry.dispose();
        mesh.material.dispose();
      }
    }
  };
  var markersOn = ({ cut, centroid, size, nVertices }) => {
    const half = Math.min(...size) / 2;
    let far = 0;
    for (let k = 0; k < nVertices; k++)
      if (Math.abs(cut.y[k] - centroid[1]) < 0.1 * half) far = Math.max(far, cut.x[k] - centroid[0]);
    return { half: [0.17 * half, 0.085 * half], outer: [0.78 * far, 0] };
  };
  var uniformsOf = (surface) => {
    const { size } = surface, markers = markersOn(surface);
    return {
      uThickness: { value: surface.thickness },
      uCentre: { value: new import_three6.Vector3() },
      uAcross: { value: new import_three6.Vector3() },
      uSheet: { value: new import_three6.Vector3() },
      uMarker: { value: new import_three6.Vector3() },
      uLeft: { value: new import_three6.Vector3() },
      uRight: { value: new import_three6.Vector3() },
      uColours: { value: [new import_three6.Vector3(), new import_three6.Vector3(), new import_three6.Vector3()] },
      uHalf: { value: new import_three6.Vector2(...markers.half) },
      uTouch: { value: new import_three6.Vector2() },
      uPlace: { value: new import_three6.Vector2(...markers.outer) },
      uLegs: { value: 0 },
      uBent: { value: 0 },
      uSquare: { value: Math.max(...size) / 8 }
    };
  };
  var dynamic = (array, size) => new import_three6.BufferAttribute(array, size).setUsage(import_three6.DynamicDrawUsage);
  var attributesOf = ({ points, normals, cut, centroid, nVertices }, bent) => {
    const rest = new Float32Array(2 * nVertices);
    for (let k = 0; k < nVertices; k++) rest.set([cut.x[k] - centroid[0], cut.y[k] - centroid[1]], 2 * k);
    return {
      position: dynamic(points, 3),
      normal: dynamic(normals, 3),
      bent: dynamic(bent, 1),
      rest: new import_three6.BufferAttribute(rest, 2)
    };
  };
  var faceOf = (attributes, triangles) => {
    const geometry = new import_three6.BufferGeometry();
    for (const [name, attribute] of Object.entries(attributes)) geometry.setAttribute(name, attribute);
    return geometry.setIndex(new import_three6.BufferAttribute(Uint16Array.from(triangles), 1));
  };
  var turnedOver = (triangles) => triangles.map((_, t) => triangles[t % 3 === 0 ? t : t + 3 - 2 * (t % 3)]);
  var Rim = class {
    constructor(surface) {
      this.surface = surface;
      this.loops = surface.cut.loops;
      const n = 2 * this.loops.reduce((sum2, loop2) => sum2 + loop2.length, 0);
      const arrays = { position: 3, normal: 3, outward: 3, bent: 1, lift: 1, rest: 2 };
      this.geometry = new import_three6.BufferGeometry();
      for (const [name, size] of Object.entries(arrays)) {
        this[name] = new Float32Array(size * n);
        this.geometry.setAttribute(name, dynamic(this[name], size));
      }
      const index = [];
      let first = 0;
      for (const loop2 of this.loops) {
        loop2.forEach((vertex, k) => {
          const a = first + 2 * k, b = first + 2 * ((k + 1) % loop2.length);
          index.push(a, b, b + 1, a, b + 1, a + 1);
          this.lift[a + 1] = 1;
          const rest = [surface.cut.x[vertex] - surface.centroid[0], surface.cut.y[vertex] - surface.centroid[1]];
          this.rest.set([...rest, ...rest], 2 * a);
        });
        first += 2 * loop2.length;
      }
      this.geometry.setIndex(index);
    }
    update(bent) {
      const { points: p, normals: n } = this.surface, { position, normal, outward } = this;
      let at2 = 0;
      for (const loop2 of this.loops)
        for (let k = 0; k < loop2.length; k++, at2 += 2) {
          const { length } = loop2, from = 3 * loop2[k];
          const before = 3 * loop2[(k + 2 * length - 2) % length], after = 3 * loop2[(k + 2) % length];
          const tx = p[after] - p[before], ty = p[after + 1] - p[before + 1], tz = p[after + 2] - p[before + 2];
          const nx = n[from], ny = n[from + 1], nz = n[from + 2];
          const x = ty * nz - tz * ny, y = tz * nx - tx * nz, z = tx * ny - ty * nx;
          for (let to = 3 * at2; to < 3 * at2 + 6; to += 3) {
            for (let d = 0; d < 3; d++) {
              position[to + d] = p[from + d];
              normal[to + d] = n[from + d];
            }
            outward[to] = x;
            outward[to + 1] = y;
            outward[to + 2] = z;
          }
          this.bent[at2] = this.bent[at2 + 1] = bent[loop2[k]];
        }
      for (const name of ["position", "normal", "outward", "bent"]) this.geometry.attributes[name].needsUpdate = true;
    }
  };

  // src/view/spline.js
  var AROUND = [[1, 0, 1], [-1, 0, 1], [0, 1, 1], [0, -1, 1], [1, 1, 0.5], [-1, 1, 0.5], [1, -1, 0.5], [-1, -1, 0.5]];
  var QUARTERS = [[1, 1], [-1, 1], [1, -1], [-1, -1]];
  var TAPS = 16;
  var LatticeSpline = class {
    /**
     * @param {ArrayLike<number>} squares column and row of each node
     * @param {ArrayLike<number>} u columns of the points to give the surface at, in squares
     * @param {ArrayLike<number>} v rows of them
     */
    constructor(squares2, u, v) {
      this.nNodes = squares2.length / 2;
      this.nPoints = u.length;
      const grid = gridAround(squares2, u, v);
      this.taps = new Uint32Array(TAPS * this.nPoints);
      this.weights = new Float32Array(TAPS * this.nPoints);
      const wanted = /* @__PURE__ */ new Set();
      for (let k = 0; k < this.nPoints; k++) this.lay(grid, u[k], v[k], k, wanted);
      this.continueTo(grid, wanted);
      for (let t = 0; t < this.taps.length; t++) this.taps[t] = grid.number[this.taps[t]];
      this.extended = new Float32Array(3 * (this.nNodes + this.nBeyond));
    }
    /** Squares and weights that give point k. */
    lay(grid, u, v, k, wanted) {
      const i = Math.floor(u), j = Math.floor(v), across = cubic(u - i), along = cubic(v - j);
      for (let a = 0; a < 4; a++)
        for (let b = 0; b < 4; b++) {
          const weight = across[a] * along[b], t = TAPS * k + 4 * a + b;
          const none = weight === 0, column = none ? squareNear(i, across) : i + a - 1;
          const asked = grid.at(column, none ? squareNear(j, along) : j + b - 1);
          this.taps[t] = asked;
          this.weights[t] = weight;
          if (grid.number[asked] < 0) wanted.add(asked);
        }
    }
    /** Number the squares beyond the nodes that are wanted, and say what each is continued from. */
    continueTo(grid, wanted) {
      const start = [0], from = [], weight = [], steps = [];
      let next = this.nNodes;
      while ([...wanted].some((square2) => grid.number[square2] < 0)) {
        const ring = grid.ring();
        const rules = ring.map((square2) => ruleFor(grid, square2));
        ring.forEach((square2, k) => {
          grid.number[square2] = next++;
          for (const [index, share2] of rules[k].from) {
            from.push(index);
            weight.push(share2);
          }
          steps.push(...rules[k].step);
          start.push(from.length);
        });
      }
      this.nBeyond = next - this.nNodes;
      this.start = Uint32Array.from(start);
      this.from = Uint32Array.from(from);
      this.weight = Float32Array.from(weight);
      this.steps = Float32Array.from(steps);
    }
    /**
     * Points of the surface.
     * @param {Float32Array} nodes x, y, z of each, m
     * @param {Float32Array} points what is written to
     * @param {ArrayLike<number>} turned how far one square further along columns and along rows is, were the sheet stiff
     */
    through(nodes, points, turned) {
      const { extended: e, start, from, weight, steps, taps, weights } = this;
      e.set(nodes);
      for (let k = 0, g = 3 * this.nNodes; k < this.nBeyond; k++, g += 3) {
        const i = steps[2 * k], j = steps[2 * k + 1];
        let x = i * turned[0] + j * turned[3], y = i * turned[1] + j * turned[4], z = i * turned[2] + j * turned[5];
        for (let t = start[k]; t < start[k + 1]; t++) {
          const w = weight[t], n = 3 * from[t];
          x += w * e[n];
          y += w * e[n + 1];
          z += w * e[n + 2];
        }
        e[g] = x;
        e[g + 1] = y;
        e[g + 2] = z;
      }
      for (let k = 0, t = 0; k < 3 * this.nPoints; k += 3) {
        let x = 0, y = 0, z = 0;
        for (const last2 = t + TAPS; t < last2; t++) {
          const w = weights[t], n = 3 * taps[t];
          x += w * e[n];
          y += w * e[n + 1];
          z += w * e[n + 2];
        }
        points[k] = x;
        points[k + 1] = y;
        points[k + 2] = z;
      }
      return points;
    }
    /** One number of each node, as the points have it: beyond the nodes, what the nearest have. */
    spread(values, points) {
      const { extended: e, start, from, taps, weights, nNodes } = this;
      for (let k = 0; k < nNodes; k++) e[k] = values[k];
      for (let k = 0; k < this.nBeyond; k++) {
        let sum2 = 0;
        for (let t = start[k]; t < start[k + 1]; t++) sum2 += e[from[t]];
        e[nNodes + k] = sum2 / (start[k + 1] - start[k]);
      }
      for (let k = 0, t = 0; k < this.nPoints; k++) {
        let sum2 = 0;
        for (const last2 = t + TAPS; t < last2; t++) sum2 += weights[t] * e[taps[t]];
        points[k] = sum2;
      }
      return points;
    }
  };
  var cubic = (s) => [
    ((2 - s) * s - 1) * s / 2,
    ((3 * s - 5) * s * s + 2) / 2,
    ((4 - 3 * s) * s + 1) * s / 2,
    (s - 1) * s * s / 2
  ];
  var squareNear = (i, weights) => i + weights.findIndex((w) => w !== 0) - 1;
  var gridAround = (squares2, u, v) => {
    let low = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity;
    const reach = (i, j) => {
      low = Math.min(low, i);
      right = Math.max(right, i);
      bottom = Math.min(bottom, j);
      top = Math.max(top, j);
    };
    for (let k = 0; k < squares2.length; k += 2) reach(squares2[k], squares2[k + 1]);
    for (let k = 0; k < u.length; k++) reach(Math.floor(u[k]), Math.floor(v[k]));
    low -= 4;
    bottom -= 4;
    const columns = right - low + 5, rows = top - bottom + 5;
    const number = new Int32Array(columns * rows).fill(-1);
    const at2 = (i, j) => (i - low) * rows + j - bottom;
    for (let k = 0; k < squares2.length; k += 2) number[at2(squares2[k], squares2[k + 1])] = k / 2;
    const ring = () => {
      const found = [];
      for (let i = 1; i + 1 < columns; i++)
        for (let j = 1; j + 1 < rows; j++) {
          const s = i * rows + j;
          if (number[s] < 0 && AROUND.some(([di, dj]) => number[s + di * rows + dj] >= 0)) found.push(s);
        }
      return found;
    };
    return { number, rows, at: at2, ring };
  };
  var ruleFor = ({ number, rows }, square2) => {
    const known = (di, dj) => number[square2 + di * rows + dj] ?? -1;
    const lines = AROUND.filter(([i2, j2]) => known(i2, j2) >= 0 && known(2 * i2, 2 * j2) >= 0);
    const total = lines.reduce((sum2, [, , w]) => sum2 + w, 0);
    if (total > 0) {
      const from = lines.flatMap(([i2, j2, w]) => [[known(i2, j2), 2 * w / total], [known(2 * i2, 2 * j2), -w / total]]);
      return { from, step: [0, 0] };
    }
    const corner = QUARTERS.find(([i2, j2]) => known(i2, 0) >= 0 && known(0, j2) >= 0 && known(i2, j2) >= 0);
    if (corner) {
      const [i2, j2] = corner;
      return { from: [[known(i2, 0), 1], [known(0, j2), 1], [known(i2, j2), -1]], step: [0, 0] };
    }
    const [i, j] = AROUND.find(([di, dj]) => known(di, dj) >= 0);
    return { from: [[known(i, j), 1]], step: [-i, -j] };
  };

  // src/view/trimming.js
  var HALVINGS = 24;
  var cutGrid = (inside, xs, ys) => {
    const columns = xs.length, rows = ys.length;
    const within = new Uint8Array(columns * rows);
    for (let i = 0; i < columns; i++)
      for (let j = 0; j < rows; j++) within[i * rows + j] = inside(xs[i], ys[j]) ? 1 : 0;
    const vertices = new Vertices(inside, xs, ys, within);
    const triangles = [], after = /* @__PURE__ */ new Map();
    for (let i = 0; i + 1 < columns; i++)
      for (let j = 0; j + 1 < rows; j++) {
        const a = i * rows + j;
        cutCell([a, a + rows, a + rows + 1, a + 1], within, vertices, triangles, after);
      }
    return { ...vertices.arrays(), triangles: Uint32Array.from(triangles), loops: closed(after) };
  };
  var Vertices = class {
    constructor(inside, xs, ys, within) {
      Object.assign(this, { inside, xs, ys, within, points: [], inner: [], byGrid: /* @__PURE__ */ new Map(), byEdge: /* @__PURE__ */ new Map() });
    }
    at(point) {
      if (!this.byGrid.has(point)) {
        const n = this.points.length;
        this.byGrid.set(point, n);
        this.points.push(this.place(point));
        this.inner.push(n);
      }
      return this.byGrid.get(point);
    }
    /** Where the outline crosses the edge between a grid point inside and one outside, by halving. */
    crossing(a, b) {
      const key = a * this.within.length + b;
      if (!this.byEdge.has(key)) {
        const [x0, y0] = this.place(a), [x1, y1] = this.place(b);
        let low = 0, high = 1;
        for (let k = 0; k < HALVINGS; k++) {
          const share2 = (low + high) / 2;
          if (this.inside(x0 + share2 * (x1 - x0), y0 + share2 * (y1 - y0))) low = share2;
          else high = share2;
        }
        const inner = this.at(a);
        this.byEdge.set(key, this.points.length);
        this.points.push([x0 + low * (x1 - x0), y0 + low * (y1 - y0)]);
        this.inner.push(inner);
      }
      return this.byEdge.get(key);
    }
    place(point) {
      const rows = this.ys.length, j = point % rows;
      return [this.xs[(point - j) / rows], this.ys[j]];
    }
    arrays() {
      return {
        x: Float64Array.from(this.points, ([x]) => x),
        y: Float64Array.from(this.points, ([, y]) => y),
        inner: Int32Array.from(this.inner)
      };
    }
  };
  var cutCell = (corners2, within, vertices, triangles, after) => {
    const count = within[corners2[0]] + within[corners2[1]] + within[corners2[2]] + within[corners2[3]];
    if (count === 0) return;
    let first = 0;
    if (count < 4) while (!within[corners2[first]] || within[corners2[(first + 3) % 4]]) first++;
    const polygon = [];
    let leaving = -1;
    for (let k = first; k < first + 4; k++) {
      const a = corners2[k % 4], b = corners2[(k + 1) % 4];
      if (within[a]) polygon.push(vertices.at(a));
      if (within[a] === within[b]) continue;
      const crossing2 = within[a] ? vertices.crossing(a, b) : vertices.crossing(b, a);
      polygon.push(crossing2);
      if (within[a]) leaving = crossing2;
      else after.set(leaving, crossing2);
    }
    for (let k = 2; k < polygon.length; k++) triangles.push(polygon[0], polygon[k - 1], polygon[k]);
  };
  var closed = (after) => {
    const loops = [];
    while (after.size) {
      const [start] = after.keys();
      const loop2 = [];
      for (let at2 = start; after.has(at2); ) {
        const next = after.get(at2);
        after.delete(at2);
        loop2.push(at2);
        at2 = next;
      }
      loops.push(loop2);
    }
    return loops;
  };

  // src/view/surface.js
  var CELLS = 2e3;
  var LEAST_ALONG = 6;
  var MOST_ALONG = 180;
  var SheetSurface = class {
    /**
     * @param {object} sheet of a scenario: outline, pitch, thickness
     * @param {import("../model/lattice.js").Lattice} lattice its nodes
     * @param {number} [cells] over the outline's box
     */
    constructor(sheet, lattice2, cells = CELLS) {
      const { columns, rows, squares: squares2, nNodes } = lattice2, { pitch } = sheet;
      this.nNodes = nNodes;
      this.pitch = pitch;
      this.thickness = sheet.thickness;
      this.size = outlineSize(sheet.outline);
      const middle = [(columns - 1) / 2, (rows - 1) / 2];
      const lines = gridLines(this.size, cells, STRAIGHT.has(sheet.outline.shape));
      this.cut = cutGrid(insideNear(sheet, lattice2, middle), ...lines);
      const onLattice = (places, d) => places.map((at2) => at2 / pitch + middle[d]), { x, y } = this.cut;
      this.nVertices = x.length;
      this.spline = new LatticeSpline(squares2, onLattice(x, 0), onLattice(y, 1));
      this.rest = restOf2(squares2, pitch);
      this.centroid = [0, 1].map((d) => meanOf(squares2, d) * pitch - middle[d] * pitch);
      this.area = areaOf(this.cut);
      this.points = new Float32Array(3 * this.nVertices);
      this.normals = new Float32Array(3 * this.nVertices);
      this.turned = new Float64Array(6);
      this.steepest = 1;
      this.centre = new Float64Array(3);
      this.angle = 0;
    }
    /**
     * Put the surface through nodes.
     * @param {Float32Array} nodes world, m
     * @param {Float32Array} onPlate the same in the plate's frame
     * @param {Float64Array} frame of the plate
     */
    update(nodes, onPlate, frame) {
      this.findPlace(onPlate);
      const cos = this.pitch * Math.cos(this.angle), sin = this.pitch * Math.sin(this.angle);
      for (let d = 0; d < 3; d++) {
        this.turned[d] = cos * frame[3 * d] + sin * frame[3 * d + 1];
        this.turned[3 + d] = -sin * frame[3 * d] + cos * frame[3 * d + 1];
      }
      this.spline.through(nodes, this.points, this.turned);
      this.findNormals(frame);
    }
    findPlace(onPlate) {
      const { rest, centre, nNodes: n } = this;
      centre.fill(0);
      for (let k = 0; k < 3 * n; k++) centre[k % 3] += onPlate[k] / n;
      let cross2 = 0, dot3 = 0;
      for (let k = 0; k < n; k++) {
        const x = onPlate[3 * k] - centre[0], y = onPlate[3 * k + 1] - centre[1];
        cross2 += rest[2 * k] * y - rest[2 * k + 1] * x;
        dot3 += rest[2 * k] * x + rest[2 * k + 1] * y;
      }
      this.angle = Math.atan2(cross2, dot3);
    }
    /** Upward unit normals of the vertices, from the triangles around each. */
    findNormals(frame) {
      const { points: p, normals: n } = this, { triangles, inner } = this.cut;
      n.fill(0);
      for (let t = 0; t < triangles.length; t += 3) {
        const a = 3 * triangles[t], b = 3 * triangles[t + 1], c = 3 * triangles[t + 2];
        const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
        const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
        const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
        n[a] += x;
        n[a + 1] += y;
        n[a + 2] += z;
        n[b] += x;
        n[b + 1] += y;
        n[b + 2] += z;
        n[c] += x;
        n[c + 1] += y;
        n[c + 2] += z;
      }
      let steepest = 1;
      for (let k = 0; k < inner.length; k++) {
        const i = 3 * k, from = 3 * inner[k];
        const length = Math.sqrt(n[i] * n[i] + n[i + 1] * n[i + 1] + n[i + 2] * n[i + 2]);
        if (length > 1e-16) {
          n[i] /= length;
          n[i + 1] /= length;
          n[i + 2] /= length;
        } else if (from !== i) {
          n[i] = n[from];
          n[i + 1] = n[from + 1];
          n[i + 2] = n[from + 2];
        } else n[i + 2] = 1;
        steepest = Math.min(steepest, n[i] * frame[2] + n[i + 1] * frame[5] + n[i + 2] * frame[8]);
      }
      this.steepest = steepest;
    }
  };
  var STRAIGHT = /* @__PURE__ */ new Set(["rectangle", "mask"]);
  var gridLines = (size, cells, straight) => {
    const step = Math.sqrt(size[0] * size[1] / cells);
    return size.map((extent3) => {
      const n = Math.min(Math.max(LEAST_ALONG, Math.round(extent3 / step)), MOST_ALONG);
      const first = straight ? -1 : -0.5;
      return Float64Array.from({ length: straight ? n + 3 : n + 2 }, (_, k) => ((k + first) / n - 0.5) * extent3);
    });
  };
  var insideNear = ({ outline, pitch }, { squares: squares2, columns, rows }, middle) => {
    const inside = insideOf(outline), there = /* @__PURE__ */ new Set();
    for (let k = 0; k < squares2.length; k += 2) there.add(squares2[k] * (rows + 4) + squares2[k + 1]);
    const carried = (i, j) => i >= 0 && j >= 0 && i < columns && j < rows && there.has(i * (rows + 4) + j);
    const near = (x, y) => {
      const u = x / pitch + middle[0], v = y / pitch + middle[1];
      for (let i = Math.ceil(u - 1); i <= u + 1; i++)
        for (let j = Math.ceil(v - 1); j <= v + 1; j++)
          if (carried(i, j) && Math.hypot(u - i, v - j) <= 1) return true;
      return false;
    };
    return (x, y) => inside(x * (1 - 1e-9), y * (1 - 1e-9)) && near(x, y);
  };
  var meanOf = (squares2, d) => {
    let sum2 = 0;
    for (let k = d; k < squares2.length; k += 2) sum2 += squares2[k];
    return 2 * sum2 / squares2.length;
  };
  var restOf2 = (squares2, pitch) => {
    const mean2 = [meanOf(squares2, 0), meanOf(squares2, 1)];
    return Float64Array.from(squares2, (at2, k) => (at2 - mean2[k % 2]) * pitch);
  };
  var areaOf = ({ x, y, triangles }) => {
    const area = new Float32Array(x.length);
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = triangles.subarray(t, t + 3);
      const whole2 = ((x[b] - x[a]) * (y[c] - y[a]) - (y[b] - y[a]) * (x[c] - x[a])) / 2;
      for (const k of [a, b, c]) area[k] += whole2 / 3;
    }
    return area;
  };

  // src/view/goal.js
  var Contour = class {
    constructor(surface, shared, look) {
      const { cut, centroid } = surface;
      let far = 0;
      for (const x of cut.x) far = Math.max(far, x - centroid[0]);
      this.pieces = cut.loops.reduce((sum2, loop2) => sum2 + loop2.length, 0) + 1;
      this.lines = new Lines(this.pieces, shared, look);
      for (const loop2 of cut.loops)
        this.lines.path(loop2.flatMap((k) => [cut.x[k] - centroid[0], cut.y[k] - centroid[1]]), true);
      this.lines.path([0, 0, far, 0], false);
      this.mesh = this.lines.mesh;
      this.mesh.visible = false;
    }
    /** @param {{x: number, y: number, angle: number} | null} pose on the plate, m and rad; whether it can be drawn */
    place(pose) {
      const there = pose !== null && [pose.x, pose.y, pose.angle].every(Number.isFinite);
      this.mesh.visible = there;
      if (!there) return pose === null;
      this.mesh.position.set(pose.x, pose.y, 0);
      this.mesh.rotation.z = pose.angle;
      return true;
    }
    colour(colour, edge) {
      this.lines.colour(colour, edge);
    }
    dispose() {
      this.lines.dispose();
    }
  };
  var VERTEX4 = (
    /* glsl */
    `
  ${HALFWAY}
  uniform mat3 uTurn;
  attribute vec2 rest;
  attribute float inner;
  varying vec2 vRest;
  varying float vInner;
  void main() {
    vec4 at = modelMatrix * vec4(position, 1.0);
    vec3 up = normalize(uTurn * normal);
    face(up, at.xyz);
    vRest = rest;
    vInner = inner;
    gl_Position = projectionMatrix * viewMatrix * at;
  }
`
  );
  var FRAGMENT4 = (
    /* glsl */
    `
  ${LIT}
  uniform vec3 uColour;
  uniform vec2 uHalf, uPlace;
  varying vec2 vRest;
  varying float vInner;
  void main() {
    vec3 normal = normalize(gl_FrontFacing ? vNormal : -vNormal);
    float edge = clamp(1.5 - vInner / (fwidth(vInner) + 1e-9), 0.0, 1.0);
    vec2 off = clamp(0.5 - (abs(vRest - uPlace) - uHalf) / (fwidth(vRest) + 1e-9), 0.0, 1.0);
    gl_FragColor = vec4(uColour * matt(normal), max(0.012, max(0.5 * edge, 0.35 * off.x * off.y)));
  }
`
  );
  var MOST = 24;
  var CELLS2 = 480;
  var Cloud = class {
    constructor({ sheet, motion }, lattice2, shared) {
      Object.assign(this, { sheet, lattice: lattice2, height: motion.height });
      this.group = new import_three7.Group();
      this.uniforms = {
        ...shared,
        uColour: { value: new import_three7.Vector3() },
        uHalf: { value: new import_three7.Vector2() },
        uPlace: { value: new import_three7.Vector2() }
      };
      this.material = new import_three7.ShaderMaterial({
        vertexShader: VERTEX4,
        fragmentShader: FRAGMENT4,
        uniforms: this.uniforms,
        transparent: true,
        depthWrite: false,
        depthTest: false,
        side: import_three7.DoubleSide
      });
      this.surface = null;
      this.frame = new Float64Array(FRAME_SIZE);
    }
    recolour({ accent }) {
      this.uniforms.uColour.value.fromArray(accent);
    }
    /** @param {{nodes: Float32Array, pose: ArrayLike<number>}[]} frames each of as many nodes as this sheet has */
    show(frames) {
      if (frames === this.frames) return;
      this.frames = frames;
      if (frames.length && !this.surface) this.prepare();
      const drawn = frames.filter(({ nodes }) => nodes.length === 3 * this.surface.nNodes).slice(0, MOST);
      while (this.group.children.length < drawn.length) this.group.add(this.another());
      this.group.children.forEach((mesh, k) => {
        mesh.visible = k < drawn.length;
        if (mesh.visible) this.put(drawn[k], mesh.geometry.attributes);
      });
    }
    prepare() {
      this.surface = new SheetSurface(this.sheet, this.lattice, CELLS2);
      const { cut, centroid, nVertices } = this.surface, markers = markersOn(this.surface);
      this.uniforms.uHalf.value.set(...markers.half);
      this.uniforms.uPlace.value.set(...markers.outer);
      this.rest = new import_three7.BufferAttribute(new Float32Array(2 * nVertices), 2);
      for (let k = 0; k < nVertices; k++) this.rest.setXY(k, cut.x[k] - centroid[0], cut.y[k] - centroid[1]);
      this.inner = new import_three7.BufferAttribute(Float32Array.from(cut.inner, (from, k) => from === k ? 1 : 0), 1);
    }
    put({ nodes, pose }, { position, normal }) {
      const { surface } = this;
      plateFrame(pose, this.height, this.frame);
      this.onPlate ??= new Float32Array(nodes.length);
      surface.update(nodes, ontoPlate(this.frame, nodes, this.onPlate), this.frame);
      position.array.set(surface.points);
      normal.array.set(surface.normals);
      position.needsUpdate = normal.needsUpdate = true;
    }
    another() {
      const geometry = new import_three7.BufferGeometry(), n = 3 * this.surface.nVertices;
      geometry.setAttribute("position", new import_three7.BufferAttribute(new Float32Array(n), 3).setUsage(import_three7.DynamicDrawUsage));
      geometry.setAttribute("normal", new import_three7.BufferAttribute(new Float32Array(n), 3).setUsage(import_three7.DynamicDrawUsage));
      geometry.setAttribute("rest", this.rest).setAttribute("inner", this.inner);
      geometry.setIndex(new import_three7.BufferAttribute(Uint16Array.from(this.surface.cut.triangles), 1));
      const mesh = new import_three7.Mesh(geometry, this.material);
      mesh.frustumCulled = false;
      mesh.renderOrder = 3;
      return mesh;
    }
    dispose() {
      for (const mesh of this.group.children) mesh.geometry.dispose();
      this.material.dispose();
    }
  };

  // src/view/marks.js
  var import_three8 = __toESM(require_three(), 1);
  var AT = (
    /* glsl */
    `
  uniform mat3 uTurn;
  uniform vec3 uEx, uEy, uUp;
  uniform float uLift;
  attribute vec3 node;
  vec4 place(vec2 shift) {
    vec4 at = modelMatrix * vec4(node + uEx * shift.x + uEy * shift.y, 1.0);
    at.xyz += normalize(uTurn * uUp) * uLift;
    return projectionMatrix * viewMatrix * at;
  }
`
  );
  var DISC = (
    /* glsl */
    `
  ${AT}
  attribute float radius;
  varying vec2 vPlace;
  varying float vRadius;
  void main() {
    vPlace = position.xy * 1.15;
    vRadius = radius;
    gl_Position = place(vPlace * radius);
  }
`
  );
  var DISC_FRAGMENT = (
    /* glsl */
    `
  uniform vec3 uColour, uHalo;
  uniform float uClear;
  varying vec2 vPlace;
  varying float vRadius;
  void main() {
    float r = length(vPlace), px = fwidth(r) + 1e-6;
    float alpha = clamp((1.0 - r) / px + 0.5, 0.0, 1.0);
    float inner = clamp((1.0 - r) / px - 0.8, 0.0, 1.0);
    if (alpha <= 0.0) discard;
    gl_FragColor = vec4(mix(uHalo, uColour, inner), alpha * uClear * mix(0.9, 0.78, inner));
  }
`
  );
  var ARROW = (
    /* glsl */
    `
  ${AT}
  uniform float uPitch, uGrown;
  attribute vec2 way;
  void main() {
    float length_ = length(way);
    vec2 along = length_ > 0.0 ? way / length_ : vec2(1.0, 0.0);
    float head = min(0.3 * uPitch, 0.6 * length_), neck = length_ - head;
    float s = position.x < -0.5 ? 0.0 : position.x < 0.5 ? neck : length_;
    float out_ = uGrown * 0.035 * uPitch;
    s += position.x < -0.5 ? -out_ : position.x < 0.5 ? -out_ : 2.2 * out_;
    float width = abs(position.y) > 1.5 ? 0.5 * head + 1.6 * out_ : 0.05 * uPitch + out_;
    gl_Position = place(along * s + vec2(-along.y, along.x) * sign(position.y) * width);
  }
`
  );
  var ARROW_FRAGMENT = (
    /* glsl */
    `
  uniform vec3 uColour;
  uniform float uClear;
  void main() {
    gl_FragColor = vec4(uColour, uClear);
  }
`
  );
  var Marks = class {
    /** @param {object} scenario @param {number} nNodes @param {object} shared uniforms */
    constructor(scenario, nNodes, shared) {
      const { sheet } = scenario;
      this.nNodes = nNodes;
      this.pitch = sheet.pitch;
      this.share = nodeShare(scenario, nNodes);
      const disc = [[-1, -1], [1, -1], [1, 1], [-1, 1]];
      const arrow = [[-1, -1], [0, -1], [0, 1], [-1, 1], [0, -2], [1, 0], [0, 2]];
      this.touches = new Copies(disc, QUAD, nNodes, { node: 3, radius: 1 });
      this.drags = new Copies(arrow, [...QUAD, 4, 5, 6], nNodes, { node: 3, way: 2 });
      const vectors = { uEx: { value: new import_three8.Vector3() }, uEy: { value: new import_three8.Vector3() }, uUp: { value: new import_three8.Vector3() } };
      this.uniforms = { ...shared, ...vectors, uLift: { value: sheet.thickness }, uPitch: { value: sheet.pitch } };
      this.discColours = { uColour: { value: new import_three8.Vector3() }, uHalo: { value: new import_three8.Vector3() } };
      this.arrowColour = { value: new import_three8.Vector3() };
      this.haloColour = { value: new import_three8.Vector3() };
      const inDiscs = { ...this.uniforms, ...this.discColours };
      const inArrows = { ...this.uniforms, uColour: this.arrowColour, uGrown: { value: 0 } };
      const inHalos = { ...this.uniforms, uColour: this.haloColour, uGrown: { value: 1 } };
      this.group = new import_three8.Group();
      this.group.add(
        overAll(this.touches, inDiscs, DISC, DISC_FRAGMENT, 6),
        overAll(this.drags, inHalos, ARROW, ARROW_FRAGMENT, 7),
        overAll(this.drags, inArrows, ARROW, ARROW_FRAGMENT, 8)
      );
    }
    recolour({ ink, paper, accent, dark }) {
      this.discColours.uColour.value.fromArray(dark ? paper : ink);
      this.discColours.uHalo.value.fromArray(dark ? ink : paper);
      this.arrowColour.value.fromArray(dark ? paper : accent);
      this.haloColour.value.fromArray(dark ? ink : paper);
      if (dark) this.arrowColour.value.set(0.03, 0.3, 0.62);
    }
    /**
     * @param {Float32Array} nodes world, m
     * @param {Float32Array} onPlate the same in the plate's frame
     * @param {Float32Array | null} forces of each node normal force and friction along the plate's axes, N
     * @param {Float64Array} frame of the plate
     * @param {{contact: boolean, forces: boolean}} layers
     */
    update(nodes, onPlate, forces, frame, layers2) {
      this.uniforms.uEx.value.set(frame[0], frame[3], frame[6]);
      this.uniforms.uEy.value.set(frame[1], frame[4], frame[7]);
      this.uniforms.uUp.value.set(frame[2], frame[5], frame[8]);
      const disc = this.touches.values, arrow = this.drags.values;
      let discs = 0, arrows = 0;
      for (let k = 0; k < this.nNodes; k++) {
        const normal = forces ? forces[3 * k] : onPlate[3 * k + 2] <= 0 ? this.share : 0;
        if (!(normal > 0)) continue;
        if (layers2.contact) {
          copyNode(nodes, k, disc.node, discs);
          disc.radius[discs++] = this.pitch * discRadius(layers2.forces ? normal : this.share, this.share);
        }
        if (!layers2.forces || !forces) continue;
        const fx = forces[3 * k + 1], fy = forces[3 * k + 2], long = this.pitch * arrowLength(fx, fy, this.share);
        if (long === 0) continue;
        copyNode(nodes, k, arrow.node, arrows);
        arrow.way[2 * arrows] = long * fx / Math.hypot(fx, fy);
        arrow.way[2 * arrows++ + 1] = long * fy / Math.hypot(fx, fy);
      }
      this.touches.upload(discs);
      this.drags.upload(arrows);
    }
    dispose() {
      this.touches.dispose();
      this.drags.dispose();
      for (const mesh of this.group.children) mesh.material.dispose();
    }
  };
  var copyNode = (nodes, from, into, to) => {
    for (let d = 0; d < 3; d++) into[3 * to + d] = nodes[3 * from + d];
  };
  var overAll = ({ geometry }, uniforms, vertexShader, fragmentShader, order) => {
    const material = new import_three8.ShaderMaterial({
      vertexShader,
      fragmentShader,
      uniforms,
      transparent: true,
      depthTest: false,
      depthWrite: false
    });
    const mesh = new import_three8.Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = order;
    return mesh;
  };

  // src/view/pace.js
  var BUDGETS = [6e5, 42e4, 3e5, 2e5];
  var STILL = 26e5;
  var PATIENCE2 = 28;
  var LATE = 8;
  var GOOD = 150;
  var Pace = class {
    constructor() {
      this.step = 0;
      this.late = 0;
      this.good = 0;
      this.needed = GOOD;
      this.began = 0;
    }
    /** Pixels over CSS px that a moving picture of so many CSS px should have, on a screen with so many. */
    moving(area, pixels) {
      return Math.min(pixels, Math.sqrt(BUDGETS[this.step] / area));
    }
    /** The same of a picture that stands still: its edges are smoothed by drawing it twice as fine as the screen. */
    still(area, pixels) {
      return Math.min(2 * pixels, Math.sqrt(STILL / area));
    }
    /**
     * A picture is begun.
     * @param {number} now ms
     * @param {boolean} finished whether the one before was
     * @returns {boolean} whether pictures should be coarser or finer from now on
     */
    next(now, finished) {
      const took = now - this.began;
      this.began = now;
      if (took > 20 * PATIENCE2) return false;
      this.good = finished ? this.good + 1 : 0;
      if (took >= PATIENCE2) this.late = Math.max(0, this.late + (finished ? -1 : 1));
      const coarser = this.late >= LATE && this.step < BUDGETS.length - 1;
      const finer = this.good >= this.needed && this.step > 0;
      if (!coarser && !finer) return false;
      this.step += coarser ? 1 : -1;
      if (finer) this.needed *= 2;
      this.late = this.good = 0;
      return true;
    }
  };

  // src/view/plate.js
  var import_three9 = __toESM(require_three(), 1);

  // src/view/shadow.js
  var CELLS3 = 96;
  var ROOM = 1.7;
  var NEAR = 3e-3;
  var Shadow = class {
    /** @param {import("./surface.js").SheetSurface} surface */
    constructor(surface) {
      this.surface = surface;
      this.grain = ROOM * Math.max(...surface.size) / CELLS3;
      this.dark = new Uint8Array(CELLS3 * CELLS3);
      this.corner = new Float64Array(2);
      this.sharp = new Float32Array(CELLS3 * CELLS3);
      this.soft = new Float32Array(CELLS3 * CELLS3);
      this.spare = new Float32Array(CELLS3 * CELLS3);
      const cells = (length) => Math.max(1, Math.round(length / this.grain));
      this.reach = [cells(12e-4), cells(0.045 * Math.max(...surface.size))];
    }
    /**
     * @param {Float64Array} frame of the plate
     * @param {ArrayLike<number>} light towards it, plate frame
     */
    cast(frame, light) {
      const { surface, sharp, soft, dark, grain, corner } = this, { points, area } = surface;
      for (let d = 0; d < 2; d++) corner[d] = (Math.round(surface.centre[d] / grain) - CELLS3 / 2) * grain;
      sharp.fill(0);
      soft.fill(0);
      const ax = frame[0], bx = frame[1], nx = frame[2], ay = frame[3], by = frame[4], ny = frame[5];
      const az = frame[6], bz = frame[7], nz = frame[8], ox = frame[9], oy = frame[10], oz = frame[11];
      const leanX = light[0] / light[2], leanY = light[1] / light[2], cell3 = 1 / (grain * grain);
      for (let k = 0, p = 0; p < points.length; k++, p += 3) {
        const x = points[p] - ox, y = points[p + 1] - oy, z = points[p + 2] - oz;
        const height = nx * x + ny * y + nz * z;
        if (height < -5e-3) continue;
        const up = Math.max(height, 0);
        const u = (ax * x + ay * y + az * z - up * leanX - corner[0]) / grain - 0.5;
        const v = (bx * x + by * y + bz * z - up * leanY - corner[1]) / grain - 0.5;
        const i = Math.floor(u), j = Math.floor(v);
        if (!(i >= 2 && j >= 2 && i < CELLS3 - 3 && j < CELLS3 - 3)) continue;
        const close = Math.exp(-up / NEAR), whole2 = area[k] * cell3;
        spread(sharp, i, j, u - i, v - j, whole2 * close);
        spread(soft, i, j, u - i, v - j, whole2 * (1 - close));
      }
      blur(sharp, this.spare, this.reach[0]);
      blur(soft, this.spare, this.reach[1]);
      for (let k = 0; k < dark.length; k++)
        dark[k] = 255 * Math.min(0.7, 0.55 * Math.min(1, sharp[k]) + 0.42 * Math.min(1, soft[k]));
      clearEdge(dark);
    }
  };
  var spread = (grid, i, j, s, t, weight) => {
    const k = j * CELLS3 + i;
    grid[k] += weight * (1 - s) * (1 - t);
    grid[k + 1] += weight * s * (1 - t);
    grid[k + CELLS3] += weight * (1 - s) * t;
    grid[k + CELLS3 + 1] += weight * s * t;
  };
  var blur = (grid, spare, reach) => {
    for (let pass = 0; pass < 2; pass++) {
      for (let line = 0; line < CELLS3; line++) runningMean(grid, spare, line * CELLS3, 1, reach);
      for (let line = 0; line < CELLS3; line++) runningMean(spare, grid, line, CELLS3, reach);
    }
  };
  var runningMean = (from, to, start, stride, reach) => {
    const width = 2 * reach + 1;
    let sum2 = 0;
    for (let k = 0; k <= reach; k++) sum2 += from[start + k * stride];
    for (let k = 0; k < CELLS3; k++) {
      to[start + k * stride] = sum2 / width;
      if (k + reach + 1 < CELLS3) sum2 += from[start + (k + reach + 1) * stride];
      if (k - reach >= 0) sum2 -= from[start + (k - reach) * stride];
    }
  };
  var clearEdge = (dark) => {
    for (let k = 0; k < CELLS3; k++)
      dark[k] = dark[(CELLS3 - 1) * CELLS3 + k] = dark[k * CELLS3] = dark[k * CELLS3 + CELLS3 - 1] = 0;
  };

  // src/view/plate.js
  var SLAB = 0.035;
  var BAR2 = 0.03;
  var WITHOUT_END = 1.1;
  var SHOWN = 0.6;
  var WANDERED = 0.3;
  var BAR_ENDS = 3.4;
  var VERTEX5 = (
    /* glsl */
    `
  ${HALFWAY}
  varying vec2 vPlace;
  void main() {
    vec4 at = modelMatrix * vec4(position, 1.0);
    face(normalize(transpose(inverse(mat3(modelMatrix))) * normal), at.xyz);
    vPlace = position.xy;
    gl_Position = projectionMatrix * viewMatrix * at;
  }
`
  );
  var SURFACE_VERTEX = (
    /* glsl */
    `
  uniform vec3 uLight;
  uniform vec2 uShift;
  varying vec2 vPlace;
  varying float vMatt;
  void main() {
    vec3 up = normalize(transpose(inverse(mat3(modelMatrix))) * normal);
    vMatt = ${MATT("up")};
    vPlace = position.xy + uShift;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(vPlace, 0.0, 1.0);
  }
`
  );
  var SURFACE = (
    /* glsl */
    `
  uniform vec3 uColour, uGrid, uAxis, uDark;
  uniform vec2 uHalf, uCorner, uShift;
  uniform float uPitch, uWindow, uFade;
  uniform sampler2D uShadow;
  varying vec2 vPlace;
  varying float vMatt;
  void main() {
    vec2 px = fwidth(vPlace) + 1e-9;
    vec2 off = abs(fract(vPlace / uPitch + 0.5) - 0.5) * uPitch / px;
    float line = clamp(1.2 - min(off.x, off.y), 0.0, 1.0) * clamp(uPitch / (6.0 * max(px.x, px.y)), 0.0, 1.0);
    vec3 colour = uColour * vMatt;
    colour = mix(colour, uGrid, line);
    colour = mix(colour, uAxis, clamp(1.4 - abs(vPlace.y) / px.y, 0.0, 1.0));
    vec2 window = (vPlace - uCorner) / uWindow - 0.5;
    if (max(abs(window.x), abs(window.y)) < 0.5) colour = mix(colour, uDark, texture2D(uShadow, window + 0.5).r);
    vec2 share = abs(vPlace - uShift) / uHalf, cubes = share * share * share;
    gl_FragColor = vec4(colour, 1.0 - uFade * smoothstep(0.24, 1.0, cubes.x + cubes.y));
  }
`
  );
  var SOLID = (
    /* glsl */
    `
  ${LIT}
  uniform vec3 uColour;
  uniform float uFade;
  varying vec2 vPlace;
  void main() {
    vec3 normal = normalize(vNormal);
    float alpha = 1.0 - smoothstep(0.45 * uFade, uFade, abs(vPlace.x));
    gl_FragColor = vec4(uColour * matt(normal) + 0.12 * shine(normal), alpha);
  }
`
  );
  var PlateMesh = class {
    /**
     * @param {object} scenario
     * @param {number[]} size of the sheet, m
     * @param {import("./shadow.js").Shadow} shadow
     * @param {object} shared uniforms
     */
    constructor({ plate }, size, shadow, shared) {
      this.shadow = shadow;
      this.endless = plate === null || plate === void 0;
      const far = WITHOUT_END * Math.max(...size);
      this.half = this.endless ? [far, far] : [plate.length / 2, plate.width / 2];
      this.shown = this.endless ? [SHOWN * far, SHOWN * far] : this.half;
      this.corners = cornersOf(this.shown, this.endless);
      this.slab = 2 * SLAB * Math.min(...this.shown);
      this.bar = 2 * BAR2 * Math.min(...this.shown);
      this.pitch = 10 ** Math.round(Math.log10(2 * Math.max(...this.shown) / 8));
      this.texture = new import_three9.DataTexture(shadow.dark, CELLS3, CELLS3, import_three9.RedFormat, import_three9.UnsignedByteType);
      this.texture.minFilter = this.texture.magFilter = import_three9.LinearFilter;
      this.uniforms = this.makeUniforms(shared);
      this.group = new import_three9.Group();
      this.group.matrixAutoUpdate = false;
      const surface = this.add(rectangle(this.half), SURFACE, this.uniforms, this.endless, SURFACE_VERTEX);
      surface.renderOrder = 1;
      this.bodies = new import_three9.Group();
      this.group.add(this.bodies);
      this.metal = { ...shared, uColour: { value: new import_three9.Vector3() }, uFade: { value: BAR_ENDS * this.half[0] } };
      const depth = this.endless ? this.bar : this.slab + this.bar;
      this.bodies.add(this.add(cylinder(this.half[0], this.bar, depth), SOLID, this.metal, true));
      if (this.endless) return;
      this.body = { ...shared, uColour: { value: new import_three9.Vector3() }, uFade: { value: 1e6 } };
      this.bodies.add(this.add(slab(this.half, this.slab), SOLID, this.body, false));
    }
    makeUniforms(shared) {
      return {
        ...shared,
        uColour: { value: new import_three9.Vector3() },
        uGrid: { value: new import_three9.Vector3() },
        uAxis: { value: new import_three9.Vector3() },
        uDark: { value: new import_three9.Vector3() },
        uHalf: { value: new import_three9.Vector2(...this.half) },
        uCorner: { value: new import_three9.Vector2() },
        uPitch: { value: this.pitch },
        uWindow: { value: CELLS3 * this.shadow.grain },
        uShift: { value: new import_three9.Vector2() },
        uFade: { value: this.endless ? 1 : 0 },
        uShadow: { value: this.texture }
      };
    }
    add(geometry, fragmentShader, uniforms, transparent, vertexShader = VERTEX5) {
      const material = new import_three9.ShaderMaterial({ vertexShader, fragmentShader, uniforms, transparent });
      const mesh = new import_three9.Mesh(geometry, material);
      mesh.frustumCulled = false;
      this.group.add(mesh);
      return mesh;
    }
    recolour({ plate, ink, paper, dark }) {
      this.uniforms.uColour.value.fromArray(plate);
      this.uniforms.uGrid.value.fromArray(mix(plate, dark ? paper : ink, dark ? 0.28 : 0.13));
      this.uniforms.uAxis.value.fromArray(mix(plate, ink, 0.5));
      this.uniforms.uDark.value.fromArray(dark ? [0.02, 0.03, 0.05] : [0.14, 0.18, 0.24]);
      this.metal.uColour.value.fromArray(mix(plate, dark ? ink : [0.42, 0.45, 0.5], 0.3));
      this.body?.uColour.value.fromArray(plate);
    }
    /**
     * @param {import("three").Matrix4} pose of the plate
     * @param {number} exaggerated how much higher than they are heights are drawn
     * @param {ArrayLike<number>} centre of the sheet on the plate, m
     */
    update(pose, exaggerated, centre) {
      if (this.endless) this.uniforms.uShift.value.set(beyond(centre[0], this.half[0]), beyond(centre[1], this.half[1]));
      this.group.matrix.copy(pose);
      this.group.matrixWorldNeedsUpdate = true;
      this.bodies.scale.set(1, 1, 1 / exaggerated);
      this.texture.needsUpdate = true;
      this.uniforms.uCorner.value.set(this.shadow.corner[0], this.shadow.corner[1]);
    }
    dispose() {
      this.texture.dispose();
      this.group.traverse((object) => {
        object.geometry?.dispose();
        object.material?.dispose();
      });
    }
  };
  var beyond = (at2, half) => at2 - Math.min(Math.max(at2, -WANDERED * half), WANDERED * half);
  var cornersOf = ([a, b], endless) => {
    if (!endless) return [[-a, -b], [a, -b], [a, b], [-a, b]];
    const around2 = Array.from({ length: 8 }, (_, k) => k * Math.PI / 4);
    return around2.map((angle) => [1.2 * a * Math.cos(angle), 1.2 * b * Math.sin(angle)]);
  };
  var geometryOf = (positions, normals, index) => {
    const geometry = new import_three9.BufferGeometry();
    geometry.setAttribute("position", new import_three9.BufferAttribute(Float32Array.from(positions), 3));
    geometry.setAttribute("normal", new import_three9.BufferAttribute(Float32Array.from(normals), 3));
    return geometry.setIndex(index);
  };
  var rectangle = ([a, b]) => geometryOf([-a, -b, 0, a, -b, 0, a, b, 0, -a, b, 0], [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1], [0, 1, 2, 0, 2, 3]);
  var slab = ([a, b], depth) => {
    const corners2 = [[-a, -b], [a, -b], [a, b], [-a, b]], outward = [[0, -1], [1, 0], [0, 1], [-1, 0]];
    const positions = [], normals = [], index = [];
    const face = (points, normal) => {
      const first = positions.length / 3;
      for (const point of points) {
        positions.push(...point);
        normals.push(...normal);
      }
      index.push(first, first + 1, first + 2, first, first + 2, first + 3);
    };
    corners2.forEach((corner, k) => {
      const next = corners2[(k + 1) % 4];
      face([[...corner, -depth], [...next, -depth], [...next, 0], [...corner, 0]], [...outward[k], 0]);
    });
    face([...corners2].reverse().map((corner) => [...corner, -depth]), [0, 0, -1]);
    return geometryOf(positions, normals, index);
  };
  var AROUND2 = 24;
  var cylinder = (from, radius, depth) => {
    const positions = [], normals = [], index = [];
    for (let k = 0; k <= AROUND2; k++) {
      const y = Math.cos(2 * Math.PI * k / AROUND2), z = Math.sin(2 * Math.PI * k / AROUND2);
      for (const x of [0, -BAR_ENDS * from]) {
        positions.push(x, radius * y, radius * z - depth);
        normals.push(0, y, z);
      }
      if (k > 0) index.push(2 * k - 2, 2 * k, 2 * k - 1, 2 * k - 1, 2 * k, 2 * k + 1);
    }
    return geometryOf(positions, normals, index);
  };

  // src/view/print.js
  var import_three11 = __toESM(require_three(), 1);

  // src/view/decal.js
  var import_three10 = __toESM(require_three(), 1);
  var VERTEX6 = (
    /* glsl */
    `
  attribute vec2 place;
  varying vec2 vPlace;
  void main() {
    vPlace = place;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }
`
  );
  var FRAGMENT5 = (
    /* glsl */
    `
  uniform sampler2D uPicture;
  varying vec2 vPlace;
  void main() {
    gl_FragColor = texture2D(uPicture, vPlace);
  }
`
  );
  var Decal = class {
    /**
     * @param {number} width px of the picture
     * @param {number} height
     * @param {number[]} corners x and y of lower left, lower right, upper right, upper left, m
     */
    constructor(width, height, corners2) {
      this.canvas = document.createElement("canvas");
      this.canvas.width = width;
      this.canvas.height = height;
      this.texture = new import_three10.CanvasTexture(this.canvas);
      this.texture.anisotropy = 4;
      const geometry = new import_three10.BufferGeometry(), at2 = [0, 1, 2, 3].flatMap((k) => [corners2[2 * k], corners2[2 * k + 1], 0]);
      geometry.setAttribute("position", new import_three10.BufferAttribute(Float32Array.from(at2), 3));
      geometry.setAttribute("place", new import_three10.BufferAttribute(Float32Array.from([0, 0, 1, 0, 1, 1, 0, 1]), 2));
      geometry.setIndex([0, 1, 2, 0, 2, 3]);
      const material = new import_three10.ShaderMaterial({
        vertexShader: VERTEX6,
        fragmentShader: FRAGMENT5,
        uniforms: { uPicture: { value: this.texture } },
        transparent: true,
        depthWrite: false,
        polygonOffset: true,
        polygonOffsetFactor: -1,
        polygonOffsetUnits: -2
      });
      this.mesh = new import_three10.Mesh(geometry, material);
      this.mesh.frustumCulled = false;
      this.mesh.renderOrder = 2;
    }
    /** @param {(pen: CanvasRenderingContext2D, width: number, height: number) => void} draw onto what is clear */
    paint(draw) {
      const { width, height } = this.canvas, pen = this.canvas.getContext("2d");
      pen.clearRect(0, 0, width, height);
      draw(pen, width, height);
      this.texture.needsUpdate = true;
    }
    dispose() {
      this.texture.dispose();
      this.mesh.geometry.dispose();
      this.mesh.material.dispose();
    }
  };

  // src/view/print.js
  var WIDE2 = 0.137;
  var LENGTH3 = 1024;
  var NAME = [256, 64];
  var marksAlong = (half, pitch) => {
    const marks = [], n = Math.floor(half / pitch + 1e-6), every = n > 8 ? 5 : 2;
    for (let k = -2 * n; k <= 2 * n; k++) {
      const numbered = k % (2 * every) === 0, length = numbered ? 1 : k % 2 === 0 ? 0.66 : 0.4;
      const text = numbered ? String(Number((500 * k * pitch).toPrecision(6))).replace("-", "−") : "";
      marks.push({ at: k * pitch / 2, length, text });
    }
    return marks;
  };
  var Print = class {
    /** @param {number[]} half of the plate's length and width, as measured, m @param {number} pitch of its grid */
    constructor([a, b], pitch) {
      this.pitch = pitch;
      const wide = WIDE2 * Math.min(a, b);
      const ruler = (reach2, corners2, free) => ({ reach: reach2, free, decal: new Decal(LENGTH3, Math.round(LENGTH3 * wide / (2 * reach2)), corners2) });
      this.rulers = [
        ruler(a, [-a, -b, a, -b, a, wide - b, -a, wide - b], a - 1.3 * wide),
        ruler(b, [a, -b, a, b, a - wide, b, a - wide, -b], b)
      ];
      const low = a - 1.25 * wide, high = low - 1.1 * wide, reach = 0.55 * wide * NAME[0] / NAME[1];
      const word = (y) => new Decal(...NAME, [low, y - reach, low, y + reach, high, y + reach, high, y - reach]);
      const places = { left: 0.54 * b, right: -0.54 * b };
      this.words = ["left", "right"].flatMap((side) => [true, false].map((touches) => ({ side, touches, text: `${side} leg`, decal: word(places[side]) })));
      this.words.push({ side: "", touches: false, text: "in flight", decal: word(0) });
      this.names = new import_three11.Group();
      this.names.add(...this.words.map(({ decal }) => decal.mesh));
      this.group = new import_three11.Group();
      this.group.add(...this.rulers.map(({ decal }) => decal.mesh), this.names);
    }
    recolour(colours2) {
      const { plate, ink, font, dark } = colours2;
      for (const { decal, reach, free } of this.rulers)
        decal.paint((pen, width, height) => {
          pen.fillStyle = pen.strokeStyle = css(mix(plate, ink, dark ? 0.72 : 0.62));
          pen.lineWidth = 2;
          write(pen, Math.round(0.52 * height), font);
          for (const { at: at2, length, text } of marksAlong(0.985 * reach, this.pitch)) {
            const x = (at2 / reach + 1) * width / 2, half = pen.measureText(text).width / 2 + 2;
            pen.beginPath();
            pen.moveTo(x, height);
            pen.lineTo(x, height * (1 - 0.3 * length));
            pen.stroke();
            const fits = x > half && x < width - half && at2 < free;
            if (text && fits) pen.fillText(text === "0" ? "0 mm" : text, x, 0.6 * height);
          }
        });
      for (const { side, touches, text, decal } of this.words)
        decal.paint((pen, width, height) => {
          pen.fillStyle = pen.strokeStyle = css(side ? mix(colours2[side], ink, 0.25) : ink);
          write(pen, Math.round(0.62 * height), font);
          if (side) drawFoot(pen, width / 2 - pen.measureText(text).width / 2 - 0.16 * height, 0.48 * height, touches);
          pen.fillText(text, width / 2 + (side ? 0.16 * height : 0), 0.7 * height);
        });
    }
    /** Which leg touches. @param {{left: boolean, right: boolean}} touching */
    showLegs({ left, right }) {
      for (const { side, touches, decal } of this.words)
        decal.mesh.visible = side === "" ? !left && !right : touches === (side === "left" ? left : right);
    }
    dispose() {
      for (const { decal } of this.rulers) decal.dispose();
      for (const { decal } of this.words) decal.dispose();
    }
  };
  var drawFoot = (pen, x, y, touches) => {
    pen.lineWidth = 4;
    pen.beginPath();
    pen.arc(x, y, 9, 0, 2 * Math.PI);
    pen.stroke();
    if (touches) pen.fill();
  };
  var write = (pen, size, font) => {
    pen.font = `${size}px ${font}`;
    pen.textAlign = "center";
    pen.textBaseline = "alphabetic";
  };

  // src/view/push.js
  var HEAD = 0.28;
  var PushArrow = class {
    constructor(size, shared) {
      this.most = Math.max(...size) / 9;
      this.lines = new Lines(3, shared, { width: 8 });
      this.mesh = this.lines.mesh;
      this.mesh.renderOrder = 9;
      this.mesh.visible = false;
    }
    recolour({ ink, paper }) {
      this.lines.colour(ink, paper);
    }
    /** From one place to another, in the plate's frame. */
    show(from, to) {
      const dx = to[0] - from[0], dy = to[1] - from[1], length = Math.hypot(dx, dy);
      this.mesh.visible = length > 1e-4;
      if (!this.mesh.visible) return;
      const head = Math.min(HEAD * length, this.most), ux = head * dx / length, uy = head * dy / length;
      this.mesh.position.z = from[2];
      this.lines.count = 0;
      this.lines.add(from[0], from[1], to[0], to[1], 0, 1);
      this.lines.add(to[0], to[1], to[0] - ux - 0.55 * uy, to[1] - uy + 0.55 * ux, 0, 1);
      this.lines.add(to[0], to[1], to[0] - ux + 0.55 * uy, to[1] - uy - 0.55 * ux, 0, 1);
      this.lines.upload();
    }
    hide() {
      this.mesh.visible = false;
    }
    dispose() {
      this.lines.dispose();
    }
  };

  // src/view/gl_picture.js
  var MOST_PIXELS_PER_PX = 2;
  var contextOf = (canvas) => canvas.getContext("webgl2", { alpha: false, antialias: !drawnByProcessor(), stencil: false });
  var GlPicture = class {
    /**
     * @param {HTMLCanvasElement} canvas
     * @param {WebGL2RenderingContext} gl
     * @param {import("./camera.js").ViewCamera} view
     */
    constructor(canvas, gl, view) {
      this.view = view;
      this.renderer = new import_three12.WebGLRenderer({ canvas, context: gl, alpha: false, stencil: false });
      this.renderer.sortObjects = true;
      this.gl = gl;
      this.pace = drawnByProcessor() ? new Pace() : null;
      this.fence = null;
      this.scene = new import_three12.Scene();
      this.shared = sharedUniforms();
      this.world = new import_three12.Group();
      this.world.matrixAutoUpdate = false;
      this.onPlate = new import_three12.Group();
      this.onPlate.matrixAutoUpdate = false;
      this.world.add(this.onPlate);
      this.notes = new Notes(this.shared);
      this.scene.add(this.world, this.notes.mesh);
      this.pose = new import_three12.Matrix4();
      this.back = new import_three12.Matrix4();
      this.light = new import_three12.Vector3();
      this.parts = [];
      this.past = [];
      this.ratio = 1;
    }
    /** Build what is drawn of a sheet. @param {import("./shown.js").Shown} shown */
    build(shown4) {
      this.past.push(...this.parts);
      this.world.clear();
      this.onPlate.clear();
      this.shown = shown4;
      const { scenario, surface } = shown4, { shared } = this;
      this.shadow = new Shadow(surface);
      this.plate = new PlateMesh(scenario, surface.size, this.shadow, shared);
      this.sheet = new SheetMesh(surface, shared);
      this.marks = new Marks(scenario, shown4.nNodes, shared);
      this.trail = new Trail(shown4, shared);
      this.goal = new Contour(surface, shared, { width: 4.5, dash: Math.max(...surface.size) / 14 });
      this.ghost = new Contour(surface, shared, { width: 4 });
      this.cloud = new Cloud(scenario, shown4.lattice, shared);
      this.arrow = new PushArrow(surface.size, shared);
      this.print = new Print(this.plate.shown, this.plate.pitch);
      this.parts = [this.plate, this.sheet, this.marks, this.trail, this.goal, this.ghost, this.cloud, this.arrow];
      this.parts.push(this.print);
      this.onPlate.add(...this.trail.meshes, this.goal.mesh, this.ghost.mesh, this.arrow.mesh, this.print.group);
      this.world.add(this.onPlate, this.plate.group, this.sheet.group, this.marks.group, this.cloud.group);
      return this.plate.corners;
    }
    recolour(colours2) {
      this.colours = colours2;
      const [red, green, blue] = colours2.panel.map((value) => Math.round(255 * value));
      this.renderer.setClearColor(red << 16 | green << 8 | blue, 1);
      this.parts.forEach((part) => part.recolour?.(colours2));
      this.goal?.colour(colours2.failed, colours2.paper);
      this.ghost?.colour(colours2.accent, colours2.paper);
    }
    /** @param {number} width CSS px @param {number} height @param {number} pixels of the screen over CSS px */
    resize(width, height, pixels) {
      this.size = [width, height];
      this.pixels = Math.min(pixels, MOST_PIXELS_PER_PX);
      this.setRatio(this.moving);
    }
    /** Pixels over CSS px while the picture moves. */
    get moving() {
      return this.pace ? this.pace.moving(this.size[0] * this.size[1], this.pixels) : this.pixels;
    }
    setRatio(ratio) {
      const { renderer, shared } = this;
      this.ratio = ratio;
      renderer.setPixelRatio(ratio);
      renderer.setSize(...this.size, false);
      shared.uViewport.value.set(renderer.domElement.width, renderer.domElement.height);
      shared.uRatio.value = ratio;
    }
    /** Where the processor draws, moving pictures have rough edges: one that stands still for a while is drawn finer. */
    get finer() {
      return this.pace !== null && this.ratio === this.moving;
    }
    /** Pixels over CSS px of the picture that comes next. */
    nextRatio(still) {
      if (this.pace === null) return this.moving;
      if (still) return this.pace.still(this.size[0] * this.size[1], this.pixels);
      const { gl, fence } = this, finished = !fence || gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.SIGNALED;
      this.pace.next(performance.now(), finished);
      return this.moving;
    }
    /** To be asked of later: whether what was drawn is finished. */
    setFence() {
      const { gl } = this;
      if (this.pace === null) return;
      if (this.fence) gl.deleteSync(this.fence);
      this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    }
    /**
     * @param {object} asked what of it is wanted: layers, exaggerated, goal, ghost, cloud, push
     * @param {boolean} [still] whether it will stand for a while
     */
    draw(asked, still = false) {
      const { shown: shown4, view, renderer } = this, ratio = this.nextRatio(still);
      if (ratio !== this.ratio) this.setRatio(ratio);
      this.placeWorld(asked.exaggerated);
      this.sheet.group.visible = this.marks.group.visible = shown4.there;
      if (shown4.there) this.updateSheet(asked);
      else this.shadow.dark.fill(0);
      this.plate.update(this.pose, asked.exaggerated, shown4.surface.centre);
      for (const mesh of this.trail.meshes) mesh.visible = asked.layers.trail;
      this.goal.place(asked.goal);
      this.ghost.place(asked.ghost);
      this.cloud.show(asked.cloud);
      if (asked.push) this.arrow.show(asked.push.from, asked.push.to);
      else this.arrow.hide();
      this.notes.say(asked.said, this.colours, this.ratio);
      this.shared.uEye.value.copy(view.camera.position);
      this.shared.uClear.value = clearness(view.elevation);
      renderer.render(this.scene, view.camera);
      while (this.past.length) this.past.pop().dispose();
      this.setFence();
    }
    updateSheet({ layers: layers2, exaggerated, said: said2 }) {
      const { shown: shown4, sheet } = this, { touching, frame } = shown4;
      const { x: lx, y: ly, z } = this.shared.uLight.value, lz = z / exaggerated;
      this.light.set(
        frame[0] * lx + frame[3] * ly + frame[6] * lz,
        frame[1] * lx + frame[4] * ly + frame[7] * lz,
        frame[2] * lx + frame[5] * ly + frame[8] * lz
      );
      this.shadow.cast(frame, this.light.toArray(this.towards ??= [0, 0, 1]));
      sheet.showBent(layers2.bending);
      if (layers2.bending) said2.most = shown4.bent(layers2.bending, sheet.bent);
      const on = layers2.legs && !layers2.bending;
      this.print.names.visible = on;
      this.print.showLegs(touching);
      sheet.showLegs(on, touching);
      sheet.update(frame, this.leastSlope(exaggerated));
      this.marks.group.visible = layers2.contact || layers2.forces;
      if (this.marks.group.visible)
        this.marks.update(shown4.nodes, shown4.onPlate, shown4.hasForces ? shown4.forces : null, frame, layers2);
      this.trail.update();
    }
    /** From above, cosine of the slopes whose lower faces come to be seen: the lower the eye, the flatter they may be. */
    leastSlope(exaggerated) {
      const seen = this.view.elevation - 0.3;
      return seen > 0 && exaggerated === 1 ? Math.cos(seen) : 2;
    }
    /** The plate's pose, and how the world is drawn: heights exaggerated, or the plate at rest and the world moving. */
    placeWorld(exaggerated) {
      const f = this.shown.frame;
      this.pose.set(f[0], f[1], f[2], f[9], f[3], f[4], f[5], f[10], f[6], f[7], f[8], f[11], 0, 0, 0, 1);
      this.onPlate.matrix.copy(this.pose);
      const { matrix } = this.world;
      matrix.makeScale(1, 1, exaggerated);
      if (this.view.riding) matrix.multiply(this.back.copy(this.pose).invert());
      this.world.updateMatrixWorld(true);
      this.shared.uTurn.value.getNormalMatrix(matrix);
    }
    /** The ray that a place of the picture, CSS px, shows: in the data's world. */
    rayAt(x, y) {
      const { camera } = this.view, [width, height] = this.size;
      this.back.copy(this.world.matrix).invert();
      const far = new import_three12.Vector3(2 * x / width - 1, 1 - 2 * y / height, 0.5).unproject(camera).applyMatrix4(this.back);
      const from = camera.position.clone().applyMatrix4(this.back);
      return { from: from.toArray(), way: far.sub(from).normalize().toArray() };
    }
    dispose() {
      for (const part of [...this.parts, ...this.past]) part.dispose();
      this.notes.dispose();
      this.renderer.dispose();
      this.gl.getExtension("WEBGL_lose_context")?.loseContext();
    }
  };
  var clearness = (elevation) => Math.min(1, Math.max(0, (Math.abs(Math.sin(elevation)) - 0.1) / 0.12));
  var drawnByProcessor = () => {
    if (byProcessor === null) {
      const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
      const firefox = navigator.userAgent.includes("Firefox");
      const name = firefox ? gl?.RENDERER : gl?.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL;
      byProcessor = /swiftshader|llvmpipe|software|basic render/i.test(name ? String(gl.getParameter(name)) : "");
    }
    return byProcessor;
  };
  var byProcessor = null;

  // src/view/pointing.js
  var PER_DRAG = 8;
  var FASTEST = 1.2;
  var meetPlane = (from, way, frame, height) => {
    const normal = [frame[2], frame[5], frame[8]];
    let down = 0, above = -height;
    for (let d = 0; d < 3; d++) {
      down += way[d] * normal[d];
      above += (from[d] - frame[9 + d]) * normal[d];
    }
    const far = -above / down;
    return Math.abs(down) > 1e-6 && far > 0 && Number.isFinite(far) ? [0, 1, 2].map((d) => from[d] + far * way[d]) : null;
  };
  var nearestNode = (from, way, nodes) => {
    const length = Math.hypot(...way);
    let best = { node: -1, off: Infinity };
    for (let k = 0; k < nodes.length / 3; k++) {
      const x = nodes[3 * k] - from[0], y = nodes[3 * k + 1] - from[1], z = nodes[3 * k + 2] - from[2];
      const along = (x * way[0] + y * way[1] + z * way[2]) / length;
      const off = Math.sqrt(Math.max(0, x * x + y * y + z * z - along * along));
      if (along > 0 && off < best.off) best = { node: k, off };
    }
    return best;
  };
  var pushOf = (at2, to) => {
    const drag = [0, 1, 2].map((d) => PER_DRAG * (to[d] - at2[d]));
    const speed = Math.hypot(...drag), share2 = speed > FASTEST ? FASTEST / speed : 1;
    return { at: [at2[0], at2[1]], velocity: drag.map((v) => v * share2) };
  };
  var wayOf = (direction, azimuth) => {
    const right = [-Math.sin(azimuth), Math.cos(azimuth), 0], away2 = [-Math.cos(azimuth), -Math.sin(azimuth), 0];
    const ways = { right, left: right.map((v) => -v), away: away2, towards: away2.map((v) => -v), up: [0, 0, 1] };
    return ways[direction] ?? null;
  };

  // src/view/curvature.js
  var Curvature = class {
    constructor(sheet, lattice2) {
      const { squares: squares2, nNodes, rows } = lattice2;
      const at2 = /* @__PURE__ */ new Map();
      for (let k = 0; k < nNodes; k++) at2.set(squares2[2 * k] * (rows + 2) + squares2[2 * k + 1], k);
      const neighbour = (k, di, dj) => at2.get((squares2[2 * k] + di) * (rows + 2) + squares2[2 * k + 1] + dj) ?? -1;
      this.pitch = sheet.pitch;
      this.neighbours = new Int32Array(4 * nNodes);
      for (let k = 0; k < nNodes; k++)
        this.neighbours.set([neighbour(k, -1, 0), neighbour(k, 1, 0), neighbour(k, 0, -1), neighbour(k, 0, 1)], 4 * k);
      this.values = new Float32Array(nNodes);
      this.most = 0;
    }
    /** @param {Float32Array} nodes world, m @param {Float64Array} frame of the plate */
    update(nodes, frame) {
      const { neighbours, values } = this;
      this.most = 0;
      for (let k = 0; k < values.length; k++) {
        const a = neighbours[4 * k], b = neighbours[4 * k + 1], c = neighbours[4 * k + 2], d = neighbours[4 * k + 3];
        let nx = frame[2], ny = frame[5], nz = frame[8];
        const along = a >= 0 && b >= 0, across = c >= 0 && d >= 0;
        if (along && across) {
          const i = 3 * a, j = 3 * b, m = 3 * c, n = 3 * d;
          const ux = nodes[j] - nodes[i], uy = nodes[j + 1] - nodes[i + 1], uz = nodes[j + 2] - nodes[i + 2];
          const vx = nodes[n] - nodes[m], vy = nodes[n + 1] - nodes[m + 1], vz = nodes[n + 2] - nodes[m + 2];
          nx = uy * vz - uz * vy;
          ny = uz * vx - ux * vz;
          nz = ux * vy - uy * vx;
          const length = Math.sqrt(nx * nx + ny * ny + nz * nz) || 1;
          nx /= length;
          ny /= length;
          nz /= length;
        }
        let bent = 0;
        if (along) bent += second(nodes, a, k, b, nx, ny, nz);
        if (across) bent += second(nodes, c, k, d, nx, ny, nz);
        values[k] = -bent / (2 * this.pitch * this.pitch);
        this.most = Math.max(this.most, Math.abs(values[k]));
      }
    }
  };
  var second = (p, a, k, b, nx, ny, nz) => nx * (p[3 * a] - 2 * p[3 * k] + p[3 * b]) + ny * (p[3 * a + 1] - 2 * p[3 * k + 1] + p[3 * b + 1]) + nz * (p[3 * a + 2] - 2 * p[3 * k + 2] + p[3 * b + 2]);

  // src/view/way.js
  var MOST2 = 1200;
  var SHORTEST = 2e-4;
  var Way = class {
    constructor(most = MOST2) {
      this.most = most;
      this.places = new Float64Array(2 * (most + 1));
      this.times = new Float64Array(most + 1);
      this.count = 0;
    }
    clear() {
      this.count = 0;
    }
    /** What was reached later than a time is forgotten: the picture went back to it. */
    backTo(time) {
      let n = this.count;
      while (n > 0 && this.times[n - 1] > time) n--;
      const changed2 = n !== this.count;
      this.count = n;
      return changed2;
    }
    /** Whether the place is far enough from the last one to count. */
    add(x, y, time) {
      const n = this.count;
      if (n > 0 && Math.hypot(x - this.places[2 * n - 2], y - this.places[2 * n - 1]) < SHORTEST) return false;
      if (n > this.most) this.forget(n >> 2);
      this.places[2 * this.count] = x;
      this.places[2 * this.count + 1] = y;
      this.times[this.count++] = time;
      return true;
    }
    /** The oldest go first. */
    forget(n) {
      this.places.copyWithin(0, 2 * n, 2 * this.count);
      this.times.copyWithin(0, n, this.count);
      this.count -= n;
    }
  };

  // src/view/shown.js
  var STEPS3 = [1, 1.5, 2, 3, 5, 7];
  var LEAST_BENT = 0.05;
  var Shown = class {
    /** @param {object} scenario @param {object} lattice of its sheet */
    constructor(scenario, lattice2) {
      this.scenario = scenario;
      this.lattice = lattice2;
      this.surface = new SheetSurface(scenario.sheet, lattice2);
      this.curvature = new Curvature(scenario.sheet, lattice2);
      this.height = scenario.motion.height;
      this.nNodes = this.surface.nNodes;
      this.nodes = new Float32Array(3 * this.nNodes);
      this.onPlate = new Float32Array(3 * this.nNodes);
      this.forces = new Float32Array(3 * this.nNodes);
      this.hasForces = false;
      this.pose = new Float64Array(6);
      this.frame = new Float64Array(FRAME_SIZE);
      this.time = 0;
      this.way = new Way();
      this.ways = 0;
      this.touching = { left: false, right: false };
      this.most = { curvature: 0, height: 0 };
      this.there = false;
      plateFrame(this.pose, this.height, this.frame);
    }
    /**
     * Take over a frame; whether it can be drawn: it is of this sheet, and all of it is finite.
     * @param {{nodes: ArrayLike<number>, pose: ArrayLike<number>, forces?: ArrayLike<number>, time?: number}} frame
     */
    take(frame) {
      if (!this.couldTake(frame)) return false;
      const { nodes, pose, forces = null, time = this.time } = frame;
      this.nodes.set(nodes);
      for (let d = 0; d < 6; d++) this.pose[d] = pose[d];
      this.time = time;
      this.hasForces = forces?.length === 3 * this.nNodes && allFinite(forces);
      if (this.hasForces) this.forces.set(forces);
      plateFrame(this.pose, this.height, this.frame);
      ontoPlate(this.frame, this.nodes, this.onPlate);
      this.surface.update(this.nodes, this.onPlate, this.frame);
      this.seeLegs();
      const x = this.surface.centre[0], y = this.surface.centre[1];
      if (this.way.backTo(time) | this.way.add(x, y, time)) this.ways++;
      this.there = true;
      return true;
    }
    couldTake({ nodes, pose, time = 0 }) {
      if (nodes?.length !== 3 * this.nNodes || !(pose?.length >= 6)) return false;
      return allFinite(nodes) && allFinite(pose) && Number.isFinite(time);
    }
    /** Whether the halves on either side of the bar's direction touch, where they are now. */
    seeLegs() {
      const { onPlate, forces, hasForces, touching } = this, middle = this.surface.centre[1];
      touching.left = touching.right = false;
      for (let k = 0; k < this.nNodes; k++) {
        if (hasForces ? !(forces[3 * k] > 0) : onPlate[3 * k + 2] > 0) continue;
        if (onPlate[3 * k + 1] > middle) touching.left = true;
        else touching.right = true;
      }
    }
    /** The same of a node, once `bent` was asked for the kind. */
    bentAt(kind, node) {
      const most = this.most[kind];
      if (kind === "height") return 2 * this.onPlate[3 * node + 2] / most - 1;
      return this.curvature.values[node] / most;
    }
    /** Forget the way so far. */
    forget() {
      this.way.clear();
      this.ways++;
    }
    /**
     * How bent or high the vertices are, from -1 to 1, into `values`; what 1 stands for, 1/m or m.
     * @param {"curvature" | "height"} kind
     */
    bent(kind, values) {
      const { surface, curvature, frame } = this, { points } = surface;
      if (kind === "curvature") {
        curvature.update(this.nodes, frame);
        surface.spline.spread(curvature.values, values);
        const least2 = 2 * LEAST_BENT / Math.min(...surface.size);
        this.most.curvature = roundedUp(Math.max(this.most.curvature, curvature.most, least2));
      } else {
        const nx = frame[2], ny = frame[5], nz = frame[8], ox = frame[9], oy = frame[10], oz = frame[11];
        let highest = LEAST_BENT * Math.min(...surface.size);
        for (let k = 0, p = 0; k < values.length; k++, p += 3) {
          values[k] = nx * (points[p] - ox) + ny * (points[p + 1] - oy) + nz * (points[p + 2] - oz);
          highest = Math.max(highest, values[k]);
        }
        this.most.height = roundedUp(Math.max(this.most.height, highest));
      }
      const most = this.most[kind];
      const scale = kind === "height" ? 2 / most : 1 / most, shift = kind === "height" ? -1 : 0;
      for (let k = 0; k < values.length; k++) values[k] = scale * values[k] + shift;
      return most;
    }
  };
  var roundedUp = (value) => {
    const ten = 10 ** Math.floor(Math.log10(value) + 1e-9);
    return ten * (STEPS3.find((step) => step * ten >= value * (1 - 1e-9)) ?? 10);
  };

  // src/view/view.js
  var LAYERS2 = { contact: true, forces: true, legs: true, trail: true, bending: "" };
  var MOST_EXAGGERATED = 10;
  var GRASP = 0.8;
  var STILL2 = 250;
  var LIVELY = 60;
  var drawnOf = ({ sheet: { outline, pitch, thickness, mass }, plate, motion, start, slip_limit, gravity }) => JSON.stringify([outline, pitch, thickness, mass, plate, motion.height, start, slip_limit, gravity]);
  var View = class {
    /** @param {HTMLCanvasElement} canvas of a size that the page gives it */
    constructor(canvas) {
      this.canvas = canvas;
      this.camera = new ViewCamera();
      this.asked = {
        layers: { ...LAYERS2 },
        exaggerated: 1,
        goal: null,
        ghost: null,
        cloud: [],
        push: null,
        said: { exaggerated: 1, bent: "", most: 0 }
      };
      this.shown = null;
      this.tellPush = null;
      this.held = null;
      this.waiting = 0;
      this.soon = this.settling = 0;
      this.drawn = 0;
      this.lively = -Infinity;
      this.stand = null;
      if (canvas.tabIndex < 0) canvas.tabIndex = 0;
      this.listen();
      const gl = contextOf(canvas);
      this.picture = gl ? new GlPicture(canvas, gl, this.camera) : new FlatPicture(canvas, this.camera);
      this.recolour();
      this.resize();
    }
    listen() {
      const { canvas } = this;
      this.lost = (event) => this.lose(event);
      this.restored = (event) => this.restore(event);
      canvas.addEventListener("webglcontextlost", this.lost);
      canvas.addEventListener("webglcontextrestored", this.restored);
      this.gestures = new Gestures(canvas, this.hands());
      this.themed = () => this.recolour();
      this.scheme = matchMedia("(prefers-color-scheme: dark)");
      this.scheme.addEventListener("change", this.themed);
      this.attributes = new MutationObserver(this.themed);
      this.attributes.observe(document.documentElement, { attributes: true });
      this.sizes = new ResizeObserver(() => this.resize());
      this.sizes.observe(canvas);
    }
    hands() {
      const seen = (act) => (...values) => {
        act(...values);
        this.redraw();
      };
      return {
        orbit: seen((byAzimuth, byElevation) => this.camera.orbit(byAzimuth, byElevation)),
        pan: seen((right, up) => this.camera.pan(right, up)),
        zoom: seen((factor) => this.camera.zoomBy(factor)),
        look: (name) => this.look(name),
        grasp: (x, y) => this.grasp(x, y),
        drag: (x, y) => this.drag(x, y),
        release: (letGo) => this.release(letGo),
        hover: (x, y) => {
          this.canvas.style.cursor = this.tellPush && this.sheetAt(x, y) ? "grab" : "";
        }
      };
    }
    /**
     * Show another sheet or plate; nothing is made anew where nothing of it that is drawn is another.
     * @param {object} scenario @param {object} lattice of its sheet
     */
    setSheet(scenario, lattice2) {
      const before = this.corners?.join(), drawn = drawnOf(scenario);
      if (drawn === this.sheet) return;
      this.sheet = drawn;
      this.shown = new Shown(scenario, lattice2);
      this.corners = this.picture.build(this.shown);
      this.picture.recolour(this.colours);
      this.stand?.build(this.shown);
      this.held = this.asked.push = null;
      this.asked.cloud = [];
      if (this.corners.join() !== before) this.camera.frame(this.corners);
      this.redraw();
    }
    /**
     * Show a moment, at once.
     * @param {Frame} frame
     * @returns {boolean} whether it could be drawn: it is of this sheet, and every number of it finite
     */
    show(frame) {
      if (!this.shown?.take(frame)) return false;
      this.lively = performance.now();
      this.camera.follow(this.shown.surface.centre[0], this.shown.surface.centre[1]);
      this.frame();
      return true;
    }
    /** Draw what there is, at once. */
    frame() {
      cancelAnimationFrame(this.waiting);
      clearTimeout(this.soon);
      this.waiting = this.soon = 0;
      if (!this.shown || this.gone || !this.canvas.clientWidth || !this.canvas.clientHeight) return;
      (this.stand ?? this.picture).draw(this.asked);
      this.drawn = performance.now();
      if (this.picture.finer) this.settling ||= setTimeout(() => this.settle(), STILL2);
    }
    /** Nothing has moved for a while: draw it once more, finer. */
    settle() {
      const left = this.drawn + STILL2 - performance.now();
      this.settling = left > 5 ? setTimeout(() => this.settle(), left) : 0;
      if (!this.settling && !this.stand && !this.gone) this.picture.draw(this.asked, true);
    }
    /** Draw with the screen's next picture, or with the next frame that is shown where they follow each other. */
    redraw() {
      if (this.waiting || this.soon || this.gone) return;
      if (performance.now() - this.lively < LIVELY) this.soon = setTimeout(() => this.frame(), LIVELY);
      else this.waiting = requestAnimationFrame(() => this.frame());
    }
    /**
     * What is drawn besides the sheet.
     * @param {{forces?: boolean, contact?: boolean, legs?: boolean, trail?: boolean,
     *     bending?: boolean | "curvature" | "height"}} layers
     */
    setLayers(layers2) {
      Object.assign(this.asked.layers, layers2);
      const { bending } = this.asked.layers;
      this.asked.layers.bending = this.asked.said.bent = bending === true ? "curvature" : bending || "";
      this.redraw();
    }
    /** @param {number} factor 1 to 10, by which heights are drawn higher than they are; the picture says so */
    setExaggeration(factor) {
      const kept2 = Math.min(MOST_EXAGGERATED, Math.max(1, Number(factor) || 1));
      this.asked.exaggerated = this.asked.said.exaggerated = kept2;
      this.redraw();
    }
    /** @param {{x: number, y: number, angle: number} | null} pose on the plate that the sheet should reach, m and rad */
    setGoal(pose) {
      this.asked.goal = pose;
      this.redraw();
    }
    /** @param {{x: number, y: number, angle: number} | null} pose on the plate at which a film saw the sheet */
    setGhost(pose) {
      this.asked.ghost = pose;
      this.redraw();
    }
    /** @param {Frame[]} frames of other sheets with the same nodes, drawn translucent */
    setCloud(frames) {
      this.asked.cloud = (frames ?? []).filter((frame) => this.shown?.couldTake(frame));
      this.redraw();
    }
    /** Forget where the sheet has been. */
    clearTrail() {
      this.shown?.forget();
      this.redraw();
    }
    /** @param {"default" | "above" | "bar" | "plate"} name @returns {boolean} whether there is such a view */
    look(name) {
      const known = this.camera.look(name);
      this.redraw();
      return known;
    }
    /** @param {(push: {at: number[], velocity: number[]}) => void} tell where the sheet is pushed, m, and how, m/s */
    onPush(tell) {
      this.tellPush = tell;
    }
    /**
     * A push without a pointer, for keys and buttons.
     * @param {{direction?: "left" | "right" | "away" | "towards" | "up", speed?: number, velocity?: number[],
     *     at?: number[]}} push a direction as the picture shows it and a speed, m/s, or a velocity; at the sheet's middle
     *     where no place is given
     * @returns {boolean} whether there was anything to push
     */
    pushWith({ direction, speed = 0.15, velocity: velocity2, at: at2 }) {
      if (!this.shown?.there) return false;
      const way = velocity2 ?? wayOf(direction, this.camera.azimuth)?.map((v) => v * speed);
      const place = at2 ?? this.middle();
      if (!way || ![...way, ...place].every(Number.isFinite)) return false;
      this.tellPush?.({ at: [place[0], place[1]], velocity: way });
      return true;
    }
    middle() {
      const { nodes, nNodes } = this.shown, sum2 = [0, 0];
      for (let k = 0; k < nNodes; k++) for (let d = 0; d < 2; d++) sum2[d] += nodes[3 * k + d] / nNodes;
      return sum2;
    }
    /** The node and the ray at a place of the picture, CSS px, where the sheet is there. */
    sheetAt(x, y) {
      const picture = this.stand ?? this.picture;
      if (!this.shown?.there || !picture.size) return null;
      const ray = picture.rayAt(x, y), { node, off } = nearestNode(ray.from, ray.way, this.shown.nodes);
      return off <= GRASP * this.shown.surface.pitch ? { node, ...ray } : null;
    }
    grasp(x, y) {
      const there = this.tellPush ? this.sheetAt(x, y) : null;
      if (!there) return false;
      const height = Math.max(0, this.shown.onPlate[3 * there.node + 2]);
      const at2 = meetPlane(there.from, there.way, this.shown.frame, height);
      if (!at2) return false;
      this.held = { at: at2, to: at2, height };
      this.canvas.style.cursor = "grabbing";
      return true;
    }
    drag(x, y) {
      if (!this.held) return;
      const { from, way } = (this.stand ?? this.picture).rayAt(x, y);
      const to = meetPlane(from, way, this.shown.frame, this.held.height);
      if (!to) return;
      const { at: at2 } = this.held, far = Math.hypot(to[0] - at2[0], to[1] - at2[1], to[2] - at2[2]);
      const share2 = Math.min(1, FASTEST / PER_DRAG / Math.max(far, 1e-9));
      this.held.to = at2.map((v, d) => v + share2 * (to[d] - v));
      const ends = ontoPlate(this.shown.frame, [...at2, ...this.held.to], new Float64Array(6));
      this.asked.push = { from: [...ends.subarray(0, 3)], to: [...ends.subarray(3)] };
      this.redraw();
    }
    release(letGo) {
      const { held } = this;
      this.held = this.asked.push = null;
      this.canvas.style.cursor = "";
      this.redraw();
      if (!held || !letGo) return;
      const push = pushOf(held.at, held.to);
      if (Math.hypot(...push.velocity) > 1e-3) this.tellPush?.(push);
    }
    /** The canvas may have another size. */
    resize() {
      const { clientWidth: width, clientHeight: height } = this.canvas, pixels = window.devicePixelRatio || 1;
      if (!width || !height) return;
      const key = `${width} ${height} ${pixels}`;
      if (key === this.size) return;
      this.size = key;
      this.picture.resize(width, height, pixels);
      this.stand?.resize(width, height, pixels);
      this.camera.setAspect(width / height);
      this.frame();
    }
    /** The page's colours may be others. */
    recolour() {
      this.colours = coloursAt(this.canvas);
      this.picture.recolour(this.colours);
      this.stand?.recolour(this.colours);
      this.redraw();
    }
    /** The graphics card is gone: until it is back, a plain picture lies over this one. */
    lose(event) {
      event.preventDefault();
      event.stopImmediatePropagation();
      if (this.stand) return;
      const { canvas } = this, over = document.createElement("canvas"), { style } = over;
      style.position = "absolute";
      style.left = `${canvas.offsetLeft}px`;
      style.top = `${canvas.offsetTop}px`;
      style.width = `${canvas.clientWidth}px`;
      style.height = `${canvas.clientHeight}px`;
      style.pointerEvents = "none";
      over.setAttribute("aria-hidden", "true");
      canvas.after(over);
      this.stand = new FlatPicture(over, this.camera);
      this.stand.recolour(this.colours);
      this.stand.resize(canvas.clientWidth, canvas.clientHeight, window.devicePixelRatio || 1);
      if (this.shown) this.stand.build(this.shown);
      this.redraw();
    }
    restore(event) {
      event.stopImmediatePropagation();
      this.picture = new GlPicture(this.canvas, contextOf(this.canvas), this.camera);
      if (this.shown) this.picture.build(this.shown);
      this.picture.recolour(this.colours);
      this.size = "";
      this.stand?.canvas.remove();
      this.stand = null;
      this.resize();
    }
    /** What is seen now as a PNG. @returns {Promise<Blob | null>} */
    snapshot() {
      this.frame();
      if (!this.stand && this.shown) this.picture.draw(this.asked, true);
      const { canvas } = this.stand ?? this;
      return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
    }
    destroy() {
      this.gone = true;
      cancelAnimationFrame(this.waiting);
      clearTimeout(this.settling);
      clearTimeout(this.soon);
      this.gestures.destroy();
      this.sizes.disconnect();
      this.attributes.disconnect();
      this.scheme.removeEventListener("change", this.themed);
      this.canvas.removeEventListener("webglcontextlost", this.lost);
      this.canvas.removeEventListener("webglcontextrestored", this.restored);
      this.stand?.canvas.remove();
      this.picture.dispose();
    }
  };

  // src/app/scene.js
  var READ_EVERY = 100;
  var Scene2 = class {
    constructor(parent, desk, index) {
      this.desk = desk;
      this.index = index;
      this.canvas = make("canvas", { tabIndex: 0, role: "img", "aria-label": "The sheet on its plate, in three dimensions" });
      this.word = make("p", { class: "word" });
      this.of = make("p", { class: "of" });
      this.element = make("div", { class: "scene" }, this.canvas, this.word, this.of);
      this.element.addEventListener("pointerdown", () => desk.select(index), true);
      parent.append(this.element);
      this.view = new View(this.canvas, { facts: desk.facts });
      this.view.onPush((kick) => desk.push(index, kick));
      this.read = null;
      this.readAt = 0;
      this.drawn = null;
      this.sheet = null;
    }
    get seat() {
      return this.desk.seats[this.index];
    }
    /** The scenario may be another. */
    changed() {
      const { scenario } = this.seat;
      const shape = JSON.stringify([scenario.sheet, scenario.plate, scenario.slip_limit, scenario.motion.height]);
      if (shape !== this.sheet) {
        this.sheet = shape;
        this.view.setSheet(scenario, latticeOf(scenario.sheet));
        this.drawn = null;
      }
      this.element.classList.toggle("selected", this.desk.seats.length > 1 && this.desk.selected === this.index);
      this.of.textContent = this.desk.seats.length > 1 ? `${"AB"[this.index]}: ${scenario.name}` : "";
    }
    /** Show where the sheet is after so much wall time, s; whether anything was drawn. */
    tick(wall) {
      const { live } = this.seat;
      const frame = live.tick(wall);
      this.look(live);
      if (!frame || frame === this.drawn) return false;
      if (frame.nodes.length !== 3 * latticeOf(this.seat.scenario.sheet).nNodes) return false;
      this.drawn = frame;
      this.view.show(frame);
      return true;
    }
    /** Draw once more what is shown: a theme, a layer or the viewpoint is another. */
    repaint() {
      this.view.redraw();
    }
    look(live) {
      const now = performance.now();
      if (now - this.readAt < READ_EVERY) return;
      this.readAt = now;
      this.read = reading(live.scenario, live.samples, live.ended === "diverged");
      const text = live.recorded && live.samples.length < 4 ? "as recorded" : inWords(this.read);
      if (this.word.textContent !== text) {
        this.word.textContent = text;
        this.word.classList.toggle("failed", Boolean(this.read.failure));
        this.canvas.setAttribute("aria-label", `The sheet on its plate: ${text}`);
      }
    }
    close() {
      this.view.destroy();
      this.element.remove();
    }
  };

  // src/app/share.js
  var LONGEST = 2e4;
  function fragmentOf(scenario, facts) {
    const name = Object.hasOwn(facts.presets, scenario.name) ? scenario.name : Object.keys(facts.presets)[0];
    const preset = facts.presets[name].scenario;
    const names = differences(preset, scenario).map((field) => field.startsWith("sheet.outline.") ? "sheet.outline" : field);
    const changed2 = Object.fromEntries([...new Set(names)].map((field) => [field, plain2(scenario, field)]));
    return `#${encodeURIComponent(JSON.stringify({ v: 1, of: name, with: changed2 }))}`;
  }
  var plain2 = (scenario, field) => field.split(".").reduce((part, key) => part?.[key], scenario) ?? null;
  function scenarioOf(fragment, facts) {
    const text = fragment.replace(/^#/, "");
    if (!text) return null;
    if (text.length > LONGEST) throw new Error("the link is too long to be one of this page's");
    let held;
    try {
      held = JSON.parse(decodeURIComponent(text));
    } catch {
      throw new Error("the link is spoilt: it was cut off, or changed on its way");
    }
    if (held === null || typeof held !== "object" || !Object.hasOwn(facts.presets, held.of ?? ""))
      throw new Error("the link is of no preset that this page knows");
    const scenario = structuredClone(facts.presets[held.of].scenario);
    for (const [name, value] of Object.entries(held.with ?? {})) {
      if (!/^[a-z_]+(\.[a-z_0-9]+)*$/.test(name) || /__proto__|constructor|prototype/.test(name))
        throw new Error("the link names something that no scenario has");
      const keys2 = name.split(".");
      let part = scenario;
      for (const key of keys2.slice(0, -1)) {
        if (part[key] === null || typeof part[key] !== "object") part[key] = {};
        part = part[key];
      }
      part[keys2.at(-1)] = value;
    }
    return scenario;
  }

  // src/app/tabs.js
  function tabs(list, panels, given2) {
    let current = -1;
    const made = given2.map(({ title, build }, index) => {
      const id = identity("tab");
      const tab = make("button", {
        type: "button",
        role: "tab",
        id,
        "aria-controls": `${id}-panel`,
        "aria-selected": "false",
        tabIndex: -1,
        onclick: () => show(index)
      }, title);
      const panel = make("div", { role: "tabpanel", id: `${id}-panel`, "aria-labelledby": id, tabIndex: 0, hidden: true });
      list.append(tab);
      panels.append(panel);
      return { tab, panel, build, built: null };
    });
    list.addEventListener("keydown", (event) => {
      const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!by) return;
      event.preventDefault();
      show((current + by + made.length) % made.length);
      made[current].tab.focus();
    });
    function show(index) {
      if (index === current) return;
      if (current >= 0) {
        const before = made[current];
        before.tab.setAttribute("aria-selected", "false");
        before.tab.tabIndex = -1;
        before.panel.hidden = true;
        before.built?.hidden?.();
      }
      current = index;
      const now = made[index];
      now.tab.setAttribute("aria-selected", "true");
      now.tab.tabIndex = 0;
      now.panel.hidden = false;
      now.built ??= now.build(now.panel) ?? {};
      now.built.shown?.();
    }
    return { show, current: () => current };
  }

  // src/app/theme.js
  var NEXT = { system: "light", light: "dark", dark: "system" };
  function theme(control, changed2) {
    let now = "system";
    const put2 = () => {
      if (now === "system") delete document.documentElement.dataset.theme;
      else document.documentElement.dataset.theme = now;
      control.textContent = `Theme: ${now}`;
      changed2();
    };
    control.addEventListener("click", () => {
      now = NEXT[now];
      put2();
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed2);
    put2();
  }

  // src/app/transport.js
  var SPEEDS = [1, 1 / 2, 1 / 5, 1 / 10, 1 / 20, 1 / 50, 1 / 100, 1 / 200];
  var said = (speed) => speed === 1 ? "real time" : `1/${Math.round(1 / speed)}`;
  function transport(bar, desk) {
    const play = button("Pause", () => desk.play(!desk.playing), { class: "play" });
    const back = button("◀", () => desk.step(-1), { "aria-label": "One picture back", title: "One picture back (,)" });
    const on = button("▶", () => desk.step(1), { "aria-label": "One picture forward", title: "One picture forward (.)" });
    const anew = button("Lay down anew", () => desk.restart(), { title: "Begin at rest again (r)" });
    const speed = make("input", {
      type: "range",
      min: 0,
      max: SPEEDS.length - 1,
      step: 1,
      value: 0,
      id: "speed",
      oninput: () => desk.setSpeed(SPEEDS[Number(speed.value)])
    });
    const speedText = make("output", { for: "speed" });
    const track = make("input", {
      type: "range",
      min: 0,
      max: 1e3,
      step: 1,
      value: 1e3,
      "aria-label": "Time, to scrub",
      oninput: () => desk.seek(Number(track.value) / 1e3)
    });
    const clock = make("output", { class: "clock", "aria-label": "Time" });
    const pace = make("span", { class: "pace", role: "status" });
    bar.append(play, back, on, track, clock, make("label", { for: "speed" }, "Speed"), speed, speedText, pace, anew);
    return {
      /** @param {{clock: number, first: number, last: number, pace: number, slowed: boolean}} now */
      update(now) {
        const label = desk.playing ? "Pause" : "Play";
        if (play.textContent !== label) play.textContent = label;
        const text = `${now.clock.toFixed(now.clock < 10 ? 3 : 2)} s`;
        if (clock.textContent !== text) clock.textContent = text;
        const index = Math.max(0, SPEEDS.findIndex((each) => Math.abs(each - desk.speed) < 1e-9));
        if (Number(speed.value) !== index) speed.value = String(index);
        speed.setAttribute("aria-valuetext", said(desk.speed));
        if (speedText.textContent !== said(desk.speed)) speedText.textContent = said(desk.speed);
        const slow = now.slowed ? `slowed to ${now.pace >= 0.1 ? now.pace.toFixed(1) : now.pace.toPrecision(1)} × real time: as fast as this computer goes` : "";
        if (pace.textContent !== slow) pace.textContent = slow;
        if (document.activeElement !== track || desk.playing) {
          const share2 = now.last > now.first ? (now.clock - now.first) / (now.last - now.first) : 1;
          track.value = String(Math.round(1e3 * share2));
        }
        track.setAttribute("aria-valuetext", text);
      }
    };
  }

  // src/curve/file.js
  var DEGREE2 = Math.PI / 180;
  var cell = (value) => typeof value === "string" ? value : Number.isFinite(value) ? String(Number(value.toPrecision(10))) : "";
  var observableColumns = () => OBSERVABLES.filter(({ label, name }) => label || name.startsWith("twist_")).map((observable) => {
    const { name, unit, display } = observable;
    const readIn = display ?? unit;
    if (readIn === "%" || readIn === "1") return { name, heading: name, scale: 1 };
    return { name, heading: `${name}_${readIn.replaceAll("/", "_")}`, scale: scaleOf(observable) };
  });
  var curveCsv = (points, protocol) => {
    const observables = observableColumns();
    const heading2 = [
      "frequency_hz",
      "spin_rate_deg_s",
      "spin_rate_sd_deg_s",
      "gait",
      "failure",
      "runs",
      "failed_runs",
      ...observables.map(({ heading: each }) => each),
      "duration_s",
      "slip_limit_mm"
    ];
    const rows = points.map((point) => [
      point.frequency,
      point.rate / DEGREE2,
      point.spread > 0 ? point.spread / DEGREE2 : NaN,
      point.gait,
      point.failure,
      point.runs,
      point.failedRuns,
      ...observables.map(({ name, scale }) => scale * point.values[name]),
      protocol.duration,
      1e3 * protocol.slip_limit
    ]);
    return [heading2, ...rows.map((row2) => row2.map(cell))].map((row2) => `${row2.join(",")}
`).join("");
  };

  // src/simulation/ensemble.js
  var START_TURN = Math.PI / 180;
  var fails = (failedRuns, runs) => failedRuns > 0 && 2 * failedRuns >= runs;
  var together = (observations) => observations.map(pointOf);
  var pointOf = (runs) => {
    const sound = runs.filter(({ failure }) => !failure);
    const counted = sound.filter(({ spin }) => Number.isFinite(spin.rate));
    const failedRuns = runs.length - sound.length;
    const failed2 = fails(failedRuns, runs.length);
    return {
      runs: runs.length,
      failedRuns,
      countedRuns: counted.length,
      failed: failed2,
      partlyFailed: failedRuns > 0 && failedRuns < runs.length,
      ...rateOf(counted.map(({ spin }) => spin)),
      settled: !failed2 && sound.every(({ spin }) => spin.settled),
      gait: gaitOf2(sound),
      ...failureOf(runs),
      values: Object.fromEntries(OBSERVABLES.map((observable) => [observable.name, valueOf2(observable, runs)]))
    };
  };
  var rateOf = (spins) => {
    const n = spins.length;
    if (!n) return { rate: NaN, spread: NaN, low: NaN, high: NaN };
    const rate = mean(spins.map((spin) => spin.rate));
    if (n === 1) return { rate, spread: spins[0].sd, low: spins[0].low, high: spins[0].high };
    const spread2 = Math.sqrt(spins.reduce((sum2, spin) => sum2 + (spin.rate - rate) ** 2, 0) / (n - 1));
    const half = student95(n - 1) * spread2 / Math.sqrt(n);
    return { rate, spread: spread2, low: rate - half, high: rate + half };
  };
  var gaitOf2 = (sound) => {
    const livelierFirst = [...GAITS].reverse();
    const counts = livelierFirst.map((kind) => sound.filter(({ gait: gait2 }) => gait2 === kind).length);
    return counts.some(Boolean) ? livelierFirst[placeOfLargest(counts)] : "";
  };
  var failureOf = (runs) => {
    const failures = runs.map(({ failure }) => failure).filter(Boolean);
    if (!failures.length) return { failure: "", failureTime: NaN };
    const timesOf2 = (kind2) => failures.filter((failure) => failure.kind === kind2).map(({ time }) => time);
    const kind = FAILURES[placeOfLargest(FAILURES.map((each) => timesOf2(each).length))];
    return { failure: kind, failureTime: median(timesOf2(kind)) };
  };
  var valueOf2 = ({ name, overRuns }, runs) => {
    if (overRuns === "worst") {
      return runs.map(({ values }) => values[name]).reduce((worst, value) => furthest(value) > furthest(worst) ? value : worst);
    }
    const finite2 = runs.filter(({ failure }) => !failure).map(({ values }) => values[name]).filter(Number.isFinite);
    return finite2.length ? mean(finite2) : NaN;
  };
  var furthest = (value) => Number.isNaN(value) ? Infinity : Math.abs(value);

  // src/science/form.js
  var FieldError = class extends Error {
    constructor(field, fault2) {
      super(`${field}: ${fault2}`);
      this.field = field;
    }
  };
  var notAllowed = (field, got, allowed) => new FieldError(field, `${got} is not allowed: ${allowed}.`);
  var quantity2 = (name, text, field, units) => {
    const told3 = parsed(text, field, units);
    if (told3.fault) throw new FieldError(name, told3.fault);
    return told3.value;
  };
  var whole = (name, text, least2, most) => {
    const value = Number(text);
    if (text.trim() === "" || !Number.isInteger(value) || value < least2 || value > most) {
      throw notAllowed(name, `“${text.slice(0, 40)}”`, `a whole number from ${least2} to ${most}`);
    }
    return value;
  };
  var textField = (text, value, unit = "") => {
    const input = document.createElement("input");
    Object.assign(input, { type: "text", value, autocomplete: "off", spellcheck: false, inputMode: "decimal" });
    const label = element("label");
    const words = element("span", "", text);
    label.append(words, input);
    const field = {
      name: text,
      input,
      label,
      setUnit: (next) => words.textContent = next ? `${text} (${pretty(next)})` : text
    };
    field.setUnit(unit);
    return field;
  };
  var choiceField = (text, rows, value) => {
    const select = document.createElement("select");
    const label = element("label");
    label.append(element("span", "", text), select);
    const fill = (options, chosen) => {
      const groups = /* @__PURE__ */ new Map([["", select]]);
      select.replaceChildren();
      for (const [key, words, group = ""] of options) {
        if (!groups.has(group)) {
          const made = document.createElement("optgroup");
          made.label = group;
          groups.set(group, select.appendChild(made));
        }
        groups.get(group).append(new Option(words, key, key === chosen, key === chosen));
      }
    };
    fill(rows, value);
    return { name: text, input: select, label, fill };
  };
  var buttonOf = (text, act) => {
    const button2 = element("button", "", text);
    button2.type = "button";
    button2.addEventListener("click", act);
    return button2;
  };
  var faultLine = (fields) => {
    const line = element("p", "study-fault");
    line.setAttribute("role", "alert");
    const clear = () => {
      line.textContent = "";
      for (const { input } of fields()) input.removeAttribute("aria-invalid");
    };
    return {
      line,
      clear,
      tell(error) {
        clear();
        line.textContent = error.message;
        const wrong = fields().find(({ name }) => name === error.field);
        wrong?.input.setAttribute("aria-invalid", "true");
        wrong?.input.focus();
      }
    };
  };

  // src/science/overlays.js
  var DEGREE3 = Math.PI / 180;
  var MOST_CURVES = 60;
  var storedCurves = (payload, units = {}) => {
    if (payload?.kind !== "store" || !Array.isArray(payload.points) || !Array.isArray(payload.parameters)) return [];
    const names = payload.parameters.map(({ name }) => name);
    const which = names.indexOf("motion.frequency");
    if (which < 0) return [];
    const curves = /* @__PURE__ */ new Map();
    for (const { at: at2, spin_rate: rate } of payload.points) {
      if (!Array.isArray(at2) || !Number.isFinite(at2[which])) continue;
      const others = names.map((name2, i) => i === which ? "" : worded(name2, at2[i], payload.parameters[i], units)).filter(Boolean);
      const name = others.join(", ") || String(payload.name ?? "store");
      if (!curves.has(name) && curves.size >= MOST_CURVES) continue;
      if (!curves.has(name)) curves.set(name, []);
      curves.get(name).push({ frequency: at2[which], rate: rate ?? NaN });
    }
    return [...curves].map(([name, points]) => ({ name, points: sorted(points) }));
  };
  var worded = (name, value, { display }, units) => {
    const short = name.split(".").at(-1).replaceAll("_", " ");
    if (typeof value !== "number") return `${short} ${String(value)}`;
    const [factor] = Object.hasOwn(units, display) ? units[display] : [1];
    return `${short} ${read2(value / factor, 4)} ${pretty(display)}`.trim();
  };
  var sorted = (points) => points.sort((a, b) => a.frequency - b.frequency);
  var RATES = { spin_rate_deg_s: DEGREE3, spin_rate_rad_s: 1, spin_rate: DEGREE3 };
  var FREQUENCIES = { frequency_hz: 1, frequency: 1 };
  var readCurve = (name, text) => {
    const lines = text.replace(/^\ufeff/, "").split(/\r?\n/).filter((line) => line.trim() && !line.startsWith("#"));
    const separator = lines[0]?.includes(";") ? ";" : lines[0]?.includes("	") ? "	" : ",";
    const headings = (lines[0] ?? "").split(separator).map((word) => word.trim().toLowerCase().replace(/^"|"$/g, ""));
    const columnOf = (known) => headings.findIndex((heading2) => Object.hasOwn(known, heading2));
    const [f, r] = [columnOf(FREQUENCIES), columnOf(RATES)];
    if (f < 0 || r < 0) {
      throw new Error(`${name}: got the columns ${headings.slice(0, 5).join(", ").slice(0, 80)}, must be frequency_hz and spin_rate_deg_s`);
    }
    const number = (cell3) => cell3?.trim() ? Number(separator === ";" ? cell3.replace(",", ".") : cell3) : NaN;
    const points = lines.slice(1).map((line) => line.split(separator)).map((cells) => ({
      frequency: FREQUENCIES[headings[f]] * number(cells[f]),
      rate: RATES[headings[r]] * number(cells[r])
    })).filter(({ frequency }) => frequency > 0 && frequency < Infinity);
    if (!points.length) throw new Error(`${name}: got no row with a frequency above 0 Hz, must be one row for each point`);
    return { name: name.replace(/\.[^.]*$/, ""), points: sorted(points) };
  };

  // src/science/work.js
  var LANES = 4;
  var greatestCommonDivisor2 = (a, b) => b === 0 ? a : greatestCommonDivisor2(b, a % b);
  var groupsOf = (items, repeats) => {
    const size = LANES / greatestCommonDivisor2(LANES, repeats);
    const groups = [];
    for (let i = 0; i < items.length; i += size) groups.push(items.slice(i, i + size));
    return groups;
  };
  var coarseFirst = (count, coarsest = 8) => {
    const seen = /* @__PURE__ */ new Set();
    for (let step = coarsest; step >= 1; step /= 2) for (let i = 0; i < count; i += step) seen.add(i);
    return [...seen];
  };
  var observeAll = async ({ pool, items, scenarioOf: scenarioOf3, repeats, seed, onObserved, onRefused, signal }) => {
    const groups = groupsOf(items, repeats);
    const ask = async (group) => {
      try {
        const scenarios = group.map(scenarioOf3);
        const { observations } = await pool.ask({ ask: "observe", scenarios, repeats, seed }, { signal });
        if (!signal.aborted) group.forEach((item, i) => onObserved(item, observations[i]));
      } catch (error) {
        if (signal.aborted) return;
        if (group.length > 1) for (const item of group) await ask([item]);
        else onRefused(group[0], error.field ? `${error.field}: ${error.message}` : String(error.message ?? error));
      }
    };
    const next = async () => {
      while (groups.length && !signal.aborted) await ask(groups.shift());
    };
    const ahead = 2 * (pool.size ?? navigator.hardwareConcurrency ?? 2);
    await Promise.all(Array.from({ length: Math.min(ahead, groups.length) }, next));
  };
  var oncePerPicture = (draw) => {
    let waiting = false;
    return () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => {
        waiting = false;
        draw();
      });
    };
  };
  var fileName2 = (text) => text.replace(/[^\p{L}\p{N}_-]+/gu, "-").slice(0, 60) || "lab";

  // src/science/curve.js
  var MOST_POINTS = 200;
  var MOST_REPEATS = 32;
  var MOST_RUNS = 2e3;
  var MOST_SECONDS = 60;
  var SEED = 0;
  var FIT_EVERY = 300;
  var MOST_BYTES2 = 2e6;
  var SECONDS = { unit: "s", display: "s", factor: 1, example: "2 s", above: 0, at_least: null, at_most: MOST_SECONDS };
  var frequenciesOf = (from, to, count) => Array.from({ length: count }, (_, i) => Number((from + i * (to - from) / (count - 1)).toPrecision(12)));
  var scenarioAt = (scenario, frequency, duration) => ({ ...scenario, duration, transient: null, motion: { ...scenario.motion, frequency } });
  var curveTab = (el, desk) => {
    const units = desk.facts.units;
    const hertz = desk.facts.fields.find(({ name }) => name === "motion.frequency");
    const fields = {
      from: textField("from", "12", "Hz"),
      to: textField("to", "30", "Hz"),
      points: textField("points", "30"),
      seconds: textField("time of a point", "2", "s"),
      repeats: textField("starts of a point", "1")
    };
    const fault2 = faultLine(() => Object.values(fields));
    const state = { points: [], scenario: null, told: null, stop: null, refused: "", own: [] };
    const asked = () => {
      const told3 = {
        from: quantity2("from", fields.from.input.value, hertz, units),
        to: quantity2("to", fields.to.input.value, hertz, units),
        count: whole("points", fields.points.input.value, 2, MOST_POINTS),
        duration: quantity2("time of a point", fields.seconds.input.value, SECONDS, units),
        repeats: whole("starts of a point", fields.repeats.input.value, 1, MOST_REPEATS)
      };
      if (!(told3.to > told3.from)) throw notAllowed("to", fields.to.input.value, `above ${told3.from} Hz, where the curve begins`);
      if (told3.count * told3.repeats > MOST_RUNS) {
        throw notAllowed("starts of a point", `${told3.count * told3.repeats} runs in all`, `at most ${MOST_RUNS} runs`);
      }
      return told3;
    };
    const page2 = layout(el, fields, fault2.line, {
      run: () => {
        if (state.stop) return state.stop.abort();
        fault2.clear();
        try {
          return void compute(desk, state, asked(), page2, draw);
        } catch (error) {
          return fault2.tell(error);
        }
      },
      save: () => saveText(
        `${fileName2(state.scenario.name)}-curve.csv`,
        curveCsv(state.points, { duration: state.told.duration, slip_limit: state.scenario.slip_limit }),
        "text/csv"
      ),
      open: async (file) => {
        fault2.clear();
        try {
          if (file.size > MOST_BYTES2) throw notAllowed(file.name, `${Math.round(file.size / 1e6)} MB`, "a curve of 2 MB at most");
          state.own.push(readCurve(file.name, await file.text()));
          page2.fillOverlays(stored2, state.own, `own ${state.own.length - 1}`);
          draw();
        } catch (error) {
          fault2.tell(error);
        }
      },
      overlay: () => draw()
    });
    const stored2 = storedCurves(desk.payload, units);
    page2.fillOverlays(stored2, state.own, stored2.length ? "stored 0" : "");
    const watch = (point) => desk.watch({ ...state.scenario, motion: { ...state.scenario.motion, frequency: point.frequency } });
    const chart = spinCurve(page2.chart, { onPick: watch });
    const draw = oncePerPicture(() => {
      const fit = fitOf(state);
      const used = fittedPoints(state.points);
      const points = state.points.map((point, i) => ({ ...point, fitted: used[i] }));
      chart.update({ points, fit, from: state.told?.from, to: state.told?.to, overlays: page2.overlays(stored2, state.own) });
      page2.tell(state, fit, watch);
    });
    draw();
    return { shown: () => chart.resize(), hidden() {
    }, destroy: () => (state.stop?.abort(), chart.destroy()) };
  };
  var fitOf = (state) => {
    const now = performance.now();
    if (!state.stop || now - (state.fittedAt ?? 0) > FIT_EVERY) {
      state.fit = state.points.length ? fitPoints(state.points) : null;
      state.fittedAt = now;
    }
    return state.fit;
  };
  var compute = async (desk, state, told3, page2, draw) => {
    const scenario = structuredClone(desk.scenario());
    Object.assign(state, { points: [], fit: null, scenario, told: told3, stop: new AbortController(), refused: "", began: performance.now() });
    const frequencies = frequenciesOf(told3.from, told3.to, told3.count);
    page2.running(true);
    draw();
    const { signal } = state.stop;
    await observeAll({
      pool: desk.pool,
      items: coarseFirst(told3.count).map((i) => frequencies[i]),
      repeats: told3.repeats,
      seed: SEED,
      signal,
      scenarioOf: (frequency) => scenarioAt(scenario, frequency, told3.duration),
      onObserved: (frequency, runs) => {
        state.points.push({ frequency, ...together([runs])[0] });
        state.points.sort((a, b) => a.frequency - b.frequency);
        draw();
      },
      onRefused: (frequency, message) => {
        state.refused = `${frequency} Hz cannot be run: ${message}`;
        draw();
      }
    });
    state.took = (performance.now() - state.began) / 1e3;
    state.stop = null;
    page2.running(false);
    draw();
  };
  var layout = (el, fields, faultElement, act) => {
    const form = element("form", "study-fields");
    form.append(...Object.values(fields).map(({ label }) => label));
    const run = element("button", "play", "Run");
    run.type = "submit";
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      act.run();
    });
    form.append(run);
    const progress = document.createElement("progress");
    progress.setAttribute("aria-label", "Points of the curve that are done");
    progress.max = 1;
    progress.value = 0;
    const save = buttonOf("Save CSV", act.save);
    save.disabled = true;
    const file = document.createElement("input");
    Object.assign(file, { type: "file", accept: ".csv,text/csv", hidden: true });
    file.addEventListener("change", () => {
      if (file.files[0]) act.open(file.files[0]);
      file.value = "";
    });
    const overlay = choiceField("beside it", [["", "no other curve"]], "");
    overlay.input.addEventListener("change", act.overlay);
    const actions2 = element("div", "study-actions");
    const count = element("span", "study-count");
    actions2.append(progress, count, save, buttonOf("Open a measured curve…", () => file.click()), file, overlay.label);
    const status = element("p", "study-status");
    status.setAttribute("role", "status");
    const words = element("p", "study-words");
    const chart = element("div");
    const table2 = tableOf();
    el.append(form, faultElement, actions2, status, chart, words, table2.details);
    return {
      chart,
      running(on) {
        run.textContent = on ? "Stop" : "Run";
      },
      fillOverlays(stored2, own, chosen) {
        overlay.fill([
          ["", "no other curve"],
          ...stored2.map(({ name }, i) => [`stored ${i}`, name, "of the store"]),
          ...stored2.length > 1 ? [["stored", "all of the store's", "of the store"]] : [],
          ...own.map(({ name }, i) => [`own ${i}`, name, "measured"])
        ], chosen);
      },
      overlays(stored2, own) {
        const [kind, number] = overlay.input.value.split(" ");
        const list = { stored: stored2, own }[kind] ?? [];
        return number === void 0 ? list : [list[Number(number)]].filter(Boolean);
      },
      tell(state, fit, watch) {
        save.disabled = !state.points.length;
        progress.value = state.told ? state.points.length / state.told.count : 0;
        count.textContent = state.told ? `${state.points.length} of ${state.told.count}` : "";
        const now = statusOf(state);
        if (status.textContent !== now) status.textContent = now;
        words.replaceChildren(...fitInParts(fit).flatMap((part) => [element("span", "", part), " "]));
        if (!state.stop) table2.update(state.points, watch);
      }
    };
  };
  var statusOf = ({ points, told: told3, scenario, stop, took, refused }) => {
    if (!told3) return "Computes the spin rate of the sheet on the plate at each frequency, on all of the computer's cores.";
    const count = stop ? `computing ${told3.count} points of ${scenario.name}` : `${points.length} points of ${scenario.name}`;
    const how = `fails at a slip of ${Number((1e3 * scenario.slip_limit).toPrecision(3))} mm`;
    const end = stop ? "" : `${points.length < told3.count && !refused ? "stopped after" : "in"} ${took.toFixed(1)} s`;
    return [count, how, end, refused].filter(Boolean).join(" · ");
  };
  var tableOf = () => {
    const details = document.createElement("details");
    const body = element("div", "study-table");
    body.tabIndex = 0;
    body.setAttribute("role", "region");
    body.setAttribute("aria-label", "Points of the curve");
    details.append(element("summary", "", "Points as a list"), body);
    let last2 = null;
    let shown4 = [];
    const fill = () => {
      if (!details.open) return;
      const list = element("ul");
      for (const point of shown4) {
        const item = element("li", "", `${pointInWords(point)} `);
        item.append(buttonOf(`Watch ${Number(point.frequency.toPrecision(4))} Hz`, () => last2(point)));
        list.append(item);
      }
      body.replaceChildren(list);
    };
    details.addEventListener("toggle", fill);
    return {
      details,
      update(points, watch) {
        [shown4, last2] = [points, watch];
        fill();
      }
    };
  };

  // src/science/grid.js
  var DEGREE4 = Math.PI / 180;
  var COARSEST = 8;
  var OF_THE_RUN = /* @__PURE__ */ new Set(["duration", "transient", "time_step", "motion.ramp"]);
  var SHORTHANDS2 = /* @__PURE__ */ new Set(["natural_frequency", "friction_angle"]);
  var OF_THE_LATTICE = /^sheet\.(outline|pitch)/;
  var parametersOf = (facts, scenario) => {
    const seen = /* @__PURE__ */ new Set();
    const shorthands = (facts.shorthands ?? []).filter(({ name }) => SHORTHANDS2.has(name));
    return [...facts.fields, ...shorthands].filter((field) => {
      const { name, kind, choices, on } = field;
      if (seen.has(name) || name.includes("*") || OF_THE_RUN.has(name) || choices || (kind ?? "number") !== "number") return false;
      if (!Number.isFinite(numberOf(scenario, name)) || on && !on.includes(valueOf(scenario, `${name.replace(/\.[^.]*$/, "")}.shape`))) {
        return false;
      }
      seen.add(name);
      return true;
    });
  };
  var numberOf = (scenario, name) => {
    try {
      return valueOf(scenario, name);
    } catch {
      return NaN;
    }
  };
  var wordsOf2 = ({ name }) => name.replaceAll(/[._]/g, " ");
  var valuesOf = (from, to, count, even) => Array.from({ length: count }, (_, i) => {
    const share2 = i / (count - 1);
    return Number((even ? from + share2 * (to - from) : from * (to / from) ** share2).toPrecision(12));
  });
  var cellsOf = (x, y) => {
    const [nx, ny] = [x.values.length, y.values.length];
    const byRow = OF_THE_LATTICE.test(y.field.name);
    const seen = /* @__PURE__ */ new Set();
    const cells = [];
    for (let step = COARSEST; step >= 1; step /= 2) {
      const own = [];
      for (let i = 0; i < nx; i += step) for (let j = 0; j < ny; j += step) if (!seen.has(`${i},${j}`)) own.push({ i, j });
      if (byRow) own.sort((a, b) => a.j - b.j || a.i - b.i);
      for (const cell3 of own) seen.add(`${cell3.i},${cell3.j}`);
      cells.push(...own);
    }
    return cells;
  };
  var standIn = (cells, i, j) => {
    for (let step = 2; step <= COARSEST; step *= 2) {
      const coarse = cells.get(`${i - i % step},${j - j % step}`);
      if (coarse) return coarse;
    }
    return void 0;
  };
  var heading = ({ name, display }) => display ? `${name}_${display.replaceAll("/", "_")}` : name;
  var cell2 = (value) => {
    if (typeof value === "number") return Number.isFinite(value) ? String(Number(value.toPrecision(10))) : "";
    const text = String(value ?? "").replace(/^[=+\-@]/, "'$&");
    return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  var mapCsv = (x, y, points) => {
    const observables = observableColumns();
    const rows = [[
      heading(x.field),
      heading(y.field),
      "spin_rate_deg_s",
      "spin_rate_sd_deg_s",
      "gait",
      "failure",
      "runs",
      "failed_runs",
      ...observables.map(({ heading: each }) => each),
      "note"
    ]];
    for (const [key, point] of points) {
      const [i, j] = key.split(",").map(Number);
      const place = [x.values[i] / x.field.factor, y.values[j] / y.field.factor];
      if (point.refused) rows.push([...place, ...Array.from({ length: 6 + observables.length }, () => ""), point.refused]);
      else {
        rows.push([
          ...place,
          point.rate / DEGREE4,
          point.spread / DEGREE4,
          point.gait,
          point.failure,
          point.runs,
          point.failedRuns,
          ...observables.map(({ name, scale }) => scale * point.values[name]),
          ""
        ]);
      }
    }
    return rows.map((row2) => `${row2.map(cell2).join(",")}
`).join("");
  };

  // src/science/map.js
  var MOST_CELLS = 2e3;
  var MOST_ON_AN_AXIS = 100;
  var MOST_REPEATS2 = 16;
  var MOST_SECONDS2 = 20;
  var SEED2 = 0;
  var SECONDS2 = { unit: "s", display: "s", factor: 1, example: "1 s", above: 0, at_least: null, at_most: MOST_SECONDS2 };
  var DEGREE5 = Math.PI / 180;
  var FIRST = ["motion.frequency", "motion.angle"];
  var SHOWN2 = [
    { name: "spin_rate", label: "spin rate", unit: "°/s", of: (point) => point.rate / DEGREE5 },
    { name: "gait", label: "gait", unit: "", categories: GAITS, of: ({ gait: gait2 }) => gait2 ? GAITS.indexOf(gait2) : NaN },
    {
      name: "failure",
      label: "failure",
      unit: "",
      categories: ["none", ...FAILURES],
      of: ({ failure, failed: failed2 }) => failed2 ? 1 + FAILURES.indexOf(failure) : 0
    },
    { name: "spread", label: "spread of the spin rate", unit: "°/s", of: (point) => point.spread / DEGREE5 },
    ...OBSERVABLES.filter(({ label }) => label).map((observable) => ({
      name: observable.name,
      label: observable.label,
      unit: pretty(observable.display ?? observable.unit),
      of: ({ values }) => scaleOf(observable) * values[observable.name]
    })),
    { name: "energy_imbalance", label: "energy out of balance", unit: "%", of: ({ values }) => 100 * values.energy_imbalance }
  ];
  var mapTab = (el, desk) => {
    const axes = [axisOf("across", 0, desk), axisOf("up", 1, desk)];
    const general = { seconds: textField("time of a point", "1", "s"), repeats: textField("starts of a point", "1") };
    const fields = [...axes.flatMap((axis2) => axis2.fields), ...Object.values(general)];
    const shown4 = choiceField("show", SHOWN2.map(({ name, label }) => [name, label]), "spin_rate");
    const fault2 = faultLine(() => fields);
    const state = { points: /* @__PURE__ */ new Map(), told: null, scenario: null, stop: null, took: 0 };
    const asked = () => {
      const [x, y] = axes.map((axis2) => axis2.asked());
      if (x.field.name === y.field.name) throw notAllowed("parameter up", wordsOf2(y.field), "another than the one across");
      const told3 = {
        x,
        y,
        duration: quantity2("time of a point", general.seconds.input.value, SECONDS2, desk.facts.units),
        repeats: whole("starts of a point", general.repeats.input.value, 1, MOST_REPEATS2)
      };
      const runs = x.values.length * y.values.length * told3.repeats;
      if (runs > MOST_CELLS) throw notAllowed("points up", `${runs} runs in all`, `such that there are ${MOST_CELLS} runs at most`);
      return told3;
    };
    const page2 = layout2(el, axes, Object.values(general), shown4, fault2.line, {
      run: () => {
        fault2.clear();
        try {
          const told3 = asked();
          state.stop?.abort();
          Object.assign(state, { points: /* @__PURE__ */ new Map(), told: told3, scenario: structuredClone(desk.scenario()), took: 0 });
          compute2(desk, state, draw);
        } catch (error) {
          fault2.tell(error);
        }
      },
      stop: () => state.stop ? state.stop.abort() : compute2(desk, state, draw),
      save: () => saveText(`${fileName2(state.scenario.name)}-map.csv`, mapCsv(state.told.x, state.told.y, state.points), "text/csv")
    });
    const watch = (cell3) => {
      if (state.told) desk.watch(scenarioOf2(state, cell3));
    };
    const chart = heatMap(page2.chart, { onPick: watch });
    const draw = oncePerPicture(() => {
      if (state.told) chart.update(pictureOf(state, SHOWN2.find(({ name }) => name === shown4.input.value)));
      page2.tell(state);
    });
    shown4.input.addEventListener("change", draw);
    desk.on("change", () => axes.forEach((axis2) => axis2.refresh()));
    page2.tell(state);
    return { shown: () => chart.resize(), hidden() {
    }, destroy: () => (state.stop?.abort(), chart.destroy()) };
  };
  var scenarioOf2 = ({ scenario, told: { x, y } }, { i, j }) => withValue(withValue(scenario, x.field.name, x.values[i]), y.field.name, y.values[j]);
  var compute2 = async (desk, state, draw) => {
    const { told: told3, points } = state;
    const stop = new AbortController();
    state.stop = stop;
    const began = performance.now() - 1e3 * state.took;
    draw();
    await observeAll({
      pool: desk.pool,
      items: cellsOf(told3.x, told3.y).filter(({ i, j }) => !points.has(`${i},${j}`)),
      repeats: told3.repeats,
      seed: SEED2,
      signal: stop.signal,
      scenarioOf: (cell3) => ({ ...scenarioOf2(state, cell3), duration: told3.duration, transient: null }),
      onObserved: ({ i, j }, runs) => {
        points.set(`${i},${j}`, together([runs])[0]);
        draw();
      },
      onRefused: ({ i, j }, message) => {
        points.set(`${i},${j}`, { refused: message });
        draw();
      }
    });
    if (state.stop !== stop) return;
    state.took = (performance.now() - began) / 1e3;
    state.stop = null;
    draw();
  };
  var pictureOf = ({ points, told: { x, y } }, shown4) => {
    const cells = new Map([...points].map(([key, point]) => [key, point.refused ? point : {
      value: shown4.of(point),
      gait: point.gait,
      failure: point.failure,
      failed: point.failed && shown4.name !== "failure"
    }]));
    const axis2 = ({ field, values }) => ({
      label: field.display ? `${wordsOf2(field)} (${pretty(field.display)})` : wordsOf2(field),
      values: values.map((value) => value / field.factor)
    });
    return {
      x: axis2(x),
      y: axis2(y),
      cells,
      label: shown4.label,
      unit: shown4.unit,
      categories: shown4.categories ?? null,
      step: (i, j) => standIn(cells, i, j)
    };
  };
  var axisOf = (way, which, desk) => {
    const offered = () => parametersOf(desk.facts, desk.scenario());
    const fieldOf = (name) => offered().find((field) => field.name === name) ?? offered()[which];
    const rows = () => offered().map((field) => [field.name, wordsOf2(field), field.name.includes(".") ? field.name.split(".")[0] : "whole"]);
    const parameter = choiceField(`parameter ${way}`, rows(), FIRST[which]);
    const from = textField(`from, ${way}`, "");
    const to = textField(`to, ${way}`, "");
    const points = textField(`points ${way}`, ["12", "10"][which]);
    const spacing = choiceField(`spacing ${way}`, [["even", "even"], ["log", "by factors"]], "even");
    const suggest = () => {
      const field = fieldOf(parameter.input.value);
      const [low, high] = around(field, valueOf(desk.scenario(), field.name));
      [from.input.value, to.input.value] = [low, high].map((value) => read2(value / field.factor, 3));
      from.setUnit(field.display);
      to.setUnit(field.display);
    };
    parameter.input.addEventListener("change", suggest);
    suggest();
    return {
      fields: [parameter, from, to, points, spacing],
      refresh() {
        const names = rows().map(([name]) => name);
        if (JSON.stringify(names) === JSON.stringify([...parameter.input.options].map(({ value }) => value))) return;
        const kept2 = names.includes(parameter.input.value) ? parameter.input.value : FIRST[which];
        const changed2 = kept2 !== parameter.input.value;
        parameter.fill(rows(), kept2);
        if (changed2) suggest();
      },
      asked() {
        const field = fieldOf(parameter.input.value);
        const [low, high] = [from, to].map((each) => quantity2(each.name, each.input.value, field, desk.facts.units));
        if (!(high > low)) throw notAllowed(to.name, to.input.value, `above ${from.input.value}, where the map begins`);
        const even = spacing.input.value === "even";
        if (!even && !(low > 0)) throw notAllowed(from.name, from.input.value, "above 0 where points are spaced by factors");
        return { field, values: valuesOf(low, high, whole(points.name, points.input.value, 2, MOST_ON_AN_AXIS), even) };
      }
    };
  };
  var around = (field, value) => {
    if (field.name === "motion.frequency") return [12, 30];
    const reach = value !== 0 ? 0.4 * Math.abs(value) : field.factor * (Math.abs(Number.parseFloat(field.example)) || 1);
    const low = field.at_least ?? field.above ?? -Infinity;
    return [Math.max(value - reach, low), Math.min(value + reach, field.at_most ?? Infinity)];
  };
  var layout2 = (el, axes, general, shown4, faultElement, act) => {
    const form = element("form", "study-fields");
    for (const axis2 of axes) {
      const group = element("div", "study-axis");
      group.append(...axis2.fields.map(({ label }) => label));
      form.append(group);
    }
    const run = element("button", "play", "Run");
    run.type = "submit";
    const stop = buttonOf("Stop", act.stop);
    stop.disabled = true;
    form.append(...general.map(({ label }) => label), run, stop);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      act.run();
    });
    const progress = document.createElement("progress");
    progress.setAttribute("aria-label", "Cells of the map that are done");
    progress.max = 1;
    progress.value = 0;
    const count = element("span", "study-count");
    const save = buttonOf("Save CSV", act.save);
    save.disabled = true;
    const actions2 = element("div", "study-actions");
    actions2.append(progress, count, save, shown4.label);
    const status = element("p", "study-status");
    status.setAttribute("role", "status");
    const chart = element("div");
    el.append(form, faultElement, actions2, status, chart);
    return {
      chart,
      tell(state) {
        const total = state.told ? state.told.x.values.length * state.told.y.values.length : 0;
        const done = state.points.size;
        progress.value = total ? done / total : 0;
        count.textContent = total ? `${done} of ${total}` : "";
        save.disabled = done === 0;
        stop.disabled = !state.told || !state.stop && done === total;
        stop.textContent = state.stop || stop.disabled ? "Stop" : "Go on";
        const now = statusOf2(state, done, total);
        if (status.textContent !== now) status.textContent = now;
      }
    };
  };
  var statusOf2 = ({ told: told3, scenario, stop, took, points }, done, total) => {
    if (!told3) return "Computes every point of a grid over two parameters, coarse first; a click on a cell shows its motion.";
    if (stop) return `computing ${total} points of ${scenario.name}`;
    const refused = [...points.values()].filter((point) => point.refused);
    const why = refused.length ? ` · ${refused.length} cannot be run: ${refused[0].refused}` : "";
    return `${done} points of ${scenario.name} ${done < total ? "so far," : ""} in ${took.toFixed(1)} s${why}`;
  };

  // src/main.js
  var at = (id) => document.getElementById(id);
  var SLOW_PICTURE = 14;
  function begin() {
    const facts = readFacts();
    if (!facts) {
      at("notice").textContent = "This file is spoilt: the model's facts are missing. Write it anew: plategait lab";
      return;
    }
    const payload = readPayload();
    const makeWorker = workerMaker();
    const workers = Math.max(1, Math.min(8, navigator.hardwareConcurrency || 2));
    const desk = new Desk({ facts, payload, pool: new Pool(makeWorker, workers), makeWorker });
    desk.on("notice", notice);
    page(desk, firstScenario(facts, payload));
  }
  function firstScenario(facts, payload) {
    const usual = structuredClone(facts.presets[Object.keys(facts.presets)[0]].scenario);
    for (const find of [() => scenarioOf(location.hash, facts), () => payload.scenario]) {
      try {
        const scenario = find();
        if (!scenario) continue;
        checkScenario(scenario);
        return scenario;
      } catch (error) {
        notice(`${error.field ? `${error.field}: ` : ""}${error.message}. The ${usual.name} lies there instead.`);
      }
    }
    if (payload.kind === "spoilt") notice(`The data in this file are spoilt. The ${usual.name} lies there instead.`);
    return usual;
  }
  function page(desk, scenario) {
    const scenes = [];
    const stage = at("scenes");
    desk.on("seats", () => {
      while (scenes.length > desk.seats.length) scenes.pop().close();
      while (scenes.length < desk.seats.length) scenes.push(new Scene2(stage, desk, scenes.length));
      for (const scene of scenes) scene.view.resize();
    });
    const bar = transport(at("transport"), desk);
    desk.add(scenario);
    const shown4 = layers(at("stage"), scenes, desk);
    desk.on("seats", shown4.apply);
    const panel = controls(at("controls"), desk);
    const subject = actions(desk, scenes);
    const findings = tabs(at("tabs"), at("panels"), [
      { title: "Now", build: (element2) => nowTab(element2, desk, scenes) },
      ...desk.payload.kind !== "none" && desk.payload.kind !== "scenario" && desk.payload.kind !== "spoilt" ? [{ title: "From the file", build: (element2) => exhibit(element2, desk, scenes) }] : [],
      { title: "Spin curve", build: (element2) => curveTab(element2, desk) },
      { title: "Map", build: (element2) => mapTab(element2, desk) }
    ]);
    findings.show(0);
    const changed2 = () => {
      for (const scene of scenes) scene.changed();
      panel.update();
      subject();
    };
    desk.on("change", changed2);
    desk.on("watch", () => at("stage").scrollIntoView({ block: "nearest" }));
    changed2();
    keys(desk, scenes);
    about(at("about"), desk.facts);
    new ResizeObserver(() => {
      for (const scene of scenes) scene.view.resize();
    }).observe(stage);
    window.addEventListener("hashchange", () => {
      try {
        const linked = scenarioOf(location.hash, desk.facts);
        if (linked) desk.set(linked);
      } catch (error) {
        notice(error.message);
      }
    });
    loop(desk, scenes, bar);
  }
  function actions(desk, scenes) {
    const bar = at("actions");
    const open = files(desk, (poses) => {
      desk.payload = { ...desk.payload, kind: "poses", ...poses };
      desk.tell("poses", poses);
      notice(`${poses.time.length} poses: shown beside the sheet`);
    });
    const compare = button("Compare", () => {
      if (desk.seats.length > 1) desk.drop();
      else desk.add(structuredClone(desk.scenario()));
      compare.textContent = desk.seats.length > 1 ? "Only one" : "Compare";
      desk.select(desk.seats.length - 1);
    }, { title: "Two objects or motions side by side" });
    const appearance = button("Theme", () => {
    });
    bar.append(
      button("Open…", open, { title: "A scenario's TOML, or poses in CSV" }),
      button(
        "Save TOML",
        () => saveText(fileName(desk.scenario()), tomlOf(desk.scenario(), desk.facts.version)),
        { title: "A file that plategait simulate takes" }
      ),
      button("Copy link", async () => {
        const link = location.href.replace(/#.*$/, "") + fragmentOf(desk.scenario(), desk.facts);
        history.replaceState(null, "", link);
        notice(await copyText(link) ? "The link is copied: it holds this scenario" : "The address above is the link: copy it from there");
      }),
      compare,
      button("Undo", () => desk.undo(), { title: "The change before (Ctrl+Z)" }),
      appearance
    );
    theme(appearance, () => {
      desk.tell("theme");
      for (const scene of scenes) scene.repaint();
    });
    return () => {
      const { name, sheet, motion } = desk.scenario();
      at("subject").textContent = `${name}: ${(sheet.mass * 1e3).toPrecision(3)} g on a plate at ${motion.frequency.toPrecision(3)} Hz`;
      document.title = `${name} – plategait lab`;
    };
  }
  var quiet = 0;
  function notice(text) {
    at("notice").textContent = String(text).slice(0, 300);
    clearTimeout(quiet);
    quiet = setTimeout(() => at("notice").textContent = "", 9e3);
  }
  function loop(desk, scenes, bar) {
    let before = performance.now();
    let cost = 0;
    let odd = false;
    const turn = (now) => {
      requestAnimationFrame(turn);
      odd = !odd;
      if (cost > SLOW_PICTURE && odd) return;
      const wall = Math.max(0, (now - before) / 1e3);
      before = now;
      const began = performance.now();
      let drawn = false;
      for (const scene of scenes) drawn = scene.tick(wall) || drawn;
      if (drawn) cost = 0.8 * cost + 0.2 * (performance.now() - began);
      const { live } = desk.seats[desk.selected];
      const { first, last: last2 } = live.frames;
      const slowed = live.capacity < Infinity && 0.85 * live.capacity < live.speed;
      bar.update({
        clock: live.clock,
        first: first?.time ?? 0,
        last: last2?.time ?? 0,
        pace: live.pace.speed || live.possible,
        slowed: slowed && desk.playing
      });
      if (drawn) desk.tell("drawn");
    };
    requestAnimationFrame(turn);
  }
  begin();
})();
