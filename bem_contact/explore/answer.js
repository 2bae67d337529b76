// Who answers the page. Nothing else in it knows that: a solver inside the browser could stand here.
// A scene is {text, changes: {key: value}, files: {name: text}}; a record is what record/json.hpp describes.
const WINDOW = `${Date.now()} ${Math.random()}`;

/// What the program makes of a scene, as a Response. `lane`: a newer question in the same lane replaces this one.
const asked = async (what, scene, lane) => {
  let response;
  try {
    response = await fetch(what, {method: "POST", headers: {"Content-Type": "application/json"},
                                  body: JSON.stringify({...scene, window: `${WINDOW} ${lane}`})});
  } catch {
    return problemOf("The program does not answer (it was ended, or this machine has lost it) Start bem_contact explore again.");
  }
  return response.ok ? response : problemOf(await response.text());
};
const problemOf = message => Response.json({problem: {kind: "refused", message}});

/// {data} with the scene's record, or {problem: {kind, message}}.
const answer = async (scene, lane = "slider") => (await asked("answer", scene, lane)).json();

/// A file that belongs to a scene, as a Blob: its "scene", "result" or "report". Throws what is wrong with it.
const fileOf = async (what, scene) => {
  const response = await asked(what, scene, "file");
  if (!response.headers.get("Content-Type")?.startsWith("application/json"))
    return response.blob();
  throw new Error((await response.json()).problem.message);
};
