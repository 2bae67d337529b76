"""The chapters of tests/VERIFICATION.md. Each runs its checks, writes its tables and returns what failed."""

import io
import platform
import re
import subprocess
import time

import h5py
import matplotlib
import numpy as np

from . import closed_forms, gauge_corner, kernels, textbook
from .page import number, percent
from .program import ROOT, commit, digest

matplotlib.use("svg")
import matplotlib.pyplot as plt

REMOVED = "structural motion removed"
HELD = "rail held at its web, wheel at its rim"
BARS = {"Fy": 0.01, "approach": 0.01, "pmax": 0.01, "area": 0.03, "centre of pressure, s": 0.05}
# By the place of rows of 0.5 mm on the rail pmax differs by 1.3 %: as much again for it.
BARS_OF = {REMOVED: BARS, HELD: BARS | {"pmax": 0.02}}

# Test programs of the source tree that hold checks of their own: program, filter, what they show, also with --quick.
PROGRAMS = [
    ("test_reference", "*", "our own closed forms against printed tables and against each other", True),
    ("test_halfspace", "*", "half-space influence numbers and stresses against numerical quadrature", True),
    ("test_contact", "Textbook.*", "2,000 random problems against a dense solver, in C++", False),
    ("test_contact", "*Kalker*", "creep coefficients at six ellipses against the linear theory, extrapolated", False),
    ("test_contact", "*BallInSeat*", "a ball in a spherical seat, half angle 20 to 60 degrees, with rings of equal area", False),
    ("test_contact", "Metamorphic.*", "units, shifts of the grid, action and reaction, other starts", False),
    ("test_geometry", "*", "contact search and undeformed distance against a brute-force search", False),
    ("test_hard_cases", "*", "cases that break contact solvers: certified, refused or not converged", False),
    ("test_fem_influence", "*", "influence functions against the half-space and the 3-D method", False),
]

def verdict(good):
    return "" if good else "**FAILS**"

def scope(page):
    page.heading("1 What is claimed, for what use")
    page.text("""`bem_contact` is meant for the stresses and forces between a wheel and a rail, above all where both are curved
        alike: pressure, shear tractions, adhesion and slip, forces, approach, creepages, for steady rolling, transient
        rolling and shifts. We claim:""")
    page.items("""**The equations are solved.** Every certified result satisfies the discrete contact conditions within 1e-6 of
        their scales (section 3; every result carries its certificate).""",
               """**The equations are the right ones.** On smaller elements results tend to the exact solutions that are known,
        at the order stated (section 2).""",
               """**The influence functions are those of the bodies.** They agree with exact solutions and with an independent
        3-D analysis (section 4).""",
               "**The limits of each model are known** (sections 5 and 6).")
    page.text("""Terms are those of ASME V&V 10 and of NAFEMS: code verification (sections 2 and 4), solution verification (the
        certificate and the discretisation estimate that every result carries; how good the latter is:
        [tools/BENCHMARKS.md](../tools/BENCHMARKS.md)), and validation (section 7: what is missing).""")
    page.text("""Limits of use: linear elasticity and small strains; Coulomb friction; smooth surfaces without roughness; bodies
        that are the same all along x within the contact, or round about the axle; no inertia in the contact; distances and
        normals of the undeformed surfaces.""")

def study_rows(studies, quick, say):
    checks = []
    for study in studies:
        say(study.name)
        checks += study.run(quick)
    rows = [[c.name, c.quantity + (f", {c.unit}" if c.unit else ""), number(c.exact[-1]),
             "; ".join(f"{c.sizes[k]}: {number(c.ours[k], 5)}" for k in (0, -1)), percent(c.errors()[-1]),
             "-" if not np.isfinite(c.order()) else f"{c.order():.1f}",
             percent(c.bar) + (f", order {c.order_bar:g}" if c.order_bar else ""), verdict(c.passed())] for c in checks]
    return checks, rows

