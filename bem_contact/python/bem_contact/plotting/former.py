"""How versions of bem_contact wrote their files. What a picture needs is asked here, so that no other module knows it.

Before 0.2 the fields of a result lay in a group named as its model, beside the coordinates of all models; numbers were
attributes, some with a unit in their names; and some groups had other names.
"""

import h5py

from .kinds import text


def value(group, *names):
    """The number or text of that name in a group: a dataset today, an attribute before. Further names are former ones."""
    for name in names:
        if name in group.attrs:
            found = group.attrs[name]
            return text(found) if isinstance(found, (bytes, str)) else float(found)
        if name in group and isinstance(group[name], h5py.Dataset):
            return float(group[name][()])
    raise KeyError(names[0])


def part(group, *names):
    """The first of these groups that is there; the group itself where none is."""
    return next((group[name] for name in names if name in group), group)


def results_in(group):
    """{model: (coordinates, result)} of a group."""
    if "p_n" in group:
        return {text(group.attrs["model"]): (group, group)}
    return {name: (item if "x" in item else group, item) for name, item in group.items() if isinstance(item, h5py.Group) and "p_n" in item}


def sizes_of(coordinates, result):
    """Length and width of an element, mm."""
    if "dx_mm" in coordinates.attrs:
        return value(coordinates, "dx_mm"), value(coordinates, "ds_mm")
    return value(result["quantities"], "dx"), value(result["quantities"], "ds")


def certificate_of(result):
    """Whether a result is certified, its worst violation, and which is allowed."""
    certified = value(result, "certified", "certificate_holds")
    worst = value(result["quantities"], "certificate") if "certificate" in result["quantities"] else value(result, "certificate_worst")
    return bool(certified), worst, value(part(result, "certificate"), "tolerance", "certificate_tolerance")


def set_of(comparison):
    """The results of a comparison: the name of their set, and its group."""
    for name in ("at_equal_forces", "at_equal_position"):
        for known in (name, name.removeprefix("at_")):
            if known in comparison:
                return name, comparison[known]
    raise KeyError("at_equal_forces")


def curves_of(file):
    """The groups of creep curves, and the vertical force, the bound of friction and the mean radius."""
    return part(file, "curves"), value(file, "Fz", "Fz_N"), value(file, "bound", "bound_N"), value(file, "radius", "radius_mm")


def table_names(file):
    """Axes, columns, and columns that are held to the tolerance, of a table."""
    return [value(file, *names).split() for names in (("axis_names", "axes"), ("column_names", "columns"), ("held",))]


def bodies_of(file, side):
    """Names of wheel and rail on one side of a conicity."""
    return [text(file[side].attrs[body] if side in file else file.attrs[f"{side}_{body}"]) for body in ("wheel", "rail")]


def wheel_of(wheelset, side):
    """The result of one wheel."""
    return part(wheelset[side], "result")
