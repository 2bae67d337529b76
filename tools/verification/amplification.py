"""How much small changes of a scene's input change its totals; and condition numbers of influence matrices."""

import tomllib
from dataclasses import dataclass

import numpy as np

from . import dense, textbook
from .program import ROOT

SIZES = (1e-9, 1e-6, 1e-3)
FRACTIONS = (0.125, 0.25, 0.5)
SCENES = ROOT / "data" / "scenes"
# What an input's change is relative to, where not to its own value: a length that places bodies to 10 mm, about the
# clearance of the flange; an angle to 0.1 rad.
PLACES = {f"position.{k}": 10.0 for k in ("lateral", "gauge", "gauge_height", "back_to_back", "tape_circle", "vertical", "rail_lateral",
                                          "rail_vertical")}
ANGLES = {f"position.{k}": 0.1 for k in ("roll", "yaw", "rail_inclination", "rail_roll")}
ALWAYS = {"wheel_rail": {"position.gauge": 1435.0, "position.back_to_back": 1360.0, "position.wheel_radius": 460.0,
                         "position.lateral": 0.0, "position.rail_inclination": 0.0, "position.yaw": 0.0}, "patch": {}}
NO_INPUTS = ("grid.", "solver.", "stresses.", "motion.steps", "strip.rail_s0", "strip.wheel_s0", "sweep.", "table.", "weight")
# Bodies of the influence files that the scenes name, in demo/.
BODIES = ("bore", "disc", "ring", "roller", "groove", "wheel_in_groove")
NAMED = {"rail_60E1": "rail_60E1_gauge_corner", "wheel_S1002": "wheel_S1002_flange_root"}  # as tools/demo names them


@dataclass
class Moved:
    """The largest amplification of one case over inputs and totals, for each size; and what it belongs to."""

    name: str
    model: str
    worst: dict  # size: (amplification, input, total)
    grid: float = float("nan")   # largest change of a total by fractions of an element
    stated: float = float("nan")  # discretisation error that the result states
    converges: bool = True  # False: the result says that the pressure does not, and states no error of pmax
    note: str = ""


