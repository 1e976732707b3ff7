# SPDX-License-Identifier: MIT
"""plain_english.py ROOT: what users read is plain engineering English. Refuses the phrases of PHRASES in strings of production
code (C++, page scripts and pages, scripts, the Python package with its docstrings), in test names and, where DOCS_ARE_CHECKED,
in docs/*.md; and test names (Subject.ExpectedBehaviour) of more than eight words. A program cannot read senses: a phrase that
is right in one file stands in EXCEPTIONS with its reason. Comments and strings without a space (keys) are not read."""

import pathlib
import re
import sys

import source_tree

# Pages in DOCS_TO_CONVERT are not read.
DOCS_ARE_CHECKED = True
DOCS_TO_CONVERT = {"scene_file.md"}  # generated from strings that are read

MOST_WORDS = 8  # of a test name, both parts
# phrase (regular expression, any case), what to write instead
PHRASES = [
    (r"whatever", "any, every, or 'regardless of'"),
    (r"nobody|whoever", "users, no one; or omit"),
    (r"by (?:itself|themselves)", "separately, alone"),
    (r"of (?:its|their|one's) own", "its own, separate, user-defined"),
    (r"at hand", "available, current"),
    (r"in vain", "without success"),
    (r"a hair", "the amount"),
    (r"stray(?:s|ed|ing)?", "leaves"),
    (r"mend(?:s|ed|ing)?", "fix"),
    (r"com(?:e|es|ing) home", "returns"),
    (r"farther", "further"),
    (r"alike", "identical, equally"),
    (r"standstill", "rest, dwell"),
    (r"cam figures|figures of the cam", "cam properties"),
    (r"remed(?:y|ies)", "suggested change, combined change"),
    (r"what (?:would )?helps?", "suggested change"),
    (r"proved not to help", "proved ineffective"),
    (r"given law", "prescribed law"),
    (r"looked for", "searched"),
    (r"(?:limits?|caps?|conditions?) (?:is|are|be|was|were) (?:not )?kept", "satisfied"),
    (r"(?:is|are) (?:all |not )?kept", "satisfied, retained"),
    (r"keeps? (?:every|all|all the|the|its|no|any|each) (?:limits?|caps?|rules?)", "satisfies"),
    (r"(?:is|are|be) broken|broken limits?", "violated"),
    (r"break(?:s|ing)? (?:a|the|its|every|no|any) (?:limits?|caps?|rules?|rows?|conditions?)", "violates"),
    (r"bites?|presses|fights?", "active (a limit), conflicts with"),
    (r"whole turn|per turn|each turn", "one revolution (cam), a cycle (machine)"),
    (r"the places? of", "the cam angle, the location"),
    (r"beside", "compared with, next to, together with"),
]
# (file, or folder with a closing slash; phrase in lower case): why it is right there
EXCEPTIONS = {
    ("scene/keys/load_rows.cpp", "presses"): "a force presses the follower on the cam",
    ("profiles/disk/disk_kind.cpp", "presses"): "a force presses the follower on the cam",
    ("docs/adding_a_solver.md", "remedy"): "a member of SolverEntry",
    ("docs/nc.md", "beside"): "printed by programs of earlier releases, quoted",
    ("docs/nc.md", "whatever"): "quoted output",
    ("scene/limit_table.cpp", "presses"): "a force presses the follower on the cam",
}
WORD = re.compile(r"[A-Z][a-z0-9]*|[a-z0-9]+")
TEST = re.compile(r"\b(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\)")
CPP = re.compile(r"//[^\n]*|/\*.*?\*/|R\"(\w*)\((?P<raw>.*?)\)\1\"|\"(?P<text>(?:[^\"\\\n]|\\.)*)\"|'(?:[^'\\\n]|\\.)+'",
                 re.DOTALL)
