// Time: play, single steps, speed, and a track to scrub through what was shown.
import { button, make } from "./elements.js";

const SPEEDS = [1, 1 / 2, 1 / 5, 1 / 10, 1 / 20, 1 / 50, 1 / 100, 1 / 200];
const said = (speed) => (speed === 1 ? "real time" : `1/${Math.round(1 / speed)}`);

/** Buttons and track; `desk.lives()` are the sheets, which share one clock's controls. */
export function transport(bar, desk) {
  const play = button("Pause", () => desk.play(!desk.playing), { class: "play" });
  const back = button("◀", () => desk.step(-1), { "aria-label": "One picture back", title: "One picture back (,)" });
  const on = button("▶", () => desk.step(1), { "aria-label": "One picture forward", title: "One picture forward (.)" });
  const anew = button("Lay down anew", () => desk.restart(), { title: "Begin at rest again (r)" });
  const speed = make("input", { type: "range", min: 0, max: SPEEDS.length - 1, step: 1, value: 0, id: "speed",
    oninput: () => desk.setSpeed(SPEEDS[Number(speed.value)]) });
  const speedText = make("output", { for: "speed" });
  const track = make("input", { type: "range", min: 0, max: 1000, step: 1, value: 1000, "aria-label": "Time, to scrub",
    oninput: () => desk.seek(Number(track.value) / 1000) });
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
        const share = now.last > now.first ? (now.clock - now.first) / (now.last - now.first) : 1;
        track.value = String(Math.round(1000 * share));
      }
      track.setAttribute("aria-valuetext", text);
    },
  };
}
