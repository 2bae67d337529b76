"""The page of tools/benchmarks/speed_error: for each scene processor time against error, and what to choose."""

import base64
import html
import io

from matplotlib.lines import Line2D

from bem_contact.plotting import style

NAMES = {"pmax": "largest pressure", "area": "area in contact", "Fx": "Fx", "Fy": "Fy", "Mz": "Mz", "T_gamma": "friction power"}
MARKS = {"halfspace": "o", "tangent_plane": "s", "fem": "D"}
BARS = (0.05, 0.02, 0.01, 0.005)
NEGLIGIBLE = 1e-5  # 1. Smaller errors are drawn here.
PAGE = """<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Speed against error</title><style>
body {{ font-family: sans-serif; max-width: 70em; margin: 2em auto; padding: 0 1em; color: #1c2733; line-height: 1.45 }}
table {{ border-collapse: collapse; font-size: .9em; margin: 1em 0 }} td, th {{ padding: .15em .7em; text-align: right; border-bottom: 1px solid #e3e7eb }}
img {{ max-width: 100% }}</style></head><body><h1>Speed against error</h1>
<p>Six scenes, three models of elasticity, elements from coarse to fine. Each point is a whole answer: contact search, influence
numbers, solution, certificate and estimate of the error. Time is processor time of one thread within a sequence of cases. Models
are compared at equal forces: each has the lateral displacement where it bears the same Fy with the finest elements (on the tread,
where Fy says little of the position, the same displacement), and the creepage that is equally far from its own free rolling. The error is that against finite elements with finer influence files on elements half as long and half as wide
as those of the finest grid here: of pmax, area and frictional power relative, of forces over the friction limit, of the moment
over that times the contact's mean radius.</p>
<p>An answer counts as good to 1 % if all six errors are within 1 %. A line goes along the answers of a model to which no
faster one is better. Filled marks have a number of elements (<code>grid.elements</code>), hollow ones an accuracy asked for
(<code>grid.accuracy</code>).</p>
{overview}{scenes}</body></html>
"""


def worst(row, quantities):
    return max(row[q] for q in quantities)


def front(rows, error):
    """Of these rows those to which no faster one is better, fastest first."""
    out = []
    for row in sorted(rows, key=lambda r: r["seconds"]):
        if not out or error(row) < error(out[-1]):
            out.append(row)
    return out


def draw(axis, rows, error, label):
    """Points of all models, and the front of each."""
    for model, (_, _, dash) in style.MODELS.items():
        of_model = [r for r in rows if r["model"] == model]
        if not of_model:
            continue
        for asked, face in (("grid.elements", style.INK), ("grid.accuracy", "none")):
            some = [r for r in of_model if r["asked"] == asked]
            axis.loglog([1e3 * r["seconds"] for r in some], [100 * max(error(r), NEGLIGIBLE) for r in some], linestyle="none",
                        marker=MARKS[model], color=style.INK, markerfacecolor=face, markersize=4.5)
        best = front(of_model, error)
        axis.loglog([1e3 * r["seconds"] for r in best], [100 * max(error(r), NEGLIGIBLE) for r in best], color=style.INK, linestyle=dash)
    axis.set(title=label)


def key(figure):
    """Below all panels: what marks and lines mean."""
    look = {"color": style.INK, "markersize": 5.5}
    models = [Line2D([], [], linestyle=dash, marker=MARKS[model], label=short, **look)
              for model, (_, short, dash) in style.MODELS.items() if model in MARKS]
    asked = [Line2D([], [], linestyle="none", marker="o", label="filled: a number of elements (grid.elements)", **look),
             Line2D([], [], linestyle="none", marker="o", markerfacecolor="none", label="hollow: an accuracy (grid.accuracy)", **look)]
    figure.legend(handles=models + asked, loc="upper center", bbox_to_anchor=(0.5, 0), ncol=5, handlelength=3, fontsize=9)


