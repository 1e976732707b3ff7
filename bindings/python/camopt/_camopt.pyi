# SPDX-License-Identifier: MIT
import os
from collections.abc import Callable, Sequence as Sequence_
from typing import Any, overload

import numpy as np
import numpy.typing as npt

__version__: str

Numbers = npt.NDArray[np.float64]
_Option = float | str | os.PathLike[str] | None
_Callback = Callable[["Progress"], object] | None

def licenses() -> str: """The terms for distributing this module, and the licences of its libraries."""

class InputError(ValueError):
    """Invalid input: the message says what was found and what is allowed."""
class UnavailableError(InputError):
    """A capability that this build of camopt does not have; the message names the package to install."""
class ModelError(ValueError):
    """A user-defined rule is invalid: a wrong shape, a value that is not finite."""

class Number:
    """A number with its partials by x, y, v, a and j: the argument of a user-defined function.

    It takes + - * / **, abs, comparisons (by its value) and NumPy's sqrt, exp, log, sin, cos, tan, arcsin,
    arccos, arctan, arctan2, sinh, cosh and tanh."""
    @property
    def value(self) -> float: """Without its partials."""
    def __add__(self, other: Number | float) -> Number: ...
    def __radd__(self, other: Number | float) -> Number: ...
    def __sub__(self, other: Number | float) -> Number: ...
    def __rsub__(self, other: Number | float) -> Number: ...
    def __mul__(self, other: Number | float) -> Number: ...
    def __rmul__(self, other: Number | float) -> Number: ...
    def __truediv__(self, other: Number | float) -> Number: ...
    def __rtruediv__(self, other: Number | float) -> Number: ...
    def __pow__(self, other: Number | float) -> Number: ...
    def __rpow__(self, other: Number | float) -> Number: ...
    def __neg__(self) -> Number: ...
    def __pos__(self) -> Number: ...
    def __abs__(self) -> Number: ...
    def __lt__(self, other: Number | float) -> bool: ...
    def __le__(self, other: Number | float) -> bool: ...
    def __gt__(self, other: Number | float) -> bool: ...
    def __ge__(self, other: Number | float) -> bool: ...
    def __bool__(self) -> bool: ...
    def sqrt(self) -> Number: """Square root."""
    def exp(self) -> Number: """e to this power."""
    def log(self) -> Number: """Natural logarithm."""
    def sin(self) -> Number: """Sine."""
    def cos(self) -> Number: """Cosine."""
    def tan(self) -> Number: """Tangent."""
    def arcsin(self) -> Number: """Arc sine."""
    def arccos(self) -> Number: """Arc cosine."""
    def arctan(self) -> Number: """Arc tangent."""
    def sinh(self) -> Number: """Hyperbolic sine."""
    def cosh(self) -> Number: """Hyperbolic cosine."""
    def tanh(self) -> Number: """Hyperbolic tangent."""
    def arctan2(self, other: Number | float) -> Number: """Angle of the point (other, self)."""

def evaluate_rule(rule: Any, point: Numbers) -> tuple[float, Numbers, Numbers]:
    """Value, gradient by (x, y, v, a, j) and Hessian by (y, v, a, j) of a rule at such a point."""

class Peak:
    """A largest magnitude and where it is reached."""
    @property
    def value(self) -> float: """The magnitude, without units; may be infinite."""
    @property
    def at(self) -> float: """x, the cam angle over that of the rise."""
    def __float__(self) -> float: ...

class Peaks:
    """V, A, J = max |y'|, |y''|, |y'''| over x, the torque figure max |y' y''|, and root mean squares.

    Exact, also between samples; no units."""
    @property
    def velocity(self) -> Peak: """V, a Peak."""
    @property
    def acceleration(self) -> Peak: """A, a Peak."""
    @property
    def jerk(self) -> Peak: """J, a Peak."""
    @property
    def torque(self) -> Peak: """max |y' y''|, a Peak."""
    @property
    def rms_velocity(self) -> float: """Square root of the mean of y'²."""
    @property
    def rms_acceleration(self) -> float: """Square root of the mean of y''²."""
    @property
    def rms_jerk(self) -> float: """Square root of the mean of y'''²."""

