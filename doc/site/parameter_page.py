"""The page of all parameters, from the text that 'geneva parameters' prints."""

import html
import re

INTRODUCTION = """# Parameters

Every parameter of `case.prm` by its subsection, as `geneva parameters` prints it ([as a file](parameters.prm)).
[The case file](case-file.md) explains how to write a case, [Inputs on the drawing](inputs.md) shows the lengths.
"""


def markdown(text):
    """Markdown with a heading for every subsection and parameter; the anchor of 'Pin diameter' in 'Mechanism' is
    mechanism-pin-diameter."""
    page, sections, help_lines = [INTRODUCTION, "## At the top", ""], [], []
    for line in map(str.strip, text.splitlines()):
        if line.startswith("#"):
            help_lines.append(line.lstrip("# "))
        elif line.startswith("subsection "):
            sections.append(line[len("subsection "):])
            page += [f"## {' / '.join(sections)} {{#{anchor(sections)}}}", ""]
            page += paragraph(help_lines)
            help_lines = []
        elif line == "end":
            sections.pop()
        elif line.startswith("set "):
            name, value = (part.strip() for part in line[len("set "):].split("=", 1))
            page += parameter(sections, name, value, " ".join(help_lines))
            help_lines = []
        elif not line and help_lines:  # the heading of the file
            help_lines = []
    return "\n".join(page)


def parameter(sections, name, default, text):
    """Heading, help, what is allowed and the default of a parameter."""
    text = re.sub(r"^Listing of Parameters -+ ", "", text)
    explanation, _, allowed = text.rpartition("[")
    if default:
        facts = f"Default: `{default}`. "
    else:  # the help may say more of it
        facts = "" if re.search("Default:|Required", explanation) else "Default: none. "
    return [f"### {name} {{#{anchor([*sections, name])}}}", "", escaped(explanation.strip()), "",
            f"`{'/'.join([*sections, name])}`. {facts}Allowed: {escaped(allowed.rstrip(']'))}", ""]


def paragraph(lines):
    return [escaped(" ".join(lines)), ""] if lines else []


def anchor(names):
    return re.sub(r"[^a-z0-9]+", "-", "-".join(names).lower()).strip("-")


def escaped(text):
    return re.sub(r"([\\`*_{}\[\]#$])", r"\\\1", html.escape(text, quote=False))
