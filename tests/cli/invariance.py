"""The same problem said in another way gives the same numbers."""

import math
import re
import shutil

import closed_forms
import geneva_cli
import mesh_files
from geneva_cli import CliTest, change_case, flat, look_up, number, read_csv, read_summary, replace_in, unit_of

# What a run finds out, as far as it is no place in the plane and no round-off.
FINDINGS = ("contact.force", "contact.peak_pressure", "contact.half_width", "contact.max_shear",
            "contact.max_shear_depth", "contact.active_nodes", "hertz.peak_pressure", "hertz.half_width",
            "mesh.levels", "mesh.cells", "mesh.dofs")
WHEEL_FINDINGS = (*FINDINGS, "load.force", "load.pin_distance", "wheel.inertia_from_geometry", "wheel.inertia_used",
                  "wheel.max_von_mises", "equilibrium.bore_torque")

# The output units of a system, from their definitions: factors on SI values.
OUTPUT_UNITS = {
    "SI": {"m": 1.0, "Pa": 1.0},
    "mm-N": {"mm": 1e3, "MPa": 1e-6},
    "in-lbf": {"in": 1 / closed_forms.INCH, "psi": 1 / closed_forms.PSI},
}


class Invariance(CliTest):

    def assert_same(self, summary, reference, keys, tolerance):
        """Compares findings by their relative differences, and names all that differ.

        A half-width hangs on the pressure of the last node, a tenth of the peak, which the solver knows as well as the peak."""
        differing = []
        for key in keys:
            ours, theirs = number(look_up(summary, key)), number(look_up(reference, key))
            allowed = 10 * tolerance if key.endswith("half_width") else tolerance
            if abs(ours - theirs) > allowed * abs(theirs):
                differing.append(f"{key}: {ours!r} and {theirs!r} differ by {ours / theirs - 1:.2e}")
        self.assertFalse(differing, f"allowed: {tolerance:g}")

    def assert_same_estimate(self, summary, reference, tolerance):
        """The estimate is a difference of peak pressures, relative to them."""
        estimates = [result["contact"]["peak_pressure_error"] for result in (summary, reference)]
        self.assertAlmostEqual(*estimates, delta=2 * tolerance)

    def assert_same_steps(self, summary, reference):
        """The same meshes, active sets and steps."""
        for ours, theirs in zip(summary["solver"]["levels"], reference["solver"]["levels"], strict=True):
            for key in ("cells", "dofs", "active_nodes", "active_set_iterations"):
                self.assertEqual(ours[key], theirs[key], key)


