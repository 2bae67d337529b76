"""Conformal wheel-rail contact: scenes (TOML files) solved from Python. Units mm, N, MPa, rad.

    import bem_contact
    r = bem_contact.solve("scene.toml", {"position.lateral": 6.6})
    if r.certified:
        print(r.pmax, r.Fx, r.p_n.shape)      # MPa, N, [ms][mx]

Every error that says what is wrong and what to do is a `bem_contact.Error`: `InputError` (a `ValueError` too) for wrong
input, `ConvergenceError` (a `RuntimeError` too) where there is no certified result, and `Error` itself where the machine
is to blame, as when the disk gets full.

Each command of the program has a function here, or is called as a command:

    solve         solve(), or Sequence for many cases     wheelset      wheelset()
    compare       compare()                               creep-curves  creep_curves()
    check         check()                                 table         table(), read_table()
    profile       profile(), standards()                  wear          wear()
    sweep         sweep()                                 fatigue       fatigue(), of a Result
    conicity      conicity(), conicity_map()              report        report()
    plot          plot()                                  study         study()
    shakedown     shakedown(), of a Result                fit           fit()

    info, influence, stresses, schema, new, replay, fmu, from-contact, explore, options such as --csv    python3 -m bem_contact info FILE.h5, from a shell

A profile of your own may be arrays: Profile(y, z, kind) goes wherever a profile file goes,
and Sections(at, profiles) wherever rail.profile goes, for a rail that changes along the track, or a wheel round its axle.

`help(bem_contact.solve)` and `help(bem_contact.Result)` say what goes in and what comes out; each function and class has such a text.
Classes: Result, Sequence, Table, Sweep, Profile, Sections, Error, InputError, ConvergenceError.
"""
# Without a list __all__: with it, help() would print what the classes inherit, 600 lines, before the functions.

from .cases import Sweep
from .plotting import plot
from .profiles import Profile, Sections
from .studies import study

try:
    from ._core import ConvergenceError, Error, InputError, Result, Sequence, Table, __commit__, __version__, check, compare, conicity, conicity_map, creep_curves, fatigue, fit, profile, read_table, report, shakedown, solve, standards, sweep, table, wear, wheelset
except ModuleNotFoundError as missing:
    if missing.name != f"{__name__}._core":
        raise

    def __getattr__(name):  # pictures need no compiled part
        import sys
        if name.startswith("__"):
            raise AttributeError(name)
        raise ImportError(
            f"the compiled part of bem_contact is missing (it was not built, or not for this Python {sys.version_info.major}."
            f"{sys.version_info.minor}) Call cmake --build --preset full --target bem_contact_python, and use "
            "/usr/bin/python3.", name=f"{__name__}._core")
