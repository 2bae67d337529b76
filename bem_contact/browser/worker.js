// In the worker, behind what emscripten makes: the first message brings the solver, another one its influence files,
// all others questions.
let solver;

const answerTo = (it, what, question) => {
  const texts = [what, question].map(text => it.stringToNewUTF8(text));
  const type = it.UTF8ToString(it._browser_reply(...texts));
  texts.forEach(it._free);
  return {type, body: it.HEAPU8.slice(it._browser_body(), it._browser_body() + it._browser_size())};
};

const take = async ({wasm, files, what, question}) => {
  solver ??= createSolver({wasmBinary: wasm});
  const it = await solver;
  for (const [name, content] of Object.entries(files ?? {}))
    it.FS.writeFile(name, Uint8Array.from(atob(content), c => c.charCodeAt(0)));
  if (!what)
    return;
  const reply = answerTo(it, what, question);
  postMessage(reply, [reply.body.buffer]);
};

if (typeof WorkerGlobalScope !== "undefined") // else make_page.js runs it
  onmessage = event => take(event.data).catch(error => setTimeout(() => { throw error; })); // the page hears of it
