// Figures of what follows from contacts: wear, conicity, fatigue, shakedown, tables.
import {BOUND, INK, RAIL, STRESS, WHEEL} from "./contact_figures.js";
import {ABOVE, FORCES, lineOver, titled} from "./curve_figures.js";
import {linesOf, number, shortName, unitText, valueOf, words} from "./numbers.js";

const DRAWN_STEPS = 5; // lines of one figure: more cannot be told apart on paper

/// "1760 km", of a step.
const mileageAt = (data, step) => `${Number(data.mileage.values[data.step.values.indexOf(step)].toPrecision(3))} km`;

/// How deep a body is worn over its y, a line a step: later steps are darker and thicker.
export const wornFigure = (all, data, body) => {
  const steps = all.filter(
      (_, k) => k === 0 ||
          Math.floor(k * DRAWN_STEPS / (all.length - 1)) > Math.floor((k - 1) * DRAWN_STEPS / (all.length - 1)));
  const first = steps[0][body];
  const traces = steps.slice(1).map((at, k) => ({
                                      type: "scatter",
                                      mode: "lines",
                                      x: first.map(p => p[0]),
                                      y: at[body].map((p, i) => Math.hypot(p[0] - first[i][0], p[1] - first[i][1])),
                                      name: `step ${at.step}, ${mileageAt(data, at.step)}`,
                                      line: {
                                        color: body === "rail" ? RAIL : WHEEL,
                                        width: 1 + 0.6 * k,
                                        dash: ["dot", "dash", "dashdot", "longdash", "solid"].slice(1 - steps.length)[k]
                                      }
                                    }));
  const worn = first.filter((_, i) => traces.some(t => t.y[i] > 1e-6)).map(p => p[0]);
  const [lo, hi] = worn.length ? [Math.min(...worn), Math.max(...worn)] : [-40, 40];
  return {traces, height: 340, layout: {xaxis: {title: `y of the ${body}, mm`, range: [lo - 2, hi + 2]},
                                        yaxis: {title: "worn away, mm", autorange: "reversed"}, legend: ABOVE}};
};

/// The worn profile from step to step, with a slider; the depth is drawn larger than it is. Paper shows the last step.
export const filmFigure = (steps, data, body) => {
  const first = steps[0][body], deepest = data[`${body}_depth`].values.at(-1),
        times = 5 / deepest; // drawn 5 mm deep at last
  const drawn = at => at[body].map((p, i) => p.map((value, k) => first[i][k] + times * (value - first[i][k])));
  const curve = points => ({x: points.map(p => p[0]), y: points.map(p => p[1])});
  const colour = body === "rail" ? RAIL : WHEEL,
        now = {mode: "immediate", frame: {duration: 0, redraw: true}, transition: {duration: 0}};
  const sizes = [0, 1].map(
      k => [Math.min, Math.max].map(most => most(...first.map(p => p[k]), ...drawn(steps.at(-1)).map(p => p[k]))));
  return {
    height: 420,
    traces: [
      {
        type: "scatter",
        mode: "lines",
        ...curve(first),
        name: `new ${body}`,
        line: {color: BOUND, width: 1.5, dash: "dash"}
      },
      {
        type: "scatter",
        mode: "lines",
        ...curve(drawn(steps.at(-1))),
        name: `worn ${body}, depth drawn ${times.toPrecision(3)} times as large`,
        line: {color: colour, width: 2.5}
      }
    ],
    frames: steps.map(at => ({name: `step ${at.step}`, data: [curve(drawn(at))], traces: [1]})),
    layout: {
      xaxis: {title: `y of the ${body}, mm`, range: [sizes[0][0] - 2, sizes[0][1] + 2]},
      legend: ABOVE,
      margin: {b: 110},
      yaxis: {title: "z down, mm", range: [sizes[1][1] + 2, sizes[1][0] - 2], scaleanchor: "x"},
      sliders: [{
        active: steps.length - 1,
        pad: {t: 45},
        currentvalue: {prefix: "mileage "},
        steps: steps.map(at => ({label: mileageAt(data, at.step), method: "animate", args: [[`step ${at.step}`], now]}))
      }],
      updatemenus: [{
        type: "buttons",
        x: 1,
        xanchor: "right",
        y: -0.14,
        yanchor: "top",
        showactive: false,
        buttons: [{
          label: "play",
          method: "animate",
          args: [null, {fromcurrent: false, frame: {duration: 250, redraw: true}, transition: {duration: 0}}]
        }]
      }]
    }
  };
};

