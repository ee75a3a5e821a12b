"""Runs every case of cases/ and compares its summary with the case's expected.json.

expected.json is a list of checks for `geneva run`, or names another command:

    {"command": "synthesize", "checks": [...]}

Each check has a "why" that says where the value comes from, and one of these forms:

    {"key": "contact.peak_pressure", "value": 1.0, "unit": "Pa", "relative_tolerance": 0.005}; a ratio has no unit
    {"key": "mesh.dofs", "at_most": 10000}, or "at_least"
    {"key": "solver.converged", "equals": true}
    {"key": "contact.peak_pressure_error", "at_least_share": 0.5, "of_error_of": "contact.peak_pressure",
     "value": 1.0, "unit": "Pa"}: an error estimate against the true error
    {"key": "path.solutions", "has": {"crank": 0.04, ...}, "absolute_tolerance": 1e-9}: a list with an entry like that
    {"column": "contact_pressure [MPa]", "value": 1.0, "relative_tolerance": 1e-10}: every row of the table

Keys are the dotted names of the command's JSON file, columns the headings of its CSV file (FILES); values are SI.
They come from closed forms (see closed_forms.py) and from publications, never from the program.
"""

import json

import closed_forms
import geneva_cli
from geneva_cli import CliTest, look_up, number, read_csv


# The keys that each form of check has.
FORMS = ({"key", "value", "unit", "relative_tolerance"}, {"key", "value", "relative_tolerance"},
         {"key", "at_most"}, {"key", "at_least"}, {"key", "equals"},
         {"key", "at_least_share", "of_error_of", "value", "unit"}, {"key", "has", "absolute_tolerance"},
         {"column", "value", "relative_tolerance"})

# Bytes of a report that still opens at once.
GREATEST_REPORT = 6e6

# What each command writes: single figures and a table.
FILES = {"run": ("summary.json", "contact.csv"), "cycle": ("cycle.json", "cycle.csv"), "kinematics": ("kinematics.json", "kinematics.csv"),
         "design": ("design.json", "design.csv"), "synthesize": ("synthesis.json", "synthesis.csv")}


def read_command(case):
    """The command that a case is for."""
    content = json.loads((case / "expected.json").read_text())
    return "run" if isinstance(content, list) else content["command"]


def read_expected(case):
    """The checks of a case, whatever its command."""
    content = json.loads((case / "expected.json").read_text())
    return content if isinstance(content, list) else content["checks"]


class Verdict:
    """One check: whether it holds, and its figures."""

    def __init__(self, holds, text):
        self.holds = holds
        self.text = text


def judge(check, summary, columns):
    if "column" in check:
        return judge_column(check, columns)
    entry = look_up(summary, check["key"])
    if "has" in check:
        return judge_list(check, entry)
    if "value" in check and isinstance(entry, dict) and entry["unit"] != check.get("unit"):
        return Verdict(False, f"unit {entry['unit']} instead of {check.get('unit')}")
    value = number(entry)
    if "equals" in check:
        return Verdict(value == check["equals"], f"{value}, expected {check['equals']}")
    if "at_most" in check:
        return Verdict(value <= check["at_most"], f"{value:.6g}, at most {check['at_most']:g}")
    if "at_least" in check:
        return Verdict(value >= check["at_least"], f"{value:.6g}, at least {check['at_least']:g}")
    if "at_least_share" in check:
        true_error = abs(number(look_up(summary, check["of_error_of"])) / check["value"] - 1)
        holds = value >= check["at_least_share"] * true_error
        return Verdict(holds, f"{value:.3%}, the true error is {true_error:.3%}")
    return compare(value, check)


def judge_list(check, entries):
    """The verdict on the entry that is nearest to what the list should have."""
    if not entries:
        return Verdict(False, "the list is empty")
    farthest = min(max(abs(number(entry[name]) - value) for name, value in check["has"].items()) for entry in entries)
    text = f"{len(entries)} entries, the nearest is {farthest:.2e} off, allowed {check['absolute_tolerance']:g}"
    return Verdict(farthest <= check["absolute_tolerance"], text)


def compare(value, check):
    difference = value / check["value"] - 1
    text = f"{value:.9g}, expected {check['value']:.9g}: {difference:+.2e}, allowed {check['relative_tolerance']:g}"
    return Verdict(abs(difference) <= check["relative_tolerance"], text)


def judge_column(check, columns):
    """The verdict on the row that is farthest off."""
    if not columns[check["column"]]:
        return Verdict(False, "the column is empty")
    return compare(max(columns[check["column"]], key=lambda entry: abs(entry - check["value"])), check)


class RunCases(CliTest):
    """One test for every directory of cases/; they are added below."""

    def check_case(self, name):
        case = self.copy_case(name)
        expected = read_expected(case)
        command = read_command(case)
        run = self.geneva(command, case)
        self.assertEqual(run.code, 0, run.describe())
        figures, table = FILES[command]
        summary = json.loads((case / "results" / figures).read_text())
        columns = read_csv(case / "results" / table) if (case / "results" / table).exists() else {}  # without contact
        print(f"\n{name}")
        for check in expected:
            what = check.get("key", check.get("column"))
            with self.subTest(what):
                verdict = judge(check, summary, columns)
                print(f"  {'ok  ' if verdict.holds else 'FAIL'} {what}: {verdict.text}", flush=True)
                self.assertTrue(verdict.holds, f"{what}: {verdict.text} ({check['why']})")
        if command == "run":
            self.check_soundness(summary, case / "results" / "report.html")

    def check_soundness(self, summary, report):
        """What holds for every run of a shipped case."""
        for check in summary["checks"]:
            with self.subTest(check["name"]):
                self.assertTrue(check["passed"], f"{check['value']}, at most {check['limit']}: {check['meaning']}")
        print(f"  report: {report.stat().st_size / 1e6:.1f} MB")
        self.assertLess(report.stat().st_size, GREATEST_REPORT)


class ExpectedValues(CliTest):
    """What stands in the expected.json files."""

    def cases(self):
        return sorted(path.parent for path in (self.source / "cases").glob("*/case.prm"))

    def test_every_case_has_checks_of_known_form_that_say_why(self):
        for case in self.cases():
            expected = read_expected(case)
            self.assertTrue(expected, case.name)
            self.assertIn(read_command(case), FILES)
            for check in expected:
                with self.subTest(f"{case.name}: {check}"):
                    self.assertTrue(check["why"])
                    self.assertIn(set(check) - {"why"}, FORMS)

    def test_expected_values_are_those_of_the_closed_forms(self):
        closed = closed_forms.values()
        for case in self.cases():
            published = {"nafems-roller": ("contact.peak_pressure", "contact.half_width")}.get(case.name, ())
            for check in read_expected(case):
                key = check.get("of_error_of", check.get("key"))
                if "has" in check:
                    self.assertEqual(check["has"], closed[case.name][key])
                if "value" not in check or key in published or key not in closed[case.name]:
                    continue
                with self.subTest(f"{case.name}: {key}"):
                    self.assert_close(check["value"], closed[case.name][key], 1e-12, key)


def add_tests(source):
    """A test method for each case, so that unittest names them."""
    for case in sorted(path.parent.name for path in (source / "cases").glob("*/case.prm")):
        def test(self, name=case):
            self.check_case(name)
        setattr(RunCases, f"test_{case.replace('-', '_')}_meets_its_expectations", test)


if __name__ == "__main__":
    geneva_cli.main(add_tests)
