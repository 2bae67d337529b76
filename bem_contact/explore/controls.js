// What can be moved: sliders and fields, each for a key of scenes. `scale`: what 1 in the field is in the key's unit,
// which is `keyUnit`. `of`: whether it is asked of one wheel or of a wheelset; else of both.
const CONTROLS = [
  {key: "position.lateral", title: "lateral, to the right", unit: "mm", from: -8, to: 8, step: 0.02,
   kind: "wheel_rail"},
  {key: "position.yaw", title: "yaw, front to the right", unit: "mrad", keyUnit: "rad",
   scale: 1e-3, from: -20, to: 20, step: 0.1, kind: "wheel_rail"},
  {key: "position.roll", title: "roll, right side down", unit: "mrad", keyUnit: "rad",
   scale: 1e-3, from: -10, to: 10, step: 0.05, kind: "wheel_rail", of: "wheel"},
  {key: "track.curve_radius", title: "curve, centre to the right", unit: "m", keyUnit: "mm", scale: 1e3,
   inverse: {from: -10, to: 10, step: 0.1, unit: "1/km"},
   kind: "wheel_rail"},
  {key: "motion.speed", title: "speed", unit: "km/h", keyUnit: "mm/s",
   scale: 1e6 / 3600, from: 0, to: 250, step: 1, kind: "wheel_rail"},
  {key: "load.force", title: "vertical force", unit: "kN", keyUnit: "N",
   scale: 1e3, from: 5, to: 200, step: 0.5, fits: true, of: "wheel"},
  {key: "wheelset.force", title: "vertical force on the axle", unit: "kN", keyUnit: "N",
   scale: 1e3, from: 10, to: 400, step: 1, fits: true, of: "wheelset"},
  {key: "wheelset.force_y", title: "lateral force on the axle", unit: "kN", keyUnit: "N",
   scale: 1e3, from: -60, to: 60, step: 0.5, of: "wheelset", given: true},
  {key: "motion.friction", title: "coefficient of friction", unit: "", from: 0.01, to: 0.6, step: 0.005},
  {key: "motion.xi", title: "longitudinal creepage", unit: "‰",
   scale: 1e-3, from: -10, to: 10, step: 0.02, of: "wheel"},
  {key: "motion.eta", title: "lateral creepage", unit: "‰",
   scale: 1e-3, from: -10, to: 10, step: 0.02, of: "wheel"},
  {key: "motion.phi", title: "spin", unit: "1/m", keyUnit: "1/mm",
   scale: 1e-3, from: -2, to: 2, step: 0.01, of: "wheel"},
  {key: "layer.compliance", title: "compliance of a layer", unit: "mm³/kN", keyUnit: "mm^3/N",
   scale: 1e-3, from: 0, to: 0.4, step: 0.002}];

/// Numbers in a field's unit as the key's values, and back, without digits of rounding.
const exact = value => Number(value.toPrecision(12));
const toKey = (control, value) => exact(value * (control.scale ?? 1));
const toField = (control, value) => exact(value / (control.scale ?? 1));

/// A message about a key with its numbers in the unit of the key's field.
const inFieldUnits = message => {
  const numeral = "-?[0-9]+(?:\\.[0-9]*)?(?:e[-+]?[0-9]+)?";
  for (const control of CONTROLS.filter(one => one.scale && message.includes(one.key))) {
    const shown = text => `${Number(toField(control, Number(text)).toPrecision(6))} ${control.unit}`,
          quoted = text => text.replace(/[.^/]/g, "\\$&");
    const unit = control.keyUnit ? `(?: ${quoted(control.keyUnit)}(?![\\w/^]))` : "(?!)";
    message = message
                  .replace(
                      new RegExp(`(${quoted(control.key)} = )(${numeral})${unit}?`, "g"),
                      (_, before, value) => before + shown(value))
                  .replace(
                      new RegExp(`([<>]=? )(${numeral})${unit}?(?! ?${quoted(control.unit)})`, "g"),
                      (_, before, value) => before + shown(value))
                  .replace(new RegExp(`(^|[ (])(${numeral})${unit}`, "g"), (_, before, value) => before + shown(value));
  }
  return message;
};

/// A curve's slider moves its curvature: a straight track is its middle.
const toSlider = (control, value) => control.inverse ? (value ? exact(1e3 / value) : 0) : value;
const fromSlider = toSlider;

/// A label, a field and a slider. `moved(key, value)` is called as they move.
const addControl = (control, parent, moved) => {
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
  return {...control, row, field, slider};
};

/// Makes room for a value beyond the slider's ends, and sets it.
const stretch = (slider, value) => {
  slider.min = Math.min(Number(slider.min), value);
  slider.max = Math.max(Number(slider.max), value);
  slider.value = value;
};

/// The slider's own ends, where a scene begins anew.
const unstretch = ({slider, inverse, ...own}) => {
  const scale = inverse ?? own;
  Object.assign(slider, {min: scale.from, max: scale.to, step: scale.step});
};

/// Shows what the scene has; a key that the scene cannot have is hidden.
const showControl = (control, kind) => {
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
const addChoice = (key, title, names, parent, moved) => {
  const row = add("div", "", parent, {className: "control wide"}), id = key.replace(".", "-");
  add("label", title, row, {htmlFor: id, title: key});
  const list = add("select", "", row, {id, name: key});
  for (const [name, text] of names)
    add("option", text, list, {value: name});
  list.addEventListener("change", () => moved(key, list.value));
  return {key, row, list};
};

const LARGEST_FILE = 10e6; // bytes of a profile

/// A profile: a standard's name, or a file that is chosen or dropped here. `dropped(key, name, text)`.
const addProfileField = (key, title, names, parent, moved, dropped) => {
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
