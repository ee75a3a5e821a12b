"""Numbers with their units."""

from __future__ import annotations

import dataclasses
from typing import Dict, Iterator, Mapping, Optional, Tuple

import numpy as np
import numpy.typing as npt

from geneva import _core

Array = npt.NDArray[np.float64]


def unit_of(dimension: str, units: str = "SI") -> Tuple[str, float]:
    """Name of a unit, and what to multiply an SI value with to get it: ("MPa", 1e-6) of ("stress", "mm-N").

    :param dimension: as results name it: 'length', 'stress', 'force', 'angle'
    :param units: 'SI', 'mm-N' or 'in-lbf'
    :raises InputError: for names that are none
    """
    return _core.output_unit(units, dimension)


@dataclasses.dataclass(frozen=True)
class Figure:
    """A figure of a result, with its error and what others say of it.

    Values are in the units of `units`, SI unless `to` gave another one; what is not known is None.
    """

    name: str
    dimension: str
    value: Optional[float]  # None where it has no bound or is not known
    error: Optional[float] = None  # estimated, relative
    closed_form: Optional[float] = None
    published: Optional[float] = None
    limit: Optional[float] = None  # that case or material allow
    driver_angle: Optional[float] = None  # at which it occurs [rad]
    is_bounded: bool = True  # False: it grows from mesh to mesh
    note: str = ""
    units: str = "SI"

    @property
    def unit(self) -> str:
        """Name of the unit of its values; empty of a plain number."""
        return unit_of(self.dimension, self.units)[0]

    def to(self, units: str) -> "Figure":
        """The same in other units: 'SI', 'mm-N' or 'in-lbf'."""
        factor = unit_of(self.dimension, units)[1] / unit_of(self.dimension, self.units)[1]

        def converted(value: Optional[float]) -> Optional[float]:
            return None if value is None else value * factor

        return dataclasses.replace(self, value=converted(self.value), closed_form=converted(self.closed_form),
                                   published=converted(self.published), limit=converted(self.limit), units=units)

    def __str__(self) -> str:
        value = "not bounded" if not self.is_bounded else "unknown" if self.value is None else f"{self.value:.6g}"
        error = "" if self.error is None else f" +- {100 * self.error:.2g} %"
        return f"{self.name}: {value}{' ' + self.unit if self.unit else ''}{error}"


class Curves(Mapping[str, Array]):
    """Arrays of the same length by their names, in the units that `units` gives by the same names."""

    def __init__(self, columns: Mapping[str, Tuple[Array, str]], system: str = "SI") -> None:
        self._columns = dict(columns)
        self._system = system

    @property
    def units(self) -> Dict[str, str]:
        """Names of the units by the names of the curves; empty of plain numbers."""
        return {name: unit_of(dimension, self._system)[0] for name, (_, dimension) in self._columns.items()}

    def to(self, units: str) -> "Curves":
        """The same in other units: 'SI', 'mm-N' or 'in-lbf'."""
        columns = {}
        for name, (array, dimension) in self._columns.items():
            factor = unit_of(dimension, units)[1] / unit_of(dimension, self._system)[1]
            columns[name] = (array * factor, dimension)
        return Curves(columns, units)

    def __getitem__(self, name: str) -> Array:
        try:
            return self._columns[name][0]
        except KeyError:
            raise KeyError(f"{name!r}: there are {', '.join(map(repr, self._columns))}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        rows = len(next(iter(self._columns.values()))[0]) if self._columns else 0
        names = ", ".join(f"{name} [{unit}]" if unit else name for name, unit in self.units.items())
        return f"<geneva.Curves of {rows} rows: {names}>"
