// The page of an answer: first what was found, with one picture, what to mind and what to do next; then figures; then
// tables, folded; last what was asked. Then the figures are drawn.
import {rows} from "./contact_figures.js";
import {
  add, addFigure, addFirstFigure, draw, failed, figures, followWidth, idPrefix, inside, into, isFirst, loadLibrary,
  page, prefixIds
} from "./drawing.js";
import {linesOf, number, sentenceText, unitText, valueOf} from "./numbers.js";
import {COMPARISON, RESULT, WHEELSET} from "./page_contact.js";
import {
  CONTACT_WEAR, GOOD_JACOBIAN, INFLUENCE_FILE, MESH, PROFILE, SECTIONS, TABLE, USABLE_JACOBIAN, addDownloads,
  worstJacobian
} from "./page_files.js";
import {FATIGUE, SHAKEDOWN, STRESSES} from "./page_strength.js";
import {CONICITY, CONICITY_MAP, CREEP_CURVES, FIT, SWEEP, WEAR} from "./page_uses.js";
import {sceneInWords} from "./scene_words.js";
import {data, report, show} from "./shown.js";
import {addTable, warningsFound} from "./tables.js";

const whole = JSON.parse(document.getElementById("data").textContent);
const read = () => {
  const {attributes: {kind, file}, parts = {}, steps = {}, scene_values} = whole;
  const stepsOf = ([step, {rail, wheel}]) => ({step: Number(step), rail: rows(rail), wheel: rows(wheel)});
  Object.assign(report, {kind, file, steps: Object.entries(steps).map(stepsOf)});
  show({...whole.data, scene_values});
  for (const [name, part] of Object.entries(parts))
    data.parts[name].scene_values = part.scene_values;
  if (data.profiles)
    data.profiles = Object.values(data.profiles).map(({attributes: {name}, y, z, curvature}) =>
      ({name, y: y.values, z: z.values, curvature: curvature.values}));
};

/// What each kind of answer shows. `picture`: [id, caption, figure] of what stands first; `warnings`: [title, contact]
/// of those that may have some; `large`: numbers in large figures; `sure`: how far it is certified. All but `picture`
/// may lack.
const ANSWERS = {
  result: RESULT,
  comparison: COMPARISON,
  wheelset: WHEELSET,
  sweep: SWEEP,
  "creep curves": CREEP_CURVES,
  fit: FIT,
  conicity: CONICITY,
  "conicity map": CONICITY_MAP,
  wear: WEAR,
  "wear of one contact": CONTACT_WEAR,
  fatigue: FATIGUE,
  stresses: STRESSES,
  shakedown: SHAKEDOWN,
  table: TABLE,
  profile: PROFILE,
  sections: SECTIONS,
  "influence file": INFLUENCE_FILE,
  mesh: MESH
};
const TITLE_OF = {
  result: "Contact of wheel and rail",
  comparison: "Comparison of models",
  sweep: "Sweep",
  "creep curves": "Creep curves",
  fit: "Fit to measured forces",
  conicity: "Conicity",
  wheelset: "Wheelset",
  wear: "Wear",
  profile: "Profile",
  sections: "Sections",
  study: "Study",
  fatigue: "Fatigue",
  stresses: "Stresses inside a body",
  shakedown: "Shakedown",
  table: "Table of forces",
  "conicity map": "Conicities",
  "wear of one contact": "Wear",
  "influence file": "Influence functions",
  mesh: "Mesh of a body"
};

const folded = (title, id, fill, more = {}) => {
  const fold = add("details", "", into, {id: idPrefix + id, ...more});
  add("summary", title, fold);
  inside(fold, fill);
  if (fold.childElementCount < 2)
    fold.remove();
};

/// Whether the page has the words of a command: a profile, or sections.
const hasOwnWords = () => ["profile", "sections"].includes(report.kind);

/// What was found, or what the file is.
const addFound = found => {
  const list = add("ul", "", into, {id: `${idPrefix}found`, className: "found"});
  for (const sentence of found.length ? found : [inWords()].filter(() => !hasOwnWords()))
    add("li", sentenceText(sentence), list);
};

/// The most important warning, and the others behind a click.
const addFirstWarning = texts => {
  if (!texts.length)
    return;
  const block = add("div", "", into, {id: `${idPrefix}warnings`});
  const [first, ...others] = texts.map(sentenceText);
  add("p", first, block, {className: "warning"});
  if (!others.length)
    return;
  const fold = add("details", "", block);
  add("summary", `${others.length} more warning${others.length > 1 ? "s" : ""}`, fold);
  for (const text of others)
    add("p", text, fold, {className: "warning"});
};

