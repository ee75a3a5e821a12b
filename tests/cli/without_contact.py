"""Cases without contact: maximum stresses beside closed forms, their errors, and what is refused."""

import math

import geneva_cli
from geneva_cli import CliTest, look_up, number, set_parameter

HEAD = """set Model = geometry
set Output units = mm-N
"""
RING = """a = {a}; b = {b};
Point(1) = {{0, 0, 0}}; Point(2) = {{a, 0, 0}}; Point(3) = {{b, 0, 0}}; Point(4) = {{0, b, 0}}; Point(5) = {{0, a, 0}};
Line(1) = {{2, 3}}; Circle(2) = {{3, 1, 4}}; Line(3) = {{4, 5}}; Circle(4) = {{5, 1, 2}};
Curve Loop(1) = {{1, 2, 3, 4}}; Plane Surface(1) = {{1}};
Transfinite Curve {{1, 3}} = 3; Transfinite Curve {{2, 4}} = 4; Transfinite Surface {{1}}; Recombine Surface {{1}};
Physical Surface("ring") = {{1}};
Physical Curve("bore") = {{4}}; Physical Curve("rim") = {{2}};
Physical Curve("below") = {{1}}; Physical Curve("left") = {{3}};
"""
PRESSURE = """  subsection Load bore
    set Value = 100 MPa
  end
"""
# A quarter of a flat bar with a hole, as the case plate-with-hole.
BAR = """r = {r}; h = {h}; L = {length};
Point(1) = {{0, 0, 0}}; Point(2) = {{r, 0, 0}}; Point(3) = {{0, r, 0}};
Point(4) = {{0, h, 0}}; Point(5) = {{L, h, 0}}; Point(6) = {{L, 0, 0}};
Circle(1) = {{2, 1, 3}}; Line(2) = {{3, 4}}; Line(3) = {{4, 5}}; Line(4) = {{5, 6}}; Line(5) = {{6, 2}};
Curve Loop(1) = {{1, 2, 3, 4, 5}}; Plane Surface(1) = {{1}};
Mesh.MeshSizeMax = h / 3;
Physical Surface("bar") = {{1}};
Physical Curve("left") = {{2}}; Physical Curve("below") = {{5}}; Physical Curve("end") = {{4}};
"""
PULLED = """  set Bodies = bar
  set Supports = left: x, below: y
  set Loads = end
  set Plane = plane stress
  set Thickness = 5 mm
  subsection Load end
    set Type = traction
    set Value = 100 MPa
    set Direction = 1, 0
  end
"""
# A quarter of a ring, pulled at one end along x; held along y where nothing pulls that way.
CURVED = """a = {a}; b = {b}; e = (b - a) / 40; m = (a + b) / 2;
Point(1) = {{0, 0, 0}}; Point(2) = {{a, 0, 0}}; Point(3) = {{b, 0, 0}}; Point(4) = {{0, b, 0}}; Point(5) = {{0, a, 0}};
Point(6) = {{m - e, 0, 0}}; Point(7) = {{m + e, 0, 0}};
Line(1) = {{2, 6}}; Line(2) = {{6, 7}}; Line(3) = {{7, 3}};
Circle(4) = {{3, 1, 4}}; Line(5) = {{4, 5}}; Circle(6) = {{5, 1, 2}};
Curve Loop(1) = {{1, 2, 3, 4, 5, 6}}; Plane Surface(1) = {{1}};
Mesh.MeshSizeMax = (b - a) / 3;
Physical Surface("bar") = {{1}};
Physical Curve("end") = {{1, 3}}; Physical Curve("middle") = {{2}}; Physical Curve("left") = {{5}};
"""
# A quarter of a flat bar with opposite notches. Under bending it is held along y where nothing pulls that way.
NOTCHED = """r = {r}; h = {h}; L = {length}; e = h / 40;
Point(1) = {{0, 0, 0}}; Point(2) = {{L, 0, 0}}; Point(3) = {{L, h, 0}}; Point(4) = {{r, h, 0}}; Point(5) = {{0, h - r, 0}};
Point(6) = {{0, h, 0}}; Point(7) = {{0, e, 0}};
Line(1) = {{1, 2}}; Line(2) = {{2, 3}}; Line(3) = {{3, 4}}; Circle(4) = {{4, 6, 5}}; Line(5) = {{5, 7}}; Line(6) = {{7, 1}};
Curve Loop(1) = {{1, 2, 3, 4, 5, 6}}; Plane Surface(1) = {{1}};
Mesh.MeshSizeMax = h / 3;
Physical Surface("bar") = {{1}};
Physical Curve("below") = {{1}}; Physical Curve("end") = {{2}}; Physical Curve("notch") = {{4}};
Physical Curve("left") = {{5}}; Physical Curve("middle") = {{6}};
"""
# Half of a stepped flat bar; the middle of its thick part is a plane of symmetry.
STEPPED = """r = 3; H = 22.5; h = 15; L = 60; e = H / 40;
Point(1) = {0, 0, 0}; Point(2) = {2 * L, 0, 0}; Point(3) = {2 * L, h, 0}; Point(4) = {L + r, h, 0};
Point(5) = {L, h + r, 0}; Point(6) = {L, H, 0}; Point(7) = {0, H, 0}; Point(8) = {0, e, 0}; Point(9) = {L + r, h + r, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Circle(4) = {4, 9, 5}; Line(5) = {5, 6}; Line(6) = {6, 7};
Line(7) = {7, 8}; Line(8) = {8, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7, 8}; Plane Surface(1) = {1};
Mesh.MeshSizeMax = h / 3; Mesh.MeshSizeMin = 2;
Physical Surface("bar") = {1};
Physical Curve("below") = {1}; Physical Curve("end") = {2}; Physical Curve("fillet") = {4};
Physical Curve("left") = {7}; Physical Curve("middle") = {8};
"""
BEAM = """L = {length}; h = {h};
Point(1) = {{0, 0, 0}}; Point(2) = {{L, 0, 0}}; Point(3) = {{L, h, 0}}; Point(4) = {{0, h, 0}};
Line(1) = {{1, 2}}; Line(2) = {{2, 3}}; Line(3) = {{3, 4}}; Line(4) = {{4, 1}};
Curve Loop(1) = {{1, 2, 3, 4}}; Plane Surface(1) = {{1}};
Transfinite Curve {{1, 3}} = 9; Transfinite Curve {{2, 4}} = 3; Transfinite Surface {{1}}; Recombine Surface {{1}};
v[] = Extrude {{0, 0, h}} {{ Surface{{1}}; Layers{{2}}; Recombine; }};
Physical Volume("beam") = {{v[1]}};
Physical Surface("root") = {{v[5]}}; Physical Surface("end") = {{v[3]}};
"""
# The section of a hollow shaft with a shoulder: x is the radius, y the axis.
SHAFT = """d = 30; D = 45; r = 3; L = 45; b = 12;
Point(1) = {b / 2, 0, 0}; Point(2) = {D / 2, 0, 0}; Point(3) = {D / 2, L, 0}; Point(4) = {d / 2 + r, L, 0};
Point(5) = {d / 2, L + r, 0}; Point(6) = {d / 2, 2 * L, 0}; Point(7) = {b / 2, 2 * L, 0}; Point(8) = {d / 2 + r, L + r, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Circle(4) = {4, 8, 5}; Line(5) = {5, 6}; Line(6) = {6, 7};
Line(7) = {7, 1};
Curve Loop(1) = {1, 2, 3, 4, 5, 6, 7}; Plane Surface(1) = {1};
Mesh.MeshSizeMax = 8; Mesh.MeshSizeMin = 2;
"""
PLANE_SHAFT = SHAFT + """Physical Surface("shaft") = {1};
Physical Curve("thick end") = {1}; Physical Curve("shoulder") = {3}; Physical Curve("fillet") = {4};
Physical Curve("thin part") = {5}; Physical Curve("thin end") = {6}; Physical Curve("bore") = {7};
"""
SHAFT_IN_SPACE = SHAFT + """Recombine Surface{1};
v[] = Extrude {{0, 1, 0}, {0, 0, 0}, ANGLE} {Surface{1}; Layers{LAYERS}; Recombine;};
Physical Volume("shaft") = {v[1]};
Physical Surface("begin") = {1}; Physical Surface("middle") = {v[0]}; Physical Surface("thick end") = {v[2]};
Physical Surface("shoulder") = {v[4]}; Physical Surface("fillet") = {v[5]}; Physical Surface("thin part") = {v[6]};
Physical Surface("thin end") = {v[7]}; Physical Surface("bore") = {v[8]};
"""


