// The page: one scene, its answer, and what is drawn of it.
import {certifiedOf, contactsOf, titleOf} from "../report/answers.js";
import {
  ARROWS, cutFigure, extent, isShaped, patchFigure, sectionFigure, solidFigure
} from "../report/contact_figures.js";
import {add, failed, loadLibrary} from "../report/drawing.js";
import {linesOf, ranked, unitText, valueText, words} from "../report/numbers.js";
import {radiusOf, sceneValue} from "../report/scene_words.js";
import {data, report, show} from "../report/shown.js";
import {addPatches, addQuantities, addSix, addTable, warningsOf} from "../report/tables.js";
import {addBodiesPanel} from "./bodies.js";
import {
  ask, change, kept, lastMove, moved, oneOf, scene, sceneNow, start, whenAnswered
} from "./case.js";
import {
  LARGEST_FILE, addChoice, addControl, addProfileField, controls, showControl, unstretch
} from "./controls.js";
import {HEIGHTS, costs, drawn, element} from "./frames.js";
import {addHeldPanel, showHeld} from "./held.js";
import {CONTROLS} from "./moved_keys.js";
import {problemShown} from "./problem.js";
import {addSavePanel, showCommands} from "./save.js";
import {addSweepPanel} from "./sweep.js";
import {NOTE} from "reply";

let resting, drawing = 0;
const REST = 150; // ms without a move, after which figures that are slow to draw follow
const QUICK = 30; // ms that a figure may take to be drawn at each move

const figuresOf = contact => {
  /** @type {[string, any][]} */
  const out = [["patch", patchFigure(contact, element("arrows").value)]];
  if (extent(contact)) {
    if (isShaped(contact)) {
      out.push(["section", sectionFigure(contact)]);
      if (element("in-3d").checked) {
        const solid = solidFigure(contact, radiusOf(contact));
        solid.layout.scene.camera =
            element("solid").layout?.scene.camera ?? solid.layout.scene.camera; // as it was turned
        out.push(["solid", solid]);
      }
    }
    for (const along of ["x", "s"].filter(name => contact[name].length > 1))
      out.push([`cut-${along}`, cutFigure(contact, along)]);
  }
  return out;
};

const drawContact = async all => {
  const [contact] = contactsOf(data), mine = ++drawing;
  const there = new Map(contact ? figuresOf(contact) : []);
  for (const id of Object.keys(HEIGHTS))
    element(id).hidden = !there.get(id);
  for (const [id, figure] of there)
    if (figure && (all || id === "patch" || (costs[id] ?? QUICK) < QUICK)) {
      if (mine !== drawing)
        return;
      await drawn(element(id), {...figure, height: HEIGHTS[id]});
    }
  if (!all) {
    clearTimeout(resting);
    resting = setTimeout(() => drawContact(true), REST);
  } else
    document.body.dataset.drawn = String(drawing);
};

/// On paper stands the answer that is shown, in every figure.
const drawAtOnce = () => {
  const [contact] = contactsOf(data);
  for (const [id, figure] of contact ? figuresOf(contact) : [])
    if (figure)
      drawn(element(id), {...figure, height: HEIGHTS[id]});
};

/// Shows an answer, or what is wrong.
const shown = async (reply, took, asked) => {
  if (reply.problem) {
    element("status").textContent = "Not solved.";
    problemShown(reply.problem.message);
    document.body.dataset.drawn ??= "0";
    return;
  }
  show(oneOf(reply.data));
  kept.solved = asked ?? sceneNow();
  problemShown("");
  showControls();
  showNumbers(took);
  showWheels();
  showHeld();
  showCommands();
  await drawContact(performance.now() - lastMove > REST);
};

const showControls = () => {
  const kind = sceneValue("kind");
  for (const control of controls)
    showControl(control, kind);
  for (const {key, list} of choices)
    list.value = sceneValue(key) || list.value;
  choices.find(one => one.key === "position.side").row.hidden = kind !== "wheel_rail" || Boolean(data.wheels);
  for (const {key, row, field} of profiles) {
    row.hidden = kind !== "wheel_rail";
    if (document.activeElement !== field)
      field.value = sceneValue(key);
  }
  offerSweep(controls.filter(control => !control.row.hidden));
};

