// Figures over many contacts: sweeps, creep curves, conicity, wear; and of profiles.
const FORCES = {Fx: {colour: ALONG_X, dash: "solid", mark: "circle"}, Fs: {colour: ALONG_S, dash: "dash", mark: "square"},
                Fy: {colour: ALONG_S, dash: "dash", mark: "square"}, Fz: {colour: INK, dash: "dot", mark: "diamond"},
                Mz: {colour: INK, dash: "dashdot", mark: "diamond-open"}};

const lineOver = (x, y, name, {colour, dash, mark}, errors, cases) => ({
  type: "scatter", mode: "lines+markers", x, y, name, customdata: cases, line: {color: colour, width: 1.8, dash},
  marker: {symbol: mark, size: 6, color: colour},
  error_y: errors?.some(e => e > 0) ? {type: "data", array: errors, thickness: 1, width: 3} : undefined});

const ABOVE = {orientation: "h", y: 1.02, yanchor: "bottom"};

/// The forces over one creepage, with the bound of friction and the slopes of linear theory.
const creepFigure = (data, which) => {
  const curve = data.curves[which], x = curve.creepage.values, bound = valueOf(data, "bound"), traces = [];
  const column = ["xi", "eta", "phi"].indexOf(which), spans = [x[0], x[x.length - 1]];
  for (const y of [bound, -bound])
    traces.push({type: "scatter", mode: "lines", x: spans, y: [y, y], name: "friction bound μ Fn", showlegend: y > 0,
                 line: {color: BOUND, width: 1.5, dash: "dot"}});
  ["Fx", "Fs"].forEach((force, row) => {
    traces.push(lineOver(x, curve[force].values, `${force}, N`, FORCES[force], curve[`${force}_error`].values));
    const slope = data.kalker?.values[3 * row + column];
    if (slope && row === (which === "xi" ? 0 : 1)) {
      // The other two creepages have their part of the force too, and the geometry makes some of its own.
      const rigid = data.rigid_creepages?.values ?? [0, 0, 0];
      const own = data.rigid_creepages ? Number(sceneValue(`motion.${which}`)) : 0; // as the curve counts it
      const there = rigid.reduce((sum, creepage, k) => sum + data.kalker.values[3 * row + k] * creepage, 0);
      const ends = [-bound, bound].map(force => own + (force - there) / slope).sort((a, b) => a - b);
      const from = Math.max(ends[0], Math.min(...spans)), to = Math.min(ends[1], Math.max(...spans));
      if (from < to)
        traces.push({type: "scatter", mode: "lines", x: [from, to], y: [from, to].map(v => there + slope * (v - own)),
                     name: `${force} by linear theory`, line: {color: FORCES[force].colour, width: 1}});
    }
  });
  traces.push({...lineOver(x, curve.Mz.values, "Mz, N mm (right)", FORCES.Mz, curve.Mz_error.values), yaxis: "y2"});
  if (data.measured?.attributes.creepage === which) {
    const {points, attributes: {force}} = data.measured;
    traces.push({type: "scatter", mode: "markers", x: points.creepage.values, y: points.measured.values, name: `${force} as measured`,
                 yaxis: force === "Mz" ? "y2" : "y", marker: {symbol: "square-open", size: 8, color: INK, line: {width: 1.5}},
                 error_y: points.scatter && {type: "data", array: points.scatter.values, thickness: 1, width: 4, color: INK}});
  }
  const unit = curve.creepage.unit === "1" ? "" : `, ${curve.creepage.unit}`;
  return {traces, height: 380, layout: {xaxis: {title: words(which) + unit}, yaxis: {title: "force on the rail, N"},
                                        yaxis2: {title: "Mz, N mm", overlaying: "y", side: "right", showgrid: false},
                                        legend: ABOVE, margin: {r: 70}}};
};

