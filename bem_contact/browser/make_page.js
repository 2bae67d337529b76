// Puts the folder of static files together, when it is built:
//     node make_page.js SOLVER.js SOLVER.wasm WORKER.js LIBRARY FOLDER INFLUENCE_FILE ...
// LIBRARY is the plotting library as pack_library.py packs it.
const fs = require("fs"), path = require("path"), zlib = require("zlib");
const [solver, wasm, worker, library, folder, ...influence] = process.argv.slice(2);

const packed = bytes => zlib.gzipSync(bytes, {level: 9}).toString("base64");
const script = fs.readFileSync(solver, "utf8") + fs.readFileSync(worker, "utf8");

require(path.resolve(solver))({wasmBinary: fs.readFileSync(wasm)}).then(it => {
  it._browser_reply(it.stringToNewUTF8("page"), it.stringToNewUTF8(""));
  const page = Buffer.from(it.HEAPU8.slice(it._browser_body(), it._browser_body() + it._browser_size())).toString();
  const data = '<script type="application/json" id="data">';
  const parts = Object.entries({solver: packed(script), wasm: packed(fs.readFileSync(wasm))});
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
