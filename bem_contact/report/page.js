// The page: words and tables first, which need no library; then the figures.
const page = document.getElementById("page"), report = JSON.parse(document.getElementById("data").textContent);
const data = report.data;
const figures = []; // [element, figure]: drawn once the library is there

const failed = error => {
  const list = document.getElementById("script-errors");
  list.hidden = false;
  list.append(Object.assign(document.createElement("li"), {textContent: `This page was not drawn to its end: ${error}`}));
};
window.addEventListener("error", event => failed(event.message));
window.addEventListener("unhandledrejection", event => failed(event.reason));

const add = (kind, text = "", parent = page, more = {}) =>
    parent.appendChild(Object.assign(document.createElement(kind), {textContent: text}, more));

const addFigure = (id, caption, figure) => {
  if (!figure)
    return;
  const block = add("div", "", page, {className: "block"});
  const frame = add("div", "", block, {id, className: id.startsWith("solid") ? "figure solid" : "figure"});
  add("div", "", frame, {className: "drawing"});
  add("p", caption, block, {className: "caption"});
  figures.push([frame, figure]);
};

/// "1859 ± 4": as many digits as the error has meaning.
const number = (value, error) => {
  if (value === null || value === undefined)
    return "–";
  if (!(error > 0))
    return Math.abs(value) < 1e-3 && value !== 0 ? value.toExponential(3) : String(Number(value.toPrecision(6)));
  const digits = Math.min(12, Math.max(0, Math.ceil(-Math.log10(error) + 0.3)));
  return `${value.toFixed(digits)} ± ${error.toFixed(digits)}`;
};

/// "mm2" as people write it.
const unitText = unit => unit.replace(/mm\^?2/g, "mm²").replace(/mm\^?3/g, "mm³");

/// A table; the cells numbered `numbers` from the left, or all of them, are numbers.
const addTable = (caption, head, lines, {parent = page, numbers, id = "", wide = false} = {}) => {
  const table = add("table", "", parent, {id, className: wide ? "wide" : ""});
  add("caption", caption, table);
  const fill = (row, kind, cells) => cells.forEach((cell, k) =>
      add(kind, cell, row, {className: !numbers || numbers.includes(k) ? "number" : ""}));
  fill(add("tr", "", add("thead", "", table)), "th", head);
  const body = add("tbody", "", table);
  for (const cells of lines)
    fill(add("tr", "", body), "td", cells);
};

const TITLES = {fem: "Finite-element influence functions", tangent_plane: "Tangent planes", halfspace: "Half-space",
                hertz: "Hertz"};
const SETS = {equal_forces: "At equal forces", equal_position: "At equal position and vertical force"};
const MAIN = ["Fx", "Fy", "Fz", "Fs", "Mz", "lateral", "approach", "pmax", "area", "adhesion_share", "friction_power", "xi",
              "eta", "phi", "free_rolling_xi", "free_rolling_radius", "patch_count"];
const PATCH = ["Fn", "Fx", "Fs", "Mn", "pmax", "area", "y", "z", "s", "delta", "semi_axis_a", "semi_axis_b", "xi", "eta", "phi"];

const contactsOf = group => Object.keys(TITLES).filter(name => group?.[name]?.p_n)
    .map(name => contactOf(name, group[name].x ? group[name] : group, group[name]));

/// A value of the scene with all defaults; "" if it has none.
const sceneValue = key => {
  const [table, name] = key.split(".");
  const lines = (data.scene_with_defaults?.text ?? "").split("\n");
  const from = lines.findIndex(line => line.trim() === `[${table}]`);
  const found = lines.slice(from + 1).find(line => line.trim().split(/\s*=/)[0] === name);
  return found === undefined ? "" : found.split("=")[1].split("#")[0].trim().replaceAll('"', "");
};