class Motion:
    """A motion y(x) with its first three derivatives.

    x = cam angle / rise angle, y = displacement / lift; no units. Call it with numbers or arrays."""
    @overload
    def __call__(self, x: float, order: int = 0, side: str = "right") -> float:
        """The derivative of that order (0 … 3) at x, in the shape of x.

        side: where a derivative jumps, its limit from the "left" or the "right". Raises InputError for an x
        outside [begin, end]."""
    @overload
    def __call__(self, x: npt.ArrayLike, order: int = 0, side: str = "right") -> Numbers:
        """The derivative of that order (0 … 3) at x, in the shape of x.

        side: where a derivative jumps, its limit from the "left" or the "right". Raises InputError for an x
        outside [begin, end]."""
    @property
    def begin(self) -> float: """The least x."""
    @property
    def end(self) -> float: """The largest x: 1 for DRD, 1 + return / rise for RR."""
    @property
    def breakpoints(self) -> Numbers:
        """Ascending x where a derivative may jump or change its formula, both ends included."""

class Law(Motion):
    """A classical motion law: a rise of 1 over 0 <= x <= 1."""
    @property
    def key(self) -> str: """Its name in scenes: "modified_sine"."""
    @property
    def title(self) -> str: """Its name in reports."""
    @property
    def source(self) -> str: """Who described it."""
    @property
    def continuity(self) -> int: """The highest derivative that is continuous everywhere, both ends included."""
    @property
    def peaks(self) -> Peaks: """Its exact Peaks; an impulse is an infinite jerk."""

def laws() -> list[str]: """The names of all classical laws, in the order of the catalogue."""
def law(name: str) -> Law:
    """The law of that name, with its customary parameters. Raises InputError for an unknown name."""

class ReadScene:
    """A scene that was read and checked; a constant. See camopt.Scene."""
    def __init__(
        self,
        text: str,
        source: str,
        settings: Sequence_[str],
        terms: Sequence_[Any] = [],
        limits: Sequence_[Any] = [],
        alone: bool = False,
    ) -> None: ...
    @property
    def text(self) -> str: """The text as given."""
    @property
    def source(self) -> str: """Its name in messages."""
    @property
    def settings(self) -> list[str]: """What was set on top of it."""
    def toml(self) -> str: """One TOML text that reads back as this scene, bit for bit."""

def settled_text(text: str, source: str, settings: Sequence_[str]) -> str:
    """The TOML of a text with settings on top; keys and values are not validated."""
def read_text(path: str) -> str: """The text of a scene file. Raises InputError where it cannot be read."""
def scene_keys(table: str = "") -> list[str]:
    """Every key that a table of a scene ("motion", "limits", …; "" the top level) may have, as written."""
def scene_keys_markdown() -> str: """Every key of a scene with its unit, range, default and meaning, as Markdown."""

class OwnTermValue:
    """The value of a user-defined cost term."""
    @property
    def name(self) -> str: """Of the term."""
    @property
    def weight(self) -> float: """As given."""
    @property
    def reference(self) -> float: """As given."""
    @property
    def value(self) -> float: """Its largest along the motion, in its own unit; 0 where it is nowhere above."""
    @property
    def at(self) -> float: """x."""

class Constraint:
    """A limit of the scene, as written, and the value reached."""
    @property
    def name(self) -> str: """"velocity", "pressure_angle", …"""
    @property
    def key(self) -> str: """As written: "limits.velocity_mm_s"."""
    @property
    def limit(self) -> float: """In `unit`."""
    @property
    def worst(self) -> float: """The worst value over all cam angles, in `unit`."""
    @property
    def unit(self) -> str: """"deg", "mm", …; empty: none."""
    @property
    def at(self) -> float: """x of the worst value."""
    @property
    def at_deg(self) -> float: """The same as a cam angle from the start of the scene, in degrees."""
    @property
    def active(self) -> bool: """Whether the limit is reached."""
    @property
    def no_contact(self) -> bool: """There is no figure: the follower cannot touch the cam."""

class CompanionChange:
    """A number that changes together with another one: the dwell that becomes shorter."""
    @property
    def key(self) -> str: """Of the scene."""
    @property
    def given(self) -> float: """As it is, in the unit of the key."""
    @property
    def solved(self) -> float: """In the solve that found a motion."""

class Relaxation:
    """The least change of one number that makes an infeasible scene feasible."""
    @property
    def key(self) -> str: """Of the scene."""
    @property
    def given(self) -> float: """As it is, in the unit of the key."""
    @property
    def needed(self) -> float | None: """The boundary of feasibility; None if none was found."""
    @property
    def solved(self) -> float | None: """`needed` rounded to the feasible side: a solve with it found a motion."""
    @property
    def ruled_out(self) -> bool: """It is proved that no value helps."""
    @property
    def also(self) -> list[CompanionChange]: """What changes along with it: a list of CompanionChange."""

