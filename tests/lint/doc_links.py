# SPDX-License-Identifier: MIT
"""doc_links.py ROOT: every relative link and every path in backticks that the documentation names exists."""

import pathlib
import re
import sys

import source_tree

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
TICKED = re.compile(r"`([A-Za-z0-9_.][A-Za-z0-9_./-]*/[A-Za-z0-9_./-]*)`")
FENCE = re.compile(r"^\s*```")
# Made by a build; not in the tree.
MADE = ("build/", "out/")


def anchors(path):
    """The anchors of a page's headings, as the usual viewers make them."""
    for line in path.read_text().splitlines():
        if line.startswith("#"):
            title = re.sub(r"[^\w\- ]", "", line.lstrip("#").strip().lower())
            yield title.replace(" ", "-")


def faults_of_link(root, page, target):
    if re.match(r"[a-z]+:", target):
        return
    name, _, anchor = target.partition("#")
    path = (root / page).parent / name if name else root / page
    if not path.exists():
        yield f"'{target}' does not exist"
    elif anchor and path.suffix == ".md" and anchor not in anchors(path):
        yield f"'{target}': no such heading"


def faults_of(root, page):
    fenced = False
    for number, line in enumerate((root / page).read_text().splitlines(), 1):
        if FENCE.match(line):
            fenced = not fenced
        if fenced:
            continue
        for target in LINK.findall(line):
            for fault in faults_of_link(root, page, target):
                yield f"{page}:{number}: {fault}"
        for path in TICKED.findall(line):
            inside = (root / path.split("/")[0]).exists()
            if inside and not path.startswith(MADE) and not (root / path).exists():
                yield f"{page}:{number}: `{path}` does not exist"


def main():
    root = pathlib.Path(sys.argv[1])
    pages = [path for path in source_tree.files(root) if path.suffix == ".md"]
    faults = [fault for page in pages for fault in faults_of(root, page)]
    source_tree.report("doc_links", faults, len(pages))


main()
