"""Profiles from arrays."""

import hashlib
import tempfile
from os import PathLike, fspath, path

_plain_names = {}  # {file: what it holds}
_folder = None  # of the files of this process; they are removed when it ends


def _file(text, kind):
    """A file with this text; the same for the same text."""
    global _folder
    if _folder is None or not path.isdir(_folder.name):
        _folder = tempfile.TemporaryDirectory(prefix="bem_contact_profiles_")
    ending = {"wheel": ".whl", "rail": ".ban", "sections": ".slcs", "wheel_sections": ".slcw"}[kind]
    name = f"profile_{hashlib.sha256(text.encode()).hexdigest()[:12]}{ending}"
    file = path.join(_folder.name, name)
    if not path.exists(file):
        with open(file, "w", encoding="ascii") as out:
            out.write(text)
    return file


def in_plain_names(text):
    """A message with the arrays for their files."""
    for file, name in list(_plain_names.items()):
        text = text.replace(file, name)
    return text


class Profile(PathLike):
    """A profile of your own, for wherever a profile file or a standard's name goes.

        rail = bem_contact.Profile(y, z, kind="rail")
        r = bem_contact.solve("scene.toml", {"rail.profile": rail})

    `y` to the field side and `z` down, mm, point by point, as a profile file has them: a rail with its top at y = 0, a
    wheel with its tape circle there. It is read as such a file is: with the same repairs, warnings and keys (smoothing,
    nominal, unit, profile_z, mirror, flange_back). `kind`: "rail" or "wheel".

    `fspath()` is a file that holds the points with all their digits until this process ends. To solve a result file again
    later, save the points in a file of your own.
    """

    def __init__(self, y, z, kind):
        from ._core import InputError
        if kind not in ("rail", "wheel"):
            raise InputError(f"There is no kind of profiles {kind!r} (there are rails and wheels) Give kind=\"rail\" or kind=\"wheel\".")
        try:
            y, z = ([float(value) for value in values] for values in (y, z))
        except (TypeError, ValueError) as error:
            raise InputError(f"The points of this profile cannot be used (y and z are no lists of numbers: {error}) Give two lists or arrays of one "
                             "dimension, in mm.") from None
        if len(y) != len(z):
            raise InputError(f"The points of this profile cannot be used (there are {len(y)} y and {len(z)} z) Give one of each for each point.")
        self.kind = kind
        self._path = _file("".join(f"{a!r} {b!r}\n" for a, b in zip(y, z)), kind)
        _plain_names[self._path] = f"the array of a {kind} ({len(y)} points)"

    _path = None  # of one that was made by Profile.__new__() alone

    def __fspath__(self):
        if self._path is None:
            raise TypeError("This profile has no points (it was made without them) Call bem_contact.Profile(y, z, kind).")
        return self._path

    def __str__(self):
        return self.__fspath__()

    def __repr__(self):
        return f"<Profile of a {self.kind}, {path.basename(self._path)}>" if self._path else "<Profile without points>"


class Sections(PathLike):
    """A rail whose section changes along the track, for wherever `rail.profile` goes; or a wheel that changes round its axle.

        rail = bem_contact.Sections([0, 500], [Profile(y0, z0, "rail"), Profile(y1, z1, "rail")])
        r = bem_contact.solve("scene.toml", {"rail.profile": rail, "position.along": 250})
        wheel = bem_contact.Sections([0, 3.1], ["S1002", Profile(y, z, "wheel")], kind="wheel")

    `at`: places along the track, rising, mm; of a wheel: angles within one turn, rad. `profiles`: one for each, a Profile, a
    profile file or a standard's name, all with the same origin. `features`: for each section the lengths along the chords of its
    points, from the first one (gauge side), at which the feature lines lie, mm; below 0 where it does not have one. Without them
    what corresponds is found. `kind`: "rail" or "wheel".

    `fspath()` is a slices file (.slcs, .slcw) that lasts until this process ends.
    """

    def __init__(self, at, profiles, features=None, kind="rail"):
        from ._core import InputError
        if kind not in ("rail", "wheel"):
            raise InputError(f"There is no kind of sections {kind!r} (there are rails and wheels) Give kind=\"rail\" or kind=\"wheel\".")
        at, profiles = [float(place) for place in at], list(profiles)
        features = [[] for _ in at] if features is None else [[float(s) for s in of] for of in features]
        if not len(at) == len(profiles) == len(features):
            raise InputError(f"The sections of this {kind} cannot be used (there are {len(at)} places, {len(profiles)} profiles and {len(features)} lists "
                             "of features) Give one of each for each section.")
        if len({len(of) for of in features}) > 1:
            raise InputError(f"The features of this {kind} cannot be used (each is a line through all sections, and some sections have more than others) "
                             "Give each section as many, below 0 where it does not have one.")
        names = [path.abspath(profile) if path.exists(profile) else fspath(profile) for profile in profiles]
        text = f"0 1\n{len(at)}\n{len(features[0]) if features else 0}\n1\n"
        text += "".join(f"{u!r} '{name}'\n" for u, name in zip(at, names))
        text += "".join(f"{u!r} {' '.join(map(repr, of))}\n" for u, of in zip(at, features) if len(of) > 1)
        self._path = _file(text, "sections" if kind == "rail" else "wheel_sections")
        _plain_names[self._path] = f"the {len(at)} sections of a {kind}"

    def __fspath__(self):
        return self._path

    def __str__(self):
        return self._path
