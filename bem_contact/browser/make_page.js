// Puts the folder of static files together, when it is built:
//     node make_page.js SOLVER.js SOLVER.wasm LIBRARY FOLDER INFLUENCE_FILE ...
// SOLVER.js is what emscripten makes with worker.js behind it; pack_library.py packs the plotting library LIBRARY.
const fs = require("fs"), path = require("path"), zlib = require("zlib");
const [script, wasm, library, folder, ...influence] = process.argv.slice(2);
const {createSolver, answerTo} = require(path.resolve(script));

const packed = file => zlib.gzipSync(fs.readFileSync(file), {level: 9}).toString("base64");

createSolver({wasmBinary: fs.readFileSync(wasm)}).then(it => {
  const page = Buffer.from(answerTo(it, "page", "").body).toString();
  const data = '<script type="application/json" id="data">';
  const parts = Object.entries({solver: packed(script), wasm: packed(wasm)});
  fs.mkdirSync(folder, {recursive: true});
  fs.writeFileSync(
      path.join(folder, "index.html"),
      page.replace("@LIBRARY_OF_THE_PAGE@", () => fs.readFileSync(library, "utf8"))
          .replace(
              data,
              () => parts.map(([id, text]) => `<script type="text/plain" id="${id}">${text}</script>\n`).join("") +
                  data));
  const files =
      influence.map(file => [`/data/influence/${path.basename(file)}`, fs.readFileSync(file).toString("base64")]);
  fs.writeFileSync(
      path.join(folder, "influence.js"), `globalThis.INFLUENCE = ${JSON.stringify(Object.fromEntries(files))};\n`);
});
