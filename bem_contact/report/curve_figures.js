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
