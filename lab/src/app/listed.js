// What a person would turn, in the order in which the page shows it, with how far a slider reaches.
//
// [dotted name, what it is called, least and most of its slider in the unit shown, whether it counts in factors]

const DEG = Math.PI / 180;

export const GROUPS = [
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
      ["motion.ramp", "Smooth start", 0, 1, false],
    ],
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
      ["sheet.pitch", "Distance between nodes", 2, 20, true],
    ],
  },
  {
    title: "Friction and contact",
    controls: [
      ["friction.static", "Static friction μ_s", 0, 2, false],
      ["friction.kinetic", "Kinetic friction μ_k", 0, 2, false],
      ["friction.transition_speed", "Transition speed V", 1, 1000, true],
      ["friction.kinetic_speed_ratio", "Full μ_k at … times V", 1.1, 100, true],
      ["contact.stiffness", "Contact stiffness", 0.5, 200, true],
      ["contact.damping", "Contact damping", 0, 0.1, false],
      ["contact.damping_ramp", "Depth of full damping", 0, 1, false],
    ],
  },
  {
    title: "Place and measurement",
    controls: [
      ["start.x", "Starts at x", -80, 80, false],
      ["start.y", "Starts at y", -80, 80, false],
      ["start.angle", "Starts at angle", -180, 180, false],
      ["gravity", "Gravity", 0, 25, false],
      ["slip_limit", "Failed after slipping", 1, 50, true],
      ["duration", "Duration of a saved run", 0.5, 20, true],
    ],
  },
];

/** Fields that are no single field of a scenario: what they measure. */
export const SHORTHANDS = [
  {
    name: "natural_frequency", unit: "rad/s", display: "pi rad/s", factor: Math.PI, example: "10 pi rad/s", above: 0,
    at_least: null, at_most: null, description: "of the dish mode: bending stiffness follows by its square", choices: null,
  },
  {
    name: "motion.phase", unit: "rad", display: "deg", factor: DEG, example: "90 deg", above: null, at_least: null,
    at_most: null, description: "of the stroke along the bar against the swing about it", choices: null,
  },
];

/** Outlines that one can begin from. */
export const OUTLINES = {
  disk: (size) => ({ shape: "disk", radius: size / 2 }),
  ellipse: (size) => ({ shape: "ellipse", length: size, width: 0.6 * size }),
  rectangle: (size) => ({ shape: "rectangle", length: size, width: 0.6 * size }),
  leaf: (size) => ({ shape: "polygon", corners: leaf(size) }),
  fish: (size) => ({ shape: "polygon", corners: fish(size) }),
  triangle: (size) => ({ shape: "polygon", corners: regular(3, size) }),
  hexagon: (size) => ({ shape: "polygon", corners: regular(6, size) }),
};

/** A regular polygon whose longer side of its bounding box is `size`. */
function regular(n, size) {
  const corners = Array.from({ length: n }, (_, k) => (2 * Math.PI * (k + 0.25)) / n).map((angle) => [Math.cos(angle), Math.sin(angle)]);
  const by = size / Math.max(...sizeOf({ shape: "polygon", corners }));
  return corners.map(([x, y]) => [by * x, by * y]);
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
    [-0.5, 0.22], [-0.38, 0.07], [-0.27, 0.08], [-0.1, 0.19], [0.12, 0.22], [0.32, 0.15], [0.45, 0.06], [0.5, 0],
  ].map(([x, y]) => [size * x, size * y]);
  return [...half, ...half.slice(0, -1).reverse().map(([x, y]) => [x, -y]), [-0.43 * size, 0]];
}

/** Length along the bar and width across it of an outline, m. */
export function sizeOf(outline) {
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
    return [width, rows.length ? (width * rows.length) / rows[0].length : width];
  }
  return [outline.length, outline.width];
}
