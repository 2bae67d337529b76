// Figures of one contact. One colour has one meaning on the whole page; line styles and marks say the same without it.
import {valueOf} from "./numbers.js";

export const INK = "#1c2733", RAIL = "#5b6f82", RAIL_FACE = "#a9b6c3", RAIL_LIGHT = "#edf1f5", WHEEL = "#b4533c",
      ADHESION = "#d95f02", BOUND = "#8a949e";
export const ALONG_X = "#6a3d9a", ALONG_S = "#1b7f79";
export const PRESSURE = [[0, "#eef4fb"], [1, "#3b7cc4"]];
export const STRESS = [[0, "#ffffff"], [1, "#7a7a7a"]];
const EXTERIOR = 0, ADHERES = 1, SLIPS = 2;
const MOST_SLENDER = 15; // length over width of a patch that is drawn in its proportions, with arrows

/// Row-major values as rows.
export const rows = data => {
  const [count, width] = data.shape;
  return Array.from({length: count}, (_, i) => data.values.slice(i * width, (i + 1) * width));
};

/// What the figures need of a result.
export const contactOf = (name, group) => ({
  name, group,
  x: group.x.values, s: group.s.values, y: group.y?.values, z: group.z?.values,
  delta: group.delta?.values, dx: valueOf(group.quantities, "dx"), ds: valueOf(group.quantities, "ds"),
  friction: valueOf(group, "friction"), left: group.attributes.side === "left",
  rail: group.rail_profile && rows(group.rail_profile),
  wheel: group.wheel_profile && rows(group.wheel_profile),
  state: rows(group.state), pn: rows(group.p_n), px: rows(group.p_x), ps: rows(group.p_s),
  slipX: group.slip_x && rows(group.slip_x), slipS: group.slip_s && rows(group.slip_s),
});

/// Whether the rail has no shape that is worth a picture.
const flat = contact => {
  const size = k => Math.max(...contact.rail.map(p => p[k])) - Math.min(...contact.rail.map(p => p[k]));
  return size(1) <= 0.02 * size(0);
};

/// Whether wheel and rail can be shown in place.
export const isShaped = contact =>
  Boolean(contact.rail && contact.wheel && contact.y && contact.delta) && !flat(contact);

export const sideways = contact => `y to the ${contact.left ? "left" : "right"}, mm`;

/// Indices of the first and last row and column in contact; undefined without contact.
export const extent = contact => {
  const found = [];
  contact.state.forEach((row, i) => row.forEach((state, j) => { if (state !== EXTERIOR) found.push([i, j]); }));
  if (!found.length)
    return undefined;
  const of = k => found.reduce(([lo, hi], at) => [Math.min(lo, at[k]), Math.max(hi, at[k])], [Infinity, -Infinity]);
  return {rows: of(0), columns: of(1)};
};

/// Row and column of the largest pressure.
export const peak = contact => {
  let at = [0, 0];
  contact.pn.forEach((row, i) => row.forEach((p, j) => { if (p > contact.pn[at[0]][at[1]]) at = [i, j]; }));
  return at;
};

/// The border of the elements that `inside` names, along their edges, as one line with gaps.
const outline = (contact, inside) => {
  const x = [], y = [], {dx, ds} = contact;
  const is = (i, j) => contact.state[i]?.[j] !== undefined && inside(contact.state[i][j]);
  const add = (x0, y0, x1, y1) => { x.push(x0, x1, null); y.push(y0, y1, null); };
  for (let i = 0; i <= contact.s.length; ++i)
    for (let j = 0; j <= contact.x.length; ++j) {
      const left = contact.x[0] + (j - 0.5) * dx, low = contact.s[0] + (i - 0.5) * ds;
      if (is(i, j) !== is(i - 1, j)) add(left, low, left + dx, low);
      if (is(i, j) !== is(i, j - 1)) add(left, low, left, low + ds);
    }
  return {x, y};
};

const hatching = contact => {
  const x = [], y = [];
  contact.state.forEach((row, i) => row.forEach((state, j) => {
    if (state !== SLIPS)
      return;
    x.push(contact.x[j] - contact.dx / 2, contact.x[j] + contact.dx / 2, null);
    y.push(contact.s[i] - contact.ds / 2, contact.s[i] + contact.ds / 2, null);
  }));
  return {x, y};
};