const addNext = next => {
  if (!next.length)
    return;
  const block = add("div", "", into, {id: `${idPrefix}next`});
  add("h2", "What next?", block);
  const list = add("ul", "", block);
  for (const {attributes: {asks, command}} of next) {
    const line = add("li", command ? `${asks} ` : asks, list);
    if (command)
      add("code", command, line);
  }
};

/// What fills the first screen.
const addFirst = ({found, next}, warnings, picture) => {
  const first = add("section", "", page, {id: "first", className: picture ? "first" : ""});
  inside(add("div", "", first, {className: "said"}), () => {
    addFound(found);
    addFirstWarning(warnings);
    addNext(next);
  });
  if (!picture)
    return;
  inside(first, () => addFirstFigure(...picture));
};

const textsOf = (group, name) => group[name]?.text ? linesOf(group[name]).filter(Boolean) : [];
const foundIn = group => ({found: textsOf(group, "found"), next: Object.values(group.next ?? {})});

/// Figures and numbers of an answer, below what stands first.
const addRest = (answer, where = "") => {
  answer.large?.();
  if (answer.figures)
    inside(add("div", "", into, {className: `side-by-side ${where}`.trim()}), answer.figures);
  answer.sure?.();
  if (answer.tables)
    folded("All numbers", "numbers", answer.tables);
};

const partsOf = study =>
    Object.entries(study.parts).sort(([, a], [, b]) => a.study_order.values[0] - b.study_order.values[0]);
/// Does `action` as if a part of a study were the whole file.
const ofPart = (name, part, action) => {
  const to = (shown, kind, prefix) => {
    show(shown);
    report.kind = kind;
    prefixIds(prefix);
  };
  const study = data;
  to(part, part.attributes.study_page, `${name}-`);
  const out = action(ANSWERS[report.kind]);
  to(study, "study", "");
  return out;
};
const shownParts = () => partsOf(data).filter(([, part]) => ANSWERS[part.attributes.study_page]);

const studyWarnings = () => {
  const known = new Map(); // of several parts that say the same the first one
  for (const [name, part] of shownParts())
    for (const {kind, text} of ofPart(name, part, answer => warningsFound(answer.warnings?.() ?? [])))
      known.set(kind, known.get(kind) ?? text);
  return [...known.values()];
};

/// How each part went, and the numbers that people look at first.
const addStudyTables = () => {
  const names = linesOf(data.headline_names), units = linesOf(data.headline_units),
        meanings = linesOf(data.headline_meanings);
  const {value, element_error: elements, input_spread: inputs} = data.headline,
                                                       drawn = inputs.values.some(v => v !== null);
  const spread = v => v === null ? "–" : number(Number(v.toPrecision(2)));
  addTable(
      "Numbers, each with its error by the size of the elements" +
          (drawn ? " and its standard deviation by the inputs" : ""),
      ["part", "number", "value ± elements", ...(drawn ? ["inputs"] : []), "unit", ""],
      linesOf(data.headline_parts)
          .slice(0, value.values.length)
          .map(
              (part, k) =>
                  [part, names[k], number(value.values[k], elements.values[k]),
                   ...(drawn ? [spread(inputs.values[k])] : []), units[k] === "1" ? "" : unitText(units[k]),
                   meanings[k]]),
      {numbers: drawn ? [2, 3] : [2], id: "headline", wide: true});
  const states = data.states ? linesOf(data.states) : [];
  if (states.length)
    addTable(
        "The same for other states of the surfaces (layer.state)", ["part", "number", "as given", ...states, "unit"],
        linesOf(data.headline_parts)
            .slice(0, value.values.length)
            .map((part, k) => [part, names[k], number(value.values[k], elements.values[k]),
                               ...states.map((_, i) => number(data.headline_states.values[k * states.length + i],
                                                              elements.values[k])),
                               units[k] === "1" ? "" : unitText(units[k])]),
        {numbers: [2, ...states.map((_, i) => 3 + i)], id: "states", wide: true});
  addTable(
      "Parts", ["part", "", "s", "what went wrong"],
      partsOf(data).map(
          ([name, part]) =>
              [`${name}: ${part.attributes.study_title}`, part.attributes.study_status,
               part.study_seconds.values[0].toFixed(1), part.study_errors.text]),
      {numbers: [2], id: "parts"});
};

const addTaken = () => addTable(
    "What all answers rest on", ["key", "value", "unit", ""],
    Object.entries(data.taken).map(([
                                     key, {attributes: {value, unit, given}}
                                   ]) => [key, value, unitText(unit), given === 1 ? "given" : "by default"]),
    {numbers: [], id: "taken"});

