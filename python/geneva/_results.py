"""What the functions of the package return."""

from __future__ import annotations

import dataclasses
import json
import os
import pathlib
from typing import Any, Callable, ClassVar, Dict, List, Mapping, Optional, Protocol, Tuple, TypeVar, Union

import numpy as np
import numpy.typing as npt

from geneva import _core
from geneva._case import Case
from geneva._figures import Array, Curves, Figure, unit_of

Path = Union[str, "os.PathLike[str]"]
Anything = TypeVar("Anything")


class Communicator(Protocol):
    """What is used of a communicator of mpi4py."""

    @property
    def rank(self) -> int: ...

    def py2f(self) -> int: ...

    def bcast(self, obj: Any, root: int = 0) -> Any: ...


class _Handle(Protocol):
    """What the compiled results have in common."""

    @property
    def given(self) -> _core.Case: ...

    def table(self) -> str: ...

    def document(self) -> str: ...

    def write(self, directory: "os.PathLike[str]") -> Tuple[List[str], List[str]]: ...


@dataclasses.dataclass(frozen=True)
class Written:
    """What is worth knowing when results have been written."""

    directory: pathlib.Path
    removed: Tuple[str, ...]  # files of results of another case, or of this one before it was changed
    missing_packages: Tuple[str, ...]  # without which the report lacks its interactive parts


def _on_first_rank(comm: Optional[Communicator], task: Callable[[], Anything]) -> Anything:
    """What a task returns on rank 0, on all ranks; what it raises there, all raise."""
    if comm is None:
        return task()
    outcome: Any = None
    if comm.rank == 0:
        try:
            outcome = (task(), None)
        except Exception as error:  # which is raised again on all ranks
            outcome = (None, error)
    result, raised = comm.bcast(outcome)
    if raised is not None:
        raise raised
    return result  # type: ignore[no-any-return]


def figures_of(rows: List[Dict[str, Any]]) -> Tuple[Figure, ...]:
    return tuple(Figure(**row) for row in rows)


class Result:
    """What all results have in common."""

    def __init__(self, handle: _Handle, comm: Optional[Communicator] = None) -> None:
        self._handle: Any = handle
        self._comm = comm

    @property
    def case(self) -> Case:
        """The case that was computed."""
        return Case(self._handle.given)

    @property
    def document(self) -> Dict[str, Any]:
        """All that is known, in SI units: the content of the JSON file that `write` makes (doc/results.md)."""
        return json.loads(self._handle.document())  # type: ignore[no-any-return]

    def table(self) -> str:
        """The figures as the command line prints them, in the case's own units."""
        return self._handle.table()  # type: ignore[no-any-return]

    def write(self, directory: Path) -> Written:
        """Writes the files of the command line, the report among them. With several ranks all call it.

        :raises InputError: if the directory cannot be written; it is then as it was
        """
        directory = pathlib.Path(directory)

        def write() -> Tuple[List[str], List[str]]:
            return self._handle.write(directory)  # type: ignore[no-any-return]

        removed, missing = _on_first_rank(self._comm, write)
        return Written(directory, tuple(removed), tuple(missing))

    def __repr__(self) -> str:
        return f"<geneva.{type(self).__name__} of {self.case.name}>"


class _Figured(Result):

    @property
    def figures(self) -> Tuple[Figure, ...]:
        """The rows of the table."""
        return figures_of(self._handle.figures())

    def figure(self, name: str) -> Figure:
        """The figure of that name.

        :raises KeyError: if there is none, with the names that there are
        """
        figures = self.figures
        for figure in figures:
            if figure.name == name:
                return figure
        raise KeyError(f"{name!r}: there are {', '.join(repr(figure.name) for figure in figures)}")


class _Judged(Result):

    @property
    def limits(self) -> Tuple[Figure, ...]:
        """Figures with a limit of the case or the materials."""
        return figures_of(self._handle.limits())


class _Noticed(Result):

    @property
    def notices(self) -> Tuple[str, ...]:
        """What one should know before trusting the figures."""
        return tuple(self._handle.notices)


@dataclasses.dataclass(frozen=True)
class Step:
    """A step of the active set: refinement level, unknowns, step (0 where a mesh begins) and its linear iterations."""

    mesh: int
    unknowns: int
    step: int
    linear_iterations: int


@dataclasses.dataclass(frozen=True)
class Mesh:
    """A mesh that has been solved."""

    cells: int
    unknowns: int
    peak_pressure: float  # [Pa]
    error: float  # of that, extrapolated, relative
    active_nodes: int
    linear_iterations: Tuple[int, ...]  # of each active-set step
    seconds: float  # since the start of the contact solve


