// The solver by Node: in this process, without a worker.
import {readFile} from "node:fs/promises";
import {createRequire} from "node:module";

const {createSolver, answerTo, hold} = createRequire(import.meta.url)("./solver.js");
const start = async () => createSolver({wasmBinary: await readFile(new URL("./solver.wasm", import.meta.url))});
let solver;

/// The bytes of its reply to a message of ask.mjs.
export const replyTo = async ({what, question, influence}) => {
  const it = await (solver ??= start());
  try {
    for (const [name, bytes] of Object.entries(influence))
      hold(it, name, bytes);
    return answerTo(it, what, question).body;
  } catch (error) { // it has ended, as for lack of memory: the next call starts another one
    solver = undefined;
    throw error;
  }
};
