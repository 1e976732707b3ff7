# SPDX-License-Identifier: MIT
"""The fenced blocks of the documentation, with what a comment right above a block says of it.

    <!-- not run: REASON -->     the commands are not run but only looked up: do they and their options exist?
    <!-- with: TEXT -->          what the block leaves to the reader: put before it (C++: declarations; TOML: other tables)
    <!-- in: FOLDER -->          the block runs in this folder of the scratch copy
    Save this as `NAME`          in the text above: the block is that file from there on
"""

import dataclasses
import re

FENCE = re.compile(r"^( *)(`{3,})(.*)$")
NOTE = re.compile(r"<!-- (not run|with|in): (.*?) -->", re.S)
SAVED = re.compile(r"[Ss]ave this as `([^`]+)`")


@dataclasses.dataclass
class Block:
    page: str
    line: int
    language: str
    text: str
    notes: dict
    saved_as: str = ""

    @property
    def place(self):
        return f"{self.page}:{self.line}"


def paragraph_above(lines, number):
    """What stands right above a fence: comments, or the last paragraph and comments below it."""
    end = number
    while end > 0 and not lines[end - 1].strip():
        end -= 1
    start = end
    while start > 0 and lines[start - 1].strip():
        start -= 1
    return "\n".join(lines[start:end])


def blocks_of(page, text):
    lines = text.split("\n")
    opened = None
    for number, line in enumerate(lines):
        fence = FENCE.match(line)
        if not fence:
            continue
        if opened is None:
            opened = (number, fence.group(3).strip(), len(fence.group(1)))
        elif not fence.group(3).strip():
            start, language, indent = opened
            above = paragraph_above(lines, start)
            notes = {name: what.strip() for name, what in NOTE.findall(above)}
            saved = SAVED.search(above)
            body = "\n".join(row[indent:] for row in lines[start + 1:number]) + "\n"
            yield Block(page, start + 1, language, body, notes, saved.group(1) if saved else "")
            opened = None
    if opened is not None:
        raise ValueError(f"{page}:{opened[0] + 1}: this fence is not closed")


def pages_of(root):
    """README first: what it saves the other pages use."""
    names = ["README.md", "CONTRIBUTING.md"]
    names += sorted(str(path.relative_to(root)) for path in (root / "docs").rglob("*.md"))
    return [name for name in names if (root / name).exists()]


def all_blocks(root):
    return [block for page in pages_of(root) for block in blocks_of(page, (root / page).read_text(encoding="utf-8"))]


INDENTED = re.compile(r"^ {4,}(camopt|build/\S+|scripts/\S+|cmake|ctest|find_package\(|#include) ?")


def indented_commands(root):
    """Places of commands and code that no fence encloses, and so nobody checks."""
    places = []
    for page in pages_of(root):
        fenced = False
        for number, line in enumerate((root / page).read_text(encoding="utf-8").split("\n"), 1):
            if FENCE.match(line):
                fenced = not fenced
            elif not fenced and INDENTED.match(line):
                places.append(f"{page}:{number}")
    return places
