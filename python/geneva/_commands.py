"""What can be computed: a function for each command of the command line.

Each takes a case, or the path of a case directory.
"""

from __future__ import annotations

import contextlib
import multiprocessing
import pathlib
from typing import Any, Callable, Iterable, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from geneva import _core
from geneva._case import Case, CaseOrDirectory, Path, given_of, is_number, path_of, text_or_numbers
from geneva._results import (Analysis, Communicator, Crown, Cycle, Design, Estimate, Instant, Kinematics, LoadHistory, Mesh,
                             Optimum, Step, Sweep, Synthesis, Written, mesh_of)

Swept = Union[str, Sequence[Union[str, float]], "np.ndarray[Any, Any]"]
_Outcome = Tuple[Optional[str], str]


def _solver() -> Any:
    """The half with finite elements, which takes longer to load than all the rest."""
    from geneva import _solver as loaded
    return loaded


def run(case: CaseOrDirectory, *, comm: Optional[Communicator] = None, progress: Optional[Callable[[Mesh], object]] = None,
        on_step: Optional[Callable[[Step], object]] = None) -> Analysis:
    """Solves the contact problem of a case by finite elements, as `geneva run` does, and writes nothing.

    The interpreter's other threads go on meanwhile. What a callback raises, and Ctrl-C at the end of a step, ends the
    computation and is raised unchanged; with several ranks on the others as `EndedByOtherRank`.

    :param comm: communicator of mpi4py, all of whose ranks call this and get the same; None: this process alone
    :param progress: called with every mesh that has been solved, on every rank
    :param on_step: called with every step of the active set, on every rank
    :raises InputError: if the case cannot be solved
    :raises LimitReached: if a limit was reached before there was any result
    """
    meshes = None if progress is None else lambda row: progress(mesh_of(row))
    steps = None if on_step is None else lambda row: on_step(Step(**row))
    return Analysis(_solver().run(given_of(case), comm, meshes, steps), comm)


def cycle(case: CaseOrDirectory, *, comm: Optional[Communicator] = None,
          progress: Optional[Callable[[Instant], object]] = None) -> Cycle:
    """Solves the contact at the instants that stand for the engagements, as `geneva cycle` does.

    :param comm: communicator of mpi4py, whose ranks share the instants; None: this process alone
    :param progress: called after every instant, on the rank that solved it
    :raises InputError: if the case is no mechanism, or nothing ever presses
    """
    tell = None if progress is None else lambda *told: progress(Instant(*told))
    return Cycle(_solver().cycle(given_of(case), comm, tell), comm)


def load_steps(case: CaseOrDirectory, *, comm: Optional[Communicator] = None,
               progress: Optional[Callable[[Mesh], object]] = None,
               on_step: Optional[Callable[[Step], object]] = None) -> LoadHistory:
    """Solves the contact at every load step of a geometry, as `geneva cycle` does.

    :param comm, progress, on_step: as `run` takes them
    :raises InputError: if the case has no load steps, or cannot be solved
    :raises LimitReached: if a limit was reached before there was any result
    """
    meshes = None if progress is None else lambda row: progress(mesh_of(row))
    steps = None if on_step is None else lambda row: on_step(Step(**row))
    return LoadHistory(_solver().load_steps(given_of(case), comm, meshes, steps), comm)


def estimate(case: CaseOrDirectory) -> Estimate:
    """Pin force, Hertz's contact and, in 3-D, line contacts along the pin, as `geneva estimate` does.

    :raises InputError: if the case has no mechanism, or none whose pin presses on the driving wall
    """
    return Estimate(_core.estimate(given_of(case)))


def kinematics(case: CaseOrDirectory, steps: int = 720) -> Kinematics:
    """Motion and pin force of a mechanism over its cycle, as `geneva kinematics` does.

    :param steps: of the curves, 1 or more
    :raises InputError: if the case has no mechanism, or one that cannot move
    """
    return Kinematics(_core.kinematics(given_of(case), steps))


def design(case: CaseOrDirectory, *, strength: bool = False, comm: Optional[Communicator] = None,
           progress: Optional[Callable[[int, int], object]] = None) -> Design:
    """Johnson's wheel of minimum contact stress and the shaft, as `geneva design` does.

    :param strength: also solves wheels of several diameters by finite elements
    :param comm: communicator of mpi4py for these; None: this process alone
    :param progress: called after every one of these with how many are done, and of how many
    :raises InputError: if the case is no mechanism or has no best wheel
    """
    found = _core.design(given_of(case))
    if strength:
        _solver().add_strength(found, comm, progress)
    return Design(found, comm)


def crown(case: CaseOrDirectory, *, confirm: bool = False, comm: Optional[Communicator] = None) -> Crown:
    """The pin by which the line load of a case in 3-D is most even, as `geneva design --crown` does.

    :param confirm: solves it by finite elements, too
    :param comm: communicator of mpi4py for that; None: this process alone
    :raises InputError: if the case is wrong, or line contacts along the pin know no answer
    """
    found = _core.design_crown(given_of(case))
    return Crown(found, comm, _solver().confirm_crown(found, comm) if confirm else None)


