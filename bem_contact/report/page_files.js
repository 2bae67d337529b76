// Pages of tables to look up, profiles, influence files and meshes; what every page can save.
import {titleOf} from "./answers.js";
import {RAIL, WHEEL, rows} from "./contact_figures.js";
import {withUnit} from "./curve_figures.js";
import {add, addFigure, csvOf, download, page} from "./drawing.js";
import {correspondenceFigure, jacobiansOf, meshFigure, profilesFigure, stripFigure} from "./file_figures.js";
import {VIEWS, number, unitText, valueOf, valueText, withErrors, words} from "./numbers.js";
import {data, report} from "./shown.js";
import {addLarge, addTable, single} from "./tables.js";
import {tableErrorFigure, tableFigure, wornRowsFigure} from "./use_figures.js";

export const TABLE = {
  picture: () =>
      ["table-errors", "Largest interpolation error of each column; filled bars are held to the goal.",
       tableErrorFigure(data)],
  large: () => {
    const names = Object.keys(data.values).filter(name => name !== "attributes"),
          goal = 100 * valueOf(data, "tolerance");
    const share = name => 100 * valueOf(data.interpolation_error, name) / valueOf(data.scale, name);
    const held = (data.attributes.held ?? "").split(" ").filter(name => names.includes(name)),
          worst = Math.max(...held.map(share));
    addLarge([
      ["points", "points", number(valueOf(data, "points"))],
      ["solved", "contact problems", number(valueOf(data, "solved"))],
      ["checked", "of them to measure the error", number(valueOf(data, "checked"))],
      ["worst", "largest error", `${number(Number(worst.toPrecision(2)))} %`],
      ["goal", "asked for", `${number(goal)} %`], ["axes", "axes", String(data.attributes.axis_names.split(" ").length)]
    ]);
  },
  figures: () => {
    for (const name of VIEWS.table.figures.flat().filter(name => data.values[name])) {
      const figure = tableFigure(data, name);
      addFigure(
          `table-${name}`,
          `${words(name)[0].toUpperCase()}${words(name).slice(1)} in the table${
              figure?.rest ? `, at ${figure.rest}` : ""}.`,
          figure);
    }
  },
  tables: () => {
    const names = Object.keys(data.values).filter(name => name !== "attributes");
    addTable(
        "Columns", ["column", "interpolation", "by elements", "scale", "unit", ""],
        names.map(
            name =>
                [words(name),
                 ...["interpolation_error", "element_error", "scale"].map(of => number(valueOf(data[of], name))),
                 unitText(data.values[name].unit), data.values[name].description]),
        {numbers: [1, 2, 3], id: "table-columns"});
    addTable("Axes", ["axis", "points", "from", "to", "unit"], data.attributes.axis_names.split(" ").map(name => {
      const axis = data.axes[name];
      return [
        words(name), String(axis.values.length), number(Math.min(...axis.values)), number(Math.max(...axis.values)),
        unitText(axis.unit)
      ];
    }), {numbers: [1, 2, 3], id: "table-axes"});
  }
};

/// [side, group] of each wheel; "" of one that is alone.
/** @type {() => [string, any][]} */
const wornWheels = () =>
    data.rows ? [["", data]] : ["right", "left"].filter(side => data[side]).map(side => [side, data[side]]);
const wornId = (id, side) => `${id}${side && `-${side}`}`;
const wornRows = ([side, one]) =>
    [wornId("worn-rows", side),
     `${
         side ? `${titleOf(side)}. `
              : ""}What is worn off along the profile: wheel (left scale) and rail (right scale).`,
     wornRowsFigure(one.rows)];
const ratesOf = one => Object.keys(one).filter(key => one[key].values?.length === 1);
export const CONTACT_WEAR = {
  picture: () => wornRows(wornWheels()[0]),
  large: () => wornWheels().forEach(([side, one]) => {
    if (side)
      add("h3", titleOf(side));
    addLarge(VIEWS["wear of one contact"]
                 .columns.filter(key => one[key])
                 .map(key => single(key, undefined, one))
                 .map(([key, ...more]) => [wornId(key, side), ...more]));
  }),
  figures: () => wornWheels().slice(1).forEach(one => addFigure(...wornRows(one))),
  tables: () => wornWheels().forEach(
      ([side, one]) => addTable(
          side ? titleOf(side) : "Numbers", ["", "value", "unit", ""],
          ratesOf(one).map(
              key =>
                  [words(key).replaceAll("_", " "), valueText(one, key), unitText(one[key].unit),
                   one[key].description]),
          {numbers: [1], id: wornId("rates", side)}))
};

export const PROFILE = {
  picture: () => ["outline", "The profile; the others lie behind it.", profilesFigure(data.profiles, "z")],
  figures: () => addFigure(
      "curvature", "Curvature: above 0 convex, below concave.", profilesFigure(data.profiles, "curvature"), "wide")
};

