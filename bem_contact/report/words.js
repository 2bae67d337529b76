// Words and tables of a page. They need no library. `data` and `report`: what the page shows.
const LEAST_NUMBER = 1e-8; // in every unit of a page (mm, rad, MPa, N, N mm) less is rounding

/// "1859 ± 4" or "(-9.27 ± 0.05)e-4": as many digits as the error has meaning.
const number = (value, error) => {
  if (value === null || value === undefined)
    return "–";
  if (Math.abs(value) < LEAST_NUMBER)
    value = 0;
  if (!(error > LEAST_NUMBER * Math.max(1, Math.abs(value))))
    return Math.abs(value) < 1e-3 && value !== 0 ? value.toExponential(3) : String(Number(value.toPrecision(6)));
  const size = Math.max(Math.abs(value), error);
  if (value !== 0 && size < 0.01) {
    const power = Math.floor(Math.log10(size)), scale = 10 ** power;
    return `(${number(value / scale, error / scale)})e${power}`;
  }
  const digits = Math.min(12, Math.max(0, Math.ceil(-Math.log10(error) + 0.3)));
  return `${value.toFixed(digits)} ±\u00a0${error.toFixed(digits)}`;
};

/// An angle in degrees behind what is written in rad.
const inDegrees = (text, value, unit) => unit === "rad" && value !== null && value !== undefined
    ? `${text} (${number(Number((value * 180 / Math.PI).toPrecision(3)))}°)` : text;

/// Names of the files as people read them (record/words.json); a name that is not there stands as it is.
const WORDS = SHARED.words;
const ofEither = name => name.replace(/^(right|left)_/, ""); // wheel
const words = name => WORDS[name] ?? (ofEither(name) === name ? name : `${words(ofEither(name))}, ${name.split("_")[0]} wheel`);

/// The lines of a text.
const linesOf = texts => texts.text.split("\n");
/// The name of a file without its folders.
const shortName = name => name.split("/").pop();

/// "mm2" as people write it.
const unitText = unit => unit.replace(/mm\^?2/g, "mm²").replace(/mm\^?3/g, "mm³").replace("N mm", "N\u00a0mm");

/// A table; the cells numbered `numbers` from the left, or all of them, are numbers.
const addTable = (caption, head, lines, {parent = page, numbers, id = "", wide = false} = {}) => {
  const table = add("table", "", add("div", "", parent, {className: "scroll"}), {id: id && idPrefix + id, className: !wide ? "" : wide === "widest" || head.length > 10 ? "wide widest" : "wide"});
  add("caption", caption, table);
  const fill = (row, kind, cells) => cells.forEach((cell, k) =>
      add(kind, cell, row, {className: !numbers || numbers.includes(k) ? "number" : ""}));
  fill(add("tr", "", add("thead", "", table)), "th", head);
  const body = add("tbody", "", table);
  for (const cells of lines)
    fill(add("tr", "", body), "td", cells);
};

const TITLES = {...Object.fromEntries(Object.entries(SHARED.models).map(([name, {title}]) => [name, title])),
                right: "Right wheel", left: "Left wheel"}; // in that order; of wheelsets the last two
// A model that is not here has its name in scenes, and stands behind the others.
const titleOf = name => TITLES[name] ?? name, shortOf = name => SHARED.models[name]?.short ?? name;
const namesIn = group => [...new Set([...Object.keys(TITLES), ...Object.keys(group ?? {})])].filter(name => group?.[name]);
const SETS = {at_equal_forces: "At equal forces", at_equal_position: "At equal position and vertical force"};
const MAIN = ["Fx", "Fy", "Fz", "Fs", "Mz", "lateral", "approach", "pmax", "area", "adhesion_share", "T_gamma",
              "Tmax_rail", "Tmax_wheel", "xi", "eta", "phi", "free_rolling_xi", "free_rolling_radius", "patch_count"];
const PATCH = ["Fn", "Fx", "Fs", "Mn", "pmax", "area", "y", "z", "s", "delta", "semi_axis_a", "semi_axis_b", "xi", "eta", "phi"];

