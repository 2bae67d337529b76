// The question in words. It needs no library.
import {contactsOf, countsText, titleOf} from "./answers.js";
import {sweptKeys} from "./curve_figures.js";
import {hasBothWheels, inDegrees, number, valueOf, words} from "./numbers.js";
import {data, report} from "./shown.js";

/// A value of the scene with all defaults, as a text; "" if it has none.
export const sceneValue = key => data.scene_values?.attributes?.[key] ?? "";

/// Radius of the wheel at the contact; undefined where there is no wheel.
export const radiusOf = contact => {
  const depth = contact.group.patches?.wheel_z?.values[0],
        own = contact.left ? sceneValue("wheelset.left_wheel_radius") : "";
  const radius = Number(own || sceneValue("position.wheel_radius"));
  return radius > 0 && depth !== null && depth !== undefined ? radius + depth : undefined;
};

const bothWheels = profile => `Both wheels of a wheelset ${profile("wheel")}, on rails ${profile("rail")}.`;

const wheelsetInWords = profile => {
  const name = path => path?.split("/").pop(), words = [], of = name => number(data.wheelset[name]?.values[0]);
  if (report.kind === "conicity") {
    const side = which => `${name(data[which].attributes.wheel)} on ${name(data[which].attributes.rail)}`;
    words.push(
        side("right") === side("left")
            ? `A rigid wheelset with wheels ${side("right")}.`
            : `A rigid wheelset: the right wheel is ${side("right")}, the left one ${side("left")}.`,
        "It is moved sideways on its track. The rolling radius difference says how it steers itself, and the " +
            "equivalent conicity (EN 15302) is the slope of the cone with the same wavelength.");
  } else
    words.push(
        bothWheels(profile),
        `The axle bears ${of("Fz")} N down and ${of("Fy")} N to the right. It stands ${
            of("lateral")} mm to the right with a roll of ` +
            `${
                inDegrees(
                    `${of("roll")} rad`, data.wheelset.roll?.values[0],
                    "rad")}, right side down, and rolls on a radius of ${of("rolling_radius")} mm.`);
  return words;
};

export const sceneInWords = () => {
  const swept = report.kind === "sweep" ? sweptKeys(data) : [];
  const profile = body => swept.includes(`${body}.profile`) ? "of several profiles"
                                                            : data.inputs?.[`${body}.profile`] &&
          `with the profile ${data.inputs[`${body}.profile`].attributes.name.split("/").pop()}`;
  if (report.kind === "conicity" || report.kind === "wheelset")
    return wheelsetInWords(profile);
  const out = [],
        contact = contactsOf(data)[0] ?? contactsOf(data.at_equal_forces)[0] ?? contactsOf(data.at_equal_position)[0];
  const quantities = contact?.group.quantities ?? {}, q = name => number(quantities[name]?.values[0]);
  if (data.right || hasBothWheels(data))
    out.push(bothWheels(profile));
  else if (profile("rail"))
    out.push(`A ${sceneValue("position.side") || "right"} wheel ${profile("wheel")} and the nominal radius ` +
             `${Number(sceneValue("position.wheel_radius"))} mm, on a rail ${profile("rail")}.`);
  else if (data.scene_text)
    out.push("One contact problem, given directly by undeformed distance, load and creepages.");
  if (contact) {
    // Those that act: the keys are counted from a rolling radius, to which the geometry adds.
    const acting = contact.group.patches?.xi?.values?.length && contact.group.patches.xi.values[0] !== null
        ? contact.group.patches
        : undefined;
    const at = name => number(acting[name].values[0]);
    out.push(
        `The vertical force is ${q("Fz")} N` +
        (profile("rail") && report.kind === "result"
             ? `, and the wheelset is displaced by ${q("lateral")} mm to the right.`
             : "."));
    out.push(
        contact.friction > 0 ? `The coefficient of friction is ${contact.friction}.` +
                (report.kind !== "result"
                     ? ""
                     : (acting
                            ? ` At the centre of the patch${
                                  acting.xi.values.length > 1 ? " with the largest force" : ""} the creepages are xi ${
                                  at("xi")}, eta ${at("eta")} and phi ${at("phi")} ${acting.phi.unit}.`
                            : ` The creepages are xi ${q("xi")}, eta ${q("eta")} and phi ${q("phi")} ${
                                  quantities.phi?.unit ?? ""}.`))
                             : "There is no friction.");
    for (const {name, group} of report.kind === "result" ? [contact] : [])
      out.push(
          `The model is ${name} (${titleOf(name).toLowerCase()}): ${group.attributes.why_this_model}. The grid has ${
              q("mx")} × ` +
          `${q("ms")} elements of ${q("dx")} × ${q("ds")} mm.`);
    const {conformity, attributes} = contact.group, placed = report.kind === "result";
    if (placed && attributes.track)
      out.push(`${attributes.track[0].toUpperCase()}${attributes.track.slice(1)}.`);
    if (placed && conformity)
      out.push(
          `Where the rigid bodies touch first they are ${conformity.attributes.fit}: at most ${
              number(valueOf(conformity, "largest_distance"))} mm ` +
          `apart between there and the gauge point, and less than 0.1 mm over ${
              number(valueOf(conformity, "width"))} mm.`);
  }
  if (swept.length)
    out.push(
        `${data.status.values.length} cases: ${swept.map(words).join(", ")} ${swept.length > 1 ? "vary" : "varies"}. ` +
        countsText(outcome => valueOf(data, `${outcome.replace(" ", "_")}_count`) ?? 0) + ".");
  if (["creep curves", "fit"].includes(report.kind))
    out.push(`The scene ${data.attributes.scene.split("/").pop()}, model ${data.attributes.model}: vertical force ` +
             `${number(valueOf(data, "Fz"))} N` +
             (data.bound === undefined ? "." : `, friction bound μ Fn = ${number(valueOf(data, "bound"))} N.`));
  if (report.kind === "wear")
    out.push(
        `${data.step.values.length - 1} steps, ${number(data.mileage.values.at(-1))} km: the rail has lost ` +
        `${number(data.rail_area.values.at(-1))} mm² of its section, the wheel ${
            number(data.wheel_area.values.at(-1))} mm².`);
  return out;
};
