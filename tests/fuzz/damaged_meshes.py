"""The meshes that Gmsh crashed on are refused in one sentence."""

import pathlib
import sys

import findings

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "cli"))
import geneva_cli  # noqa: E402

CORPUS = pathlib.Path(__file__).resolve().parent / "corpus" / "damaged-meshes"


class DamagedMeshes(geneva_cli.CliTest):

    def test_each_is_refused_in_one_sentence(self):
        cases = sorted(CORPUS.iterdir())
        self.assertGreaterEqual(len(cases), 12)
        for case in cases:
            with self.subTest(case.name):
                run = self.geneva("run", case, "--output", self.directory / "results", time_limit=60)
                self.assertEqual(run.code, 1, run.describe())
                self.assertEqual(findings.of_run(run), [], run.describe())
                self.assertEqual(len(run.err.splitlines()), 1, run.err)
                self.assertIn("geometry.msh: ", run.err)
                self.assertEqual(list(self.directory.iterdir()), [])


if __name__ == "__main__":
    geneva_cli.main()
