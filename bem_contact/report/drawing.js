// How any page is put together: elements, figures, errors of scripts, the plotting library.
import {INK} from "./contact_figures.js";

export const page = document.getElementById("page");
export let into = page; // where add() puts what it makes
/// What `action` adds comes into this element.
export const inside = (element, action) => {
  const before = into;
  into = element;
  action();
  into = before;
  return element;
};
export let idPrefix = ""; // of a part of a study: ids are unique
export const prefixIds = prefix => { idPrefix = prefix; };
/** @type {any[]} */
export const figures = []; // [element, figure]: drawn once the library is there

export const failed = error => {
  const list = document.getElementById("script-errors");
  list.hidden = false;
  list.append(
      Object.assign(document.createElement("li"), {textContent: `This page was not drawn to its end: ${error}`}));
};
window.addEventListener("error", event => failed(event.message));
window.addEventListener("unhandledrejection", event => failed(event.reason));

export const add = (kind, text = "", parent = into, more = {}) =>
    parent.appendChild(Object.assign(document.createElement(kind), {textContent: text}, more));

/// `shape`: "wide" has a line of its own where others stand side by side.
export const addFigure = (id, caption, figure, shape = "") => {
  if (!figure)
    return;
  const block = add("div", "", into, {className: `block ${shape}`.trim()});
  const frame =
      add("div", "", block, {id: idPrefix + id, className: id.startsWith("solid") ? "figure solid" : "figure"});
  add("div", "", frame, {className: "drawing"});
  add("p", caption, block, {className: "caption"});
  figures.push([frame, figure]);
};

let firstFigure = ""; // id of what stands first
export const isFirst = id => firstFigure === idPrefix + id;
export const addFirstFigure = (id, ...more) => {
  firstFigure = idPrefix + id;
  addFigure(id, ...more);
};

/// The library is kept compressed in the page.
export const loadLibrary = async () => add("script", await (await unpacked("library")).text(), document.head);

/// What pack_library.py has packed, as a Response.
export const unpacked = async id => {
  const bytes = Uint8Array.from(atob(document.getElementById(id).textContent), c => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new window["DecompressionStream"]("gzip")));
};

/// The layout of a figure for the library, `width` px wide.
export const layoutOf = ({layout, height}, width) => {
  const axis = {
    automargin: true,
    showline: true,
    linecolor: INK,
    ticks: "outside",
    zeroline: false,
    gridcolor: "#e3e7eb",
    exponentformat: "none"
  };
  const whole = {width, height, font: {family: "sans-serif", size: 12, color: INK}, hovermode: "closest", ...layout,
                 margin: {t: 50, l: 65, r: 20, b: 50, ...layout.margin}};
  for (const name of ["xaxis", "yaxis", "xaxis2", "yaxis2"])
    if (layout[name])
      whole[name] = {...axis, ...layout[name], title: {text: layout[name].title, standoff: 6}};
  return whole;
};
export const PLOT_OPTIONS = {displaylogo: false, modeBarButtonsToRemove: ["select2d", "lasso2d"]};

const PAPER = 700, GUTTER = 16; // px: a sheet of A4 within its margins, and between figures side by side
let onPaper = false;
const isHalf = frame => frame.closest(".side-by-side, .part") && !frame.closest(".wide");
const widthOf = frame => onPaper ? isHalf(frame) ? (PAPER - GUTTER) / 2 : PAPER : Math.max(280, frame.clientWidth);
/// On paper a study's parts stand side by side, too, and figures are flatter, so that an answer takes few sheets.
const heightOf = (frame, height) => onPaper ? Math.min(height, isHalf(frame) ? 250 : 340) : height;

export const draw = async ([frame, figure]) => {
  const drawing = frame.firstChild;
  const narrow = widthOf(frame) < 600; // px: its buttons would cover a legend
  const layout = {...layoutOf(figure, widthOf(frame)), height: heightOf(frame, figure.height)};
  await Plotly.newPlot(drawing, figure.traces, layout, {...PLOT_OPTIONS, ...narrow ? {displayModeBar: false} : {}});
  if (figure.frames)
    await Plotly.addFrames(drawing, figure.frames);
  if (figure.click)
    drawing.on("plotly_click", event => figure.click(event.points[0].customdata));
  if (!frame.classList.contains("solid"))
    return;
  const picture = add("img", "", frame, {className: "paper", alt: "wheel, rail and patch"});
  const take = async () => {
    const shown = {data: drawing.data, layout: {...drawing.layout, updatemenus: []}};
    picture.src = await Plotly.toImage(shown, {format: "png", width: PAPER, height: figure.height, scale: 2});
  };
  await take();
  drawing.on("plotly_relayout", take); // paper shows it as it was turned last
};

/// Figures follow the width of the window, and of paper.
const fit = () => {
  for (const [frame, {height}] of figures) {
    const width = widthOf(frame), {layout} = frame.firstChild;
    if (layout && frame.offsetParent !== null &&
        (Math.abs(layout.width - width) > 1 || layout.height !== heightOf(frame, height)))
      Plotly.relayout(frame.firstChild, {width, height: heightOf(frame, height)});
  }
};
export const followWidth = () => {
  addEventListener("resize", fit);
  addEventListener("beforeprint", () => {
    onPaper = true;
    for (const one of figures.filter(
             ([frame]) => !frame.firstChild.data)) // the event waits for nobody; the library draws at once
      draw(one);
    fit();
  });
  addEventListener("afterprint", () => { onPaper = false; fit(); });
};

/// Saves a text as a file of the browser.
export const download = (blob, name) => {
  const link = add("a", "", document.body, {href: URL.createObjectURL(blob), download: name});
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 60e3);
};
export const csvOf = lines => lines
                           .map(
                               cells => cells
                                            .map(cell => {
                                              const text = String(cell ?? "");
                                              return /^([\w .]*|-?[\d.]+(e[-+]?\d+)?)$/.test(text)
                                                  ? text
                                                  : `"${/^[=+\-@]/.test(text) ? " " : ""}${
                                                        text.replaceAll('"', '""').replaceAll(/[\r\n]/g, " ")}"`;
                                            })
                                            .join(","))
                           .join("\n") +
    "\n"; // texts as record::csv_text()