/// The contacts of a group: itself, or one of each model or wheel.
const contactsOf = group => {
  if (group?.p_n)
    return [contactOf(group.attributes.model, group)];
  const inside = name => group?.[name]?.result ?? group?.[name];
  return namesIn(group).filter(name => inside(name)?.p_n)
    .map(name => contactOf(name, inside(name)));
};
/// A number of a group; undefined where it has none.
const valueOf = (group, name) => group?.[name]?.values?.[0];
const certifiedOf = group => group.attributes.certified === 1;
/// How an answer ended, by its number in files (record/outcome.hpp), and how many cases are it.
const OUTCOMES = ["missing", "certified", "not certified", "refused", "died", "failed"];
const COUNTED = {certified: "are certified", "not certified": "are not", refused: "were refused", died: "died", failed: "failed", missing: "are missing"};
const countsText = countOf => Object.entries(COUNTED).map(([outcome, text]) => [countOf(outcome), text]).filter(([count], k) => count > 0 || k === 0)
  .map(([count, text]) => `${count} ${text}`).join(", ");

/// A value of the scene with all defaults; "" if it has none.
const sceneValue = key => {
  const [table, name] = key.split(".");
  const lines = (data.scene_with_defaults?.text ?? "").split("\n");
  const from = lines.findIndex(line => line.trim() === `[${table}]`);
  const found = lines.slice(from + 1).find(line => line.trim().split(/\s*=/)[0] === name);
  return found === undefined ? "" : found.split("=")[1].split("#")[0].trim().replaceAll('"', "");
};

/// Radius of the wheel at the contact; undefined where there is no wheel.
const radiusOf = contact => {
  const depth = contact.group.patches?.wheel_z?.values[0], own = contact.left ? sceneValue("wheelset.left_wheel_radius") : "";
  const radius = Number(own || sceneValue("position.wheel_radius"));
  return radius > 0 && depth !== null && depth !== undefined ? radius + depth : undefined;
};

const bothWheels = profile => `Both wheels of a wheelset ${profile("wheel")}, on rails ${profile("rail")}.`;

const wheelsetInWords = profile => {
  const name = path => path?.split("/").pop(), words = [], of = name => number(data.wheelset[name]?.values[0]);
  if (report.kind === "conicity") {
    const side = which => `${name(data[which].attributes.wheel)} on ${name(data[which].attributes.rail)}`;
    words.push(side("right") === side("left") ? `A rigid wheelset with wheels ${side("right")}.`
               : `A rigid wheelset: the right wheel is ${side("right")}, the left one ${side("left")}.`,
               "It is moved sideways on its track. The rolling radius difference says how it steers itself, and the equivalent " +
               "conicity (EN 15302) is the slope of the cone with the same wavelength.");
  } else
    words.push(bothWheels(profile),
               `The axle bears ${of("Fz")} N down and ${of("Fy")} N to the right. It stands ${of("lateral")} mm to the right with a roll of ` +
               `${inDegrees(`${of("roll")} rad`, data.wheelset.roll?.values[0], "rad")}, right side down, and rolls on a radius of ${of("rolling_radius")} mm.`);
  return words;
};