def mesh_of(row: Mapping[str, Any]) -> Mesh:
    return dataclasses.replace(Mesh(**row), linear_iterations=tuple(row["linear_iterations"]))


@dataclasses.dataclass(frozen=True)
class Check:
    """Something that must be small in a sound result."""

    name: str
    meaning: str
    value: float
    limit: float

    @property
    def is_passed(self) -> bool:
        return self.value <= self.limit


@dataclasses.dataclass(frozen=True, repr=False)
class _Measured:
    """Fields with dimensions, in the units of a system."""

    _dimensions: ClassVar[Mapping[str, str]] = {}

    @property
    def units(self) -> Dict[str, str]:
        """Names of the units by the names of the fields."""
        return {name: unit_of(dimension, self._system)[0] for name, dimension in self._dimensions.items()}

    @property
    def _system(self) -> str:
        return getattr(self, "system")  # type: ignore[no-any-return]


def _in_units(measured: Any, units: str) -> Any:
    changes = {name: getattr(measured, name) * unit_of(dimension, units)[1] / unit_of(dimension, measured.system)[1]
               for name, dimension in measured._dimensions.items()}
    return dataclasses.replace(measured, system=units, **changes)


@dataclasses.dataclass(frozen=True, repr=False)
class Contact(_Measured):
    """What a contact pair carries: of the pair, and at the n nodes of its source surface."""

    _dimensions: ClassVar[Mapping[str, str]] = {
        "force": "force", "peak_pressure": "stress", "half_width": "length", "place": "length", "pressure": "stress",
        "gap": "length", "hertz_pressure": "stress"
    }

    source: str  # name of the surface
    target: str
    force: Array  # (3,), resultant of the pressure on the source's body
    peak_pressure: float
    half_width: float  # in 3-D of the middle section, or the semi-axis across z
    place: Array  # (n, 3), undeformed; z is 0 in the plane
    pressure: Array  # (n,), >= 0
    gap: Array  # (n,), > 0 where it is open
    hertz_pressure: Array  # (n,); not a number where Hertz's theory does not hold
    system: str = "SI"

    def to(self, units: str) -> "Contact":
        """The same in other units: 'SI', 'mm-N' or 'in-lbf'."""
        return _in_units(self, units)  # type: ignore[no-any-return]

    def __repr__(self) -> str:
        return (f"<geneva.Contact {self.source} on {self.target}: {len(self.pressure)} nodes, peak pressure "
                f"{self.peak_pressure:.6g} {self.units['pressure']}>")


@dataclasses.dataclass(frozen=True, repr=False)
class Fields(_Measured):
    """Displacement and stress at n nodes of m cells; with several ranks those of this rank's cells."""

    _dimensions: ClassVar[Mapping[str, str]] = {
        "place": "length", "displacement": "length", "stress": "stress", "von_mises": "stress"
    }

    place: Array  # (n, 3), undeformed; z is 0 in the plane
    displacement: Array  # (n, 3)
    stress: Array  # (n, 6): xx, yy, zz, xy, yz, zx
    von_mises: Array  # (n,)
    cells: npt.NDArray[np.int64]  # (m, 4) or (m, 8): nodes in lexicographic order
    bodies: npt.NDArray[np.uint32]  # (m,), in the order of the coarse mesh's bodies
    system: str = "SI"

    def to(self, units: str) -> "Fields":
        """The same in other units: 'SI', 'mm-N' or 'in-lbf'."""
        return _in_units(self, units)  # type: ignore[no-any-return]

    def __repr__(self) -> str:
        return f"<geneva.Fields of {len(self.place)} nodes and {len(self.cells)} cells, in {self.system}>"


