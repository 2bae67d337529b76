// The page: which words, tables and figures each kind of file gets; then the figures are drawn.
const whole = JSON.parse(document.getElementById("data").textContent);
const {kind, file} = whole.attributes;
let data = whole.data; // of a study: that of the part which is added
const report = {kind, file, steps: Object.entries(whole.steps ?? {}).map(([step, {rail, wheel}]) => ({step: Number(step), rail: rows(rail), wheel: rows(wheel)}))};
if (data.profiles)
  data.profiles = Object.values(data.profiles).map(p => ({name: p.attributes.name, y: p.y.values, z: p.z.values, curvature: p.curvature.values}));

const addSolid = contact => {
  if (isShaped(contact) && extent(contact))
    addFigure(`solid-${contact.name}`, "Wheel and rail in place, with the pressure on the patch; the wheel is cut behind it. Turn it with the mouse; a " +
              "click on a name hides or shows that body.", solidFigure(contact, radiusOf(contact)));
};

const addPatchFigure = (contact, parent = page) => {
  const patch = patchFigure(contact);
  addFigure(`patch-${contact.name}`, `${titleOf(contact.name)}: the patch from above.` +
            (contact.friction > 0 ? " Hatched elements slip; those within the thick line (orange) adhere." : "") +
            (patch?.longest > 0 ? " Arrows: shear traction on the rail." : ""), patch, parent);
};

const addCuts = (contact, parent = page) => {
  for (const along of ["x", "s"].filter(name => contact[name].length > 1)) {
    const cut = cutFigure(contact, along);
    addFigure(`cut-${along}-${contact.name}`, `${titleOf(contact.name)}: ${contact.friction > 0 ? "shear traction within the bound of friction"
              : "pressure"} along ${along} through the largest pressure (${cut.where}).`, cut, parent);
  }
};

/// All figures of one contact but that in 3-D.
const addContactFigures = contact => {
  if (!extent(contact))
    return add("p", "Nothing is in contact.");
  addPatchFigure(contact);
  addCuts(contact, add("div", "", page, {className: "side-by-side"}));
  if (isShaped(contact))
    addFigure(`section-${contact.name}`, "The section at the contact, looking along the track.", sectionFigure(contact));
  if (contact.group.stresses)
    addFigure(`stresses-${contact.name}`, `${titleOf(contact.name)}: stress below the surface, by half-space formulas.`, stressFigure(contact.group.stresses));
};

/// Forces by step, of a transient or of shifts.
const addHistory = ({group: {history}}) => {
  if (!history?.Fx)
    return;
  const steps = history.Fx.values.map((_, k) => k + 1);
  addFigure("history", "Forces on the rail by step.", {height: 330, traces: ["Fx", "Fy", "Fz"].map(name =>
    lineOver(steps, history[name].values, name, FORCES[name])), layout: {xaxis: {title: "step"}, yaxis: {title: "N"}, legend: ABOVE}});
};

const addResult = () => {
  const [contact] = contactsOf(data);
  addCertificate(contact);
  addWarnings([["", contact]]);
  addSix(contact);
  addSolid(contact);
  addContactFigures(contact);
  addHistory(contact);
  add("h2", "Numbers");
  addQuantities([contact], "The errors are those that the size of the elements is estimated to cause", "quantities");
  addPatches(contact);
};

/// Fx of each model beyond its own free rolling, where the file has it.
const addCreepForces = creep => {
  if (!creep)
    return;
  const models = namesIn(creep.Fx).filter(name => creep.Fx[name].values);
  addTable("Fx on the rail (N) at equal creepage beyond free rolling, each model at its place at equal forces",
           ["creepage", ...models.map(shortOf)], creep.xi_from_free_rolling.values.map((xi, k) =>
             [String(xi), ...models.map(name => number(creep.Fx[name].values[k], creep.Fx_error[name].values[k]))]), {id: "creep-forces"});
};

