// Pages of contacts: a result, models of it side by side, both wheels of a wheelset.
import {SETS, certifiedOf, contactsOf, namesIn, shortOf, titleOf} from "./answers.js";
import {
  PRESSURE, cutFigure, extent, isShaped, patchFigure, peak, sectionFigure, solidFigure,
  stressFigure
} from "./contact_figures.js";
import {ABOVE, FORCES, lineOver} from "./curve_figures.js";
import {add, addFigure, into, isFirst} from "./drawing.js";
import {inDegrees, number, unitText, valueOf, valueText, words} from "./numbers.js";
import {correspondence} from "./page_files.js";
import {placeFigure} from "./place_figure.js";
import {radiusOf} from "./scene_words.js";
import {data} from "./shown.js";
import {
  addCertificate, addPatches, addQuantities, addSix, addTable, toleranceOf, worstOf
} from "./tables.js";

/// What stands first: wheels and rails where they touch, or the patch of one that has no bodies.
const contactPicture = contacts => {
  const place = placeFigure(contacts);
  if (place)
    return [
      "place",
      "Where wheel and rail touch, looking along the track. Blue: the pressure on each row of the patch, off the rail.",
      place
    ];
  const [contact] = contacts.filter(extent);
  return contact && patchOf(contact);
};

const patchOf = contact => {
  const patch = patchFigure(contact);
  return [`patch-${contact.name}`, `${titleOf(contact.name)}: the patch from above.` +
          (contact.friction > 0 ? " Hatched elements slip; those within the thick line (orange) adhere." : "") +
          (patch?.longest > 0 ? " Arrows: shear traction on the rail." : ""), patch];
};

const addSolid = (contact, shape = "wide") => {
  if (isShaped(contact) && extent(contact))
    addFigure(
        `solid-${contact.name}`,
        "Wheel and rail in place, with the pressure on the patch; the wheel is cut behind it. Turn it with the " +
            "mouse; a click on a name hides or shows that body.",
        solidFigure(contact, radiusOf(contact)), shape);
};

const addCuts = contact => {
  for (const along of ["x", "s"].filter(name => contact[name].length > 1)) {
    const cut = cutFigure(contact, along);
    addFigure(
        `cut-${along}-${contact.name}`,
        `${titleOf(contact.name)}: ${
            contact.friction > 0 ? "shear traction within the bound of friction"
                                 : "pressure"} along ${along} through the largest pressure (${cut.where}).`,
        cut);
  }
};

/// All figures of one contact, but what stands first of one that has no bodies.
const addContactFigures = contact => {
  if (!extent(contact))
    return add("p", "Nothing is in contact.");
  if (!isFirst(`patch-${contact.name}`))
    addFigure(...patchOf(contact));
  addCuts(contact);
  if (isShaped(contact))
    addFigure(
        `section-${contact.name}`, "The section at the contact, looking along the track.", sectionFigure(contact));
  if (contact.group.stresses)
    addFigure(
        `stresses-${contact.name}`, `${titleOf(contact.name)}: stress below the surface, by half-space formulas.`,
        stressFigure(contact.group.stresses));
  for (const side of ["rail", "wheel"].filter(name => contact.group.stresses?.[name])) {
    const own = contact.group.stresses[side];
    addFigure(
        `stresses-${side}-${contact.name}`,
        `${titleOf(contact.name)}: stress below the surface in the real ${side}, ${own.attributes.body}.`,
        stressFigure({...contact.group.stresses, ...own}));
  }
};

/// Forces by step, of a transient or of shifts.
const addHistory = ({group: {history}}) => {
  if (!history?.Fx)
    return;
  const steps = history.Fx.values.map((_, k) => k + 1);
  addFigure("history", "Forces on the rail by step.", {
    height: 330,
    traces: ["Fx", "Fy", "Fz"].map(name => lineOver(steps, history[name].values, name, FORCES[name])),
    layout: {xaxis: {title: "step"}, yaxis: {title: "N"}, legend: ABOVE}
  });
};

export const RESULT = {
  picture: () => contactPicture(contactsOf(data)),
  warnings: () => contactsOf(data).map(contact => ["", contact]),
  large: () => addSix(contactsOf(data)[0]),
  figures: () => {
    const [contact] = contactsOf(data);
    addSolid(contact);
    addContactFigures(contact);
    addHistory(contact);
    correspondence().forEach(one => addFigure(...one));
  },
  sure: () => addCertificate(contactsOf(data)[0]),
  tables: () => {
    const [contact] = contactsOf(data);
    addQuantities([contact], "The errors are those that the size of the elements is estimated to cause", "quantities");
    addPatches(contact);
  }};