const sceneInWords = () => {
  const swept = report.kind === "sweep" ? sweptKeys(data) : [];
  const profile = body => swept.includes(`${body}.profile`) ? "of several profiles"
      : data.inputs?.[`${body}.profile`] && `with the profile ${data.inputs[`${body}.profile`].attributes.name.split("/").pop()}`;
  if (report.kind === "conicity" || report.kind === "wheelset")
    return wheelsetInWords(profile);
  const out = [], contact = contactsOf(data)[0] ?? contactsOf(data.at_equal_forces)[0] ?? contactsOf(data.at_equal_position)[0];
  const quantities = contact?.group.quantities ?? {}, q = name => number(quantities[name]?.values[0]);
  if ("right_share" in data || data.right)
    out.push(bothWheels(profile));
  else if (profile("rail"))
    out.push(`A ${sceneValue("position.side") || "right"} wheel ${profile("wheel")} and the nominal radius ` +
             `${Number(sceneValue("position.wheel_radius"))} mm, on a rail ${profile("rail")}.`);
  else if (data.scene_text)
    out.push("One contact problem, given directly by undeformed distance, load and creepages.");
  if (contact) {
    // Those that act: the keys are counted from a rolling radius, to which the geometry adds.
    const acting = contact.group.patches?.xi?.values?.length && contact.group.patches.xi.values[0] !== null ? contact.group.patches : undefined;
    const at = name => number(acting[name].values[0]);
    out.push(`The vertical force is ${q("Fz")} N` +
             (profile("rail") && report.kind === "result" ? `, and the wheelset is displaced by ${q("lateral")} mm to the right.` : "."));
    out.push(contact.friction > 0
      ? `The coefficient of friction is ${contact.friction}.` + (report.kind !== "result" ? "" :
        (acting ? ` At the centre of the patch${acting.xi.values.length > 1 ? " with the largest force" : ""} the creepages are xi ${at("xi")}, eta ${at("eta")} and phi ${at("phi")} ${acting.phi.unit}.`
                : ` The creepages are xi ${q("xi")}, eta ${q("eta")} and phi ${q("phi")} ${quantities.phi?.unit ?? ""}.`))
      : "There is no friction.");
    for (const {name, group} of report.kind === "result" ? [contact] : [])
      out.push(`The model is ${name} (${titleOf(name).toLowerCase()}): ${group.attributes.why_this_model}. The grid has ${q("mx")} × ` +
               `${q("ms")} elements of ${q("dx")} × ${q("ds")} mm.`);
    const {conformity, attributes} = contact.group, placed = report.kind === "result";
    if (placed && attributes.track)
      out.push(`${attributes.track[0].toUpperCase()}${attributes.track.slice(1)}.`);
    if (placed && conformity)
      out.push(`Where the rigid bodies touch first they are ${conformity.attributes.fit}: at most ${number(valueOf(conformity, "largest_distance"))} mm ` +
               `apart between there and the gauge point, and less than 0.1 mm over ${number(valueOf(conformity, "width"))} mm.`);
  }
  if (swept.length)
    out.push(`${data.status.values.length} cases: ${swept.map(words).join(", ")} ${swept.length > 1 ? "vary" : "varies"}. ` +
             countsText(outcome => valueOf(data, `${outcome.replace(" ", "_")}_count`) ?? 0) + ".");
  if (report.kind === "creep curves")
    out.push(`The scene ${data.attributes.scene.split("/").pop()}, model ${data.attributes.model}: vertical force ` +
             `${number(valueOf(data, "Fz"))} N, friction bound μ Fn = ${number(valueOf(data, "bound"))} N.`);
  if (report.kind === "wear")
    out.push(`${data.step.values.length - 1} steps, ${number(data.mileage.values.at(-1))} km: the rail has lost ` +
             `${number(data.rail_area.values.at(-1))} mm² of its section, the wheel ${number(data.wheel_area.values.at(-1))} mm².`);
  return out;
};

const warningsOf = contact => (contact.group.warnings?.text ?? "").split("\n").filter(Boolean);

const worstOf = ({group}) => valueOf(group.quantities, "certificate").toExponential(1);
const toleranceOf = ({group}) => valueOf(group.certificate, "tolerance").toExponential(0);
const solversOf = ({group: {solver}}) => [solver?.attributes?.normal, solver?.attributes?.tangential].filter(Boolean).join(", ");

const addCertificate = (contact, title = "") => {
  const {attributes: a} = contact.group, certified = certifiedOf(contact.group), note = a.solver_note;
  add("p", (title && `${title}. `) + (certified ? `Certified: the worst violation of a contact condition is ${worstOf(contact)} (relative; at most ${toleranceOf(contact)}), ` +
      `by code that shares nothing with the solvers (${solversOf(contact)}).` + (note ? ` ${note}.` : "")
      : `NOT certified: ${a.why_not_certified ?? `the worst violation of a contact condition is ${worstOf(contact)}, ${toleranceOf(contact)} is allowed`}.`),
      page, {className: certified ? "certificate" : "certificate broken"});
};

