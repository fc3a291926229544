// Light or dark: as the system says, or as chosen.

const NEXT = { system: "light", light: "dark", dark: "system" };

/** @param {HTMLButtonElement} control that goes through the three; `changed` is called after each change */
export function theme(control, changed) {
  let now = "system";
  const put = () => {
    if (now === "system") delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = now;
    control.textContent = `Theme: ${now}`;
    changed();
  };
  control.addEventListener("click", () => {
    now = NEXT[now];
    put();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
  put();
}
