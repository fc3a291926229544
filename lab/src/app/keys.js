// Keys for the whole page, where nobody is typing.

const KICK = 0.15; // m/s

const HELP = "space: play or pause · , and . : one picture back or on · r: lay down anew · s: slower · f: faster · k: kick";

export function keys(desk) {
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
      "?": () => desk.tell("notice", HELP),
    }[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });
}

const typing = (element) => element.matches?.("input[type='text'], input[type='number'], textarea, select");
