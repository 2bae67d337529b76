// What can be moved: sliders and fields, each for a key of scenes. `scale`: what 1 in the field is in the key's unit.
// `of`: whether it is asked of one wheel or of a wheelset; else of both.
export const CONTROLS = [
  {key: "position.lateral", title: "lateral, to the right", unit: "mm", from: -8, to: 8, step: 0.02,
   kind: "wheel_rail"},
  {key: "position.yaw", title: "yaw, front to the right", unit: "mrad",
   scale: 1e-3, from: -20, to: 20, step: 0.1, kind: "wheel_rail"},
  {key: "position.roll", title: "roll, right side down", unit: "mrad",
   scale: 1e-3, from: -10, to: 10, step: 0.05, kind: "wheel_rail", of: "wheel"},
  {key: "track.curve_radius", title: "curve, centre to the right", unit: "m", scale: 1e3,
   inverse: {from: -10, to: 10, step: 0.1, unit: "1/km"},
   kind: "wheel_rail"},
  {key: "motion.speed", title: "speed", unit: "km/h",
   scale: 1e6 / 3600, from: 0, to: 250, step: 1, kind: "wheel_rail"},
  {key: "load.force", title: "vertical force", unit: "kN",
   scale: 1e3, from: 5, to: 200, step: 0.5, fits: true, of: "wheel"},
  {key: "wheelset.force", title: "vertical force on the axle", unit: "kN",
   scale: 1e3, from: 10, to: 400, step: 1, fits: true, of: "wheelset"},
  {key: "wheelset.force_y", title: "lateral force on the axle", unit: "kN",
   scale: 1e3, from: -60, to: 60, step: 0.5, of: "wheelset", given: true},
  {key: "motion.friction", title: "coefficient of friction", unit: "", from: 0.01, to: 0.6, step: 0.005},
  {key: "motion.xi", title: "longitudinal creepage", unit: "‰",
   scale: 1e-3, from: -10, to: 10, step: 0.02, of: "wheel"},
  {key: "motion.eta", title: "lateral creepage", unit: "‰",
   scale: 1e-3, from: -10, to: 10, step: 0.02, of: "wheel"},
  {key: "motion.phi", title: "spin", unit: "1/m",
   scale: 1e-3, from: -2, to: 2, step: 0.01, of: "wheel"},
  {key: "layer.compliance", title: "compliance of a layer", unit: "mm³/kN",
   scale: 1e-3, from: 0, to: 0.4, step: 0.002}];

/// Numbers in a field's unit as the key's values, and back, without digits of rounding.
export const exact = value => Number(value.toPrecision(12));
export const toKey = (control, value) => exact(value * (control.scale ?? 1));
export const toField = (control, value) => exact(value / (control.scale ?? 1));
