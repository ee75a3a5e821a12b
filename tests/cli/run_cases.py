"""Runs every case of cases/ and compares its summary with the case's expected.json.

expected.json is a list of checks. Each has a "why" that says where the value comes from, and one of these forms:

    {"key": "contact.peak_pressure", "value": 1.0, "unit": "Pa", "relative_tolerance": 0.005}
    {"key": "mesh.dofs", "at_most": 10000}, or "at_least"
    {"key": "solver.converged", "equals": true}
    {"key": "contact.peak_pressure_error", "at_least_share": 0.5, "of_error_of": "contact.peak_pressure",
     "value": 1.0, "unit": "Pa"}: an error estimate against the true error
    {"column": "contact_pressure [MPa]", "value": 1.0, "relative_tolerance": 1e-10}: every row of contact.csv

Keys are the dotted names of summary.json; values are SI. They come from closed forms (see closed_forms.py) and from
publications, never from the program.
"""

import json

import closed_forms
import geneva_cli
from geneva_cli import CliTest, look_up, number, read_csv


# The keys that each form of check has.
FORMS = ({"key", "value", "unit", "relative_tolerance"}, {"key", "at_most"}, {"key", "at_least"}, {"key", "equals"},
         {"key", "at_least_share", "of_error_of", "value", "unit"}, {"column", "value", "relative_tolerance"})


def read_expected(case):
    return json.loads((case / "expected.json").read_text())


class Verdict:
    """One check: whether it holds, and its figures."""

    def __init__(self, holds, text):
        self.holds = holds
        self.text = text


def judge(check, summary, columns):
    if "column" in check:
        return judge_column(check, columns)
    entry = look_up(summary, check["key"])
    if "unit" in check and isinstance(entry, dict) and entry["unit"] != check["unit"]:
        return Verdict(False, f"unit {entry['unit']} instead of {check['unit']}")
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
        summary = self.run_case(case)
        columns = read_csv(case / "results" / "contact.csv")
        print(f"\n{name}")
        for check in expected:
            what = check.get("key", check.get("column"))
            with self.subTest(what):
                verdict = judge(check, summary, columns)
                print(f"  {'ok  ' if verdict.holds else 'FAIL'} {what}: {verdict.text}", flush=True)
                self.assertTrue(verdict.holds, f"{what}: {verdict.text} ({check['why']})")


class ExpectedValues(CliTest):
    """What stands in the expected.json files."""

    def cases(self):
        return sorted(path.parent for path in (self.source / "cases").glob("*/case.prm"))

    def test_every_case_has_checks_of_known_form_that_say_why(self):
        for case in self.cases():
            expected = read_expected(case)
            self.assertTrue(expected, case.name)
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
