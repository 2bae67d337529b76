// Writes the types of the npm package from what the solver answers: the names, kinds, units and meanings of its records.
//     node types.mjs PACKAGE SCENE.toml ... > PACKAGE/index.d.mts
// PACKAGE is the folder with solver.js. What only some scenes have may be undefined; a number that some answer does not
// have may be null.
import fs from "node:fs";
import {createRequire} from "node:module";
import path from "node:path";

const [folder, ...scenes] = process.argv.slice(2);
const {createSolver, answerTo, hold} = createRequire(path.resolve(folder) + "/")("./solver.js");
const solver = await createSolver({wasmBinary: fs.readFileSync(path.join(folder, "solver.wasm"))});
for (const name of fs.readdirSync(path.join(folder, "influence")))
  hold(solver, `../influence/${name}`, fs.readFileSync(path.join(folder, "influence", name)));
const ask = (what, question) => Buffer.from(answerTo(solver, what, JSON.stringify(question)).body).toString();

/// {seen, kinds: Set of "number", "string" ..., fields: {name: the same}, element: the same}
const nothing = () => ({seen: 0, kinds: new Set(), fields: new Map(), element: undefined});
const add = (type, value) => {
  ++type.seen;
  if (Array.isArray(value)) {
    type.kinds.add("array");
    type.element ??= nothing();
    value.forEach(one => add(type.element, one));
  } else if (value !== null && typeof value === "object") {
    type.kinds.add("object");
    for (const [name, inner] of Object.entries(value)) {
      if (!type.fields.has(name))
        type.fields.set(name, nothing());
      add(type.fields.get(name), inner);
    }
  } else
    type.kinds.add(value === null ? "null" : typeof value);
  return type;
};

/// {path: "MPa: largest pressure"} of a result that is described.
const meanings = new Map();
const describe = (described, at = "") => {
  if (described === null || typeof described !== "object")
    return;
  if ("description" in described && ("unit" in described || "text" in described)) {
    const {unit, description} = described;
    meanings.set(at, unit && unit !== "1" ? `${unit}: ${description}` : description);
    return;
  }
  for (const [name, inner] of Object.entries(described))
    if (name !== "attributes")
      describe(inner, at ? `${at}/${name}` : name);
};

const written = (type, at, indent) => {
  const parts = [];
  if (type.kinds.has("object")) {
    const inner = indent + "  ";
    const fields = [...type.fields].map(([name, field]) => {
      const place = at ? `${at}/${name}` : name, meaning = meanings.get(place);
      const key = /^[A-Za-z_]\w*$/.test(name) ? name : JSON.stringify(name);
      return `${meaning ? `${inner}/** ${meaning.replaceAll("*/", "* /")} */\n` : ""}${inner}${key}${
        field.seen < type.seen ? "?" : ""}: ${name === "units" && !at ? "Record<string, string>" : written(field, place, inner)};\n`;
    });
    parts.push(`{\n${fields.join("")}${indent}}`);
  }
  if (type.kinds.has("array")) {
    const element = type.element.seen ? written(type.element, at, indent) : "never";
    parts.push(/ \| /.test(element.split("{")[0]) ? `(${element})[]` : `${element}[]`);
  }
  for (const kind of ["boolean", "number", "string", "null"])
    if (type.kinds.has(kind))
      parts.push(kind);
  return parts.join(" | ");
};

const results = nothing(), wheelsets = nothing();
for (const scene of scenes) {
  const question = {text: fs.readFileSync(scene, "utf8"), files: {}};
  for (const named of JSON.parse(ask("names", question)).files ?? [])
    if (!named.influence)
      question.files[named.name] = fs.readFileSync(path.join(path.dirname(scene), named.name), "utf8");
  const answers = ["numbers", "fields"].map(what => JSON.parse(ask(what, question)));
  if (answers[0].problem) {
    console.error(`${scene}: ${answers[0].problem.message}`);
    continue;
  }
  answers.forEach(answer => add(answer.wheelset ? wheelsets : results, answer));
  describe(JSON.parse(ask("described", question)));
}
if (results.seen === 0 || wheelsets.seen === 0)
  throw new Error("No scene of one kind was solved (its types are made from an answer) Name a scene of each kind.");

process.stdout.write(`// Made from what the solver answers (bem_contact/browser/types.mjs). Units are mm, N, MPa, rad.

/** Of a scene. Fields are there with the option \`fields\`. */
export interface Result ${written(results, "", "")}

/** Of a scene with \`wheelset.force\`. */
export interface WheelsetResult ${written(wheelsets, "", "")}

export interface Options {
  /** Values in place of the scene's: {"load.force": 8e4} */
  changes?: Record<string, number | boolean | string>;
  /** Text files that the scene names, such as profiles. */
  files?: Record<string, string>;
  /** Influence files that the scene names, in flat form; those of influence/ are in this package. */
  influence?: Record<string, Uint8Array>;
  /** Also what lies on the grid: coordinates, tractions ... */
  fields?: boolean;
}

/** Why a scene has no result. */
export declare class ContactError extends Error {
  kind: "refused" | "not certified" | "died" | "failed";
}

/** Solves a scene, the text of its TOML file. Throws ContactError. */
export declare function solve<R extends Result | WheelsetResult = Result>(scene: string, options?: Options): Promise<R>;
`);