HEAD = ["problem", "quantity", "exact", "ours, coarsest and finest: elements across the contact", "error", "order", "bar", ""]

def code_verification(page, program, quick, say):
    page.heading("2 Exact solutions")
    page.text("""Each problem is solved on three or more grids. The error is that on the finest grid, relative to the exact
        value (of fields: root of the mean square over that of the exact field). The order is the slope of log(error) over
        log(element size) through all grids. Grids are chosen so that the border of the contact is not a border of elements.
        Sizes of areas change by jumps as whole elements enter or leave, so their order is not judged; nor is that of an error
        that changes its sign. A row that misses its bar says so. The exact values come from `tools/verification/exact.py`,
        written from the formulas of
        [the theory](../bem_contact/theory/estimates_and_heat.md#4-closed-forms) and not from the program.""")
    chosen = closed_forms.studies(program)
    if quick:
        chosen = [s for s in chosen if s.name in ("Hertz, ellipse", "Persson, 30 degrees", "Carter")]
    checks, rows = study_rows(chosen, quick, say)
    page.table(HEAD, rows)
    page.figure(convergence_plot(checks))
    sources = {s.source: s.name.split(",")[0] if s.name.startswith("Persson") else s.name for s in chosen}
    page.text("Sources: " + "; ".join(f"{name}: {source}" for source, name in sources.items()) + ".")
    return [f"{c.name}: {c.quantity}" for c in checks if not c.passed()]

def convergence_plot(checks):
    figure, axis = plt.subplots(figsize=(13, 7), layout="constrained")
    for c in checks:
        if len(c.sizes) > 2 and max(c.errors()) > 1e-8:
            axis.loglog(c.sizes, np.maximum(c.errors(), 1e-6), "o-", markersize=3, linewidth=1, label=f"{c.name}: {c.quantity}")
    axis.set_xlabel("elements across the contact")
    axis.set_ylabel("error")
    axis.grid(alpha=0.3)
    axis.legend(fontsize=7, frameon=False, loc="center left", bbox_to_anchor=(1, 0.5))
    text = io.StringIO()
    figure.savefig(text, format="svg")
    plt.close(figure)
    return text.getvalue()[text.getvalue().index("<svg"):]

def solver(page, program, quick, say):
    page.heading("3 The solver against a dense textbook solution")
    page.text("""Steady rolling on small grids, solved again in NumPy: dense matrices, Gauss elimination, Kalker's NORM and TANG in
        turn (`tools/verification/dense.py`). The influence numbers of half-space and tangent plane are computed there too, by
        point loads (Love 1929) and numerical means, so that section 3 checks numbers, set-up and solver at once. Those of
        finite elements are expanded from the shipped files, body by body. Differences are relative to the largest pressure,
        the largest bound mu p_n, and the approach. The bar is what the certificate allows, 1e-6.""")
    rows, failed = [], []
    for problem in textbook.problems()[5:8:2] if quick else textbook.problems():
        say(problem.name)
        c = problem.compare(program)
        rows.append([c.name, c.elements, c.contact, c.adhesion, f"{c.pressure:.0e}", f"{c.shear:.0e}", f"{c.approach:.0e}",
                     verdict(c.passed())])
        failed += [] if c.passed() else [c.name]
    page.table(["problem", "elements", "in contact", "in adhesion", "pressure", "shear", "approach", ""], rows)
    return failed