const showNumbers = took => {
  const [contact] = contactsOf(data), status = element("status");
  const certified = certifiedOf(contact.group);
  status.className = certified ? "" : "broken";
  status.textContent =
      (certified
           ? "Certified"
           : `NOT certified: ${contact.group.attributes.why_not_certified ?? "a contact condition is violated"}`) +
      `. Model: ${titleOf(contact.name).toLowerCase()}.` +
      (took === undefined ? "" : ` Answered in ${took.toFixed(0)} ms.`);
  const parent = element("answer"), open = element("more")?.open;
  parent.replaceChildren();
  addSix(contact, parent);
  addRemarks(data.remarks, parent);
  const said = new Set(Object.values(data.remarks ?? {}).map(one => one.attributes?.text));
  for (const {text} of warningsOf(contact).filter(one => !said.has(one.text)))
    add("p", `Warning: ${text}`, parent, {className: "warning"});
  const more = add("details", "", parent, {id: "more", open: Boolean(open)});
  add("summary", "All numbers, with their errors", more);
  const fill = () => more.open && more.childElementCount === 1 && addAllNumbers(contact, more);
  more.addEventListener("toggle", fill);
  fill();
};

/// What reading the profiles has said, each with a button that does what it advises.
const addRemarks = (remarks, parent) => {
  for (const {attributes: {text}, keys, values} of Object.values(remarks ?? {}).filter(one => one.attributes)) {
    const line = add("p", `${text} `, parent, {className: "warning remark"});
    const changes =
        Object.fromEntries(keys.text ? linesOf(keys).map((key, k) => [key, JSON.parse(linesOf(values)[k])]) : []);
    if (Object.keys(changes).length)
      add("button", `Take it: ${Object.entries(changes).map(([key, value]) => `${key} = ${value}`).join(", ")}`, line, {
        type: "button",
        onclick: () => change(changes)
      });
  }
};

// --- both wheels of a wheelset ---
const showWheels = () => {
  const both = data.wheels, parent = element("wheels");
  parent.hidden = !both;
  if (!both)
    return;
  element("wheels-right").checked = kept.wheel === "right";
  element("wheels-left").checked = kept.wheel === "left";
  const contacts = ["right", "left"].map(side => contactsOf(both[side])[0]),
        names = ranked(contacts[0].group.quantities, "result", "headline")
                    .filter(name => contacts.every(({group}) => group.quantities[name]));
  element("wheels-table").replaceChildren();
  addTable(
      `The wheelset stands ${
          valueText(data.wheelset, "lateral")} mm to the right. Each wheel counts y to its own side.`,
      ["", "right", "left", "unit"],
      [
        ["model", ...contacts.map(({name}) => titleOf(name)), ""],
        ["", ...contacts.map(({group}) => certifiedOf(group) ? "certified" : "NOT certified"), ""],
        ...names.map(
            name =>
                [words(name), ...contacts.map(({group}) => valueText(group.quantities, name)),
                 unitText(contacts[0].group.quantities[name].unit)])
      ],
      {parent: element("wheels-table"), numbers: [1, 2], id: "both-wheels"});
  contacts.forEach((contact, k) => {
    const figure = patchFigure(contact, element("arrows").value);
    if (figure)
      drawn(element(["patch-right", "patch-left"][k]), {...figure, height: 340});
  });
};

const addWheelsPanel = parent => {
  add("h2", "Both wheels", parent);
  const both = add("div", "", parent, {className: "side-by-side"});
  for (const side of ["right", "left"]) {
    const one = add("div", "", both),
          label = add("label", `${side} wheel: show it above `, add("p", "", one, {className: "caption"}));
    const pick = add("input", "", label, {type: "radio", name: "shown-wheel", id: `wheels-${side}`});
    pick.addEventListener("change", () => {
      kept.wheel = side;
      if (data.wheels)
        shown({data}, undefined, kept.solved);
    });
    add("div", "", one, {id: `patch-${side}`, className: "figure"});
  }
  add("div", "", parent, {id: "wheels-table", className: "scroll"});
};

const addAllNumbers = (contact, more) => {
  const parent = add("div", "", more, {className: "scroll"});
  addQuantities(
      [contact], "The errors are those that the size of the elements is estimated to cause", "quantities", parent);
  addPatches(contact, parent);
};

// --- what is on the page ---
const profileDropped = (key, name, text) => {
  scene.files[name] = text;
  moved(key, name);
};

/// A scene that is dropped, or edited on the page.
const newScene = (text, changes = {}) => {
  Object.assign(scene, {text, changes: {...changes}});
  element("text").value = text;
  for (const control of controls) {
    control.fitted = false;
    unstretch(control);
  }
  ask();
};