const addComparison = () => {
  const sets = Object.keys(SETS).filter(name => contactsOf(data[name]).length);
  const all = sets.flatMap(name => contactsOf(data[name]).map(contact => [`${SETS[name]}, ${shortOf(contact.name)}`, contact]));
  const broken = all.filter(([, contact]) => !certifiedOf(contact.group));
  const worst = all.reduce((most, [, contact]) => Math.max(most, Number(worstOf(contact))), 0);
  add("p", broken.length ? `NOT certified: ${broken.map(([title]) => title).join("; ")}.`
      : `All results are certified: the worst violation of a contact condition is ${worst.toExponential(1)} (relative; at most ${toleranceOf(all[0][1])}).`,
      page, {className: broken.length ? "certificate broken" : "certificate"});
  addWarnings(all);
  const contacts = contactsOf(data[sets[0]]);
  add("h2", SETS[sets[0]]);
  addSolid(contacts[0]);
  const patches = add("div", "", page, {className: "side-by-side"});
  for (const contact of contacts)
    if (extent(contact))
      addPatchFigure(contact, patches);
  const dashes = ["solid", "dash", "dot", "dashdot"];
  addFigure("pressures", "Pressure along s through its largest value, by each model.", {
    height: 340, traces: contacts.map((contact, k) => {
      const [, column] = peak(contact);
      return {type: "scatter", mode: "lines", x: contact.s, y: contact.pn.map(line => line[column]),
              name: titleOf(contact.name), line: {color: PRESSURE[1][1], width: 2.5 - 0.5 * k, dash: dashes[k]}};
    }), layout: {xaxis: {title: "s along the rail, mm"}, yaxis: {title: "pressure, MPa"}, legend: ABOVE}});
  for (const contact of contacts)
    if (extent(contact))
      addCuts(contact, add("div", "", page, {className: "side-by-side"}));
  add("h2", "Numbers");
  for (const name of sets)
    addQuantities(contactsOf(data[name]), SETS[name], `quantities-${name}`);
  addCreepForces(data.creep_forces);
};

/// Where a click on a mark of a sweep shows the patch of its case. Undefined where the page has no fields.
const addCaseView = () => {
  const own = data; // of a study, the part that is added now
  const cases = Object.fromEntries(Object.entries(own.cases ?? {}).filter(([, one]) => one.p_n).map(([name, one]) => [Number(name), one]));
  if (!Object.keys(cases).length)
    return undefined;
  const block = add("div", "", page, {id: `${idPrefix}case`, className: "screen-only"}), frame = add("div", "", block, {id: `${idPrefix}case-patch`});
  add("div", "", frame, {className: "drawing"});
  const line = add("p", "A click on a mark shows the patch of its case here.", block, {className: "caption"});
  return async index => {
    if (!cases[index])
      return void (line.textContent = `Case ${index} has no patch.`);
    const contact = contactOf(cases[index].attributes.model, cases[index]), figure = patchFigure(contact);
    const where = sweptKeys(own).map(key => `${words(key)} ${keyText(own[key], index)} ${unitText(own[key].unit.replace(/^1$/, ""))}`.trim()).join(", ");
    line.textContent = `Case ${index}: ${where}; ${titleOf(contact.name).toLowerCase()}, largest pressure ` +
                       `${number(own.pmax?.values[index], own.pmax_error?.values[index])} MPa.` + (figure ? "" : " Nothing is in contact.");
    frame.className = figure ? "figure" : "";
    frame.hidden = !figure;
    if (figure)
      await draw([frame, figure]);
  };
};

const addSweep = () => {
  const keys = sweptKeys(data).filter(k => new Set(data[k].values).size > 1), wheels = "right_share" in data;
  const both = name => [`right_${name}`, `left_${name}`];
  const columns = wheels ? ["lateral", "roll", ...both("share"), ...both("Fy"), ...both("pmax")] : ["pmax", "area", "Fx", "Fy", "Fz", "Mz"];
  const key = leadingKey(data, keys);
  add("h2", "Cases");
  if (!wheels && data.patches?.y.values.some(y => y !== null))
    addFigure("patches-over-y", "Where the patches lie on the rail: each bar is as wide as its patch; larger marks carry larger " +
              "normal forces, darker ones larger pressures.", {...patchesFigure(data, key), click: index => showCase?.(index)});
  const showCase = wheels ? undefined : addCaseView();
  for (const names of wheels ? [...(key === "position.lateral" ? [] : [["lateral"]]), ["roll"], both("share"), both("Fy"), both("pmax"), both("T_gamma")]
                             : [["pmax"], ["area"], ["Fx", "Fy"], ["Mz"], ["T_gamma"]])
    if (names.every(name => name in data))
      addFigure(`over-${names.join("-")}`, `${[...new Set(names.map(ofEither))].map(words).join(" and ")} over the ${key ? words(key) : "cases"}.`,
                {...sweepFigure(data, keys, key, names), click: index => showCase?.(index)});
  addTable("All cases", ["case", ...keys.map(k => withUnit(k, data[k]).replace(".", ".\u200b")), ...columns.map(name => withUnit(name, data[name])), "status"],
           data.status.values.map((state, i) =>
             [i, ...keys.map(k => keyText(data[k], i)),
              ...columns.map(name => inDegrees(number(data[name].values[i], data[`${name}_error`]?.values[i]), data[name].values[i], data[name].unit)),
              OUTCOMES[state]]),
           {id: "cases", wide: true});
  for (const [name, one] of Object.entries(data.cases ?? {}))
    if (one.attributes?.reason)
      add("p", `Case ${Number(name)}: ${one.attributes.reason}`);
};

