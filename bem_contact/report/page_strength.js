// Pages of what contacts do to the steel: fatigue, shakedown, stresses.
import {RAIL} from "./contact_figures.js";
import {add, addFigure, idPrefix, into} from "./drawing.js";
import {VIEWS, number, valueOf, valueText, words} from "./numbers.js";
import {data} from "./shown.js";
import {addColumns, addLarge, largest, single} from "./tables.js";
import {depthFigure, marksFigure, sectionMapFigure, shakedownFigure} from "./use_figures.js";

export const FATIGUE = {
  picture: () =>
      ["shakedown",
       `Shakedown diagram, k = ${
           number(valueOf(data, "yield_shear"))} MPa. Above a limit the steel flows with every passage.`,
       shakedownFigure(data)],
  large: () => {
    const p = data.patches;
    addLarge([
      single("damage", words("damage")), largest(p, "p0_over_k", "largest p0 / k"),
      largest(p, "mu_used", "most friction used"), largest(p, "FI_surf", "largest FI_surf"),
      largest(p, "von_mises", words("von_mises")), largest(p, "T_gamma", "largest T-gamma")
    ]);
  },
  figures: () => addFigure(
      "stress-depth", "Where the largest stress of each patch's case lies below the surface.",
      marksFigure(data.patches, "von_mises_depth", "von_mises", RAIL)),
  tables: () => addColumns(data.patches, VIEWS.fatigue.columns, "Patches", "fatigue-patches")
};

/// What the passages of a contact do to the steel below it.
const limitsFigure = k => {
  const at = Number(k) - 1,
        place = {s: data.patches.shakedown_s.values[at], depth: data.patches.shakedown_depth.values[at]};
  return [
    `limits-${k}`,
    `Patch ${
        k}: how large the load may be before no residual stress keeps a point elastic (1: the load of the scene). ` +
        "The cross is where the limit is decided.",
    sectionMapFigure(data.sections[k], "cycle", "load factor", place, 6)
  ];
};
const envelopeFigure = () => {
  const place = {s: valueOf(data, "dang_van_s"), depth: valueOf(data, "dang_van_depth")};
  return ["envelope", "Largest stress of Dang Van of all cases. The cross is where it is largest.",
          sectionMapFigure(data.envelope, "dang_van", "MPa", place)];
};
const sectionsOf = () => Object.entries(data.sections ?? {}); // none of a load collective
export const SHAKEDOWN = {
  picture: () => data.envelope ? envelopeFigure() : sectionsOf().slice(0, 1).map(([k]) => limitsFigure(k))[0],
  large: () => {
    const p = data.patches, least = name => number(Math.min(...p[name].values));
    addLarge([
      ["shakedown", "shakedown factor, at least", least("shakedown")],
      ["shakedown_upper", "at most", least("shakedown_upper")],
      ["first_yield", "first yield, load factor", least("first_yield")],
      largest(p, "dang_van", "largest stress of Dang Van below the surface"),
      largest(p, "crossland", "largest stress of Crossland below the surface"),
      single("yield_shear", "yield stress in shear, k")
    ]);
  },
  figures: () => {
    if (data.envelope && valueOf(data, "damage") > 0)
      addFigure("damage", "Damage of one passage, mean over the collective.",
                sectionMapFigure(data.envelope, "damage", "",
                                 {s: valueOf(data, "damage_s"), depth: valueOf(data, "damage_depth")}));
    sectionsOf().forEach(([k, section], at) => {
      if (at > 0)
        addFigure(...limitsFigure(k));
      for (const [name, title] of [
               ["dang_van", "Dang Van, MPa"],
               ["residual_xx", "residual stress along the track at that limit, its deviator, MPa"]])
        addFigure(`${name}-${k}`, `Patch ${k}: ${title}.`, sectionMapFigure(section, name, "MPa", null));
    });
  },
  tables: () => {
    for (const [k, section] of sectionsOf())
      add("p", `Patch ${k}: the steel ${section.attributes.in_words}.`, into, {id: `${idPrefix}shakedown-words-${k}`});
    addColumns(data.patches, VIEWS.shakedown.columns, "Patches", "shakedown-patches");
  }};

/// Stresses inside a body while a contact passes.
const mapsOfStresses = () => sectionsOf().filter(([, section]) => section.von_mises.shape.length === 2);
const stressMap = ([k, section]) => {
  const at = Number(k) - 1, p = data.patches,
        place = {s: p.von_mises_s.values[at], depth: p.von_mises_depth.values[at]};
  return [
    `von_mises-${k}`, `Patch ${k}: largest stress of von Mises while it passes. The cross is where it is largest.`,
    sectionMapFigure(section, "von_mises", "MPa", place)
  ];
};
export const STRESSES = {
  picture: () => mapsOfStresses().slice(0, 1).map(stressMap)[0],
  large: () => {
    const p = data.patches, change = p.von_mises_change.values[0];
    const text = (name, unit) => `${valueText(p, name)} ${unit}`;
    addLarge([
      ["von_mises", words("von_mises"), text("von_mises", "MPa")],
      ["depth", "its depth", text("von_mises_depth", "mm")],
      ["largest_shear", "largest shear stress", text("largest_shear", "MPa")],
      ["shear-depth", "its depth", text("largest_shear_depth", "mm")],
      ["mean", "hydrostatic stress there", text("mean_stress", "MPa")],
      change === null ? ["pmax", words("pmax"), text("pmax", "MPa")]
                      : ["change", "more than a half-space", `${number(Number((100 * change).toFixed(1)))} %`]
    ]);
  },
  figures: () => mapsOfStresses().forEach((one, first) => {
    const [k, section] = one, s = section.s.values, place = data.patches.von_mises_s.values[Number(k) - 1];
    const nearest = s.reduce((best, value, i) => Math.abs(value - place) < Math.abs(s[best] - place) ? i : best, 0);
    if (first > 0)
      addFigure(...stressMap(one));
    addFigure(`depth-${k}`, `Patch ${k}: largest stresses over the depth, below s = ${number(s[nearest])} mm.`,
              depthFigure(section, nearest, [["von_mises", "von Mises"], ["largest_shear", "largest shear"]]));
  }),
  tables: () => addColumns(data.patches, VIEWS.stresses.columns, "Patches", "stresses-patches")};
