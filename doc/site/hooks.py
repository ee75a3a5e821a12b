"""What makes a site of pages that are written to be read in the repository.

Links of the pages are those of the repository. On the site README.md is the title page, the pages of cases/ and the
changelog are pages as well, parameters.prm is one with an anchor for each parameter, and any other file is shown by its
path. A link to what is not there is a warning, which fails a strict build.
"""

import logging
import pathlib
import posixpath
import re
import shutil

from mkdocs.structure.files import File

import parameter_page

ROOT = pathlib.Path(__file__).resolve().parents[2]
KATEX = pathlib.Path("/usr/share/javascript/katex")
CASES = sorted(path.parent.name for path in (ROOT / "cases").glob("*/README.md"))

# Paths of pages on the site by their paths in the repository, where they are not those below doc/.
PAGES = {
    "README.md": "index.md",
    "doc/parameters.prm": "parameters.md",
    "CHANGELOG.md": "CHANGELOG.md",
    "cases": "cases/README.md",
    **{f"cases/{name}/README.md": f"cases/{name}/README.md" for name in CASES},
}
# Pages without a file of their own.
MADE = ("parameters.md", "cases/README.md")

LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s]+)\)")
log = logging.getLogger("mkdocs.geneva")


def on_config(config):
    for entry in config["nav"]:
        if "Cases" in entry:
            entry["Cases"] = ["cases/README.md"] + [{name: f"cases/{name}/README.md"} for name in CASES]
    return config


def on_files(files, config):
    for file in list(files):
        if file.src_uri.startswith("site/"):
            files.remove(file)
    for line in (ROOT / "README.md").read_text().splitlines():  # is no page, but its links must hold
        LINK.sub(lambda link: site_link(link, "README.md", "index.md"), line)
    for page in {*PAGES.values()} - {"index.md"}:
        files.append(File(page, str(ROOT), config["site_dir"], use_directory_urls=False))
    return files


def on_nav(nav, config, files):
    named = {page.file.src_uri for page in nav.pages}
    for file in files.documentation_pages():
        if file.src_uri not in named:
            log.warning("%s is not in the navigation: doc/site/mkdocs.yml takes a line for it", file.src_uri)
    return nav


def on_page_read_source(page, config):
    if page.file.src_uri == "parameters.md":
        return parameter_page.markdown((ROOT / "doc" / "parameters.prm").read_text())
    if page.file.src_uri == "cases/README.md":
        return case_list()
    return None


def on_page_markdown(markdown, page, config, files):
    name = page.file.src_uri
    if name in MADE:
        return markdown
    origin = next((path for path, site in PAGES.items() if site == name and path != "README.md"), f"doc/{name}")
    lines = [line if line.startswith("    ") else LINK.sub(lambda link: site_link(link, origin, name), line)
             for line in markdown.splitlines()]
    case = ROOT / posixpath.dirname(origin) / "case.prm"
    if origin.startswith("cases/") and case.is_file():
        lines += ["", "## The case", "", *("    " + line for line in case.read_text().splitlines())]
    return "\n".join(lines) + "\n"


def site_link(link, origin, page):
    """A link of the repository's file 'origin' as the site's page has it."""
    mark, text, target = link.groups()
    if re.match(r"[a-z]+:|#", target):
        return link.group()
    path, _, anchor = target.partition("#")
    path = posixpath.normpath(posixpath.join(posixpath.dirname(origin), path))
    if not (ROOT / path).exists():
        log.warning("%s links to %s, which is not there", origin, target)
        return text
    site = PAGES.get(path) or (path[len("doc/"):] if path.startswith("doc/") else None)
    if site is None:
        return f"`{path}`" if text in (path, f"`{path}`") else f"{text} (`{path}`)"
    relative = posixpath.relpath(site, posixpath.dirname(page) or ".")
    return f"{mark}[{text}]({relative}{'#' + anchor if anchor else ''})"


def case_list():
    """The page that lists the cases by their titles."""
    rows = []
    for name in CASES:
        title = (ROOT / "cases" / name / "README.md").read_text().splitlines()[0].lstrip("# ")
        rows.append(f"| [{name}]({name}/README.md) | {title} |")
    return "\n".join([
        "# Cases", "",
        "Each is a directory of `cases/` that runs as it is, with the numbers that must come out; a test compares them.",
        "", "    geneva run cases/johnson-optimum-wheel", "", "| case | what it is |", "|---|---|", *rows, ""])


def on_post_build(config):
    site = pathlib.Path(config["site_dir"])
    # From disk a browser reads no JSON, but scripts.
    index = (site / "search" / "search_index.json").read_text()
    (site / "search" / "search_index.js").write_text(f"window.searchIndex = {index};\n")
    katex = site / "assets" / "katex"
    shutil.copytree(KATEX / "fonts", katex / "fonts", dirs_exist_ok=True)
    for name in ("katex.min.js", "katex.min.css"):
        shutil.copyfile(KATEX / name, katex / name)
    # They name addresses of a server.
    for name in ("404.html", "sitemap.xml", "sitemap.xml.gz"):
        (site / name).unlink()
    for name in site.glob("assets/**/*.map"):
        name.unlink()
