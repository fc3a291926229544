// What this page is, and whose work is in it.
import { jsonOf } from "./data.js";
import { make } from "./elements.js";

export function about(footer, facts) {
  const licences = jsonOf("licences") ?? "";
  footer.append(
    make("p", {}, `plategait ${facts.version}. Everything is computed here, by the package's own core compiled for the browser, `
      + "in single precision. Nothing is sent or fetched: the page forbids itself any network."),
    make("p", {}, "Rates are over the last periods as the sheet lives; a spin curve's points are measured over whole runs. "
      + "Keys: space, comma, full stop, r, s, f, k; ? names them."),
    make("details", {}, make("summary", {}, "Licences of what is bundled"), make("pre", { tabIndex: 0 }, licences)),
  );
}
