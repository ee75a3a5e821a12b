"""A results directory is replaced as a whole or not at all, whatever comes between."""

import contextlib
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import time

import geneva_cli
from geneva_cli import CRASH_SIGNS, CliTest, read_summary, replace_in

CASE = "hertz-line-contact"
QUICK = "5 %"
# Runs that are killed; more of them with GENEVA_KILLS.
KILLS = int(os.environ.get("GENEVA_KILLS", "24"))


class WholeResults(CliTest):

    def case(self, name="case"):
        case = self.copy_case(CASE, name)
        text = (case / "case.prm").read_text()
        (case / "case.prm").write_text(geneva_cli.set_parameter(text, "Accuracy", QUICK))
        return case

    def start(self, *arguments, ranks=None, **options):
        launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks)] if ranks else []
        return subprocess.Popen([*launcher, str(self.program), *map(str, arguments)], text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=geneva_cli.environment(),
                                **options)

    def wait_for(self, path):
        end = time.monotonic() + 30
        while not path.exists():
            self.assertLess(time.monotonic(), end, f"{path} does not come")
            time.sleep(0.002)

    def assert_nothing_is_left_beside(self, results):
        self.assertEqual([path.name for path in results.parent.iterdir()
                          if path.name.startswith(f".{results.name}.")], [])

    def assert_refused(self, run, *words, code=1):
        self.assertEqual(run.code, code, run.describe())
        for word in words:
            self.assertIn(word, run.err, run.describe())
        for sign in CRASH_SIGNS:
            self.assertNotIn(sign, run.out + run.err, run.describe())


class Replacing(WholeResults):

    def test_keeps_what_is_not_its_own(self):
        case = self.case()
        results = case / "results"
        (results / "pictures" / "deep").mkdir(parents=True)
        (results / "pictures" / "deep" / "one.png").write_text("picture")
        (results / "notes.txt").write_text("notes")
        (results / "to notes").symlink_to("notes.txt")
        (results / "solution.17.vtu").write_text("of a run on many ranks")
        results.chmod(0o750)
        for command in ("run", "kinematics"):
            if command == "kinematics":
                case = self.copy_case("johnson-optimum-wheel")
                shutil.copytree(results, case / "results", symlinks=True)
                results = case / "results"
                results.chmod(0o750)
            with self.subTest(command):
                run = self.geneva(command, case)
                self.assertEqual(run.code, 0, run.describe())
                self.assertEqual((results / "pictures" / "deep" / "one.png").read_text(), "picture")
                self.assertEqual((results / "notes.txt").read_text(), "notes")
                self.assertEqual(os.readlink(results / "to notes"), "notes.txt")
                self.assertFalse((results / "solution.17.vtu").exists())
                self.assertEqual(results.stat().st_mode & 0o777, 0o750)
                self.assert_nothing_is_left_beside(results)

    def test_follows_a_link_to_the_directory(self):
        case = self.case()
        (self.directory / "elsewhere").mkdir()
        (case / "results").symlink_to(self.directory / "elsewhere")
        self.run_case(case)
        self.assertTrue((case / "results").is_symlink())
        self.assertTrue((self.directory / "elsewhere" / "summary.json").is_file())

    def test_mends_what_an_interruption_left(self):
        case = self.case()
        self.run_case(case)
        (case / "results" / "pictures").mkdir()
        # Killed between the two renames where directories cannot be exchanged ...
        (case / "results").rename(case / ".results.old")
        (case / ".results.partial").mkdir()
        (case / ".results.lock").write_text("1\n")
        run = self.geneva("kinematics", case)  # refused, since it has no mechanism
        self.run_case(case)
        self.assertTrue((case / "results" / "pictures").is_dir(), run.describe())
        self.assert_nothing_is_left_beside(case / "results")
        # ... or after an exchange, with the old one still there.
        shutil.copytree(case / "results", case / ".results.partial")
        (case / "results" / "pictures").rmdir()
        self.run_case(case)
        self.assertTrue((case / "results" / "pictures").is_dir())
        self.assert_nothing_is_left_beside(case / "results")


