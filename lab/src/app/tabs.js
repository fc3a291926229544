// Tabs: one panel of findings at a time, made when it is first opened.
import { identity, make } from "./elements.js";

/**
 * @param {HTMLElement} list with role tablist
 * @param {HTMLElement} panels
 * @param {{title: string, build: (element: HTMLElement) => ({shown?(): void, hidden?(): void}|void)}[]} tabs
 * @returns {{show(index: number): void, current(): number}}
 */
export function tabs(list, panels, given) {
  let current = -1;
  const made = given.map(({ title, build }, index) => {
    const id = identity("tab");
    const tab = make("button", { type: "button", role: "tab", id, "aria-controls": `${id}-panel`, "aria-selected": "false",
      tabIndex: -1, onclick: () => show(index) }, title);
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