/// What arrows may show.
export const ARROWS = {
  shear: {
    title: "shear traction on the rail",
    fields: ["px", "ps"],
    name: longest => `shear, at most ${longest.toPrecision(3)} MPa`
  },
  slip: {
    title: "slip of the wheel over the rail",
    fields: ["slipX", "slipS"],
    name: longest => `slip, at most ${Number(longest.toPrecision(3))}`
  }
};

/// Arrows on some elements; the longest stands for `longest`. `fields`: along x and along s.
const arrows = (contact, window, fields) => {
  const [along, across] = fields.map(name => contact[name]);
  if (!along)
    return {longest: 0};
  const size = (k, width) => (window[k][1] - window[k][0] + 1) * width;
  const apart = Math.max(size("rows", contact.ds) / 9, size("columns", contact.dx) / 13); // mm, the same along x and s
  const every = [contact.ds, contact.dx].map(width => Math.max(1, Math.round(apart / width)));
  const shown = [];
  for (let i = window.rows[0] + (every[0] >> 1); i <= window.rows[1]; i += every[0])
    for (let j = window.columns[0] + (every[1] >> 1); j <= window.columns[1]; j += every[1])
      if (contact.state[i][j] !== EXTERIOR)
        shown.push([contact.x[j], contact.s[i], along[i][j], across[i][j]]);
  const longest = Math.max(0, ...shown.map(([, , a, b]) => Math.hypot(a, b)));
  const x = [], y = [];
  const scale = 0.9 * apart / longest;
  for (const [at, up, a, b] of longest > 0 ? shown : []) {
    const [u, v] = [a * scale, b * scale], [tipX, tipY] = [at + u / 2, up + v / 2];
    x.push(at - u / 2, tipX, null, tipX - 0.35 * u + 0.18 * v, tipX, tipX - 0.35 * u - 0.18 * v, null);
    y.push(up - v / 2, tipY, null, tipY - 0.35 * v - 0.18 * u, tipY, tipY - 0.35 * v + 0.18 * u, null);
  }
  return {x, y, longest};
};

/// The patch from above the rail: pressure, adhesion and slip, and arrows.
export const patchFigure = (contact, shown = "shear") => {
  const window = extent(contact);
  if (!window)
    return undefined;
  const pressure = contact.pn.map((row, i) => row.map((p, j) => contact.state[i][j] === EXTERIOR ? null : p));
  const line = (points, name, style, more = {}) =>
      ({type: "scatter", mode: "lines", ...points, name, line: style, hoverinfo: "skip", ...more});
  const range = (middles, [from, to], step) => [middles[from] - 3 * step, middles[to] + 3 * step];
  const x = range(contact.x, window.columns, contact.dx), s = range(contact.s, window.rows, contact.ds);
  const proportion = (s[1] - s[0]) / (x[1] - x[0]), slender = Math.max(proportion, 1 / proportion) > MOST_SLENDER;
  const arrow = slender ? {longest: 0} : arrows(contact, window, ARROWS[shown].fields);
  /** @type {object[]} */
  const traces = [{type: "heatmap", x: contact.x, y: contact.s, z: pressure, colorscale: PRESSURE, zmin: 0,
                   colorbar: {title: {text: "pressure, MPa", side: "right"}, thickness: 14}, hoverongaps: false,
                   hovertemplate: "x %{x:.3f} mm<br>s %{y:.3f} mm<br>%{z:.1f} MPa<extra></extra>"}];
  if (contact.friction > 0) {
    traces.push(line(hatching(contact), "slip (hatched)", {color: INK, width: 0.7}));
    const adheres = outline(contact, state => state === ADHERES);
    traces.push(line(adheres, "", {color: "#ffffff", width: 6.5}, {showlegend: false}));
    traces.push(line(adheres, "adhesion", {color: ADHESION, width: 3.5}));
  }
  traces.push(line(outline(contact, state => state !== EXTERIOR), "contact", {color: INK, width: 2}));
  if (arrow.longest > 0) {
    traces.push(line(arrow, "", {color: "#ffffff", width: 4.5}, {showlegend: false}));
    traces.push(line(arrow, ARROWS[shown].name(arrow.longest), {color: INK, width: 1.8}));
  }
  const height = slender ? 300 : Math.min(620, Math.max(240, 520 * proportion));
  return {traces, longest: arrow.longest, height: height + 120, layout: {
    xaxis: {title: "x, rolling direction, mm", range: x, constrain: "domain"},
    yaxis: {title: "s along the rail, mm", range: s, constrain: "domain", ...slender ? {} : {scaleanchor: "x"}},
    legend: {orientation: "h", y: 1.02, yanchor: "bottom", x: 0}, margin: {t: 60}}};
};