class Refusals(WholeResults):
    """What can be known before the solution is said before it."""

    def assert_refused_at_once(self, case, *words, output=None):
        run = self.geneva("run", case, *(["--output", output] if output else []))
        self.assert_refused(run, *words)
        self.assertNotIn("unknowns", run.out)

    def test_a_name_that_is_taken_by_a_directory(self):
        case = self.case()
        (case / "results" / "summary.json").mkdir(parents=True)
        self.assert_refused_at_once(case, "summary.json", "not a file", "--output")
        self.assertEqual([path.name for path in (case / "results").iterdir()], ["summary.json"])

    def test_a_link_that_leads_to_nothing(self):
        case = self.case()
        (case / "results").symlink_to(self.directory / "nowhere")
        self.assert_refused_at_once(case, "results", "a link that leads to nothing", "--output")

    def test_names_that_are_too_long(self):
        self.assert_refused_at_once(self.case(), "250 bytes, of which", output=self.directory / (250 * "n"))
        deep = self.directory.joinpath(*(200 * "d" for _ in range(21)))
        self.assert_refused_at_once(self.case("other"), "bytes, of which", output=deep)

    def test_long_names_that_the_system_takes_are_no_error(self):
        case = self.case()
        output = self.directory.joinpath(*(230 * "d" for _ in range(3)))
        run = self.geneva("run", case, "--output", output)
        self.assertEqual(run.code, 0, run.describe())
        self.assertTrue((output / "results.h5").is_file())

    def test_the_current_directory(self):
        case = self.case()
        (case / "results").mkdir()
        done = subprocess.run([str(self.program), "run", str(case)], cwd=case / "results", text=True,
                              capture_output=True, env=geneva_cli.environment(), check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("current directory", done.stderr)

    def test_a_current_directory_that_is_no_more(self):
        gone = self.directory / "gone"
        gone.mkdir()
        script = f'rmdir "$PWD" && exec "{self.program}" run case --output results'
        done = subprocess.run(["sh", "-c", script], cwd=gone, text=True, capture_output=True,
                              env=geneva_cli.environment(), check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"^geneva: the current directory cannot be used \(.*\): [^\n]*\n$")

    def test_too_little_address_space(self):
        script = f'ulimit -v 900000 && exec "{self.program}" run case'
        done = subprocess.run(["sh", "-c", script], text=True, capture_output=True,
                              env=geneva_cli.environment(), check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"^geneva: the address space [^\n]* 0\.922 GB; [^\n]*ulimit -v\)\n$")

    def test_a_file_in_the_way(self):
        case = self.case()
        (case / "results").write_text("a file")
        self.assert_refused_at_once(case, "a file of that name is in the way")


class Writing(WholeResults):

    def test_does_not_follow_planted_links(self):
        case = self.copy_case("johnson-optimum-wheel")
        (case / "results").mkdir()
        victim = self.directory / "victim"
        victim.write_text("untouched")
        for name in (".kinematics.json.partial", "kinematics.json", "report.html"):
            (case / "results" / name).symlink_to(victim)
        run = self.geneva("kinematics", case)
        self.assertEqual(run.code, 0, run.describe())
        self.assertEqual(victim.read_text(), "untouched")
        self.assertFalse((case / "results" / "kinematics.json").is_symlink())
        report = self.geneva("report", case / "results")
        self.assertEqual(report.code, 0, report.describe())
        self.assertEqual(victim.read_text(), "untouched")

    def test_standard_output_that_cannot_be_written_is_said(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([str(self.program), "parameters"], stdout=full, stderr=subprocess.PIPE, text=True,
                                  env=geneva_cli.environment(), check=False)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stderr, "geneva: cannot write all of standard output\n")

    def test_a_reader_that_has_gone_does_not_cost_the_results(self):
        case = self.case()
        started = self.start("run", case)
        started.stdout.close()
        self.assertEqual(started.wait(timeout=120), 0, started.stderr.read())
        started.stderr.close()
        self.assertTrue((case / "results" / "summary.json").is_file())


class TwoRuns(WholeResults):

    def test_the_second_one_into_a_directory_is_refused_at_once(self):
        one, other = self.case("one"), self.case("other")
        text = (one / "case.prm").read_text()
        (one / "case.prm").write_text(geneva_cli.set_parameter(text, "Accuracy", "0.05 %"))
        output = self.directory / "shared"
        first = self.start("run", one, "--output", output)
        self.wait_for(self.directory / ".shared.partial")
        second = self.geneva("run", other, "--output", output)
        self.assert_refused(second, "shared", f"another run (process {first.pid}) writes there")
        _, err = first.communicate(timeout=120)
        self.assertEqual(first.returncode, 0, err)
        self.assertEqual(read_summary(output)["case"]["name"], "one")
        self.assert_nothing_is_left_beside(output)


class Interruptions(WholeResults):

    def interrupt(self, number, ranks=None, delay=0.):
        case = self.copy_case("crowned-pin", f"{number}-{ranks}-{delay}")
        text = (case / "case.prm").read_text()
        (case / "case.prm").write_text(geneva_cli.set_parameter(text, "Accuracy", "0.5 %"))
        started = self.start("run", case, ranks=ranks)
        self.wait_for(case / ".results.partial")
        time.sleep(delay)
        started.send_signal(number)
        begin = time.monotonic()
        _, err = started.communicate(timeout=30)
        self.assertLess(time.monotonic() - begin, 2.)
        self.assertEqual(sorted(path.name for path in case.iterdir() if path.name not in ("case.prm", "README.md", "expected.json")), [])
        return started.returncode, err

    def test_end_it_with_a_sentence_and_leave_nothing(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            for delay in (0., 0.3, 1.5):
                with self.subTest(f"{number!r} {delay}"):
                    returned, err = self.interrupt(number, delay=delay)
                    self.assertEqual(returned, code, err)
                    self.assertEqual(err, f"\ngeneva: interrupted ({number.name}); nothing was left half written\n")

    def test_end_all_ranks(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number.name):
                code, err = self.interrupt(number, ranks=2, delay=1.)
                self.assertNotEqual(code, 0)
                self.assertEqual(err.count("nothing was left half written"), 1, err)

    def test_kills_leave_old_or_new_results_whole(self):
        """SIGKILL at moments around the end of a run."""
        self.assert_whole_after_kills(KILLS, lambda run: run.kill())

    def test_a_rank_killed_among_three_leaves_old_or_new_results_whole(self):
        self.assert_whole_after_kills(KILLS // 6, lambda run: self.kill_rank(run, random.randrange(3)), ranks=3)

    def assert_whole_after_kills(self, count, kill, **options):
        case = self.case()
        text = (case / "case.prm").read_text()
        self.run_case(case)
        begin = time.monotonic()
        self.start("run", case, **options).communicate(timeout=geneva_cli.TIME_LIMIT)
        length = time.monotonic() - begin
        random.seed(1)
        seen = set()
        for i in range(count):
            (case / "case.prm").write_text(geneva_cli.set_parameter(text, "Title", f"run {i}"))
            started = self.start("run", case, **options)
            # The first one before anything is solved, the others around the end.
            if i == 0:
                self.wait_for(case / ".results.partial")
            else:
                time.sleep(length * (0.7 + 0.5 * i / count))
            kill(started)
            started.communicate(timeout=30)
            titles = {self.title_in_summary(case), self.title_in_copy(case)}
            self.assertEqual(len(titles), 1, titles)
            seen.add(titles == {f"run {i}"})
        self.assertIn(False, seen)
        self.run_case(case)
        self.assert_nothing_is_left_beside(case / "results")

    def kill_rank(self, run, rank):
        """Kills one of the processes that mpirun has started, if they still run."""
        ranks = []
        for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
            with contextlib.suppress(OSError):
                name, parent = re.match(r"\d+ \((.*)\) \S (\d+)", status.read_text()).groups()
                if name == "geneva-solver" and int(parent) == run.pid:
                    ranks.append(int(status.parent.name))
        if rank < len(ranks):
            with contextlib.suppress(ProcessLookupError):
                os.kill(sorted(ranks)[rank], signal.SIGKILL)

    @staticmethod
    def title_in_summary(case):
        return read_summary(case / "results")["case"]["title"]

    @staticmethod
    def title_in_copy(case):
        text = (case / "results" / "case.prm").read_text()
        return re.search(r"set Title\s*= ([^#]*)", text).group(1).strip()


if __name__ == "__main__":
    geneva_cli.main()
