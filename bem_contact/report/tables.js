// Tables, certificates and warnings of a page. They need no library.
import {certifiedOf, shortOf} from "./answers.js";
import {withUnit} from "./curve_figures.js";
import {add, idPrefix, into} from "./drawing.js";
import {
  LEAST_NUMBER, entryText, inDegrees, largestOf, number, ranked, unitText, valueOf, valueText, words
} from "./numbers.js";
import {data} from "./shown.js";

/** @typedef {{parent?: HTMLElement, numbers?: number[], id?: string, wide?: boolean | string}} Looks */
/// A table; the cells numbered `numbers` from the left, or all of them, are numbers.
export const addTable = (caption, head, lines, /** @type {Looks} */ looked = {}) => {
  const {parent = into, numbers, id = "", wide = false} = looked;
  const looks = !wide ? "" : wide === "widest" || head.length > 10 ? "wide-table widest" : "wide-table";
  const frame = add("div", "", parent, {className: "scroll"});
  const table = add("table", "", frame, {id: id && idPrefix + id, className: looks});
  add("caption", caption, table);
  const fill = (row, kind, cells) => cells.forEach((cell, k) =>
    add(kind, cell, row, {className: !numbers || numbers.includes(k) ? "number" : ""}));
  fill(add("tr", "", add("thead", "", table)), "th", head);
  const body = add("tbody", "", table);
  for (const cells of lines)
    fill(add("tr", "", body), "td", cells);
};

/// [{text, kind}] of a contact, the most important first. Two of one kind about the same key say the same.
export const warningsOf = ({group}) => {
  const lines = name => (group[name]?.text ?? "").split("\n");
  const kinds = lines("warning_kinds"), about = lines("warning_about");
  return lines("warnings").map((text, k) => ({text, kind: kinds[k] ? `${kinds[k]} ${about[k] ?? ""}` : text}))
    .filter(({text}) => text);
};

export const worstOf = ({group}) => valueOf(group.quantities, "certificate").toExponential(1);
export const toleranceOf = ({group}) => valueOf(group.certificate, "tolerance").toExponential(0);
const solversOf = ({group: {solver}}) =>
  [solver?.attributes?.normal, solver?.attributes?.tangential].filter(Boolean).join(", ");

export const addCertificate = (contact, title = "") => {
  const {why_not_certified: why, solver_note: note} = contact.group.attributes, certified = certifiedOf(contact.group);
  const worst = `the worst violation of a contact condition is ${worstOf(contact)}`, most = toleranceOf(contact);
  const text = certified
    ? `Certified: ${worst} (relative; at most ${most}), by code that shares nothing with the solvers ` +
      `(${solversOf(contact)}).` + (note ? ` ${note}.` : "")
    : `NOT certified: ${why ?? `${worst}, ${most} is allowed`}.`;
  add("p", (title && `${title}. `) + text, into, {className: certified ? "certificate" : "certificate broken"});
};

/// [{text, kind}] of each warning once; `of`: [title, contact] of those that may have it.
export const warningsFound = (of, shown = text => text) => {
  const found = new Map();
  for (const [title, contact] of of)
    for (const {text, kind} of warningsOf(contact))
      found.set(kind, {text, ...found.get(kind), titles: [...(found.get(kind)?.titles ?? []), title]});
  const whose = titles => of.length < 2 ? ""
    : ` (${titles.length < of.length ? titles.join("; ") : "all of them"}; figures are those of the first)`;
  return [...found].map(([kind, {text, titles}]) => ({kind, text: `Warning: ${shown(text)}${whose(titles)}`}));
};

/// What is looked at first, in large figures: [name, words, text] of each.
export const addLarge = (items, parent = into) => {
  const list = add("dl", "", parent, {className: "six"});
  for (const [name, title, text] of items) {
    const one = add("div", "", list);
    add("dt", title, one);
    add("dd", text, one, {id: `${idPrefix}six-${name}`});
  }
};
export const addSix = (contact, parent = into) => {
  const q = contact.group.quantities;
  const text = name => `${valueText(q, name)} ${unitText(q[name].unit)}`;
  addLarge(ranked(q, "result", "headline").map(name => [name, words(name), text(name)]), parent);
};

/// How much more a contact has than the first one, the reference.
const lessText = (contacts, contact, name) => {
  const [reference, other] = [contacts[0], contact].map(one => valueOf(one.group.quantities, name));
  if (typeof reference !== "number" || typeof other !== "number")
    return "–";
  const share = Math.abs(reference) > LEAST_NUMBER
    ? ` (${Math.round(1000 * (other - reference) / Math.abs(reference)) / 10 || 0} %)` : "";
  return number(Number((other - reference).toPrecision(4))) + share;
};

export const addQuantities = (contacts, caption, id, parent = into) => {
  const [{group: {quantities: first}}, ...others] = contacts, isOne = !others.length;
  const value = ({group: {quantities: q}}, name) => inDegrees(valueText(q, name), valueOf(q, name), q[name]?.unit);
  const line = name => [
    words(name), ...contacts.map(c => value(c, name)), ...others.map(c => lessText(contacts, c, name)),
    unitText(first[name].unit), ...isOne ? [first[name].description] : []];
  const less = others.map(c => `${shortOf(c.name)} less ${shortOf(contacts[0].name)}`);
  const names = contacts.map(c => shortOf(c.name));
  const head = isOne ? ["", "value ± error", "unit", ""] : ["", ...names, ...less, "unit"];
  const shown = ranked(first, "result", "main");
  const isKnown = name => contacts.some(c => typeof valueOf(c.group.quantities, name) === "number");
  const numbers = Array.from({length: 2 * contacts.length - 1}, (_, k) => k + 1);
  const looks = {numbers, wide: contacts.length > 2 ? "widest" : false};
  addTable(caption, head, shown.filter(isKnown).map(line), {parent, id, ...looks});
  const rest = add("details", "", parent);
  add("summary", "all other numbers", rest);
  const unranked = Object.keys(first).filter(name => !shown.includes(name));
  addTable("", head, unranked.map(line), {parent: rest, ...looks});
};

export const addPatches = (contact, parent = into) => {
  const p = contact.group.patches;
  if (!p?.Fn)
    return;
  const places = p.Fn.values.map((_, k) => k);
  const cell = (name, k) =>
    inDegrees(entryText(p[name], k), p[name].values[k], p[name].unit);
  addTable("Patches, the largest force first", ["", ...places.map(k => `patch ${k + 1}`), "unit", ""],
           ranked(p, "patch", "main").map(name =>
             [words(name), ...places.map(k => cell(name, k)), unitText(p[name].unit), p[name].description]),
           {parent, numbers: places.map(k => k + 1), id: `patches-${contact.name}`});
};

/// Some columns of a table, a line each row.
export const addColumns = (table, names, caption, id, more = {}) => {
  const there = names.filter(name => table[name]);
  addTable(
      caption, there.map(name => withUnit(name.replaceAll("_", " "), table[name])),
      table[there[0]].values.map(
          (_, i) =>
              there.map(name => more[name]?.(i) ?? entryText(table[name], i))),
      {id, wide: there.length > 6});
};

/// [name, words, text] of the largest number of a column.
export const largest = (table, name, title) =>
  [name, title, `${number(largestOf(table[name].values))} ${unitText(table[name].unit.replace(/^1$/, ""))}`];
/// The same of a single number.
export const single = (name, title = words(name).replaceAll("_", " "), group = data) =>
  [name, title, `${valueText(group, name)} ${unitText(group[name].unit.replace(/^1$/, ""))}`];