class Units(Invariance):
    """Lengths, stresses and forces are made dimensionless inside: the unit changes round-off only."""

    TOLERANCE = 1e-10

    def test_a_mechanism_is_the_same_in_inches_millimetres_and_metres(self):
        inches = self.run_case(self.copy_case("johnson-optimum-wheel"))
        density = 0.283 * closed_forms.POUND / closed_forms.INCH**3
        friction = 2 * closed_forms.POUND_FORCE * closed_forms.INCH
        for unit, per_metre, torque, per_newton_metre in (("mm", 1e3, "N.mm", 1e3), ("m", 1.0, "N.m", 1.0)):
            case = self.copy_case("johnson-optimum-wheel", unit)
            scale = closed_forms.INCH * per_metre
            changes = {"Mechanism/Wheel diameter": f"{4.53 * scale:.17g} {unit}",
                       "Mechanism/Load diameter": f"{4 * scale:.17g} {unit}",
                       "Mechanism/Load length": f"{0.25 * scale:.17g} {unit}",
                       "Mechanism/Load density": f"{density:.17g} kg/m^3",
                       "Mechanism/Friction moment": f"{friction * per_newton_metre:.17g} {torque}"}
            for material in ("Pin material", "Wheel material"):
                changes[f"Mechanism/{material}/Young's modulus"] = f"{30e6 * closed_forms.PSI:.17g} Pa"
                changes[f"Mechanism/{material}/Density"] = f"{density:.17g} kg/m^3"
            change_case(case, changes)
            summary = self.run_case(case)
            with self.subTest(unit):
                self.assert_same(summary, inches, WHEEL_FINDINGS, self.TOLERANCE)
                self.assert_same_estimate(summary, inches, self.TOLERANCE)
                self.assert_same_steps(summary, inches)

    def in_other_units(self, name):
        """Length units, what a millimetre is in them, and a copy of the case for each."""
        for unit, millimetre in (("in", 1e-3 / closed_forms.INCH), ("m", 1e-3)):
            case = self.copy_case(name, f"{name}-{unit}")
            change_case(case, {"Geometry/Length unit": unit})
            yield unit, millimetre, case

    def test_a_geometry_is_the_same_in_inches_millimetres_and_metres(self):
        millimetres = self.run_case(self.copy_case("hertz-sphere"))
        for unit, size, case in self.in_other_units("hertz-sphere"):
            for name, length in (("R", 10), ("W", 40)):
                replace_in(case / "geometry.geo", f"{name} = {length};", f"{name} = {length * size:.17g};")
            summary = self.run_case(case)
            with self.subTest(unit):
                self.assert_same(summary, millimetres, FINDINGS, self.TOLERANCE)
                self.assert_same_estimate(summary, millimetres, self.TOLERANCE)
                self.assert_same_steps(summary, millimetres)

    def test_a_mesh_file_is_the_same_in_inches_millimetres_and_metres(self):
        mesh = mesh_files.cylinder_on_block()
        case = self.copy_case("hertz-line-contact")
        (case / "geometry.geo").unlink()
        (case / "geometry.msh").write_text(mesh.text())
        millimetres = self.run_case(case)
        for unit, size, case in self.in_other_units("hertz-line-contact"):
            (case / "geometry.geo").unlink()
            (case / "geometry.msh").write_text(mesh.text(scale=size))
            change_case(case, {"Geometry/Thickness": f"{size:.17g} {unit}"})
            summary = self.run_case(case)
            with self.subTest(unit):
                self.assert_same(summary, millimetres, FINDINGS, self.TOLERANCE)
                self.assert_same_estimate(summary, millimetres, self.TOLERANCE)
                self.assert_same_steps(summary, millimetres)

    def test_output_units_change_headings_and_values_but_not_the_summary(self):
        summaries, tables, runs = {}, {}, {}
        for units in OUTPUT_UNITS:
            case = self.copy_case("johnson-optimum-wheel", to="wheel")
            change_case(case, {"Output units": units})
            runs[units] = self.geneva("run", case, "--output", self.directory / units)
            self.assertEqual(runs[units].code, 0, runs[units].describe())
            summaries[units] = flat(read_summary(self.directory / units))
            self.assertEqual(summaries[units].pop("case.output_units"), units)
            for key in [key for key in summaries[units] if key.startswith(("case.inputs", "case.worked_out"))]:
                del summaries[units][key]  # texts, as the case has them
            tables[units] = read_csv(self.directory / units / "contact.csv")
            shutil.rmtree(case)
        for units, factors in OUTPUT_UNITS.items():
            with self.subTest(units):
                self.assertEqual(summaries[units], summaries["SI"])
                self.assert_table_in_units(tables[units], tables["SI"], factors)
                self.assert_headings_in_units(runs[units].out, units)

    def assert_table_in_units(self, table, si_table, factors):
        self.assertEqual(len(table), len(si_table))
        for heading, si_heading in zip(table, si_table):
            unit = unit_of(heading)
            self.assertEqual(heading.split(" [")[0], si_heading.split(" [")[0])
            self.assertEqual(unit is None, unit_of(si_heading) is None)
            if unit is None:
                self.assertEqual(table[heading], si_table[si_heading])
                continue
            self.assertIn(unit, factors)
            largest = max(map(abs, si_table[si_heading])) * factors[unit]
            for value, si_value in zip(table[heading], si_table[si_heading], strict=True):
                self.assertLessEqual(abs(value - si_value * factors[unit]), 1e-11 * largest, heading)

    def assert_headings_in_units(self, output, units):
        others = {unit for system, names in OUTPUT_UNITS.items() if system != units for unit in names}
        found = set(re.findall(r"\[([^\]]+)\]", output))
        self.assertLessEqual(set(OUTPUT_UNITS[units]), found)
        self.assertFalse(found & (others - set(OUTPUT_UNITS[units])), output)