/// Traction and friction bound along one line through the largest pressure; `along`: "x" or "s".
export const cutFigure = (contact, along) => {
  const [row, column] = peak(contact);
  const of = field => along === "x" ? field[row] : field.map(line => line[column]);
  const [at, pn, px, ps] = [contact[along], of(contact.pn), of(contact.px), of(contact.ps)];
  const line = (y, name, style) => ({type: "scatter", mode: "lines", x: at, y, name, line: style});
  const traces = contact.friction > 0 ? [
    {...line(pn.map(p => contact.friction * p), `friction bound, ${contact.friction} × pressure`,
             {color: BOUND, width: 1.5, dash: "dot"}), fill: "tozeroy", fillcolor: "rgba(138,148,158,0.18)"},
    line(px.map((p, k) => Math.hypot(p, ps[k])), "size of the shear traction", {color: INK, width: 1.3}),
    line(px, "along x", {color: ALONG_X, width: 2.4, dash: "dash"}),
    line(ps, "along s", {color: ALONG_S, width: 2.4, dash: "dashdot"})]
    : [line(pn, "pressure", {color: PRESSURE[1][1], width: 2})];
  const where = along === "x" ? `s = ${contact.s[row].toFixed(2)} mm` : `x = ${contact.x[column].toFixed(2)} mm`;
  const title = along === "x" ? "x, rolling direction, mm" : "s along the rail, mm";
  const touched = at.filter((_, k) => pn[k] > 0), step = along === "x" ? contact.dx : contact.ds;
  return {traces, height: 320, where, layout: {
    xaxis: {title, range: [touched[0] - 3 * step, touched[touched.length - 1] + 3 * step]}, yaxis: {title: "MPa"},
    legend: {orientation: "h", y: 1.02, yanchor: "bottom"}}};
};

/// Both profiles at the contact, looking along the track.
export const sectionFigure = contact => {
  const line = (points, name, style) => ({type: "scatter", mode: "lines", x: points.map(p => p[0]),
                                          y: points.map(p => p[1]), name, line: style});
  const touching = contact.state.map((row, i) => row.some(state => state !== EXTERIOR)
                                                 ? [contact.y[i], contact.z[i]] : [null, null]);
  return {height: 380, traces: [
    line(touching, "contact", {color: PRESSURE[1][1], width: 8}),
    line(contact.rail, "rail", {color: RAIL, width: 2.5}),
    line(contact.wheel, "wheel, undeformed, just touching", {color: WHEEL, width: 2, dash: "dash"})],
    layout: {xaxis: {title: sideways(contact)}, legend: {orientation: "h", y: 1.02, yanchor: "bottom"},
             yaxis: {title: "z down, mm", autorange: "reversed", scaleanchor: "x"}}};
};