def synthesize(case: CaseOrDirectory) -> Synthesis:
    """Dimensions of the linkage that a case asks for, as `geneva synthesize` does.

    :raises InputError: if the case has another model, or there is no such linkage
    """
    return Synthesis(_core.synthesize(given_of(case)))


def optimise(case: CaseOrDirectory, *, confirm: bool = False, comm: Optional[Communicator] = None,
             progress: Optional[Callable[[int], object]] = None) -> Optimum:
    """The free dimensions of a case with which its goal is least under its limits, as `geneva optimise` does.

    :param confirm: solves the best case by finite elements, too
    :param comm: communicator of mpi4py for finite elements; None: this process alone
    :param progress: called now and then with the number of candidates
    :raises InputError: if the case leaves nothing free, or no candidate keeps the limits
    """
    if _core.wants_slot_bottom(given_of(case)):
        found = _solver().optimise(given_of(case), comm, progress)
    else:
        found = _core.optimise(given_of(case), progress)
    return Optimum(found, comm, _solver().confirm_optimum(found, comm) if confirm else None)


def _swept(name: str, values: Swept) -> Any:
    if isinstance(values, str):
        return values
    if is_number(values):
        values = [values]  # type: ignore[list-item]
    if not isinstance(values, Sequence) and not isinstance(values, np.ndarray):
        raise _core.InputError(f"'{name}' = {values!r}: texts or numbers are wanted, not {type(values).__name__}")
    texts = [text_or_numbers(name, value) for value in values]
    if texts and all(isinstance(text, list) for text in texts):
        return [number for text in texts for number in text]
    if not texts or not all(isinstance(text, str) for text in texts):
        raise _core.InputError(f"'{name}': texts alone or numbers alone are wanted, one or more")
    return texts


def sweep(case: CaseOrDirectory, parameters: Mapping[str, Swept], with_: str = "estimate", *, jobs: int = 1,
          comm: Optional[Communicator] = None, progress: Optional[Callable[[int, int], object]] = None) -> Sweep:
    """A case over some of its parameters, every combination of their values, as `geneva sweep` does.

    :param parameters: by the path of the parameter its values: "8 mm .. 14 mm, 7" as of `geneva sweep --set`, or a list
        of texts, or numbers (of numpy) in the case's own unit
    :param with_: 'estimate', 'kinematics', 'design', or 'run'
    :param jobs: how many runs at a time, in processes of their own if more than 1; a script that asks for it keeps its
        first call behind `if __name__ == "__main__":`, as multiprocessing wants it
    :param comm: communicator of mpi4py for 'run', all of whose ranks solve each point; None: this process alone
    :param progress: called after every run with how many points are done, and of how many
    :raises InputError: if no combination is a case, or none has any figures; for several jobs of several ranks
    """
    commands = ("estimate", "kinematics", "design", "run")
    if with_ not in commands:
        raise _core.InputError(f"with_ = {with_!r}: one of {', '.join(map(repr, commands))} is wanted")
    if isinstance(jobs, bool) or not isinstance(jobs, int) or jobs < 1:
        raise _core.InputError(f"jobs = {jobs!r}: a whole number of 1 or more is wanted")
    if jobs > 1 and comm is not None:
        raise _core.InputError(f"jobs = {jobs}: the ranks of comm solve each point together; leave one of both out")
    found = _core.sweep(given_of(case), [(*path_of(name), _swept(name, values)) for name, values in parameters.items()],
                        with_)
    if with_ != "run":
        found.work_out()
    else:
        _take_runs(found, jobs, comm, progress)
    found.require_figures()
    return Sweep(found, comm)


def _take_runs(found: _core.Sweep, jobs: int, comm: Optional[Communicator],
               progress: Optional[Callable[[int, int], object]]) -> None:
    points = found.points()
    given_at = {place: Case(given) for place, (_, given, *_) in enumerate(points) if given is not None}
    cases = list(given_at.values())
    with contextlib.ExitStack() as stack:
        if jobs > 1:
            pool = stack.enter_context(multiprocessing.get_context("spawn").Pool(min(jobs, len(cases))))
            outcomes: Iterable[_Outcome] = pool.imap(_outcome_of, cases)
        else:
            outcomes = (_outcome_of(each, comm) for each in cases)
        for done, (place, (document, words)) in enumerate(zip(given_at, outcomes), len(points) - len(cases) + 1):
            if document is None:
                found.refuse(place, words)
            else:
                found.take(place, document, words)
            if progress is not None:
                progress(done, len(points))


def _outcome_of(case: Case, comm: Optional[Communicator] = None) -> _Outcome:
    """The document of a run with what it lacks; of one that is refused none, and why."""
    try:
        analysis = _solver().run(given_of(case), comm, None, None)
    except (_core.InputError, _core.LimitReached) as error:
        return None, str(error)
    return analysis.document(), analysis.shortfall


def write_report(results: Path, file: Optional[Path] = None) -> Written:
    """Writes the report of a results directory anew, as `geneva report` does.

    :param file: where it goes; None: report.html in the directory
    :raises InputError: if there are no results, or the file cannot be written
    """
    directory = pathlib.Path(results)
    removed, missing = _core.write_report(directory, None if file is None else pathlib.Path(file))
    return Written(directory, tuple(removed), tuple(missing))