class Spline:
    """The motion as one spline over x. See Solution.bspline."""
    @property
    def degree(self) -> int: """3, 5 or 7."""
    @property
    def continuity(self) -> int: """The highest continuous derivative."""
    @property
    def breakpoints(self) -> Numbers: """Ascending x, both ends included."""
    @property
    def knots(self) -> Numbers: """Clamped: degree + 1 fold at both ends."""
    @property
    def coefficients(self) -> Numbers: """Control points over `knots`."""

class Solution:
    """What was found for a scene: the verdict, the proof, the motion, the cam, the files."""
    @property
    def verdict(self) -> str: """"optimal", "local", "feasible", "infeasible" or "failed"."""
    @property
    def success(self) -> bool: """Whether there is a motion that satisfies every limit."""
    @property
    def message(self) -> str: """The verdict as a sentence."""
    @property
    def reason(self) -> str: """Why the verdict is not better, one word; empty if there is no reason."""
    @property
    def fun(self) -> float | None: """The objective of the motion found; None without one."""
    @property
    def bound(self) -> float | None: """A proved lower bound of the objective; None without a proof."""
    @property
    def gap(self) -> float | None: """(fun − bound) / max(1, |fun|); None without a proof."""
    @property
    def proof(self) -> str: """The kind of proof of the bound: "duality", "any_curve_limit", "boxes" or "none"."""
    @property
    def any_curve_limit(self) -> float | None: """A lower bound for curves of any kind; None if unknown."""
    @property
    def worst_violation(self) -> float: """Of all limits over all cam angles, relative; <= 0: all are satisfied."""
    @property
    def stationarity(self) -> float | None:
        """Norm of the gradient of the Lagrangian with the best multipliers; None where not computed."""
    @property
    def solver(self) -> str: """The backend that ran."""
    @property
    def iterations(self) -> int: """Of the backend."""
    @property
    def convex(self) -> bool: """Whether the problem is convex: the optimum is then the global one."""
    @property
    def seconds(self) -> float: """Wall time of the whole solve, s."""
    @property
    def notes(self) -> list[str]: """Notes on the result."""
    @property
    def relaxation(self) -> list[Relaxation]:
        """Of an infeasible scene: for each limit the least change of it alone that helps."""
    @property
    def motion(self) -> Motion | None:
        """The Motion found, callable; None where nothing was found. Where the output is prescribed, the cam's."""
    @property
    def output(self) -> Motion | None:
        """The Motion of the output where dynamics.prescribe = "output"; None: it is `motion`."""
    @property
    def peaks(self) -> Peaks | None:
        """The exact Peaks of the motion, normalised as the scene's limits; None without a motion."""
    @property
    def spline(self) -> Spline | None: """The motion as one Spline; None for a program and without a motion."""
    def bspline(self) -> Any:
        """The motion as a scipy.interpolate.BSpline of y over x. Needs SciPy; raises InputError for a program."""
    @property
    def own_terms(self) -> list[OwnTermValue]: """The user-defined terms, a list of OwnTermValue."""
    @property
    def constraints(self) -> list[Constraint]: """Every limit of the scene, a list of Constraint."""
    @property
    def drive(self) -> dict[str, float] | None:
        """Torque, speed and power of the motor of [drive] as result.json has them; None without a motor."""
    @property
    def valve(self) -> dict[str, Any] | None:
        """Events, durations, areas and accelerations of a valve lobe as result.json has them; None for other motions."""
    @property
    def least(self) -> dict[str, Any] | None:
        """How far the number of objective.least or largest went, as result.json has it: key, value,
        impossible, verdict, …; None where the scene seeks none."""
    def table(self) -> dict[str, Numbers]:
        """The motion as columns {name: array}: those of motion.csv, the unit in the name. 361 even cam angles, the
        breakpoints and the peaks; where the jerk jumps an angle stands twice."""
    def profile(self, points: int | None = None) -> dict[str, Numbers]:
        """The cam as columns {name: array}: those of profile.csv (cam_x_mm, pitch_x_mm, normal_x, …), in the frame of
        the cam.

        points: about so many, evenly by cam angle; None: a polyline through them is within 1 µm of the cam. A radius
        is infinite where the cam is straight. Raises InputError without a plane cam."""
    def to_json(self) -> str: """The text of result.json: what `camopt solve --json` prints."""
    def to_dict(self) -> dict[str, Any]:
        """The same as a dict: peaks and dimensions with units, segments, design, evaluations."""
    def certificate(self) -> str: """The text of certificate.json: the proof, from which the bound can be recomputed."""
    def summary(self) -> str: """What `camopt solve` prints."""
    def dxf(self, tolerance_mm: float = 0.001) -> str:
        """The cam as DXF text: arcs within the tolerance of the exact curve. Raises InputError without a plane cam."""
    def svg(self, what: str = "motion") -> str: """A picture as SVG text: of the "motion" or of the "cam"."""
    def write(self, folder: str, points: int | None = None, dxf: bool = False) -> list[str]:
        """Writes the result folder that `camopt solve --out` writes; returns the paths."""
    def _repr_svg_(self) -> str | None: """For notebooks: the picture of the motion."""
    def _repr_html_(self) -> str: """For notebooks: the summary, the motion, the cam."""
    def files(self) -> list[str]:
        """The names of the files that file() and export() make of this solution: "report.html", "codesys.st",
        "drawing.pdf", "cam.step", "cam.nc", …"""
    def file(self, name: str, **options: _Option) -> bytes:
        """The bytes of one of files().

        Raises InputError for another name, an NC program that its check refuses, a cam that is open or
        undercut; UnavailableError for STEP or PDF in a build without the library.

        Options are those of `camopt export` with _ for -: cutter_mm=12, direction="conventional", bore_mm, post (a
        file), points, … (`camopt list keys` lists them all). None is the default; lengths end in _mm, _in or _m."""
    def export(self, folder: str | os.PathLike[str], names: Sequence_[str], **options: _Option) -> list[str]:
        """Writes some of files() into a folder, all or none; returns the paths. Raises as file().

        Options are those of `camopt export` with _ for -: cutter_mm=12, direction="conventional", bore_mm, post (a
        file), points, … (`camopt list keys` lists them all). None is the default; lengths end in _mm, _in or _m."""
    def drawing(self, format: str = "pdf", **options: _Option) -> bytes:
        """The workshop drawing of a disk cam or drum as bytes: "pdf", "svg" or "dxf", to scale, mm. Options bore_mm, thickness_mm.

        Of the second disk of a conjugate cam: file("drawing_second.pdf")."""
    def nc(self, **options: _Option) -> str:
        """The NC program of the cam as text (G-code), after its check. Raises InputError where the check finds a fault;
        file("cam_nc_check.txt") says what it found.

        Options are those of `camopt export` with _ for -: cutter_mm=12, direction="conventional", bore_mm, post (a
        file), points, … (`camopt list keys` lists them all). None is the default; lengths end in _mm, _in or _m."""
    def step(self, **options: _Option) -> str:
        """STEP, as text, mm: a disk cam as a solid, the flanks of a three-dimensional cam as surfaces. Options bore_mm,
        thickness_mm. Raises UnavailableError in a build without Open CASCADE."""
    def plc(self, controller: str, **options: _Option) -> str:
        """The motion as an electronic cam, as text: of "codesys", "twincat", "twincat7", "siemens", "br", "rockwell", "omron",
        "lenze" or "csv". Master in deg, slave in mm or deg. Option points: evenly over the revolution; default: the joints of
        the motion."""
    def report(self, format: str = "md") -> str:
        """The report as text: "md" is report.md, Markdown, "html" is report.html, a page that needs nothing else."""