def keys_of(table, prefix=""):
    for key, value in table.items():
        if isinstance(value, dict):
            yield from keys_of(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value


def first_case(scene):
    """{key: value} of what the first case of a sweep changes; {} of another scene."""
    def first_of(table, prefix=""):
        for key, value in table.items():
            if isinstance(value, list):
                yield prefix + key, value[0]
            elif isinstance(value, dict) and "from" in value:
                yield prefix + key, value["from"]
            elif isinstance(value, dict):
                yield from first_of(value, f"{prefix}{key}.")
    swept = tomllib.loads(scene.read_text()).get("sweep", {})
    out = dict(first_of(swept))
    if "table" in swept:
        lines = [line for line in (scene.parent / swept["table"]).read_text().splitlines() if not line.startswith("#")]
        out |= dict(zip(lines[0].split(","), map(float, lines[1].split(","))))
    out.pop("weight", None)
    return out


def answers(module, scene, options, model=None):
    """The result, or those of both wheels."""
    if "[wheelset]" in scene.read_text():
        pair = module.wheelset(scene, options, model)
        return [pair[side]["result"] for side in ("right", "left")]
    return [module.solve(scene, options, model)]


def inputs_of(given):
    """{key: (value, scale)} of every number that a scene gives, and of what places wheel and rail."""
    found = ALWAYS[given.get("kind", "wheel_rail")] | {k: v for k, v in given.items() if isinstance(v, (int, float))}
    out = {}
    for key, value in found.items():
        scale = PLACES.get(key) or ANGLES.get(key) or abs(value)
        if not isinstance(value, bool) and scale and not key.startswith(NO_INPUTS):
            out[key] = (float(value), scale)
    return out


def changes(before, after, friction):
    """{total: change over scale}: the normal force for forces, friction times it for Fx, the approach of a patch for approach."""
    carried = sum(p["Fn"] for p in before.patches)
    out = {"Fy": abs(after.Fy - before.Fy) / carried, "Fz": abs(after.Fz - before.Fz) / carried,
           "pmax": abs(after.pmax / before.pmax - 1),
           "approach": abs(after.approach - before.approach) / max(p["overlap"] for p in before.patches)}
    if before.p_x.any() and friction > 0:
        out["Fx"] = abs(after.Fx - before.Fx) / (friction * carried)
    return out


def largest_changes(before, after, friction):
    """changes() of one result or of several."""
    all_of_them = [changes(b, a, friction) for b, a in zip(before, after)]
    return {total: max(c.get(total, 0.0) for c in all_of_them) for total in all_of_them[0]}


def amplification(module, scene):
    """Every input of one scene, or of the first case of a sweep, is moved by every size, each solved from a cold start."""
    case = first_case(scene)
    options = {"solver.tolerance": 1e-12} | case
    given = dict(keys_of(tomllib.loads(scene.read_text()))) | case
    friction = given.get("motion.friction", 0.3)
    try:
        model = answers(module, scene, options, "fem" if "rail.influence" in given else None)[0].model
    except module.InputError:
        model = "halfspace"  # its influence files are not here
    before = answers(module, scene, options, model)
    stated = [r.discretisation for r in before if r.discretisation is not None]
    out = Moved(scene.stem, model, {size: (0.0, "", "") for size in SIZES}, stated=max(stated, default=float("nan")),
                converges=not stated or all(r.pmax_error is not None for r in before))
    for key, (value, scale) in inputs_of(given).items():
        for size in SIZES:
            try:
                after = answers(module, scene, options | {key: value + size * scale}, model)
            except module.InputError as refusal:
                out.note = f"{key}: {str(refusal).split('(')[0].strip()}"
                continue
            for total, change in largest_changes(before, after, friction).items():
                if change / size > out.worst[size][0]:
                    out.worst[size] = (change / size, key, total)
    if len(before) == 1 and not any(key.endswith("table") and key != "sweep.table" for key in given):  # a table belongs to its grid
        chosen = {key: 0 for key in ("grid.elements", "grid.accuracy") if key in given}
        out.grid = moved_grid(module, scene, options | chosen, model, before[0], friction)
    return out


def moved_grid(module, scene, options, model, before, friction):
    """Elements a little larger, so that at the border of the contact they lie by fractions of an element elsewhere."""
    dx = before.x[1] - before.x[0] if len(before.x) > 1 else 0.0
    ds = before.s[1] - before.s[0] if len(before.s) > 1 else 0.0
    contact = before.p_n > 0
    sizes = {"grid.dx": dx, "grid.ds": ds} if dx and ds else {}
    same = module.solve(scene, options | sizes, model)
    largest = 0.0
    for step, key, across in ((dx, "grid.dx", contact.any(axis=0).sum()), (ds, "grid.ds", contact.any(axis=1).sum())):
        if not step:
            continue
        for fraction in FRACTIONS:
            try:
                after = module.solve(scene, options | sizes | {key: step * (1 + 2 * fraction / across)}, model)
            except module.InputError:
                continue
            largest = max([largest, *changes(same, after, friction).values()])
    return largest


def noise_rows(module, program, draws):
    """White noise on every point of two measured-like profiles: change of pmax and Fy against the profiles as they are."""
    rows = []
    points = {name: np.loadtxt(ROOT / "data" / "bodies" / f"worn_{name}.txt") for name in ("rail", "wheel")}
    scene = program.folder / "noise.toml"

    def solve(lateral, noise, seed):
        random = np.random.default_rng(seed)
        for name, xy in points.items():
            np.savetxt(program.folder / f"noisy_{name}.txt", xy + noise * random.standard_normal(xy.shape) * [0, 1], fmt="%.15g")
        scene.write_text('kind = "wheel_rail"\nrail.profile = "noisy_rail.txt"\nwheel.profile = "noisy_wheel.txt"\n'
                         f"position.lateral = {lateral}\nload.force = 1e5\nmotion.friction = 0.3\ngrid.dx = 0.5\ngrid.ds = 0.25\n"
                         "solver.tolerance = 1e-12\n")
        return module.solve(scene, {}, "halfspace")

    for lateral in (0.0, 6.0):
        smooth = solve(lateral, 0.0, 0)
        approach = smooth.approach
        for noise in (1e-9 * approach, 1e-6 * approach, 1e-3 * approach, 2e-3, 1e-2):
            found = [solve(lateral, noise, seed) for seed in range(draws)]
            pmax = max(abs(r.pmax / smooth.pmax - 1) for r in found)
            fy = max(abs(r.Fy - smooth.Fy) / smooth.Fz for r in found)
            rows.append([f"{lateral:g}", f"{1000 * noise:.2g}", f"{100 * pmax:.2g} %", f"{100 * fy:.2g} %",
                         f"{max(pmax, fy) * approach / noise:.2g}"])
    return rows


def condition(matrix):
    values = np.linalg.svd(matrix, compute_uv=False)
    return values[0] / values[-1]


def conditions(program, sizes):
    """Rows: model, grid, condition of A_nn, of A_tt, of all of A, and of the matrix of steady rolling."""
    rows = []
    dx = ds = 0.5
    for n in sizes:
        arc = [(12 * np.sin(s / 12), 12 * (1 - np.cos(s / 12)), s / 12) for s in (np.arange(n) - (n - 1) / 2) * ds]
        grid = (dx, ds, n + 2, n)
        pairs = [("half-space", dense.halfspace_pair(n, n, dx, ds, textbook.STEEL, textbook.STEEL)),
                 ("tangent plane, radius 12 mm", dense.tangent_plane_pair(n, n, dx, ds, textbook.STEEL, textbook.STEEL, arc)),
                 ("finite elements, gauge corner", dense.pair_of_bodies(program.body_numbers(textbook.RAIL, *grid, textbook.RAIL_S),
                                                                        program.body_numbers(textbook.WHEEL, *grid, textbook.WHEEL_S)))]
        for name, numbers in pairs:
            a, b = dense.full_matrix(numbers, n), dense.steady_matrix(numbers, n)
            t = slice(0, 2)

            def flat(m):
                return m.transpose(0, 2, 1, 3).reshape(m.shape[0] * m.shape[2], -1)
            rows.append([name, f"{n} x {n}", f"{condition(a[2, 2]):.0f}", f"{condition(flat(a[t, t])):.0f}",
                         f"{condition(flat(a)):.0f}", f"{condition(flat(b[t, t])):.0f}"])
    return rows
