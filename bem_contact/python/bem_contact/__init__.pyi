from collections.abc import Callable, Mapping, Sequence as _List
from concurrent.futures import Executor
from os import PathLike
from typing import Any, Final, Literal, overload

import numpy as np
from numpy.typing import NDArray

from ._numbers import Numbers as _Numbers  # the build writes it

__version__: str
__commit__: str

_Value = float | int | bool | str | PathLike[str] | _List[float] | NDArray[Any] | np.generic
_Changes = Mapping[str, _Value] | None
_Scene = str | PathLike[str] | Mapping[str, Any]
_Model = str | None  # a name that `bem_contact solve --help` lists, or ""
_Array = NDArray[np.float64]

class Error(Exception): ...
class InputError(Error, ValueError): ...
class ConvergenceError(Error, RuntimeError): ...

class Result(_Numbers):
    """One scene solved with one model. Arrays are copies. Can be copied and pickled."""

    # Parts.
    patches: Final[list[dict[str, float | None]]]
    history: Final[dict[str, _Array]]
    units: Final[dict[str, str]]
    stresses: Final[dict[str, Any] | None]
    structure: Final[dict[str, Any] | None]
    other_laterals: Final[list[float]]
    lateral_slope: Final[float | None]
    approach_datum: Final[str]
    track: Final[str]
    derivatives: Final[dict[str, Any] | None]
    conformity: Final[dict[str, Any] | None]
    x: Final[_Array]
    # Trust.
    found: Final[list[str]]
    model: Final[str]
    why_this_model: Final[str]
    why_not_certified: Final[str]
    why_no_errors: Final[str]
    warnings: Final[list[str]]
    warning_kinds: Final[list[str]]
    certified: Final[bool]
    converges_with_elements: Final[bool | None]
    seconds: Final[float]
    def __getitem__(self, path: str) -> Any: ...
    def save(self, file: str | PathLike[str]) -> None: ...
    def report(self, page: str | PathLike[str]) -> None: ...
    def plot(self, picture: str | PathLike[str] | None = None) -> Any: ...
    def _repr_html_(self) -> str: ...

class Sequence:
    def __init__(
        self, scene: _Scene, *, folder: str | PathLike[str] | None = None, threads: int = 1
    ) -> None: ...
    def solve(
        self,
        changes: _Changes = None,
        model: _Model = None,
        strict: bool = False,
        *,
        derivatives: str | _List[str] | None = None,
    ) -> Result: ...

def solve(
    scene: _Scene,
    changes: _Changes = None,
    model: _Model = None,
    strict: bool = False,
    *,
    folder: str | PathLike[str] | None = None,
    derivatives: str | _List[str] | None = None,
) -> Result: ...

def compare(
    scene: _Scene,
    models: _List[str] | None = None,
    changes: _Changes = None,
    *,
    folder: str | PathLike[str] | None = None,
) -> dict[str, Any]:
    """One scene with several models, at equal forces and at equal position: {model: Result} each; and creep forces.

    "at_equal_forces", "creep_forces" (Fx over the creepage beyond free rolling), "at_equal_position", "reference".
    """

def check(
    scene: _Scene, changes: _Changes = None, model: _Model = None, *, folder: str | PathLike[str] | None = None
) -> dict[str, list[str]]:
    """What would be solved, and whether the influence files suffice: "lines" and "warnings". Nothing is solved.

    A scene with a table [wheelset] is described as wheelset() would begin to solve it.
    """

class Sweep(dict[str, Any]):
    """The columns of a sweep by their names."""

    def to_frame(self, rows: Literal["cases", "patches"] = "cases") -> Any:
        """A DataFrame of pandas: one row for each case, or for each patch. InputError where pandas is missing."""
    def _repr_html_(self) -> str: ...

    def to_parquet(self, file: str | PathLike[str], rows: Literal["cases", "patches"] = "cases") -> None:
        """The same as a file of Parquet. InputError where pyarrow is missing."""

