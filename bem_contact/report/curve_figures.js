// Figures over many contacts: sweeps, creep curves and fits.
import {ALONG_S, ALONG_X, BOUND, INK, PRESSURE, RAIL, WHEEL} from "./contact_figures.js";
import {number, quantityOf, unitText, valueOf, words} from "./numbers.js";
import {sceneValue} from "./scene_words.js";

export const FORCES = {
  Fx: {colour: ALONG_X, dash: "solid", mark: "circle"},
  Fs: {colour: ALONG_S, dash: "dash", mark: "square"},
  Fy: {colour: ALONG_S, dash: "dash", mark: "square"},
  Fz: {colour: INK, dash: "dot", mark: "diamond"},
  Mz: {colour: INK, dash: "dashdot", mark: "diamond-open"},
  pmax: {colour: PRESSURE[1][1], dash: "solid", mark: "circle"}
};

/// What a run's own contact model has, beside ours.
const OF_RUN = {colour: BOUND, dash: "dot", mark: "x"};

export const lineOver = (x, y, name, {colour, dash, mark}, errors, cases) => ({
  type: "scatter", mode: "lines+markers", x, y, name, customdata: cases, line: {color: colour, width: 1.8, dash},
  marker: {symbol: mark, size: 6, color: colour},
  error_y: errors?.some(e => e > 0) ? {type: "data", array: errors, thickness: 1, width: 3} : undefined});

export const ABOVE = {orientation: "h", y: 1.02, yanchor: "bottom"};