export const radiusFigure = ({function: f}) => ({
  height: 320,
  traces: [{type: "scatter", mode: "lines", x: f.lateral.values, y: f.difference.values, line: {color: INK, width: 2}}],
  layout: {
    xaxis: {title: "lateral displacement to the right, mm"},
    yaxis: {title: "right less left, mm"},
    showlegend: false
  }
});

export const conicityFigure = ({conicity: c}) => ({
  height: 320,
  traces: [
    {...lineOver(c.amplitude.values, c.tan_gamma.values, "tan γ", {colour: INK, dash: "solid", mark: "circle"})}, {
      type: "scatter",
      mode: "lines",
      x: [3, 3],
      y: [0, Math.max(...c.tan_gamma.values.filter(v => v !== null))],
      name: "amplitude of the standard, 3 mm",
      line: {color: BOUND, width: 1.5, dash: "dot"}
    }
  ],
  layout: {xaxis: {title: "amplitude, mm"}, yaxis: {title: "tan γ", rangemode: "tozero"}, legend: ABOVE}
});

/// Where both wheels touch: on the wheel or on the rail.
export const touchFigure = ({function: f}, body) => ({
  height: 340,
  traces: Object.entries({
    right: {symbol: "circle", size: 4},
    left: {symbol: "x-thin", size: 9, maxdisplayed: 40, line: {color: body === "rail" ? RAIL : WHEEL, width: 1.5}}
  }).map(([side, mark]) => ({
    type: "scatter",
    mode: "markers",
    x: f.lateral.values,
    y: f[`${side}_${body}_y`].values,
    name: side,
    marker: {color: body === "rail" ? RAIL : WHEEL, ...mark}
  })),
  layout: {
    xaxis: {title: "lateral displacement to the right, mm"},
    yaxis: {title: `y on the ${body}, mm, to the field side`},
    legend: ABOVE
  }
});

export const wearFigure = (data, what, unit) => ({
  height: 320,
  traces: [["rail", RAIL, "solid", "circle"], ["wheel", WHEEL, "dash", "square"]].map(
      ([body, colour, dash, mark]) =>
          lineOver(data.mileage.values, data[`${body}_${what}`].values, body, {colour, dash, mark})),
  layout: {
    xaxis: {title: "mileage, km"},
    yaxis: {title: `${what === "depth" ? "largest depth" : "area gone from the section"}, ${unit}`},
    legend: ABOVE
  }
});

/// Patches in the shakedown diagram: the largest pressure over the yield stress in shear, and the friction used.
export const shakedownFigure = ({patches: p}) => {
  const mu = Array.from({length: 60}, (_, k) => 0.01 * (k + 1)), load = p.p0_over_k.values,
        top = 1.15 * Math.max(6, ...load);
  return {
    height: 380,
    traces: [
      {
        type: "scatter",
        mode: "lines",
        x: mu,
        y: mu.map(m => Math.min(1 / m, top)),
        name: "limit of the surface, 1/μ",
        line: {color: BOUND, width: 1.5, dash: "dot"}
      },
      {
        type: "scatter",
        mode: "markers",
        x: p.mu_used.values,
        y: p.p0_over_k_limit.values,
        name: "limit below the surface, of each patch",
        marker: {symbol: "line-ew", size: 12, line: {color: INK, width: 1.5}}
      },
      {
        type: "scatter",
        mode: "markers",
        x: p.mu_used.values,
        y: load,
        name: "patches",
        text: load.map((_, k) => `case ${p.case.values[k]}`),
        marker: {color: RAIL, size: 9, line: {color: INK, width: 1}}
      }
    ],
    layout: {
      xaxis: {title: "μ used: shear force over normal force", range: [0, 0.62]},
      yaxis: {title: "p0 / k", range: [0, top]},
      legend: ABOVE
    }
  };
};