/// What was measured, point by point, beside what is computed there.
const addMeasured = measured => {
  if (!measured)
    return;
  const {points, attributes: {force, creepage}} = measured, unit = unitText(points.measured.unit), column = name => points[name].values;
  const share = i => Math.abs(column("measured")[i]) > 0 ? `${(100 * column("difference")[i] / Math.abs(column("measured")[i])).toFixed(1)} %` : "–";
  const scatter = points.scatter ? [`scatter, ${unit}`] : [];
  add("h2", "Beside what was measured");
  add("p", `Over the ${words(creepage)}, ${force} as computed less ${force} as measured is ${number(valueOf(measured, "mean_difference"))} ${unit} in the mean and ` +
      `${number(valueOf(measured, "largest_difference"))} ${unit} at most` +
      (points.scatter ? `; ${valueOf(measured, "within_scatter")} of ${column("creepage").length} points lie within the scatter of what was measured.` : "."));
  addTable(`${force} as measured and as computed`, [creepage, `measured, ${unit}`, ...scatter, `computed, ${unit}`, "difference", "of the measured one"],
    column("creepage").map((at, i) => [number(at), number(column("measured")[i]), ...scatter.map(() => number(column("scatter")[i])),
      number(column("computed")[i], column("computed_error")[i]), number(column("difference")[i]), share(i)]), {numbers: [0, 1, 2, 3, 4, 5], id: "measured"});
};

const addCreepCurves = () => {
  add("h2", "Curves");
  for (const which of ["xi", "eta", "phi"])
    if (data.curves?.[which] ?? data[which])
      addFigure(`curve-${which}`, `Forces over the ${words(which)}; the other two creepages stay as in the scene. With little creepage a force ` +
                "grows along the straight line of linear theory, which takes the other two into account; with much of it the whole contact slips, and the force " +
                "stays within the bound of friction.", creepFigure(data, which));
  addMeasured(data.measured);
  add("h2", "Slopes and sensitivities");
  const matrix = (name, caption) => data[name] && addTable(caption, ["", "d/dxi", "d/deta", "d/dphi"],
    ["Fx", "Fs", "Mz"].map((force, row) => [force, ...[0, 1, 2].map(k =>
      number(data[name].values[3 * row + k], data[`${name}_error`]?.values[3 * row + k]))]), {numbers: [1, 2, 3], id: name});
  matrix("slopes", "Slopes where nothing moves over the other (N; Mz: N mm; by phi: times mm)");
  matrix("kalker", "The same by Kalker's linear theory, for the nearest ellipse");
  matrix("sensitivities", "Sensitivities at the scene's creepages");
};

const addWear = () => {
  add("h2", "Wear");
  for (const body of report.steps.length > 1 ? ["rail", "wheel"] : [])
    if (data[`${body}_depth`].values.at(-1) > 0) {
      addFigure(`film-${body}`, `The ${body} from step to step. On a screen: move the slider, or play.`, filmFigure(report.steps, data, body));
      addFigure(`worn-${body}`, `What is gone from the ${body}, by step.`, wornFigure(report.steps, data, body));
    }
  addFigure("wear-depth", "Depth of the deepest place.", wearFigure(data, "depth", "mm"));
  addFigure("wear-area", "Area gone from the sections.", wearFigure(data, "area", "mm²"));
  const names = ["mileage", "revolutions", "rail_depth", "wheel_depth", "rail_area", "wheel_area"];
  addTable("By step", ["step", ...names.map(name => withUnit(name.replace("_", " "), data[name]))],
           data.step.values.map((step, i) => [step, ...names.map(name => number(data[name].values[i]))]), {id: "steps", wide: true});
};

const addConicity = () => {
  add("h2", "Conicity");
  addFigure("tan-gamma", "Equivalent conicity over the amplitude.", conicityFigure(data));
  const c = data.conicity, names = ["amplitude", "tan_gamma", "wavelength", "from", "to"], whole = i => Math.abs(c.amplitude.values[i] % 1) < 1e-9;
  addTable("Equivalent conicity (EN 15302); – where no motion has this amplitude", names.map(name => withUnit(name.replace("_", " "), c[name])),
           c.amplitude.values.map((_, i) => i).filter((i, _, all) => all.length <= 20 || whole(i))
             .map(i => names.map(name => number(c[name].values[i]))), {id: "conicities"});
  add("h2", "Contact points");
  addFigure("radius-difference", "Rolling radius difference.", radiusFigure(data));
  for (const body of ["wheel", "rail"])
    addFigure(`touch-${body}`, `Where both wheels touch, on the ${body}; a gap is a jump of the contact.`, touchFigure(data, body));
};

