# SPDX-License-Identifier: MIT
"""completion_test.py SHELL PROGRAM SCRIPTS: completes real lines in a real shell (bash, zsh or fish).

Exit code 77 where the shell is not on this machine."""

import os
import pathlib
import subprocess
import sys
import tempfile

import shells

# What is typed, and the line after a tab.
CERTAIN = [
    ("camopt so", "camopt solve "),
    ("camopt solve --se", "camopt solve --set "),
    ("camopt solve --set spline.degr", "camopt solve --set spline.degree="),
    ("camopt solve --set motion.symmetric=t", "camopt solve --set motion.symmetric=true "),
    ("camopt solve --set objective.reference=modified_s", "camopt solve --set objective.reference=modified_sine "),
    ("camopt solve --solver struct", "camopt solve --solver structured "),
    ("camopt sweep --vary cam.base_radius_m", "camopt sweep --vary cam.base_radius_m"),
    ("camopt solve fir", "camopt solve first.toml "),
    ("camopt solve --out fol", "camopt solve --out folder/"),
    ("camopt export fol", "camopt export folder/"),
    ("camopt export first.toml --post pos", "camopt export first.toml --post post.txt "),
    ("camopt solve --out two", "camopt solve --out two\\ words/"),
    ("camopt list so", "camopt list solvers "),
    ("camopt export first.toml --plc code", "camopt export first.toml --plc codesys "),
    ("camopt export first.toml --columns theta_d", "camopt export first.toml --columns theta_deg "),
    ("camopt sweep me", "camopt sweep merge "),
    ("camopt solve --nonsen", "camopt solve --nonsen"),
]

# What is typed, and every word that fits, or some of them.
ALL = [
    ("camopt ", ["check", "compare", "dynamics", "export", "inspect", "list", "machine", "report", "solve", "studio", "sweep", "table",
                 "valves"]),
    ("camopt list ", ["columns", "controllers", "followers", "keys", "laws", "solvers"]),
]
SOME = [
    ("camopt solve --set motion.segments", ["motion.segments[0].law=", "motion.segments[0].to_mm="]),
    ("camopt solve --", ["--out", "--set", "--json", "--help"]),
]


def working_folder(path):
    (path / "first.toml").write_text("")
    (path / "other.toml").write_text("")
    (path / "post.txt").write_text("")
    (path / "folder").mkdir()
    (path / "two words").mkdir()


def in_terminal(name, program, scripts, folder):
    """(typed, expected, found) of everything that is not as it should be."""
    shell = shells.Shell(name, program, scripts, folder)
    try:
        for typed, expected in CERTAIN:
            line = shell.completed(typed)
            if line != expected:
                yield typed, expected, line
        for typed, expected in ALL:
            words = sorted(shell.fitting(typed))
            if words != expected:
                yield typed, expected, words
        for typed, expected in SOME:
            words = [word.replace("\\", "") for word in shell.fitting(typed)]
            if not set(expected) <= set(words):
                yield typed, expected, words
    finally:
        shell.close()


def fish_words(line, program, scripts, folder):
    """fish says itself what fits: the words, each without its description."""
    path = os.path.dirname(program) + os.pathsep + os.environ["PATH"]
    run = subprocess.run(["fish", "--no-config", "-c", f"source {scripts}/camopt.fish; complete -C '{line}'"], cwd=folder,
                         env=dict(os.environ, PATH=path, HOME=folder), capture_output=True, text=True, timeout=60, check=True)
    return [row.split("\t")[0] for row in run.stdout.splitlines()]


def in_fish(program, scripts, folder):
    for typed, expected in CERTAIN:
        start, last = typed.rsplit(" ", 1)
        wanted = expected[len(start) + 1:].strip().replace("\\", "")
        words = fish_words(typed, program, scripts, folder)
        if wanted == last:  # nothing certain to add
            continue
        if wanted not in words:
            yield typed, wanted, words
    for typed, expected in ALL:
        words = sorted(fish_words(typed, program, scripts, folder))
        if words != expected:
            yield typed, expected, words
    for typed, expected in SOME:
        words = fish_words(typed, program, scripts, folder)
        if not set(expected) <= set(words):
            yield typed, expected, words


def main():
    name, program, scripts = sys.argv[1], os.path.abspath(sys.argv[2]), os.path.abspath(sys.argv[3])
    if not shells.found(name):
        print(f"completion_test: SKIPPED: {name} is not on this machine; its completion is not tested")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        working_folder(pathlib.Path(folder))
        run = in_fish(program, scripts, folder) if name == "fish" else in_terminal(name, program, scripts, folder)
        faults = list(run)
    for typed, expected, seen in faults:
        print(f"{name}: '{typed}': expected {expected!r}, found {seen!r}")
    print(f"completion_test: {len(CERTAIN) + len(ALL) + len(SOME)} lines in {name}, {len(faults)} wrong")
    sys.exit(1 if faults else 0)


main()