def whole_contacts(page, program, files, say):
    """Against the 3-D analysis: bem_contact, and exact kinematics with the same influence functions."""
    page.text("""**An independent 3-D finite-element contact analysis**: 20-node bricks, an exact gap and exact kinematics (deformed
        surfaces against each other, pressure along the deformed normal), sharing nothing with this project. S1002 on 60E1,
        lateral displacement 6.6 mm, 1e5 N, no friction. Its uncertainty is stated as 0.02 % in Fy and approach, 0.4 % in
        pmax, 1 % in the area. With linear kinematics in the 3-D analysis too, its largest pressure and ours agree within 0.05 %.""",
              """In brackets: difference to the analysis. `linear` and `placed` are bem_contact, `solver.contact_motion`; `linear`, the
        default, takes distances and normals of the undeformed surfaces. Bars: 1 %, area 3 %, centre of pressure 0.05 mm;
        pmax 2 % on rows of 0.5 mm, because their place on the rail changes it by 1.3 %. Fy of `forces stay`: 0.1 %.""")
    removed = gauge_corner.CASES[REMOVED]
    say("shipped files")
    found = gauge_corner.solved_by_program(program, (*removed[:4], 0.5, *removed[5:]), (textbook.RAIL, textbook.WHEEL), "linear")
    page.text("Shipped files, 0.5 x 0.5 mm, structural motion removed:")
    failed = against_analysis(page, REMOVED, {"linear": found}, {"linear": BARS})
    if not files:
        return failed
    folder, bodies = files["rail_60E1_gauge_corner"].parent, gauge_corner.touching(program)
    for name, bars in BARS_OF.items():
        say(name)
        case = gauge_corner.CASES[name]
        own = [gauge_corner.influence_file(program, folder, kind, held) for kind, held in zip(("rail", "wheel"), case)]
        ours = {motion: gauge_corner.solved_by_program(program, case, own, motion) for motion in ("linear", "placed")}
        finer = gauge_corner.exact_contact(program, bodies, gauge_corner.halved(case), own)
        ours |= {"exact kinematics": finer.solve(gauge_corner.FORCE), "forces stay": finer.solve(gauge_corner.FORCE, stay=True)}
        page.text(f"{name[0].upper()}{name[1:]}, influence files of the gauge corner, {case[3]} x {case[4]} mm (the last two columns "
                  "on rows half as wide):")
        failed += against_analysis(page, name, ours, {"linear": bars, "placed": bars, "forces stay": {"Fy": 1e-3}})
    page.text("""**What remains, and why.** `exact kinematics` is a solution in Python with our influence functions
        (`tools/verification/deformed_contact.py`): gap between deformed surfaces, pressure along the deformed normal. In plane strain it
        agrees with a closed form within 4e-5. Its Fy is 0.5 % above that of the analysis. `forces stay` is the same, but the force of
        each element on the wheel stays where it was as the bodies touched, although the surfaces slide 0.064 mm past each other. It gives
        the analysis's Fy within 0.008 % with structural motion removed, and within 0.08 % with web and rim held. So we infer that the analysis pairs forces like this,
        which is no exact kinematics; its program was not at hand. Other causes change Fy by at most 0.08 %: a longer rail, the
        undeformed normal, elements half as long or wide, shifted rows, rows paired 0.1 mm apart.""")
    remote_sections(page, program, folder, bodies, say)
    page.text("""Recorded, not repeated by this command: the stretch of the surfaces under that pressure (mean of du_x/dx, weighted with
        pressure, structure removed) is -1008.5e-6 on the rail and -801.9e-6 on the wheel; ours -1009.5e-6 and -802.3e-6. For the rail
        held at its foot and the wheel at its bore see
        [tools/BENCHMARKS.md](../tools/BENCHMARKS.md#whole-contacts-with-exact-kinematics).""")
    return failed

def remote_sections(page, program, folder, bodies, say):
    """How far the approach depends on the remote sections it is relative to."""
    case, files = gauge_corner.CASES[REMOVED], {}
    for other in ("", *gauge_corner.OTHER_REMOTE_SECTIONS):
        say(f"remote section: {other or 'as shipped'}")
        files[other] = [gauge_corner.influence_file(program, folder, kind, held, other)
                        for kind, held in zip(("rail", "wheel"), case)]
    found = {other: gauge_corner.exact_contact(program, bodies, case, pair).solve(gauge_corner.FORCE, stay=True)
             for other, pair in files.items()}
    shipped = found.pop("")
    page.text("""The approach is 0.2 % below that of the analysis with structural motion removed, and agrees where it is included (`forces
        stay`). With `removed` it is relative to the remote sections, and their place is a convention. The table changes that place:
        the 0.2 % are half a millimetre of D, the least distance of that section from the strip (20 mm), or strips longer by 1.5 mm at each
        end.""")
    page.table(["remote section", *(f"{q}, change" for q in gauge_corner.QUANTITIES[:3])],
               [[other, *(f"{100 * (r[q] / shipped[q] - 1):+.3f} %" for q in gauge_corner.QUANTITIES[:3])]
                for other, r in found.items()])

