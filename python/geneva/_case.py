"""Cases: read from a directory, or built of parameters."""

from __future__ import annotations

import numbers
import os
import pathlib
from typing import Any, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from geneva import _core

Path = Union[str, "os.PathLike[str]"]
Value = Union[str, bool, float, Sequence[Union[str, float]]]
Parameters = Mapping[str, Any]  # of values and, by the names of subsections, of the same


def is_number(value: object) -> bool:
    """Whether it is a number, be it of numpy; True and False are none."""
    return isinstance(value, numbers.Real) and not isinstance(value, (bool, np.bool_))


def _refuse(name: str, value: object) -> None:
    raise _core.InputError(f"'{name}' = {value!r}: a text, a number or a list of these is wanted, not "
                           f"{type(value).__name__}; for example '8 mm', or 8 in the case's own unit")


def text_or_numbers(name: str, value: object) -> Union[str, List[float]]:
    """A value as the reader takes it: a text, or numbers that get the case's own unit."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if is_number(value):
        return [float(value)]  # type: ignore[arg-type]
    if isinstance(value, np.ndarray):
        value = value.tolist()
    if not isinstance(value, (list, tuple)):
        _refuse(name, value)
    parts = list(value)  # type: ignore[call-overload]
    if parts and all(is_number(part) for part in parts):
        return [float(part) for part in parts]
    if not all(isinstance(part, str) for part in parts):
        _refuse(name, value)
    return ", ".join(parts)


def path_of(name: str) -> Tuple[List[str], str]:
    """Subsections and name of "Mechanism/Pin/Overhang"."""
    *sections, last = [part.strip() for part in name.split("/")]
    return sections, last


def _settings(parameters: Parameters, above: Sequence[str] = ()) -> Iterable[_core.Setting]:
    for name, value in parameters.items():
        if not isinstance(name, str):
            raise _core.InputError(f"{name!r}: the name of a parameter is a text, such as 'Mechanism/Pin diameter'")
        sections, last = path_of(name)
        if isinstance(value, Mapping):
            yield from _settings(value, [*above, *sections, last])
        else:
            yield _core.Setting([*above, *sections], last, text_or_numbers(last, value))


class Case:
    """What is to be computed: a mechanism, a geometry of one's own, or a linkage that is wanted.

    Made by `read_case`, `new_case`, `starter_case` or `with_`; a case never changes.
    """

    def __init__(self, given: _core.Case) -> None:
        self._given = given

    @property
    def name(self) -> str:
        """That of its directory."""
        return self._given.name

    @property
    def directory(self) -> pathlib.Path:
        """Where the files lie that the case names."""
        return pathlib.Path(self._given.directory)

    @property
    def title(self) -> str:
        """What the case calls itself; may be empty."""
        return self._given.title

    @property
    def model(self) -> str:
        """'mechanism', 'geometry' or 'synthesis'."""
        return self._given.model

    @property
    def dimension(self) -> int:
        """2 or 3; 0 of a synthesis."""
        return self._given.dimension

    @property
    def units(self) -> str:
        """The case's own units, which tables show: 'SI', 'mm-N' or 'in-lbf'."""
        return self._given.units

    @property
    def parameters(self) -> "dict[str, str]":
        """What the case gives, by the path of the parameter: {"Mechanism/Pin diameter": "8 mm"}."""
        return {"/".join([*section, name]): value for section, name, value in self._given.assignments}

    @property
    def text(self) -> str:
        """The case as a file case.prm with all parameters, explained, and every default filled in."""
        return self._given.completed

    def with_(self, parameter: Union[str, Parameters], value: Optional[Value] = None) -> "Case":
        """The case with another value of a parameter, or of several in a (nested) dict.

        :param parameter: path of the parameter, "Mechanism/Pin diameter", with its value; or a dict as of `new_case`
        :param value: text with a unit, "9 mm", or number in the case's own unit
        :raises InputError: if there is no such parameter, or its value makes no case
        """
        changes = parameter if isinstance(parameter, Mapping) else {parameter: value}
        return Case(self._given.changed(list(_settings(changes))))

    def __repr__(self) -> str:
        title = f": {self.title}" if self.title else ""
        return f"<geneva.Case {self.name}{title}, {self.model}, {self.units}>"

    def __reduce__(self) -> Tuple[Any, ...]:
        return Case, (self._given, )


def read_case(directory: Path) -> Case:
    """Reads case.prm of a case directory.

    :raises InputError: naming file, line, parameter, the value found and what is allowed
    """
    return Case(_core.read_case(pathlib.Path(directory)))


CaseOrDirectory = Union[Case, Path]


def given_of(case: CaseOrDirectory) -> _core.Case:
    """What is computed of a case, or of the case in a directory.

    :raises InputError: for anything else
    """
    if isinstance(case, Case):
        return case._given
    if isinstance(case, (str, os.PathLike)):
        return read_case(case)._given
    raise _core.InputError(f"{case!r} is no case: what read_case(), new_case() or starter_case() give is wanted, or the "
                           "path of a case directory")


def new_case(parameters: Parameters, directory: Path = ".") -> Case:
    """A case of parameters, as a file case.prm names them, with the defaults of the rest.

    :param parameters: values by the path of the parameter, "Mechanism/Pin diameter", or by subsections in nested
        dicts, as one likes. A value is a text with its unit, "8 mm", or a number in the case's own unit ('Output units'),
        or a list of these where the parameter takes several.
    :param directory: where files lie that the case names, and after which it is called
    :raises InputError: in the words in which a file would be refused
    """
    return Case(_core.new_case(list(_settings(parameters)), "the new case", pathlib.Path(directory).absolute()))


def starter_case(type: str = "external", stations: Optional[int] = None, units: str = "mm-N",
                 directory: Path = ".") -> Case:
    """A mechanism that runs as it is, as `geneva init` writes it, to begin with.

    :param type: 'external', 'internal', 'spherical', 'long dwell' or 'four-bar'
    :param stations: of the wheel; None: 6
    :param units: 'SI', 'mm-N' or 'in-lbf'
    :raises InputError: for a type that is none, or a wheel that cannot have that many stations
    """
    return Case(_core.starter_case(type, stations, units, pathlib.Path(directory).absolute()))
