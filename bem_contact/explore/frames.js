// Places of the page, and figures in them.
import {PLOT_OPTIONS, layoutOf} from "../report/drawing.js";

/** @type {(id: string) => any} */
export const element = id => document.getElementById(id);
export const HEIGHTS = {solid: 400, section: 260, patch: 400, "cut-x": 260, "cut-s": 260};

/// ms that each figure took when it was drawn last.
export const costs = {};

export const drawn = async (frame, figure) => {
  const from = performance.now();
  await Plotly.react(
      frame, figure.traces, layoutOf(figure, frame.clientWidth), {...PLOT_OPTIONS, displayModeBar: false});
  costs[frame.id] = performance.now() - from;
};