const addWheelset = () => {
  const wheels = contactsOf(data), track = side => data[side].track, sum = name => data.wheelset[name]?.values[0];
  for (const wheel of wheels)
    addCertificate(wheel, titleOf(wheel.name));
  addWarnings(wheels.map(wheel => [titleOf(wheel.name), wheel]));
  add("h2", "Both wheels");
  addTable("On the track, y to the right for both", ["", "left", "right", "sum", "unit", ""], Object.keys(track("right")).filter(name => !name.endsWith("_error")).map(name =>
    [words(name), ...["left", "right"].map(side => inDegrees(number(track(side)[name].values[0], track(side)[`${name}_error`]?.values[0]), track(side)[name].values[0], track(side)[name].unit)),
     number(sum(name)), unitText(track("right")[name].unit),
     track("right")[name].description]), {numbers: [1, 2, 3], id: "track"});
  for (const wheel of wheels) {
    add("h2", titleOf(wheel.name));
    addSolid(wheel);
    addContactFigures(wheel);
    addQuantities([wheel], `${titleOf(wheel.name)}, in the frame of its side`, `quantities-${wheel.name}`);
  }
};

const addProfile = () => {
  addFigure("outline", "The profile; the others lie behind it.", profilesFigure(data.profiles, "z"));
  addFigure("curvature", "Curvature: above 0 convex, below concave.", profilesFigure(data.profiles, "curvature"));
};

/// Some columns of a table, a line each row.
const addColumns = (table, names, caption, id, more = {}) => {
  const there = names.filter(name => table[name]);
  addTable(caption, there.map(name => withUnit(name.replaceAll("_", " "), table[name])), table[there[0]].values.map((_, i) =>
    there.map(name => more[name]?.(i) ?? number(table[name].values[i], table[`${name}_error`]?.values[i]))), {id, wide: there.length > 6});
};

const known = values => values.filter(value => value !== null);
const largestOf = values => known(values).length ? Math.max(...known(values)) : null;
/// [name, words, text] of the largest number of a column.
const largest = (table, name, title) => [name, title, `${number(largestOf(table[name].values))} ${unitText(table[name].unit.replace(/^1$/, ""))}`];

const addFatigue = () => {
  const p = data.patches, one = name => valueOf(data, name), count = p.p0_over_k.values.length;
  add("p", `${count} patches in ${one("cases")} cases: ${one("beyond_surface_limit")} beyond the shakedown limit of the surface, ` +
      `${one("beyond_limit_below")} others beyond that below it. One passage does a damage of ${number(one("damage"))} in the mean; a crack begins at 1.`,
      page, {id: `${idPrefix}fatigue-words`});
  addLarge([["damage", words("damage"), number(one("damage"))], largest(p, "p0_over_k", "largest p0 / k"), largest(p, "mu_used", "most friction used"),
            largest(p, "FI_surf", "largest FI_surf"), largest(p, "von_mises", words("von_mises")), largest(p, "T_gamma", "largest T-gamma")]);
  addFigure("shakedown", `Shakedown diagram, k = ${number(one("yield_shear"))} MPa. Above a limit the steel flows with every passage.`, shakedownFigure(data));
  addFigure("stress-depth", "Where the largest stress of each patch's case lies below the surface.", marksFigure(p, "von_mises_depth", "von_mises", RAIL));
  addColumns(p, ["case", "patch", "weight", "s", "Fn", "pmax", "p0_over_k", "p0_over_k_limit", "mu_used", "FI_surf", "T_gamma", "damage", "von_mises", "von_mises_depth"],
             "Patches", "fatigue-patches");
};

