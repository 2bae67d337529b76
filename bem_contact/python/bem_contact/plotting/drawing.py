"""Which module draws which kind of file."""

from pathlib import Path

import matplotlib

from . import bodies, conicity, curves, fatigue, influence, inside, meshes, profiles, results, sections, style, sweep, tables, wear
from .kinds import from_file, kind_of, require_output, to_file
from .refusals import refuse

DRAW = {"result": results.draw_result, "comparison": results.draw_comparison, "wheelset": results.draw_wheelset, "sweep": sweep.draw,
        "creep curves": curves.draw, "fit": curves.draw, "conicity": conicity.draw, "conicity map": conicity.draw_map, "fatigue": fatigue.draw, "stresses": inside.draw, "wear": wear.draw, "table": tables.draw,
        "mesh": meshes.draw, "sections": sections.draw, "sections table": sections.draw, "influence file": influence.draw}
PROFILES = ("profile", "profile table")
WITH_BODIES = ("result", "comparison")  # meshes of both bodies may follow
MESHES = (".msh", ".toml")


def draw(files, picture, options):
    """The figure; of a film nothing. `picture`: where it is written; None: nowhere."""
    first, *others = files
    kind = from_file(first, lambda: kind_of(first))
    with_bodies = kind in WITH_BODIES and others and not options and all(Path(name).suffix in MESHES for name in others)
    if kind not in PROFILES and not with_bodies and (others or options):
        refuse(f"'{first}' is drawn alone", f"{(options + others)[0]} is more", "Leave it out.")
    film = picture is not None and require_picture(Path(picture), kind, files)
    with matplotlib.rc_context():  # a notebook keeps its own style
        style.use()
        if film:
            from_file(first, lambda: to_file(picture, lambda: wear.animate(files, Path(picture))))
            return None
        figure = from_file(first, lambda: profiles.draw(files, options) if kind in PROFILES else
                           bodies.draw(files) if with_bodies else DRAW[kind](files))
        if picture is not None:
            to_file(picture, lambda: style.save(figure, picture))
        return figure


def require_picture(picture, kind, files):
    """Whether it is a film. Refuses what is no picture, and one that would overwrite what is drawn."""
    film = kind == "wear" and picture.suffix in wear.FILMS
    if picture.suffix.lower() not in style.PICTURES and not film:
        refuse(f"'{picture}' is no picture", "its ending is none of " + ", ".join(style.PICTURES), "Give one of these.")
    require_output(picture, files)
    return film