const sceneInWords = () => {
  const profile = body => data.inputs?.[`${body}.profile`]?.attributes.name;
  const out = [], contact = contactsOf(data)[0] ?? contactsOf(data.equal_forces)[0] ?? contactsOf(data.equal_position)[0];
  const quantities = contact?.group.quantities ?? {}, q = name => number(quantities[name]?.values[0]);
  const swept = report.kind === "sweep" ? sweptKeys(data) : [];
  if (profile("rail"))
    out.push(`A ${sceneValue("position.side") || "right"} wheel with the profile ${profile("wheel")}, of radius ` +
             `${sceneValue("position.wheel_radius")} mm, on a rail ${profile("rail")}.`);
  else if (data.scene_text)
    out.push("One contact problem, given directly by undeformed distance, load and creepages.");
  if (contact) {
    out.push(`The vertical force is ${q("Fz")} N` +
             (profile("rail") ? `, and the wheelset is displaced by ${q("lateral")} mm to the right.` : "."));
    out.push(contact.friction > 0
      ? `The coefficient of friction is ${contact.friction}. The creepages are xi ${q("xi")}, eta ${q("eta")} and phi ` +
        `${q("phi")} ${quantities.phi?.unit ?? ""}.` : "There is no friction.");
    for (const {name, group} of report.kind === "result" ? [contact] : [])
      out.push(`The model is ${name} (${TITLES[name].toLowerCase()}): ${group.attributes.reason}. The grid has ${q("mx")} × ` +
               `${q("ms")} elements of ${q("dx")} × ${q("ds")} mm.`);
  }
  if (swept.length)
    out.push(`${data.attributes.cases} cases: ${swept.join(", ")} ${swept.length > 1 ? "vary" : "varies"}. ` +
             `${data.attributes.certified} are certified, ${data.attributes.not_certified} are not, ` +
             `${data.attributes.refused} were refused, ${data.attributes.died} died, ${data.attributes.missing} are missing.`);
  if (report.kind === "creep curves")
    out.push(`The scene ${data.attributes.scene.split("/").pop()}, model ${data.attributes.model}: vertical force ` +
             `${number(data.attributes.Fz_N)} N, friction bound μ Fn = ${number(data.attributes.bound_N)} N.`);
  if (report.kind === "wear")
    out.push(`${data.step.values.length - 1} steps, ${number(data.mileage.values.at(-1))} km: the rail has lost ` +
             `${number(data.rail_area.values.at(-1))} mm² of its section, the wheel ${number(data.wheel_area.values.at(-1))} mm².`);
  return out;
};

const addCertificate = (contact, title = "") => {
  const a = contact.group.attributes, holds = a.certificate_holds === 1;
  const box = add("div", "", page, {className: holds ? "certificate" : "certificate broken"});
  add("p", `${title}The certificate ${holds ? "holds" : "DOES NOT HOLD"}: the worst violation of a contact condition is ` +
      `${a.certificate_worst.toExponential(1)} (relative; at most ${a.certificate_tolerance.toExponential(0)}). It was computed by ` +
      `code that shares nothing with the solvers (${a.normal_solver}${a.tangential_solver ? ", " + a.tangential_solver : ""}).` +
      (a.remark ? ` ${a.remark}.` : ""), box);
  for (const warning of (contact.group.warnings?.text ?? "").split("\n").filter(Boolean))
    add("p", `Warning: ${warning}`, box);
};

const addQuantities = (contacts, caption, id) => {
  const value = (contact, name) => number(contact.group.quantities[name]?.values[0],
                                          contact.group.quantities[`${name}_error`]?.values[0]);
  const line = name => { const q = contacts[0].group.quantities[name];
                         return [name, ...contacts.map(c => value(c, name)), unitText(q.unit), q.description]; };
  const all = Object.keys(contacts[0].group.quantities).filter(name => !name.endsWith("_error"));
  const head = ["", ...contacts.map(c => contacts.length > 1 ? TITLES[c.name] : "value ± error"), "unit", ""];
  const known = name => contacts.some(c => c.group.quantities[name]?.values[0] !== null);
  const numbers = contacts.map((_, k) => k + 1);
  addTable(caption, head, MAIN.filter(name => all.includes(name) && known(name)).map(line), {numbers, id});
  const rest = add("details");
  add("summary", "all other numbers", rest);
  addTable("", head, all.filter(name => !MAIN.includes(name)).map(line), {parent: rest, numbers});
};

const addPatches = contact => {
  const p = contact.group.patches;
  if (!p)
    return;
  const count = p.Fn.values.length;
  addTable("Patches, the largest force first", ["", ...Array.from({length: count}, (_, k) => `patch ${k + 1}`), "unit", ""],
           PATCH.filter(name => p[name]).map(name =>
             [name, ...Array.from({length: count}, (_, k) => number(p[name].values[k], p[`${name}_error`]?.values[k])),
              unitText(p[name].unit), p[name].description]),
           {numbers: Array.from({length: count}, (_, k) => k + 1), id: `patches-${contact.name}`});
};

