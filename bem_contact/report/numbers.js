// Numbers and names as people read them.
const LEAST_NUMBER = 1e-8; // in every unit of a page (mm, rad, MPa, N, N mm) less is rounding
const DIGITS = 5; // of a number without a known error

/// "2630 ± 32" or "(-9.27 ± 0.13)e-4": value and error, rounded to two digits of the error, as record::rounded().
const number = (value, error) => {
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
const inDegrees = (text, value, unit) => unit === "rad" && value !== null && value !== undefined
    ? `${text} (${number(Number((value * 180 / Math.PI).toPrecision(3)))}°)` : text;

/// "mm2" as people write it.
const unitText = unit => unit.replace(/mm\^?2/g, "mm²").replace(/mm\^?3/g, "mm³").replace("N mm", "N\u00a0mm");
/// A sentence of the program (record/found.hpp) with the signs of print.
const sentenceText = text => unitText(text).replaceAll(" +- ", " ±\u00a0");

/// Names of the files as people read them (record/words.json); a name that is not there stands as it is.
const WORDS = SHARED.words;
const ofEither = name => name.replace(/^(right|left)_/, ""); // wheel
const words = name =>
    WORDS[name] ?? (ofEither(name) === name ? name : `${words(ofEither(name))}, ${name.split("_")[0]} wheel`);

/// The lines of a text.
const linesOf = texts => texts.text.split("\n");
/// The name of a file without its folders.
const shortName = name => name.split("/").pop();

/// A number of a group; undefined where it has none.
const valueOf = (group, name) => group?.[name]?.values?.[0];
const errorOf = (group, name) => group?.[name]?.errors?.[0];
/// "2630 ± 32" of an entry of a column.
const entryText = (column, i) => number(column.values[i], column.errors?.[i]);
/// "2630 ± 32" of a group's number.
const valueText = (group, name) => number(valueOf(group, name), errorOf(group, name));

/// [name, numbers] of an entry, and of its errors as files have them.
const withErrors = ([name, one]) => {
  const description = "estimated error by the size of the elements";
  return one.errors ? [[name, one], [`${name}_error`, {...one, values: one.errors, description}]] : [[name, one]];
};

/// What each kind of answer shows: its prominent numbers, columns of tables, figures (record/words.json).
const VIEWS = SHARED.views;
/// Those numbers of a view that a group has. `rank`: "headline" (in large figures), "main" (in the first table).
const ranked = (group, view, rank) => VIEWS[view][rank].filter(name => group[name]);

const known = values => values.filter(value => value !== null);
const largestOf = values => known(values).length ? Math.max(...known(values)) : null;
