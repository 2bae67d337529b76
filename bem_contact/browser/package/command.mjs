#!/usr/bin/env node
// conformal-contact solve SCENE.toml
import {existsSync, readFileSync, statSync} from "node:fs";
import path from "node:path";
import {parseArgs} from "node:util";
import {solve} from "./node.mjs";

const HELP = `Solves a wheel-rail contact, as bem_contact solve does.
    npx conformal-contact solve SCENE.toml [--json] [--fields] [--model NAME]
--json     every number of the result, with its error and unit
--fields   and what lies on the grid: coordinates, tractions ... (needs --json)
--model    "halfspace", "tangent_plane", "fem" ..., in place of the scene's
A first scene: rail.profile = "60E1", wheel.profile = "S1002", load.force = 8e4, a line each.

Units are mm, N, MPa, rad. Exit code 0: the certificate holds. 2: the input is wrong. 3: the solver did not converge, or
the certificate does not hold. 1: an unforeseen error.
`;
const wrong_input = 2, no_convergence = 3;

/// The files that the scene names: every text of it that is a file, seen from its folder. FILE#2 is a part of FILE.
const filesOf = (scene, folder) => {
  const files = {}, influence = {};
  for (const [, double, single] of scene.matchAll(/"([^"\n]+)"|'([^'\n]+)'/g)) {
    const text = double === undefined ? single : double.replaceAll("\\\\", "\\");
    for (const name of new Set([text, text.replace(/#[^#]*$/, "")])) {
      const file = path.resolve(folder, name);
      if (!existsSync(file) || !statSync(file).isFile())
        continue;
      if (name.endsWith(".h5"))
        influence[name] = readFileSync(file);
      else
        files[name] = readFileSync(file, "utf8");
    }
  }
  return {files, influence};
};

const numberText = value => value === null || value === undefined ? "-" : String(+value.toPrecision(7));

/// What was found in sentences, and each number with its error and unit; of a wheelset those of each wheel.
const textOf = result => {
  const lines = [...result.found];
  const add = (title, path, group) => {
    lines.push("", title);
    for (const [name, value] of Object.entries(group)) {
      if (typeof value !== "number" || name.endsWith("_error"))
        continue;
      const error = group[`${name}_error`], unit = result.units[path + name] ?? result.units[name];
      lines.push(`  ${name.padEnd(24)}${numberText(value).padStart(14)}${
        error > 0 ? ` +- ${error.toPrecision(2)}` : ""}${unit && unit !== "1" ? ` ${unit}` : ""}`);
    }
  };
  if (result.quantities)
    add("Numbers", "quantities/", result.quantities);
  if (result.wheelset)
    add("Wheelset", "wheelset/", result.wheelset);
  for (const side of ["right", "left"])
    if (result[side]?.track)
      add(`Wheel on the ${side}`, `${side}/track/`, result[side].track);
  return lines.join("\n") + "\n";
};

const certified = result => result.certified ?? ["right", "left"].every(side => result[side].result.certified);

const run = async () => {
  const {values, positionals} = parseArgs({
    allowPositionals: true,
    options: {json: {type: "boolean"}, fields: {type: "boolean"}, model: {type: "string"}, help: {type: "boolean"},
      version: {type: "boolean"}}
  });
  const [command, file, ...more] = positionals;
  if (values.version)
    return console.log(JSON.parse(readFileSync(new URL("./package.json", import.meta.url))).version), 0;
  if (values.help || command === undefined)
    return process.stdout.write(HELP), values.help ? 0 : wrong_input;
  if (command !== "solve" || file === undefined || more.length > 0 || (values.fields && !values.json)) {
    const what = command !== "solve" ? `There is no command '${command}' (there is solve; bem_contact has more)` :
      file === undefined ? "Which scene? (solve needs a file)" :
      more.length > 0 ? `'${more[0]}' is too much (solve takes one scene)` :
      "--fields needs --json (fields are no text)";
    return console.error(`error: ${what} See conformal-contact --help`), wrong_input;
  }
  let scene;
  try {
    scene = readFileSync(file, "utf8");
  } catch (error) {
    return console.error(`error: The scene '${file}' cannot be read (${error.code}) Name a file that is there.`), wrong_input;
  }
  const changes = values.model === undefined ? {} : {"solver.model": values.model};
  const result = await solve(scene, {changes, fields: values.fields, ...filesOf(scene, path.dirname(file))});
  for (const warning of result.warnings ?? [])
    console.error(`warning: ${warning}`);
  process.stdout.write(values.json ? JSON.stringify(result, null, 2) + "\n" : textOf(result));
  return certified(result) ? 0 : no_convergence;
};

try {
  process.exitCode = await run();
} catch (error) {
  console.error(`error: ${error.message}`);
  const wrong = error.kind === "refused" || error.code?.startsWith("ERR_PARSE_ARGS");
  process.exitCode = wrong ? wrong_input : error.kind === "not certified" ? no_convergence : 1;
}