/// A map over the section below a patch; values above `most` are drawn as that. `place`: a cross.
export const sectionMapFigure = (section, name, title, place, most = Infinity) => {
  const s = section.s.values, depth = section.depth.values, values = section[name].values;
  /** @type {object[]} */
  const traces = [{
    type: "contour",
    x: s,
    y: depth,
    z: depth.map((_, n) => s.map((_, m) => {
      const value = values[m * depth.length + n];
      return value === null ? null : Math.min(most, value);
    })),
    colorscale: STRESS,
    contours: {showlabels: true, labelfont: {size: 10, color: INK}},
    colorbar: {title: {text: title, side: "right"}, thickness: 14}
  }];
  if (place)
    traces.push({type: "scatter", mode: "markers", x: [place.s], y: [place.depth], name: "where the limit is decided",
                 marker: {symbol: "cross-thin", size: 14, line: {color: INK, width: 2}}});
  return {
    height: 360,
    traces,
    layout:
        {xaxis: {title: "s along the rail, mm"}, yaxis: {title: "depth, mm", autorange: "reversed"}, showlegend: false}
  };
};

/// Largest stresses of a passage over the depth below one point of the surface; those of a half-space are dashed.
export const depthFigure = (section, at, names) => {
  const depth = section.depth.values, traces = [], colours = [RAIL, WHEEL];
  names.forEach(([name, title], i) => {
    for (const [prefix, dash, of] of [["", "solid", ""], ["halfspace_", "dash", ", half-space"]])
      if (section[prefix + name])
        traces.push({
          type: "scatter",
          mode: "lines",
          name: title + of,
          x: depth.map((_, n) => section[prefix + name].values[at * depth.length + n]),
          y: depth,
          line: {color: colours[i], dash}
        });
  });
  return {
    height: 360,
    traces,
    layout: {
      xaxis: {title: "MPa", rangemode: "tozero"},
      yaxis: {title: "depth, mm", autorange: "reversed"},
      legend: ABOVE
    }
  };
};

/// A column of a table over another one, as marks.
export const marksFigure = (table, x, y, colour) => ({
  height: 300,
  traces: [{
    type: "scatter",
    mode: "markers",
    x: table[x].values,
    y: table[y].values,
    marker: {color: colour, size: 8, line: {color: INK, width: 1}}
  }],
  layout:
      {xaxis: {title: titled(x, table[x])}, yaxis: {title: titled(y, table[y]), rangemode: "tozero"}, showlegend: false}
});

/// Conicities over the gauge, a line each pair; at one gauge over the wheels, a mark each rail. Bars: the scatter of
/// the profiles.
export const mapFigure = data => {
  const {map} = data, [wheels, rails] = ["wheels", "rails"].map(name => linesOf(data[name]).map(shortName));
  const over = new Set(map.gauge.values).size > 1, groups = new Map();
  map.gauge.values.forEach((_, i) => {
    const name =
        over ? `${wheels[map.wheel.values[i]]} on ${rails[map.rail.values[i]]}` : `on ${rails[map.rail.values[i]]}`;
    groups.set(name, [...(groups.get(name) ?? []), i]);
  });
  const marks = ["circle", "square", "diamond", "cross", "triangle-up", "x", "star", "hexagon"],
        dashes = ["solid", "dash", "dot", "dashdot"];
  const traces = [...groups].map(
      ([name, entries], k) => lineOver(
          entries.map(i => over ? map.gauge.values[i] : wheels[map.wheel.values[i]]),
          entries.map(i => map.tan_gamma.values[i]), name,
          {colour: [INK, RAIL, WHEEL][k % 3], dash: dashes[k % 4], mark: marks[k % 8]},
          map.tan_gamma_spread && entries.map(i => map.tan_gamma_spread.values[i])));
  for (const trace of over ? [] : traces)
    trace.mode = "markers";
  return {
    traces,
    height: 380,
    layout: {
      xaxis: {title: over ? "track gauge, mm" : "wheel"},
      yaxis: {title: "tan γ", rangemode: "tozero"},
      showlegend: traces.length <= 12,
      legend: ABOVE
    }
  };
};