/// The forces over one creepage, with the bound of friction and the slopes of linear theory.
export const creepFigure = (data, which) => {
  const curve = data.curves[which], x = curve.creepage.values, bound = valueOf(data, "bound"), traces = [];
  const column = ["xi", "eta", "phi"].indexOf(which), spans = [x[0], x[x.length - 1]];
  for (const y of [bound, -bound])
    traces.push({type: "scatter", mode: "lines", x: spans, y: [y, y], name: "friction bound μ Fn", showlegend: y > 0,
                 line: {color: BOUND, width: 1.5, dash: "dot"}});
  ["Fx", "Fs"].forEach((force, row) => {
    traces.push(lineOver(x, curve[force].values, `${force}, N`, FORCES[force], curve[force].errors));
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
  traces.push({...lineOver(x, curve.Mz.values, "Mz, N mm (right)", FORCES.Mz, curve.Mz.errors), yaxis: "y2"});
  if (data.measured?.attributes.creepage === which) {
    const {points, attributes: {force}} = data.measured;
    if (data.band) // of a fit
      traces.unshift(...["low", "high"].map(end => ({
        type: "scatter", mode: "lines", x: data.band.creepage.values, y: data.band[end].values,
        yaxis: force === "Mz" ? "y2" : "y", line: {width: 0}, showlegend: end === "high",
        name: `95 % of what the points allow of ${force}`, hoverinfo: "skip",
        ...(end === "high" ? {fill: "tonexty", fillcolor: `${FORCES[force].colour}33`} : {})
      })));
    traces.push({
      type: "scatter",
      mode: "markers",
      x: points.creepage.values,
      y: points.measured.values,
      name: `${force} as measured`,
      yaxis: force === "Mz" ? "y2" : "y",
      marker: {symbol: "square-open", size: 8, color: INK, line: {width: 1.5}},
      error_y: points.scatter && { type: "data", array: points.scatter.values, thickness: 1, width: 4, color: INK }
    });
  }
  const unit = curve.creepage.unit === "1" ? "" : `, ${curve.creepage.unit}`;
  return {traces, height: 380, layout: {xaxis: {title: words(which) + unit}, yaxis: {title: "force on the rail, N"},
                                        yaxis2: {title: "Mz, N mm", overlaying: "y", side: "right", showgrid: false},
                                        legend: ABOVE, margin: {r: 70}}};
};

/// A line of pressures: points as measured, and as computed there.
export const measuredPressuresFigure = ({points, attributes: {over}}) => {
  const at = points[over].values, order = at.map((_, i) => i).sort((a, b) => at[a] - at[b]);
  const along = name => order.map(i => points[name].values[i]);
  return {height: 340,
          traces: [{...lineOver(along(over), along("computed"), "as computed", {...FORCES.Fx, mark: "circle"})},
                   {type: "scatter", mode: "markers", x: along(over), y: along("measured"), name: "as measured",
                    marker: {symbol: "square-open", size: 8, color: INK, line: {width: 1.5}},
                    error_y: points.scatter &&
                        {type: "data", array: along("scatter"), thickness: 1, width: 4, color: INK}}],
          layout: {xaxis: {title: `${over}, mm`}, yaxis: {title: "pressure, MPa"}, legend: ABOVE}};
};

/// The time of a replay, carried along with its steps.
export const TIME = "note.time";

/// The keys that a sweep varies.
export const sweptKeys = data => Object.keys(data.patches ?? data)
    .filter(key => (data.patches ?? data)[key]?.role === "swept");

export const withUnit = (text, {unit}) => unit && unit !== "1" ? `${text}, ${unitText(unit)}` : text;
/// Of a figure; columns of tables have short names.
export const titled = (name, dataset) => withUnit(words(name), dataset);

/// Values of a key, or the cases' numbers.
const along = (data, key) => key ? {...data[key], title: titled(key, data[key])}
                                 : {values: data.status.values.map((_, i) => i), title: "case"};

/// The key to draw over: the first, if each case differs from some other in it alone; undefined: the cases' numbers.
export const leadingKey = (data, keys) => {
  const rest = new Set(data.status.values.map((_, i) => keys.slice(1).map(k => data[k].values[i]).join(" ")));
  return keys.length < 2 || rest.size < data.status.values.length ? keys[0] : undefined;
};

/// A value of a key that was swept over; of a text that text.
export const keyText = ({choices, values}, i) => choices?.[values[i]]?.split("/").pop() ?? number(values[i]);

/// Each patch as a bar over y, as wide as it is, one line a value of the key; its mark grows with the force.
export const patchesFigure = (data, key) => {
  const p = data.patches, largest = Math.max(...p.Fn.values);
  const half = p.y.values.map((_, k) => {
    const angle = p.axis_angle.values[k]; // from x towards s
    return Math.hypot(p.semi_axis_a.values[k] * Math.sin(angle), p.semi_axis_b.values[k] * Math.cos(angle)) *
           Math.cos(p.delta.values[k]);
  });
  const text = p.y.values.map((_, k) => `case ${p.case.values[k]}, patch ${p.patch.values[k]}<br>` +
      `Fn ${p.Fn.values[k].toPrecision(5)} N<br>pmax ${p.pmax.values[k].toPrecision(5)} MPa`);
  return {
    height: 400,
    traces: [{
      type: "scatter",
      mode: "markers",
      x: p.y.values,
      text,
      customdata: p.case.values,
      y: p.case.values.map(i => along(data, key).values[i]),
      name: "patch",
      hovertemplate: "y %{x:.2f} mm<br>%{text}<extra></extra>",
      error_x: {type: "data", array: half, thickness: 4, width: 0, color: RAIL},
      marker: {
        size: p.Fn.values.map(f => 4 + 12 * Math.sqrt(f / largest)),
        color: p.pmax.values,
        colorscale: PRESSURE,
        cmin: 0,
        line: {color: INK, width: 1},
        colorbar: {title: {text: "largest pressure, MPa", side: "right"}, thickness: 14}
      }
    }],
    layout: {
      xaxis: {title: `y to the ${sceneValue("position.side") || "right"}, mm`},
      yaxis: {title: along(data, key).title},
      showlegend: false
    }
  };
};

/// Of a sweep along the track: each patch as the ellipse that it is, where it lies on the rail, from above.
export const passageFigure = data => {
  const p = data.patches, places = data["position.along"].values, largest = Math.max(...p.pmax.values);
  const turn = Array.from({length: 25}, (_, i) => 2 * Math.PI * i / 24);
  const traces = p.case.values.map((index, k) => {
    const [a, b, angle] = ["semi_axis_a", "semi_axis_b", "axis_angle"].map(name => p[name].values[k]);
    const across = Math.cos(p.delta.values[k]), at = places[index] + p.x.values[k];
    return {
      type: "scatter",
      mode: "lines",
      x: turn.map(t => at + a * Math.cos(angle) * Math.cos(t) - b * Math.sin(angle) * Math.sin(t)),
      y: turn.map(t => p.y.values[k] +
          across * (a * Math.sin(angle) * Math.cos(t) + b * Math.cos(angle) * Math.sin(t))),
      fill: "toself",
      fillcolor: `rgba(59,124,196,${(0.12 + 0.88 * p.pmax.values[k] / largest).toFixed(3)})`,
      line: {color: INK, width: 0.7},
      customdata: turn.map(() => index),
      text: `place ${number(places[index])} mm<br>Fn ${p.Fn.values[k].toPrecision(5)} N<br>pmax ${
          p.pmax.values[k].toPrecision(5)} MPa`,
      hovertemplate: "%{text}<extra></extra>"
    };
  });
  return {
    traces,
    height: 330,
    layout: {
      xaxis: {title: "along the track, mm"},
      yaxis: {title: `y to the ${sceneValue("position.side") || "right"}, mm`},
      showlegend: false
    }
  };
};

/// The same from the side: the places of contact, and how the wheel's centre goes, which z counts down from its highest
/// place.
export const passageSideFigure = data => {
  const p = data.patches, places = data["position.along"].values, order = places.map((_, i) => i);
  order.sort((a, b) => places[a] - places[b]);
  const known = order.filter(i => Number.isFinite(data.vertical.values[i]));
  const largest = Math.max(...p.Fn.values), highest = Math.min(...known.map(i => data.vertical.values[i]));
  return {
    traces: [
      lineOver(known.map(i => places[i]), known.map(i => data.vertical.values[i] - highest),
               "wheel's centre, from its highest place", {colour: WHEEL, dash: "solid", mark: "circle"}, undefined,
               known),
      {
        type: "scatter",
        mode: "markers",
        x: p.case.values.map((i, k) => places[i] + p.x.values[k]),
        y: p.z.values,
        customdata: p.case.values,
        name: "places of contact",
        hovertemplate: "%{x:.1f} mm, z %{y:.3f} mm<extra></extra>",
        marker: {color: RAIL, symbol: "diamond", size: p.Fn.values.map(f => 3 + 7 * Math.sqrt(f / largest))}
      }
    ],
    height: 330,
    layout: {
      xaxis: {title: "along the track, mm"},
      yaxis: {title: "z, down, mm", autorange: "reversed"},
      legend: ABOVE
    }
  };
};

/// Columns of a sweep over one key. Only cases that have the same other keys are joined.
export const sweepFigure = (data, keys, key, names) => {
  const over = along(data, key), groups = new Map();
  over.values.forEach((_, i) => {
    const same = key
        ? keys.filter(k => k !== key)
              .map(k => `${words(k)} ${keyText(data[k], i)} ${unitText(data[k].unit.replace(/^1$/, ""))}`.trim())
              .join(", ")
        : "";
    groups.set(same, [...(groups.get(same) ?? []), i]);
  });
  const traces = [], marks = ["circle", "square", "diamond", "cross", "triangle-up", "x", "star", "hexagon"];
  let count = 0;
  for (const [same, cases] of groups) {
    cases.sort((a, b) => over.values[a] - over.values[b]);
    for (const name of names) {
      const {role} = data[name], ofWheel = role === "right" || role === "left";
      const known = role === "of_run"
        ? OF_RUN : FORCES[quantityOf(data, name)] ?? {colour: INK, dash: "solid", mark: "circle"};
      const style = ofWheel ? {...known, dash: role === "left" ? "dash" : "solid"} : known;
      const pick = column => cases.map(i => column.values[i]);
      const which = ofWheel ? `${role} wheel` : name;
      const label = [names.length > 1 ? which : "", same].filter(Boolean).join("; ") || name;
      traces.push(lineOver(pick(over), pick(data[name]), label,
                           groups.size > 1 ? {...style, mark: marks[count % marks.length]} : style,
                           data[name].errors && pick({values: data[name].errors}), cases));
      traces.at(-1).mode = key === TIME ? "lines" : key ? "lines+markers" : "markers";
    }
    ++count;
  }
  return {
    traces,
    height: 330,
    layout: {
      xaxis: {title: over.title, dtick: key ? undefined : Math.ceil(over.values.length / 15)},
      yaxis: {title: titled([...new Set(names.map(name => quantityOf(data, name)))].join(", "), data[names[0]])},
      showlegend: traces.length > 1 && traces.length <= 12,
      legend: ABOVE
    }
  };
};
