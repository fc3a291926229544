// The engine's worker: answers one question after the other; what it cannot do is a refusal and never its end.
import { loadEngine } from "./module.js";
import { Answers } from "./answers.js";

let answers = null;
let begun = Promise.resolve();

self.onmessage = ({ data }) => {
  if (data?.engine) {
    begun = loadEngine(data.engine).then((engine) => (answers = new Answers(engine)));
    begun.catch((error) => self.postMessage({ id: null, refused: { field: "engine", message: String(error?.message ?? error) } }));
    return;
  }
  begun = begun.catch(() => {}).then(() => {
    if (!answers) return self.postMessage({ id: data?.id, refused: { field: "engine", message: "the engine did not start in this browser" } });
    const report = (fraction) => self.postMessage({ id: data.id, told: "progress", fraction });
    const { reply, transfer } = answers.to(data, report);
    return self.postMessage(reply, transfer);
  });
};
