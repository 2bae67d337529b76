// Where wheels and rails touch, looking along the track: the first picture of an answer about a contact.
import {
  INK, PRESSURE, RAIL, RAIL_FACE, WHEEL, extent, isShaped, peak, sideways
} from "./contact_figures.js";
import {ABOVE} from "./curve_figures.js";
import {valueText} from "./numbers.js";

const LONGEST_PRESSURE = 14; // mm that the largest pressure is drawn long
const AROUND = 6; // mm that is shown beside a rail
const ABOVE_RAIL = 22, BELOW_RAIL = 28; // mm that are shown above and below the top of the rail

/// The largest pressure of each row in contact, drawn off the rail along its normal, as [y, z]; patch by patch.
const pressureOutlines = contact => {
  const largest = Math.max(...contact.pn.map(row => Math.max(...row))), out = [];
  let patch;
  contact.pn.forEach((row, i) => {
    const pressure = Math.max(...row), {y: {[i]: y}, z: {[i]: z}, delta: {[i]: delta}} = contact;
    if (!(pressure > 0))
      return void (patch = undefined);
    if (!patch)
      out.push(patch = {foot: [], tip: []});
    const length = LONGEST_PRESSURE * pressure / largest;
    patch.foot.push([y, z]);
    patch.tip.push([y + length * Math.sin(delta), z - length * Math.cos(delta)]);
  });
  return out;
};

/// One wheel on its rail, on the axes with this number ("" or "2"). Left wheels are drawn as they stand: on the left.
const placeTraces = (contact, axes, named) => {
  const side = contact.left ? -1 : 1,
        on = {xaxis: `x${axes}`, yaxis: `y${axes}`, type: "scatter", mode: "lines", hoverinfo: "skip"};
  const curve = points => ({x: points.map(p => side * p[0]), y: points.map(p => p[1])});
  const shut = (points, z) => curve([...points, [points.at(-1)[0], z], [points[0][0], z], points[0]]);
  const heights = contact.rail.map(p => p[1]);
  /** @type {object[]} */
  const traces = [
    {
      ...on,
      ...shut(contact.rail, Math.max(...heights) + BELOW_RAIL),
      fill: "toself",
      fillcolor: RAIL_FACE,
      line: {color: RAIL, width: 2.5},
      name: "rail",
      showlegend: named
    },
    {
      ...on,
      ...shut(contact.wheel, Math.min(...contact.wheel.map(p => p[1])) - 2 * ABOVE_RAIL),
      fill: "toself",
      fillcolor: "rgba(180,83,60,0.16)",
      line: {color: WHEEL, width: 2},
      name: "wheel",
      showlegend: named
    }
  ];
  pressureOutlines(contact).forEach(({foot, tip}, k) => traces.push(
    {...on, ...curve([...foot, ...tip.toReversed(), foot[0]]), fill: "toself", fillcolor: "rgba(59,124,196,0.55)",
     line: {color: PRESSURE[1][1], width: 1.5}, name: "pressure", showlegend: named && k === 0},
    {...on, ...curve(foot), line: {color: INK, width: 5}, name: "patch", showlegend: named && k === 0}));
  return traces;
};

/// What is shown of a wheel on its rail: the ranges of both axes.
const placeWindow = contact => {
  const side = contact.left ? -1 : 1, y = contact.rail.map(p => side * p[0]),
        top = Math.min(...contact.rail.map(p => p[1]));
  return {y: [Math.min(...y) - AROUND, Math.max(...y) + AROUND], z: [top + BELOW_RAIL, top - ABOVE_RAIL]};
};

/// "2630 ± 32 MPa" at the largest pressure, towards the middle of the rail: beside it are the axis and the other wheel.
const placeNote = (contact, axes) => {
  const [row] = peak(contact), side = contact.left ? -1 : 1;
  const {y: {[row]: y}, z: {[row]: z}, delta: {[row]: delta}} = contact, window = placeWindow(contact).y;
  const x = side * (y + LONGEST_PRESSURE * Math.sin(delta)), isLeft = x < (window[0] + window[1]) / 2;
  return {xref: `x${axes}`, yref: `y${axes}`, x, y: z - LONGEST_PRESSURE * Math.cos(delta),
          text: `${valueText(contact.group.quantities, "pmax")} MPa`, showarrow: true, arrowhead: 0, arrowcolor: INK,
          ax: isLeft ? 12 : -12, ay: -20, xanchor: isLeft ? "left" : "right",
          bgcolor: "rgba(255,255,255,0.8)", font: {color: INK, size: 13}};
};

/// Both wheels on both rails, or the one that there is. Undefined where no contact has bodies.
export const placeFigure = contacts => {
  const shown = contacts.filter(contact => isShaped(contact) && extent(contact))
                    .sort((a, b) => b.left - a.left); // the left one on the left
  if (!shown.length)
    return undefined;
  const layout = {
    legend: ABOVE,
    margin: {t: 30, l: 45, r: 10, b: 45},
    annotations: shown.map((contact, k) => placeNote(contact, k ? "2" : ""))
  };
  shown.forEach((contact, k) => {
    const axes = k ? "2" : "", window = placeWindow(contact), half = 1 / shown.length,
          gap = shown.length > 1 ? 0.03 : 0;
    layout[`xaxis${axes}`] = {
      title: shown.length > 1 ? `${contact.left ? "left" : "right"} wheel: y, mm` : sideways(contact),
      range: window.y, nticks: shown.length > 1 ? 4 : 6,
      domain: [k * half + k * gap, (k + 1) * half - (1 - k) * gap],
      constrain: "domain",
      anchor: `y${axes}`
    };
    layout[`yaxis${axes}`] = {
      title: k ? "" : "z down, mm",
      range: window.z,
      scaleanchor: `x${axes}`,
      constrain: "domain",
      anchor: `x${axes}`,
      showticklabels: !k
    };
  });
  return {
    traces: shown.flatMap((contact, k) => placeTraces(contact, k ? "2" : "", k === 0)),
    height: shown.length > 1 ? 310 : 400,
    layout
  };
};