/// Stresses inside a body while a contact passes.
const addStresses = () => {
  const p = data.patches, text = (name, unit) => `${number(p[name].values[0], p[`${name}_error`]?.values[0])} ${unit}`, change = p.von_mises_change.values[0];
  addLarge([["von_mises", words("von_mises"), text("von_mises", "MPa")], ["depth", "its depth", text("von_mises_depth", "mm")],
            ["largest_shear", "largest shear stress", text("largest_shear", "MPa")], ["shear-depth", "its depth", text("largest_shear_depth", "mm")],
            ["mean", "hydrostatic stress there", text("mean_stress", "MPa")],
            change === null ? ["pmax", words("pmax"), text("pmax", "MPa")] : ["change", "more than a half-space", `${number(Number((100 * change).toFixed(1)))} %`]]);
  Object.entries(data.sections).filter(([, section]) => section.von_mises.shape.length === 2).forEach(([k, section]) => {
    const at = Number(k) - 1, place = {s: p.von_mises_s.values[at], depth: p.von_mises_depth.values[at]}, s = section.s.values;
    const nearest = s.reduce((best, value, i) => Math.abs(value - place.s) < Math.abs(s[best] - place.s) ? i : best, 0);
    addFigure(`von_mises-${k}`, `Patch ${k}: largest stress of von Mises while it passes. The cross is where it is largest.`, sectionMapFigure(section, "von_mises", "MPa", place));
    addFigure(`depth-${k}`, `Patch ${k}: largest stresses over the depth, below s = ${number(s[nearest])} mm.`,
              depthFigure(section, nearest, [["von_mises", "von Mises"], ["largest_shear", "largest shear"]]));
  });
  addColumns(p, ["s", "pmax", "von_mises", "von_mises_s", "von_mises_depth", "mean_stress", "largest_shear", "largest_shear_depth", "halfspace_von_mises", "halfspace_largest_shear",
                 "von_mises_change", "largest_shear_change"], "Patches", "stresses-patches");
};

/// What the passages of a contact do to the steel below it.
const addShakedown = () => {
  const p = data.patches, one = name => valueOf(data, name), largestPlaces = [["dang_van", "Dang Van, MPa"], ["residual_xx", "residual stress along the track at that limit, its deviator, MPa"]];
  const sections = Object.entries(data.sections ?? {}); // none of a load collective
  if (data.envelope)
    add("p", `Cases ${one("cases")}: ${data.attributes.in_words}.`, page, {id: `${idPrefix}shakedown-words`});
  sections.forEach(([k, section]) =>
    add("p", `Patch ${k}: the steel ${section.attributes.in_words}.`, page, {id: `${idPrefix}shakedown-words-${k}`}));
  addLarge([["shakedown", "shakedown factor, at least", number(Math.min(...p.shakedown.values))], ["shakedown_upper", "at most", number(Math.min(...p.shakedown_upper.values))],
            ["first_yield", "first yield, load factor", number(Math.min(...p.first_yield.values))], largest(p, "dang_van", "largest stress of Dang Van"),
            largest(p, "crossland", "largest stress of Crossland"), ["yield_shear", "yield stress in shear, k", `${number(one("yield_shear"))} MPa`]]);
  if (data.envelope) {
    addFigure("envelope", "Largest stress of Dang Van of all cases.", sectionMapFigure(data.envelope, "dang_van", "MPa", {s: one("dang_van_s"), depth: one("dang_van_depth")}));
    if (one("damage") > 0)
      addFigure("damage", "Damage of one passage, mean over the collective.", sectionMapFigure(data.envelope, "damage", "", {s: one("damage_s"), depth: one("damage_depth")}));
  }
  sections.forEach(([k, section]) => {
    const at = Number(k) - 1, place = {s: p.shakedown_s.values[at], depth: p.shakedown_depth.values[at]};
    addFigure(`limits-${k}`, `Patch ${k}: how large the load may be before no residual stress keeps a point elastic (1: the load of the scene). The cross is where the limit is decided.`,
              sectionMapFigure(section, "cycle", "load factor", place, 6));
    for (const [name, title] of largestPlaces)
      addFigure(`${name}-${k}`, `Patch ${k}: ${title}.`, sectionMapFigure(section, name, "MPa", null));
  });
  addColumns(p, ["s", "pmax", "first_yield", "shakedown", "shakedown_upper", "shakedown_s", "shakedown_depth", "p0_over_k_limit", "dang_van", "dang_van_depth", "crossland", "crossland_depth"],
             "Patches", "shakedown-patches");
};

const addConicityMap = () => {
  const {map} = data, names = ["wheels", "rails"].map(name => linesOf(data[name]).map(shortName)), tan = known(map.tan_gamma.values);
  addLarge([["pairs", "wheelsets", String(map.gauge.values.length)], ["least", "least tan γ", number(tan.length ? Math.min(...tan) : null)], largest(map, "tan_gamma", "largest tan γ"),
            ["play", "least play", `${number(known(map.play.values).length ? Math.min(...known(map.play.values)) : null)} mm`], largest(map, "nonlinearity", "largest nonlinearity"),
            map.tan_gamma_spread ? largest(map, "tan_gamma_spread", "largest spread of tan γ") : largest(map, "rail_travel", "largest travel on the rail")]);
  addFigure("map", "Equivalent conicity" + (map.tan_gamma_spread ? "; bars: its standard deviation by the scatter of the profiles" : "") + ".", mapFigure(data));
  addColumns(map, ["wheel", "rail", "gauge", "tan_gamma", "tan_gamma_mean", "tan_gamma_spread", "wavelength", "play", "rated_amplitude", "nonlinearity", "rail_travel", "wheel_travel"],
             "All wheelsets; – where no motion has this amplitude", "map-entries",
             {wheel: i => names[0][map.wheel.values[i]], rail: i => names[1][map.rail.values[i]]});
};

