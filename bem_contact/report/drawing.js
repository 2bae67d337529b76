// How any page is put together: elements, figures, errors of scripts, the plotting library.
const page = document.getElementById("page");
let idPrefix = ""; // of a part of a study: ids are unique
const figures = []; // [element, figure]: drawn once the library is there

const failed = error => {
  const list = document.getElementById("script-errors");
  list.hidden = false;
  list.append(Object.assign(document.createElement("li"), {textContent: `This page was not drawn to its end: ${error}`}));
};
window.addEventListener("error", event => failed(event.message));
window.addEventListener("unhandledrejection", event => failed(event.reason));

const add = (kind, text = "", parent = page, more = {}) =>
    parent.appendChild(Object.assign(document.createElement(kind), {textContent: text}, more));

const addFigure = (id, caption, figure, parent = page) => {
  if (!figure)
    return;
  const block = add("div", "", parent, {className: "block"});
  const frame = add("div", "", block, {id: idPrefix + id, className: id.startsWith("solid") ? "figure solid" : "figure"});
  add("div", "", frame, {className: "drawing"});
  add("p", caption, block, {className: "caption"});
  figures.push([frame, figure]);
};

/// The library is kept compressed in the page.
const loadLibrary = async () => add("script", await (await unpacked("library")).text(), document.head);

/// What pack_library.py has packed, as a Response.
const unpacked = async id => {
  const bytes = Uint8Array.from(atob(document.getElementById(id).textContent), c => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
};

/// The layout of a figure for the library, `width` px wide.
const layoutOf = ({layout, height}, width) => {
  const axis = {automargin: true, showline: true, linecolor: INK, ticks: "outside", zeroline: false, gridcolor: "#e3e7eb", exponentformat: "none"};
  const whole = {width, height, font: {family: "sans-serif", size: 12, color: INK}, hovermode: "closest", ...layout,
                 margin: {t: 50, l: 65, r: 20, b: 50, ...layout.margin}};
  for (const name of ["xaxis", "yaxis", "yaxis2"])
    if (layout[name])
      whole[name] = {...axis, ...layout[name], title: {text: layout[name].title, standoff: 6}};
  return whole;
};
const PLOT_OPTIONS = {displaylogo: false, modeBarButtonsToRemove: ["select2d", "lasso2d"]};

const PAPER = 700; // px: a sheet of A4 within its margins
let onPaper = false;
const widthOf = frame => onPaper ? PAPER : Math.max(280, frame.clientWidth);

const draw = async ([frame, figure]) => {
  const drawing = frame.firstChild, size = () => ({width: widthOf(frame), height: figure.height});
  const narrow = widthOf(frame) < 600; // px: its buttons would cover a legend
  await Plotly.newPlot(drawing, figure.traces, layoutOf(figure, widthOf(frame)), {...PLOT_OPTIONS, ...narrow ? {displayModeBar: false} : {}});
  if (figure.frames)
    await Plotly.addFrames(drawing, figure.frames);
  if (figure.click)
    drawing.on("plotly_click", event => figure.click(event.points[0].customdata));
  if (!frame.classList.contains("solid"))
    return;
  const picture = add("img", "", frame, {className: "paper", alt: "wheel, rail and patch"});
  const take = async () => {
    const shown = {data: drawing.data, layout: {...drawing.layout, updatemenus: []}};
    picture.src = await Plotly.toImage(shown, {format: "png", ...size(), width: PAPER, scale: 2});
  };
  await take();
  drawing.on("plotly_relayout", take); // paper shows it as it was turned last
};

/// Figures follow the width of the window, and of paper.
const fit = () => {
  for (const [frame] of figures)
    if (frame.firstChild.data && frame.offsetParent !== null && Math.abs(frame.firstChild.layout.width - widthOf(frame)) > 1)
      Plotly.relayout(frame.firstChild, {width: widthOf(frame)});
};
const followWidth = () => {
  addEventListener("resize", fit);
  addEventListener("beforeprint", () => {
    onPaper = true;
    for (const one of figures.filter(([frame]) => !frame.firstChild.data)) // the event waits for nobody; the library draws at once
      draw(one);
    fit();
  });
  addEventListener("afterprint", () => { onPaper = false; fit(); });
};

/// Saves a text as a file of the browser.
const download = (blob, name) => {
  const link = add("a", "", document.body, {href: URL.createObjectURL(blob), download: name});
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 60e3);
};
const csvOf = lines => lines.map(cells => cells.map(cell => { const text = String(cell ?? ""); return /^([\w .]*|-?[\d.]+(e[-+]?\d+)?)$/.test(text) ? text : `"${/^[=+\-@]/.test(text) ? " " : ""}${text.replaceAll('"', '""').replaceAll(/[\r\n]/g, " ")}"`; }).join(",")).join("\n") + "\n"; // texts as record::csv_text()