class Symmetry(Invariance):
    """A mirrored problem has the mirrored solution; either body may be the source."""

    def unsymmetric_case(self, name):
        """A cylinder that presses obliquely on a block that reaches farther on one side."""
        case = self.copy_case("hertz-line-contact", name)
        for point in ("{W, -W, 0}", "{W, 0, 0}"):
            replace_in(case / "geometry.geo", point, point.replace("{W", "{1.3 * W"))
        change_case(case, {"Geometry/Load cylinder core/Direction": "0.02, -1"})
        return case

    def transformed(self, name, point, direction):
        """The unsymmetric case with every point rewritten by a pattern and another direction of the force."""
        case = self.unsymmetric_case(name)
        file = case / "geometry.geo"
        text, count = re.subn(r"= \{([^,}]+), ([^,}]+), 0\};", point, file.read_text())
        self.assertGreater(count, 8)
        file.write_text(text)
        change_case(case, {"Geometry/Load cylinder core/Direction": direction})
        return case

    def test_a_mirrored_geometry_has_the_mirrored_contact(self):
        plain = self.unsymmetric_case("plain")
        reference = self.run_case(plain)
        mirrored = self.transformed("mirrored", r"= {-(\1), \2, 0};", "-0.02, -1")
        self.assert_same(self.run_case(mirrored), reference, FINDINGS, 1e-8)
        self.assert_mirrored(read_csv(mirrored / "results" / "contact.csv"),
                             read_csv(plain / "results" / "contact.csv"))

    def assert_mirrored(self, mirrored, plain):
        """The same pressures at opposite places."""
        peak = max(plain["contact_pressure [MPa]"])

        def nodes(table, sign):
            return sorted((sign * x, y, p) for x, y, p in
                          zip(table["x [mm]"], table["y [mm]"], table["contact_pressure [MPa]"]))

        for ours, theirs in zip(nodes(mirrored, -1), nodes(plain, 1), strict=True):
            self.assertAlmostEqual(ours[0], theirs[0], delta=1e-9)
            self.assertAlmostEqual(ours[2], theirs[2], delta=1e-8 * peak)

    def test_a_geometry_upside_down_is_the_same(self):
        reference = self.run_case(self.unsymmetric_case("plain"))
        turned = self.transformed("turned", r"= {-(\1), -(\2), 0};", "-0.02, 1")
        self.assert_same(self.run_case(turned), reference, FINDINGS, 1e-8)

    def swapped(self, name, pair):
        """Results of a case, and with its contact pair written the other way round."""
        reference = self.run_case(self.copy_case(name))
        case = self.copy_case(name, f"swapped-{name}")
        replace_in(case / "case.prm", pair, " -> ".join(reversed(pair.split(" -> "))))
        return reference, self.run_case(case)

    def test_source_and_target_of_equally_stiff_bodies_may_be_swapped(self):
        reference, summary = self.swapped("hertz-line-contact", "cylinder surface -> block top")
        self.assertEqual(summary["contact"]["source"], "block top")
        error = sum(number(each["contact"]["peak_pressure_error"]) for each in (summary, reference))
        self.assert_same(summary, reference, ("contact.peak_pressure",), error)
        self.assert_same(summary, reference, ("contact.force",), 1e-8)

    def test_the_softer_body_is_the_source_whichever_is_written_first(self):
        reference, summary = self.swapped("hertz-dissimilar", "steel surface -> aluminium surface")
        self.assertEqual(summary["contact"]["source"], "aluminium surface")
        self.assert_same(summary, reference, FINDINGS, 1e-9)