/// Radius of the wheel at the contact; undefined where there is no wheel.
const radiusOf = contact => {
  const depth = contact.group.patches?.wheel_z?.values[0], radius = Number(sceneValue("position.wheel_radius"));
  return radius > 0 && depth !== null && depth !== undefined ? radius + depth : undefined;
};

const addContactFigures = (contact, solid) => {
  const title = TITLES[contact.name];
  if (!extent(contact))
    return add("p", "Nothing is in contact.");
  if (solid && contact.rail && contact.y && contact.delta)
    addFigure(`solid-${contact.name}`, "Wheel and rail in place, with the pressure on the patch. Turn it with the mouse; a " +
              "click on a name hides or shows that body.", solidFigure(contact, radiusOf(contact)));
  addFigure(`patch-${contact.name}`, `${title}: the patch from above. Hatched elements slip; those within the thick orange line ` +
            "adhere. Arrows: shear traction on the rail.", patchFigure(contact));
  for (const along of ["x", "s"]) {
    const cut = cutFigure(contact, along);
    addFigure(`cut-${along}-${contact.name}`, `${title}: ${contact.friction > 0 ? "shear traction within the bound of friction"
              : "pressure"} along ${along} through the largest pressure (${cut.where}).`, cut);
  }
  if (solid && contact.rail && contact.wheel && contact.y)
    addFigure(`section-${contact.name}`, "The section at the contact, looking along the track.", sectionFigure(contact));
};

const addResult = () => {
  const [contact] = contactsOf(data);
  addCertificate(contact);
  add("h2", "Numbers");
  addQuantities([contact], "The errors are those that the size of the elements is estimated to cause", "quantities");
  addPatches(contact);
  add("h2", "Contact");
  addContactFigures(contact, true);
};

const addComparison = () => {
  const sets = Object.keys(SETS).filter(name => contactsOf(data[name]).length);
  for (const name of sets)
    for (const contact of contactsOf(data[name]))
      addCertificate(contact, `${SETS[name]}, ${TITLES[contact.name].toLowerCase()}: `);
  add("h2", "Numbers");
  for (const name of sets)
    addQuantities(contactsOf(data[name]), SETS[name], `quantities-${name}`);
  const contacts = contactsOf(data[sets[0]]);
  add("h2", SETS[sets[0]]);
  const dashes = ["solid", "dash", "dot", "dashdot"];
  addFigure("pressures", "Pressure along s through its largest value, by each model.", {
    height: 340, traces: contacts.map((contact, k) => {
      const [, column] = peak(contact);
      return {type: "scatter", mode: "lines", x: contact.s, y: contact.pn.map(line => line[column]),
              name: TITLES[contact.name], line: {color: PRESSURE[1][1], width: 2.5 - 0.5 * k, dash: dashes[k]}};
    }), layout: {xaxis: {title: "s along the rail, mm"}, yaxis: {title: "pressure, MPa"}, legend: ABOVE}});
  contacts.forEach((contact, k) => {
    add("h3", TITLES[contact.name]);
    addContactFigures(contact, k === 0);
  });
};

const addSweep = () => {
  const keys = sweptKeys(data).filter(k => new Set(data[k].values).size > 1), columns = ["pmax", "area", "Fx", "Fy", "Fz", "Mz"];
  const key = leadingKey(data, keys);
  add("h2", "Cases");
  if (data.patches.y.values.some(y => y !== null))
    addFigure("patches-over-y", "Where the patches lie on the rail: each bar is as wide as its patch; larger marks carry larger " +
              "normal forces, darker ones larger pressures.", patchesFigure(data, key));
  for (const names of [["pmax"], ["area"], ["Fx", "Fy"], ["Mz"]])
    addFigure(`over-${names.join("-")}`, `${names.join(", ")} over ${key ?? "the cases"}.`, sweepFigure(data, keys, key, names));
  const status = ["missing", "certified", "not certified", "refused", "died"];
  addTable("All cases", ["case", ...keys, ...columns.map(name => titled(name, data[name])), "status"],
           data.status.values.map((state, i) =>
             [i, ...keys.map(k => keyText(data[k], i)),
              ...columns.map(name => number(data[name].values[i], data[`${name}_error`]?.values[i])), status[state]]),
           {id: "cases", wide: true});
  for (const [name, one] of Object.entries(data.cases ?? {}))
    if (one.attributes?.reason)
      add("p", `Case ${Number(name)}: ${one.attributes.reason}`);
};

