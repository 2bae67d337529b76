// What can be saved, and the commands that do the same.
import {contactsOf} from "../report/answers.js";
import {add, csvOf, download} from "../report/drawing.js";
import {errorOf, valueOf} from "../report/numbers.js";
import {data} from "../report/shown.js";
import {fileOf} from "./answer.js";
import {bodyCommands} from "./bodies.js";
import {kept, scene, sceneNow, start} from "./case.js";
import {element} from "./frames.js";
import {problemShown} from "./problem.js";
import {sweep, sweepCsv, sweepText} from "./sweep.js";

const saving = (what, name) => async () => {
  try {
    download(await fileOf(what, sceneNow()), name);
  } catch (error) {
    problemShown(error.message);
  }
};

const numbersCsv = () => {
  const {quantities: q} = contactsOf(data)[0].group;
  return csvOf([
    ["name", "value", "error", "unit", "meaning"],
    ...Object.keys(q).map(name => [name, valueOf(q, name), errorOf(q, name), q[name].unit, q[name].description])
  ]);
};

const savePicture = async () => {
  /** @type {any[]} */
  const frames = [...document.querySelectorAll(".figure")];
  for (const frame of frames.filter(one => one.data && !one.hidden && one.clientWidth))
    download(await fetchPicture(frame), `${frame.id}.png`);
};
const fetchPicture = async frame => {
  const shownAs = {data: frame.data, layout: {...frame.layout, updatemenus: []}};
  const text =
      await Plotly.toImage(shownAs, {format: "png", width: frame.clientWidth, height: frame.clientHeight, scale: 2});
  return new Blob([Uint8Array.from(atob(text.split(",")[1]), c => c.charCodeAt(0))], {type: "image/png"});
};

const saveSweep = async () => {
  try {
    const text = await (await fileOf("scene", sceneNow())).text();
    download(new Blob([text + sweepText()]), "explored_sweep.toml");
  } catch (error) {
    problemShown(error.message);
  }
};

export const showCommands = () => {
  const changed = Object.keys(scene.changes).length > 0 || scene.text !== start.scene.text;
  const file = (!changed && start.file) || "explored.toml";
  const lines = [
    ...bodyCommands(), `bem_contact ${data.wheels ? "wheelset" : "solve"} ${file} -o explored.h5`,
    "bem_contact report explored.h5 -o explored.html"
  ];
  if (sweep.cases.length)
    lines.push("bem_contact sweep explored_sweep.toml -o explored_sweep.h5");
  const {held} = kept;
  if (held && held.scene.text === scene.text && Object.keys({...held.scene.changes, ...scene.changes})
      .every(key => key === "solver.model" || held.scene.changes[key] === scene.changes[key])) {
    const models = [held.data, data].map(one => contactsOf(one)[0].name);
    if (models[0] !== models[1])
      lines.push(`bem_contact compare ${file} --models ${models.join(",")}`);
  }
  element("commands").textContent = lines.join("\n");
  element("save-sweep").hidden = element("save-sweep-csv").hidden = !sweep.cases.length;
};

export const addSavePanel = parent => {
  add("h2", "Save", parent);
  const row = add("div", "", parent, {className: "row"});
  const button = (text, onclick, more = {}) => add("button", text, row, {type: "button", onclick, ...more});
  button("Scene (TOML)", saving("scene", "explored.toml"), {id: "save-scene"});
  button("Result (HDF5)", saving("result", "explored.h5"), {id: "save-result"});
  button("Page (HTML)", saving("report", "explored.html"), {id: "save-page"});
  button("Numbers (CSV)", () => download(new Blob([numbersCsv()]), "explored.csv"), {id: "save-csv"});
  button("Pictures (PNG)", savePicture, {id: "save-png"});
  button("Sweep (TOML)", saveSweep, {id: "save-sweep", hidden: true});
  button(
      "Sweep (CSV)", () => download(new Blob([sweepCsv()]), "explored_sweep.csv"),
      {id: "save-sweep-csv", hidden: true});
  add("p", `The same by commands. Save the scene in the folder ${start.folder || "."}, where its paths start.`, parent,
      {className: "caption"});
  add("pre", "", parent, {id: "commands"});
};
