// What the page shows: figures, tables and words read it.
/** @type {any} */
export let data = {}; // of the answer; of a study, that of the part which is added
/** @type {{kind: string, file: string, steps: any[]}} */
export const report = {kind: "result", file: "", steps: []};
export const show = shown => { data = shown; };