class WithoutContact(CliTest):

    def write(self, name, geometry, section, head=""):
        case = self.directory / name
        case.mkdir()
        (case / "geometry.geo").write_text(geometry)
        (case / "case.prm").write_text(f"{HEAD}{head}subsection Geometry\n  set Length unit = mm\n{section}end\n")
        return case

    def ring(self, name, plane, inner=20, outer=50, head="", load=PRESSURE):
        thickness = "" if plane == "axisymmetric" else "  set Thickness = 10 mm\n"
        return self.write(name, RING.format(a=inner, b=outer),
                          f"  set Bodies = ring\n  set Supports = left: x, below: y\n  set Plane = {plane}\n"
                          f"{thickness}" + ("  set Loads = bore\n" if load == PRESSURE else "") + load, head)

    def stress(self, summary, name="tensile", body=None):
        body = body or next(iter(summary["strength"]))
        return look_up(summary, f"strength.{body}.{name}")

    def assert_within_its_error(self, summary, exact, name="tensile", accuracy=0.02, exact_to=0.):
        found = self.stress(summary, name)
        self.assertLessEqual(found["error"], accuracy)
        print(f"  {self.id().split('.')[-1]}: {name} {number(found['value']):.6g} Pa, {exact:.6g} exact: "
              f"{number(found['value']) / exact - 1:+.3%} of {found['error']:.3%}")
        self.assert_close(number(found["value"]), exact, found["error"] + exact_to, name)
        for check in summary["checks"]:
            self.assertTrue(check["passed"], check)

    def test_a_thick_ring_under_pressure_has_lame_s_stress(self):
        summary = self.run_case(self.ring("ring", "plane strain"))
        p, a, b, nu = 100e6, 20., 50., 0.3
        hoop = p * (a * a + b * b) / (b * b - a * a)
        along = nu * (hoop - p)
        mises = math.sqrt(((hoop + p)**2 + (hoop - along)**2 + (along + p)**2) / 2)
        self.assert_within_its_error(summary, hoop)
        self.assert_within_its_error(summary, mises, "von_mises")
        self.assertEqual(self.stress(summary)["where"], "bore")

    def test_a_hollow_sphere_under_pressure_has_lame_s_stress(self):
        summary = self.run_case(self.ring("sphere", "axisymmetric", outer=40))
        p, a, b = 100e6, 20., 40.
        hoop = p * (2 * a**3 + b**3) / (2 * (b**3 - a**3))
        self.assert_within_its_error(summary, hoop)
        self.assert_within_its_error(summary, hoop + p, "von_mises")

    def test_a_turning_disc_has_its_closed_form(self):
        case = self.copy_case("rotating-disc")
        rho, omega, nu, a, b = 7850., 200 * math.pi, 0.3, 0.02, 0.15
        hoop = (3 + nu) / 4 * rho * omega**2 * (b * b + (1 - nu) / (3 + nu) * a * a)
        self.assert_within_its_error(self.run_case(case), hoop)

    def test_a_turning_ring_of_an_axisymmetric_model_is_that_of_the_plane(self):
        # A slice so thin that it is in plane stress; the axis is that of revolution.
        geometry = """Point(1) = {20, 0, 0}; Point(2) = {150, 0, 0}; Point(3) = {150, 2, 0}; Point(4) = {20, 2, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 33; Transfinite Curve {2, 4} = 2; Transfinite Surface {1}; Recombine Surface {1};
Physical Surface("ring") = {1}; Physical Curve("below") = {1};
"""
        case = self.write("slice", geometry, "  set Plane = axisymmetric\n  set Bodies = ring\n  set Supports = below: y\n"
                          "  subsection Body ring\n    set Angular speed = 6000 rpm\n  end\n")
        rho, omega, nu, a, b = 7850., 200 * math.pi, 0.3, 0.02, 0.15
        hoop = (3 + nu) / 4 * rho * omega**2 * (b * b + (1 - nu) / (3 + nu) * a * a)
        self.assert_within_its_error(self.run_case(case), hoop, exact_to=1e-3)

    def test_a_flat_bar_with_a_hole_has_the_stress_of_a_series(self):
        # Least squares of Airy's functions r^n cos(m theta) that leave the hole free, on the same bar: 58 and 82
        # functions, residual 3e-4 and 2e-4 of the tension. Howland's endless strip has 4.32 and 3.14.
        for half_width, length, factor in ((20, 50, 4.34888), (50, 100, 3.15591)):
            case = self.write(f"bar-{half_width}", BAR.format(r=10, h=half_width, length=length), PULLED)
            self.assert_within_its_error(self.run_case(case), factor * 100e6, exact_to=2e-4)

    def test_opposite_notches_have_peterson_s_factors(self):
        # Fits to his charts (Roark's Formulas, h/r = 1), good to a half and one per cent; x = 2 r/H = 0.5. The half bar
        # under even tension bends by sigma H^2/4 times its thickness.
        x, tension = 0.5, 100e6
        factors = {"tension": 3.065 - 3.370 * x + 0.647 * x**2 + 0.658 * x**3,
                   "bending": 3.065 - 6.637 * x + 8.229 * x**2 - 3.636 * x**3}
        nominal = {"tension": tension / (1 - x), "bending": 1.5 * tension / (1 - x)**2}
        supports = {"tension": "left: x, middle: x, below: y", "bending": "left: x, middle: x y, below: x"}
        for name, factor in factors.items():
            section = PULLED.replace("left: x, below: y", supports[name])
            case = self.write(name, NOTCHED.format(r=10, h=20, length=60), section)
            summary = self.run_case(case)
            self.assert_within_its_error(summary, factor * nominal[name], exact_to=0.005 if name == "tension" else 0.01)
            self.assertEqual(self.stress(summary)["where"], "notch")

    def test_a_curved_bar_has_golovin_s_stress(self):
        a, b = 20., 40.
        section = """  set Bodies = bar
  set Supports = left: x, middle: y
  set Loads = end, middle
  set Plane = plane stress
  set Thickness = 10 mm
  subsection Load end
    set Type = traction
    set Value = 10 MPa
    set Direction = 1, 0
  end
  subsection Load middle
    set Type = traction
    set Value = 10 MPa
    set Direction = 1, 0
  end
"""
        summary = self.run_case(self.write("curved", CURVED.format(a=a, b=b), section))
        force = 10e6 * (b - a)
        n = a * a - b * b + (a * a + b * b) * math.log(b / a)
        stress = force / n * (3 * a - b * b / a - (a * a + b * b) / a)
        # The even load's own run at 0.1 % is 0.75 % below.
        self.assert_within_its_error(summary, abs(stress), exact_to=0.01)
        self.assert_close(number(self.stress(summary)["place"]["x"]), 0., 1e-3, "at the plane of symmetry")

    def test_a_beam_in_space_has_the_stress_of_bending_where_its_maximum_is(self):
        # The clamped face's edges are left out: the maximum stands where that ends. Without Poisson's ratio the clamp
        # changes nothing of the bending.
        length, h, force = 80e-3, 10e-3, 100.
        section = """  set Bodies = beam
  set Supports = root: fixed
  set Loads = end
  subsection Body beam
    set Poisson's ratio = 0
  end
  subsection Load end
    set Type = traction
    set Value = 1 MPa
    set Direction = 0, 1, 0
  end
"""
        summary = self.run_case(self.write("beam", BEAM.format(length=80, h=10), section,
                                           "set Dimension = 3\nset Structural accuracy = 4 %\n"))
        x = number(self.stress(summary)["place"]["x"])
        self.assertLess(x, 0.3 * length)
        self.assert_within_its_error(summary, 6 * force * (length - x) / h**3, accuracy=0.04, exact_to=0.01)

    def test_a_shoulder_fillet_holds_beside_a_finer_run_under_tension_and_bending(self):
        # Peterson's charts, as Roark's formulas fit them: 2.235 and 1.830; newer ones are higher, as his for shafts are.
        nominal = {"tension": 100e6, "bending": 150e6}
        fitted = {"tension": 2.235, "bending": 1.830}
        supports = {"tension": "left: x, middle: x, below: y", "bending": "left: x, middle: x y, below: x"}
        for name in nominal:
            section = PULLED.replace("left: x, below: y", supports[name])
            fine = self.run_case(self.write(f"fine-{name}", STEPPED, section, "set Structural accuracy = 0.5 %\n"))
            truth = number(self.stress(fine)["value"])
            summary = self.run_case(self.write(name, STEPPED, section))
            self.assert_within_its_error(summary, truth, exact_to=self.stress(fine)["error"])
            self.assertEqual(self.stress(summary)["where"], "fillet")
            self.assert_close(truth / nominal[name], fitted[name], 0.04, "Peterson")

    def test_a_revolved_fillet_is_a_torus_and_has_the_stress_of_the_axisymmetric_model(self):
        section = """  set Bodies = shaft
  set Supports = thick end: y{supports}
  set Loads = thin end
{plane}  subsection Load thin end
    set Type = traction
    set Value = 100 MPa
    set Direction = {direction}
  end
"""
        plane = self.write("plane", PLANE_SHAFT,
                           section.format(supports="", plane="  set Plane = axisymmetric\n", direction="0, 1"),
                           "set Structural accuracy = 0.5 %\n")
        quarter = self.write("quarter", SHAFT_IN_SPACE.replace("ANGLE", "Pi / 2").replace("LAYERS", "5"),
                             section.format(supports=", begin: z, middle: x", plane="", direction="0, 1, 0"),
                             "set Dimension = 3\nset Structural accuracy = 8 %\n")
        listed = self.geneva("surfaces", quarter).out
        self.assertRegex(listed, r"fillet +torus of radii 18 and 3 mm")
        self.assertRegex(listed, r"shoulder +plane")
        self.assertRegex(listed, r"thin part +cylinder of radius 15 mm")
        truth = self.stress(self.run_case(plane))
        summary = self.run_case(quarter)
        self.assert_within_its_error(summary, number(truth["value"]), accuracy=0.08, exact_to=truth["error"])
        self.assertEqual(self.stress(summary)["where"], "fillet")

    def test_the_error_of_notches_and_fillets_holds_beside_a_finer_run(self):
        for name in ("shaft-fillet", "plate-with-hole"):
            case, fine = self.copy_case(name), self.copy_case(name, f"{name}-fine")
            text = set_parameter((fine / "case.prm").read_text(), "Structural accuracy", "0.3 %")
            (fine / "case.prm").write_text(text)
            truth = self.stress(self.run_case(fine))
            self.assertLess(truth["error"], 0.003)
            self.assert_within_its_error(self.run_case(case), number(truth["value"]), exact_to=truth["error"])

    def test_units_and_ranks_give_the_same(self):
        alone = self.stress(self.run_case(self.ring("alone", "plane strain")))
        ranks = self.stress(self.run_case(self.ring("ranks", "plane strain"), ranks=3))
        small = self.ring("small", "plane strain", 20 / 25.4, 50 / 25.4)
        (small / "case.prm").write_text((small / "case.prm").read_text().replace("Length unit = mm", "Length unit = in"))
        for other, tolerance in ((ranks, 1e-7), (self.stress(self.run_case(small)), 1e-7)):
            self.assert_close(number(other["value"]), number(alone["value"]), tolerance, "value")
            self.assert_close(other["error"], alone["error"], 1e-4, "error")

    def test_a_hanging_bar_has_its_own_weight(self):
        geometry = """Point(1) = {0, 0, 0}; Point(2) = {60, 0, 0}; Point(3) = {60, 20, 0}; Point(4) = {0, 20, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 7; Transfinite Curve {2, 4} = 3; Transfinite Surface {1}; Recombine Surface {1};
Physical Surface("bar") = {1}; Physical Curve("left") = {4}; Physical Curve("below") = {1};
"""
        section = """  set Bodies = bar
  set Supports = left: x, below: y
  set Plane = plane stress
  set Thickness = 5 mm
  subsection Body bar
    set Gravity = 9.81 m/s^2, 0 m/s^2
    set Density = 8000 kg/m^3
    set Poisson's ratio = 0
  end
"""
        self.assert_within_its_error(self.run_case(self.write("hanging", geometry, section)), 8000 * 9.81 * 0.06,
                                     exact_to=1e-9)

    def test_a_corner_at_which_the_stress_grows_is_named_and_left_out(self):
        # The lines of symmetry make re-entrant corners of both ends of the slanting edge, which the drawing does not show.
        bar = BAR.replace("Circle(1)", "Line(1)").replace("{{2, 1, 3}}", "{{2, 3}}")
        summary = self.run_case(self.write("diamond", bar.format(r=10, h=50, length=100), PULLED))
        self.assertEqual([place["why"] for place in summary["strength_left_out"]], ["growth", "growth"])
        self.assert_close(number(summary["strength_left_out"][0]["place"]["y"]), 0.01, 1e-9, "the diamond's tip")
        self.assert_close(number(summary["strength_left_out"][1]["place"]["x"]), 0.01, 1e-9, "its other corner")
        found = self.stress(summary)
        self.assertFalse(found["bounded"])
        self.assertLess(found["error"], 0.02)
        self.assertIn("left out, since unbounded: a corner of", (self.directory / "diamond/results/log.txt").read_text())

    def test_what_has_no_meaning_without_contact_is_refused(self):
        cases = {"Accuracy": ("set Accuracy = 1 %\n", ("'Accuracy'", "no 'Contact pairs'", "'Structural accuracy'")),
                 "Allowable": ("subsection Allowable\n  set Contact pressure = 1 GPa\nend\n",
                               ("'Contact pressure'", "no contact pressure")),
                 "Published": ("subsection Published\n  set Peak pressure = 1 GPa\nend\n",
                               ("'Peak pressure'", "no contact pressure"))}
        for name, (head, words) in cases.items():
            run = self.geneva("run", self.ring(name, "plane strain", head=head))
            self.assertEqual(run.code, 1, run.describe())
            for word in ("case.prm", *words):
                self.assertIn(word, run.err)

    def test_a_body_without_any_load_is_refused(self):
        run = self.geneva("run", self.ring("idle", "plane strain", load=""))
        self.assertEqual(run.code, 1, run.describe())
        self.assertIn("no body has any stress", run.err)
        self.assertFalse((self.directory / "idle" / "results").exists())

    def test_a_limit_ends_it_with_the_result_so_far(self):
        case = self.ring("limited", "plane strain", head="set Maximum unknowns = 1500\nset Structural accuracy = 0.1 %\n")
        run = self.geneva("run", case)
        self.assertEqual(run.code, 2, run.describe())
        self.assertIn("'Structural accuracy' =", run.err)
        self.assertTrue((case / "results" / "report.html").exists())

    def test_the_report_shows_the_maximum_and_no_contact(self):
        case = self.ring("report", "plane strain", head="set Title = thick ring\n")
        self.run_case(case)
        page = (case / "results" / "report.html").read_text()
        for text in ("Maximum von Mises stress, mesh by mesh", "Places of the maximum stresses:", "of &#39;ring&#39;",
                     "estimated error of the maximum stress"):
            self.assertIn(text, page)
        for text in ("Contact pressure beside", "away from the contact"):
            self.assertNotIn(text, page)
        files = {path.name for path in (case / "results").iterdir()}
        self.assertFalse(files & {"contact.csv", "contact.vtu", "depth.csv"})


if __name__ == "__main__":
    geneva_cli.main()