class Scaling(Invariance):

    def test_four_times_the_force_gives_twice_the_pressure(self):
        single = self.run_case(self.copy_case("hertz-line-contact"))
        case = self.copy_case("hertz-line-contact", "fourfold")
        change_case(case, {"Geometry/Load cylinder core/Value": "24 N"})
        fourfold = self.run_case(case)
        self.assert_close(number(fourfold["contact"]["force"]), 4 * number(single["contact"]["force"]), 1e-8, "force")
        self.assert_close(number(fourfold["contact"]["peak_pressure"]),
                          2 * number(single["contact"]["peak_pressure"]), 0.005, "peak pressure")

    def test_a_force_per_thickness_is_a_force_on_the_thickness(self):
        reference = self.run_case(self.copy_case("nafems-roller"))
        case = self.copy_case("nafems-roller", "thick")
        change_case(case, {"Geometry/Thickness": "7 mm", "Geometry/Load roller core/Type": "force",
                           "Geometry/Load roller core/Value": "245 kN"})
        summary = self.run_case(case)
        self.assert_close(number(summary["contact"]["force"]), 245e3, 1e-8, "force")
        self.assert_same(summary, reference, ("contact.peak_pressure", "contact.half_width"), 1e-9)


class Meshes(Invariance):
    """The coarse meshes of the two bodies need not match."""

    CELLS_OF_CYLINDER = 24  # round its circumference of 2 pi 10 mm
    WIDTH_OF_BLOCK = 80  # mm

    def test_pressure_is_hertz_pressure_on_a_target_finer_or_coarser_than_the_source(self):
        hertz = closed_forms.hertz_line(6 / 1e-3, 0.01, closed_forms.contact_modulus((210e9, 0.3), (210e9, 0.3)))
        peak, half_width = hertz["peak_pressure"] * 1e-6, hertz["half_width"] * 1e3
        for ratio in (0.7, 1.4):
            # the shift keeps the nodes of the two bodies apart on every level
            cell = ratio * 2 * math.pi * 10 / self.CELLS_OF_CYLINDER
            count = round(self.WIDTH_OF_BLOCK / cell)
            shift = 0.2718 * cell
            case = self.copy_case("hertz-line-contact", f"ratio-{ratio}")
            file = case / "geometry.geo"
            replace_in(file, "{201, 203} = 16 + 1", f"{{201, 203}} = {count} + 1")
            for corner in ("{-W, -W, 0}", "{-W, 0, 0}", "{W, -W, 0}", "{W, 0, 0}"):
                replace_in(file, corner, corner.replace("W,", f"W + {shift:.9f},", 1))
            summary = self.run_case(case)
            table = read_csv(case / "results" / "contact.csv")
            with self.subTest(ratio=ratio):
                self.assert_close(number(summary["contact"]["peak_pressure"]) * 1e-6, peak, 0.005, "peak pressure")
                self.assert_hertz_pressure(table, peak, half_width)

    def assert_hertz_pressure(self, table, peak, half_width):
        """At the nodes but the two next to each end, over whose edges the pressure changes by its own size."""
        touching = sorted((x, p) for x, p in zip(table["x [mm]"], table["contact_pressure [MPa]"]) if p > 0)
        self.assertGreater(len(touching), 16)
        for x, pressure in touching[2:-2]:
            exact = peak * math.sqrt(1 - (x / half_width)**2)
            self.assertLessEqual(abs(pressure - exact), 0.01 * peak, f"x = {x / half_width:.3f} b")


class Ranks(Invariance):
    """The number of MPI processes changes round-off only."""

    TOLERANCE = 1e-8

    def assert_same_on_ranks(self, name, keys):
        case = self.copy_case(name)
        reference = self.run_case(case, ranks=1)
        for ranks in (2, 3, 4):
            summary = self.run_case(case, ranks=ranks)
            with self.subTest(ranks=ranks):
                self.assertEqual(summary["memory"]["ranks"], ranks)
                self.assertEqual(len(list((case / "results").glob("solution.*.vtu"))), ranks)
                self.assert_same(summary, reference, keys, self.TOLERANCE)
                self.assert_same_estimate(summary, reference, self.TOLERANCE)

    def test_a_mechanism_is_the_same_on_1_to_4_ranks(self):
        self.assert_same_on_ranks("johnson-optimum-wheel", WHEEL_FINDINGS)

    def test_a_geometry_is_the_same_on_1_to_4_ranks(self):
        self.assert_same_on_ranks("hertz-line-contact", FINDINGS)


if __name__ == "__main__":
    geneva_cli.main()