/// The keys that a sweep varies: those columns of the patches that say so.
const sweptKeys = data => Object.keys(data.patches ?? data)
    .filter(key => /^(swept over|which of)/.test((data.patches ?? data)[key]?.description ?? ""));

const withUnit = (text, dataset) => dataset.unit && dataset.unit !== "1" ? `${text}, ${unitText(dataset.unit)}` : text;
const titled = (name, dataset) => withUnit(words(name), dataset); // of a figure; columns of tables have short names

/// Values of a key, or the cases' numbers.
const along = (data, key) => key ? {...data[key], title: titled(key, data[key])}
                                 : {values: data.status.values.map((_, i) => i), title: "case"};

/// The key to draw over: the first, if each case differs from some other in it alone; undefined: the cases' numbers.
const leadingKey = (data, keys) => {
  const rest = new Set(data.status.values.map((_, i) => keys.slice(1).map(k => data[k].values[i]).join(" ")));
  return keys.length < 2 || rest.size < data.status.values.length ? keys[0] : undefined;
};

/// A value of a key that was swept over; of a text that text.
const keyText = (dataset, i) => {
  const texts = dataset.description.startsWith("which of") ? dataset.description.match(/"[^"]*"/g) : null;
  return texts?.[dataset.values[i]]?.replaceAll('"', "").split("/").pop() ?? number(dataset.values[i]);
};

/// Each patch as a bar over y, as wide as it is, one line a value of the key; its mark grows with the force.
const patchesFigure = (data, key) => {
  const p = data.patches, largest = Math.max(...p.Fn.values);
  const half = p.y.values.map((_, k) => {
    const angle = p.axis_angle.values[k]; // from x towards s
    return Math.hypot(p.semi_axis_a.values[k] * Math.sin(angle), p.semi_axis_b.values[k] * Math.cos(angle)) *
           Math.cos(p.delta.values[k]);
  });
  const text = p.y.values.map((_, k) => `case ${p.case.values[k]}, patch ${p.patch.values[k]}<br>` +
      `Fn ${p.Fn.values[k].toPrecision(5)} N<br>pmax ${p.pmax.values[k].toPrecision(5)} MPa`);
  return {height: 400, traces: [{
    type: "scatter", mode: "markers", x: p.y.values, text, customdata: p.case.values,
    y: p.case.values.map(i => along(data, key).values[i]), name: "patch",
    hovertemplate: "y %{x:.2f} mm<br>%{text}<extra></extra>",
    error_x: {type: "data", array: half, thickness: 4, width: 0, color: RAIL},
    marker: {size: p.Fn.values.map(f => 4 + 12 * Math.sqrt(f / largest)), color: p.pmax.values, colorscale: PRESSURE,
             cmin: 0, line: {color: INK, width: 1}, colorbar: {title: {text: "largest pressure, MPa", side: "right"}, thickness: 14}}}],
    layout: {xaxis: {title: `y to the ${sceneValue("position.side") || "right"}, mm`}, yaxis: {title: along(data, key).title}, showlegend: false}};
};

