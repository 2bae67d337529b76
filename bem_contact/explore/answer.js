// Questions and answers of the page; reply.js knows who answers.
// A scene is {text, changes: {key: value}, files: {name: text}}; a record is what record/json.hpp describes.
import {SILENT, replyTo} from "reply";

const WINDOW = `${Date.now()} ${Math.random()}`;

/// What is made of a scene, as a Response. `lane`: a newer question in the same lane replaces this one.
export const asked = async (what, scene, lane) => {
  let response;
  try {
    response = await replyTo(what, {...scene, window: `${WINDOW} ${lane}`});
  } catch {
    return problemOf(SILENT);
  }
  return response.ok ? response : problemOf(await response.text());
};
const problemOf = message => /** @type {any} */ (Response).json({problem: {kind: "refused", message}});

/// {data} with the scene's record, or {problem: {kind, message}}.
export const answer = async (scene, lane = "slider") => (await asked("answer", scene, lane)).json();

/// A file that belongs to a scene, as a Blob: its "scene", "result" or "report". Throws what is wrong with it.
export const fileOf = async (what, scene) => {
  const response = await asked(what, scene, "file");
  if (!response.headers.get("Content-Type")?.startsWith("application/json"))
    return response.blob();
  throw new Error((await response.json()).problem.message);
};
