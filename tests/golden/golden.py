# SPDX-License-Identifier: MIT
"""golden.py PROGRAM ROOT [CASE …]: everything that camopt prints and writes, compared with what is expected of it.

A case is a file of cases/: comments and commands. Each command runs in an empty folder with links to scenes/ and tests/ and to the
files/ of this folder. Of "$ WORDS" the exit code, the console and every file written are held; of "% WORDS" the exit code, the
console, report.md and the names of the other files. "& NAME" runs the program of --texts, which writes the texts of solutions made by
hand (texts.cpp) into the folder NAME. expected/CASE.txt holds them as lines (views.py); words are compared literally, numbers by their size
(differences.py). --update writes it again and prints what changed."""

import argparse
import concurrent.futures
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time

from differences import differences
from views import lines_of

HERE = pathlib.Path(__file__).resolve().parent
MOST = 12  # differences of a case that are printed
MARK = "@@@ "
NEEDED = ("Ipopt", "Open CASCADE", "cairo")  # `camopt check` names the first, the others write .step and .pdf
SKIPPED = 77


def commands_of(case):
    for line in (HERE / "cases" / f"{case}.txt").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            assert line[:2].strip() in ("$", "%", "&"), f"cases/{case}.txt: found '{line}'"
            yield line[0], line[2:]


def files_of(folder):
    return {str(path.relative_to(folder)): path for path in sorted(folder.rglob("*")) if path.is_file() and not path.is_symlink()
            and path.relative_to(folder).parts[0] not in ("scenes", "tests", "files")}


def run_case(programs, root, case):
    """The sections of a case: (title, lines). `programs`: by the letter of a command."""
    seen, styles = {}, set()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        for link, target in (("scenes", root / "scenes"), ("tests", root / "tests"), ("files", HERE / "files")):
            (folder / link).symlink_to(target)
        before = {}
        for letter, words in commands_of(case):
            done = subprocess.run([programs[letter], *shlex.split(words)], cwd=folder, capture_output=True, timeout=120, check=False,
                                  stdin=subprocess.DEVNULL, env={**os.environ, "COLUMNS": "100", "LC_ALL": "C.UTF-8"})
            yield f"$ camopt {words}", [f"exit code {done.returncode}"]
            texts = {"standard output": ("x.json" if done.stdout.startswith((b"{", b"[")) else "", done.stdout),
                     "standard error": ("", done.stderr)}
            names, now = [], files_of(folder)
            changed = {path: (place.stat().st_mtime_ns, place.stat().st_size) for path, place in now.items()}
            for path, place in now.items():
                if before.get(path) != changed[path] and "chunks/" not in path:
                    if letter != "%" or path.endswith("report.md"):
                        texts[path] = (path, place.read_bytes())
                    else:
                        names.append(path)
            names += [f"removed: {path}" for path in before if path not in now]
            before = changed
            if names:
                yield "other files", names
            for title, (kind, data) in texts.items():
                if not data:
                    continue
                if data in seen:
                    yield title, [f"the same as {seen[data]}"]
                    continue
                seen[data] = f"{title} of $ camopt {words}"
                lines = lines_of(kind, data.replace(str(root).encode(), b"ROOT").replace(str(folder).encode(), b"FOLDER"))
                yield title, [line for line in lines if line not in styles]  # the style of pictures once
                styles.update(line for line in lines if "<style> " in line)


def stored(case):
    """(title, first line's number, lines) as they stand in the file."""
    path = HERE / "expected" / f"{case}.txt"
    sections = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines() if path.exists() else [], 1):
        if line.startswith(MARK):
            sections.append((line[len(MARK):], number + 1, []))
        else:
            sections[-1][2].append(line)
    return sections


def compare(case, sections):
    """Sentences, each a difference: file:line, what was expected, what was found."""
    expected = stored(case)
    if not expected:
        return [f"tests/golden/expected/{case}.txt: missing (scripts/test --update-golden writes it)"]
    faults, command, at = [], "", 0
    by_key, found = {}, []
    for title, lines in sections:
        command = title if title.startswith("$ ") else command
        found.append((command, title, lines))
    command = ""
    for title, number, lines in expected:
        command = title if title.startswith("$ ") else command
        by_key[(command, title)] = (number, lines)
        at = number + len(lines)
    keys = {(command, title) for command, title, _ in found}
    for (command, title), (number, _) in by_key.items():
        if (command, title) not in keys:
            faults.append(f"tests/golden/expected/{case}.txt:{number}: expected: {title} of {command}\n  found: nothing")
    for command, title, lines in found:
        if (command, title) not in by_key:
            faults.append(f"tests/golden/expected/{case}.txt:{at}: expected: nothing\n  found: {title} of {command}: "
                          + " | ".join(lines[:5]))
            continue
        number, held = by_key[(command, title)]
        for place, one, other in differences(held, lines):
            faults.append(f"tests/golden/expected/{case}.txt:{number + place} ({title} of {command})\n"
                          f"  expected: {'nothing' if one is None else one}\n  found:    {'nothing' if other is None else other}")
    return faults


def update(case, sections):
    path = HERE / "expected" / f"{case}.txt"
    faults = compare(case, sections) if path.exists() else ["new"]
    if faults:
        text = "".join(f"{MARK}{title}\n" + "".join(line + "\n" for line in lines) for title, lines in sections)
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("root", type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("cases", nargs="*", default=sorted(path.stem for path in (HERE / "cases").glob("*.txt")))
    parser.add_argument("--texts", help="the program of texts.cpp", default="")
    parser.add_argument("--update", action="store_true", help="write the expectation again, and print what changed")
    parser.add_argument("--all", action="store_true", help="print every difference")
    arguments = parser.parse_intermixed_args()
    version = subprocess.run([arguments.program, "--version"], capture_output=True, text=True, check=True).stdout
    absent = [library for library in NEEDED if library not in version]
    if absent:
        print(f"golden: skipped, the program was built without {' and '.join(absent)}")
        return SKIPPED
    program = str(pathlib.Path(arguments.program).resolve())
    programs = {"$": program, "%": program, "&": str(pathlib.Path(arguments.texts).resolve())}
    failed = 0

    def run(case):
        begin = time.monotonic()
        return case, list(run_case(programs, arguments.root, case)), time.monotonic() - begin

    with concurrent.futures.ThreadPoolExecutor(2 if len(arguments.cases) > 1 else 1) as pool:
        for case, sections, seconds in pool.map(run, arguments.cases):
            faults = update(case, sections) if arguments.update else compare(case, sections)
            failed += bool(faults)
            for fault in faults if arguments.all else faults[:MOST]:
                print(fault)
            if len(faults) > MOST and not arguments.all:
                print(f"… and {len(faults) - MOST} more (--all)")
            print(f"{case}: {len(sections)} texts, {seconds:.1f} s, "
                  f"{'unchanged' if not faults else 'written' if arguments.update else f'{len(faults)} differences'}", flush=True)
    if failed and not arguments.update:
        print("What is right now is written by scripts/test --update-golden.")
    return 1 if failed and not arguments.update else 0


if __name__ == "__main__":
    sys.exit(main())