/// Columns of a sweep over one key. Only cases that have the same other keys are joined.
const sweepFigure = (data, keys, key, names) => {
  const over = along(data, key), groups = new Map();
  over.values.forEach((_, i) => {
    const same = key ? keys.filter(k => k !== key).map(k => `${words(k)} ${keyText(data[k], i)} ${unitText(data[k].unit.replace(/^1$/, ""))}`.trim()).join(", ") : "";
    groups.set(same, [...(groups.get(same) ?? []), i]);
  });
  const traces = [], marks = ["circle", "square", "diamond", "cross", "triangle-up", "x", "star", "hexagon"];
  let count = 0;
  for (const [same, cases] of groups) {
    cases.sort((a, b) => over.values[a] - over.values[b]);
    for (const name of names) {
      const of = ofEither(name); // of wheelsets: the colour of the number, dashed for the left wheel
      const known = FORCES[of] ?? {colour: of === "pmax" ? PRESSURE[1][1] : INK, dash: "solid", mark: "circle"};
      const style = of === name ? known : {...known, dash: name.startsWith("left_") ? "dash" : "solid"};
      const pick = column => cases.map(i => column.values[i]);
      const which = of === name ? name : `${name.split("_")[0]} wheel`;
      const label = [names.length > 1 ? which : "", same].filter(Boolean).join("; ") || name;
      traces.push(lineOver(pick(over), pick(data[name]), label,
                           groups.size > 1 ? {...style, mark: marks[count % marks.length]} : style,
                           data[`${name}_error`] && pick(data[`${name}_error`]), cases));
      traces.at(-1).mode = key ? "lines+markers" : "markers";
    }
    ++count;
  }
  return {traces, height: 330, layout: {xaxis: {title: over.title, dtick: key ? undefined : Math.ceil(over.values.length / 15)},
                                        yaxis: {title: titled([...new Set(names.map(ofEither))].join(", "), data[names[0]])},
                                        showlegend: traces.length > 1 && traces.length <= 12, legend: ABOVE}};
};

const DRAWN_STEPS = 5; // lines of one figure: more cannot be told apart on paper

/// "1760 km", of a step.
const mileageAt = (data, step) => `${Number(data.mileage.values[data.step.values.indexOf(step)].toPrecision(3))} km`;

/// How deep a body is worn over its y, a line a step: later steps are darker and thicker.
const wornFigure = (all, data, body) => {
  const steps = all.filter((_, k) => k === 0 || Math.floor(k * DRAWN_STEPS / (all.length - 1)) > Math.floor((k - 1) * DRAWN_STEPS / (all.length - 1)));
  const first = steps[0][body];
  const traces = steps.slice(1).map((at, k) => ({
    type: "scatter", mode: "lines", x: first.map(p => p[0]),
    y: at[body].map((p, i) => Math.hypot(p[0] - first[i][0], p[1] - first[i][1])),
    name: `step ${at.step}, ${mileageAt(data, at.step)}`,
    line: {color: body === "rail" ? RAIL : WHEEL, width: 1 + 0.6 * k, dash: ["dot", "dash", "dashdot", "longdash", "solid"]
                                                                        .slice(1 - steps.length)[k]}}));
  const worn = first.filter((_, i) => traces.some(t => t.y[i] > 1e-6)).map(p => p[0]);
  const [lo, hi] = worn.length ? [Math.min(...worn), Math.max(...worn)] : [-40, 40];
  return {traces, height: 340, layout: {xaxis: {title: `y of the ${body}, mm`, range: [lo - 2, hi + 2]},
                                        yaxis: {title: "worn away, mm", autorange: "reversed"}, legend: ABOVE}};
};

/// The worn profile from step to step, with a slider; the depth is drawn larger than it is. Paper shows the last step.
const filmFigure = (steps, data, body) => {
  const first = steps[0][body], deepest = data[`${body}_depth`].values.at(-1), times = 5 / deepest; // drawn 5 mm deep at last
  const drawn = at => at[body].map((p, i) => p.map((value, k) => first[i][k] + times * (value - first[i][k])));
  const curve = points => ({x: points.map(p => p[0]), y: points.map(p => p[1])});
  const colour = body === "rail" ? RAIL : WHEEL, now = {mode: "immediate", frame: {duration: 0, redraw: true}, transition: {duration: 0}};
  const sizes = [0, 1].map(k => [Math.min, Math.max].map(most => most(...first.map(p => p[k]), ...drawn(steps.at(-1)).map(p => p[k]))));
  return {
    height: 420,
    traces: [{type: "scatter", mode: "lines", ...curve(first), name: `new ${body}`, line: {color: BOUND, width: 1.5, dash: "dash"}},
             {type: "scatter", mode: "lines", ...curve(drawn(steps.at(-1))), name: `worn ${body}, depth drawn ${times.toPrecision(3)} times as large`,
              line: {color: colour, width: 2.5}}],
    frames: steps.map(at => ({name: `step ${at.step}`, data: [curve(drawn(at))], traces: [1]})),
    layout: {xaxis: {title: `y of the ${body}, mm`, range: [sizes[0][0] - 2, sizes[0][1] + 2]}, legend: ABOVE, margin: {b: 110},
             yaxis: {title: "z down, mm", range: [sizes[1][1] + 2, sizes[1][0] - 2], scaleanchor: "x"},
             sliders: [{active: steps.length - 1, pad: {t: 45}, currentvalue: {prefix: "mileage "},
                        steps: steps.map(at => ({label: mileageAt(data, at.step), method: "animate", args: [[`step ${at.step}`], now]}))}],
             updatemenus: [{type: "buttons", x: 1, xanchor: "right", y: -0.14, yanchor: "top", showactive: false, buttons: [
               {label: "play", method: "animate", args: [null, {fromcurrent: false, frame: {duration: 250, redraw: true}, transition: {duration: 0}}]}]}]}};
};