def overview(scenes, quantities):
    figure, axes = style.panels(2, 3, (11, 6.6), sharex=True, sharey=True)
    for axis, scene in zip(axes.flat, scenes):
        draw(axis, scene["rows"], lambda r: worst(r, quantities), scene["name"])
    for axis in axes[-1]:
        axis.set_xlabel("processor time of an answer, ms")
    for axis in axes[:, 0]:
        axis.set_ylabel("largest of six errors, %")
    for axis in list(axes.flat)[len(scenes):]:
        axis.set_visible(False)
    key(figure)
    return figure


def of_scene(scene, quantities):
    figure, axes = style.panels(2, 3, (11, 6.4), sharex=True)
    for axis, quantity in zip(axes.flat, quantities):
        draw(axis, scene["rows"], lambda r: r[quantity], NAMES[quantity])
    for axis in axes[-1]:
        axis.set_xlabel("processor time of an answer, ms")
    for axis in axes[:, 0]:
        axis.set_ylabel("error, %")
    key(figure)
    return figure


def advice(scene, quantities):
    """For each bar the fastest answer that is within it: lines of a table."""
    lines = []
    for bar in BARS:
        good = [r for r in scene["rows"] if worst(r, quantities) <= bar]
        if good:
            best = min(good, key=lambda r: r["seconds"])
            lines.append((f"{100 * bar:g} %", style.MODELS[best["model"]][1], f"{best['asked']} = {best['value']:g}", str(best["contact"]),
                          f"{1e3 * best['seconds']:.0f}", f"{100 * worst(best, quantities):.2g} %"))
        else:
            lines.append((f"{100 * bar:g} %", "none of these", "", "", "", ""))
    return lines


def paid_back(scene):
    """After how many cases the influence files took less time than the cases solved with them: at grid.elements 400."""
    online = [r["seconds"] for r in scene["rows"] if r["model"] == "fem" and (r["asked"], r["value"]) == ("grid.elements", 400)]
    return f", as long as {scene['offline'] / online[0]:.0f} cases with 400 elements in contact" if online else ""


def table(head, lines):
    cells = lambda tag, line: "<tr>" + "".join(f"<{tag}>{html.escape(str(c))}</{tag}>" for c in line) + "</tr>"
    return "<table>" + cells("th", head) + "".join(cells("td", line) for line in lines) + "</table>"


def picture(figure):
    out = io.BytesIO()
    style.save(figure, out)
    return f'<p><img alt="error over processor time" src="data:image/png;base64,{base64.b64encode(out.getvalue()).decode()}"></p>'


def section(scene, quantities):
    memory = {m: max((r["megabytes"] for r in scene["rows"] if r["model"] == m), default=0) for m in MARKS}
    all_rows = [(style.MODELS[r["model"]][1], f"{r['asked']} = {r['value']:g}", r["contact"], f"{1e3 * r['seconds']:.1f}",
                 f"{1e3 * r['first']:.0f}", *(f"{100 * r[q]:.2g}" for q in quantities)) for r in scene["rows"]]
    return (f"<h2>{html.escape(scene['name'].capitalize())}</h2><p>{html.escape(scene['title'].capitalize())}. The influence files took "
            f"{scene['offline']:.0f} s of processor time{paid_back(scene)}. Most memory, with Python: "
            + ", ".join(f"{style.MODELS[m][1]} {memory[m]:.0f} MB" for m in memory) + ".</p>"
            + table(("good to", "take", "with", "in contact", "ms", "largest error"), advice(scene, quantities))
            + picture(of_scene(scene, quantities)) + "<details><summary>All answers</summary>"
            + table(("model", "asked", "in contact", "ms", "first, ms", *(f"{NAMES[q]}, %" for q in quantities)), all_rows) + "</details>")


def page(scenes, quantities, folder):
    """Writes speed_error.html and speed_error.png. `scenes`: as tools/benchmarks/speed_error keeps them."""
    style.use()
    figure = overview(scenes, quantities)
    style.save(figure, folder / "speed_error.png")
    (folder / "speed_error.html").write_text(PAGE.format(overview=picture(figure), scenes="".join(section(s, quantities) for s in scenes)))
