// Two cases side by side.
import {contactsOf} from "../report/answers.js";
import {patchFigure} from "../report/contact_figures.js";
import {add} from "../report/drawing.js";
import {number, ranked, unitText, valueOf, valueText, words} from "../report/numbers.js";
import {data} from "../report/shown.js";
import {addTable} from "../report/tables.js";
import {kept} from "./case.js";
import {drawn, element} from "./frames.js";
import {CONTROLS, toField} from "./moved_keys.js";

const SAME = 1e-12;
const changedText = (key, {changes}) => {
  const control = CONTROLS.find(one => one.key === key), value = changes[key];
  return value === undefined ? "as given" : control ? `${toField(control, value)} ${control.unit}`.trim() : value;
};
const describeChanges = (from, to) => {
  const keys = [...new Set([...Object.keys(from.changes), ...Object.keys(to.changes)])];
  return keys.filter(key => from.changes[key] !== to.changes[key])
    .map(key => `${words(key)} (${key}) ${changedText(key, from)} → ${changedText(key, to)}`).join("; ") || "nothing";
};

export const showHeld = () => {
  const parent = element("held"), [now] = contactsOf(data);
  parent.hidden = !kept.held;
  element("release").hidden = !kept.held;
  if (!kept.held)
    return;
  const [before] = contactsOf(kept.held.data), q = [before, now].map(contact => contact.group.quantities);
  element("differs").textContent = `What differs: ${describeChanges(kept.held.scene, kept.solved)}.`;
  const names = ranked(q[1], "result", "main").filter(name => q.every(one => typeof valueOf(one, name) === "number"));
  const share = (a, b) => Math.abs(a) > SAME ? `${(100 * (b - a) / Math.abs(a)).toFixed(1)} %` : "–";
  element("held-table").replaceChildren();
  addTable("", ["", "held", "now", "difference", "of the held one", "unit"], names.map(name => {
    const [a, b] = q.map(one => valueOf(one, name));
    return [
      words(name), valueText(q[0], name), valueText(q[1], name), number(b - a), share(a, b), unitText(q[1][name].unit)
    ];
  }), {parent: element("held-table"), numbers: [1, 2, 3, 4], id: "differences"});
  [before, now].forEach((contact, k) => {
    const figure = patchFigure(contact, element("arrows").value);
    if (figure)
      drawn(element(["patch-held", "patch-now"][k]), {...figure, height: 340});
  });
};

export const addHeldPanel = parent => {
  add("h2", "Two cases side by side", parent);
  add("p", "", parent, {id: "differs", className: "caption"});
  const both = add("div", "", parent, {className: "side-by-side"});
  for (const [id, title] of [["patch-held", "held"], ["patch-now", "now"]]) {
    const one = add("div", "", both);
    add("p", title, one, {className: "caption"});
    add("div", "", one, {id, className: "figure"});
  }
  add("div", "", parent, {id: "held-table", className: "scroll"});
};