def sweep(
    scene: _Scene,
    changes: _Changes = None,
    model: _Model = None,
    *,
    folder: str | PathLike[str] | None = None,
    executor: Executor | None = None,
    output: str | PathLike[str] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Sweep:
    """The cases of a table [sweep] as columns: the keys swept over, "status", "reason", "model", the numbers, "patches".

    `output`: a folder that keeps what is solved, for the same call after a stop. `progress(done, of)`: called after each task.
    """

def profile(
    file: str | PathLike[str],
    kind: Literal["", "rail", "wheel"] = "",
    reading: _Changes = None,
    *,
    step: float = 0.1,
) -> dict[str, Any]:
    """What a profile says: "s", "y", "z" (mm), "inclination" (rad), "curvature" (1/mm), "noise", "like" ...

    `reading`: keys of [rail] or [wheel] of a scene, as {"smoothing": 8}.
    """

class Profile(PathLike[str]):
    """A profile of your own, for wherever a profile file or a standard's name goes."""

    kind: Literal["rail", "wheel"]
    def __init__(self, y: _List[float] | NDArray[Any], z: _List[float] | NDArray[Any], kind: Literal["rail", "wheel"]) -> None: ...
    def __fspath__(self) -> str: ...

class Sections(PathLike[str]):
    """A rail whose section changes along the track, or a wheel whose section changes round its axle."""

    def __init__(
        self,
        at: _List[float] | NDArray[Any],
        profiles: _List[str | PathLike[str]],
        features: _List[_List[float]] | None = None,
        kind: Literal["rail", "wheel"] = "rail",
    ) -> None: ...
    def __fspath__(self) -> str: ...

def standards() -> list[dict[str, Any]]:
    """All profiles of standards that are built in: "name", "kind", "part", "standard", "other_names", "remark" of each."""

def conicity(
    scene: _Scene | None = None,
    changes: _Changes = None,
    *,
    left_wheel: str = "",
    left_rail: str = "",
    roll: bool = False,
    to: float = 10.0,
    step: float = 1.0,
    folder: str | PathLike[str] | None = None,
) -> dict[str, Any]:
    """Rolling radius difference and equivalent conicity (EN 15302) of a wheelset: a dict of NumPy arrays.

    "function": over the lateral displacement (mm); "conicity": over the amplitude (mm), nan where there is no motion.
    """

def conicity_map(
    scene: _Scene | None = None,
    changes: _Changes = None,
    *,
    wheels: _List[str | PathLike[str]] | None = None,
    rails: _List[str | PathLike[str]] | None = None,
    gauges: _List[float] | NDArray[Any] | None = None,
    amplitude: float = 3.0,
    noise: float | None = None,
    draws: int = 20,
    seed: int = 1,
    roll: bool = False,
    folder: str | PathLike[str] | None = None,
    executor: Executor | None = None,
) -> dict[str, Any]:
    """Equivalent conicities of every wheel on every rail at every gauge (mm): "wheels", "rails", and "map" (arrays).

    With `noise` (mm) the points of the profiles scatter: mean and standard deviation over `draws` from `seed`.
    """

def creep_curves(
    scene: _Scene,
    changes: _Changes = None,
    model: _Model = None,
    *,
    xi: Any = None,
    eta: Any = None,
    phi: Any = None,
    folder: str | PathLike[str] | None = None,
    executor: Executor | None = None,
    measured: str | PathLike[str] | Mapping[str, Any] | None = None,
) -> dict[str, Any]:
    """Forces over creepages (each of xi, eta, phi: values, or None), slopes at zero, sensitivities; NumPy arrays.

    Matrices are [Fx, Fs, Mz][xi, eta, phi]. Without any values all three curves go from full slip to full slip.
    """

def fit(
    scene: _Scene,
    measured: str | PathLike[str] | Mapping[str, Any] | _List[str | PathLike[str] | Mapping[str, Any]],
    parameters: str | _List[str],
    changes: _Changes = None,
    model: _Model = None,
    *,
    folder: str | PathLike[str] | None = None,
) -> dict[str, Any]:
    """Keys of a scene by measured forces or pressures (CSV files, or dicts of columns xi, Fx, scatter or s, pn), with intervals of 95 %."""

def wheelset(
    scene: _Scene, changes: _Changes = None, model: _Model = None, *, folder: str | PathLike[str] | None = None
) -> dict[str, Any]:
    """Both wheels of a wheelset under the forces on its axle: "wheelset", "right" and "left" (numbers and Results)."""

def table(
    scene: _Scene | None = None,
    axes: Mapping[str, _List[float] | NDArray[Any]] | None = None,
    *,
    hold: _List[str] = ...,
    tolerance: float = 0.02,
    most_points: int = ...,
    ratio: tuple[float, float] = (0.5, 2.0),
    poisson: float = 0.28,
    elements: int = ...,
    output: str | PathLike[str] | None = None,
    folder: str | PathLike[str] | None = None,
    executor: Executor | None = None,
) -> dict[str, Any]:
    """Forces over axes, refined until the interpolation is within the tolerance; NumPy arrays, and `output` (HDF5).

    Without a scene: creep forces of an ellipse (Kalker's USETAB). With one: its axes, or those of its table [table].
    """

class Table:
    """A table to look up in; its members are what the dict of table() holds."""

    axes: Final[dict[str, NDArray[Any]]]
    first: Final[dict[str, NDArray[Any]]]
    values: Final[dict[str, NDArray[Any]]]
    errors: Final[dict[str, dict[str, Any]]]
    units: Final[dict[str, str]]
    creep_scale: Final[dict[str, NDArray[Any]] | None]
    tolerance: Final[float]
    solved: Final[int]

    def look_up(self, at: _List[float] | NDArray[Any]) -> dict[str, Any]:
        """Each column at a point, or at an array of points; InputError outside the axes."""

    def force(self, at: _List[float], columns: _List[str] | None = None) -> dict[str, dict[str, Any]]:
        """"values", "derivatives" by column and axis, and stated "errors" at a point; InputError outside the axes."""

    def creep_forces(
        self,
        a: float,
        b: float,
        shear_modulus: float,
        bound: float,
        xi: float = 0,
        eta: float = 0,
        phi: float = 0,
    ) -> dict[str, Any]:
        """Fx, Fy (N), Mz (N mm) and their errors; mm, MPa, N. InputError where a/b is outside the table."""

def read_table(file: str | PathLike[str]) -> Table:
    """Reads a table that table() or `bem_contact table` wrote."""

@overload
def wear(
    scene: _Scene,
    depth: float = 0.1,
    *,
    law: str = "energy",
    hardness: float = 3000,
    speed: float = 3e4,
    body: str = "both",
    cap: float = ...,
    smoothing: float = ...,
    passages: float = 1,
    kept_turn: float = ...,
    model: _Model = None,
    folder: str | PathLike[str] | None = None,
    executor: Executor | None = None,
) -> dict[str, Any]:
    """Profiles worn under the load collective of a scene's table [sweep]: mileage, depths, areas, profiles by step; of a rail of
    sections those of each section."""

@overload
def wear(
    result: Result,
    law: str = "energy",
    hardness: float = 3000,
    speed: float = 3e4,
    map: tuple[_List[float], _List[float], _List[_List[float]]] | None = None,
) -> dict[str, Any]:
    """What a result wears away: depth by passage and revolution over s, sliding distance, volume by rolled distance; of a wheel
    on a rail also by km, million axles and MGT."""

@overload
def fatigue(
    result: Result,
    yield_shear: float = 300,
    nodes: _List[float] = ...,
    damage: _List[float] = ...,
    stresses: bool = True,
    body: str | None = None,
) -> dict[str, Any]:
    """Shakedown point, FI_surf, T-gamma and damage of each patch; largest stresses below the surface."""

@overload
def fatigue(
    scene: _Scene,
    yield_shear: float = 300,
    nodes: _List[float] = ...,
    damage: _List[float] = ...,
    wear_is_negative: bool = False,
    folder: str | PathLike[str] | None = None,
    body: str | None = None,
) -> dict[str, Any]:
    """The same of each case of a table [sweep], a dict for each patch of all cases, and the damage of the collective."""

def shakedown(
    result: Result,
    yield_shear: float | None = None,
    dang_van_a: float | None = None,
    alpha: float | None = None,
    in_plane: bool = False,
    steel: str = "",
    initial_stress: str | None = None,
) -> dict[str, Any]:
    """Whether the steel below each patch yields never, once or for ever; shakedown bounds, Dang Van, Crossland; maps over the section."""

def study(
    scene: _Scene,
    output: str | PathLike[str],
    *,
    jobs: int = 0,
    folder: str | PathLike[str] | None = None,
    executor: Executor | None = None,
    influence: str | PathLike[str] | None = None,
) -> dict[str, Any]:
    """All answers that a scene asks for, in a folder, as `bem_contact study`: what study.h5 holds. Parts may be shared by an executor."""

def plot(
    file: str | PathLike[str],
    picture: str | PathLike[str] | None = None,
    *,
    others: _List[str | PathLike[str]] = (),
    options: _List[str] = (),
) -> Any:
    """A picture of what bem_contact wrote, or of a profile: matplotlib's Figure. `picture`: where it is written, too."""

def report(file: str | PathLike[str], output: str | PathLike[str]) -> None:
    """One HTML page of what a command wrote, or of an influence file (HDF5): words, tables, figures."""