class Progress:
    """How far a solve is. str() of it is its line."""
    @property
    def message(self) -> str: """One short line."""
    @property
    def round(self) -> int | None: """Of the exchange of cam angles, from 1; None where unknown."""
    @property
    def incumbent(self) -> float | None: """Objective of the best motion so far, or None."""
    @property
    def bound(self) -> float | None: """Lower bound proved so far, or None."""
    @property
    def violation(self) -> float | None: """Of the incumbent, relative to each limit; <= 0: all are satisfied."""

def solve(scene: ReadScene, progress: _Callback = None) -> Solution:
    """Solves a scene that was read. progress: called with a Progress now and then. Other threads run meanwhile."""

class Sequence:
    """Neighbouring scenes one after another, each solved from what the last one found."""
    def __init__(self) -> None: ...
    def solve(self, scene: ReadScene, progress: _Callback = None) -> Solution:
        """As solve(), but an infeasible scene is not explained: no relaxation is searched."""

class MachineSolution:
    """What was found for a machine of several axes: its speed with the proof of what stops it, the motions."""
    @property
    def verdict(self) -> str: """"optimal", "local", "feasible", "infeasible" or "failed"."""
    @property
    def speed_rpm(self) -> float | None: """The speed of the motions delivered; None without any."""
    @property
    def impossible_above_rpm(self) -> float | None:
        """The speed at which it is proved that no motions exist; None without a proof."""
    @property
    def at_standstill(self) -> bool: """Whether the machine contradicts itself at any speed."""
    @property
    def fun(self) -> float | None: """The total objective; None where nothing is delivered."""
    @property
    def axes(self) -> dict[str, Solution]: """A dict of one Solution an axis, by name; empty where there is none."""
    @property
    def notes(self) -> list[str]: """Notes on the result."""
    @property
    def seconds(self) -> float: """Wall time of the whole solve, s."""
    def to_json(self) -> str: """What `camopt machine --json` prints."""
    def to_dict(self) -> dict[str, Any]:
        """The same as a dict: limited_by, clearances, timing, the result of every axis."""
    def summary(self) -> str: """What `camopt machine` prints."""
    def svg(self) -> str | None: """The timing diagram as SVG text; None where nothing is delivered."""
    def write(self, folder: str, plc: Sequence_[str] = ...) -> None:
        """Writes the folder that `camopt machine --out` writes. plc: formats of electronic cams, for every axis."""
    def _repr_svg_(self) -> str | None: """For notebooks: the timing diagram."""

