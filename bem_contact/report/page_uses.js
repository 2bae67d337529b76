// Pages of what follows from contacts.
import {namesIn, titleOf} from "./answers.js";
import {contactOf, patchFigure} from "./contact_figures.js";
import {
  TIME, creepFigure, keyText, leadingKey, measuredPressuresFigure, passageFigure, passageSideFigure, patchesFigure,
  sweepFigure, sweptKeys, withUnit
} from "./curve_figures.js";
import {add, addFigure, draw, idPrefix, into} from "./drawing.js";
import {
  VIEWS, entryText, hasBothWheels, inDegrees, known, linesOf, number, quantityOf, sentenceText, shortName, unitText,
  valueOf, words
} from "./numbers.js";
import {correspondence} from "./page_files.js";
import {data, report} from "./shown.js";
import {addColumns, addLarge, addTable, largest} from "./tables.js";
import {
  conicityFigure, filmFigure, mapFigure, radiusFigure, touchFigure, wearFigure, wornFigure
} from "./use_figures.js";

/// Where a click on a mark of a sweep shows the patch of its case. Undefined where the page has no fields.
const addCaseView = () => {
  const own = data; // of a study, the part that is added now
  const cases = Object.fromEntries(
      Object.entries(own.cases ?? {}).filter(([, one]) => one.p_n).map(([name, one]) => [Number(name), one]));
  if (!Object.keys(cases).length)
    return undefined;
  const block = add("div", "", into, {id: `${idPrefix}case`, className: "screen-only"}),
        frame = add("div", "", block, {id: `${idPrefix}case-patch`});
  add("div", "", frame, {className: "drawing"});
  const line = add("p", "A click on a mark shows the patch of its case here.", block, {className: "caption"});
  const shown = Object.keys(cases).map(Number);
  if (alongTrack() && shown.length > 1) { // a film of the passage
    const film = add("input", "", block, {
      type: "range", id: `${idPrefix}film`, min: 0, max: shown.length - 1, value: 0, ariaLabel: "place of the patch"
    });
    film.addEventListener("input", () => showCase?.(shown[Number(film.value)]));
    line.textContent = "Move the slider, or click on a mark: the patch of that place is shown here.";
  }
  return async index => {
    if (!cases[index])
      return void (line.textContent = `Case ${index} has no patch.`);
    const contact = contactOf(cases[index].attributes.model, cases[index]), figure = patchFigure(contact);
    const where =
        sweptKeys(own)
            .map(
                key => `${words(key)} ${keyText(own[key], index)} ${unitText(own[key].unit.replace(/^1$/, ""))}`.trim())
            .join(", ");
    line.textContent = `Case ${index}: ${where}; ${titleOf(contact.name).toLowerCase()}, largest pressure ` +
        `${own.pmax ? entryText(own.pmax, index) : number()} MPa.` +
        (figure ? "" : " Nothing is in contact.");
    frame.className = figure ? "figure" : "";
    frame.hidden = !figure;
    if (figure)
      await draw([frame, figure]);
  };
};

const variedKeys = () => sweptKeys(data).filter(k => new Set(data[k].values).size > 1);
const ofWheelsets = () => hasBothWheels(data);
const isReplay = () => "solved" in data; // of a vehicle program's run
const alongTrack = () => variedKeys().includes("position.along") && "vertical" in data;
const sweepKind = () => ofWheelsets() ? "sweep of wheelsets" : alongTrack() ? "sweep along the track" : "sweep";
const sweepViews = () => VIEWS[isReplay() ? "replay" : sweepKind()];
/// Both wheels' columns of a name; itself where both have one.
const ofWheels = name => name in data ? [name] : ["right", "left"].flatMap(
  side => Object.keys(data).filter(column => data[column]?.role === side && data[column].of === name));
let showCase; // of the sweep that is added

const sweepFigures = () => {
  const keys = isReplay() ? [] : variedKeys(), click = index => showCase?.(index), out = [];
  const key = isReplay() && TIME in data ? TIME : leadingKey(data, keys);
  if (!ofWheelsets() && !isReplay() && data.patches?.y.values.some(y => y !== null))
    out.push([
      "patches-over-y",
      "Where the patches lie on the rail: each bar is as wide as its patch; larger marks carry larger normal forces, " +
          "darker ones larger pressures.",
      {...patchesFigure(data, key), click}
    ]);
  if (out.length && alongTrack() && key === "position.along") {
    out.push(["passage-above",
              "The passage from above: each patch as an ellipse of its size, where it lies along the track. " +
                  "The darker, the larger its pressure.",
              {...passageFigure(data), click}, "wide"]);
    out.push(["passage-side",
              "The passage from the side: how the wheel's centre sinks and rises, and where it stands; " +
                  "larger marks carry larger normal forces.",
              {...passageSideFigure(data), click}, "wide"]);
  }
  for (const names of sweepViews()
           .figures.filter(([name]) => key !== `position.${name}`)
           .map(names => isReplay() ? names.filter(name => name in data) : names.flatMap(ofWheels)))
    if (names.length && names.every(name => name in data))
      out.push([
        `over-${names.join("-")}`,
        `${[...new Set(names.map(name => quantityOf(data, name)))].map(words).join(" and ")} over the ${
          key ? words(key) : "cases"}.`,
        {...sweepFigure(data, keys, key, names), click}
      ]);
  return out;
};