const addForceTable = () => {
  const names = Object.keys(data.values).filter(name => name !== "attributes"), share = name => 100 * valueOf(data.interpolation_error, name) / valueOf(data.scale, name);
  const held = (data.attributes.held ?? "").split(" ").filter(name => names.includes(name)), worst = Math.max(...held.map(share)), goal = 100 * valueOf(data, "tolerance");
  add("p", `A table of forces to look up: ${valueOf(data, "points")} points over ${data.attributes.axis_names.split(" ").map(words).join(", ")}. ` +
      `Between them it is at most ${number(Number(worst.toPrecision(2)))} % of a column's scale off a solution; ${number(goal)} % were asked for.`, page, {id: `${idPrefix}table-words`});
  addLarge([["points", "points", number(valueOf(data, "points"))], ["solved", "contact problems", number(valueOf(data, "solved"))], ["checked", "of them to measure the error", number(valueOf(data, "checked"))],
            ["worst", "largest error", `${number(Number(worst.toPrecision(2)))} %`], ["goal", "asked for", `${number(goal)} %`], ["axes", "axes", String(data.attributes.axis_names.split(" ").length)]]);
  addFigure("table-errors", "Largest interpolation error of each column; filled bars are held to the goal.", tableErrorFigure(data));
  for (const name of ["Fx", "Fy", "pmax"].filter(name => data.values[name])) {
    const figure = tableFigure(data, name);
    addFigure(`table-${name}`, `${words(name)[0].toUpperCase()}${words(name).slice(1)} in the table${figure?.rest ? `, at ${figure.rest}` : ""}.`, figure);
  }
  addTable("Columns", ["column", "interpolation", "by elements", "scale", "unit", ""], names.map(name =>
    [words(name), ...["interpolation_error", "element_error", "scale"].map(of => number(valueOf(data[of], name))), unitText(data.values[name].unit), data.values[name].description]),
    {numbers: [1, 2, 3], id: "table-columns"});
  addTable("Axes", ["axis", "points", "from", "to", "unit"], data.attributes.axis_names.split(" ").map(name => {
    const axis = data.axes[name];
    return [words(name), String(axis.values.length), number(Math.min(...axis.values)), number(Math.max(...axis.values)), unitText(axis.unit)];
  }), {numbers: [1, 2, 3], id: "table-axes"});
};

const addContactWear = () => {
  for (const [name, one] of data.rows ? [["", data]] : ["right", "left"].filter(side => data[side]).map(side => [side, data[side]])) {
    if (name)
      add("h2", titleOf(name));
    const there = Object.keys(one).filter(key => one[key].values?.length === 1), main = ["T_gamma", "wheel_depth_per_km", "wheel_area_per_km", "rail_depth_per_mgt", "rail_area_per_mgt", "axle_load"];
    addLarge(main.filter(key => there.includes(key)).map(key => [`${key}${name && `-${name}`}`, words(key).replaceAll("_", " "), `${number(one[key].values[0])} ${unitText(one[key].unit)}`]));
    addFigure(`worn-rows${name && `-${name}`}`, "What is worn off along the profile: wheel (left scale) and rail (right scale).", wornRowsFigure(one.rows));
    addTable("Numbers", ["", "value", "unit", ""], there.map(key => [words(key).replaceAll("_", " "), number(one[key].values[0]), unitText(one[key].unit), one[key].description]),
             {numbers: [1], id: `rates${name && `-${name}`}`});
  }
};

const addInfluenceFile = () => {
  const a = data.attributes, of = name => a[name] ?? valueOf(data, name), stations = rows(data.stations), error = of("estimated_error"), width = of("station_width");
  addLarge([["stations", "stations", String(stations.length)], ["width", "width of one", `${number(width)} mm`], ["from", "strip from s", `${number(stations[0][0] - width / 2)} mm`],
            ["to", "to", `${number(stations.at(-1)[0] + width / 2)} mm`], ["modulus", "shear modulus", `${number(of("shear_modulus"))} MPa`],
            ["error", "estimated error", error >= 0 ? `${number(Number((100 * error).toPrecision(2)))} %` : "not estimated"]]);
  addFigure("strip", "The strip of the surface for which it serves, in the section of the body.", stripFigure(stations, a.invariance === "prismatic" ? RAIL : WHEEL));
  addTable("What the file says", ["", ""], ["body", "profile", "held", "method", "invariance", "reference_radius", "half_period", "poisson", "betti_error", "reaction_error"].filter(name => of(name) !== undefined)
    .map(name => [name.replaceAll("_", " "), typeof of(name) === "number" ? number(of(name)) : of(name)]), {numbers: [], id: "influence-attributes"});
};

