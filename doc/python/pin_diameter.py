"""Which pin diameter? The contact pressure and its safety over the diameter, by closed forms.

    python3 doc/python/pin_diameter.py [CASE_DIR]
"""

import sys

import numpy as np

import geneva

case = geneva.read_case(sys.argv[1] if len(sys.argv) > 1 else "cases/indexing-table")
diameters = np.linspace(10, 20, 11)  # in the case's own unit, mm
sweep = geneva.sweep(case, {"Mechanism/Pin diameter": diameters})

pressure = sweep.values("peak contact pressure", units="mm-N")
safety = sweep.values("least safety factor")
print("pin [mm]  pressure [MPa]  least safety factor")
for row in zip(diameters, pressure, safety):
    print("{:8.1f}  {:14.1f}  {:19.2f}".format(*row))

exponent = np.polyfit(np.log(diameters), np.log(pressure), 1)[0]
print(f"the pressure goes with the diameter to the power {exponent:.2f}: Hertz says -0.5 where the force stays")