const radiusFigure = ({function: f}) => ({
  height: 320, traces: [{type: "scatter", mode: "lines", x: f.lateral.values, y: f.difference.values, line: {color: INK, width: 2}}],
  layout: {xaxis: {title: "lateral displacement to the right, mm"}, yaxis: {title: "right less left, mm"}, showlegend: false}});

const conicityFigure = ({conicity: c}) => ({
  height: 320, traces: [{...lineOver(c.amplitude.values, c.tan_gamma.values, "tan γ", {colour: INK, dash: "solid", mark: "circle"})},
                        {type: "scatter", mode: "lines", x: [3, 3], y: [0, Math.max(...c.tan_gamma.values.filter(v => v !== null))],
                         name: "amplitude of the standard, 3 mm", line: {color: BOUND, width: 1.5, dash: "dot"}}],
  layout: {xaxis: {title: "amplitude, mm"}, yaxis: {title: "tan γ", rangemode: "tozero"}, legend: ABOVE}});

/// Where both wheels touch: on the wheel or on the rail.
const touchFigure = ({function: f}, body) => ({
  height: 340, traces: [["right", {symbol: "circle", size: 4}],
                         ["left", {symbol: "x-thin", size: 9, maxdisplayed: 40, line: {color: body === "rail" ? RAIL : WHEEL, width: 1.5}}]].map(([side, mark]) => ({
    type: "scatter", mode: "markers", x: f.lateral.values, y: f[`${side}_${body}_y`].values, name: side,
    marker: {color: body === "rail" ? RAIL : WHEEL, ...mark}})),
  layout: {xaxis: {title: "lateral displacement to the right, mm"}, yaxis: {title: `y on the ${body}, mm, to the field side`}, legend: ABOVE}});

const wearFigure = (data, what, unit) => ({
  height: 320,
  traces: [["rail", RAIL, "solid", "circle"], ["wheel", WHEEL, "dash", "square"]].map(([body, colour, dash, mark]) =>
      lineOver(data.mileage.values, data[`${body}_${what}`].values, body, {colour, dash, mark})),
  layout: {xaxis: {title: "mileage, km"}, yaxis: {title: `${what === "depth" ? "largest depth" : "area gone from the section"}, ${unit}`},
           legend: ABOVE}});

/// Profiles over y, the first in front: their heights, or their curvatures.
const profilesFigure = (profiles, what) => {
  const first = profiles[0], heights = what === "z", sizes = first.curvature.map(Math.abs).sort((a, b) => a - b);
  const most = 1.3 * sizes[Math.floor(0.99 * (sizes.length - 1))] + 1e-4; // a kink does not flatten all else
  const looks = [{color: INK, width: 2.2}, {color: BOUND, width: 1.5, dash: "dash"}, {color: WHEEL, width: 1.5, dash: "dot"}];
  const traces = profiles.map((p, k) => ({type: "scatter", mode: "lines", x: p.y, y: p[what], name: p.name, line: looks[k]})).reverse();
  return {traces, height: heights ? 420 : 340,
          layout: {xaxis: {title: "y, mm, to the field side"}, legend: {...ABOVE, traceorder: "reversed"},
                   yaxis: heights ? {title: "z down, mm", autorange: "reversed", scaleanchor: "x"}
                                  : {title: "curvature, 1/mm", range: [-most, most]}}};
};

