// Behind what emscripten makes. In a worker the first message brings the solver, others influence files and questions.
// By Node it is a module.
const answerTo = (it, what, question) => {
  const texts = [what, question].map(text => it.stringToNewUTF8(text));
  const type = it.UTF8ToString(it._browser_reply(...texts));
  texts.forEach(it._free);
  return {type, body: it.HEAPU8.slice(it._browser_body(), it._browser_body() + it._browser_size())};
};

/// From now on scenes may name this influence file, in the flat form of flat_influence.py.
const hold = (it, name, bytes) => {
  const place = `/held_${encodeURIComponent(name)}`, texts = [name, place].map(text => it.stringToNewUTF8(text));
  it.FS.writeFile(place, bytes);
  it._browser_hold(...texts);
  texts.forEach(it._free);
};

let solver;
const take = async ({wasm, files, influence, what, question}) => {
  solver ??= createSolver({wasmBinary: wasm});
  const it = await solver;
  for (const [name, content] of Object.entries(files ?? {}))
    it.FS.writeFile(name, Uint8Array.from(atob(content), c => c.charCodeAt(0)));
  for (const [name, bytes] of Object.entries(influence ?? {}))
    hold(it, name, bytes);
  if (!what)
    return;
  const reply = answerTo(it, what, question);
  postMessage(reply, [reply.body.buffer]);
};

if (typeof WorkerGlobalScope !== "undefined")
  onmessage = event => take(event.data).catch(error => setTimeout(() => { throw error; })); // the page hears of it
else
  module.exports = {createSolver, answerTo, hold};
