"""The site of doc/: built into a temporary directory, checked, and looked at in a browser, from disk.

    python3 tests/site/site.py . -v
"""

import html
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(ROOT / "tests" / "cli"))
from browser import Browser  # noqa: E402

DESK, TELEPHONE = (1280, 900), (390, 900)  # windows [pixels]


def build(root, site):
    return subprocess.run([root / "scripts" / "site", site], capture_output=True, text=True, check=False, timeout=120)


def check(site):
    return subprocess.run(["/usr/bin/python3", "-B", ROOT / "doc" / "site" / "check.py", site], capture_output=True,
                          text=True, check=False, timeout=60)


class Site(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.directory = pathlib.Path(tempfile.mkdtemp(prefix="geneva-site-"))
        cls.addClassCleanup(shutil.rmtree, cls.directory, ignore_errors=True)
        cls.site = cls.directory / "site"
        cls.built = build(ROOT, cls.site)
        cls.pages = sorted(cls.site.rglob("*.html"))

    def test_it_is_built_without_a_warning_and_with_valid_links(self):
        self.assertEqual(self.built.returncode, 0, self.built.stderr)
        self.assertEqual(self.built.stderr, "")
        self.assertRegex(self.built.stdout, r"^site: \d+ pages, \d+ links, all of them valid")

    def test_every_page_of_doc_and_every_case_is_in_the_navigation(self):
        start = (self.site / "index.html").read_text()
        navigation = re.search(r'<nav class="md-nav md-nav--primary".*?</nav>\s*</div>', start, re.DOTALL).group()
        reached = set(re.findall(r'href="([^"#]+)"', navigation))
        wanted = {f"{page.stem}.html" for page in (ROOT / "doc").glob("*.md")}
        wanted |= {f"cases/{page.parent.name}/index.html" for page in (ROOT / "cases").glob("*/README.md")}
        self.assertGreater(len(wanted), 40)
        self.assertEqual(wanted - reached, set())

    def test_every_parameter_has_an_anchor_and_its_help(self):
        page = html.unescape((self.site / "parameters.html").read_text())
        names = re.findall(r"^ *set (.+?) +=", (ROOT / "doc" / "parameters.prm").read_text(), re.MULTILINE)
        self.assertGreater(len(names), 100)
        self.assertEqual(len(re.findall(r"<h3 id=", page)), len(names))
        self.assertIn('<h3 id="mechanism-pin-held-at">Held at', page)
        self.assertIn("Diameter D of the wheel's rim", page)
        self.assertEqual(page.count("Allowed: "), len(names))

    def test_faults_of_a_site_are_named(self):
        broken = self.directory / "broken"
        shutil.copytree(self.site, broken)
        for addition, complaint in (
                ('<a href="nowhere.html">x</a>', "links to nowhere.html, which is not there"),
                ('<a href="theory.html#no-such">x</a>', "no such anchor"),
                ('<script src="https://example.org/x.js"></script>', "from another host"),
                ('<img src="//example.org/x.png">', "from another host")):
            with self.subTest(addition):
                page = (self.site / "guide.html").read_text()
                (broken / "guide.html").write_text(page.replace("</body>", addition + "</body>"))
                found = check(broken)
                self.assertEqual(found.returncode, 1)
                self.assertIn("guide.html: ", found.stderr)
                self.assertIn(complaint, found.stderr)
        (broken / "guide.html").write_text(page)
        (broken / "assets" / "site.css").write_text("@font-face { src: url(https://example.org/f.woff2) }")
        self.assertIn("from another host", check(broken).stderr)

    def test_a_page_outside_the_navigation_and_a_link_to_no_file_fail_the_build(self):
        copy = self.directory / "copy"
        for part in ("doc", "cases", "scripts"):
            shutil.copytree(ROOT / part, copy / part, ignore=shutil.ignore_patterns("results", "sweep", "__pycache__"))
        for part in ("README.md", "CHANGELOG.md"):
            shutil.copy(ROOT / part, copy / part)
        (copy / "doc" / "stray.md").write_text("# Stray\n\n[gone](../tests/gone.py)\n")
        failed = build(copy, self.directory / "stray")
        self.assertNotEqual(failed.returncode, 0)
        self.assertIn("stray.md is not in the navigation", failed.stderr)
        self.assertIn("doc/stray.md links to ../tests/gone.py, which is not there", failed.stderr)

    def test_every_page_fits_loads_nothing_from_elsewhere_and_shows_its_formulas(self):
        formulas = 0
        with Browser(*DESK) as browser:
            for page in self.pages:
                with self.subTest(page=str(page.relative_to(self.site))):
                    browser.open(page)
                    for width, height in (DESK, TELEPHONE):
                        browser.resize(width, height)
                        # A page may take a moment to lay out anew.
                        self.assertTrue(browser.wait_for(f"return document.documentElement.scrollWidth <= {width}"),
                                        f"wider than {width} pixels")
                    browser.resize(*DESK)
                    state = browser.run(
                        "return {pictures: [...document.images].filter(image => !image.naturalWidth).map(image => image.src),"
                        "  formulas: document.querySelectorAll('.arithmatex').length,"
                        "  typeset: document.querySelectorAll('.arithmatex > .katex, .arithmatex > .katex-display').length,"
                        "  loaded: performance.getEntriesByType('resource').map(entry => entry.name)}")
                    self.assertEqual(state["pictures"], [])
                    self.assertEqual(state["typeset"], state["formulas"])
                    self.assertEqual([name for name in state["loaded"] if not name.startswith("file:")], [])
                    formulas += state["formulas"]
            self.assertGreater(formulas, 300)
            self.assertEqual([entry["message"] for entry in browser.console()], [])

    def test_the_search_finds_a_parameter_from_disk(self):
        with Browser(*DESK) as browser:
            browser.open(self.site / "cases" / "crowned-pin" / "index.html")
            browser.run("const field = document.querySelector('.md-search__input'); field.focus(); field.value = 'root gap';"
                        "field.dispatchEvent(new KeyboardEvent('keyup', {bubbles: true}))")
            found = browser.wait_for("return [...document.querySelectorAll('.md-search-result__link')].map(a => a.href)")
            self.assertIn((self.site / "parameters.html").as_uri() + "#mechanism-pin-root-gap",
                          [re.sub(r"\?.*(?=#)", "", link) for link in found])
            self.assertEqual([entry["message"] for entry in browser.console()], [])


if __name__ == "__main__":
    unittest.main()
