// Sliders, fields and choices of the page.
import {add} from "../report/drawing.js";
import {sceneValue} from "../report/scene_words.js";
import {data} from "../report/shown.js";
import {exact, toField, toKey} from "./moved_keys.js";
import {problemShown} from "./problem.js";

/// A curve's slider moves its curvature: a straight track is its middle.
const toSlider = (control, value) => control.inverse ? (value ? exact(1e3 / value) : 0) : value;
const fromSlider = toSlider;

export const controls = []; // those of the page
/// A label, a field and a slider. `moved(key, value)` is called as they move.
export const addControl = (control, parent, moved) => {
  const row = add("div", "", parent, {className: "control", hidden: true}), id = control.key.replace(".", "-");
  add("label", control.title, row, {htmlFor: id, title: control.key});
  const field = add("input", "", row, {type: "number", id, step: "any", name: control.key});
  add("span", control.unit, row);
  const scale = control.inverse ?? control;
  const slider = add("input", "", row, {type: "range", min: scale.from, max: scale.to, step: scale.step});
  slider.setAttribute("aria-label", `${control.title}, ${scale.unit}`);
  slider.addEventListener("input", () => {
    field.value = fromSlider(control, Number(slider.value));
    moved(control.key, toKey(control, Number(field.value)));
  });
  field.addEventListener("change", () => {
    if (field.value === "" || !Number.isFinite(Number(field.value)))
      return;
    stretch(slider, toSlider(control, Number(field.value)));
    moved(control.key, toKey(control, Number(field.value)));
  });
  controls.push({...control, row, field, slider});
};

/// Makes room for a value beyond the slider's ends, and sets it.
const stretch = (slider, value) => {
  slider.min = Math.min(Number(slider.min), value);
  slider.max = Math.max(Number(slider.max), value);
  slider.value = value;
};

/// The slider's own ends, where a scene begins anew.
export const unstretch = ({slider, inverse, ...own}) => {
  const scale = inverse ?? own;
  Object.assign(slider, {min: scale.from, max: scale.to, step: scale.step});
};

/// Shows what the scene has; a key that the scene cannot have is hidden.
export const showControl = (control, kind) => {
  const text = sceneValue(control.key), given = text !== "" && Number.isFinite(Number(text));
  const of = data.wheels ? "wheelset" : "wheel"; // an axle has some keys that one wheel has not
  control.row.hidden =
      (control.kind ?? kind) !== kind || (control.of ?? of) !== of || ((control.fits || control.given) && !given);
  if (document.activeElement === control.field || document.activeElement === control.slider)
    return;
  const value = toField(control, given ? Number(text) : 0);
  if (control.fits && !control.fitted && given) { // from a hundredth to twice as much, in steps that fit
    control.fitted = true;
    const step = 10 ** Math.floor(Math.log10(value / 100));
    Object.assign(
        control.slider,
        {min: exact(step * Math.ceil(value / 100 / step)), max: exact(step * Math.ceil(2 * value / step)), step});
  }
  control.field.value = value;
  stretch(control.slider, toSlider(control, value));
};

/// A choice of names.
export const addChoice = (key, title, names, parent, moved) => {
  const row = add("div", "", parent, {className: "control wide"}), id = key.replace(".", "-");
  add("label", title, row, {htmlFor: id, title: key});
  const list = add("select", "", row, {id, name: key});
  for (const [name, text] of names)
    add("option", text, list, {value: name});
  list.addEventListener("change", () => moved(key, list.value));
  return {key, row, list};
};

export const LARGEST_FILE = 10e6; // bytes of a profile

/// A profile: a standard's name, or a file that is chosen or dropped here. `dropped(key, name, text)`.
export const addProfileField = (key, title, names, parent, moved, dropped) => {
  const row = add("div", "", parent, {className: "control wide", hidden: true}), id = key.replace(".", "-");
  add("label", title, row, {htmlFor: id, title: `${key}: a standard, or drop a file here`});
  const field = add("input", "", row, {id, name: key, autocomplete: "off"});
  field.setAttribute("list", `${id}-names`);
  const list = add("datalist", "", row, {id: `${id}-names`});
  for (const name of names)
    add("option", "", list, {value: name});
  const file = add("input", "", row, {type: "file", id: `${id}-file`});
  file.setAttribute("aria-label", `${title} from a file`);
  const take = async one => {
    if (one.size > LARGEST_FILE)
      return problemShown(`'${one.name}' is not read (it has ${
          (one.size / 1e6).toFixed(0)} MB, a profile has less than ${LARGEST_FILE / 1e6}) Drop a profile.`);
    dropped(key, one.name, await one.text());
  };
  field.addEventListener("change", () => field.value.trim() && moved(key, field.value.trim()));
  file.addEventListener("change", () => file.files[0] && take(file.files[0]));
  row.addEventListener("dragover", event => {
    event.preventDefault();
    event.stopPropagation();
    row.classList.add("onto");
  });
  row.addEventListener("dragleave", () => row.classList.remove("onto"));
  row.addEventListener("drop", event => {
    event.preventDefault();
    event.stopPropagation();
    row.classList.remove("onto");
    if (event.dataTransfer.files[0])
      take(event.dataTransfer.files[0]);
  });
  return {key, row, field};
};
