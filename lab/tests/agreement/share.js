// What the page gives away and takes back: for each scenario on standard input its TOML, what that TOML is read as, and
// what its link is read as.
import { readFileSync } from "node:fs";
import { fragmentOf, scenarioOf } from "../../src/app/share.js";
import { scenarioFrom, tomlOf } from "../../src/app/toml.js";

const { facts, scenarios, files, links } = JSON.parse(readFileSync(0, "utf8"));
const base = facts.presets.cheese.scenario;
const tried = (act) => {
  try {
    return act();
  } catch (error) {
    return { refused: error.message };
  }
};
process.stdout.write(JSON.stringify({
  shared: scenarios.map((scenario) => {
    const toml = tomlOf(scenario, facts.version);
    return { toml, back: tried(() => scenarioFrom(toml, base, facts)), linked: tried(() => scenarioOf(fragmentOf(scenario, facts), facts)) };
  }),
  files: files.map((text) => tried(() => scenarioFrom(text, base, facts))),
  links: links.map((text) => tried(() => scenarioOf(text, facts))),
}));