def against_analysis(page, name, ours, bars):
    """A table, a row for each quantity; what is above its bar. ours: {heading: values}; bars: {heading: {quantity: bar}}."""
    failed, rows = [], []
    for q, reference in zip(gauge_corner.QUANTITIES, gauge_corner.BRICKS[name]):
        good, cells = True, []
        for heading, values in ours.items():
            difference = values[q] - reference if q.startswith("centre") else values[q] / reference - 1
            cells.append(f"{number(values[q], 6)} ({difference:+.4f} mm)" if q.startswith("centre") else
                         f"{number(values[q], 6)} ({100 * difference:+.3f} %)")
            if abs(difference) > bars.get(heading, {}).get(q, np.inf):
                good = False
                failed.append(f"3-D analysis, {name}, {heading}: {q}")
        rows.append([f"{q}, {gauge_corner.UNITS[q]}", number(reference, 6), *cells, verdict(good)])
    page.table(["quantity", "3-D analysis", *ours, ""], rows)
    return failed

def influence_functions(page, program, files, quick, say):
    page.heading("4 Influence functions by finite elements")
    failed = []
    if files:
        page.text("""Michell: displacements of a disc and of a bore (in a block of half width 100 mm, so that a third of a per cent
            is the block's) in plane strain, for loads without resultant and without rigid motion. Then exact contacts, solved
            with these files.""")
        say("Michell")
        checks = [kernels.michell_check("disc", files["disc"], 9.8, 1.5e-3), kernels.michell_check("bore", files["bore"], 10, 5e-3)]
        found, rows = study_rows([kernels.persson_fem(program, files), kernels.flat_block(program, files)], quick, say)
        page.table(["body", "quantity", "stations", "difference", "bar", ""],
                   [[c.name, c.quantity, c.sizes[0], percent(c.ours[0]), percent(c.bar), verdict(c.passed())] for c in checks])
        page.table(HEAD, rows)
        page.text("""Persson's solution is one of small clearance; here it is 2 % of the radius. That and the error of the files make
            the 0.2 % that smaller elements do not take away.""")
        failed += [f"{c.name}: {c.quantity}" for c in checks + found if not c.passed()]
    else:
        page.text("""The checks against Michell, Persson and Hertz were not run: they need influence files that `fem_influence`
            makes, and it was not built.""")
    failed += whole_contacts(page, program, files, say)
    page.text("""The harmonic and the 3-D method of `fem_influence` differ by at most 0.069 % of the self number on seven bodies:
        [tools/BENCHMARKS.md](../tools/BENCHMARKS.md#both-methods-on-seven-bodies).""")
    return failed

def model_limits(page, program, quick, say):
    page.heading("5 Limits of the models")
    page.text("""Half-space and tangent plane on a case that is exactly known, a pin in a hole (Persson 1964; plane strain, no
        friction, clearance 0.0002 mm on a radius of 10 mm): error of the largest pressure, and what `auto` predicts for the
        half-space from the turn of the normal. The prediction should not be below the error. The tangent plane is exact
        here by its construction; for a ball in a seat and for rails it is not (bem_contact/theory/placing.md, section 2).""")
    say("limits of the models")
    rows = kernels.model_limits(program, quick)
    page.table(["half angle, degrees", "half-space", "predicted for it", "tangent plane", ""],
               [[r[0], f"{100 * r[1]:+.2f} %", f"{100 * r[3]:.1f} %", f"{100 * r[2]:+.3f} %",
                 verdict(abs(r[1]) <= r[3] and abs(r[2]) < 2e-3)] for r in rows])
    return [f"limits of models, {r[0]} degrees" for r in rows if abs(r[1]) > r[3] or abs(r[2]) >= 2e-3]

