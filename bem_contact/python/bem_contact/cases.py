"""The cases of a sweep, as columns."""

from .notebook import sweep_html
from .plotting.refusals import require_module


class Sweep(dict):
    """The columns of a sweep by their names, as a dict; help(bem_contact.sweep) says which there are."""

    def to_frame(self, rows="cases"):
        """A DataFrame of pandas: one row for each case, or, of rows="patches", for each patch.

        The columns of patches `case` and `patch` say whose they are. Raises InputError where pandas is missing.
        """
        pandas = require_module("pandas", "There is no DataFrame")
        if rows == "cases":
            return pandas.DataFrame({name: column for name, column in self.items() if name != "patches"})
        return pandas.DataFrame(self[rows])

    def _repr_html_(self):
        return sweep_html(self)
