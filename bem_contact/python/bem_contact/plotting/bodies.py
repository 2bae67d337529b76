"""A contact between the meshes of its bodies: both sections, and the patch on the rail in space."""

import h5py
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from scipy.optimize import least_squares
from scipy.spatial import cKDTree

from . import meshes, style
from .contact import Contact, contacts_in, set_of
from .kinds import kind_of
from .refusals import refuse

AROUND = 34  # mm of the sections around the patch that are drawn in space
BEHIND, BEFORE = 18, 16  # mm along x: where wheel and rail are cut
LOOK = {"elev": 33, "azim": -38}
WHEEL_SHOWN = 75  # mm of its rim above the rail
FITS = 1.0  # mm: a mesh whose strip lies farther from the profile is that of another body
FACE = {"rail": "#e9edf1", "wheel": "#f3e4df"}


def contacts_of(file):
    """The most exact model first, and whether they bear equal forces."""
    if kind_of(file.filename) != "comparison":
        return [Contact(file)], False
    name = set_of(file)
    return contacts_in(file[name]), name == "at_equal_forces"


def sentence(contacts, at_equal_forces):
    """What the picture says."""
    first, *others = contacts
    name = style.MODELS[first.model][1]
    said = f"{name}: {first.numbers['pmax']:.0f} MPa"
    free = first.numbers.get("free_rolling_xi", np.nan)
    if not others or not np.isfinite(free):
        return f"{said} on {first.numbers['area']:.0f} mm² of a wheel on a rail"
    other = others[-1]
    change = 100 * (other.numbers["pmax"] / first.numbers["pmax"] - 1)
    where = "At equal forces" if at_equal_forces else "At equal position"
    return (f"{where} the {style.MODELS[other.model][1]}'s largest pressure is {abs(change):.1f} % {'high' if change > 0 else 'low'},\n"
            f"but its wheel rolls freely at a creepage of {1e3 * other.numbers['free_rolling_xi']:.2f} ‰ instead of {1e3 * free:.2f} ‰")


def place(mesh, profile, name, start):
    """The mesh where the profile of the contact lies. `start`: the shift that brings the contact point there."""
    strip = mesh.points[np.unique(mesh.edges["contact"])] if len(mesh.edges.get("contact", ())) else mesh.points
    near = cKDTree(np.concatenate([np.linspace(a, b, 20, endpoint=False) for a, b in zip(profile[:-1], profile[1:])]))

    def apart(placement):
        return near.query(strip @ turned(placement[0]).T + placement[1:])[0]

    fit = least_squares(apart, (0.0, *start))
    if fit.fun.max() > FITS:
        refuse(f"'{mesh.name}' cannot be drawn with this contact", f"its strip lies {fit.fun.max():.1f} mm from the profile of the {name}",
               "Name the meshes of its rail and of its wheel, in this order.")
    return mesh.placed(turned(fit.x[0]), fit.x[1:])


def turned(angle):
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def in_space(points, x):
    """Corners (y, z), z down, as (x, y, up)."""
    return np.stack((np.broadcast_to(x, points.shape[:-1]), points[..., 0], -points[..., 1]), axis=-1)


def swept(border, points, x):
    """The side faces of a section that is swept along x."""
    a, b = points[border[:, 0]], points[border[:, 1]]
    return np.stack((in_space(a, x[0]), in_space(b, x[0]), in_space(b, x[1]), in_space(a, x[1])), axis=1)


def outer(border, whole):
    """Those edges of a part that lie on the border of the whole body."""
    known = set(map(tuple, np.sort(whole, axis=1)))
    return np.array([edge for edge in border if tuple(sorted(edge)) in known])


def shaded(points, edges):
    """Grey by the inclination of each face: a round surface is seen as round."""
    along = points[edges[:, 1]] - points[edges[:, 0]]
    steep = np.abs(along[:, 1]) / np.linalg.norm(along, axis=1)
    return [(grey, grey * 1.01, grey * 1.02) for grey in 0.96 - 0.16 * steep]


def near_patch(mesh, middle):
    """The elements around the patch."""
    inside = np.abs(mesh.points[mesh.quads] - middle).max(axis=(1, 2)) < AROUND
    return meshes.Mesh(mesh.name, mesh.points, mesh.quads[inside], mesh.edges)