def solve_machine(
    file: str,
    settings: Sequence_[str],
    speed_gap: float | None = None,
    max_seconds: float | None = None,
    progress: _Callback = None,
) -> MachineSolution:
    """Solves a machine file with settings "KEY=VALUE", or "AXIS.KEY=VALUE" of the scene of an axis."""

class SweepTable:
    """The rows of a sweep, by number: one solve each."""
    def __len__(self) -> int: ...
    @property
    def keys(self) -> list[str]: """The keys that vary."""
    def to_dict(self) -> dict[str, npt.NDArray[Any]]:
        """The columns {name: array}, those of sweep.csv: pandas.DataFrame(table.to_dict()) is the table.

        A number that does not exist (the peaks of an infeasible row) is NaN."""
    def csv(self) -> str: """The text of sweep.csv, as `camopt sweep` writes it."""
    def summary(self) -> str: """The sweep in a few lines."""

def sweep(
    scene: ReadScene,
    axes: Sequence_[tuple[Sequence_[str], npt.ArrayLike]],
    chunk: int | None = None,
    workers: int = 1,
    progress: Callable[[int, int], object] | None = None,
) -> SweepTable:
    """Solves every point of the grid of the axes [(keys, values), …]. progress: called with (done, all)."""
def varied_key(text: str) -> tuple[list[str], Numbers]:
    """Keys and values of "KEY=a:b:count", "KEY=a:b:count:log" or "KEY=v1,v2,…"."""
def simplex(divisions: int) -> tuple[list[str], Numbers]:
    """Keys and values of all weights i/N, j/N, k/N of velocity, acceleration and jerk with i + j + k = N."""

class ComparisonRow:
    """One law on the scene, or the optimum (an empty key)."""
    @property
    def key(self) -> str: """Of the law; empty: the optimum."""
    @property
    def title(self) -> str: """For people."""
    @property
    def misfit(self) -> str: """Why the law cannot make this motion at all; mostly empty."""
    @property
    def motion(self) -> Motion | None: """Its Motion on this scene; None where it does not fit."""
    @property
    def peaks(self) -> Peaks: """Its Peaks on this scene."""
    @property
    def fun(self) -> float: """The scene's objective of it; may be infinite."""
    @property
    def loss_percent(self) -> float | None: """Against the optimum; None where infinite."""
    @property
    def feasible(self) -> bool: """Whether it satisfies every limit."""

class Comparison:
    """Every classical law on one scene, compared with its optimum."""
    @property
    def optimum(self) -> Solution: """The Solution."""
    @property
    def rows(self) -> list[ComparisonRow]:
        """A list of ComparisonRow, best first; laws that violate a limit come last."""
    def to_json(self) -> str: """What `camopt compare --json` prints."""
    def summary(self) -> str: """What `camopt compare` prints."""
    def _repr_svg_(self) -> str: """For notebooks: a bar a law."""

def compare(scene: ReadScene, progress: _Callback = None) -> Comparison:
    """Every classical law on a scene that was read, compared with its optimum."""
