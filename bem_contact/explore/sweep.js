// Sweeps: one answer after the other over what a slider moves. All are kept, so that a click shows one at once.
import {OUTCOMES, certifiedOf, countsText} from "../report/answers.js";
import {patchesFigure, sweepFigure, withUnit} from "../report/curve_figures.js";
import {add, csvOf} from "../report/drawing.js";
import {VIEWS, errorOf, ranked, valueOf, withErrors} from "../report/numbers.js";
import {answer} from "./answer.js";
import {oneOf, scene, sceneNow} from "./case.js";
import {controls} from "./controls.js";
import {drawn} from "./frames.js";
import {CONTROLS, toField, toKey} from "./moved_keys.js";

export const sweep = {key: "", cases: [], running: false}; // each case: {value, reply}

const outcomeOf = ({data: result, problem}) => problem            ? problem.kind
    : Object.values(result.wheels ?? {result}).every(certifiedOf) ? "certified"
                                                                  : "not certified";
const reasonOf = ({data: result, problem}) => problem
    ? problem.message
    : Object.values(result.wheels ?? {result}).map(one => one.attributes.why_not_certified).filter(Boolean).join("; ");

/// The answers as one table, as a file of a sweep has it (curve_figures.js).
const sweepData = () => {
  const control = CONTROLS.find(one => one.key === sweep.key), good = sweep.cases.find(one => one.reply.data),
        shownOf = one => oneOf(one.reply.data);
  if (!good)
    return undefined;
  const results = sweep.cases.map(shownOf), each = of => results.map(result => (result && of(result)) ?? null);
  /** @type {Record<string, any>} */
  const out = {
    [sweep.key]: {
      values: sweep.cases.map(one => toField(control, one.value)),
      unit: control.unit || "1",
      role: "swept"
    },
    status: {values: sweep.cases.map(one => OUTCOMES.indexOf(outcomeOf(one.reply))), choices: OUTCOMES},
    patches: {case: {values: []}}
  };
  for (const name of ranked(shownOf(good).quantities, "result", "main")) {
    const {unit, description} = shownOf(good).quantities[name];
    const values = each(({quantities}) => valueOf(quantities, name)),
          errors = each(({quantities}) => errorOf(quantities, name));
    out[name] = {values, errors, unit, description};
  }
  results.forEach((result, i) => {
    const count = result?.patches?.Fn?.values.length ?? 0;
    for (const [name, column] of count ? Object.entries(result.patches) : [])
      (out.patches[name] ??= {...column, values: []}).values.push(...column.values);
    out.patches.case.values.push(...Array(count).fill(i));
  });
  out.patches.patch = {values: out.patches.case.values.map((at, k, all) => k - all.indexOf(at))};
  return out;
};

/// Figures of the sweep; a click on a mark shows that case.
const drawSweep = async (parent, shown) => {
  const table = sweepData();
  if (!table)
    return;
  /** @type {[string, any][]} */
  const wanted = VIEWS.sweep.figures.filter(names => names.every(name => table[name]))
                     .map(names => [`sweep-${names.join("-")}`, sweepFigure(table, [sweep.key], sweep.key, names)]);
  if (table.patches.y?.values.some(y => y !== null))
    wanted.unshift(["sweep-patches", patchesFigure(table, sweep.key)]);
  for (const [id, figure] of wanted) {
    const frame = document.getElementById(id) ?? add("div", "", parent, {id, className: "figure"});
    await drawn(frame, {...figure, height: 300});
    frame.removeAllListeners?.("plotly_click");
    frame.on("plotly_click", event => showCase(event.points[0].customdata, shown));
  }
};

/// Shows a case of the sweep as if its slider stood there.
const showCase = (i, shown) => {
  const one = sweep.cases[i];
  scene.changes[sweep.key] = one.value;
  /** @type {HTMLElement} */ (document.activeElement)?.blur();
  shown(one.reply);
};

export const sweepCsv = () => {
  const {status, patches, ...table} = sweepData(), columns = Object.entries(table).flatMap(withErrors);
  return csvOf([
    [...columns.map(([name, column]) => withUnit(name, column)), "status", "reason"],
    ...sweep.cases.map(({reply}, i) => [...columns.map(([, {values}]) => values[i]), outcomeOf(reply), reasonOf(reply)])
  ]);
};

/// The sweep as a table of a scene.
export const sweepText = () => {
  const values = sweep.cases.map(one => one.value);
  return `\n[sweep]\n${sweep.key} = [${values.join(", ")}]\n`;
};

/// The panel: which key, from where to where, how many; then the figures. `shown(reply)` shows an answer; `then()`
/// follows a sweep.
export const addSweepPanel = (parent, {shown, then}) => {
  add("h2", "Sweep", parent);
  const row = add("div", "", parent, {className: "row"}),
        field = (text, more) => add("input", "", add("label", text, row), more);
  const keys = add("select", "", add("label", "over ", row), {id: "sweep-key"});
  const from = field("from ", {type: "number", step: "any", id: "sweep-from"}),
        to = field("to ", {type: "number", step: "any", id: "sweep-to"});
  const count = field("cases ", {type: "number", min: 2, max: 201, value: 17, id: "sweep-count"});
  const run = add("button", "Sweep", row, {type: "button", id: "sweep-run"}),
        bar = add("progress", "", row, {hidden: true});
  const note = add("p", "A click on a mark shows its patch.", parent, {className: "caption", hidden: true});
  const figures = add("div", "", parent, {className: "side-by-side"});
  const ends = () => {
    const control = controls.find(one => one.key === keys.value);
    [from.value, to.value] = [control.slider.min, control.slider.max];
  };
  keys.addEventListener("change", ends);
  run.addEventListener("click", async () => {
    if (sweep.running)
      return void (sweep.running = false);
    const control = CONTROLS.find(one => one.key === keys.value),
          n = Math.min(201, Math.max(2, Math.round(Number(count.value)) || 2));
    const values = Array.from(
        {length: n},
        (_, k) => toKey(control, Number(from.value) + (Number(to.value) - Number(from.value)) * k / (n - 1)));
    Object.assign(sweep, {key: keys.value, cases: [], running: true});
    run.textContent = "Stop";
    Object.assign(bar, {hidden: false, max: n, value: 0});
    const asked = sceneNow();
    for (const value of values) {
      const reply = await answer({...asked, changes: {...asked.changes, [sweep.key]: value}}, "sweep");
      if (!sweep.running)
        break;
      sweep.cases.push({value, reply});
      bar.value = sweep.cases.length;
    }
    sweep.running = false;
    run.textContent = "Sweep";
    bar.hidden = true;
    const outcomes = sweep.cases.map(one => outcomeOf(one.reply)),
          bad = outcomes.findIndex(outcome => outcome !== "certified");
    note.hidden = false;
    note.textContent = `Of ${n} cases ${
                           countsText(
                               outcome => outcome === "missing" ? n - outcomes.length
                                                                : outcomes.filter(one => one === outcome).length)}. ` +
        "A click on a mark shows its patch." +
        (bad >= 0 ? ` The first that is ${outcomes[bad]}: ${reasonOf(sweep.cases[bad].reply)}` : "");
    await drawSweep(figures, shown);
    then();
  });
  return shown => { // the keys that have a slider now
    const offered = shown.filter(one => !one.inverse); // a curve's radius has no middle
    if (offered.map(one => one.key).join() === [...keys.options].map(one => one.value).join())
      return;
    keys.replaceChildren();
    for (const one of offered)
      add("option", one.title, keys, {value: one.key});
    ends();
  };
};
