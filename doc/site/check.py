"""Checks a built site: every link, anchor and file that a page names must be there, and nothing may be loaded from
another host.

    check.py SITE
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse

# Tags whose address the browser loads by itself.
LOADED = {("script", "src"), ("link", "href"), ("img", "src"), ("iframe", "src"), ("source", "src"), ("object", "data")}


class Page(html.parser.HTMLParser):
    """The anchors of a page and the addresses that it names."""

    def __init__(self, text):
        super().__init__()
        self.anchors, self.addresses = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                if value in self.anchors:
                    self.addresses.append(("twice", f"#{value}"))
                self.anchors.add(value)
            elif name in ("href", "src", "data") and value is not None:
                self.addresses.append(("loaded" if (tag, name) in LOADED else "link", value))


def faults_of(file, page, pages):
    """What is wrong with the addresses of a page."""
    for kind, address in page.addresses:
        parts = urllib.parse.urlsplit(address)
        if kind == "twice":
            yield f"the anchor {address} stands there twice"
        elif parts.scheme in ("http", "https") or parts.netloc:
            if kind == "loaded":
                yield f"loads {address} from another host"
        elif parts.scheme in ("data", "mailto"):
            continue
        else:
            target = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
            if not target.is_file():
                yield f"links to {address}, which is not there"
            elif parts.fragment and target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].anchors:
                yield f"links to {address}, but no such anchor is there"


def faults_of_style(file):
    """What is wrong with the addresses of a style sheet."""
    for address in re.findall(r"url\(\s*[\"']?([^\"')]+)", file.read_text()):
        parts = urllib.parse.urlsplit(address)
        if parts.netloc:
            yield f"loads {address} from another host"
        elif not parts.scheme and not (file.parent / parts.path).is_file():
            yield f"loads {address}, which is not there"


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    pages = {file: Page(file.read_text()) for file in sorted(site.rglob("*.html"))}
    faults = [f"{file.relative_to(site)}: {fault}" for file, page in pages.items() for fault in faults_of(file, page, pages)]
    for file in site.rglob("*.css"):
        faults += [f"{file.relative_to(site)}: {fault}" for fault in faults_of_style(file)]
    for fault in faults:
        print(f"site: {fault}", file=sys.stderr)
    if not pages or faults:
        sys.exit(f"site: {len(faults)} faults in {len(pages)} pages")
    links = sum(len(page.addresses) for page in pages.values())
    print(f"site: {len(pages)} pages, {links} links, all of them valid: {site}/index.html")


if __name__ == "__main__":
    main()