export const SWEEP = {
  picture: () => sweepFigures()[0],
  figures: () => {
    showCase = ofWheelsets() ? undefined : addCaseView();
    for (const figure of [...sweepFigures().slice(1), ...correspondence()])
      addFigure(...figure);
  },
  tables: () => {
    const keys = isReplay() ? [TIME].filter(name => name in data) : variedKeys();
    const columns = sweepViews().columns.flatMap(ofWheels).filter(name => name in data);
    const cell = (name, i) => inDegrees(entryText(data[name], i), data[name].values[i], data[name].unit);
    addTable(
        "All cases",
        [
          "case", ...keys.map(k => withUnit(k, data[k]).replace(".", ".\u200b")),
          ...columns.map(name => withUnit(name, data[name])), "status"
        ],
        data.status.values.map(
            (state, i) =>
                [i, ...keys.map(k => keyText(data[k], i)), ...columns.map(name => cell(name, i)),
                 data.status.choices[state]]),
        {id: "cases", wide: true});
    for (const [name, one] of Object.entries(data.cases ?? {}))
      if (one.attributes?.reason)
        add("p", `Case ${Number(name)}: ${one.attributes.reason}`);
  }};

/// What was measured, point by point, beside what is computed there.
const addMeasured = (measured, id = "measured") => {
  if (!measured)
    return;
  const {points, attributes: {force, creepage}} = measured, unit = unitText(points.measured.unit),
                                     column = name => points[name].values;
  const share = i => Math.abs(column("measured")[i]) > 0
      ? `${(100 * column("difference")[i] / Math.abs(column("measured")[i])).toFixed(1)} %`
      : "–";
  const scatter = points.scatter ? [`scatter, ${unit}`] : [];
  add("h2", "Beside what was measured");
  add("p",
      `Over the ${words(creepage)}, ${force} as computed less ${force} as measured is ${
          number(valueOf(measured, "mean_difference"))} ${unit} in the mean and ` +
          `${number(valueOf(measured, "largest_difference"))} ${unit} at most` +
          (points.scatter ? `; ${valueOf(measured, "within_scatter")} of ${
                                column("creepage").length} points lie within the scatter of what was measured.`
                          : "."));
  addTable(
      `${force} as measured and as computed`,
      [creepage, `measured, ${unit}`, ...scatter, `computed, ${unit}`, "difference", "of the measured one"],
      column("creepage")
          .map(
              (at, i) =>
                  [number(at), number(column("measured")[i]), ...scatter.map(() => number(column("scatter")[i])),
                   entryText(points.computed, i), number(column("difference")[i]),
                   share(i)]),
      {numbers: [0, 1, 2, 3, 4, 5], id});
};

/// What was measured beside what is computed; a fit has several. `over`: "creepage" for forces, "over" for pressures.
const measuredOver = over =>
  Object.keys(data).filter(key => data[key].points?.measured && data[key].attributes?.[over]);

/// A line of pressures as measured and as computed.
const addPressures = (line, id) => {
  const {points, attributes: {over}} = line, column = name => points[name].values;
  add("h2", "Pressures beside what was measured");
  add("p",
      `Computed less measured pressures are ${number(valueOf(line, "mean_difference"))} MPa in the mean and ` +
          `${number(valueOf(line, "largest_difference"))} MPa at most.`);
  addTable("Pressures as measured and as computed", [`${over}, mm`, "measured, MPa", "computed, MPa", "difference"],
           column(over).map((at, i) => [number(at), ...["measured", "computed", "difference"].map(
               name => number(column(name)[i]))]),
           {numbers: [0, 1, 2, 3], id});
};

const CREEP_CAPTION = "; the other two creepages stay as in the scene. With little creepage a force grows along the " +
  "straight line of linear theory, which takes the other two into account; with much of it the whole contact slips, " +
  "and the force stays within the bound of friction.";
const creepFigures = () => ["xi", "eta", "phi"].filter(which => data.curves?.[which]).map(which =>
  [`curve-${which}`, `Forces over the ${words(which)}${CREEP_CAPTION}`, creepFigure(data, which)]);

const pressureFigures = () => measuredOver("over").map(key =>
  [`${key}-figure`, `Pressures over ${data[key].attributes.over}, as measured and as computed.`,
   measuredPressuresFigure(data[key])]);
const curveFigures = () => [...creepFigures(), ...pressureFigures()];

