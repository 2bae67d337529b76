// solve() in a page: in a worker, so that the page goes on meanwhile. One question is with the worker at a time.
import {ContactError, questionOf, resultOf, solvedAs} from "./ask.mjs";

const fetched = async file => {
  const response = await fetch(file);
  if (!response.ok)
    throw new Error(`${file} cannot be loaded (HTTP ${response.status}) Put the package's files beside each other.`);
  return response.arrayBuffer();
};

const start = async () => {
  const [script, wasm] = await Promise.all(
      [fetched(new URL("./solver.js", import.meta.url)), fetched(new URL("./solver.wasm", import.meta.url))]);
  // From a text: a page may not start a worker of another server.
  const worker = new Worker(URL.createObjectURL(new Blob([script], {type: "text/javascript"})));
  worker.postMessage({wasm}, [wasm]);
  return worker;
};

let solver, before = Promise.resolve();
const ask = async message => {
  const worker = await (solver ??= start().catch(error => { solver = undefined; throw error; }));
  return new Promise((done, failed) => {
    worker.onmessage = ({data}) => done(data.body);
    worker.onerror = event => { // it has ended: the next call starts another one
      event.preventDefault();
      worker.terminate();
      solver = undefined;
      failed(new Error(event.message));
    };
    worker.postMessage(message);
  });
};

export const solve = async (scene, options) => {
  const message = questionOf(solvedAs(options), scene, options);
  const reply = before.then(() => ask(message));
  before = reply.catch(() => {});
  return resultOf(await reply);
};
export {ContactError};
