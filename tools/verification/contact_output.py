"""What the program CONTACT printed (.ref_out, .out): totals of each case, in its own signs."""

import re

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[EeDd][-+]?\d+)?"
CASE = re.compile(r"^ ?Case +(\d+)(?:, result element +\d+)?\s*$")


def numbers(line: str) -> list:
    """The numbers of a line; one that was too wide for its column (*****) is None."""
    found = []
    for word in line.split():
        word = word.rstrip(",")
        if re.fullmatch(NUMBER, word):
            found.append(float(word.replace("D", "E").replace("d", "e")))
        elif set(word) == {"*"}:
            found.append(None)
    return found


def totals_of_case(lines: list) -> dict:
    """Fn, Fx, Fy, pmax of a case; of a wheel on a rail in the track's frame, and z_ws of the wheelset."""
    out = {}
    pressures = []
    for k, line in enumerate(lines):
        names = line.replace("SHIFT ", "SHIFT_").replace("CREEP ", "CREEP_").split()  # one name is two words
        after = numbers(lines[k + 1]) if k + 1 < len(lines) else []
        if names[:3] == ["FX(TR)", "FY(TR)", "FZ(TR)"] and len(after) >= 3:
            out.update(Fx=after[0], Fy=after[1], Fn=after[2], track=True)
        elif names[:2] == ["FN", "FX"] and len(after) >= 3 and not out.get("track"):
            out.update(Fn=after[0], Fx=after[1], Fy=after[2])
        elif "PMAX" in names and len(after) > names.index("PMAX"):
            pressures.append(after[names.index("PMAX")])
        elif names[:3] == ["S_WS", "Y_WS", "Z_WS"] and len(after) >= 3:
            out["z"] = after[2]
        elif "FSTAT" in names and "FKIN" in names and after and "friction" not in out:
            out["friction"] = after[names.index("FSTAT")] if len(names) <= 3 else None
    known = [p for p in pressures if p is not None]
    if known:
        out["pmax"] = max(known)
        out["patches"] = len(known)
    return out


def read(text: str) -> list:
    """The totals of every case, in the order of the file."""
    cases, lines = [], None
    for line in text.splitlines():
        if CASE.match(line):
            if lines is not None:
                cases.append(totals_of_case(lines))
            lines = []
        elif lines is not None:
            lines.append(line)
    if lines is not None:
        cases.append(totals_of_case(lines))
    return cases
