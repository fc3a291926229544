// Bundles the page's modules into what the package ships: `make lab` calls it, after the engine's module was compiled.
//
//   libraries.js   three.js and uPlot, which change seldom
//   worker.js      the engine's worker
//   page.js        the page itself, readable
import { build } from "esbuild";
import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ?? join(here, "..", "src", "plategait", "lab", "shipped");
const LIBRARIES = { three: "THREE", uplot: "uPlot" };

const common = { bundle: true, format: "iife", target: "es2022", charset: "utf8", legalComments: "none", logLevel: "warning" };

/** Modules of libraries are taken from what libraries.js leaves in the page. */
const fromThePage = {
  name: "libraries of the page",
  setup(builder) {
    builder.onResolve({ filter: /^(three|uplot)$/ }, ({ path }) => ({ path, namespace: "library" }));
    builder.onLoad({ filter: /.*/, namespace: "library" }, ({ path }) => ({
      contents: `module.exports = globalThis.plategaitLibraries.${LIBRARIES[path]}`,
      loader: "js",
    }));
  },
};

await mkdir(out, { recursive: true });
await build({ ...common, minify: true, entryPoints: [join(here, "src", "libraries.js")], outfile: join(out, "libraries.js") });
await build({ ...common, entryPoints: [join(here, "src", "engine", "worker.js")], outfile: join(out, "worker.js") });
await build({ ...common, plugins: [fromThePage], entryPoints: [join(here, "src", "main.js")], outfile: join(out, "page.js") });
await copyFile(join(here, "src", "page.html"), join(out, "page.html"));
const uplot = await readFile(join(here, "node_modules", "uplot", "dist", "uPlot.min.css"), "utf8");
const sheets = await Promise.all(["page.css", "charts/charts.css", "science/science.css"].map((name) => readFile(join(here, "src", name), "utf8")));
await writeFile(join(out, "page.css"), [uplot, ...sheets].join("\n"));
const licences = ["three", "uplot", "smol-toml"].map(async (name) => {
  const { version } = JSON.parse(await readFile(join(here, "node_modules", name, "package.json"), "utf8"));
  const text = await readFile(join(here, "node_modules", name, "LICENSE"), "utf8");
  return `${name} ${version}\n\n${text.trim()}\n`;
});
await writeFile(join(out, "licences.txt"), (await Promise.all(licences)).join("\n" + "-".repeat(80) + "\n\n"));
