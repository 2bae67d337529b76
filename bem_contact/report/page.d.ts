// What tsc cannot read of the modules.
declare const Plotly: any; // the plotting library
