// The scene on the screen, and its answer: one solution in flight, the last position wins.
import {answer} from "./answer.js";

export const start = JSON.parse(document.getElementById("data").textContent);
const sceneOf = ({text, changes, files}) => ({text, changes: {...changes}, files: {...files}});
export const scene = sceneOf(start.scene);
export const sceneNow = () => sceneOf(scene);

/// `solved`: the scene of the last answer; `held`: {scene, data} of the case beside it; `wheel`: of a wheelset, whose
/// figures and numbers are shown.
export const kept = {solved: undefined, held: undefined, wheel: "right"};
/// What is shown of a reply's data: one contact; of a wheelset one of its wheels.
export const oneOf = found => found?.wheels ? {...found, ...found.wheels[kept.wheel]} : found;

/** @type {(...reply: any[]) => Promise<void>} */
let shown = async () => {}; // (reply, ms that it took, the scene that was asked)
export const whenAnswered = action => { shown = action; };

const PATIENCE = 400; // ms after which a newer position replaces a solution that is under way
let turn = 0, since, waiting;

export const ask = async () => {
  clearTimeout(waiting);
  const left = since === undefined ? 0 : since + PATIENCE - performance.now();
  if (left > 0)
    return void (waiting = setTimeout(ask, left));
  waiting = undefined;
  const mine = ++turn, asked = sceneNow();
  since = performance.now();
  const reply = await answer(asked);
  if (mine !== turn || reply.problem?.kind === "replaced")
    return;
  const took = performance.now() - since;
  since = undefined;
  await shown(reply, took, asked);
  if (waiting !== undefined)
    ask();
};

export let lastMove = 0; // by performance.now()
export let lastKey = ""; // that was moved
export const change = changes => {
  Object.assign(scene.changes, changes);
  lastMove = performance.now();
  ask();
};
export const moved = (key, value) => {
  lastKey = key;
  change({[key]: value});
};