/// The von Mises stress below the surface: a section through the largest one, or a line over depth, beside that of a
/// half-space if it is one in a body.
export const stressFigure = ({x, s, depths, von_mises: stress, halfspace_von_mises: flat}) => {
  const known = stress.values.filter(Number.isFinite), at = stress.values.indexOf(Math.max(...known));
  const [count, rows, deep] = stress.shape;
  const [i, j, k] = [Math.floor(at / (rows * deep)), Math.floor(at / deep) % rows, at % deep];
  const value = (l, m, n) => stress.values[(l * rows + m) * deep + n], depth = depths.values;
  const mark = {
    type: "scatter",
    mode: "markers",
    name: `largest: ${stress.values[at].toFixed(0)} MPa, ${depth[k].toFixed(2)} mm deep`,
    marker: {symbol: "cross-thin", size: 14, line: {color: INK, width: 2}}
  };
  const down = {title: "depth, mm", autorange: "reversed"}, legend = {orientation: "h", y: 1.02, yanchor: "bottom"};
  if (count === 1 && rows === 1)
    return {
      height: 340,
      traces: [
        {
          type: "scatter",
          mode: "lines+markers",
          x: depth.map((_, n) => value(0, 0, n)),
          y: depth,
          name: "von Mises stress",
          line: {color: INK}
        },
        ...(flat ? [{
          type: "scatter",
          mode: "lines",
          x: flat.values,
          y: depth,
          name: "of a half-space",
          line: {color: INK, dash: "dash"}
        }] : []),
        {...mark, x: [stress.values[at]], y: [depth[k]]}
      ],
      layout: {
        xaxis: {title: `MPa, below x = ${x.values[0]}, s = ${s.values[0]} mm`},
        yaxis: down,
        legend,
        showlegend: true
      }
    };
  const over = rows > 1 ? s : x;
  return {
    height: 360,
    traces: [
      {
        type: "contour",
        x: over.values,
        y: depth,
        z: depth.map((_, n) => over.values.map((_, m) => rows > 1 ? value(i, m, n) : value(m, j, n))),
        colorscale: STRESS,
        contours: {showlabels: true, labelfont: {size: 10, color: INK}},
        colorbar: {title: {text: "von Mises, MPa", side: "right"}, thickness: 14}
      },
      {...mark, x: [over.values[rows > 1 ? j : i]], y: [depth[k]]}
    ],
    layout: {
      xaxis: {title: rows > 1 ? "s along the rail, mm" : "x, rolling direction, mm"},
      yaxis: down,
      legend,
      showlegend: true
    }
  };
};

/// Triangles of the surface through lines of points [x, y, z], two for each quadrangle that `shown` (of line and
/// place) keeps.
const triangles = (lines, shown = (_line, _place) => true) => {
  const width = lines[0].length, points = lines.flat(), mesh = {i: [], j: [], k: [], cells: []};
  for (let l = 0; l + 1 < lines.length; ++l)
    for (let m = 0; m + 1 < width; ++m)
      if (shown(l, m)) {
        const at = l * width + m;
        mesh.i.push(at, at + 1);
        mesh.j.push(at + 1, at + width + 1);
        mesh.k.push(at + width, at + width);
        mesh.cells.push([l, m], [l, m]);
      }
  const {cells, ...corners} = mesh;
  return {
    cells,
    mesh: {type: "mesh3d", x: points.map(p => p[0]), y: points.map(p => p[1]), z: points.map(p => p[2]), ...corners}
  };
};

/// Without the points that lie nearer than `tolerance` to the straight line between those that stay (Douglas and
/// Peucker 1973): figures in 3-D are drawn in a tenth of the time.
const thinned = (points, tolerance = 0.02) => { // mm: less than a pixel, as the patch is some 10 mm wide
  const [a, b] = [points[0], points.at(-1)], chord = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const off = ([y, z]) => chord > 0 ? Math.abs((y - a[0]) * (b[1] - a[1]) - (z - a[1]) * (b[0] - a[0])) / chord
                                    : Math.hypot(y - a[0], z - a[1]);
  const distances = points.map(off), worst = distances.indexOf(Math.max(...distances));
  return distances[worst] > tolerance
      ? [...thinned(points.slice(0, worst + 1), tolerance).slice(0, -1), ...thinned(points.slice(worst), tolerance)]
      : [a, b];
};

const plainSurface = (lines, name, color, opacity) => ({
  ...triangles(lines).mesh, name, color, opacity, showlegend: true, hoverinfo: "skip",
  lighting: {ambient: 0.8, diffuse: 0.3, specular: 0}});

