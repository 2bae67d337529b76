// Influence functions of the bodies on the screen. The program computes them beside everything else; a page without it
// names the commands.
import {add, download} from "../report/drawing.js";
import {sceneValue} from "../report/scene_words.js";
import {asked} from "./answer.js";
import {ask, scene, sceneNow} from "./case.js";

const LOOK_AGAIN = 300; // ms between two looks at how far they are

const bodyTexts = {}; // by name: body files that were asked for on this page

const jsonOf = async (what, scene, lane) => {
  const reply = await (await asked(what, scene, lane)).json();
  if (reply.problem)
    throw new Error(reply.problem.message);
  return reply;
};

const commandsOfBodies = names => names.flatMap(
    name => [`mesh_body ${name}.toml -o ${name}.msh`, `fem_influence ${name}.toml ${name}.msh -o ${name}.h5`]);

/// Those of them whose influence files the scene on the screen names.
const namedBodies = () => ["rail", "wheel"].flatMap(side =>
  Object.keys(bodyTexts).filter(name => sceneValue(`${side}.influence`) === `${name}.h5`));
export const bodyCommands = () => commandsOfBodies(namedBodies());

/// The panel: a button that computes, one that saves the body files, and the commands that do the same.
export const addBodiesPanel = parent => {
  add("h2", "Finite elements", parent);
  add("p",
      "The model fem needs influence functions of both bodies where they touch. They are computed for the contact on " +
          "the screen, coarsely, in " +
          "a minute or so. If a slider moves the contact beyond their strips, compute them again.",
      parent, {className: "caption"});
  const row = add("div", "", parent, {className: "row"});
  const run = add("button", "Compute influence functions", row, {type: "button", id: "compute"});
  const save = add("button", "Bodies (TOML)", row, {type: "button", id: "save-bodies"});
  const bar = add("progress", "", row, {id: "compute-bar", max: 1, hidden: true}),
        note = add("span", "", row, {id: "compute-note"});
  note.setAttribute("role", "status");
  const commands = add("pre", "", parent, {id: "body-commands", hidden: true});
  let running = false;

  const show = state => {
    running = state.stage === "running";
    run.textContent = running ? "Cancel" : "Compute influence functions";
    run.disabled = Boolean(state.missing);
    Object.assign(bar, {hidden: !running, value: state.share});
    note.textContent = state.missing || {
      running: `${state.what}, ${Math.floor(10 * state.share)} tenths done`,
      failed: state.what,
      done: "The influence functions are there.",
      cancelled: "Cancelled."
    }[state.stage] ||
        "";
  };
  const follow = async () => {
    for (;;) {
      const state = await jsonOf("computing", {}, "computing");
      show(state);
      if (state.stage !== "running")
        return state;
      await new Promise(later => setTimeout(later, LOOK_AGAIN));
    }
  };
  const askBodies = async () => {
    const {bodies} = await jsonOf("bodies", sceneNow(), "bodies");
    for (const {name, text} of bodies)
      bodyTexts[name] = text;
    commands.hidden = false;
    commands.textContent = commandsOfBodies(bodies.map(body => body.name)).join("\n");
    return bodies;
  };
  const compute = async () => {
    await askBodies();
    show(await jsonOf("compute", sceneNow(), "bodies"));
    const state = await follow();
    if (state.stage !== "done")
      return;
    Object.assign(scene.changes, state.changes, {"solver.model": "fem"});
    ask();
  };
  const saying = work => async () => {
    try {
      await work();
    } catch (error) {
      note.textContent = error.message;
    }
  };
  run.addEventListener("click", saying(() => running ? jsonOf("cancel", {}, "computing") : compute()));
  save.addEventListener("click", saying(async () => {
    const names = (await askBodies()).map(body => body.name); // of this contact, and of the one they were computed for
    for (const name of new Set([...names, ...namedBodies()]))
      if (bodyTexts[name])
        download(new Blob([bodyTexts[name]]), `${name}.toml`);
  }));
  return saying(follow)();
};
