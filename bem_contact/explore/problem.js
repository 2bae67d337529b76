// What is wrong, in words.
import {add} from "../report/drawing.js";
import {ask, kept, lastKey, scene} from "./case.js";
import {element} from "./frames.js";
import {CONTROLS, toField} from "./moved_keys.js";

/// What was moved last, in the unit of its field: messages have the unit of the key.
const movedLast = () => {
  const control = CONTROLS.find(one => one.key === lastKey && one.scale && one.key in scene.changes);
  return control ? `You moved: ${control.title}, ${toField(control, scene.changes[lastKey])} ${control.unit}.` : "";
};

/// Shows it, with a way back; "" where nothing is wrong.
export const problemShown = message => {
  element("problem").hidden = !message;
  element("problem").textContent = message;
  element("page").classList.toggle("stale", Boolean(message));
  if (message && movedLast())
    add("p", movedLast(), element("problem"));
  if (!message || !kept.solved)
    return;
  add("p", "", element("problem")).append(Object.assign(document.createElement("button"), {
    type: "button",
    textContent: "Back to the last case that was solved",
    onclick: () => {
      Object.assign(scene, structuredClone(kept.solved));
      element("text").value = scene.text;
      ask();
    }
  }));
};