def patch_faces(contact):
    """Elements in contact as faces in space, and their pressures."""
    half = contact.ds / 2
    tangent = np.stack((np.gradient(contact.y, contact.s), np.gradient(contact.z, contact.s)), axis=1)
    middle = np.stack((contact.y, contact.z), axis=1)
    low, high = middle - half * tangent, middle + half * tangent
    i, j = np.where(contact.state > 0)
    left, right = contact.x[j] - contact.dx / 2, contact.x[j] + contact.dx / 2
    return np.stack((in_space(low[i], left), in_space(low[i], right), in_space(high[i], right), in_space(high[i], left)), axis=1), contact.pressure[i, j]


def draw_space(axis, contact, rail, wheel):
    """The rail is cut before the patch and the wheel behind it. The painter's order is ours: far things first."""
    middle = np.array([contact.y.mean(), contact.z.mean()])
    thin = {"edgecolor": style.FRAME, "linewidth": 0.3}
    part = near_patch(wheel, middle)
    axis.add_collection3d(Poly3DCollection(in_space(part.points[part.quads], -BEHIND), facecolor=FACE["wheel"], zorder=1, **thin))
    part = near_patch(rail, middle)
    outline = outer(part.border(), rail.border())
    greys = shaded(part.points, outline)
    axis.add_collection3d(Poly3DCollection(swept(outline, part.points, (-BEHIND, BEFORE)), facecolor=greys, edgecolor=greys, linewidth=0.3, zorder=2))
    faces, pressure = patch_faces(contact)
    colours = style.PRESSURE(pressure / (pressure.max() or 1))
    axis.add_collection3d(Poly3DCollection(faces, facecolor=colours, edgecolor=colours, linewidth=0.3, zorder=3))
    axis.add_collection3d(Poly3DCollection(in_space(part.points[part.quads], BEFORE), facecolor=FACE["rail"], zorder=4, **thin))
    axis.view_init(**LOOK)
    axis.set(xlim=(-AROUND, AROUND), ylim=middle[0] + np.array((-AROUND, AROUND)), zlim=-middle[1] + np.array((-AROUND, AROUND)))
    axis.set_box_aspect((1, 1, 1), zoom=1.55)
    axis.set_axis_off()
    return pressure.max()


def draw(files):
    """A result or a comparison, the mesh of its rail, the mesh of its wheel."""
    if len(files) != 3:
        refuse(f"'{files[0]}' cannot be drawn with {len(files) - 1} mesh", "a contact has two bodies", "Name the meshes of its rail and of its wheel.")
    with h5py.File(files[0]) as file:
        contacts, equal = contacts_of(file)
        first = contacts[0]
        patch = {name: float(first.group["patches"][name][0]) for name in ("y", "z", "rail_y", "rail_z", "wheel_y", "wheel_z")}
    if not np.isfinite(list(patch.values())).all():
        refuse(f"'{files[0]}' cannot be drawn with meshes", "it is not the contact of a wheel on a rail: its scene has no profiles", "Draw it alone.")
    at = np.array([patch["y"], patch["z"]])
    rail, wheel = (place(meshes.read(name), profile, body, at - (patch[f"{body}_y"], patch[f"{body}_z"]))
                   for name, profile, body in ((files[1], first.rail, "rail"), (files[2], first.wheel, "wheel")))
    figure = style.figure((12, 6.6))
    whole, space = figure.add_gridspec(1, 2, width_ratios=(1, 1.7))
    section, view = figure.add_subplot(whole), figure.add_subplot(space, projection="3d", computed_zorder=False)
    meshes.draw_elements(section, wheel, face=FACE["wheel"])
    meshes.draw_elements(section, rail, face=FACE["rail"])
    shown = np.concatenate((rail.points, wheel.points[wheel.points[:, 1] > rail.points[:, 1].min() - WHEEL_SHOWN]))
    meshes.window(section, shown, 4)
    section.set_title("Both bodies, meshed")
    pmax = draw_space(view, first, rail, wheel)
    view.set_title(f"The patch on the rail; the wheel is cut behind it\n{style.MODELS[first.model][1]}: pressure up to {pmax:.0f} MPa")
    figure.suptitle(sentence(contacts, equal), x=0.01, ha="left", fontsize=14, fontweight="bold")
    return figure