/// Patches in the shakedown diagram: the largest pressure over the yield stress in shear, and the friction that is used.
const shakedownFigure = ({patches: p}) => {
  const mu = Array.from({length: 60}, (_, k) => 0.01 * (k + 1)), load = p.p0_over_k.values, top = 1.15 * Math.max(6, ...load);
  return {height: 380, traces: [
    {type: "scatter", mode: "lines", x: mu, y: mu.map(m => Math.min(1 / m, top)), name: "limit of the surface, 1/μ", line: {color: BOUND, width: 1.5, dash: "dot"}},
    {type: "scatter", mode: "markers", x: p.mu_used.values, y: p.p0_over_k_limit.values, name: "limit below the surface, of each patch",
     marker: {symbol: "line-ew", size: 12, line: {color: INK, width: 1.5}}},
    {type: "scatter", mode: "markers", x: p.mu_used.values, y: load, name: "patches", text: load.map((_, k) => `case ${p.case.values[k]}`),
     marker: {color: RAIL, size: 9, line: {color: INK, width: 1}}}],
    layout: {xaxis: {title: "μ used: shear force over normal force", range: [0, 0.62]}, yaxis: {title: "p0 / k", range: [0, top]}, legend: ABOVE}};
};

/// A map over the section below a patch; values above `most` are drawn as that. `place`: a cross.
const sectionMapFigure = (section, name, title, place, most = Infinity) => {
  const s = section.s.values, depth = section.depth.values, values = section[name].values;
  const traces = [{type: "contour", x: s, y: depth, z: depth.map((_, n) => s.map((_, m) => values[m * depth.length + n] === null ? null : Math.min(most, values[m * depth.length + n]))),
                   colorscale: STRESS, contours: {showlabels: true, labelfont: {size: 10, color: INK}},
                   colorbar: {title: {text: title, side: "right"}, thickness: 14}}];
  if (place)
    traces.push({type: "scatter", mode: "markers", x: [place.s], y: [place.depth], name: "where the limit is decided",
                 marker: {symbol: "cross-thin", size: 14, line: {color: INK, width: 2}}});
  return {height: 360, traces, layout: {xaxis: {title: "s along the rail, mm"}, yaxis: {title: "depth, mm", autorange: "reversed"}, showlegend: false}};
};

/// Largest stresses of a passage over the depth below one point of the surface: of the body, and of a half-space dashed.
const depthFigure = (section, at, names) => {
  const depth = section.depth.values, traces = [], colours = [RAIL, WHEEL];
  names.forEach(([name, title], i) => [["", "solid", ""], ["halfspace_", "dash", ", half-space"]].forEach(([prefix, dash, of]) => {
    if (section[prefix + name])
      traces.push({type: "scatter", mode: "lines", name: title + of, x: depth.map((_, n) => section[prefix + name].values[at * depth.length + n]), y: depth,
                   line: {color: colours[i], dash}});
  }));
  return {height: 360, traces, layout: {xaxis: {title: "MPa", rangemode: "tozero"}, yaxis: {title: "depth, mm", autorange: "reversed"}}};
};

/// A column of a table over another one, as marks.
const marksFigure = (table, x, y, colour) => ({
  height: 300, traces: [{type: "scatter", mode: "markers", x: table[x].values, y: table[y].values, marker: {color: colour, size: 8, line: {color: INK, width: 1}}}],
  layout: {xaxis: {title: titled(x, table[x])}, yaxis: {title: titled(y, table[y]), rangemode: "tozero"}, showlegend: false}});

