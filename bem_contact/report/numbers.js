// Numbers and names as people read them.
import {views, words as names} from "../record/words.json";

export const LEAST_NUMBER = 1e-8; // in every unit of a page (mm, rad, MPa, N, N mm) less is rounding
const DIGITS = 5; // of a number without a known error

/// "2630 ± 32" or "(-9.27 ± 0.13)e-4": value and error, rounded to two digits of the error, as record::rounded().
export const number = (value, error) => {
  if (value === null || value === undefined)
    return "–";
  if (Math.abs(value) < LEAST_NUMBER)
    value = 0;
  if (!(error > LEAST_NUMBER * Math.max(1, Math.abs(value))))
    return Math.abs(value) < 1e-3 && value !== 0 ? value.toExponential(3) : String(Number(value.toPrecision(DIGITS)));
  const size = Math.max(Math.abs(value), error);
  if (value !== 0 && size < 0.01) {
    const power = Math.floor(Math.log10(size)), scale = 10 ** power;
    return `(${number(value / scale, error / scale)})e${power}`;
  }
  const decimals = 1 - Math.floor(Math.log10(error)), unit = 10 ** -Math.min(0, decimals);
  const rounded = of => decimals > 0 ? of.toFixed(Math.min(12, decimals)) : String(unit * Math.round(of / unit) || 0);
  return `${rounded(value)} ±\u00a0${rounded(error)}`;
};

/// An angle in degrees behind what is written in rad.
export const inDegrees = (text, value, unit) => unit === "rad" && value !== null && value !== undefined
    ? `${text} (${number(Number((value * 180 / Math.PI).toPrecision(3)))}°)` : text;

/// "mm2" as people write it.
export const unitText = unit => unit.replace(/mm\^?2/g, "mm²").replace(/mm\^?3/g, "mm³").replace("N mm", "N\u00a0mm");
/// A sentence of the program (record/found.hpp) with the signs of print.
export const sentenceText = text => unitText(text).replaceAll(" +- ", " ±\u00a0");

/// Names of the files as people read them (record/words.json); a name that is not there stands as it is.
export const words = name => names[name] ?? name;
/// The quantity that a column is of: "Fy" of "right_Fy" and of "Fy_of_run".
export const quantityOf = (data, name) => data[name]?.of ?? name;
/// Whether a sweep has columns of both wheels.
export const hasBothWheels = data => Object.values(data).some(one => one?.role === "right");

/// The lines of a text.
export const linesOf = texts => texts.text.split("\n");
/// The name of a file without its folders.
export const shortName = name => name.split("/").pop();

/// A number of a group; undefined where it has none.
export const valueOf = (group, name) => group?.[name]?.values?.[0];
export const errorOf = (group, name) => group?.[name]?.errors?.[0];
/// "2630 ± 32" of an entry of a column.
export const entryText = (column, i) => number(column.values[i], column.errors?.[i]);
/// "2630 ± 32" of a group's number.
export const valueText = (group, name) => number(valueOf(group, name), errorOf(group, name));

/// [name, numbers] of an entry, and of its errors as files have them.
export const withErrors = ([name, one]) => {
  const description = "estimated error by the size of the elements";
  return one.errors ? [[name, one], [`${name}_error`, {...one, values: one.errors, description}]] : [[name, one]];
};

/// What each kind of answer shows: its prominent numbers, columns of tables, figures (record/words.json).
export const VIEWS = views;
/// Those numbers of a view that a group has. `rank`: "headline" (in large figures), "main" (in the first table).
export const ranked = (group, view, rank) => VIEWS[view][rank].filter(name => group[name]);

export const known = values => values.filter(value => value !== null);
export const largestOf = values => known(values).length ? Math.max(...known(values)) : null;
