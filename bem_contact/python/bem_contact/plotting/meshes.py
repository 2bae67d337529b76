"""The mesh of a body: of a .msh file, or of a body file that mesh_body meshes for the picture."""

import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D

from ..program import program_file
from . import style
from .refusals import InputError, refuse, require_module

LOOKS = {"contact": (style.DEEPEST_PRESSURE, 2.6, "contact strip: unit tractions act here"), "held": (style.ADHESION, 2.6, "held: displacement zero")}
GOOD, USABLE = 0.3, 0.1  # scaled Jacobian of the worst element: a square has 1, a triangle or worse 0


@dataclass(frozen=True)
class Mesh:
    """A section: points (y, z) in mm, quadrilaterals and named edges by point number."""

    name: str
    points: np.ndarray
    quads: np.ndarray
    edges: dict

    def scaled_jacobian(self):
        """The smallest of each quadrilateral: the sine of a corner's angle, the worst corner."""
        corner = self.points[self.quads]
        after, before = np.roll(corner, -1, 1) - corner, np.roll(corner, 1, 1) - corner
        area = after[..., 0] * before[..., 1] - after[..., 1] * before[..., 0]
        sine = area / (np.linalg.norm(after, axis=2) * np.linalg.norm(before, axis=2))
        return np.where(sine.sum(1) < 0, -sine.max(1), sine.min(1))  # gmsh may count corners the other way round

    def border(self):
        """The edges that belong to one quadrilateral only."""
        sides = np.concatenate([self.quads[:, [k, (k + 1) % 4]] for k in range(4)])
        _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
        return sides[first[count == 1]]

    def placed(self, turn, shift):
        """The same elsewhere: turned, then shifted."""
        return Mesh(self.name, self.points @ turn.T + shift, self.quads, self.edges)


def read(file):
    """The mesh of a .msh file, or of a body file."""
    meshio = require_module("meshio", f"'{file}' cannot be drawn")
    if Path(file).suffix == ".toml":
        with tempfile.TemporaryDirectory() as folder:
            mesh = Path(folder) / "body.msh"
            make(file, mesh)
            return read(mesh)
    try:
        found = meshio.gmsh.read(file)
    except (Exception, SystemExit) as error:  # of meshio: many kinds
        refuse(f"'{file}' cannot be drawn", f"it is no whole mesh: {error or 'gmsh wrote another version'}", "Make it again with mesh_body.")
    quads, edges = found.cells_dict.get("quad"), found.cells_dict.get("line")
    if quads is None or any(kind in found.cells_dict for kind in ("tetra", "hexahedron")):
        refuse(f"'{file}' cannot be drawn", "it has no section of quadrilaterals", "Open a solid mesh in gmsh.")
    numbers = found.cell_data_dict.get("gmsh:physical", {}).get("line")
    groups = {name: edges[numbers == number] for name, (number, dimension) in found.field_data.items()
              if dimension == 1 and edges is not None and numbers is not None}
    return Mesh(Path(file).name, found.points[:, :2], quads, groups)


def make(body, mesh):
    """Meshes a body file."""
    contact = program_file()
    program = contact and Path(contact).with_name("mesh_body")
    if not program or not program.exists():
        refuse(f"'{body}' cannot be drawn", "the program mesh_body, which meshes a body file, was not found beside bem_contact",
               "Build everything (tools/demo), or draw a .msh file.")
    done = subprocess.run([program, body, "-o", mesh], capture_output=True, text=True, errors="replace")
    if done.returncode != 0:
        raise InputError(done.stderr.strip().removeprefix("error: "))


def quality(worst):
    """ "good" and what that means."""
    if worst >= GOOD:
        return f"good: above {GOOD:g}"
    return f"usable: above {USABLE:g}" if worst >= USABLE else f"poor: below {USABLE:g}"


def draw_elements(axis, mesh, face="none", **look):
    """Elements in thin lines, the strip and the held part in bold ones."""
    axis.add_collection(PolyCollection(mesh.points[mesh.quads], facecolor=face, edgecolor=style.FRAME, linewidth=0.35, **look))
    axis.add_collection(LineCollection(mesh.points[mesh.border()], color=style.INK, linewidth=0.9, **look))
    for name, (colour, width, _) in LOOKS.items():
        if len(mesh.edges.get(name, ())):
            axis.add_collection(LineCollection(mesh.points[mesh.edges[name]], color=colour, linewidth=width, capstyle="round", **look))


def key(mesh):
    """What bold lines mean: handles of a legend."""
    return [Line2D([], [], color=colour, linewidth=width, label=label) for name, (colour, width, label) in LOOKS.items()
            if len(mesh.edges.get(name, ()))]


def window(axis, points, margin):
    """Shows these points in their proportions, z down."""
    (y0, z0), (y1, z1) = points.min(0) - margin, points.max(0) + margin
    axis.set(xlim=(y0, y1), ylim=(z1, z0), aspect="equal", xlabel="y, mm", ylabel="z down, mm")
    axis.grid(False)


def draw(files):
    """The whole body, and the elements at its strip."""
    mesh = read(files[0])
    worst = mesh.scaled_jacobian().min()
    figure, axes = style.panels(1, 2, (12.5, 6.6))
    for axis in axes[0]:
        draw_elements(axis, mesh, face=style.OUTSIDE)
    window(axes[0, 0], mesh.points, 5)
    strip = mesh.points[mesh.edges["contact"].ravel()] if len(mesh.edges.get("contact", ())) else mesh.points
    window(axes[0, 1], strip, 0.25 * np.ptp(strip, axis=0).max())
    axes[0, 0].set_title(f"{Path(files[0]).name}: {len(mesh.quads)} quadrilaterals")
    axes[0, 1].set_title(f"The strip; worst scaled Jacobian {worst:.2f} ({quality(worst)})")
    if key(mesh):
        style.legend_beside(axes[0, 0], below=True, columns=1, handles=key(mesh))
    return figure
