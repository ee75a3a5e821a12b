"""The pressure along the contact beside Hertz's, as numbers and as a picture.

    python3 doc/python/pressure_along_contact.py [CASE_DIR [PICTURE.svg]]

Under `mpirun -n N`, with mpi4py, the ranks share the run.
"""

import sys

import numpy as np

import geneva

comm = None
try:
    from mpi4py import MPI
    comm = MPI.COMM_WORLD
except ImportError:
    pass

case = geneva.read_case(sys.argv[1] if len(sys.argv) > 1 else "cases/johnson-optimum-wheel")
result = geneva.run(case, comm=comm)
contact = result.contacts[0].to("mm-N")

order = np.argsort(contact.place[:, 0])
x = contact.place[order, 0]
pressure = contact.pressure[order]
hertz = contact.hertz_pressure[order]
difference = np.nanmax(np.abs(pressure - hertz)) / contact.peak_pressure


def polyline(values, colour):
    """A curve of a picture 600 by 300, over the width of the contact."""
    reach = 1.5 * contact.half_width
    middle = np.sum(x * pressure) / np.sum(pressure)
    points = " ".join(f"{300 + 300 * (a - middle) / reach:.1f},{290 - 270 * b / contact.peak_pressure:.1f}"
                      for a, b in zip(x, values) if abs(a - middle) < reach)
    return f'<polyline fill="none" stroke="{colour}" points="{points}"/>'


if comm is None or comm.rank == 0:
    print(f"peak pressure {contact.peak_pressure:.1f} MPa within {100 * result.error:.2g} %, half-width "
          f"{contact.half_width:.4f} mm; along the contact at most {100 * difference:.2f} % of the peak from Hertz's")
    picture = sys.argv[2] if len(sys.argv) > 2 else "pressure.svg"
    with open(picture, "w", encoding="utf-8") as file:
        file.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 600 300">'
                   f"{polyline(hertz, 'grey')}{polyline(pressure, 'black')}</svg>\n")