/// Wheel and rail in place, with the pressure on the patch. `radius`: of the wheel at the contact; undefined: no wheel.
export const solidFigure = (contact, radius) => {
  const window = extent(contact), [row, column] = peak(contact);
  const width = Math.max(...contact.rail.map(p => p[0])) - Math.min(...contact.rail.map(p => p[0]));
  const half = Math.max(0.4 * width, ...window.columns.map(k => 1.5 * Math.abs(contact.x[k])));
  const raised = 0.06; // mm above the rail, so that the patch is seen
  const cut = Math.min(
      0.6 * half,
      contact.x[window.columns[1]] + contact.dx); // mm: the wheel is drawn behind the patch alone, which it would hide
  const span = Array.from({length: 13}, (_, k) => cut + (half - cut) * k / 12);
  const rail = thinned(contact.rail), wheel = thinned(contact.wheel);
  /** @type {object[]} */
  const traces = [plainSurface(rail.map(([y, z]) => [-half, half].map(x => [x, y, z])), "rail", RAIL_LIGHT, 1)];
  const lineOf = (points, name, colour, width, dash) => ({
    type: "scatter3d", mode: "lines", x: points.map(p => p[0]), y: points.map(p => p[1]), z: points.map(p => p[2]),
    name, showlegend: false, hoverinfo: "skip", line: {color: colour, width, dash}});
  for (const x of [-half, half])
    traces.push(lineOf(rail.map(([y, z]) => [x, y, z]), "rail", INK, 4));
  if (radius) {
    const axle = contact.z[row] - radius;
    const turned = (y, z, x) => { const r = z - axle; return [x, y, axle + Math.sqrt(r * r - x * x)]; };
    traces.push(plainSurface(wheel.map(([y, z]) => span.map(x => turned(y, z, x))), "wheel", WHEEL, 0.18));
    for (const x of [cut, half])
      traces.push(lineOf(wheel.map(([y, z]) => turned(y, z, x)), "wheel", WHEEL, 4));
  }
  const {dx, ds} = contact, columns = [...contact.x.map(x => x - dx / 2), contact.x.at(-1) + dx / 2];
  const edge = k => { // half way between two rows, or half a row beyond the last
    const [a, b] = k === 0 ? [0, 0] : k === contact.s.length ? [k - 1, k - 1] : [k - 1, k], delta = contact.delta[a];
    const out = a !== b ? 0 : (k === 0 ? -0.5 : 0.5) * ds;
    return [(contact.y[a] + contact.y[b]) / 2 + out * Math.cos(delta) + raised * Math.sin(delta),
            (contact.z[a] + contact.z[b]) / 2 + out * Math.sin(delta) - raised * Math.cos(delta)];
  };
  const patch = triangles(contact.s.concat(0).map((_, k) => columns.map(x => [x, ...edge(k)])),
                          (i, j) => contact.state[i][j] !== EXTERIOR);
  traces.push({...patch.mesh, intensity: patch.cells.map(([i, j]) => contact.pn[i][j]), intensitymode: "cell",
               colorscale: PRESSURE, cmin: 0, cmax: contact.pn[row][column], name: "patch", showlegend: true,
               colorbar: {title: {text: "pressure, MPa", side: "right"}, thickness: 14, len: 0.7},
               lighting: {ambient: 1, diffuse: 0, specular: 0}, flatshading: true, hoverinfo: "skip"});
  const border = outline(contact, state => state !== EXTERIOR);
  traces.push({...lineOf(border.x.map((x, k) => x === null ? [null, null, null]
                                                 : [x, ...edge(Math.round((border.y[k] - contact.s[0]) / ds + 0.5))]),
                         "patch", INK, 5), connectgaps: false});
  const side =
      contact.delta[row] < 0 !== contact.left ? 1 : -1; // looks at the patch from where the rail's surface faces
  const view = (label, x, y, z) => ({label, method: "relayout", args: ["scene.camera.eye", {x, y, z}]});
  const aslant = [-1.25, 1.75 * side, 1.2];
  return {
    traces,
    height: 520,
    layout: {
      scene: {
        aspectmode: "data",
        camera: {
          eye: {x: aslant[0], y: aslant[1], z: aslant[2]},
          center: {x: 0, y: 0, z: -0.1},
          projection: {type: "orthographic"}
        }, // near labels are no larger, and stay on the figure
        xaxis: {title: "x, mm", nticks: 4},
        yaxis: {title: "y, mm", nticks: 6, autorange: contact.left ? true : "reversed"},
        zaxis: {title: "z down, mm", nticks: 3, autorange: "reversed"}
      },
      margin: {t: 40, l: 0, r: 0, b: 30},
      legend: {orientation: "h", y: 0, yanchor: "top", x: 0},
      updatemenus: [{
        type: "buttons",
        direction: "right",
        x: 0,
        xanchor: "left",
        y: 1.0,
        yanchor: "bottom",
        showactive: false,
        font: {size: 11},
        buttons: [
          view("aslant", ...aslant), view("along the track", -1.9, 0, 0.15), view("from above", -0.01, 0, 2.0),
          view("from the side", 0, 1.6 * side, 0.3)
        ]
      }]
    }
  };
};
