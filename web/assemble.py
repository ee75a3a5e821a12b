#!/usr/bin/env python3
"""Puts the page together: each @NAME@ of the first part, which is the page's frame, becomes the file of that name.

    assemble.py PAGE FRAME PART...
"""

import pathlib
import re
import sys


def main():
    page, frame, *parts = map(pathlib.Path, sys.argv[1:])
    texts = {part.name: part.read_text(encoding="utf-8") for part in parts}
    for name, text in texts.items():
        if "</script" in text or "</style" in text:
            sys.exit(f"assemble: {name} would end the element that it stands in")
    used = set()

    def text_of(match):
        used.add(match.group(1))
        return texts[match.group(1)]

    content = re.sub(r"@([\w.-]+)@", text_of, frame.read_text(encoding="utf-8"))
    if missing := set(texts) - used:
        sys.exit(f"assemble: {frame.name} has no place for {', '.join(sorted(missing))}")
    page.write_text(content, encoding="utf-8")


if __name__ == "__main__":
    main()