const addCreepCurves = () => {
  add("h2", "Slopes and sensitivities");
  const matrix = (name, caption) => data[name] && addTable(caption, ["", "d/dxi", "d/deta", "d/dphi"],
    ["Fx", "Fs", "Mz"].map((force, row) => [force, ...[0, 1, 2].map(k =>
      number(data[name].values[3 * row + k], data[`${name}_error`]?.values[3 * row + k]))]), {numbers: [1, 2, 3], id: name});
  matrix("slopes", "Slopes where nothing moves over the other (N; Mz: N mm; by phi: times mm)");
  matrix("kalker", "The same by Kalker's linear theory, for the nearest ellipse");
  matrix("sensitivities", "Sensitivities at the scene's creepages");
  add("h2", "Curves");
  for (const which of ["xi", "eta", "phi"])
    if (data[which])
      addFigure(`curve-${which}`, `Forces over ${which}; the other two creepages are the scene's.`, creepFigure(data, which));
};

const addWear = () => {
  add("h2", "Wear");
  for (const body of report.steps.length > 1 ? ["rail", "wheel"] : [])
    if (data[`${body}_depth`].values.at(-1) > 0)
      addFigure(`worn-${body}`, `What is gone from the ${body}, by step.`, wornFigure(report.steps, data, body));
  addFigure("wear-depth", "Depth of the deepest place.", wearFigure(data, "depth", "mm"));
  addFigure("wear-area", "Area gone from the sections.", wearFigure(data, "area", "mm²"));
  const names = ["mileage", "revolutions", "rail_depth", "wheel_depth", "rail_area", "wheel_area"];
  addTable("By step", ["step", ...names.map(name => titled(name.replace("_", " "), data[name]))],
           data.step.values.map((step, i) => [step, ...names.map(name => number(data[name].values[i]))]), {id: "steps", wide: true});
};

const addScene = () => {
  for (const [name, title] of [["scene_text", "The scene as it was given"], ["scene_with_defaults", "The scene with every key"]])
    if (data[name]) {
      const fold = add("details", "", page, {id: name});
      add("summary", title, fold);
      add("pre", data[name].text, fold);
    }
};

/// The library is kept compressed in the page.
const loadLibrary = async () => {
  const bytes = Uint8Array.from(atob(document.getElementById("library").textContent), c => c.charCodeAt(0));
  const text = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
  add("script", text, document.head);
};

const draw = async ([frame, {traces, layout, height}]) => {
  const drawing = frame.firstChild, size = {width: 700, height};
  const axis = {showline: true, linecolor: INK, ticks: "outside", zeroline: false, gridcolor: "#e3e7eb"};
  const whole = {...size, font: {family: "sans-serif", size: 12, color: INK}, hovermode: "closest", ...layout,
                 margin: {t: 50, l: 65, r: 20, b: 50, ...layout.margin}};
  for (const name of ["xaxis", "yaxis"])
    if (layout[name])
      whole[name] = {...axis, ...layout[name]};
  await Plotly.newPlot(drawing, traces, whole, {displaylogo: false, modeBarButtonsToRemove: ["select2d", "lasso2d"]});
  if (!frame.classList.contains("solid"))
    return;
  const picture = add("img", "", frame, {className: "paper", alt: "wheel, rail and patch"});
  const take = async () => { picture.src = await Plotly.toImage(drawing, {format: "png", ...size, scale: 2}); };
  await take();
  drawing.on("plotly_relayout", take); // paper shows it as it was turned last
};

const start = async () => {
  document.title = `${report.file}: bem_contact report`;
  add("h1", `${{result: "Contact of wheel and rail", comparison: "Comparison of models", sweep: "Sweep", "creep curves":
                "Creep curves", wear: "Wear"}[report.kind]}: ${report.file}`);
  add("p", sceneInWords().join(" "), page, {id: "words"});
  ({result: addResult, comparison: addComparison, sweep: addSweep, "creep curves": addCreepCurves, wear: addWear})[report.kind]();
  addScene();
  const a = data.attributes;
  add("p", `${a.program ?? "bem_contact"}. x is the direction of rolling, y points to the right, z down; s runs along the rail's ` +
      "profile, n into the rail. Forces are those on the rail. Figures: plotly.js (MIT licence), © Plotly, Inc.",
      document.getElementById("notes"));
  await loadLibrary();
  for (const one of figures)
    await draw(one);
  document.body.dataset.drawn = figures.length;
};
start().catch(failed);
