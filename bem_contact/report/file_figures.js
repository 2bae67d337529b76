// Figures of profiles, influence files and meshes.
import {ADHESION, BOUND, INK, PRESSURE, RAIL_FACE, WHEEL, rows} from "./contact_figures.js";
import {ABOVE} from "./curve_figures.js";

/// Profiles over y, the first in front: their heights, or their curvatures.
export const profilesFigure = (profiles, what) => {
  const first = profiles[0], heights = what === "z", sizes = first.curvature.map(Math.abs).sort((a, b) => a - b);
  const most = 1.3 * sizes[Math.floor(0.99 * (sizes.length - 1))] + 1e-4; // a kink does not flatten all else
  const looks =
      [{color: INK, width: 2.2}, {color: BOUND, width: 1.5, dash: "dash"}, {color: WHEEL, width: 1.5, dash: "dot"}];
  const traces =
      profiles.map((p, k) => ({type: "scatter", mode: "lines", x: p.y, y: p[what], name: p.name, line: looks[k]}))
          .reverse();
  return {traces, height: heights ? 420 : 340,
          layout: {xaxis: {title: "y, mm, to the field side"}, legend: {...ABOVE, traceorder: "reversed"},
                   yaxis: heights ? {title: "z down, mm", autorange: "reversed", scaleanchor: "x"}
                                  : {title: "curvature, 1/mm", range: [-most, most]}}};
};

/// Points of equal `key` as one line with gaps, in the order of `over`: where the next point is farther than `apart`.
const linesBy = (points, key, over, what, apart = Infinity) => {
  const lines = new Map(), x = [], y = [];
  for (const p of points)
    lines.set(`${p.body} ${p[key]}`, [...lines.get(`${p.body} ${p[key]}`) ?? [], p]);
  for (const line of lines.values()) {
    line.sort((a, b) => a[over] - b[over]).forEach((p, k) => {
      if (k > 0 && p.u - line[k - 1].u > apart)
        x.push(null), y.push(null);
      x.push(p.u), y.push(p[what]);
    });
    x.push(null), y.push(null);
  }
  return {type: "scatter", mode: "lines", x, y, connectgaps: false};
};

/// Which points of sections correspond, over the way along the track. `what`: "y" from above, "z" from the side.
export const correspondenceFigure = (lines, what) => {
  const points = lines.u.values.map((u, k) => ({
    u, body: lines.body.values[k], t: lines.t.values[k], line: lines.line.values[k] > 0,
    section: lines.section.values[k] > 0, y: lines.y.values[k], z: lines.z.values[k]
  }));
  const places = [...new Set(points.filter(p => p.section).map(p => p.u))].sort((a, b) => a - b);
  const apart = 1.01 * Math.max(...places.slice(1).map((u, k) => u - places[k])); // a body that ends and begins again
  return {
    height: 380,
    traces: [
      {...linesBy(points.filter(p => !p.line), "t", "u", what, apart), name: "what corresponds between the lines",
       line: {color: RAIL_FACE, width: 0.8}, hoverinfo: "skip"},
      {...linesBy(points.filter(p => p.section), "u", "t", what), name: "sections", line: {color: INK, width: 1}},
      {...linesBy(points.filter(p => p.line), "t", "u", what, apart), name: "lines along which they are joined",
       line: {color: ADHESION, width: 2.2}}
    ],
    layout: {
      xaxis: {title: lines.u.values.every(u => Math.abs(u) <= 4) ? "angle of the wheel, rad" : "along the track, mm"},
      yaxis: {title: `${what}, mm`, autorange: "reversed"},
      legend: ABOVE
    }
  };
};

/// The strip of an influence file in its section.
export const stripFigure = (stations, colour) => ({
  height: 360,
  traces: [{
    type: "scatter",
    mode: "lines+markers",
    x: stations.map(p => p[1]),
    y: stations.map(p => p[2]),
    text: stations.map(p => `s ${p[0].toFixed(2)} mm`),
    line: {color: colour, width: 2},
    marker: {color: colour, size: 5}
  }],
  layout: {
    xaxis: {title: "y, mm"},
    yaxis: {title: "z down, mm", autorange: "reversed", scaleanchor: "x"},
    showlegend: false
  }
});

/// The smallest scaled Jacobian of each quadrilateral: the sine of a corner's angle, the worst corner.
export const jacobiansOf = (points, quads) => quads.map(quad => {
  const sines = quad.map((at, k) => {
    const [y, z] = points[at], side = to => [points[to][0] - y, points[to][1] - z],
              [a, b] = [side(quad[(k + 1) % 4]), side(quad[(k + 3) % 4])];
    return (a[0] * b[1] - a[1] * b[0]) / (Math.hypot(...a) * Math.hypot(...b));
  });
  return Math.sign(sines.reduce((sum, sine) => sum + sine, 0)) > 0 ? Math.min(...sines) : -Math.max(...sines);
});

/// A meshed section: elements in thin lines, the strip and the held part in bold ones. `near`: the strip alone.
export const meshFigure = (data, near) => {
  const points = rows(data.points), lines = groups => ({
                                      x: groups.flatMap(g => [...g.map(k => points[k][0]), null]),
                                      y: groups.flatMap(g => [...g.map(k => points[k][1]), null])
                                    });
  const style = {
    contact: [PRESSURE[1][1], "strip: unit tractions act here"],
    held: [ADHESION, "held: no displacement"]
  };
  /** @type {object[]} */
  const traces = [{
    type: "scatter",
    mode: "lines",
    ...lines(rows(data.quads).map(q => [...q, q[0]])),
    name: "elements",
    line: {color: RAIL_FACE, width: 0.7},
    hoverinfo: "skip"
  }];
  for (const [name, [color, title]] of Object.entries(style))
    if (data.edges[name])
      traces.push(
          {type: "scatter", mode: "lines", ...lines(rows(data.edges[name])), name: title, line: {color, width: 3.5}});
  const strip = near && data.edges.contact ? rows(data.edges.contact).flat().map(k => points[k]) : points;
  const range = k => [Math.min(...strip.map(p => p[k])) - 3, Math.max(...strip.map(p => p[k])) + 3];
  return {
    traces,
    height: 520,
    layout: {
      xaxis: {title: "y, mm", range: range(0), constrain: "domain"},
      legend: ABOVE,
      yaxis: {title: "z down, mm", range: range(1).reverse(), scaleanchor: "x", constrain: "domain"}
    }
  };
};
