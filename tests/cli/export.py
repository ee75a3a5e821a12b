"""`geneva export`: wheel, driver and pin as STEP and DXF, as they are drawn elsewhere, and what is refused."""

import json
import math
import re

import geneva_cli
from geneva_cli import CliTest, change_case, number


def entities(file):
    """Lines, arcs and circles of a DXF file by layer: lists of dictionaries from group code to number."""
    lines = [line.strip() for line in file.read_text().splitlines()]
    found, section, entity = {}, None, None
    for code, value in zip(lines[::2], lines[1::2]):
        if code == "0":
            entity = {"type": value}
        elif code == "2" and entity and entity["type"] == "SECTION":
            section = value
        elif code == "8" and section == "ENTITIES":
            found.setdefault(value, []).append(entity)
        if entity is not None and code in ("10", "20", "11", "21", "40", "50", "51"):
            entity[code] = float(value)
    return found


def insert_units(file):
    return int(re.search(r"\$INSUNITS\s+70\s+(\d+)", file.read_text()).group(1))


class Export(CliTest):

    def export(self, name, *arguments):
        target = self.directory / name
        run = self.geneva("export", self.source / "cases" / name, "--output", target, *arguments)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(run.err, "")
        for deviation in re.findall(r"read back within (\S+)", run.out):
            self.assertLessEqual(float(deviation), 1e-9)
        return target, run.out

    def test_a_hollow_pin_has_its_bore(self):
        areas = []
        for bore in (None, "5 mm"):
            case = self.copy_case("indexing-table", f"bore-{bore}")
            if bore:
                with open(case / "case.prm", "a") as file:
                    file.write(f"\nsubsection Mechanism\nsubsection Pin\nset Bore diameter = {bore}\nend\nend\n")
            run = self.geneva("export", case)
            self.assertEqual(run.code, 0, run.describe())
            areas.append(float(re.search(r"pin\.dxf +([0-9.]+) mm", run.out).group(1)))
        self.assertAlmostEqual(areas[0] - areas[1], math.pi * 25 / 4, delta=2e-3)

    def test_every_part_is_written_as_step_and_dxf(self):
        for name, parts in (("indexing-table", ["wheel", "driver", "pin"]),
                            ("internal-six-station", ["wheel", "driver", "pin"]),
                            ("irregular-two-pin", ["wheel", "driver", "pin"]),
                            ("indexing-table-roller", ["wheel", "driver", "roller", "stud"])):
            target, _ = self.export(name)
            self.assertEqual(sorted(file.name for file in target.iterdir()),
                             sorted(f"{part}.{kind}" for part in [*parts, "assembly"] for kind in ("step", "dxf")))
            assembly = (target / "assembly.step").read_text()
            for part in parts:
                self.assertIn(f"PRODUCT('{part}'", assembly)

    def test_the_wheel_has_the_sizes_of_the_case(self):
        target, _ = self.export("indexing-table")
        wheel = entities(target / "wheel.dxf")["wheel"]
        by_type = {kind: [e for e in wheel if e["type"] == kind] for kind in ("LINE", "ARC", "CIRCLE")}
        stations = 6
        self.assertEqual(len(by_type["LINE"]), 2 * stations)  # walls
        self.assertEqual(len(by_type["ARC"]), 4 * stations)  # bottoms, locking arcs, rim on both sides of them
        self.assertEqual(len(by_type["CIRCLE"]), 1)  # bore
        rim = max(math.hypot(line[x], line[y]) for line in by_type["LINE"] for x, y in (("10", "20"), ("11", "21")))
        self.assertAlmostEqual(rim, self.wheel_diameter("indexing-table") / 2, delta=1e-9)

    def wheel_diameter(self, name):
        """In millimetres, from the program's own picture of the mechanism."""
        target = self.directory / f"kinematics-{name}"
        self.assertEqual(self.geneva("kinematics", self.source / "cases" / name, "-o", target).code, 0)
        lengths = json.loads((target / "mechanism.json").read_text())["lengths"]
        return 1e3 * next(number(length["length"]) for length in lengths if length["name"] == "wheel diameter")

    def test_the_assembly_stands_at_the_angle_asked_for(self):
        places = {}
        for angle in (-10, 0, 10, 180):
            target, _ = self.export("indexing-table", "--angle", f"{angle} deg")
            (pin,) = entities(target / "assembly.dxf")["pin"]
            (plate,) = [e for e in entities(target / "assembly.dxf")["driver plate"]
                        if e["type"] == "CIRCLE" and e["40"] > 2 * pin["40"]]
            centres = plate["10"]
            self.assertAlmostEqual(plate["20"], 0, delta=1e-9)
            arm = math.hypot(pin["10"] - centres, pin["20"])
            turned = math.degrees(math.atan2(pin["20"], centres - pin["10"]))
            self.assertAlmostEqual((turned - angle + 180) % 360 - 180, 0, delta=1e-9)
            places[angle] = arm
        self.assertLess(max(places.values()) - min(places.values()), 1e-9)

    def test_inches_of_a_case_are_those_of_its_files(self):
        inches, _ = self.export("johnson-optimum-wheel")
        self.assertEqual(insert_units(inches / "wheel.dxf"), 1)
        self.assertIn("INCH", (inches / "wheel.step").read_text())
        case = self.copy_case("johnson-optimum-wheel", "in-mm")
        change_case(case, {"Output units": "mm-N"})
        run = self.geneva("export", case)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(insert_units(case / "cad" / "wheel.dxf"), 4)
        (small,) = [e for e in entities(inches / "wheel.dxf")["wheel"] if e["type"] == "CIRCLE"]
        (large,) = [e for e in entities(case / "cad" / "wheel.dxf")["wheel"] if e["type"] == "CIRCLE"]
        self.assert_close(large["40"], 25.4 * small["40"], 1e-12, "bore")

    def test_other_files_of_the_directory_stay(self):
        target = self.directory / "indexing-table"
        target.mkdir()
        (target / "mine.txt").write_text("mine")
        self.export("indexing-table")
        self.assertEqual((target / "mine.txt").read_text(), "mine")

    def test_what_cannot_be_drawn_is_refused_in_words(self):
        for case, arguments, words in (
                ("four-bar-geneva", [], "external and internal wheels are drawn"),
                ("hertz-line-contact", [], "there is no Geneva mechanism to draw"),
                ("indexing-table", ["--angle", "20"], "--angle"),
                ("indexing-table", ["--angle", "20 mm"], "--angle")):
            target = self.directory / "refused"
            run = self.geneva("export", self.source / "cases" / case, "-o", target, *arguments)
            self.assertEqual(run.code, 1, run.describe())
            self.assertIn(words, run.err)
            self.assertFalse(target.exists())


if __name__ == "__main__":
    geneva_cli.main()