/// The largest interpolation error of each column of a table of forces, over its scale.
export const tableErrorFigure = data => {
  const names = Object.keys(data.interpolation_error).filter(name => name !== "attributes").reverse(),
        goal = 100 * valueOf(data, "tolerance");
  const held = new Set((data.attributes.held ?? "").split(" "));
  const percent = names.map(name => 100 * valueOf(data.interpolation_error, name) / valueOf(data.scale, name));
  return {
    height: 120 + 26 * names.length,
    traces: [
      {
        type: "bar",
        orientation: "h",
        y: names.map(words),
        x: percent,
        name: "largest interpolation error",
        marker: {color: names.map(name => held.has(name) ? RAIL : "#ffffff"), line: {color: RAIL, width: 1.5}}
      },
      {
        type: "scatter",
        mode: "lines",
        x: [goal, goal],
        y: [words(names[0]), words(names.at(-1))],
        name: `goal ${goal} %`,
        line: {color: BOUND, width: 1.5, dash: "dot"}
      }
    ],
    layout: {xaxis: {title: "% of the column's scale"}, yaxis: {title: ""}, legend: ABOVE}
  };
};

/// A column over the first axis of a table, a line for up to four points of the second one, the other axes at their
/// middle points.
export const tableFigure = (data, column) => {
  const values = data.values[column], names = data.attributes.axis_names.split(" "), {shape} = values;
  if (shape.length !== names.length)
    return undefined; // nested axes
  const axes = names.map(name => data.axes[name]), second = shape.length > 1 ? shape[1] : 1;
  const shown = [...new Set([0, 1, 2, 3].map(k => Math.round(k * (second - 1) / 3)))],
        middle = shape.map(n => Math.floor(n / 2));
  const at = place => values.values[place.reduce((sum, k, axis) => sum * shape[axis] + k, 0)];
  const said = (axis, k) =>
      `${words(names[axis])} ${number(axes[axis].values[k])} ${unitText(axes[axis].unit.replace(/^1$/, ""))}`.trim();
  const rest = names.map((_, axis) => axis).slice(2).map(axis => said(axis, middle[axis])).join(", ");
  const dashes = ["solid", "dash", "dashdot", "dot"], marks = ["circle", "square", "diamond", "triangle-up"];
  return {
    rest,
    height: 340,
    traces: shown.map(
        (k, line) => lineOver(
            axes[0].values, axes[0].values.map((_, i) => at([i, k, ...middle.slice(2)].slice(0, shape.length))),
            shape.length > 1 ? said(1, k) : words(column),
            {colour: FORCES[column]?.colour ?? INK, dash: dashes[line], mark: marks[line]})),
    layout: {
      xaxis: {title: titled(names[0], axes[0])},
      yaxis: {title: titled(column, values)},
      showlegend: shape.length > 1,
      legend: ABOVE
    }
  };
};

/// What one contact wears off rail and wheel, over the rail's profile.
export const wornRowsFigure = rows => ({
  height: 320,
  traces: [
    ["wheel_depth_per_km", WHEEL, "dash", "square"], ["rail_depth_per_million_axles", RAIL, "solid", "circle"]
  ].map(([name, colour, dash, mark]) => ({
          ...lineOver(rows.s.values, rows[name].values, titled(name, rows[name]), {colour, dash, mark}),
          yaxis: name.startsWith("wheel") ? "y" : "y2"
        })),
  layout: {
    xaxis: {title: "s along the rail, mm"},
    yaxis: {title: "wheel, mm by km", rangemode: "tozero"},
    legend: ABOVE,
    margin: {r: 70},
    yaxis2: {title: "rail, mm by a million axles", overlaying: "y", side: "right", showgrid: false, rangemode: "tozero"}
  }
});
