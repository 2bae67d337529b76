// A solver inside the page answers, in a worker (bem_contact/browser). reply.js stands here where the program does.
import {add, unpacked} from "../report/drawing.js";

export const NOTE =
    "This page solves by itself, in your browser: nothing is sent to anyone. It writes no HDF5. What needs such " +
    "files, or minutes, is done by the program: results (bem_contact solve SCENE.toml -o R.h5), finite elements of " +
    "other bodies (explore SCENE.toml, where the scene " +
    "names their influence files), tables of forces (table), sweeps on all cores (sweep), creep curves " +
    "(creep-curves), wear, fatigue, both wheels (wheelset).";
export const SILENT = "The solver of this page does not answer (the browser has ended it) Load the page again.";

/// The worker, once it has its solver.
const solver = (async () => {
  const [script, wasm] = await Promise.all(["solver", "wasm"].map(unpacked));
  const worker = new Worker(URL.createObjectURL(new Blob([await script.text()], {type: "text/javascript"})));
  worker.postMessage({wasm: await wasm.arrayBuffer()});
  return worker;
})();

/// The influence files lie beside the page in a script, which is loaded when the solver says that a scene may need
/// them. Without it the solver says what is missing.
let files;
const loadFiles = () => files ??=
    new Promise(done => add("script", "", document.head, {src: "influence.js", onload: done, onerror: done}))
        .then(async () => (await solver).postMessage({files: globalThis.INFLUENCE ?? {}}));

// One question is with the worker. Of those that wait, a newer one of the same window replaces the one before.
const queue = [];
let asking;
const askNext = async () => {
  if (asking || !(asking = queue.shift()))
    return;
  const {what, question, done, failed} = asking, worker = await solver;
  const end = (how, value) => { asking = undefined; how(value); askNext(); };
  worker.onmessage = ({data: {type, body}}) => end(done, new Response(body, {headers: {"Content-Type": type}}));
  worker.onerror = event => { event.preventDefault(); end(failed, new Error(event.message)); };
  worker.postMessage({what, question: JSON.stringify(question)});
};

const REPLACED = {problem: {kind: "replaced", message: "A newer question has replaced this one."}};
const askWorker = (what, question) => new Promise((done, failed) => {
  const before = queue.findIndex(one => one.question.window === question.window);
  if (before >= 0)
    queue.splice(before, 1)[0].done(/** @type {any} */ (Response).json(REPLACED));
  queue.push({what, question, done, failed});
  askNext();
});

/// What is answered to a question, as a Response; throws where nobody answers. `what`: a name of all_asked
/// (answers.hpp).
export const replyTo = async (what, question) => {
  const needs = files || !("text" in question) ? {} : await (await askWorker("needs", question)).json();
  if (needs.problem)
    return /** @type {any} */ (Response).json(needs);
  if (needs.influence)
    await loadFiles();
  const response = await askWorker(what, question);
  if (what !== "report" || !response.headers.get("Content-Type").startsWith("text/html"))
    return response;
  const library = document.getElementById("library").textContent;
  return new Response((await response.text()).replace("@LIBRARY_OF_THE_PAGE@", library), response);
};