/// Conicities over the gauge, a line each pair; at one gauge over the wheels, a mark each rail. Bars: the scatter of the profiles.
const mapFigure = data => {
  const {map} = data, [wheels, rails] = ["wheels", "rails"].map(name => linesOf(data[name]).map(shortName));
  const over = new Set(map.gauge.values).size > 1, groups = new Map();
  map.gauge.values.forEach((_, i) => {
    const name = over ? `${wheels[map.wheel.values[i]]} on ${rails[map.rail.values[i]]}` : `on ${rails[map.rail.values[i]]}`;
    groups.set(name, [...(groups.get(name) ?? []), i]);
  });
  const marks = ["circle", "square", "diamond", "cross", "triangle-up", "x", "star", "hexagon"], dashes = ["solid", "dash", "dot", "dashdot"];
  const traces = [...groups].map(([name, entries], k) => lineOver(
    entries.map(i => over ? map.gauge.values[i] : wheels[map.wheel.values[i]]), entries.map(i => map.tan_gamma.values[i]), name,
    {colour: [INK, RAIL, WHEEL][k % 3], dash: dashes[k % 4], mark: marks[k % 8]}, map.tan_gamma_spread && entries.map(i => map.tan_gamma_spread.values[i])));
  for (const trace of over ? [] : traces)
    trace.mode = "markers";
  return {traces, height: 380, layout: {xaxis: {title: over ? "track gauge, mm" : "wheel"}, yaxis: {title: "tan γ", rangemode: "tozero"},
                                        showlegend: traces.length <= 12, legend: ABOVE}};
};

/// The largest interpolation error of each column of a table of forces, over its scale.
const tableErrorFigure = data => {
  const names = Object.keys(data.interpolation_error).filter(name => name !== "attributes").reverse(), goal = 100 * valueOf(data, "tolerance");
  const held = new Set((data.attributes.held ?? "").split(" "));
  const percent = names.map(name => 100 * valueOf(data.interpolation_error, name) / valueOf(data.scale, name));
  return {height: 120 + 26 * names.length, traces: [
    {type: "bar", orientation: "h", y: names.map(words), x: percent, name: "largest interpolation error",
     marker: {color: names.map(name => held.has(name) ? RAIL : "#ffffff"), line: {color: RAIL, width: 1.5}}},
    {type: "scatter", mode: "lines", x: [goal, goal], y: [words(names[0]), words(names.at(-1))], name: `goal ${goal} %`, line: {color: BOUND, width: 1.5, dash: "dot"}}],
    layout: {xaxis: {title: "% of the column's scale"}, yaxis: {title: ""}, legend: ABOVE}};
};

/// A column over the first axis of a table, a line for up to four points of the second one, the other axes at their middle points.
const tableFigure = (data, column) => {
  const values = data.values[column], names = data.attributes.axis_names.split(" "), {shape} = values;
  if (shape.length !== names.length)
    return undefined; // nested axes
  const axes = names.map(name => data.axes[name]), second = shape.length > 1 ? shape[1] : 1;
  const shown = [...new Set([0, 1, 2, 3].map(k => Math.round(k * (second - 1) / 3)))], middle = shape.map(n => Math.floor(n / 2));
  const at = place => values.values[place.reduce((sum, k, axis) => sum * shape[axis] + k, 0)];
  const said = (axis, k) => `${words(names[axis])} ${number(axes[axis].values[k])} ${unitText(axes[axis].unit.replace(/^1$/, ""))}`.trim();
  const rest = names.map((_, axis) => axis).slice(2).map(axis => said(axis, middle[axis])).join(", ");
  const dashes = ["solid", "dash", "dashdot", "dot"], marks = ["circle", "square", "diamond", "triangle-up"];
  return {rest, height: 340, traces: shown.map((k, line) => lineOver(
    axes[0].values, axes[0].values.map((_, i) => at([i, k, ...middle.slice(2)].slice(0, shape.length))), shape.length > 1 ? said(1, k) : words(column),
    {colour: FORCES[column]?.colour ?? INK, dash: dashes[line], mark: marks[line]})),
    layout: {xaxis: {title: titled(names[0], axes[0])}, yaxis: {title: titled(column, values)}, showlegend: shape.length > 1, legend: ABOVE}};
};

