from collections.abc import Mapping, Sequence as _List
from os import PathLike
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import NDArray

__version__: str
__commit__: str

_Value = float | int | bool | str | PathLike[str] | _List[float] | NDArray[Any] | np.generic
_Changes = Mapping[str, _Value] | None
_Scene = str | PathLike[str] | Mapping[str, Any]
_Model = Literal["", "auto", "hertz", "halfspace", "tangent_plane", "fem"] | None
_Array = NDArray[np.float64]

class Error(Exception): ...
class InputError(Error, ValueError): ...
class ConvergenceError(Error, RuntimeError): ...

class Result:
    """One scene solved with one model. Arrays are copies. Can be copied and pickled."""

    # Numbers; `units` has their units. An error is absolute; None: not known.
    @property
    def Fx(self) -> float: ...
    @property
    def Fy(self) -> float: ...
    @property
    def Fz(self) -> float: ...
    @property
    def Fs(self) -> float: ...
    @property
    def Mz(self) -> float: ...
    @property
    def approach(self) -> float: ...
    @property
    def pmax(self) -> float: ...
    @property
    def area(self) -> float: ...
    @property
    def adhesion_share(self) -> float: ...
    @property
    def friction_power(self) -> float: ...
    @property
    def xi(self) -> float: ...
    @property
    def eta(self) -> float: ...
    @property
    def phi(self) -> float: ...
    @property
    def creepage_x(self) -> float: ...
    @property
    def creepage_s(self) -> float: ...
    @property
    def patch_count(self) -> float: ...
    @property
    def contact(self) -> float: ...
    @property
    def adhesion(self) -> float: ...
    @property
    def slip(self) -> float: ...
    @property
    def mx(self) -> float: ...
    @property
    def ms(self) -> float: ...
    @property
    def dx(self) -> float: ...
    @property
    def ds(self) -> float: ...
    @property
    def reference_s(self) -> float: ...
    @property
    def reference_y(self) -> float: ...
    @property
    def reference_z(self) -> float: ...
    @property
    def reference_delta(self) -> float: ...
    @property
    def certificate(self) -> float: ...
    @property
    def outer_iterations(self) -> float: ...
    @property
    def normal_iterations(self) -> float: ...
    @property
    def tangential_iterations(self) -> float: ...
    @property
    def warning_count(self) -> float: ...
    @property
    def Fn_2(self) -> float: ...
    @property
    def lateral(self) -> float | None: ...
    @property
    def Tmax_rail(self) -> float | None: ...
    @property
    def Tmax_rail_error(self) -> float | None: ...
    @property
    def Tmax_wheel(self) -> float | None: ...
    @property
    def Tmax_wheel_error(self) -> float | None: ...
    @property
    def free_rolling_xi(self) -> float | None: ...
    @property
    def free_rolling_xi_error(self) -> float | None: ...
    @property
    def free_rolling_radius(self) -> float | None: ...
    @property
    def free_rolling_radius_error(self) -> float | None: ...
    @property
    def discretisation(self) -> float | None: ...
    @property
    def Fx_error(self) -> float | None: ...
    @property
    def Fy_error(self) -> float | None: ...
    @property
    def Fz_error(self) -> float | None: ...
    @property
    def Fs_error(self) -> float | None: ...
    @property
    def Mz_error(self) -> float | None: ...
    @property
    def approach_error(self) -> float | None: ...
    @property
    def pmax_error(self) -> float | None: ...
    @property
    def area_error(self) -> float | None: ...
    @property
    def adhesion_share_error(self) -> float | None: ...
    @property
    def friction_power_error(self) -> float | None: ...
    @property
    def xi_error(self) -> float | None: ...
    @property
    def eta_error(self) -> float | None: ...
    @property
    def creepage_x_error(self) -> float | None: ...
    @property
    def creepage_s_error(self) -> float | None: ...
    @property
    def Fn_2_error(self) -> float | None: ...
    # Parts.
    @property
    def patches(self) -> list[dict[str, float | None]]: ...
    @property
    def history(self) -> dict[str, _Array]: ...
    @property
    def units(self) -> dict[str, str]: ...
    @property
    def stresses(self) -> dict[str, Any] | None: ...
    @property
    def structure(self) -> dict[str, Any] | None: ...
    @property
    def other_laterals(self) -> list[float]: ...
    @property
    def lateral_slope(self) -> float | None: ...
    @property
    def lateral_error(self) -> float | None: ...
    @property
    def approach_datum(self) -> str: ...
    # Elements [ms][mx].
    @property
    def p_x(self) -> _Array: ...
    @property
    def p_s(self) -> _Array: ...
    @property
    def p_n(self) -> _Array: ...
    @property
    def T_rail(self) -> _Array: ...
    @property
    def T_wheel(self) -> _Array: ...
    @property
    def slip_x(self) -> _Array: ...
    @property
    def slip_s(self) -> _Array: ...
    @property
    def u_x(self) -> _Array: ...
    @property
    def u_s(self) -> _Array: ...
    @property
    def u_n(self) -> _Array: ...
    @property
    def work_rate(self) -> _Array: ...
    @property
    def element_power(self) -> _Array: ...
    @property
    def deformed_distance(self) -> _Array: ...
    @property
    def gap(self) -> _Array: ...
    @property
    def state(self) -> _Array: ...
    # Columns [mx] and rows [ms].
    @property
    def x(self) -> _Array: ...
    @property
    def s(self) -> _Array: ...
    @property
    def y(self) -> _Array: ...
    @property
    def z(self) -> _Array: ...
    @property
    def delta(self) -> _Array: ...
    @property
    def wheel_s(self) -> _Array: ...
    # Trust.
    @property
    def model(self) -> str: ...
    @property
    def reason(self) -> str: ...
    @property
    def why_no_errors(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def certified(self) -> bool: ...
    @property
    def converges_with_elements(self) -> bool | None: ...
    @property
    def seconds(self) -> float: ...

class Sequence:
    def __init__(
        self, scene: _Scene, *, folder: str | PathLike[str] | None = None, threads: int = 1
    ) -> None: ...
    def solve(self, changes: _Changes = None, model: _Model = None, strict: bool = False) -> Result: ...

def solve(
    scene: _Scene,
    changes: _Changes = None,
    model: _Model = None,
    strict: bool = False,
    *,
    folder: str | PathLike[str] | None = None,
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
    """What would be solved, and whether the influence files suffice: "lines" and "warnings". Nothing is solved."""

def sweep(
    scene: _Scene, model: _Model = None, *, folder: str | PathLike[str] | None = None
) -> dict[str, Any]:
    """The cases of a table [sweep] as columns: the keys swept over, "status", "reason", "model", the numbers, "patches"."""

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

def creep_curves(
    scene: _Scene,
    changes: _Changes = None,
    model: _Model = None,
    *,
    xi: Any = None,
    eta: Any = None,
    phi: Any = None,
    folder: str | PathLike[str] | None = None,
) -> dict[str, Any]:
    """Forces over creepages (each of xi, eta, phi: values, or None), slopes at zero, sensitivities; NumPy arrays.

    Matrices are [Fx, Fs, Mz][xi, eta, phi]. Without any values all three curves go from full slip to full slip.
    """

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
) -> dict[str, Any]:
    """Forces over axes, refined until the interpolation is within the tolerance; NumPy arrays, and `output` (HDF5).

    Without a scene: creep forces of an ellipse (Kalker's USETAB). With one: its axes, or those of its table [table].
    """

class Table:
    """A table to look up in; its members are what the dict of table() holds."""

    axes: dict[str, NDArray[Any]]
    first: dict[str, NDArray[Any]]
    values: dict[str, NDArray[Any]]
    errors: dict[str, dict[str, Any]]
    units: dict[str, str]
    creep_scale: dict[str, NDArray[Any]] | None
    tolerance: float
    solved: int

    def look_up(self, at: _List[float] | NDArray[Any]) -> dict[str, Any]:
        """Each column at a point, or at an array of points; InputError outside the axes."""

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
) -> dict[str, NDArray[Any]]:
    """Profiles worn under the load collective of a scene's table [sweep]: mileage, depths, areas, profiles by step."""

@overload
def wear(
    result: Result,
    law: str = "energy",
    hardness: float = 3000,
    speed: float = 3e4,
    map: tuple[_List[float], _List[float], _List[_List[float]]] | None = None,
) -> dict[str, Any]:
    """What a result wears away: depth by passage and revolution over s, sliding distance, volume by rolled distance."""

@overload
def fatigue(
    result: Result,
    yield_shear: float = 300,
    nodes: _List[float] = ...,
    damage: _List[float] = ...,
    stresses: bool = True,
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
) -> dict[str, Any]:
    """The same of each case of a table [sweep], as arrays over the patches of all cases, and the damage of the collective."""

def report(file: str | PathLike[str], output: str | PathLike[str]) -> None:
    """One HTML page of a result, a comparison, a sweep, creep curves, conicity, a wheelset or wear (HDF5): words, tables, figures."""
