#!/usr/bin/env node
// conformal-contact solve SCENE.toml
import {existsSync, readFileSync, statSync} from "node:fs";
import path from "node:path";
import {parseArgs} from "node:util";
import {ContactError, questionOf, resultOf, solvedAs} from "./ask.mjs";
import {replyTo} from "./solver.mjs";

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

/// The reply of the solver, as an object. Throws ContactError.
const ask = async (what, scene, options) => resultOf(await replyTo(questionOf(what, scene, options)));

/// The files that the scene names. Throws ContactError.
const filesOf = async (scene, changes, folder) => {
  const files = {}, influence = {};
  for (const named of (await ask("names", scene, {changes})).files) {
    const file = path.resolve(folder, named.name);
    if (!existsSync(file) || !statSync(file).isFile())
      throw new ContactError({kind: "refused", message: `The file '${named.name}' is not there (${named.key} names it) ${named.advice}`});
    if (named.influence)
      influence[named.name] = readFileSync(file);
    else
      files[named.name] = readFileSync(file, "utf8");
  }
  return {files, influence};
};

const numberText = value => value === null || value === undefined ? "-" : String(+value.toPrecision(7));

/// What was found in sentences, and each number with its error and unit; of a wheelset those of each wheel. `result` is described.
const textOf = result => {
  const lines = [result.found.text];
  const add = (title, group) => {
    if (!group)
      return;
    lines.push("", title);
    for (const [name, {unit, shape, values, errors}] of Object.entries(group))
      if (shape?.length === 0) // a number
        lines.push(`  ${name.padEnd(24)}${numberText(values[0]).padStart(14)}${
          errors?.[0] > 0 ? ` +- ${errors[0].toPrecision(2)}` : ""}${unit && unit !== "1" ? ` ${unit}` : ""}`);
  };
  add("Numbers", result.quantities);
  add("Wheelset", result.wheelset);
  add("Wheel on the right", result.right?.track);
  add("Wheel on the left", result.left?.track);
  return lines.join("\n") + "\n";
};

/// Prints the result for people. Returns whether its certificate holds.
const printText = result => {
  for (const warning of result.warnings.text.split("\n")) // one line for each
    if (warning)
      console.error(`warning: ${warning}`);
  process.stdout.write(textOf(result));
  return result.attributes.certified === 1;
};

/// And for programs.
const printJson = result => {
  for (const warning of result.warnings)
    console.error(`warning: ${warning}`);
  process.stdout.write(JSON.stringify(result, null, 2) + "\n");
  return result.certified;
};

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
  const options = {changes, ...await filesOf(scene, changes, path.dirname(file))};
  const certified = values.json ? printJson(await ask(solvedAs(values), scene, options)) : printText(await ask("described", scene, options));
  return certified ? 0 : no_convergence;
};

try {
  process.exitCode = await run();
} catch (error) {
  console.error(`error: ${error.message}`);
  const wrong = error.kind === "refused" || error.code?.startsWith("ERR_PARSE_ARGS");
  process.exitCode = wrong ? wrong_input : error.kind === "not certified" ? no_convergence : 1;
}