/// What one contact wears off rail and wheel, over the rail's profile.
const wornRowsFigure = rows => ({
  height: 320, traces: [["wheel_depth_per_km", WHEEL, "dash", "square"], ["rail_depth_per_million_axles", RAIL, "solid", "circle"]].map(([name, colour, dash, mark]) => ({...lineOver(rows.s.values, rows[name].values, titled(name, rows[name]), {colour, dash, mark}),
                                           yaxis: name.startsWith("wheel") ? "y" : "y2"})),
  layout: {xaxis: {title: "s along the rail, mm"}, yaxis: {title: "wheel, mm by km", rangemode: "tozero"}, legend: ABOVE, margin: {r: 70},
           yaxis2: {title: "rail, mm by a million axles", overlaying: "y", side: "right", showgrid: false, rangemode: "tozero"}}});

/// The strip of an influence file in its section.
const stripFigure = (stations, colour) => ({
  height: 360, traces: [{type: "scatter", mode: "lines+markers", x: stations.map(p => p[1]), y: stations.map(p => p[2]), text: stations.map(p => `s ${p[0].toFixed(2)} mm`),
                         line: {color: colour, width: 2}, marker: {color: colour, size: 5}}],
  layout: {xaxis: {title: "y, mm"}, yaxis: {title: "z down, mm", autorange: "reversed", scaleanchor: "x"}, showlegend: false}});

/// The smallest scaled Jacobian of each quadrilateral: the sine of a corner's angle, the worst corner.
const jacobiansOf = (points, quads) => quads.map(quad => {
  const sines = quad.map((at, k) => {
    const [y, z] = points[at], side = to => [points[to][0] - y, points[to][1] - z], [a, b] = [side(quad[(k + 1) % 4]), side(quad[(k + 3) % 4])];
    return (a[0] * b[1] - a[1] * b[0]) / (Math.hypot(...a) * Math.hypot(...b));
  });
  return Math.sign(sines.reduce((sum, sine) => sum + sine, 0)) > 0 ? Math.min(...sines) : -Math.max(...sines);
});

/// A meshed section: elements in thin lines, the strip and the held part in bold ones. `near`: the strip alone.
const meshFigure = (data, near) => {
  const points = rows(data.points), lines = groups => ({x: groups.flatMap(g => [...g.map(k => points[k][0]), null]), y: groups.flatMap(g => [...g.map(k => points[k][1]), null])});
  const style = {contact: [PRESSURE[1][1], "strip: unit tractions act here"], held: [ADHESION, "held: no displacement"]};
  const traces = [{type: "scatter", mode: "lines", ...lines(rows(data.quads).map(q => [...q, q[0]])), name: "elements", line: {color: RAIL_FACE, width: 0.7}, hoverinfo: "skip"}];
  for (const [name, [color, title]] of Object.entries(style))
    if (data.edges[name])
      traces.push({type: "scatter", mode: "lines", ...lines(rows(data.edges[name])), name: title, line: {color, width: 3.5}});
  const strip = near && data.edges.contact ? rows(data.edges.contact).flat().map(k => points[k]) : points;
  const range = k => [Math.min(...strip.map(p => p[k])) - 3, Math.max(...strip.map(p => p[k])) + 3];
  return {traces, height: 520, layout: {xaxis: {title: "y, mm", range: range(0), constrain: "domain"}, legend: ABOVE,
                                        yaxis: {title: "z down, mm", range: range(1).reverse(), scaleanchor: "x", constrain: "domain"}}};
};