const GOOD_JACOBIAN = 0.3, USABLE_JACOBIAN = 0.1; // as bem_contact plot says it
const addMesh = () => {
  const points = rows(data.points), quads = rows(data.quads), worst = Math.min(...jacobiansOf(points, quads)), size = k => Math.max(...points.map(p => p[k])) - Math.min(...points.map(p => p[k]));
  const edges = name => data.edges[name] ? String(data.edges[name].shape[0]) : "0";
  addLarge([["quads", "quadrilaterals", String(quads.length)], ["worst", "worst scaled Jacobian", worst.toFixed(2)], ["strip", "edges on the strip", edges("contact")],
            ["held", "edges that are held", edges("held")], ["wide", "width", `${number(Number(size(0).toPrecision(4)))} mm`], ["high", "height", `${number(Number(size(1).toPrecision(4)))} mm`]]);
  addFigure("mesh", "The section and its elements.", meshFigure(data, false));
  addFigure("mesh-strip", "The elements at the strip.", meshFigure(data, true));
};

/// Tables of numbers that the file has, as [name, lines of cells]: single numbers of a group, or columns of one length.
const tablesIn = (group, name = "") => {
  const entries = Object.entries(group).filter(([key]) => key !== "attributes"), out = [];
  const single = entries.filter(([, one]) => one.values?.length === 1 && one.unit !== undefined);
  const columns = entries.filter(([, one]) => one.values?.length > 1 && one.shape?.length === 1);
  if (single.length)
    out.push([name || "numbers", [["name", "value", "unit", "meaning"], ...single.map(([key, one]) => [key, one.values[0], one.unit, one.description])]]);
  for (const length of new Set(columns.map(([, one]) => one.values.length))) {
    const same = columns.filter(([, one]) => one.values.length === length);
    out.push([name || "columns", [same.map(([key, one]) => withUnit(key, one)), ...Array.from({length}, (_, k) => same.map(([, one]) => one.values[k]))]]);
  }
  for (const [key, one] of entries)
    if (one && typeof one === "object" && !Array.isArray(one) && !("values" in one) && !("text" in one) && !["cases", "inputs"].includes(key))
      out.push(...tablesIn(one, name ? `${name}_${key}` : key));
  return out;
};

/// One button for each table; the file's own names and all digits.
const addDownloads = () => {
  const row = add("details", "", page, {className: "screen-only", id: "downloads"}), known = new Set();
  add("summary", "Numbers as CSV", row);
  for (const [name, lines] of ["profile", "mesh"].includes(report.kind) ? [] : tablesIn(data)) {
    let file = name;
    for (let k = 2; known.has(file); ++k)
      file = `${name}_${k}`;
    known.add(file);
    add("button", file.replaceAll("_", " "), row, {type: "button", onclick: () => download(new Blob([csvOf(lines)]), `${file}.csv`)});
  }
  row.hidden = !known.size;
};

const addScene = () => {
  for (const [name, title] of [["scene_text", "The scene as it was given"], ["scene_with_defaults", "The scene with every key"]])
    if (data[name]) {
      const fold = add("details", "", page, {id: name});
      add("summary", title, fold);
      add("pre", data[name].text, fold);
    }
};

const TITLE_OF = {result: "Contact of wheel and rail", comparison: "Comparison of models", sweep: "Sweep", "creep curves": "Creep curves",
                  conicity: "Conicity", wheelset: "Wheelset", wear: "Wear", profile: "Profile", study: "Study", fatigue: "Fatigue", stresses: "Stresses inside a body", shakedown: "Shakedown", table: "Table of forces",
                  "conicity map": "Conicities", "wear of one contact": "Wear", "influence file": "Influence functions", mesh: "Mesh of a body"};

const partsOf = study => Object.entries(study.parts).sort(([, a], [, b]) => a.study_order.values[0] - b.study_order.values[0]);

