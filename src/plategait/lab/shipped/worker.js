(() => {
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

  // src/model/motion.js
  var AXES = ["x", "y", "z", "rx", "ry", "rz"];
  var SHORTEST_RAMP = 1e-12;
  var SHORTEST_SAMPLE = 1e-9;
  var LARGEST_SAMPLE = 1e9;
  var MOST_SAMPLES = 2e5;
  var MOST_WAVES = 100;
  var TIMES = "[0, 0.01, 0.02]";
  var turns = (axis) => axis.startsWith("r");
  var termsOf = ({ stroke, angle, frequency, waves }) => [
    [0, stroke, frequency, 0],
    [3, -angle, frequency, 0],
    ...waves.map((wave) => [
      AXES.indexOf(wave.axis),
      wave.amplitude,
      wave.ratio * frequency,
      wave.phase / (2 * Math.PI)
    ])
  ].filter(([, amplitude]) => amplitude !== 0);
  var offsetOf = (motion) => AXES.map((axis) => motion.offset?.[axis] ?? 0);
  var poseAtStart = (motion) => {
    const pose = offsetOf(motion);
    if (motion.ramp > SHORTEST_RAMP) return pose;
    for (const [d, amplitude, , phase] of termsOf(motion)) pose[d] += amplitude * Math.sin(2 * Math.PI * phase);
    AXES.forEach((axis, d) => {
      if (motion.samples?.[axis]?.length) pose[d] += motion.samples[axis][0];
    });
    return pose;
  };
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
  var rotationOf = (pose) => {
    const [cx, cy, cz] = [Math.cos(pose[3]), Math.cos(pose[4]), Math.cos(pose[5])];
    const [sx, sy, sz] = [Math.sin(pose[3]), Math.sin(pose[4]), Math.sin(pose[5])];
    return [
      cy * cz,
      -cy * sz,
      sy,
      cx * sz + sx * sy * cz,
      cx * cz - sx * sy * sz,
      -sx * cy,
      sx * sz - cx * sy * cz,
      sx * cz + cx * sy * sz,
      cx * cy
    ];
  };
  var finestStep = ({ time }) => {
    let finest = Infinity;
    for (let k = 1; k < time.length; k++) finest = Math.min(finest, time[k] - time[k - 1]);
    return finest;
  };
  var NUMBERS = { frequency: FREQUENCY, angle: PLATE_ANGLE, stroke: PLATE_STROKE, height: OFFSET, ramp: DELAY };
  var checkMotion = (motion) => {
    checkTable(motion, "motion");
    checkNumbers(motion, "motion", NUMBERS);
    if (motion.offset !== void 0) checkTable(motion.offset, "motion.offset");
    for (const [axis, value] of Object.entries(motion.offset ?? {}))
      if (AXES.includes(axis)) checkNumber(value, `motion.offset.${axis}`, turns(axis) ? PLATE_ANGLE : OFFSET);
    checkWaves(motion.waves);
    if (motion.samples !== null && motion.samples !== void 0)
      checkSamples(checkTable(motion.samples, "motion.samples"));
  };
  var checkWaves = (waves) => {
    const example = '[{ axis = "z", amplitude = "1 mm" }]';
    if (!Array.isArray(waves) || waves.length > MOST_WAVES)
      throw new Refusal("motion.waves", told(waves), `a list of at most ${MOST_WAVES} sines`, example);
    waves.forEach((wave, i) => {
      const field = `motion.waves.${i}`;
      checkTable(wave, field);
      if (!AXES.includes(wave.axis))
        throw new Refusal(`${field}.axis`, told(wave.axis), `one of ${AXES.join(", ")}`, '"z"');
      checkNumbers(wave, field, { amplitude: turns(wave.axis) ? ANGLE : STROKE, ratio: RATIO, phase: ANGLE });
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
    for (const axis of AXES) {
      const values = samples[axis];
      if (values === void 0 || values === null || values.length === 0) continue;
      const fits = Array.isArray(values) && values.length === time.length && values.every((value) => typeof value === "number" && Math.abs(value) <= LARGEST_SAMPLE);
      if (!fits)
        throw new Refusal(
          `motion.samples.${axis}`,
          told(values),
          `${time.length} values, one for each time, of at most ${LARGEST_SAMPLE} in size`,
          TIMES
        );
    }
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
    const squares = [];
    for (let j = 0; j < rows; j++)
      for (let i = 0; i < columns; i++)
        if (inside[i * rows + j]) {
          number[i * rows + j] = squares.length;
          squares.push([i, j]);
        }
    const at = (i, j) => i >= 0 && i < columns && j >= 0 && j < rows ? number[i * rows + j] : -1;
    const chains = ([di, dj]) => {
      const found = [];
      for (let [i, j] of squares) {
        if (at(i - di, j - dj) >= 0) continue;
        const chain = [];
        for (let node = at(i, j); node >= 0; node = at(i, j)) {
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
        const corners = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        if (corners.every((node) => node >= 0)) cells.push(...corners);
      }
    return {
      nNodes: squares.length,
      rest: restOf(squares),
      axial: axial.length,
      lineStart,
      lineNodes: Int32Array.from(lines.flat()),
      cells: Int32Array.from(cells),
      nCells: cells.length / 4,
      columns,
      rows,
      squares: Int32Array.from(squares.flat())
    };
  }
  function restOf(squares) {
    const n = squares.length;
    const mean2 = [0, 1].map((k) => squares.reduce((sum, square) => sum + square[k], 0) / n);
    const rest = new Float64Array(2 * n);
    squares.forEach(([i, j], node) => {
      rest[2 * node] = i - mean2[0];
      rest[2 * node + 1] = j - mean2[1];
    });
    return rest;
  }

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
  function checkCorners({ corners }) {
    const field = `${FIELD}.corners`;
    if (!Array.isArray(corners)) throw new Refusal(field, told(corners), "a list", TRIANGLE);
    if (corners.length > MOST_CORNERS)
      throw new Refusal(
        field,
        `${corners.length} corners`,
        `at most ${MOST_CORNERS}`,
        "leaving out some that are near to others"
      );
    corners.forEach((corner, i) => {
      if (!Array.isArray(corner) || corner.length !== 2)
        throw new Refusal(`${field}.${i}`, told(corner), "x and y", TRIANGLE);
      corner.forEach((value, k) => checkNumber(value, `${field}.${i}.${k}`, OFFSET));
    });
    if (corners.length < 3 || !spanAnArea(corners)) {
      const got = `${corners.length} corners${corners.length > 1 ? " on one line" : ""}`;
      throw new Refusal(field, got, "3 or more corners that span an area", TRIANGLE);
    }
  }
  function spanAnArea(corners) {
    const across = (k) => corners.map((corner) => corner[k] - corners[0][k]);
    const dot = (a, b) => a.reduce((sum, each, i) => sum + each * b[i], 0);
    const [x, y] = [across(0), across(1)];
    const most = Math.max(...[...x, ...y].map(Math.abs));
    const [longer, other] = dot(x, x) >= dot(y, y) ? [x, y] : [y, x];
    const size = Math.sqrt(dot(longer, longer));
    if (size === 0) return false;
    const unit = longer.map((each) => each / size);
    const part = dot(other, unit);
    const once = other.map((each, i) => each - part * unit[i]);
    const rest = dot(once, unit);
    const off = Math.hypot(...once.map((each, i) => each - rest * unit[i]));
    const larger = Math.sqrt(
      (size ** 2 + part ** 2 + off ** 2 + Math.sqrt((size ** 2 + part ** 2 + off ** 2) ** 2 - 4 * (size * off) ** 2)) / 2
    );
    return size * off / larger > EDGE * most;
  }
  function extent(corners, k) {
    let [low, high] = [Infinity, -Infinity];
    for (const corner of corners) {
      low = Math.min(low, corner[k]);
      high = Math.max(high, corner[k]);
    }
    return [low, high];
  }
  function polygonSize({ corners }) {
    return [0, 1].map((k) => {
      const [low, high] = extent(corners, k);
      return high - low;
    });
  }
  function insidePolygon(outline) {
    const middle = [0, 1].map((k) => {
      const [low, high] = extent(outline.corners, k);
      return (low + high) / 2;
    });
    const corners = outline.corners.map(([x, y]) => [x - middle[0], y - middle[1]]);
    const hair = EDGE * Math.max(...polygonSize(outline));
    const around = Array.from({ length: 8 }, (_, k) => (k + 0.5) * Math.PI / 4).map((d) => [
      hair * Math.cos(d),
      hair * Math.sin(d)
    ]);
    const odd = (x, y) => {
      let inside = false;
      for (let k = 0; k < corners.length; k++) {
        const [x0, y0] = corners[k];
        const [x1, y1] = corners[(k + 1) % corners.length];
        if (y0 !== y1 && y0 > y !== y1 > y && x < x0 + (y - y0) * (x1 - x0) / (y1 - y0)) inside = !inside;
      }
      return inside;
    };
    return (x, y) => around.every(([dx, dy]) => odd(x + dx, y + dy));
  }
  function checkRows(o) {
    checkNumbers(o, FIELD, { width_of_picture: LENGTH });
    const field = `${FIELD}.rows`;
    const { rows } = o;
    if (!Array.isArray(rows) || !rows.length || rows.some((row) => typeof row !== "string" || row.length !== rows[0].length))
      throw new Refusal(field, told(rows), "rows of equal length", ROWS);
    if (rows.length * rows[0].length > MOST_PIXELS)
      throw new Refusal(
        field,
        `${rows[0].length} × ${rows.length} pixels`,
        `at most ${MOST_PIXELS} of them`,
        "a smaller copy"
      );
    if (!rows.some((row) => row.includes("#")))
      throw new Refusal(field, "nothing dark in the picture", "a dark object on a light ground", ROWS);
  }
  function cropped({ rows }) {
    const dark = rows.map((row, i) => row.includes("#") ? i : -1).filter((i) => i >= 0);
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
    const [columns, rows] = size.map((extent2) => Math.max(1, roundHalfEven(Math.min(extent2 / pitch, 1e9))));
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
        const at = front.pop();
        const [i, j] = [Math.floor(at / rows), at % rows];
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
  var areCutAlike = (one, other) => cutOf(one) === cutOf(other);
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
  var NUMBERS2 = {
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
    checkNumbers(sheet, "sheet", NUMBERS2);
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
    const cubic = [axial * squared / 4, squared + axial * bending / 2, axial + 2 * bending, -4];
    let x = 2;
    for (let k = 0; k < 8; k++) {
      const value = ((cubic[0] * x + cubic[1]) * x + cubic[2]) * x + cubic[3];
      x -= value / ((3 * cubic[0] * x + 2 * cubic[1]) * x + cubic[2]);
    }
    return unit * x;
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
  var timeStep = (s) => s.time_step ?? usualStep(s);
  var measuredFrom = (s) => s.transient ?? 0.3 * s.duration;
  var staticDepth = ({ sheet, contact, gravity }) => {
    const forceAt1Millimetre = contact.stiffness * 1e-3 * sheet.pitch ** 2 / contact.tile_area;
    return 1e-3 * (nodeMass(sheet) * gravity / forceAt1Millimetre) ** (1 / 2.2);
  };

  // src/model/recording.js
  var SAMPLES_PER_PERIOD = 24;
  var LONGEST_SAMPLE_INTERVAL = 2e-3;
  var stepsOf = (s) => Math.max(1, roundHalfEven(s.duration / timeStep(s)));
  var strideOf = (s, motion = s.motion) => {
    const interval = Math.min(LONGEST_SAMPLE_INTERVAL, periodOf(motion) / SAMPLES_PER_PERIOD);
    return Math.max(1, Math.min(roundHalfEven(interval / timeStep(s)), stepsOf(s)));
  };
  var samplesOf = (s) => Math.floor(stepsOf(s) / strideOf(s)) + 1;
  var thinningOf = (s, snapshotInterval) => {
    if (!(snapshotInterval > 0)) return 0;
    return Math.max(1, roundHalfEven(Math.min(snapshotInterval / (strideOf(s) * timeStep(s)), samplesOf(s))));
  };
  var startPositions = (s, offset = [0, 0, 0]) => {
    const { rest, nNodes } = latticeOf(s.sheet);
    const { pitch } = s.sheet;
    const { height } = s.motion;
    const [x, y, angle] = [s.start.x + offset[0], s.start.y + offset[1], s.start.angle + offset[2]];
    const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
    const pose = poseAtStart(s.motion);
    const moved = pose.some((value) => value !== 0);
    const turned = rotationOf(pose);
    const depth = staticDepth(s);
    const out = new Float64Array(3 * nNodes);
    for (let k = 0; k < nNodes; k++) {
      const [along, across] = [rest[2 * k] * pitch, rest[2 * k + 1] * pitch];
      const laid = [along * cosine - across * sine + x, along * sine + across * cosine + y, -depth];
      const up = [laid[0], laid[1], laid[2] + height];
      for (let d = 0; d < 3; d++) {
        const carried = turned[3 * d] * up[0] + turned[3 * d + 1] * up[1] + turned[3 * d + 2] * up[2];
        out[3 * k + d] = moved ? carried - (d === 2 ? height : 0) + pose[d] : laid[d];
      }
    }
    return out;
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
  var mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  var placeOfLargest = (values) => values.reduce((best, value, i) => value > values[best] ? i : best, 0);
  var student95 = (freedom) => freedom < STUDENT_95.length ? STUDENT_95[freedom] : 1.95996 + 2.37227 / freedom + 2.8225 / freedom ** 2;
  var STUDENT_95 = [Infinity, 12.7062, 4.30265, 3.18245, 2.77645, 2.57058, 2.44691, 2.36462];

  // src/simulation/observables.js
  var GAITS = ["sliding", "walking", "running"];
  var SHORTEST_STRIDE = 0.01;
  var FOLDED_AREA = 0.5;
  var HANGING_DEPTH = 1e-3;
  var BLOCKS = 8;
  var SETTLED_SHARE = 0.05;
  var SETTLED_RATE = 2 * Math.PI / 180;
  var wholePeriods = (period, start, end) => Math.floor((end - start) / period + 1e-6);
  var rotation = (cross, dot) => unwrap(Float64Array.from(cross, (value, i) => Math.atan2(value, dot[i])));
  var spinRate = (time, angle, period, start, end) => {
    const periods = wholePeriods(period, start, end);
    if (!(periods >= 2) || time.length < 4) return { rate: NaN, low: NaN, high: NaN, settled: false, sd: NaN };
    const from = end - periods * period;
    const blocks = Math.min(BLOCKS, periods);
    const edges = Array.from({ length: blocks + 1 }, (_, i) => from + period * roundHalfEven(i * periods / blocks));
    const at = edges.map((edge) => interpolate(edge, time, angle));
    const weights = edges.slice(1).map((edge, i) => edge - edges[i]);
    const slopes = weights.map((weight, i) => (at[i + 1] - at[i]) / weight);
    const total = weights.reduce((sum, weight) => sum + weight, 0);
    const average = (values) => values.reduce((sum, value, i) => sum + weights[i] * value, 0) / total;
    const rate = average(slopes);
    const spread = Math.sqrt(average(slopes.map((slope) => (slope - rate) ** 2)) * blocks / (blocks - 1));
    const half = student95(blocks - 1) * spread / Math.sqrt(blocks);
    const span = Math.floor(periods / 2) * period;
    const rateFrom = (a) => (interpolate(a + span, time, angle) - interpolate(a, time, angle)) / span;
    const settled = Math.abs(rateFrom(end - span) - rateFrom(from)) <= Math.max(SETTLED_SHARE * Math.abs(rate), SETTLED_RATE);
    return { rate, low: rate - half, high: rate + half, settled, sd: spread };
  };
  var twist = (time, moves, period, start, end) => {
    const periods = wholePeriods(period, start, end);
    if (!(periods >= 2) || time.length < 4) {
      return { mean: [NaN, NaN, NaN], covariance: [0, 1, 2].map(() => [NaN, NaN, NaN]) };
    }
    const edges = Array.from({ length: periods + 1 }, (_, i) => end - period * (periods - i));
    const strides = moves.map((move) => {
      const at = edges.map((edge) => interpolate(edge, time, move));
      return Float64Array.from({ length: periods }, (_, i) => (at[i + 1] - at[i]) / (edges[i + 1] - edges[i]));
    });
    const means = strides.map(mean);
    const covariance = strides.map(
      (one, a) => strides.map((other, b) => {
        let sum = 0;
        for (let i = 0; i < periods; i++) sum += (one[i] - means[a]) * (other[i] - means[b]);
        return sum / (periods - 1);
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
  var periodMaxima = (time, values, period, start, end) => {
    const largest = [];
    const count = inPeriods(time, values, period, start, end, (index, value) => {
      const before = largest[index] ?? -Infinity;
      largest[index] = value > before || Number.isNaN(value) ? value : before;
    });
    return Float64Array.from({ length: count }, (_, i) => Number.isFinite(largest[i]) ? largest[i] : NaN);
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
      const sum = new Float64Array(n + 1);
      for (let i = 0; i < n; i++) sum[i + 1] = sum[i] + values[i];
      return sum;
    });
    return Float64Array.from({ length: n }, (_, i) => {
      const reach = Math.min(half, i, n - 1 - i);
      const [dx, dy] = sums.map((sum) => (sum[i + reach + 1] - sum[i - reach]) / (2 * reach + 1));
      return Math.hypot(dx - x[0], dy - y[0]);
    });
  };
  var isAveraged = (time, i, last, period) => time[i] <= time[last] - period / 2 || time[last] < period;
  var finiteSamples = (channels) => {
    const all = Object.values(channels);
    const n = channels.time.length;
    return all.reduce((finite, values) => {
      for (let i = 0; i < finite; i++) if (!Number.isFinite(values[i])) return i;
      return finite;
    }, n);
  };
  var firstFailure = (channels, period, slipLimit, plateSize = null, diverged = false) => {
    const { time } = channels;
    const last = finiteSamples(channels);
    const failures = [];
    const sign = (kind, at) => at >= 0 && failures.push({ kind, time: time[at], first_sign: Infinity });
    if (last > 0) {
      const [t, x, y] = [time, channels.centre_x, channels.centre_y].map((values) => values.subarray(0, last));
      const slipped = slip(t, x, y, period);
      sign("slipped", slipped.findIndex((way, i) => way > slipLimit && isAveraged(t, i, last - 1, period)));
    }
    const state = stateOf(channels, plateSize);
    const first = (holds) => {
      for (let i = 0; i < last; i++) if (holds(i)) return i;
      return -1;
    };
    sign("folded", first((i) => state.folded(i) && !state.hanging(i)));
    sign("turned over", first((i) => state.over(i) && !state.hanging(i)));
    sign("left the plate", first((i) => state.beyond(i) || state.hanging(i) && (state.folded(i) || state.over(i))));
    if (diverged || last < time.length) sign("diverged", Math.max(last - 1, 0));
    if (!failures.length) return null;
    const earliest = failures.reduce((best, failure) => failure.time < best.time ? failure : best);
    const left = earliest.kind === "slipped" && failures.find(({ kind }) => kind === "left the plate");
    return left ? { ...left, first_sign: earliest.time } : earliest;
  };
  var stateOf = (channels, plateSize) => {
    const { centre_x: x, centre_y: y, centre_z: z, area_x: ax, area_y: ay, area_z: az } = channels;
    const never = () => false;
    const told2 = az && az[0] > 0;
    const size = (i) => Math.hypot(ax[i], ay[i], az[i]);
    return {
      folded: told2 ? (i) => size(i) < FOLDED_AREA : never,
      over: told2 ? (i) => size(i) >= FOLDED_AREA && az[i] < 0 : never,
      beyond: plateSize ? (i) => Math.abs(x[i]) > plateSize[0] / 2 || Math.abs(y[i]) > plateSize[1] / 2 : never,
      hanging: plateSize && z ? (i) => z[i] < -HANGING_DEPTH : never
    };
  };
  var soundUntil = (time, failure) => failure ? Math.min(failure.time, failure.first_sign) : time[time.length - 1];

  // src/simulation/registry.js
  var finiteMean = (values) => values.length ? mean(values) : NaN;
  var drift = ({ channels, period }) => {
    const { time } = channels;
    let furthest = NaN;
    slip(time, channels.centre_x, channels.centre_y, period).forEach((way, i) => {
      if (Number.isFinite(way) && isAveraged(time, i, time.length - 1, period) && !(way <= furthest)) furthest = way;
    });
    return furthest;
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
    channels.plate_work.forEach((given3, i) => {
      if (channels.time[i] > start && channels.time[i] <= end) work += given3;
    });
    return work / (end - start);
  };
  var velocity = (which) => (window) => window.twist.mean[which];
  var strideCovariance = (one, other) => (window) => window.twist.covariance[one][other];
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
      measure: (window) => finiteMean(window.means("contact"))
    },
    {
      name: "flight_fraction",
      unit: "1",
      display: "%",
      longName: "share of the time in which nothing touches",
      label: "time in flight",
      measure: (window) => finiteMean(window.means("flight"))
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
      measure: (window) => finiteMean(window.maxima("height_high"))
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
      measure: (window) => window.energy.relativeResidual
    },
    {
      name: "energy_imbalance",
      unit: "1",
      longName: "furthest that the energy was out of balance, over the energy given",
      overRuns: "worst",
      measure: (window) => window.energy.imbalance
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
  var measureAll = (window) => Object.fromEntries(OBSERVABLES.map(({ name, measure }) => [name, measure(window)]));

  // src/simulation/ensemble.js
  var START_SPREAD = 1e-4;
  var START_TURN = Math.PI / 180;
  var starts = (repeats, seed) => {
    const normal = normals(seed);
    return Array.from(
      { length: repeats },
      (_, i) => i === 0 ? [0, 0, 0] : [START_SPREAD * normal(), START_SPREAD * normal(), START_TURN * normal()]
    );
  };
  var normals = (seed) => {
    let state = mixed(seed | 0);
    const uniform = () => {
      state = state + 2654435769 | 0;
      return (mixed(state) >>> 0) / 2 ** 32;
    };
    return () => Math.sqrt(-2 * Math.log(1 - uniform())) * Math.cos(2 * Math.PI * uniform());
  };
  var mixed = (bits) => {
    const once = Math.imul(bits ^ bits >>> 16, 569420461);
    const twice = Math.imul(once ^ once >>> 15, 1935289751);
    return twice ^ twice >>> 15;
  };

  // src/simulation/energy.js
  var LEDGER_TOLERANCE = 0.05;
  var LEAST_LIFT = 1e-3;
  var BEGUN = ["kinetic", "axial", "bending", "torsion", "contact"];
  var leastEnergy = (weight, size) => weight * LEAST_LIFT * size;
  var energyLedger = (channels, least2 = 0) => {
    const [contactEnergy, gravity] = [channels.contact_energy, channels.gravity_energy];
    const sums = { work: 0, contactWork: 0, joint: 0, friction: 0, exchanged: 0 };
    let [largestGap, lowest, at] = [-Infinity, Infinity, null];
    for (let i = 0; i < channels.time.length; i++) {
      sums.work += channels.plate_work[i];
      sums.exchanged += Math.abs(channels.plate_work[i]);
      sums.contactWork += channels.contact_work[i];
      sums.joint += channels.joint_loss[i];
      sums.friction += channels.friction_loss[i];
      at = {
        kinetic: channels.kinetic_energy[i] - channels.kinetic_energy[0],
        gravity: gravity[i] - gravity[0],
        axial: channels.axial_energy[i] - channels.axial_energy[0],
        bending: channels.bending_energy[i] - channels.bending_energy[0],
        torsion: channels.torsion_energy[i] - channels.torsion_energy[0],
        contactStored: contactEnergy[i] - contactEnergy[0]
      };
      at.elastic = at.axial + at.bending + at.torsion;
      const stored = at.kinetic + at.gravity + at.elastic + at.contactStored;
      const contactLoss = sums.contactWork - at.contactStored;
      const lost = sums.joint + contactLoss + sums.friction;
      largestGap = Math.max(
        largestGap,
        Math.abs(sums.work - stored - lost),
        stored - sums.work,
        -sums.joint,
        -contactLoss,
        -sums.friction
      );
      lowest = Math.min(lowest, at.gravity);
    }
    const begun2 = BEGUN.reduce((sum, name) => sum + Math.abs(channels[`${name}_energy`][0]), 0);
    const ledger = {
      plateWork: sums.work,
      ...at,
      jointLoss: sums.joint,
      contactLoss: sums.contactWork - at.contactStored,
      frictionLoss: sums.friction,
      given: sums.exchanged + begun2 - lowest + least2,
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
  var share = (energy, given3) => given3 !== 0 ? energy / given3 : energy === 0 ? 0 : NaN;

  // src/simulation/observe.js
  var observe = (scenario, recording) => {
    const { channels } = recording;
    const period = periodOf(scenario.motion);
    const from = measuredFrom(scenario);
    const plateSize = scenario.plate ? [scenario.plate.length, scenario.plate.width] : null;
    const failure = firstFailure(channels, period, scenario.slip_limit, plateSize, recording.diverged);
    const energy = energyLedger(channels, least(scenario));
    const end = soundUntil(channels.time, failure);
    const angle = rotation(channels.spin_cross, channels.spin_dot);
    const window = windowOf(channels, angle, period, from, end, energy);
    const legs = ["left_contact", "right_contact", "flight"].map(window.means);
    return {
      spin: spinRate(channels.time, angle, period, from, end),
      gait: gait(...legs),
      failure,
      energy,
      values: measureAll(window)
    };
  };
  var least = ({ sheet, gravity }) => {
    const { rest } = latticeOf(sheet);
    const sides = [0, 1].map((axis) => {
      const along = rest.filter((_, i) => i % 2 === axis);
      return along.reduce((most, place) => Math.max(most, place), -Infinity) - along.reduce((low, place) => Math.min(low, place), Infinity);
    });
    return leastEnergy(sheet.mass * gravity, (Math.max(...sides) + 1) * sheet.pitch);
  };
  var windowOf = (channels, angle, period, from, end, energy) => {
    const start = end - Math.max(0, wholePeriods(period, from, end)) * period;
    const { time } = channels;
    return {
      channels,
      period,
      start,
      end,
      energy,
      twist: twist(time, [channels.centre_x, channels.centre_y, angle], period, start, end),
      means: (name) => periodMeans(time, channels[name], period, start, end),
      maxima: (name) => periodMaxima(time, channels[name], period, start, end)
    };
  };

  // src/engine/piece.js
  var byChannel = (samples, names) => {
    const count = samples.length / names.length;
    return Object.fromEntries(
      names.map((name, c) => {
        const series = new Float32Array(count);
        for (let k = 0; k < count; k++) series[k] = samples[k * names.length + c];
        return [name, series];
      })
    );
  };
  var shapesOf = (channels, first, thinning, pictured) => {
    const at = [];
    for (let k = 0; at.length < pictured; k++) if ((first + k) % thinning === 0) at.push(k);
    return {
      snapshotTime: Float64Array.from(at, (k) => channels.time[k]),
      platePose: Float32Array.from(at.flatMap((k) => AXES.map((axis) => channels[`plate_${axis}`][k])))
    };
  };
  var joined = (pieces) => Object.fromEntries(
    Object.keys(pieces[0]).map((name) => {
      const whole = new pieces[0][name].constructor(pieces.reduce((sum, piece) => sum + piece[name].length, 0));
      let at = 0;
      for (const piece of pieces) {
        whole.set(piece[name], at);
        at += piece[name].length;
      }
      return [name, whole];
    })
  );
  var multiples = (count, of) => of > 0 ? Math.ceil(count / of) : 0;
  var allFinite = (numbers2) => {
    for (let k = 0; k < numbers2.length; k++) if (!Number.isFinite(numbers2[k])) return false;
    return true;
  };

  // src/model/course.js
  var OVER = 1 + 1e-5;
  var courseOf = (motion) => [{ motion, begin: 0, duration: motion.ramp, tableBegin: 0 }];
  var stillNeeded = (course, time) => {
    for (let i = course.length - 1; i > 0; i--) {
      const { begin: begin2, duration } = course[i];
      if (time - begin2 > duration * OVER + SHORTEST_RAMP) return course.slice(i);
    }
    return course;
  };
  var goneOver = (course, motion, time, duration) => {
    const before = course.at(-1);
    const same = motion.samples && JSON.stringify(motion.samples) === JSON.stringify(before.motion.samples);
    return [...stillNeeded(course, time), { motion, begin: time, duration, tableBegin: same ? before.tableBegin : time }];
  };

  // src/model/spline.js
  var MOST_KNOTS = 2e6;
  function knotsOf(samples, step, end) {
    const last = samples.time.at(-1);
    const n = Math.ceil((Math.min(last, end) + 2 * step) / step);
    if (!(n <= MOST_KNOTS))
      throw new Refusal(
        "motion.samples",
        `${n} knots`,
        `at most ${MOST_KNOTS}`,
        "samples further apart, or a shorter run"
      );
    const table = new Float64Array(12 * n);
    AXES.forEach((axis, d) => {
      const values = samples[axis];
      if (!values?.length) return;
      const spline = naturalSpline(samples.time, values);
      for (let k = 0; k < n; k++) {
        const time = k * step;
        const [at, speed] = spline(Math.min(time, last));
        table[12 * k + 2 * d] = at;
        table[12 * k + 2 * d + 1] = time < last ? speed : 0;
      }
    });
    return table;
  }
  function naturalSpline(x, y) {
    const n = x.length;
    const second = new Float64Array(n);
    const u = new Float64Array(n);
    for (let k = 1; k < n - 1; k++) {
      const share2 = (x[k] - x[k - 1]) / (x[k + 1] - x[k - 1]);
      const p = share2 * second[k - 1] + 2;
      second[k] = (share2 - 1) / p;
      const bend = (y[k + 1] - y[k]) / (x[k + 1] - x[k]) - (y[k] - y[k - 1]) / (x[k] - x[k - 1]);
      u[k] = (6 * bend / (x[k + 1] - x[k - 1]) - share2 * u[k - 1]) / p;
    }
    second[n - 1] = 0;
    for (let k = n - 2; k >= 0; k--) second[k] = second[k] * second[k + 1] + u[k];
    let at = 0;
    return (time) => {
      if (time < x[at]) at = 0;
      while (at < n - 2 && time >= x[at + 1]) at++;
      const h = x[at + 1] - x[at];
      const [a, b] = [(x[at + 1] - time) / h, (time - x[at]) / h];
      const value = a * y[at] + b * y[at + 1] + ((a ** 3 - a) * second[at] + (b ** 3 - b) * second[at + 1]) * h * h / 6;
      const slope = (y[at + 1] - y[at]) / h + (-(3 * a * a - 1) * second[at] + (3 * b * b - 1) * second[at + 1]) * h / 6;
      return [value, slope];
    };
  }

  // src/model/packing.js
  var ENDLESS = 1e9;
  function parametersOf(s) {
    const { sheet, contact, friction } = s;
    const share2 = sheet.pitch ** 2 / contact.tile_area;
    return {
      pitch: sheet.pitch,
      node_mass: nodeMass(sheet),
      axial_stiffness: sheet.axial_stiffness,
      axial_damping: sheet.axial_damping,
      shear_ratio: sheet.shear_ratio,
      bending_stiffness: sheet.bending_stiffness,
      bending_damping: sheet.bending_damping,
      torsion_stiffness: sheet.torsion_stiffness,
      torsion_damping: sheet.torsion_damping,
      contact_stiffness: contact.stiffness * 1e-3 * share2,
      contact_damping: contact.damping * share2,
      contact_ramp: contact.damping_ramp,
      static_friction: friction.static,
      kinetic_friction: friction.kinetic,
      static_speed: friction.transition_speed,
      kinetic_speed: friction.transition_speed * friction.kinetic_speed_ratio,
      smooth_friction: friction.law === "adams" ? 1 : 0,
      gravity: s.gravity,
      plate_half_length: s.plate ? s.plate.length / 2 : ENDLESS,
      plate_half_width: s.plate ? s.plate.width / 2 : ENDLESS,
      plate_height: s.motion.height,
      time_step: timeStep(s)
    };
  }
  function packParameters(names, scenarios) {
    const rows = scenarios.map(parametersOf);
    const packed = new Float64Array(names.length * rows.length);
    names.forEach((name, p) => rows.forEach((row, j) => packed[p * rows.length + j] = row[name]));
    return packed;
  }
  function featuresOf(scenarios) {
    return [
      scenarios.some((s) => s.sheet.torsion_stiffness !== 0 || s.sheet.torsion_damping !== 0),
      scenarios.some((s) => s.friction.law === "adams"),
      scenarios.some((s) => Boolean(s.plate)),
      scenarios.some((s) => s.contact.damping_ramp !== 0)
    ].map(Number);
  }
  function tableStep(s, motion) {
    if (!motion.samples) return 1;
    return Math.fround(Math.max(Math.min(finestStep(motion.samples) / 2, s.duration), 2 * timeStep(s)));
  }
  function packCourses(scenarios, courses, ends) {
    const n = courses.length;
    const most = Math.max(...courses.map((course) => course.length));
    const missing = courses.map((course) => most - course.length);
    const layerTerms = [0];
    const termDof = [];
    const terms = [];
    const layers = [];
    const followed = [];
    for (let i = 0; i < most; i++) {
      const row = courses.map((course, j) => i > missing[j] ? course[i - missing[j]] : course[0]);
      const gone = missing.map((each) => each > i);
      const packed = packTerms(row.map((layer, j) => gone[j] ? [] : termsOf(layer.motion)));
      termDof.push(...packed.dofs);
      terms.push(...packed.numbers);
      layerTerms.push(termDof.length);
      const numbers2 = row.map(
        (layer, j) => gone[j] ? [0, 0, 0, 1, ...offsetOf(layer.motion)] : [
          layer.begin,
          layer.duration,
          layer.tableBegin,
          tableStep(scenarios[j], layer.motion),
          ...offsetOf(layer.motion)
        ]
      );
      for (let k = 0; k < numbers2[0].length; k++) for (let j = 0; j < n; j++) layers.push(numbers2[j][k]);
      row.forEach(
        (layer, j) => followed.push(
          !gone[j] && layer.motion.samples ? {
            samples: layer.motion.samples,
            step: tableStep(scenarios[j], layer.motion),
            end: ends[j] - layer.tableBegin
          } : null
        )
      );
    }
    return {
      nLayers: most,
      layerTerms: Int32Array.from(layerTerms),
      termDof: Int32Array.from(termDof),
      terms: Float64Array.from(terms),
      layers: Float64Array.from(layers),
      ...tables(followed)
    };
  }
  function packTerms(byRun) {
    const most = Array.from(
      { length: 6 },
      (_, d) => Math.max(...byRun.map((terms) => terms.filter((term) => term[0] === d).length))
    );
    const dofs = most.flatMap((count, d) => Array(count).fill(d));
    const numbers2 = new Array(dofs.length * 3 * byRun.length).fill(0);
    byRun.forEach((terms, j) => {
      const free = most.map((_, d) => most.slice(0, d).reduce((sum, count) => sum + count, 0));
      for (const [d, ...values] of terms) {
        const slot = free[d]++;
        values.forEach((value, k) => numbers2[(3 * slot + k) * byRun.length + j] = value);
      }
    });
    return { dofs, numbers: numbers2 };
  }
  function tables(followed) {
    if (!followed.some(Boolean))
      return { knots: new Float64Array(0), firstKnot: new BigInt64Array(0), nKnots: new BigInt64Array(0) };
    const made = /* @__PURE__ */ new Map();
    const keyOf = (one) => one ? `${identity(one.samples)} ${one.step}` : "";
    const ends = /* @__PURE__ */ new Map();
    for (const one of followed) ends.set(keyOf(one), Math.max(ends.get(keyOf(one)) ?? 0, one?.end ?? 0));
    let length = 0;
    for (const one of followed) {
      const key = keyOf(one);
      if (made.has(key)) continue;
      const knots2 = one ? knotsOf(one.samples, one.step, ends.get(key)) : new Float64Array(24);
      made.set(key, { first: length, count: knots2.length / 12, knots: knots2 });
      length += knots2.length / 12;
    }
    const knots = new Float64Array(12 * length);
    for (const { first, knots: own } of made.values()) knots.set(own, 12 * first);
    return {
      knots,
      firstKnot: BigInt64Array.from(followed, (one) => BigInt(made.get(keyOf(one)).first)),
      nKnots: BigInt64Array.from(followed, (one) => BigInt(made.get(keyOf(one)).count))
    };
  }
  var identities = /* @__PURE__ */ new WeakMap();
  var given2 = 0;
  var identity = (object) => {
    if (!identities.has(object)) identities.set(object, ++given2);
    return identities.get(object);
  };

  // src/engine/asked.js
  var FASTEST = 100;
  var FURTHEST = 10;
  var RADIUS = 0.02;
  var LaidDownAnew = class extends Error {
    constructor(what) {
      super(`${what} must be laid down anew`);
      this.anew = true;
    }
  };
  var numbers = (values, count, most) => Array.isArray(values) && values.length === count && values.every((value) => typeof value === "number" && Math.abs(value) <= most);
  var checkOffset = (offset) => {
    if (!numbers(offset, 3, FURTHEST))
      throw new Error("an offset of a start is x and y in m, and an angle in rad; try [0, 0, 0]");
    return offset;
  };
  var checkKick = ({ velocity: velocity2 = [0, 0, 0], spin = 0, at = null, radius = RADIUS }) => {
    const along = Array.isArray(velocity2) && velocity2.length === 2 ? [...velocity2, 0] : velocity2;
    const fits = numbers(along, 3, FASTEST) && numbers([spin], 1, FASTEST) && (at === null || numbers(at, 2, FURTHEST)) && typeof radius === "number" && radius > 0 && radius <= FURTHEST;
    if (!fits) throw new Error(`a kick is a velocity of at most ${FASTEST} m/s along x, y, z; try [0.2, 0, 0]`);
    return { velocity: along, spin, at, radius };
  };
  var checkSaved = (saved, session) => {
    const refusal = new Error("nothing that this sheet was saved as");
    const kept = saved?.state;
    if (!kept || !["scenarios", "courses", "stride", "since", "wanted"].every(
      (name) => saved[name]?.length === session.scenarios.length
    ))
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

  // src/engine/session.js
  var [TAKEN, , DUE, SAMPLED] = [0, 1, 2, 3];
  var AHEAD = 2;
  var MOST_NUMBERS = 3e7;
  var NODE_NUMBERS = 3;
  var PLATE_NUMBERS = 6;
  var USUAL_RAMP = 0.1;
  var ON_THE_PLATE = -2;
  var Session = class {
    /**
     * @param {import("./module.js").Engine} engine
     * @param {object[]} scenarios of like lattice
     * @param {{offsets?: number[][], snapshotInterval?: number}} [given] x, y, angle added to each start, m and rad; time
     *   between recorded shapes, s, 0 for none
     */
    constructor(engine, scenarios, { offsets = [], snapshotInterval = 0 } = {}) {
      scenarios.forEach(checkScenario);
      this.engine = engine;
      this.scenarios = [...scenarios];
      this.lattice = latticeOf(scenarios[0].sheet);
      if (scenarios.some(({ sheet }) => latticeOf(sheet) !== this.lattice))
        throw new Error("sheets of one lattice go side by side");
      this.courses = scenarios.map(({ motion }) => courseOf(motion));
      this.stride = scenarios.map((s) => strideOf(s));
      this.thinning = scenarios.map((s) => thinningOf(s, snapshotInterval));
      this.since = scenarios.map(() => ({ sample: 0, time: 0 }));
      this.wanted = scenarios.map(() => 0);
      this.tabulated = scenarios.map(() => 0);
      this.state = this.#start(offsets);
      this.packed = null;
    }
    #start(offsets) {
      const { engine, scenarios } = this;
      const [n, per] = [scenarios.length, 3 * this.lattice.nNodes];
      const x = new Float64Array(n * per);
      scenarios.forEach((s, j) => x.set(startPositions(s, offsets[j] && checkOffset(offsets[j])), j * per));
      return {
        x,
        v: new Float64Array(n * per),
        edge: new Float64Array(this.#ends() ? n * per : 0),
        tally: new Float64Array(n * engine.tallies),
        clock: new BigInt64Array(n * engine.clocks),
        last: new Float32Array(n * engine.names.channels.length).fill(NaN),
        diverged: scenarios.map(() => false)
      };
    }
    /** Whether some plate ends. */
    #ends() {
      return featuresOf(this.scenarios)[2] === 1;
    }
    #clock(run, which) {
      return Number(this.state.clock[run * this.engine.clocks + which]);
    }
    /** Time of a run, s. */
    time(run = 0) {
      return this.#clock(run, TAKEN) * timeStep(this.scenarios[run]);
    }
    /** Whether a run ceased to be finite: it goes on no further. */
    diverged(run = 0) {
      return this.state.diverged[run];
    }
    /**
     * Let all runs go on: for so many seconds, or by so many steps of each.
     *
     * @param {{seconds?: number, steps?: number[]}} how
     * @returns {import("./piece.js").Piece[]}
     */
    advance({ seconds = 0, steps }) {
      const { engine, scenarios, state } = this;
      const wanted = scenarios.map((s, j) => steps ? this.time(j) + steps[j] * timeStep(s) : this.wanted[j] + seconds);
      const todo = scenarios.map(
        (s, j) => state.diverged[j] ? 0 : Math.max(0, steps?.[j] ?? roundHalfEven(wanted[j] / timeStep(s)) - this.#clock(j, TAKEN))
      );
      if (!allFinite(todo)) throw new Error("no finite time to go on for");
      const [n, channels, per] = [scenarios.length, engine.names.channels.length, 3 * this.lattice.nNodes];
      const first = scenarios.map((_, j) => this.#clock(j, SAMPLED));
      const due = todo.map((count, j) => this.#samplesWithin(j, count));
      const maxSamples = Math.max(...due);
      const maxSnapshots = Math.max(...due.map((count, j) => this.#pictures(j, first[j], count)));
      if (n * (maxSamples * channels + maxSnapshots * per) > MOST_NUMBERS)
        throw new Error("more to record at once than a page has room for; try a shorter run, or fewer at once");
      const told2 = this.#told(todo);
      const before = scenarios.map((_, j) => this.#clock(j, TAKEN));
      const { samples, snapshots, ...next } = engine.with(
        { ...told2.counts, max_samples: maxSamples, max_snapshots: maxSnapshots },
        {
          ...told2.arrays,
          samples: { bytes: 4 * n * maxSamples * channels },
          snapshots: { bytes: 4 * n * maxSnapshots * per }
        },
        (table) => engine.core.plategait_advance(table),
        (view) => ({
          x: view(Float64Array, "x", n * per),
          v: view(Float64Array, "v", n * per),
          edge: view(Float64Array, "edge", state.edge.length),
          tally: view(Float64Array, "tally", n * engine.tallies),
          clock: view(BigInt64Array, "clock", n * engine.clocks),
          last: view(Float32Array, "last", n * channels),
          samples: view(Float32Array, "samples", n * maxSamples * channels),
          snapshots: view(Float32Array, "snapshots", n * maxSnapshots * per)
        })
      );
      this.state = { ...next, diverged: state.diverged };
      this.wanted = wanted;
      const taken = before.map((from, j) => this.#clock(j, TAKEN) - from);
      this.state.diverged = scenarios.map(
        (_, j) => state.diverged[j] || taken[j] < todo[j] || !allFinite(next.x.subarray(j * per, (j + 1) * per))
      );
      return scenarios.map((_, j) => {
        const from = j * maxSamples * channels;
        const written = Math.min(this.#clock(j, SAMPLED) - first[j], maxSamples);
        const own = samples.subarray(from, from + written * channels);
        return this.#piece(j, first[j], own, snapshots.subarray(j * maxSnapshots * per), taken[j]);
      });
    }
    /** @returns {import("./piece.js").Piece} */
    #piece(run, first, samples, snapshots, steps) {
      const channels = byChannel(samples, this.engine.names.channels);
      const { sample, time } = this.since[run];
      const interval = this.stride[run] * timeStep(this.scenarios[run]);
      channels.time = Float64Array.from(channels.time, (_, k) => time + (first + k - sample) * interval);
      const pictured = this.#pictures(run, first, channels.time.length);
      return {
        channels,
        steps,
        diverged: this.state.diverged[run] || !allFinite(samples),
        snapshots: snapshots.slice(0, pictured * 3 * this.lattice.nNodes),
        ...shapesOf(channels, first, this.thinning[run], pictured)
      };
    }
    #samplesWithin(run, steps) {
      const [due, end] = [this.#clock(run, DUE), this.#clock(run, TAKEN) + steps];
      return due <= end && steps > 0 ? Math.floor((end - due) / this.stride[run]) + 1 : 0;
    }
    #pictures(run, first, samples) {
      return multiples(first + samples, this.thinning[run]) - multiples(first, this.thinning[run]);
    }
    /** Everything that the core reads before it takes steps, by the names of its table. */
    #told(steps) {
      const { lattice: lattice2, scenarios, state } = this;
      scenarios.forEach((s, j) => {
        const reached = this.time(j) + steps[j] * timeStep(s);
        const needed = stillNeeded(this.courses[j], this.time(j));
        if (needed === this.courses[j] && reached <= this.tabulated[j]) return;
        this.courses[j] = needed;
        if (reached > this.tabulated[j]) this.tabulated[j] = this.tabulated[j] > 0 ? AHEAD * reached : reached;
        this.packed = null;
      });
      this.packed ??= packCourses(scenarios, this.courses, this.tabulated);
      const { packed } = this;
      const [torsion, smooth, edge, ramp] = featuresOf(scenarios);
      const whole = (values) => BigInt64Array.from(values, BigInt);
      return {
        counts: {
          n_nodes: lattice2.nNodes,
          n_lines: lattice2.lineStart.length - 1,
          n_axial_lines: lattice2.axial,
          n_cells: lattice2.nCells,
          n_runs: scenarios.length,
          n_layers: packed.nLayers,
          n_terms: packed.termDof.length,
          has_torsion: torsion,
          has_smooth_friction: smooth,
          has_plate_edge: edge,
          has_contact_ramp: ramp
        },
        arrays: {
          line_start: lattice2.lineStart,
          line_nodes: lattice2.lineNodes,
          cells: lattice2.cells,
          rest: lattice2.rest,
          mobility: new Float64Array(lattice2.nNodes).fill(1),
          parameters: packParameters(this.engine.names.parameters, scenarios),
          layer_terms: packed.layerTerms,
          term_dof: packed.termDof,
          terms: packed.terms,
          layers: packed.layers,
          steps: whole(steps),
          stride: whole(this.stride),
          thinning: whole(this.thinning),
          x: state.x,
          v: state.v,
          edge: state.edge,
          tally: state.tally,
          clock: state.clock,
          last: state.last,
          ...packed.knots.length ? { knots: packed.knots, first_knot: packed.firstKnot, n_knots: packed.nKnots } : {}
        }
      };
    }
    /** Let the plate of a run go over to another motion from now on, within so many seconds. @throws {LaidDownAnew} */
    change(run, motion, ramp = motion?.ramp) {
      this.become(run, { ...this.scenarios[run], motion }, ramp);
    }
    /**
     * Let a run be another of the same lattice from now on, where it is; its plate goes over to the other's motion.
     *
     * @throws {LaidDownAnew} where it would want another lattice, a plate about another axis, or a shorter time step
     */
    become(run, scenario, ramp = scenario.motion?.ramp) {
      const step = timeStep(this.scenarios[run]);
      checkScenario({ ...scenario, time_step: null });
      if (!areCutAlike(scenario.sheet, this.scenarios[run].sheet)) throw new LaidDownAnew("a sheet of another lattice");
      if (scenario.motion.height !== this.scenarios[run].motion.height)
        throw new LaidDownAnew("a plate about another axis");
      const usual = timeStep({ ...scenario, time_step: null });
      if (usual < step * (1 - 1e-9)) throw new LaidDownAnew("what needs a shorter time step");
      const ended = this.#ends();
      if (JSON.stringify(scenario.motion) !== JSON.stringify(this.scenarios[run].motion))
        this.#goOver(run, scenario.motion, ramp);
      this.scenarios[run] = { ...scenario, time_step: step };
      if (this.#ends() && !ended) this.state.edge = this.state.x.map((_, k) => k % 3 === 2 ? ON_THE_PLATE : 0);
      if (!this.#ends()) this.state.edge = new Float64Array(0);
      this.packed = null;
    }
    #goOver(run, motion, ramp) {
      const duration = Number.isFinite(ramp) && ramp > SHORTEST_RAMP ? ramp : USUAL_RAMP;
      this.courses[run] = goneOver(this.courses[run], motion, this.time(run), duration);
      const step = timeStep(this.scenarios[run]);
      const stride = strideOf({ ...this.scenarios[run], motion, time_step: step });
      if (stride === this.stride[run]) return;
      this.since[run] = { sample: this.#clock(run, SAMPLED), time: this.#clock(run, DUE) * step };
      this.stride[run] = stride;
    }
    /**
     * Add to the velocities of a run's nodes.
     *
     * @param {{velocity?: number[], spin?: number, at?: number[], radius?: number}} kick m/s along x, y, z; rad/s about
     *   the sheet's middle; where it is felt most and how far from there, m: everywhere alike where that is left out
     */
    push(run, kick) {
      const { velocity: velocity2, spin, at, radius } = checkKick(kick);
      const [n, per] = [this.lattice.nNodes, 3 * this.lattice.nNodes];
      const x = this.state.x.subarray(run * per, (run + 1) * per);
      const v = this.state.v.slice();
      let [middleX, middleY] = [0, 0];
      for (let k = 0; k < n; k++) {
        middleX += x[3 * k] / n;
        middleY += x[3 * k + 1] / n;
      }
      for (let k = 0; k < n; k++) {
        const far = at ? Math.hypot(x[3 * k] - at[0], x[3 * k + 1] - at[1]) / radius : 0;
        const share2 = Math.exp(-far * far);
        const own = run * per + 3 * k;
        v[own] += share2 * velocity2[0] - spin * (x[3 * k + 1] - middleY);
        v[own + 1] += share2 * velocity2[1] + spin * (x[3 * k] - middleX);
        v[own + 2] += share2 * velocity2[2];
      }
      this.state = { ...this.state, v };
    }
    /** Node positions of a run now, world frame, m: [node][x, y, z]. */
    nodes(run = 0) {
      const per = 3 * this.lattice.nNodes;
      return Float32Array.from(this.state.x.subarray(run * per, (run + 1) * per));
    }
    /** Pose of a run's plate now, m and rad. */
    platePose(run = 0) {
      if (this.#clock(run, TAKEN) === 0) return poseAtStart(this.scenarios[run].motion);
      const at = run * this.engine.names.channels.length;
      return AXES.map((axis) => this.state.last[at + this.engine.channel[`plate_${axis}`]]);
    }
    /**
     * What each node of the first run gets from the plate now, and the plate from them.
     *
     * @returns {{nodes: Float32Array, plate: Float32Array}} [node][normal, along x, along y], N; force, N, and torque
     *   about the middle of the surface, N m, both in the plate's frame
     */
    forces() {
      const n = this.lattice.nNodes;
      const told2 = this.#told(this.scenarios.map(() => 0));
      return this.engine.with(
        told2.counts,
        { ...told2.arrays, forces: { bytes: 4 * NODE_NUMBERS * n }, plate: { bytes: 4 * PLATE_NUMBERS } },
        (table, address) => this.engine.core.plategait_show(table, address.forces, address.plate),
        (view) => ({
          nodes: view(Float32Array, "forces", NODE_NUMBERS * n),
          plate: view(Float32Array, "plate", PLATE_NUMBERS)
        })
      );
    }
    /** Where the runs are, to come back to. */
    save() {
      const { state, scenarios, courses, stride, since, wanted } = this;
      return structuredClone({ state, scenarios, courses, stride, since, wanted });
    }
    /** Go back to where the runs were. */
    restore(saved) {
      checkSaved(saved, this);
      Object.assign(this, structuredClone(saved), { tabulated: this.scenarios.map(() => 0), packed: null });
    }
  };

  // src/engine/answers.js
  var MOST_FRAMES = 600;
  var MOST_RUNS = 400;
  var MOST_SESSIONS = 16;
  var MOST_NODE_STEPS = 1e9;
  var NODE_STEPS_A_CALL = 2e5;
  var LONGEST_ADVANCE = 400;
  var QUESTIONS = ["run", "observe", "open", "advance", "change", "become", "push", "save", "restore", "close"];
  var Answers = class {
    /** @param {import("./module.js").Engine} engine */
    constructor(engine) {
      this.engine = engine;
      this.sessions = /* @__PURE__ */ new Map();
    }
    /**
     * The reply to a question, and what of it is handed over rather than copied; never an exception.
     *
     * @param {any} message
     * @param {(fraction: number) => void} [report]
     * @returns {{reply: object, transfer: ArrayBuffer[]}}
     */
    to(message, report = () => {
    }) {
      const id = message?.id;
      try {
        if (!QUESTIONS.includes(message?.ask))
          throw new Error(`nothing is known of "${String(message?.ask).slice(0, 20)}"; try "run"`);
        const { arrays = [], ...reply } = this[message.ask](message, report);
        return { reply: { id, ...reply }, transfer: [...new Set(arrays.map((array) => array.buffer))] };
      } catch (error) {
        const trapped = error instanceof WebAssembly.RuntimeError;
        if (trapped || error instanceof RangeError) this.#recover();
        const said = trapped ? "the engine stopped: too large a sheet, or numbers beyond it" : String(error?.message ?? error);
        return {
          reply: { id, refused: { field: error?.field ?? null, message: said, anew: Boolean(error?.anew) } },
          transfer: []
        };
      }
    }
    /** After a trap the module's memory cannot be trusted; where sheets are is kept outside of it. */
    #recover() {
      this.engine = this.engine.anew();
      for (const session of this.sessions.values()) session.engine = this.engine;
    }
    run({ scenarios, offsets = [], snapshotInterval = 0 }, report) {
      const recordings = this.#whole(listed(scenarios), offsets, snapshotInterval, report);
      const arrays = recordings.flatMap((r) => [...Object.values(r.channels), r.snapshots, r.platePose, r.snapshotTime]);
      return { told: "ran", recordings, arrays };
    }
    observe({ scenarios, repeats = 1, seed = 0 }, report) {
      if (!Number.isInteger(repeats) || repeats < 1 || repeats > MOST_RUNS)
        throw new Error(`repeats: a whole number from 1 to ${MOST_RUNS}; try 4`);
      const offsets = starts(repeats, seed);
      const many = listed(scenarios).flatMap((scenario) => offsets.map((offset) => ({ scenario, offset })));
      const recordings = this.#whole(
        many.map(({ scenario }) => scenario),
        many.map(({ offset }) => offset),
        0,
        report
      );
      const observations = recordings.map((recording, k) => observe(many[k].scenario, recording));
      return {
        told: "observed",
        observations: scenarios.map((_, k) => observations.slice(k * repeats, (k + 1) * repeats))
      };
    }
    /** Whole runs, in the order of the scenarios. */
    #whole(scenarios, offsets, snapshotInterval, report) {
      if (scenarios.length > MOST_RUNS) throw new Error(`${scenarios.length} runs at once; try at most ${MOST_RUNS}`);
      scenarios.forEach(checkRun);
      const groups = /* @__PURE__ */ new Map();
      scenarios.forEach(({ sheet }, k) => groups.set(latticeOf(sheet), [...groups.get(latticeOf(sheet)) ?? [], k]));
      const recordings = new Array(scenarios.length);
      let done = 0;
      for (const group of groups.values()) {
        group.sort((a, b) => stepsOf(scenarios[a]) - stepsOf(scenarios[b]) || a - b);
        for (let k = 0; k < group.length; k += this.engine.lanes) {
          const block = group.slice(k, k + this.engine.lanes);
          const session = new Session(
            this.engine,
            block.map((i) => scenarios[i]),
            { offsets: block.map((i) => offsets[i]), snapshotInterval }
          );
          const pieces = session.advance({ steps: block.map((i) => stepsOf(scenarios[i])) });
          block.forEach((i, j) => recordings[i] = pieces[j]);
          done += block.length;
          report(done / scenarios.length);
        }
      }
      return recordings;
    }
    open({ scenario, key }) {
      if (!this.sessions.has(key) && this.sessions.size >= MOST_SESSIONS)
        throw new Error(`at most ${MOST_SESSIONS} sheets at once; close one first`);
      this.sessions.set(key, new Session(this.engine, [scenario]));
      return { told: "opened" };
    }
    #session({ key }) {
      const session = this.sessions.get(key);
      if (!session) throw new Error("no such sheet; open it first");
      return session;
    }
    /**
     * Frames evenly through so many seconds, each with what the plate gives and gets, and the samples on the way. Fewer
     * frames where they take too long: `seconds` tells how far the sheet has come.
     */
    advance({ key, seconds, frames = 1, forces = true }) {
      const session = this.#session({ key });
      const [began, from, shown2, pieces] = [performance.now(), session.time(), [], []];
      const steps = Math.max(1, Math.round(seconds / timeStep(session.scenarios[0])));
      const count = Math.max(1, Math.min(Math.round(frames), MOST_FRAMES, steps));
      if (!Number.isFinite(steps) || !Number.isFinite(count))
        throw new Error("no finite time to go on for; try seconds: 0.1");
      for (let k = 0; k < count && !session.diverged(); k++) {
        const own = Math.round(steps * (k + 1) / count) - Math.round(steps * k / count);
        pieces.push(...stepped(session, own, began));
        const frame = { time: session.time(), nodes: session.nodes(), pose: session.platePose() };
        if (forces) {
          const { nodes, plate } = session.forces();
          Object.assign(frame, { forces: nodes, plate: Array.from(plate) });
        }
        if (!session.diverged() && allFinite(frame.nodes)) shown2.push(frame);
        if (performance.now() - began > LONGEST_ADVANCE) break;
      }
      const samples = pieces.length ? joined(pieces) : {};
      const arrays = [
        ...shown2.flatMap(({ nodes, forces: felt }) => felt ? [nodes, felt] : [nodes]),
        ...Object.values(samples)
      ];
      const [gone, wall] = [session.time() - from, performance.now() - began];
      return { told: "frames", frames: shown2, samples, diverged: session.diverged(), seconds: gone, wall, arrays };
    }
    change({ key, motion, ramp }) {
      this.#session({ key }).change(0, motion, ramp);
      return { told: "changed" };
    }
    become({ key, scenario, ramp }) {
      this.#session({ key }).become(0, scenario, ramp);
      return { told: "become" };
    }
    push({ key, ...kick }) {
      this.#session({ key }).push(0, kick);
      return { told: "pushed" };
    }
    save({ key }) {
      return { told: "saved", state: this.#session({ key }).save() };
    }
    restore({ key, state }) {
      this.#session({ key }).restore(state);
      return { told: "restored" };
    }
    close({ key }) {
      this.sessions.delete(key);
      return { told: "closed" };
    }
  };
  var listed = (scenarios) => {
    if (!Array.isArray(scenarios) || !scenarios.length) throw new Error("scenarios: a list of one at least");
    return scenarios;
  };
  var checkRun = (s) => {
    checkScenario(s);
    const nodeSteps = stepsOf(s) * latticeOf(s.sheet).nNodes;
    if (nodeSteps <= MOST_NODE_STEPS) return;
    const most = Number((s.duration * MOST_NODE_STEPS / nodeSteps).toPrecision(2));
    throw new Refusal(
      "duration",
      `${s.duration} s`,
      `at most ${most} s of such a sheet in a page`,
      `${Math.min(4, most)} s`
    );
  };
  var stepped = (session, steps, began) => {
    const most = Math.max(1, Math.floor(NODE_STEPS_A_CALL / session.lattice.nNodes));
    const pieces = [];
    for (let left = steps; left > 0 && !session.diverged(); left -= most) {
      pieces.push(session.advance({ steps: [Math.min(left, most)] })[0].channels);
      if (performance.now() - began > LONGEST_ADVANCE) break;
    }
    return pieces;
  };

  // src/engine/module.js
  var MOST_BYTES = 1 << 30;
  async function loadEngine(source) {
    const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
    return new Engine(module);
  }
  var Engine = class _Engine {
    /** @param {WebAssembly.Module} module */
    constructor(module) {
      this.module = module;
      const { exports } = new WebAssembly.Instance(module, {});
      exports._initialize();
      this.core = exports;
      const [words, parameters, layer, channels] = [0, 1, 2, 3].map((which) => this.#names(which));
      this.names = { words, parameters, layer, channels };
      [this.tallies, this.clocks, this.lanes] = [0, 1, 2].map((which) => exports.plategait_count(which));
      this.channel = Object.fromEntries(channels.map((name, k) => [name, k]));
    }
    /** A fresh instance: after a trap nothing in the old one's memory can be trusted. */
    anew() {
      return new _Engine(this.module);
    }
    #names(which) {
      const length = this.core.plategait_names(which, 0);
      const at = this.core.plategait_allocate(length);
      this.core.plategait_names(which, at);
      const text = String.fromCharCode(...new Uint8Array(this.core.memory.buffer, at, length));
      this.core.plategait_release(at);
      return text.trimEnd().split("\n");
    }
    /**
     * Lay arrays into the module's memory, call it, and give back what is wanted of them, copied.
     *
     * @param {Record<string, number>} counts words that are no address
     * @param {Record<string, ArrayBufferView | {bytes: number}>} arrays by the names of the table's words
     * @param {(table: number, address: Record<string, number>) => void} call
     * @param {(view: <T>(kind: new (...args: any[]) => T, name: string, length: number) => T) => any} take
     */
    with(counts, arrays, call, take) {
      const { core } = this;
      const taken = [];
      const allocate = (bytes) => {
        if (core.memory.buffer.byteLength + bytes > MOST_BYTES)
          throw new Error("more memory than a page may take: fewer nodes, or less at once");
        const at = core.plategait_allocate(Math.max(bytes, 16));
        if (!at) throw new Error("there is no memory for it: fewer nodes, or less at once");
        taken.push(at);
        return at;
      };
      try {
        const address = {};
        for (const [name, array] of Object.entries(arrays)) {
          address[name] = allocate(array.bytes ?? array.byteLength);
          if (array.buffer)
            new Uint8Array(core.memory.buffer, address[name], array.byteLength).set(
              new Uint8Array(array.buffer, array.byteOffset, array.byteLength)
            );
        }
        const table = allocate(4 * this.names.words.length);
        const words = new Int32Array(core.memory.buffer, table, this.names.words.length);
        this.names.words.forEach((name, k) => words[k] = counts[name] ?? address[name] ?? 0);
        call(table, address);
        return take((Kind, name, length) => new Kind(core.memory.buffer, address[name], length).slice());
      } finally {
        for (const at of taken) core.plategait_release(at);
      }
    }
  };

  // src/engine/worker.js
  var answers = null;
  var begun = Promise.resolve();
  var refuse = (id, message) => self.postMessage({ id, refused: { field: "engine", message, anew: false } });
  var begin = (engine) => {
    begun = loadEngine(engine).then(
      (loaded) => answers = new Answers(loaded),
      (error) => refuse(null, `the engine did not start in this browser: ${error?.message ?? error}`)
    );
  };
  var answer = (message) => {
    if (!answers) return refuse(message?.id, "the engine did not start in this browser");
    const report = (fraction) => self.postMessage({ id: message.id, told: "progress", fraction });
    const { reply, transfer } = answers.to(message, report);
    return self.postMessage(reply, transfer);
  };
  self.onmessage = ({ data }) => {
    if (data?.engine) return begin(data.engine);
    begun = begun.then(() => answer(data));
    return void 0;
  };
})();
