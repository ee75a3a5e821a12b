"""A case built of numbers, its motion, and the contact at its worst instant; the report beside.

    python3 doc/python/case_of_numbers.py [RESULTS_DIR]
"""

import sys

import geneva

case = geneva.new_case({
    "Title": "Indexing table of a packing machine",
    "Output units": "mm-N",
    "Mechanism": {
        "Stations": 6,
        "Wheel diameter": 120,  # mm, the case's own unit of a length
        "Pin diameter": "14 mm",
        "Driver speed": "120 rpm",
        "Driver angle": "at maximum pin force",
        "Load inertia": "0.002 kg.m^2",
        "Wheel material": {"Material": "42CrMo4 quenched and tempered"},
        "Pin material": {"Material": "100Cr6 hardened"},
    },
})

motion = geneva.kinematics(case)
curves = motion.curves.to("mm-N")
worst = curves["pin force"].argmax()
print(f"greatest pin force {curves['pin force'][worst]:.1f} {curves.units['pin force']} at "
      f"{curves['driver angle'][worst]:.2f} {curves.units['driver angle']}")

result = geneva.run(case, progress=lambda mesh: print(f"{mesh.unknowns} unknowns, within {100 * mesh.error:.2g} %"))
for figure in result.figures:
    print(figure.to("mm-N"))
print(result.write(sys.argv[1] if len(sys.argv) > 1 else "results").directory / "report.html")
