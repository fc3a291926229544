// The engine's worker: answers one question after the other; what it cannot do is a refusal and never its end.
import { Answers } from "./answers.js";
import { loadEngine } from "./module.js";

let answers = null;
let begun = Promise.resolve();

const refuse = (id, message) => self.postMessage({ id, refused: { field: "engine", message, anew: false } });

const begin = (engine) => {
  begun = loadEngine(engine).then(
    (loaded) => (answers = new Answers(loaded)),
    (error) => refuse(null, `the engine did not start in this browser: ${error?.message ?? error}`),
  );
};

const answer = (message) => {
  if (!answers) return refuse(message?.id, "the engine did not start in this browser");
  const report = (fraction) => self.postMessage({ id: message.id, told: "progress", fraction });
  const { reply, transfer } = answers.to(message, report);
  return self.postMessage(reply, transfer);
};

self.onmessage = ({ data }) => {
  if (data?.engine) return begin(data.engine);
  begun = begun.then(() => answer(data));
  return undefined;
};