SCRIPT = re.compile(r"//[^\n]*|/\*.*?\*/|\"(?P<text>(?:[^\"\\\n]|\\.)*)\"|'(?P<raw>(?:[^'\\\n]|\\.)*)'|`(?P<long>[^`]*)`", re.DOTALL)
PYTHON = re.compile(r"#[^\n]*|\"\"\"(?P<long>.*?)\"\"\"|\"(?P<text>(?:[^\"\\\n]|\\.)*)\"|'(?P<raw>(?:[^'\\\n]|\\.)*)'", re.DOTALL)
HTML = re.compile(r"<!--.*?-->|<[^>]*>|(?P<text>[^<]+)", re.DOTALL)
TOKENS = {".cpp": CPP, ".hpp": CPP, ".js": SCRIPT, ".py": PYTHON, ".html": HTML}
WITH_DOCSTRINGS = "bindings"  # docstrings elsewhere are comments
LEFT_OUT = {"tests", "benchmarks", "notebooks_cpp", "docs"}
REFUSED = [(re.compile(rf"\b(?:{phrase})\b", re.IGNORECASE), instead) for phrase, instead in PHRASES]


def is_read(path):
    if path.parts[0] in LEFT_OUT or "vendor" in path.parts or "examples" in path.parts:
        return False
    return path.suffix in (".cpp", ".hpp") or (path.suffix in TOKENS and path.parts[0] in ("report", "shop", "apps", "scripts", "bindings"))


def text_of(path, match):
    """The string that was matched; None of a comment."""
    groups = match.groupdict()
    if path.suffix == ".py" and path.parts[0] != WITH_DOCSTRINGS and groups["long"] is not None:
        return None
    return next((part for part in groups.values() if part is not None), None)


def strings_of(path, text):
    """(line, string) of the strings of a file; neighbouring literals are one."""
    begin, end, parts = 0, 0, []
    for match in TOKENS[path.suffix].finditer(text):
        found = text_of(path, match)
        if found is None:
            continue
        if parts and text[end:match.start()].strip():
            yield text.count("\n", 0, begin) + 1, "".join(parts)
            parts = []
        if not parts:
            begin = match.start()
        parts.append(found)
        end = match.end()
    if parts:
        yield text.count("\n", 0, begin) + 1, "".join(parts)


def is_excepted(path, phrase):
    name = path.as_posix()
    return any(phrase.lower() == right and (name == place or (place.endswith("/") and name.startswith(place)))
               for place, right in EXCEPTIONS)


def faults_in(path, line, text):
    if " " not in text.strip():
        return
    for phrase, instead in REFUSED:
        for match in phrase.finditer(text):
            if not is_excepted(path, match[0]):
                yield f"{path}:{line}: '{match[0]}': write {instead}"


def faults_of_names(path, text):
    for match in TEST.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        words = [WORD.findall(part) for part in match.groups()]
        if len(words[0]) + len(words[1]) > MOST_WORDS:
            yield f"{path}:{line}: {match[1]}.{match[2]}: {len(words[0]) + len(words[1])} words; allowed: {MOST_WORDS}"
        yield from faults_in(path, line, " ".join(words[1]))


def main(root):
    faults, seen = [], 0
    for path in source_tree.files(root):
        is_page = path.suffix == ".md" and path.parts[0] == "docs"
        if not (is_read(path) or is_page or (path.parts[0] == "tests" and path.suffix in (".cpp", ".hpp"))):
            continue
        seen += 1
        text = (pathlib.Path(root) / path).read_text()
        if path.parts[0] == "tests":
            faults += faults_of_names(path, text)
        elif not is_page:
            faults += [fault for line, string in strings_of(path, text) for fault in faults_in(path, line, string)]
        elif DOCS_ARE_CHECKED and path.name not in DOCS_TO_CONVERT:
            faults += [fault for number, line in enumerate(text.splitlines(), 1) for fault in faults_in(path, number, line)]
    source_tree.report("plain_english", faults, seen)


main(sys.argv[1])