const addPart = ([name, part]) => {
  const {study_title: title, study_status: status, study_about: about} = part.attributes;
  add("h2", `${title}: ${status}`);
  if (about)
    add("p", `${about[0].toUpperCase()}${about.slice(1)}.`, into, {className: "caption"});
  if (part.study_errors.text)
    add("p", part.study_errors.text);
  if (!ANSWERS[part.attributes.study_page])
    return;
  ofPart(name, part, answer => {
    addFound(foundIn(whole.parts?.[name] ?? {}).found);
    const picture = answer.picture();
    if (picture && !isFirst(picture[0]))
      addFigure(...picture);
    addRest(answer, "screen-only"); // paper has the picture of each part
  });
};

const STUDY = {
  picture: () => {
    for (const [name, part] of shownParts()) {
      const picture = ofPart(name, part, answer => answer.picture());
      if (picture)
        return [`${name}-${picture[0]}`, ...picture.slice(1)];
    }
    return undefined;
  },
  rest: () => {
    folded("All numbers, and how each part went", "numbers", addStudyTables);
    const parts = add("div", "", into, {className: "parts"});
    for (const part of partsOf(data))
      inside(add("section", "", parts, {className: "part"}), () => addPart(part));
  }};

/// What a page says of the question.
const inWords = () => {
  if (report.kind === "conicity map")
    return `Rigid wheelsets with ${linesOf(data.wheels).length} profiles of wheels on ${
               linesOf(data.rails).length} of rails. The equivalent conicity (EN 15302) is the slope ` +
        `of the cone with the same wavelength, for an amplitude of ${number(valueOf(data, "amplitude"))} mm.` +
        (!data.noise ? ""
                     : ` The points of the profiles scatter by ${number(valueOf(data, "noise"))} mm in ${
                           valueOf(data, "all_draws")} draws.`);
  if (report.kind === "influence file")
    return `How the surface of ${
        data.attributes.body} moves under unit tractions on its strip, computed by finite elements (${
        data.attributes.method}).`;
  if (report.kind === "mesh") {
    const worst = worstJacobian();
    return `A section in ${data.quads.shape[0]} quadrilaterals. Their quality is ${
               worst >= GOOD_JACOBIAN         ? "good"
                   : worst >= USABLE_JACOBIAN ? "usable"
                                              : "poor"}: the worst scaled ` +
        `Jacobian is ${worst.toFixed(2)}; a rectangle has 1.`;
  }
  if (report.kind === "stresses" || (report.kind === "shakedown" && !data.scene_text))
    return `${data.attributes.in_words[0].toUpperCase()}${data.attributes.in_words.slice(1)}.`;
  return report.kind === "study" ? "One scene, and an answer to each of its tables." : sceneInWords().join(" ");
};

/// What was asked, with what was taken by default.
const addQuestion = () => {
  if (!hasOwnWords())
    add("p", inWords(), into, {id: "words"});
  if (data.taken)
    addTaken();
  for (const [name, title] of [
           ["scene_text", "The scene as it was given"], ["scene_with_defaults", "The scene with every key"]])
    if (data[name])
      folded(title, name, () => add("pre", data[name].text));
};

const addNotes = program => add("p",
  `${program}. x is the direction of rolling, y points to the right (left wheel: to the left), z down; s runs along ` +
  "the rail's profile, n into the rail. Forces are those on the rail. Figures: plotly.js (MIT licence), " +
  "© Plotly, Inc.",
  document.getElementById("notes"));

const begin = async () => {
  read();
  document.title = `${report.file}: bem_contact report`;
  const title = TITLE_OF[report.kind], answer = report.kind === "study" ? STUDY : ANSWERS[report.kind];
  add("h1", `${title}: ${report.file}`);
  const ownWarnings = () => warningsFound(answer.warnings?.() ?? []).map(one => one.text);
  const warned = report.kind === "study" ? studyWarnings() : ownWarnings();
  addFirst(foundIn(whole), warned, answer.picture());
  if (hasOwnWords())
    add("pre", data.attributes.words, page, {id: "words"});
  if (report.kind === "study")
    answer.rest();
  else
    addRest(answer);
  addDownloads();
  folded("What was asked", "question", addQuestion);
  addNotes(data.attributes?.program ?? "bem_contact");
  await loadLibrary();
  followWidth();
  for (const one of figures)
    if (!one[0].firstChild.data) // a printer may have been faster
      await draw(one);
  document.body.dataset.drawn = String(figures.length);
};
begin().catch(failed);