/// What was taken, which part said what, and the numbers that people look at first.
const addStudyHead = () => {
  addTable("What all answers rest on", ["key", "value", "unit", ""], Object.entries(data.taken).map(([key, {attributes: {value, unit, given}}]) =>
    [key, value, unitText(unit), given === 1 ? "given" : "by default"]), {numbers: [], id: "taken"});
  addTable("Parts", ["part", "", "s", "what went wrong"], partsOf(data).map(([name, part]) =>
    [`${name}: ${part.attributes.study_title}`, part.attributes.study_status, part.study_seconds.values[0].toFixed(1), part.study_errors.text]),
    {numbers: [2], id: "parts"});
  const names = linesOf(data.headline_names), units = linesOf(data.headline_units), meanings = linesOf(data.headline_meanings);
  const {value, element_error: elements, input_spread: inputs} = data.headline, drawn = inputs.values.some(v => v !== null);
  const spread = v => v === null ? "–" : number(Number(v.toPrecision(2)));
  addTable("Numbers, each with its error by the size of the elements" + (drawn ? " and its standard deviation by the inputs" : ""),
    ["part", "number", "value", "elements", ...(drawn ? ["inputs"] : []), "unit", ""], linesOf(data.headline_parts).slice(0, value.values.length).map((part, k) =>
      [part, names[k], number(value.values[k]), spread(elements.values[k]), ...(drawn ? [spread(inputs.values[k])] : []),
       units[k] === "1" ? "" : unitText(units[k]), meanings[k]]), {numbers: drawn ? [2, 3, 4] : [2, 3], id: "headline", wide: true});
};

const addStudy = () => {
  const study = data;
  addStudyHead();
  for (const [name, part] of partsOf(study)) {
    const {study_title: title, study_page: of, study_status: status} = part.attributes;
    add("h1", `${title}: ${status}`);
    if (part.attributes.study_about)
      add("p", `${part.attributes.study_about[0].toUpperCase()}${part.attributes.study_about.slice(1)}.`);
    if (part.study_errors.text)
      add("p", part.study_errors.text);
    if (of) {
      [data, report.kind, idPrefix] = [part, of, `${name}-`];
      add("p", inWords());
      ADDED[of]();
    }
  }
  [data, report.kind, idPrefix] = [study, "study", ""];
};

const ADDED = {result: addResult, comparison: addComparison, sweep: addSweep, "creep curves": addCreepCurves, conicity: addConicity, wheelset: addWheelset,
               wear: addWear, profile: addProfile, study: addStudy, fatigue: addFatigue, stresses: addStresses, shakedown: addShakedown, "conicity map": addConicityMap, table: addForceTable,
               "wear of one contact": addContactWear, "influence file": addInfluenceFile, mesh: addMesh};

/// What a page says before its numbers.
const inWords = () => {
  if (report.kind === "conicity map")
    return `Rigid wheelsets with ${linesOf(data.wheels).length} profiles of wheels on ${linesOf(data.rails).length} of rails. The equivalent conicity (EN 15302) is the slope ` +
           `of the cone with the same wavelength, for an amplitude of ${number(valueOf(data, "amplitude"))} mm.` + (!data.noise ? "" :
           ` The points of the profiles scatter by ${number(valueOf(data, "noise"))} mm in ${valueOf(data, "all_draws")} draws.`);
  if (report.kind === "stresses" || (report.kind === "shakedown" && !data.scene_text))
    return `${data.attributes.in_words[0].toUpperCase()}${data.attributes.in_words.slice(1)}.`;
  if (report.kind === "influence file")
    return `How the surface of ${data.attributes.body} moves under unit tractions on its strip, computed by finite elements (${data.attributes.method}).`;
  if (report.kind === "mesh") {
    const worst = Math.min(...jacobiansOf(rows(data.points), rows(data.quads)));
    return `A section in ${data.quads.shape[0]} quadrilaterals. Their quality is ${worst >= GOOD_JACOBIAN ? "good" : worst >= USABLE_JACOBIAN ? "usable" : "poor"}: the worst scaled ` +
           `Jacobian is ${worst.toFixed(2)}; a rectangle has 1.`;
  }
  return report.kind === "profile" ? data.attributes.words : sceneInWords().join(" ");
};

const start = async () => {
  document.title = `${report.file}: bem_contact report`;
  add("h1", `${TITLE_OF[report.kind]}: ${report.file}`);
  if (report.kind !== "study")
    add(report.kind === "profile" ? "pre" : "p", inWords(), page, {id: "words"});
  ADDED[report.kind]();
  addDownloads();
  addScene();
  add("p", `${data.attributes?.program ?? "bem_contact"}. x is the direction of rolling, y points to the right (left wheel: to the left), z down; s runs along the rail's ` +
      "profile, n into the rail. Forces are those on the rail. Figures: plotly.js (MIT licence), © Plotly, Inc.",
      document.getElementById("notes"));
  await loadLibrary();
  followWidth();
  for (const one of figures)
    if (!one[0].firstChild.data) // a printer may have been faster
      await draw(one);
  document.body.dataset.drawn = figures.length;
};
start().catch(failed);
