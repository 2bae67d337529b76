// solve() by Node: in this process, without a worker.
import {readFile} from "node:fs/promises";
import {createRequire} from "node:module";
import {ContactError, questionOf, resultOf} from "./ask.mjs";

const {createSolver, answerTo, hold} = createRequire(import.meta.url)("./solver.js");
const start = async () => createSolver({wasmBinary: await readFile(new URL("./solver.wasm", import.meta.url))});
let solver;

export const solve = async (scene, options) => {
  const {what, question, influence} = questionOf(scene, options);
  const it = await (solver ??= start());
  let reply;
  try {
    for (const [name, bytes] of Object.entries(influence))
      hold(it, name, bytes);
    reply = answerTo(it, what, question);
  } catch (error) { // it has ended, as for lack of memory: the next call starts another one
    solver = undefined;
    throw error;
  }
  return resultOf(reply.body);
};
export {ContactError};