const choices = [], profiles = [];
const addControls = form => {
  const group = title => { const set = add("fieldset", "", form); add("legend", title, set); return set; };
  const position = group("Position and load"), motion = group("Friction and creepage"),
        bodies = group("Bodies and model");
  for (const control of CONTROLS)
    addControl(control, /^(motion|layer)/.test(control.key) ? motion : position, moved);
  for (const [key, title, names] of [["rail.profile", "rail", start.rails], ["wheel.profile", "wheel", start.wheels]])
    profiles.push(addProfileField(key, title, names, bodies, moved, profileDropped));
  choices.push(addChoice(
      "solver.model", "model", start.models.map(({name, title}) => [name, name === title ? name : title]), bodies,
      moved));
  choices.push(addChoice("position.side", "side", [["right", "right wheel"], ["left", "left wheel"]], bodies, moved));
  const row = add("div", "", form, {className: "row"});
  const button = (text, id, onclick, more = {}) => add("button", text, row, {type: "button", id, onclick, ...more});
  button("As it began", "reset", () => newScene(start.scene.text, start.scene.changes));
  button("Hold this case", "hold", () => { kept.held = {scene: kept.solved, data}; showHeld(); showCommands(); });
  button("Let it go", "release", () => { kept.held = undefined; showHeld(); showCommands(); }, {hidden: true});
  const fold = add("details", "", form);
  add("summary", "The scene's text: every other key", fold);
  const text = add("textarea", "", fold, {id: "text", spellcheck: false, value: scene.text});
  text.setAttribute("aria-label", "the scene as TOML");
  add("button", "Solve this text", fold, {type: "button", id: "solve-text", onclick: () => newScene(text.value)});
  form.addEventListener("submit", event => event.preventDefault());
};

/// A file that is dropped beside the fields of the profiles: a scene, or a word on where profiles go.
const takeDrops = () => {
  document.addEventListener("dragover", event => event.preventDefault());
  document.addEventListener("drop", async event => {
    event.preventDefault();
    const file = event.dataTransfer.files[0];
    if (!file)
      return;
    if (/\.toml$/i.test(file.name) && file.size < LARGEST_FILE)
      newScene(await file.text());
    else
      problemShown(`'${file.name}' is not taken (a scene ends with .toml; of a profile it is not known whose it is) ` +
                   "Drop a profile on the field of the rail or of the wheel.");
  });
};

const CAPTIONS = {
  solid: "Wheel and rail with the pressure on the patch; the wheel is cut behind it. Turn it with the mouse.",
  patch: "The patch from above. Hatched: slip. Within the thick line: adhesion.",
  section: "The section at the contact, looking along the track.",
  "cut-x": "Shear traction within the bound of friction, along x through the largest pressure.",
  "cut-s": "The same along s."
};
const addFigures = parent => {
  for (const [id, caption] of Object.entries(CAPTIONS)) {
    const block = add("div", "", parent);
    add("div", "", block, {id, className: "figure"}).style.minHeight = `${HEIGHTS[id]}px`;
    const line = add("p", `${caption} `, block, {className: "caption"});
    if (id === "solid") { // without a graphics card it takes seconds
      const box = add("input", "", add("label", "Draw in 3-D ", line), {type: "checkbox", id: "in-3d", checked: true});
      box.addEventListener("change", () => drawContact(true));
    }
    if (id === "patch") {
      const list = add("select", "", add("label", "Arrows: ", line), {id: "arrows"});
      for (const [name, {title}] of Object.entries(ARROWS))
        add("option", title, list, {value: name});
      list.addEventListener("change", () => { drawContact(true); showHeld(); });
    }
  }
};

let offerSweep;
const begin = async () => {
  report.file = start.name;
  whenAnswered(shown);
  document.title = `${start.name}: bem_contact explore`;
  addFigures(element("figures"));
  addControls(element("controls"));
  addWheelsPanel(element("wheels"));
  addHeldPanel(element("held"));
  offerSweep = addSweepPanel(element("sweep"), {shown, then: showCommands});
  addBodiesPanel(element("bodies"));
  addSavePanel(element("save"));
  takeDrops();
  add("p",
      "x is the direction of rolling, y points to the right (left wheel: to the left), z down; s runs along the " +
          "rail's profile, n into the rail. Forces are those on the rail. Figures: plotly.js (MIT licence), " +
          "© Plotly, Inc.",
      element("notes"));
  if (NOTE)
    add("p", NOTE, element("notes"));
  await loadLibrary();
  let wide = innerWidth;
  addEventListener("resize", () => {
    if (innerWidth !== wide && data.p_n) {
      wide = innerWidth;
      drawContact(true);
      showHeld();
    }
  });
  addEventListener("beforeprint", drawAtOnce);
  await ask();
};
begin().catch(failed);
