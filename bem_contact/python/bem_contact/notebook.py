"""How a Result and a Sweep show themselves in a notebook."""

from html import escape
from math import isnan

from .plotting.shared import VIEWS

_MOST_ROWS = 20  # of a sweep


def _text(value):
    if value is None or isinstance(value, float) and isnan(value):
        return "–"
    return f"{value:.6g}" if isinstance(value, (int, float)) else str(value)


def _table(head, rows):
    cells = lambda kind, row: "".join(f"<{kind}>{escape(_text(cell))}</{kind}>" for cell in row)  # noqa: E731
    return f"<table><thead><tr>{cells('th', head)}</tr></thead><tbody>" + "".join(f"<tr>{cells('td', row)}</tr>" for row in rows) + "</tbody></table>"


def result_html(result):
    """The main numbers with their errors, and what to know before they are used."""
    rows = []
    for name in VIEWS["result"]["main"]:
        value, error = getattr(result, name, None), getattr(result, f"{name}_error", None)
        if value is not None and not isnan(value):
            rows.append((name, value, "" if error is None else f"± {error:.2g}", result.units.get(name, "")))
    state = "Certified" if result.certified else f"NOT certified: {result.why_not_certified}"
    return (f"<p>{escape(state)}. Model: {escape(result.model)}.</p>" + _table(("", "value", "error", "unit"), rows)
            + "".join(f"<p>Warning: {escape(text)}</p>" for text in result.warnings))


def sweep_html(sweep):
    """The keys swept over and the main numbers of the first cases."""
    names = [name for name in sweep if "." in name] + ["status"] + [name for name in VIEWS["sweep"]["columns"] + ["T_gamma"] if name in sweep]
    count = len(sweep["status"])
    rows = [[i] + [sweep[name][i] if isinstance(sweep[name][i], str) else float(sweep[name][i]) for name in names] for i in range(min(count, _MOST_ROWS))]
    more = f"<p>{count - _MOST_ROWS} more cases; to_frame() has all.</p>" if count > _MOST_ROWS else ""
    return f"<p>{count} cases</p>" + _table(["case", *names], rows) + more