/// Which points of sections correspond; nothing where there are no sections.
export const correspondence = () => data.section_lines ? [
  ["sections-above",
   "The sections from above (dark), and the lines along which they are joined (orange): lines run along an edge, and " +
       "none crosses over.",
   correspondenceFigure(data.section_lines, "y"), "wide"],
  ["sections-side", "The same from the side.", correspondenceFigure(data.section_lines, "z"), "wide"]
] : [];
export const SECTIONS = {
  picture: () => correspondence()[0].slice(0, 3), // beside the words, not wide
  figures: () => correspondence().slice(1).forEach(one => addFigure(...one))
};

const ofInfluence = name => data.attributes[name] ?? valueOf(data, name);
export const INFLUENCE_FILE = {
  picture: () =>
      ["strip", "The strip of the surface for which it serves, in the section of the body.",
       stripFigure(rows(data.stations), ofInfluence("invariance") === "prismatic" ? RAIL : WHEEL)],
  large: () => {
    const stations = rows(data.stations), error = ofInfluence("estimated_error"), width = ofInfluence("station_width");
    addLarge([
      ["stations", "stations", String(stations.length)], ["width", "width of one", `${number(width)} mm`],
      ["from", "strip from s", `${number(stations[0][0] - width / 2)} mm`],
      ["to", "to", `${number(stations.at(-1)[0] + width / 2)} mm`],
      ["modulus", "shear modulus", `${number(ofInfluence("shear_modulus"))} MPa`],
      ["error", "estimated error", error >= 0 ? `${number(Number((100 * error).toPrecision(2)))} %` : "not estimated"]
    ]);
  },
  tables: () => {
    const names = [
      "body", "profile", "held", "method", "invariance", "reference_radius", "half_period", "poisson", "betti_error",
      "reaction_error"
    ];
    addTable(
        "What the file says", ["", ""],
        names.filter(name => ofInfluence(name) !== undefined)
            .map(
                name =>
                    [name.replaceAll("_", " "),
                     typeof ofInfluence(name) === "number" ? number(ofInfluence(name)) : ofInfluence(name)]),
        {numbers: [], id: "influence-attributes"});
  }
};

export const GOOD_JACOBIAN = 0.3, USABLE_JACOBIAN = 0.1; // as bem_contact plot says it
export const worstJacobian = () => Math.min(...jacobiansOf(rows(data.points), rows(data.quads)));
export const MESH = {
  picture: () => ["mesh", "The section and its elements.", meshFigure(data, false)],
  large: () => {
    const points = rows(data.points),
          size = k => Math.max(...points.map(p => p[k])) - Math.min(...points.map(p => p[k]));
    const edges = name => data.edges[name] ? String(data.edges[name].shape[0]) : "0",
          length = k => `${number(Number(size(k).toPrecision(4)))} mm`;
    addLarge([
      ["quads", "quadrilaterals", String(data.quads.shape[0])],
      ["worst", "worst scaled Jacobian", worstJacobian().toFixed(2)], ["strip", "edges on the strip", edges("contact")],
      ["held", "edges that are held", edges("held")], ["wide", "width", length(0)], ["high", "height", length(1)]
    ]);
  },
  figures: () => addFigure("mesh-strip", "The elements at the strip.", meshFigure(data, true), "wide")
};

/// Tables of numbers that the file has, as [name, lines of cells]: single numbers of a group, or columns of one length.
const tablesIn = (group, name = "") => {
  const entries = Object.entries(group).filter(([key]) => key !== "attributes").flatMap(withErrors), out = [];
  const alone = entries.filter(([, one]) => one.values?.length === 1 && one.unit !== undefined);
  const columns = entries.filter(([, one]) => one.values?.length > 1 && one.shape?.length === 1);
  if (alone.length)
    out.push([
      name || "numbers",
      [
        ["name", "value", "unit", "meaning"],
        ...alone.map(([key, one]) => [key, one.values[0], one.unit, one.description])
      ]
    ]);
  for (const length of new Set(columns.map(([, one]) => one.values.length))) {
    const same = columns.filter(([, one]) => one.values.length === length);
    out.push([
      name || "columns",
      [
        same.map(([key, one]) => withUnit(key, one)),
        ...Array.from({length}, (_, k) => same.map(([, one]) => one.values[k]))
      ]
    ]);
  }
  for (const [key, one] of entries)
    if (one && typeof one === "object" && !Array.isArray(one) && !("values" in one) && !("text" in one) &&
        !["cases", "inputs"].includes(key))
      out.push(...tablesIn(one, name ? `${name}_${key}` : key));
  return out;
};

/// One button for each table; the file's own names and all digits.
export const addDownloads = () => {
  const row = add("details", "", page, {className: "screen-only", id: "downloads"}), taken = new Set();
  add("summary", "Numbers as CSV", row);
  for (const [name, lines] of ["profile", "sections", "mesh"].includes(report.kind) ? [] : tablesIn(data)) {
    let saved = name;
    for (let k = 2; taken.has(saved); ++k)
      saved = `${name}_${k}`;
    taken.add(saved);
    add("button", saved.replaceAll("_", " "), row,
        {type: "button", onclick: () => download(new Blob([csvOf(lines)]), `${saved}.csv`)});
  }
  row.hidden = !taken.size;
};
