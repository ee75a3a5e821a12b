"""Maximum stresses away from the contact: their errors, places and what has none."""

import math

import geneva_cli
from geneva_cli import CliTest, look_up, number, set_parameter

WHEEL = """set Model = mechanism
set Output units = SI
set Accuracy = 2 %
subsection Mechanism
  set Stations = 6
  set Wheel diameter = 100 mm
  set Pin diameter = 14 mm
  set Wheel thickness = 14 mm
  set Driver speed = 300 rpm
  set Driver angle = -20 deg
  set Friction moment = 20 N.m
  set Load inertia = 1e-3 kg.m^2
  set Contact model = full wheel
  subsection Pin
  end
  subsection Pin material
  end
  subsection Wheel material
    set Density = 7850 kg/m^3
  end
end
"""
PSI = 6894.757293168361  # Pa
VALUES = ("von_mises", "tensile")


class Strength(CliTest):

    def run_with(self, name, changes=None, ranks=None):
        case = self.directory / name
        case.mkdir()
        text = WHEEL
        for parameter, value in (changes or {}).items():
            text = set_parameter(text, parameter, value)
        (case / "case.prm").write_text(text)
        return self.run_case(case, ranks=ranks)

    def stresses(self, summary):
        return [look_up(summary, f"strength.wheel.{name}") for name in VALUES]

    def test_errors_at_2_percent_hold_beside_a_run_at_a_seventh_of_it(self):
        coarse = self.run_with("coarse")
        fine = self.run_with("fine", {"Structural accuracy": "0.3 %"})
        for found, truth in zip(self.stresses(coarse), self.stresses(fine)):
            self.assertLess(found["error"], 0.02)
            self.assertLess(truth["error"], 0.003)
            self.assert_close(found["value"], truth["value"], found["error"], "within its error")
            self.assertEqual(found["where"], "bottom of the engaged slot")
        self.assertLess(coarse["mesh"]["dofs"], fine["mesh"]["dofs"])

    def test_they_do_not_depend_on_the_accuracy_of_the_contact(self):
        rough, exact = self.run_with("rough", {"Accuracy": "10 %"}), self.run_with("exact", {"Accuracy": "0.2 %"})
        for one, other in zip(self.stresses(rough), self.stresses(exact)):
            self.assert_close(one["value"], other["value"], one["error"], "within its error")

    def test_the_slots_bottom_is_refined_on_the_meshes_that_the_contact_needs(self):
        case = self.copy_case("internal-six-station")
        with_search = self.run_case(case)
        file = case / "case.prm"
        file.write_text(set_parameter(file.read_text(), "Structural accuracy", "off"))
        without = self.run_case(case)
        self.assertEqual(look_up(with_search, "strength.wheel.tensile")["where"], "bottom of the engaged slot")
        self.assertLess(look_up(with_search, "strength.wheel.tensile")["error"], 0.02)
        self.assertLessEqual(len(with_search["solver"]["levels"]), len(without["solver"]["levels"]) + 1)

    def test_units_and_ranks_give_the_same(self):
        alone = self.run_with("alone")
        inches = self.run_with("inches", {"Mechanism/Wheel diameter": f"{100 / 25.4!r} in",
                                          "Mechanism/Pin diameter": f"{14 / 25.4!r} in",
                                          "Mechanism/Wheel thickness": f"{14 / 25.4!r} in"})
        ranks = self.run_with("ranks", ranks=3)
        for name, other, tolerance in (("inches", inches, 1e-8), ("ranks", ranks, 1e-6)):
            for one, same in zip(self.stresses(alone), self.stresses(other)):
                with self.subTest(name):
                    self.assert_close(same["value"], one["value"], tolerance, "value")
                    self.assert_close(same["error"], one["error"], 1e-3, "error")

    def test_they_are_in_the_closing_table_and_in_the_safety_factors(self):
        summary = self.run_with("yield", {"Mechanism/Wheel material/Yield strength": "300 MPa",
                                          "Mechanism/Wheel material/Fatigue strength": "200 MPa"})
        rows = {row["quantity"]: row for row in summary["comparison"]}
        of_mises = look_up(summary, "strength.wheel.von_mises")
        self.assertEqual(number(rows["von Mises stress, wheel"]["computed"]), of_mises["value"])
        self.assertEqual(rows["tensile stress, wheel"]["error"], look_up(summary, "strength.wheel.tensile")["error"])
        rows = {row["quantity"]: row for row in summary["safety"]}
        factors = {name: row["computed_factor"] for name, row in rows.items()}
        self.assert_close(factors["von Mises stress away from the contact, wheel"], 300e6 / of_mises["value"], 1e-12,
                          "factor")
        self.assert_close(factors["tensile stress away from the contact (fatigue), wheel"],
                          200e6 / look_up(summary, "strength.wheel.tensile")["value"], 1e-12, "factor")
        row = rows["von Mises stress away from the contact, wheel"]  # over the cycle it grows with the pin force
        self.assertLessEqual(row["factor"], row["computed_factor"])

    def test_the_root_of_a_plane_pin_bears_force_and_moment_by_beam_theory(self):
        d, thickness = 14e-3, 14e-3
        for holding, arm, share in (({}, thickness / 2 + d / 4, 1.),
                                    ({"Root gap": "1 mm"}, thickness / 2 + 1e-3, 1.),
                                    ({"Held at": "both ends", "Root gap": "0 mm"}, thickness / 12, 0.5)):
            with self.subTest(holding):
                name = "_".join(holding.values()).replace(" ", "-") or "default"
                summary = self.run_with(name, {"Mechanism/Pin material/Yield strength": "900 MPa",
                                               **{f"Mechanism/Pin/{key}": value for key, value in holding.items()}})
                force = look_up(summary, "load.force")["value"]
                root = {key: entry["value"] for key, entry in summary["pin"].items()}
                self.assert_close(root["root_force"], share * force, 1e-12, "force")
                self.assert_close(root["root_moment"], force * arm, 1e-12, "moment")
                stress = 32 * force * arm / (math.pi * d ** 3)
                self.assert_close(root["root_stress_beam_theory"], stress, 1e-12, "bending")
                self.assert_close(root["root_shear_stress_beam_theory"],
                                  4 / 3 * share * force / (math.pi * d ** 2 / 4), 1e-12, "shear")
                rows = {row["quantity"]: row for row in summary["comparison"]}
                self.assertEqual(number(rows["bending stress, pin root"]["closed_form"]),
                                 root["root_stress_beam_theory"])
                row = {row["quantity"]: row for row in summary["safety"]}[
                    "von Mises stress at the pin's root (beam theory)"]
                self.assertLessEqual(row["factor"], 900e6 / stress * (1 + 1e-12))
        core = self.run_with("core", {"Mechanism/Pin/Held at": "core"})
        self.assertNotIn("pin", core)

    def test_the_place_is_named_also_where_the_first_cell_touches_it_with_one_node_alone(self):
        wheel = self.run_with("three", {"Mechanism/Stations": "3", "Mechanism/Wheel diameter": "120 mm",
                                        "Mechanism/Pin diameter": "19.2 mm", "Mechanism/Wheel thickness": "19.2 mm",
                                        "Mechanism/Driver angle": "at maximum wheel acceleration"})
        for found in self.stresses(wheel):
            self.assertEqual(found["where"], "bottom of the engaged slot")

    def test_off_costs_no_cells(self):
        summaries = {value: self.run_with(value.split()[0], {"Structural accuracy": value}) for value in ("off", "1 %")}
        self.assertLess(summaries["off"]["mesh"]["dofs"], summaries["1 %"]["mesh"]["dofs"])
        self.assertGreater(look_up(summaries["off"], "strength.wheel.von_mises.error"), 0.01)

    def crowned_pin(self, name, structural):
        case = self.copy_case("crowned-pin", name)
        geneva_cli.change_case(case, {"Accuracy": "5 %", "Structural accuracy": structural})
        return self.run_case(case)

    def test_in_3d_errors_hold_where_the_slots_bottom_is_refined_along_the_pin(self):
        for found, truth in zip(self.stresses(self.crowned_pin("fine", "5 %")), (4078, 4305)):
            self.assertLess(found["error"], 0.05)
            # on meshes of 276 000 unknowns and more
            self.assert_close(found["value"], truth * PSI, found["error"], "within its error")

    def test_in_3d_a_limit_that_only_the_stresses_would_pass_ends_a_run_as_converged(self):
        case = self.copy_case("crowned-pin", "limited")
        geneva_cli.change_case(case, {"Accuracy": "5 %", "Structural accuracy": "2 %", "Maximum unknowns": 77000})
        summary = self.run_case(case)
        self.assertTrue(summary["solver"]["converged"])
        self.assertLessEqual(summary["mesh"]["dofs"], 77000)
        self.assertTrue(all(found["error"] > 0.02 for found in self.stresses(summary)))
        notices = [text for text in summary["notices"] if "'wheel' away from the contact is known to" in text]
        self.assertEqual(len(notices), 2)
        self.assertIn("'Maximum unknowns'", notices[0])

    def test_in_3d_the_contact_has_the_meshes_that_it_has_without_them(self):
        contacts = []
        for structural in ("off", "5 %"):
            case = self.copy_case("johnson-optimum-3d", structural.split()[0])
            geneva_cli.change_case(case, {"Accuracy": "20 %", "Structural accuracy": structural})
            contacts.append(self.run_case(case)["contact"])
        self.assert_close(*(number(contact["active_nodes"]) for contact in reversed(contacts)), 0.01, "nodes in contact")
        # its correction is of what the cells around leave, and they are others
        self.assert_close(*(number(contact["peak_pressure"]) / (1 + number(contact["peak_pressure_correction"]))
                            for contact in reversed(contacts)), 0.005, "pressure of the mesh")

    def test_in_3d_the_error_is_not_known_where_cells_are_longer_than_half_of_the_notchs_radius(self):
        summary = self.crowned_pin("long", "off")
        for found in self.stresses(summary):
            self.assertGreaterEqual(found["error"], 1, "as long as the radius: von Mises was off by 12 %")
        (notice,) = [text for text in summary["notices"] if "is not known" in text]
        self.assertIn("'wheel'", notice)
        self.assertIn("'Structural accuracy = 5 %'", notice)

    def test_in_3d_beside_the_sharp_edge_of_a_contact_nothing_is_away_from_it(self):
        summary = self.run_case(self.copy_case("johnson-optimum-3d", "edge"))
        for found in self.stresses(summary):
            self.assertEqual(found["where"], "bottom of the engaged slot")
            self.assertLess(found["error"], 0.05, "what is taken for the contact's own field does not matter")

    def test_in_3d_no_cells_are_spent_on_a_tensile_stress_that_decides_nothing(self):
        summary = self.run_case(self.copy_case("hertz-sphere-3d", "sphere"))
        self.assertLess(number(summary["mesh"]["dofs"]), 60000)
        notices = [text for text in summary["notices"] if "less than a tenth of the von Mises stress" in text]
        self.assertEqual(len(notices), 2, "one for each body")

    def test_in_3d_nothing_is_said_of_the_accuracy_of_a_stress_that_is_not_bounded(self):
        summary = self.run_case(self.copy_case("tilted-pin", "root"))
        self.assertFalse(look_up(summary, "strength.pin.von_mises.bounded"), "it stands beside the clamped root")
        self.assertFalse([text for text in summary["notices"] if "'Structural accuracy' asks for" in text])

    def test_a_block_that_stands_for_a_wheel_has_none(self):
        summary = self.run_with("block", {"Mechanism/Contact model": "local"})
        self.assertEqual(summary["strength"]["wheel"], {"von_mises": None, "tensile": None})

    def test_what_the_bore_gives_to_the_wheel_is_told(self):
        summary = self.run_with("bore")
        bore = summary["reactions"]["bore"]
        self.assert_close(number(bore["total"]), number(look_up(summary, "contact.force")), 1e-3, "no other force")
        self.assert_close(abs(number(bore["moment"])), number(look_up(summary, "equilibrium.bore_torque")), 1e-9, "torque")

    def test_an_accuracy_out_of_range_is_refused(self):
        case = self.directory / "bad"
        case.mkdir()
        (case / "case.prm").write_text(set_parameter(WHEEL, "Structural accuracy", "30 %"))
        run = self.geneva("run", case)
        self.assertEqual(run.code, 1)
        self.assertIn("Structural accuracy", run.err)
        self.assertIn("at most 20 %", run.err)


if __name__ == "__main__":
    geneva_cli.main()