class Analysis(_Figured, _Noticed):
    """The contact problem of a case solved: figures with their errors, beside the closed forms."""

    @property
    def is_converged(self) -> bool:
        """Whether the accuracy was reached that the case asks for."""
        return self._handle.is_converged  # type: ignore[no-any-return]

    @property
    def shortfall(self) -> str:
        """What was reached instead, why, and what to try; empty if it converged."""
        return self._handle.shortfall  # type: ignore[no-any-return]

    @property
    def error(self) -> float:
        """Of the peak pressure, estimated, relative."""
        return self._handle.error  # type: ignore[no-any-return]

    @property
    def memory(self) -> float:
        """Maximum resident meanwhile, of all ranks [byte]."""
        return self._handle.memory  # type: ignore[no-any-return]

    @property
    def contacts(self) -> Tuple[Contact, ...]:
        """By contact pair."""
        return tuple(Contact(**row) for row in self._handle.contacts())

    @property
    def meshes(self) -> Tuple[Mesh, ...]:
        """From the first to the last one."""
        return tuple(mesh_of(row) for row in self._handle.meshes())

    @property
    def checks(self) -> Tuple[Check, ...]:
        """What must be small in a sound result."""
        return tuple(Check(*row) for row in self._handle.checks())

    def fields(self) -> Fields:
        """Displacement and stress; with several ranks each has those of its own cells."""
        return Fields(**self._handle.fields())

    def write(self, directory: Path) -> Written:
        """Writes the files of `geneva run`, the report among them. With several ranks all call it.

        :raises InputError: if the directory cannot be written; it is then as it was
        """
        directory = pathlib.Path(directory)
        removed, missing = self._handle.write(directory)
        return Written(directory, tuple(removed), tuple(missing))

    def __repr__(self) -> str:
        state = "" if self.is_converged else ", not converged"
        return f"<geneva.Analysis of {self.case.name}: error {100 * self.error:.2g} %{state}>"


class Kinematics(_Figured, _Judged, _Noticed):
    """Motion and pin force over the cycle."""

    @property
    def curves(self) -> Curves:
        """Over the cycle, at equal steps of time and at the ends of the engagements; a force is negative on the braking
        wall."""
        return Curves(self._handle.curves())

    @property
    def walls(self) -> Tuple[str, ...]:
        """The wall that carries in each row of the curves: 'driving', 'braking' or 'none'."""
        return tuple(self._handle.walls())


class Estimate(_Figured, _Judged, _Noticed):
    """The contact without finite elements."""

    @property
    def curves(self) -> Curves:
        """Over the engagements; a force is negative on the braking wall."""
        return Curves(self._handle.curves())

    @property
    def pin(self) -> Curves:
        """In 3-D the line load along the pin, by line contacts; without curves in the plane and where they know none."""
        return Curves(self._handle.pin())

    @property
    def left_out(self) -> Tuple[str, ...]:
        """What the figures do not know of, in sentences."""
        return tuple(self._handle.left_out)


class Design(_Figured, _Noticed):
    """Johnson's wheel of minimum contact stress."""

    @property
    def curves(self) -> Curves:
        """Against the wheel's diameter; not a number where there is no such wheel."""
        return Curves(self._handle.curves())

    @property
    def strength(self) -> Curves:
        """Maximum stresses of wheels of several diameters by finite elements; without rows unless asked for."""
        return Curves(self._handle.strength())


class Crown(Result):
    """The pin by which the line load is most even."""

    def __init__(self, handle: _core.Crown, comm: Optional[Communicator], is_accurate: Optional[bool]) -> None:
        super().__init__(handle, comm)
        self._is_accurate = is_accurate

    @property
    def best(self) -> Case:
        """The case with the profile found."""
        return Case(self._handle.best)

    @property
    def parameter(self) -> str:
        """'Crown radius' or 'Profile amplitude'."""
        return self._handle.parameter  # type: ignore[no-any-return]

    @property
    def size(self) -> float:
        """Of that, found [m]."""
        return self._handle.size  # type: ignore[no-any-return]

    @property
    def is_converged(self) -> Optional[bool]:
        """Whether finite elements have confirmed it as accurately as the case asks; None if they were not asked."""
        return self._is_accurate

    @property
    def before(self) -> Curves:
        """The line load along the pin of the case."""
        return Curves(self._handle.before())

    @property
    def after(self) -> Curves:
        """The line load along the pin found."""
        return Curves(self._handle.after())


class Synthesis(Result):
    """Dimensions of the linkage that a case asks for."""

    @property
    def shortfall(self) -> str:
        """Why there is no linkage, and what to try; empty if there is one."""
        return self._handle.shortfall  # type: ignore[no-any-return]


class Optimum(_Figured, _Judged):
    """The best dimensions of a case; of a figure that finite elements have confirmed, `closed_form` is the one before."""

    def __init__(self, handle: _core.Optimum, comm: Optional[Communicator], is_accurate: Optional[bool]) -> None:
        super().__init__(handle, comm)
        self._is_accurate = is_accurate

    @property
    def best(self) -> Case:
        """The case with the best dimensions."""
        return Case(self._handle.best)

    @property
    def is_converged(self) -> Optional[bool]:
        """Whether finite elements have confirmed it as accurately as the case asks; None if they were not asked."""
        return self._is_accurate


