"""Conformal wheel-rail contact: scenes (TOML files) solved from Python. Units mm, N, MPa, rad.

    import bem_contact
    r = bem_contact.solve("scene.toml", {"position.lateral": 6.6})
    if r.certified:
        print(r.pmax, r.Fx, r.p_n.shape)      # MPa, N, [ms][mx]

`help(bem_contact.solve)` and `help(bem_contact.Result)` say what goes in and what comes out.
"""

from ._core import ConvergenceError, InputError, Result, Sequence, Table, __commit__, __version__, compare, conicity, creep_curves, fatigue, read_table, report, solve, table, wear, wheelset

__all__ = ["ConvergenceError", "InputError", "Result", "Sequence", "Table", "__commit__", "__version__", "compare", "conicity", "creep_curves",
           "fatigue", "read_table", "report", "solve", "table", "wear", "wheelset"]