/// Each warning once, whatever figures are in it; `of`: [title, contact] of those that may have it.
const addWarnings = (of, parent = page, shown = text => text) => {
  const known = new Map();
  for (const [title, contact] of of)
    for (const warning of warningsOf(contact)) {
      const kind = warning.replace(/[\d.]+/g, "#");
      known.set(kind, {warning, ...known.get(kind), titles: [...(known.get(kind)?.titles ?? []), title]});
    }
  for (const {warning, titles} of known.values())
    add("p", `Warning: ${shown(warning)}` + (of.length < 2 ? "" : ` (${titles.length < of.length ? titles.join("; ") : "all of them"}; figures are those of the first)`),
        parent, {className: "warning"});
};

const SIX = ["pmax", "area", "Fx", "Fy", "Mz", "T_gamma"];
/// What is looked at first, in large figures: [name, words, text] of each.
const addLarge = (items, parent = page) => {
  const list = add("dl", "", parent, {className: "six"});
  for (const [name, title, text] of items) {
    const one = add("div", "", list);
    add("dt", title, one);
    add("dd", text, one, {id: `${idPrefix}six-${name}`});
  }
};
const addSix = (contact, parent = page) => {
  const q = contact.group.quantities;
  addLarge(SIX.filter(name => q[name]).map(name =>
    [name, words(name), `${number(valueOf(q, name), valueOf(q, `${name}_error`))} ${unitText(q[name].unit)}`]), parent);
};

const addQuantities = (contacts, caption, id, parent = page) => {
  const value = (contact, name) => {
    const q = contact.group.quantities[name];
    return inDegrees(number(q?.values[0], contact.group.quantities[`${name}_error`]?.values[0]), q?.values[0], q?.unit);
  };
  // The first one is the reference: how much each other one has more.
  const less = (contact, name) => {
    const [reference, other] = [contacts[0], contact].map(one => valueOf(one.group.quantities, name));
    if (typeof reference !== "number" || typeof other !== "number")
      return "–";
    const share = Math.abs(reference) > LEAST_NUMBER ? ` (${Math.round(1000 * (other - reference) / Math.abs(reference)) / 10 || 0} %)` : "";
    return number(Number((other - reference).toPrecision(4))) + share;
  };
  const line = name => { const q = contacts[0].group.quantities[name];
                         return [words(name), ...contacts.map(c => value(c, name)), ...contacts.slice(1).map(c => less(c, name)), unitText(q.unit),
                                 ...contacts.length > 1 ? [] : [q.description]]; };
  const all = Object.keys(contacts[0].group.quantities).filter(name => !name.endsWith("_error"));
  const head = contacts.length > 1 ? ["", ...contacts.map(c => shortOf(c.name)), ...contacts.slice(1).map(c => `${shortOf(c.name)} less ${shortOf(contacts[0].name)}`), "unit"]
                                   : ["", "value ± error", "unit", ""];
  const known = name => contacts.some(c => c.group.quantities[name]?.values[0] !== null);
  const numbers = Array.from({length: 2 * contacts.length - 1}, (_, k) => k + 1);
  const wide = contacts.length > 2 ? "widest" : false;
  addTable(caption, head, MAIN.filter(name => all.includes(name) && known(name)).map(line), {parent, numbers, id, wide});
  const rest = add("details", "", parent);
  add("summary", "all other numbers", rest);
  addTable("", head, all.filter(name => !MAIN.includes(name)).map(line), {parent: rest, numbers, wide});
};

const addPatches = (contact, parent = page) => {
  const p = contact.group.patches;
  if (!p?.Fn)
    return;
  const count = p.Fn.values.length;
  addTable("Patches, the largest force first", ["", ...Array.from({length: count}, (_, k) => `patch ${k + 1}`), "unit", ""],
           PATCH.filter(name => p[name]).map(name =>
             [words(name), ...Array.from({length: count}, (_, k) =>
                        inDegrees(number(p[name].values[k], p[`${name}_error`]?.values[k]), p[name].values[k], p[name].unit)),
              unitText(p[name].unit), p[name].description]),
           {parent, numbers: Array.from({length: count}, (_, k) => k + 1), id: `patches-${contact.name}`});
};