@dataclasses.dataclass(frozen=True)
class Instant:
    """An instant of the cycle that has been solved: the how manieth of how many, and which in words."""

    done: int
    of: int
    words: str


class Cycle(_Judged, _Noticed):
    """A mechanism over its engagements, by finite elements."""

    @property
    def is_converged(self) -> bool:
        """Whether every instant has the accuracy that the case asks for."""
        return self._handle.is_converged  # type: ignore[no-any-return]

    @property
    def instants(self) -> Curves:
        """What was solved, a row for each instant; not a number where an instant could not be solved."""
        return Curves(self._handle.instants())

    @property
    def refusals(self) -> Tuple[str, ...]:
        """Why an instant could not be solved; empty where it was."""
        return tuple(self._handle.refusals())

    @property
    def curves(self) -> Curves:
        """Force and pressure between the instants."""
        return Curves(self._handle.curves())

    def fields(self) -> Tuple[Fields, ...]:
        """Of the instants that were solved, in the frame of the engaged slot, whose axis is x; on rank 0."""
        return tuple(Fields(**row) for row in self._handle.fields())


class LoadHistory(_Judged, _Noticed):
    """A geometry over its load steps, by finite elements."""

    @property
    def is_converged(self) -> bool:
        """Whether the last step has the accuracy that the case asks for."""
        return self._handle.is_converged  # type: ignore[no-any-return]

    @property
    def error(self) -> Optional[float]:
        """Of the last step's peak pressure, estimated, relative; None: not known."""
        return self._handle.error  # type: ignore[no-any-return]

    @property
    def contacts(self) -> Mapping[str, Curves]:
        """By contact pair, "source -> target": what it carries, a row for each step."""
        return {name: Curves(columns) for name, columns in self._handle.contacts().items()}

    @property
    def stresses(self) -> Mapping[str, Curves]:
        """By body: its maximum stresses, with the contact's own field, a row for each step."""
        return {name: Curves(columns) for name, columns in self._handle.stresses().items()}

    def fields(self) -> Tuple[Fields, ...]:
        """After every step, on one mesh; on rank 0."""
        return tuple(Fields(**row) for row in self._handle.fields())


@dataclasses.dataclass(frozen=True, repr=False)
class SweepPoint:
    """A combination of values, and what was found."""

    values: Tuple[str, ...]  # as a case file would say them
    case: Optional[Case]  # None where it is refused
    message: str  # why there are no figures, or what they lack
    figures: Mapping[str, Figure]  # by name
    is_converged: bool

    def __repr__(self) -> str:
        return f"<geneva.SweepPoint {', '.join(self.values)}{': ' + self.message if self.message else ''}>"


class Sweep(Result):
    """A case over some of its parameters."""

    def __init__(self, handle: _core.Sweep, comm: Optional[Communicator] = None) -> None:
        super().__init__(handle, comm)
        self._points = tuple(
            SweepPoint(tuple(values), None if given is None else Case(given), message,
                       {figure.name: figure for figure in figures_of(figures)}, is_converged)
            for values, given, message, figures, is_converged in handle.points())

    @property
    def parameters(self) -> Tuple[str, ...]:
        """Paths of the parameters that are varied."""
        return tuple(self._handle.parameters)

    @property
    def points(self) -> Tuple[SweepPoint, ...]:
        """All combinations; the last parameter changes fastest."""
        return self._points

    def numbers(self, parameter: str) -> Array:
        """The values of a parameter at the points, in the unit in which they were given.

        :raises KeyError: if that parameter is not varied
        :raises InputError: if its values are no numbers of one unit
        """
        if parameter not in self.parameters:
            raise KeyError(f"{parameter!r}: there are {', '.join(map(repr, self.parameters))}")
        found = self._handle.numbers(self.parameters.index(parameter))
        if found is None:
            raise _core.InputError(f"'{parameter}': the values are no numbers of one unit")
        return np.array(found)

    def values(self, figure: str, units: str = "SI") -> Array:
        """A figure at the points; not a number where there is none.

        :param units: 'SI', 'mm-N' or 'in-lbf'
        :raises KeyError: if no point has that figure
        """
        found = [point.figures.get(figure) for point in self._points]
        if not any(found):
            names = {name: None for point in self._points for name in point.figures}
            raise KeyError(f"{figure!r}: there are {', '.join(map(repr, names))}")
        values = [None if one is None else one.to(units).value for one in found]
        return np.array([np.nan if value is None else value for value in values])

    def __repr__(self) -> str:
        return f"<geneva.Sweep of {self.case.name}: {len(self._points)} points over {', '.join(self.parameters)}>"
