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

    def to_parquet(self, file, rows="cases"):
        """Writes what to_frame() has, one row group for some 100,000 rows, for DuckDB, Polars, pandas and others.

        Raises InputError where pyarrow is missing.
        """
        pyarrow, parquet = (require_module(name, "There is no file of Parquet", "Debian has no package of it: pip install pyarrow")
                            for name in ("pyarrow", "pyarrow.parquet"))
        columns = {name: column for name, column in self.items() if name != "patches"} if rows == "cases" else self[rows]
        parquet.write_table(pyarrow.table(columns), file, row_group_size=100_000)