def not_validated(page):
    page.heading("6 Limits that were measured")
    page.items("""Linear kinematics: 0.9 % in Fy and 0.3 % in pmax at the gauge corner at equal position, which is 0.003 mm of
        lateral displacement; `solver.contact_motion = "placed"` leaves 0.2 % of Fy at most and 0.3 %
        of the approach. With rail foot and wheel bore held 6 % in Fy unless
        the bodies are placed by their structural motion, as they are by default (section 4).""",
               """Small errors of the input may be enlarged: `tools/stability` tables by how much, and the condition
        numbers of the influence matrices.""",
               "Influence files: each states its own error, 1 to 5 times the true one on 84 files (fem_influence/ERRORS.md).",
               """Stresses below a curved surface use half-space formulas from the tractions found; a warning says where the
        surface is too curved. `stresses.in = "bodies"` takes those of the real bodies, with the error of their finite elements.""")
    page.heading("7 What is not validated")
    page.items("**Measurements**: creep forces of one locomotive, and the shape of one curve of a roller rig "
               "([VALIDATION.md](VALIDATION.md)). No ultrasonic or pressure-film contact patch, no wear.",
               "**Coulomb's law** and its coefficients: friction that falls with slip, third bodies, water, temperature.",
               "**Plasticity**: beyond first yield the pressure is that of an elastic body.",
               "**Roughness and measured profiles**: noise on a profile changes the contact; the exact solutions are smooth.",
               "**Inertia** of the contact, and waves; bodies that change along x within the contact (squats, welds, switches).",
               "**Web, disc and ballast** of a real vehicle and track: structural motion is that of the body file's section and support.",
               "**Steady rolling with friction at large conformity** has no exact solution. The solver is checked there by section 3, "
               "the influence functions by section 4, their combination only by the certificate.")

def test_programs(page, program, quick, say):
    page.heading("8 Tests of the source tree with checks of their own")
    rows, failed = [], []
    for name, chosen, what, also_quick in PROGRAMS:
        path = program.bin / name
        if (quick and not also_quick) or not path.exists():
            rows.append([f"`{name}`", chosen, what, "not run" + ("" if path.exists() else ": not built")])
            continue
        say(name)
        done = subprocess.run([path, f"--gtest_filter={chosen}", "--gtest_brief=1"], capture_output=True, text=True,
                              env=program.environment, cwd=program.folder)
        passed = re.search(r"\[  PASSED  \] (\d+) test", done.stdout)
        rows.append([f"`{name}`", chosen, what, f"{passed[1] if passed else 0} passed, {verdict(done.returncode == 0)}".rstrip(", ")])
        failed += [] if done.returncode == 0 else [f"{name} {chosen}"]
    page.table(["program", "tests", "what they show", ""], rows)
    return failed

def versions(page, program, files, seconds, failed):
    page.heading("9 Versions and digests")
    used = {file.name: file for file in (textbook.RAIL, textbook.WHEEL, *files.values())}
    rows = [["source tree", commit()], ["program", f"{program.version()}, sha256 {digest(program.path)[:16]}"],
            ["date", time.strftime("%Y-%m-%d", time.gmtime())],
            ["Python, NumPy, h5py", f"{platform.python_version()}, {np.__version__}, {h5py.__version__}"],
            ["system", f"{platform.system()} {platform.machine()}"], ["seconds of this run", f"{seconds:.0f}"]]
    rows += [[f"influence file {name}", f"sha256 {digest(file)[:16]}"] for name, file in sorted(used.items())]
    page.table(["what", "version"], rows)
    page.text(f"**{len(failed)} checks fail**: " + "; ".join(failed) + "." if failed else "All checks hold.")
    return str(ROOT)