/// Fx of each model beyond its own free rolling, where the file has it.
const addCreepForces = creep => {
  if (!creep)
    return;
  const models = namesIn(creep.Fx).filter(name => creep.Fx[name].values);
  addTable(
      "Fx on the rail (N) at equal creepage beyond free rolling, each model at its place at equal forces",
      ["creepage", ...models.map(shortOf)],
      creep.xi_from_free_rolling.values.map(
          (xi,
           k) => [String(xi), ...models.map(name => number(creep.Fx[name].values[k], creep.Fx_error[name].values[k]))]),
      {id: "creep-forces"});
};

const setsThere = () => Object.keys(SETS).filter(name => contactsOf(data[name]).length);
/** @type {() => any[]} */
const comparedContacts = () => setsThere().flatMap(name =>
  contactsOf(data[name]).map(contact => [`${SETS[name]}, ${shortOf(contact.name)}`, contact]));

const pressuresFigure = contacts => {
  const dashes = ["solid", "dash", "dot", "dashdot"];
  return {
    height: 400,
    layout: {xaxis: {title: "s along the rail, mm"}, yaxis: {title: "pressure, MPa"}, legend: ABOVE},
    traces: contacts.map((contact, k) => {
      const [, column] = peak(contact);
      return {
        type: "scatter",
        mode: "lines",
        x: contact.s,
        y: contact.pn.map(line => line[column]),
        name: titleOf(contact.name),
        line: {color: PRESSURE[1][1], width: 2.5 - 0.5 * k, dash: dashes[k]}
      };
    })
  };
};

export const COMPARISON = {
  picture: () =>
      ["pressures", "Pressure along s through its largest value, by each model.",
       pressuresFigure(contactsOf(data[setsThere()[0]]))],
  warnings: comparedContacts,
  figures: () => {
    const contacts = contactsOf(data[setsThere()[0]]);
    addSolid(contacts[0]);
    for (const contact of contacts.filter(extent))
      addFigure(...patchOf(contact));
    for (const contact of contacts.filter(extent))
      addCuts(contact);
  },
  sure: () => {
    const all = comparedContacts(), broken = all.filter(([, contact]) => !certifiedOf(contact.group));
    const worst = all.reduce((most, [, contact]) => Math.max(most, Number(worstOf(contact))), 0);
    add("p",
        broken.length ? `NOT certified: ${broken.map(([title]) => title).join("; ")}.`
                      : `All results are certified: the worst violation of a contact condition is ${
                            worst.toExponential(1)} (relative; at most ${toleranceOf(all[0][1])}).`,
        into, {className: broken.length ? "certificate broken" : "certificate"});
  },
  tables: () => {
    for (const name of setsThere())
      addQuantities(contactsOf(data[name]), SETS[name], `quantities-${name}`);
    addCreepForces(data.creep_forces);
  }
};

const addTrackTable = () => {
  const track = side => data[side].track, sum = name => data.wheelset[name]?.values[0];
  const cell = (side, name) =>
      inDegrees(valueText(track(side), name), valueOf(track(side), name), track(side)[name].unit);
  addTable(
      "On the track, y to the right for both", ["", "left", "right", "sum", "unit", ""],
      Object.keys(track("right"))
          .map(
              name =>
                  [words(name), cell("left", name), cell("right", name), number(sum(name)),
                   unitText(track("right")[name].unit), track("right")[name].description]),
      {numbers: [1, 2, 3], id: "track"});
};

export const WHEELSET = {
  picture: () => contactPicture(contactsOf(data)),
  warnings: () => contactsOf(data).map(wheel => [titleOf(wheel.name), wheel]),
  figures: () => {
    for (const wheel of contactsOf(data)) {
      add("h3", titleOf(wheel.name), into, {className: "wide"});
      addSolid(wheel, "wide screen-only"); // paper has both patches from above
      addContactFigures(wheel);
    }
  },
  sure: () => contactsOf(data).forEach(wheel => addCertificate(wheel, titleOf(wheel.name))),
  tables: () => {
    addTrackTable();
    for (const wheel of contactsOf(data))
      addQuantities([wheel], `${titleOf(wheel.name)}, in the frame of its side`, `quantities-${wheel.name}`);
  }};