export const CREEP_CURVES = {
  picture: () => curveFigures()[0],
  warnings: () => [["", {group: data}]],
  figures: () => curveFigures().slice(1).forEach(one => addFigure(...one)),
  tables: () => {
    measuredOver("creepage").forEach(key => addMeasured(data[key], key));
    measuredOver("over").forEach(key => addPressures(data[key], key));
    const matrix = (name, caption) =>
        data[name] &&
        addTable(
            caption, ["", "d/dxi", "d/deta", "d/dphi"],
            ["Fx", "Fs", "Mz"].map(
                (force, row) =>
                    [force, ...[0, 1, 2].map(k => entryText(data[name], 3 * row + k))]),
            {numbers: [1, 2, 3], id: name});
    matrix("slopes", "Slopes where nothing moves over the other (N; Mz: N mm; by phi: times mm)");
    matrix("kalker", "The same by Kalker's linear theory, for the nearest ellipse");
    matrix("sensitivities", "Sensitivities at the scene's creepages");
  }};

/// The keys that were fitted, with their intervals, and how they hang together.
export const FIT = {
  ...CREEP_CURVES,
  tables: () => {
    const names = namesIn(data.parameters);
    const numberOf = (name, entry) => number(valueOf(data.parameters[name], entry));
    add("h2", "What was fitted");
    addTable(
        "Keys of the scene, with intervals of 95 %", ["key", "first guess", "found", "from", "to", "unit"],
        names.map(name => [name, ...["start", "value", "low", "high"].map(entry => numberOf(name, entry)),
                           unitText(data.parameters[name].value.unit)]),
        {numbers: [1, 2, 3, 4], id: "parameters"});
    if (names.length > 1)
      addTable("Correlation of what was found", ["", ...names],
               names.map((name, row) => [name, ...names.map((_, k) =>
                 data.correlation.values[names.length * row + k].toFixed(3))]),
               {numbers: names.map((_, k) => k + 1), id: "correlation"});
    for (const text of linesOf(data.not_determined ?? {text: ""}).filter(text => text))
      add("p", sentenceText(text));
    CREEP_CURVES.tables();
  }};

/// Of rail and wheel, if their profiles lie beside the file; else how deep both are by and by.
const wearFigures = () => {
  const out = [];
  for (const body of report.steps.length > 1 ? ["rail", "wheel"] : [])
    if (data[`${body}_depth`].values.at(-1) > 0)
      out.push([`worn-${body}`, `What is gone from the ${body}, by step.`, wornFigure(report.steps, data, body)], [
        `film-${body}`, `The ${body} from step to step. On a screen: move the slider, or play.`,
        filmFigure(report.steps, data, body)
      ]);
  return [...out, ["wear-depth", "Depth of the deepest place.", wearFigure(data, "depth", "mm")],
          ["wear-area", "Area gone from the sections.", wearFigure(data, "area", "mm²")]];
};
export const WEAR = {
  picture: () => wearFigures()[0],
  figures: () => wearFigures().slice(1).forEach(one => addFigure(...one)),
  tables: () => addTable(
      "By step", ["step", ...VIEWS.wear.columns.map(name => withUnit(name.replace("_", " "), data[name]))],
      data.step.values.map((step, i) => [step, ...VIEWS.wear.columns.map(name => number(data[name].values[i]))]),
      {id: "steps", wide: true})
};

export const CONICITY = {
  picture: () => ["tan-gamma", "Equivalent conicity over the amplitude.", conicityFigure(data)],
  figures: () => {
    addFigure("radius-difference", "Rolling radius difference.", radiusFigure(data));
    for (const body of ["wheel", "rail"])
      addFigure(
          `touch-${body}`, `Where both wheels touch, on the ${body}; a gap is a jump of the contact.`,
          touchFigure(data, body));
  },
  tables: () => {
    const c = data.conicity, names = VIEWS.conicity.columns, isWhole = i => Math.abs(c.amplitude.values[i] % 1) < 1e-9;
    addTable(
        "Equivalent conicity (EN 15302); – where no motion has this amplitude",
        names.map(name => withUnit(name.replace("_", " "), c[name])),
        c.amplitude.values.map((_, i) => i)
            .filter((i, _, all) => all.length <= 20 || isWhole(i))
            .map(i => names.map(name => number(c[name].values[i]))),
        {id: "conicities"});
  }};

export const CONICITY_MAP = {
  picture: () =>
      ["map",
       "Equivalent conicity" +
           (data.map.tan_gamma_spread ? "; bars: its standard deviation by the scatter of the profiles" : "") + ".",
       mapFigure(data)],
  large: () => {
    const {map} = data,
          least = name => number(known(map[name].values).length ? Math.min(...known(map[name].values)) : null);
    addLarge([
      ["pairs", "wheelsets", String(map.gauge.values.length)], ["least", "least tan γ", least("tan_gamma")],
      largest(map, "tan_gamma", "largest tan γ"), ["play", "least play", `${least("play")} mm`],
      largest(map, "nonlinearity", "largest nonlinearity"),
      map.tan_gamma_spread ? largest(map, "tan_gamma_spread", "largest spread of tan γ")
                           : largest(map, "rail_travel", "largest travel on the rail")
    ]);
  },
  tables: () => {
    const {map} = data, names = ["wheels", "rails"].map(name => linesOf(data[name]).map(shortName));
    addColumns(map, VIEWS["conicity map"].columns, "All wheelsets; – where no motion has this amplitude",
               "map-entries", {wheel: i => names[0][map.wheel.values[i]], rail: i => names[1][map.rail.values[i]]});
  }
};
