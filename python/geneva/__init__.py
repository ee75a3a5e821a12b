"""The contact stress of Geneva mechanisms, by finite elements and by closed forms.

    import geneva

    case = geneva.read_case("cases/johnson-optimum-wheel")
    result = geneva.run(case, progress=print)
    print(result.contacts[0].peak_pressure, result.error)

Results are in SI units, which stand beside them; ``to("mm-N")`` gives them in other ones. What is wrong with a case is
an `InputError` with the words of the command line.
"""

from geneva._core import EndedByOtherRank, InputError, LimitReached
from geneva._core import version as __version__
from geneva._case import Case, new_case, read_case, starter_case
from geneva._commands import (crown, cycle, design, estimate, kinematics, load_steps, optimise, run, sweep,
                              synthesize, write_report)
from geneva._figures import Curves, Figure, unit_of
from geneva._results import (Analysis, Check, Contact, Crown, Cycle, Design, Estimate, Fields, Instant, Kinematics,
                             LoadHistory, Mesh, Optimum, Result, Step, Sweep, SweepPoint, Synthesis, Written)

__all__ = [
    "Analysis", "Case", "Check", "Contact", "Crown", "Curves", "Cycle", "Design", "EndedByOtherRank", "Estimate",
    "Fields", "Figure", "InputError", "Instant", "Kinematics", "LimitReached", "LoadHistory", "Mesh", "Optimum", "Result",
    "Step", "Sweep", "SweepPoint", "Synthesis", "Written", "__version__", "crown", "cycle", "design", "estimate", "kinematics",
    "load_steps", "new_case", "optimise", "read_case", "run", "starter_case", "sweep", "synthesize", "unit_of", "write_report"
]
